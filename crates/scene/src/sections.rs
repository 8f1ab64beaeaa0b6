//! The tables of a scene that are not shapes.

use task::{CostWeights, Horizon, Impedance, Inertia, TrajectoryCost};

use crate::error::SceneError;
use crate::inertia::symmetric;
use crate::pose::pose;
use crate::scene::StartPose;
use crate::table::Table;

/// The start poses.
pub fn starts(scene: &Table) -> Result<Vec<StartPose>, SceneError> {
    let mut starts: Vec<StartPose> = Vec::new();
    for table in scene.tables("start", "start")? {
        let entry = table.require("name")?;
        let name = entry.name()?;
        if starts.iter().any(|other| other.name == name) {
            return Err(entry.refuse(format!("start name `{name}` is used twice")));
        }
        starts.push(StartPose { name, pose: pose(&table)? });
    }
    Ok(starts)
}

/// The controller, critically damped where the scene does not say otherwise.
pub fn impedance(table: &Table, inertia: &Inertia) -> Result<Impedance, SceneError> {
    let (translational, rotational) = (table.number("translational_stiffness")?, table.number("rotational_stiffness")?);
    let mut impedance = Impedance::critically_damped(translational, rotational, inertia);
    if let Some(damping) = table.find("translational_damping") {
        impedance.translational_damping = symmetric(&damping)?;
    }
    if let Some(damping) = table.find("rotational_damping") {
        impedance.rotational_damping = symmetric(&damping)?;
    }
    Ok(impedance)
}

/// The time grid.
pub fn horizon(table: &Table) -> Result<Horizon, SceneError> {
    Ok(Horizon { steps: table.integer("steps")? as usize, time_step: table.number("time_step")? })
}

/// The weights.
pub fn cost(scene: &Table) -> Result<TrajectoryCost, SceneError> {
    let cost = scene.table("cost")?;
    Ok(TrajectoryCost {
        reference: weights(&cost.table("reference")?)?,
        compliant: weights(&cost.table("compliant")?)?,
    })
}

fn weights(table: &Table) -> Result<CostWeights, SceneError> {
    Ok(CostWeights {
        translational_velocity: table.number("translational_velocity")?,
        rotational_velocity: table.number("rotational_velocity")?,
        terminal_position: table.number("terminal_position")?,
        terminal_orientation: table.number("terminal_orientation")?,
    })
}
