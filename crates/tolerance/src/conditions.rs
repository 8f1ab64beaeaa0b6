//! The errors with which a plan is played.

use serde::{Deserialize, Serialize};

use crate::quantity::Quantity;

/// How large every error is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Conditions {
    /// Largest offset (m).
    pub offset: f64,
    /// Rotation error (rad).
    pub rotation: f64,
    /// Position error of the environment (m).
    pub hole: f64,
    /// Friction of all rollouts; `None` for the frictions of the request, in turn.
    pub friction: Option<f64>,
    /// Clearance (m); `None` for that of the scene.
    pub clearance: Option<f64>,
    /// Width of the chamfer at the mouth of the hole (m); `None` for the hole of the scene.
    pub chamfer: Option<f64>,
}

impl Conditions {
    /// The same with another value of one quantity (SI units).
    pub fn with(self, quantity: Quantity, value: f64) -> Self {
        match quantity {
            Quantity::Offset => Self { offset: value, ..self },
            Quantity::Rotation => Self { rotation: value, ..self },
            Quantity::Hole => Self { hole: value, ..self },
            Quantity::Friction => Self { friction: Some(value), ..self },
            Quantity::Clearance => Self { clearance: Some(value), ..self },
            Quantity::Chamfer => Self { chamfer: Some(value), ..self },
        }
    }
}
