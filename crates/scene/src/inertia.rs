//! The apparent inertia of the body: the robot's, else that of the body's own mass.

use nalgebra::{Matrix3, Matrix6, SMatrix, SymmetricEigen};
use task::{Inertia, Pose};

use crate::entry::Entry;
use crate::error::SceneError;
use crate::material::Material;
use crate::part::GivenPart;
use crate::robot::Robot;
use crate::table::Table;

/// Relative difference of two numbers of a matrix that counts as rounding.
const ROUNDING: f64 = 1e-9;
/// Largest condition number of an apparent inertia, scaled by masses and lengths, that computations tolerate.
const WORST_CONDITION: f64 = 1e8;

/// The apparent inertia: the one that the scene gives, else that of its arm at the goal, else that of the body there.
pub fn inertia(
    scene: &Table,
    robot: Option<&Robot>,
    material: Option<&Material>,
    parts: &[GivenPart],
    goal: &Pose,
) -> Result<Inertia, SceneError> {
    let table = scene.table("robot")?;
    match (table.find("apparent_inertia"), robot) {
        (Some(entry), _) => apparent(&entry),
        (None, Some(robot)) => {
            let configured = robot.arm.at(&robot.configuration);
            let singular = || "the arm is singular at the goal: choose another configuration or base".to_owned();
            let matrix = configured.apparent_inertia().ok_or_else(singular);
            let configuration = table.require("configuration")?;
            matrix.map(Inertia::from_matrix).map_err(|message| configuration.refuse(message))
        }
        (None, None) => of_body(&scene.require_table("body")?, material, parts, goal),
    }
}

/// An apparent inertia that the scene gives as a matrix.
fn apparent(entry: &Entry) -> Result<Inertia, SceneError> {
    let path = entry.path();
    let matrix = equal_to_transpose::<6>(entry, &entry.rows()?)?;
    // Velocities and angular velocities have other units: of the diagonal, only ratios of like entries mean something.
    let scale = matrix.diagonal().map(|entry| 1.0 / entry.max(f64::MIN_POSITIVE).sqrt());
    let scaled = Matrix6::from_fn(|row, column| matrix[(row, column)] * scale[row] * scale[column]);
    let principal = principal_values(scaled);
    let (least, most) = principal.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), &v| (low.min(v), high.max(v)));
    let is_definite = matrix.diagonal().min() > 0.0 && least * WORST_CONDITION > most;
    if !is_definite {
        return Err(entry.refuse(format!("{path} must be positive definite")));
    }
    Ok(Inertia::from_matrix(matrix))
}

/// Mass and rotational inertia: those given, else of the density of the parts, else the defaults.
fn of_body(body: &Table, material: Option<&Material>, parts: &[GivenPart], goal: &Pose) -> Result<Inertia, SceneError> {
    match (material, body.find("mass"), body.find("inertia")) {
        (Some(material), None, None) => Ok(material.inertia(parts, goal)),
        (Some(_), Some(given), _) | (Some(_), None, Some(given)) => {
            Err(given
                .refuse(format!("{} is given, and `density` of the parts too: leave one of them out", given.path())))
        }
        (None, _, Some(rotational)) => Ok(Inertia::of_body(body.number("mass")?, symmetric(&rotational)?)),
        (None, _, None) => Ok(Inertia::of_body(body.number("mass")?, Matrix3::identity() * body.number("inertia")?)),
    }
}

/// A symmetric matrix with its principal values in the key's range. Rounding may make a zero negative, where the range
/// includes zero.
pub fn symmetric(entry: &Entry) -> Result<Matrix3<f64>, SceneError> {
    let matrix = equal_to_transpose::<3>(entry, &entry.matrix()?)?;
    let (path, unit, range) = (entry.path(), entry.key().unit, entry.key().bounds());
    let rounding = ROUNDING * matrix.amax();
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

/// A matrix of given rows that equals its transpose up to rounding.
fn equal_to_transpose<const N: usize>(entry: &Entry, rows: &[[f64; N]; N]) -> Result<SMatrix<f64, N, N>, SceneError> {
    let matrix = SMatrix::<f64, N, N>::from_fn(|row, column| rows[row][column]);
    if (matrix - matrix.transpose()).amax() > ROUNDING * matrix.amax() {
        return Err(entry.refuse(format!("{} must be symmetric ({})", entry.path(), entry.key().unit)));
    }
    Ok(matrix)
}

/// Principal values of a symmetric matrix; those of a diagonal one are exact.
fn principal_values<const N: usize>(matrix: SMatrix<f64, N, N>) -> Vec<f64> {
    const ITERATIONS: usize = 1000;
    let diagonal = matrix.diagonal();
    if matrix == SMatrix::from_diagonal(&diagonal) {
        return diagonal.iter().copied().collect();
    }
    let dynamic = nalgebra::DMatrix::from_fn(N, N, |row, column| matrix[(row, column)]);
    let eigen = SymmetricEigen::try_new(dynamic, f64::EPSILON, ITERATIONS);
    eigen.map_or(vec![f64::NAN; N], |eigen| eigen.eigenvalues.iter().copied().collect())
}
