//! Requirements on a robust plan, and limits of its refinement.

use std::time::Duration;

use scene::RobustnessSpec;

use crate::error::PlannerError;
use crate::parameters::RobustParameters;
use crate::ranges::{require, require_frictions, require_rotation_error};

/// Requirements on a robust plan, and limits of its refinement.
#[derive(Debug, Clone, PartialEq)]
pub struct RobustnessTarget {
    /// Success rate to reach at each friction, 0 to 1.
    pub target_rate: f64,
    /// Coulomb coefficients, each once.
    pub frictions: Vec<f64>,
    /// Largest rotation error of the part in the gripper besides its offset, about any axis (rad).
    pub rotation_error: f64,
    /// Largest relative error of the inertia.
    pub inertia_error: f64,
    /// Largest relative error of the stiffness.
    pub stiffness_error: f64,
    /// Largest delay beyond that of the controller (s).
    pub delay: f64,
    /// Largest bias of a component of the measured wrench (N, Nm).
    pub bias: [f64; 2],
    /// When to stop refining, the time of the first solve included.
    pub time_limit: Duration,
    /// Perturbations in a row without improvement after which a plan is evaluated again.
    pub stall_limit: usize,
    /// Parameters of the search.
    pub parameters: RobustParameters,
    /// Limit of perturbations in the whole refinement, if any: unlike a time, a count means the same on every machine.
    pub max_perturbations: Option<usize>,
}

impl Default for RobustnessTarget {
    fn default() -> Self {
        Self::of(&RobustnessSpec::default())
    }
}

impl RobustnessTarget {
    /// From the robustness specification of a scene.
    pub fn of(spec: &RobustnessSpec) -> Self {
        let RobustnessSpec { frictions, rotation_error, inertia_error, stiffness_error, delay, bias, edge_radius: _ } =
            spec.clone();
        Self {
            target_rate: 0.99,
            frictions,
            rotation_error,
            inertia_error,
            stiffness_error,
            delay,
            bias,
            time_limit: Duration::from_secs(300),
            stall_limit: 150,
            parameters: RobustParameters::default(),
            max_perturbations: None,
        }
    }
}

impl RobustnessTarget {
    /// Checks all values.
    ///
    /// # Errors
    /// With the first that is out of its range.
    pub fn validate(&self) -> Result<(), PlannerError> {
        require(
            0.0 <= self.target_rate && self.target_rate <= 1.0,
            "target_rate",
            self.target_rate,
            "must lie between 0 and 1",
        )?;
        require_frictions(&self.frictions)?;
        require_rotation_error(self.rotation_error)?;
        self.parameters.validate()
    }

    /// The largest friction.
    pub fn largest_friction(&self) -> f64 {
        self.frictions.iter().copied().fold(0.0, f64::max)
    }

    /// The smallest friction: that of the motions which the plan shows.
    pub fn least_friction(&self) -> f64 {
        self.frictions.iter().copied().fold(f64::INFINITY, f64::min)
    }
}
