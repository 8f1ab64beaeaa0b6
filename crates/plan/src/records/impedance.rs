//! The controller of a plan, in exports and in logs of players.

use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};
use task::Impedance;

/// The controller of a plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImpedanceRecord {
    /// Along every axis (N/m).
    pub translational_stiffness: f64,
    /// About every axis (Nm/rad).
    pub rotational_stiffness: f64,
    /// Rows along the axes of the world (Ns/m).
    pub translational_damping: [[f64; 3]; 3],
    /// Rows along the axes of the part (Nms/rad).
    pub rotational_damping: [[f64; 3]; 3],
}

impl From<&Impedance> for ImpedanceRecord {
    fn from(impedance: &Impedance) -> Self {
        Self {
            translational_stiffness: impedance.translational_stiffness,
            rotational_stiffness: impedance.rotational_stiffness,
            translational_damping: rows(&impedance.translational_damping),
            rotational_damping: rows(&impedance.rotational_damping),
        }
    }
}

impl From<&ImpedanceRecord> for Impedance {
    fn from(record: &ImpedanceRecord) -> Self {
        let matrix = |rows: &[[f64; 3]; 3]| Matrix3::from_fn(|row, column| rows[row][column]);
        Self {
            translational_stiffness: record.translational_stiffness,
            rotational_stiffness: record.rotational_stiffness,
            translational_damping: matrix(&record.translational_damping),
            rotational_damping: matrix(&record.rotational_damping),
        }
    }
}

fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)]))
}
