//! The tables of a scene that are not shapes.

use nalgebra::{Matrix3, SymmetricEigen};
use task::{CostWeights, Horizon, Impedance, Inertia, TrajectoryCost};

use crate::entry::Entry;
use crate::error::SceneError;
use crate::keys::key;
use crate::part::Part;
use crate::pose::pose;
use crate::scene::StartPose;
use crate::table::Table;
use crate::words::{clipped, suggest};

/// Relative difference of two numbers of a matrix that counts as rounding.
const ROUNDING: f64 = 1e-9;

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

/// Mass and rotational inertia.
pub fn inertia(body: &Table) -> Result<Inertia, SceneError> {
    let mass = body.number("mass")?;
    let Some(entry) = body.find("inertia") else {
        return Ok(Inertia { mass, rotational: Matrix3::identity() * body.number("inertia")? });
    };
    Ok(Inertia { mass, rotational: symmetric(&entry)? })
}

/// A symmetric matrix with its principal values in the key's range. Where zero is in the range, rounding may make it
/// negative.
fn symmetric(entry: &Entry) -> Result<Matrix3<f64>, SceneError> {
    let rows = entry.matrix()?;
    let (path, unit, range) = (entry.path(), entry.key().unit, entry.key().bounds());
    let matrix = Matrix3::from_fn(|row, column| rows[row][column]);
    let rounding = ROUNDING * matrix.amax();
    if (matrix - matrix.transpose()).amax() > rounding {
        return Err(entry.refuse(format!("{path} must be symmetric ({unit})")));
    }
    let may_be_zero = range.contains(0.0);
    let principal = principal_values(matrix);
    let is_within = |value: f64| range.contains(value) || may_be_zero && range.contains(value + rounding);
    match principal.iter().find(|value| !is_within(**value)) {
        None if may_be_zero || matrix.cholesky().is_some() => Ok(matrix),
        outside => {
            let definite = if may_be_zero { "semidefinite" } else { "definite" };
            let value = outside.map_or(String::new(), |value| format!("; one is {value:.1e}"));
            Err(entry
                .refuse(format!("{path} must be positive {definite}, with principal values {range} {unit}{value}")))
        }
    }
}

/// Principal values of a symmetric matrix; those of a diagonal one are exact.
fn principal_values(matrix: Matrix3<f64>) -> [f64; 3] {
    const ITERATIONS: usize = 1000;
    if matrix == Matrix3::from_diagonal(&matrix.diagonal()) {
        return matrix.diagonal().into();
    }
    let values = SymmetricEigen::try_new(matrix, f64::EPSILON, ITERATIONS).map(|eigen| eigen.eigenvalues.into());
    values.unwrap_or([f64::NAN; 3])
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

/// The pairs that are listed, else every body part with every environment part.
pub fn pairs(scene: &Table, body: &[Part], environment: &[Part]) -> Result<Vec<(usize, usize)>, SceneError> {
    let Some(entry) = scene.table("contact")?.find("pairs") else {
        let most = *key("contact", "pairs").count().map_or(&usize::MAX, |count| count.end());
        if body.len() * environment.len() > most {
            return Err(scene.require("environment")?.refuse(format!(
                "{} body parts and {} environment parts make more than {most} pairs: list those that may touch as \
                 pairs in [contact]",
                body.len(),
                environment.len()
            )));
        }
        let all = (0..body.len()).flat_map(|part| (0..environment.len()).map(move |other| (part, other)));
        return Ok(all.collect());
    };
    let mut pairs = Vec::new();
    for pair in entry.pairs()? {
        let refuse = |message: String| entry.source().error(pair.span(), message);
        let find = |parts: &[Part], parent: &str, name: &str| {
            parts.iter().position(|part| part.name == name).ok_or_else(|| {
                let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                let name = clipped(name);
                refuse(format!("[{parent}] has no part `{name}`{}", suggest(&name, &names)))
            })
        };
        let [first, second] = *pair.get_ref();
        let indices = (find(body, "body", first)?, find(environment, "environment", second)?);
        if pairs.contains(&indices) {
            return Err(refuse(format!("the pair `{first}`, `{second}` is listed twice")));
        }
        pairs.push(indices);
    }
    Ok(pairs)
}
