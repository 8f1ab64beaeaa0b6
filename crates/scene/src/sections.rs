//! The tables of a scene that are not shapes.

use admittance::PositionRobot;
use task::{CostWeights, Coverage, Horizon, Impedance, Inertia, TrajectoryCost};

use crate::chosen;
use crate::error::SceneError;
use crate::inertia::symmetric;
use crate::keys::COVERAGES;
use crate::pose::{Endpoints, StartPose, direction, directions, pose};
use crate::robot::Stiffness;
use crate::scene::RobustnessSpec;
use crate::table::Table;

/// Distance (m) and angle (rad) below which a start is the goal.
const SAME_POSE: f64 = 1e-6;

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

/// Refuses a start that is the goal.
pub fn require_motions(scene: &Table, ends: Endpoints) -> Result<(), SceneError> {
    for (table, StartPose { name, pose }) in scene.tables("start", "start")?.iter().zip(ends.starts) {
        let error = pose.error(ends.goal);
        if error.position.max(error.orientation) < SAME_POSE {
            let problem =
                format!("start `{name}` is the goal: there is nothing to plan; move it to where the motion begins");
            return Err(table.require("position")?.refuse(problem));
        }
    }
    Ok(())
}

/// The controller, critically damped unless the scene gives the damping.
pub fn impedance(scene: &Table, inertia: &Inertia, stiffness: Stiffness) -> Result<Impedance, SceneError> {
    let table = scene.table("impedance")?;
    let Stiffness { translational, rotational } = stiffness;
    let mut impedance = Impedance::critically_damped(translational, rotational, inertia);
    if let Some(damping) = table.find("translational_damping") {
        impedance.translational_damping = symmetric(&damping)?;
    }
    if let Some(damping) = table.find("rotational_damping") {
        impedance.rotational_damping = symmetric(&damping)?;
    }
    Ok(impedance)
}

/// Friction in the plan.
pub fn frictions(scene: &Table) -> Result<Vec<f64>, SceneError> {
    let contact = scene.table("contact")?;
    match contact.find("friction") {
        Some(entry) => entry.number_or_numbers(),
        None => Ok(vec![contact.number("friction")?]),
    }
}

/// What a robust plan must tolerate besides offsets.
pub fn robustness_spec(robustness: &Table) -> Result<RobustnessSpec, SceneError> {
    let frictions = match robustness.find("friction") {
        Some(entry) => entry.numbers()?,
        None => RobustnessSpec::default().frictions,
    };
    Ok(RobustnessSpec {
        frictions,
        rotation_error: robustness.number("rotation_error")?,
        inertia_error: robustness.number("inertia_error")?,
        stiffness_error: robustness.number("stiffness_error")?,
        delay: robustness.number("delay")?,
        bias: [robustness.number("force_bias")?, robustness.number("torque_bias")?],
        edge_radius: robustness.find("edge_radius").map(|entry| entry.number()).transpose()?,
    })
}

/// The time grid: that of the scene, or one in which the controlled body can cover the longest path to the goal.
pub fn horizon(
    scene: &Table,
    ends: Endpoints,
    inertia: &Inertia,
    impedance: &Impedance,
    position_robot: Option<&PositionRobot>,
    offset_magnitude: f64,
) -> Result<Horizon, SceneError> {
    let table = scene.table("horizon")?;
    let steps = table.find("steps").map(|entry| entry.integer()).transpose()?.map(|steps| steps as usize);
    let time_step = table.find("time_step").map(|entry| entry.number()).transpose()?;
    let time_constant = match position_robot {
        Some(robot) => robot.contact_loop().lag(),
        None => (inertia.mean_mass() / impedance.translational_stiffness).sqrt(),
    };
    let paths = ends.starts.iter().map(|start| &start.pose);
    let sliding = position_robot.map_or(0.0, |robot| chosen::sliding_time(robot, offset_magnitude));
    let duration = chosen::duration(paths, ends.goal, time_constant) + sliding;
    let time_step = match (steps, position_robot) {
        (None, Some(_)) => time_step.or(Some(chosen::slow_time_step(duration))),
        _ => time_step,
    };
    Ok(chosen::horizon(duration, steps, time_step))
}

/// Which offsets are covered: the hull of those whose directions the scene gives, else a disc or a ball.
pub fn coverage(robustness: &Table, ends: Endpoints) -> Result<Coverage, SceneError> {
    let (given, axis) = (robustness.find("coverage"), robustness.find("insertion_axis"));
    if robustness.find("offset_directions").is_some() {
        return match given.as_ref().or(axis.as_ref()) {
            None => Ok(Coverage::Hull),
            Some(entry) => Err(entry.refuse(format!(
                "{} beside robustness.offset_directions: directions cover their hull; leave one of the two keys out",
                entry.path()
            ))),
        };
    }
    match (COVERAGES[robustness.choice("coverage")?], axis) {
        ("ball", Some(axis)) => Err(axis.refuse(format!(
            "{} beside robustness.coverage = \"ball\": a ball has no axis; leave one of the two keys out",
            axis.path()
        ))),
        ("ball", None) => Ok(Coverage::Ball),
        (_, Some(axis)) => Ok(Coverage::Disc { axis: direction(&axis)? }),
        (_, None) => Ok(Coverage::Disc { axis: chosen::insertion_axis(&ends.starts[0].pose, ends.goal) }),
    }
}

/// Directions of the planned offsets: those of the scene, or some with which the coverage is planned.
pub fn offset_directions(robustness: &Table, coverage: &Coverage) -> Result<Vec<[f64; 3]>, SceneError> {
    match robustness.find("offset_directions") {
        Some(entry) => directions(&entry),
        None => Ok(chosen::directions(coverage)),
    }
}

/// Axes of the rotation errors, one for each of the offset directions: those of the scene, or zeros.
pub fn rotation_axes(robustness: &Table, offset_directions: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, SceneError> {
    let Some(entry) = robustness.find("rotation_axes") else { return Ok(vec![[0.0; 3]; offset_directions.len()]) };
    if robustness.find("offset_directions").is_none() {
        return Err(entry.refuse(format!(
            "{} without robustness.offset_directions: give a direction for each of the axes",
            entry.path()
        )));
    }
    let (turns, wanted) = (directions(&entry)?, offset_directions.len());
    match turns.len() {
        count if count == wanted => Ok(turns),
        count => Err(entry.refuse(format!(
            "robustness.rotation_axes has {count} axes: give one for each of the {wanted} offset_directions"
        ))),
    }
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
