//! The tables of a scene that are not shapes.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use task::{CostWeights, Horizon, Impedance, Inertia, TrajectoryCost};

use crate::entry::Entry;
use crate::error::SceneError;
use crate::part::GivenPart;
use crate::pose::{norm, pose};
use crate::scene::StartPose;
use crate::table::Table;

/// Relative difference of two numbers of a matrix that counts as rounding.
const ROUNDING: f64 = 1e-9;
/// Distance of the centre of mass from the origin, in sizes of the body, that makes no difference.
const CENTERED: f64 = 0.01;

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

/// Mass and rotational inertia: those given, else of the density of the parts, else the defaults.
pub fn inertia(body: &Table, parts: &[GivenPart]) -> Result<Inertia, SceneError> {
    let material = of_density(parts)?;
    let mass = match (&material, body.find("mass")) {
        (Some(material), None) => material.mass,
        _ => body.number("mass")?,
    };
    let rotational = match (material, body.find("inertia")) {
        (_, Some(entry)) => symmetric(&entry)?,
        (Some(material), None) => material.rotational,
        (None, None) => Matrix3::identity() * body.number("inertia")?,
    };
    Ok(Inertia { mass, rotational })
}

/// Of a body whose parts are meshes with a density. Its origin must be the centre of mass.
fn of_density(parts: &[GivenPart]) -> Result<Option<Inertia>, SceneError> {
    let Some(first) = parts.iter().find_map(|part| part.mesh().filter(|mesh| mesh.making.density.is_some())) else {
        return Ok(None);
    };
    let (mut mass, mut moment, mut about_origin) = (0.0, Vector3::zeros(), Matrix3::zeros());
    for part in parts {
        let Some((mesh, density)) = part.mesh().and_then(|mesh| Some((mesh, mesh.making.density?))) else {
            return Err(first.refuse(format!("`density` is given here but not for part `{}`", part.name)));
        };
        let (properties, placement) = (mesh.solid.mass_properties(), part.placement());
        let own = density * properties.volume;
        let center = placement.transform_point(&properties.center.into()).coords;
        let turn = placement.rotation.to_rotation_matrix();
        let rows = Matrix3::from_fn(|row, column| properties.inertia[row][column]);
        mass += own;
        moment += own * center;
        about_origin += density * (turn * rows * turn.inverse())
            + own * (Matrix3::identity() * center.norm_squared() - center * center.transpose());
    }
    let center = moment / mass;
    let size = parts.iter().flat_map(GivenPart::points).map(|point| norm(&point)).fold(0.0, f64::max);
    if center.norm() > CENTERED * size {
        let [x, y, z] = (-center).into();
        return Err(first.refuse(format!(
            "the centre of mass must be the body's origin: move its parts by position = [{x:.6}, {y:.6}, {z:.6}], and \
             start and goal accordingly, or leave `density` out"
        )));
    }
    Ok(Some(Inertia { mass, rotational: about_origin }))
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
