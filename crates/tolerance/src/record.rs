//! `tolerance.json`, and its lines.

use plan::{Format, PlannerError, VERSION, reference_hash};
use serde::{Deserialize, Serialize};

use crate::boundary::Boundary;
use crate::map::ToleranceMap;
use crate::quantity::Quantity;
use crate::trials::Trials;

/// Name of the file.
pub const TOLERANCE: &str = "tolerance.json";

/// What was measured, in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ToleranceRecord {
    format: Format,
    assembly_plan: String,
    /// Title of the scene.
    pub scene: String,
    /// Folders of the plans.
    pub plans: Vec<String>,
    /// [Hash](plan::reference_hash) of the reference whose tolerances these are, apart from those of the map.
    pub reference: String,
    /// Success rate that the rollouts must reach.
    pub rate: f64,
    /// Frictions of the rollouts.
    pub frictions: Vec<f64>,
    seed: u64,
    position_tolerance_m: f64,
    angle_tolerance_rad: f64,
    contact_force_limit_n: Option<f64>,
    /// The offset that the plan was made for.
    pub planned_offset_m: f64,
    /// The clearance of the scene from side to side.
    pub clearance_m: Option<f64>,
    /// Boundaries of single quantities.
    pub boundaries: Vec<Boundary>,
    /// The answer to --need.
    pub need: Option<NeedRecord>,
    /// The map.
    pub map: Option<ToleranceMap>,
}

/// The smallest clearance or chamfer at which something is tolerated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NeedRecord {
    /// What is to be tolerated.
    pub quantity: Quantity,
    /// Its value (m, rad, or 1).
    pub value: f64,
    /// The clearance or the chamfer.
    pub boundary: Boundary,
}

impl ToleranceRecord {
    /// Whether each boundary that was asked for has a value, and what is needed can be had. Rows of the map need not.
    pub fn is_answered(&self) -> bool {
        let needed = self.need.iter().map(|need| &need.boundary);
        self.boundaries.iter().chain(needed).all(|boundary| boundary.value.is_some())
    }

    /// Of some trials.
    pub(crate) fn new(trials: &Trials, boundaries: Vec<Boundary>) -> Self {
        let (problem, request) = (trials.problem(), &trials.request);
        let force = problem.task().limits.contact_force;
        Self {
            format: Format::CURRENT,
            assembly_plan: VERSION.to_owned(),
            scene: problem.scene().title.clone(),
            plans: Vec::new(),
            reference: reference_hash(trials.reference()),
            rate: request.rate,
            frictions: request.frictions.clone(),
            seed: request.seed,
            position_tolerance_m: problem.success().position,
            angle_tolerance_rad: problem.success().orientation,
            contact_force_limit_n: force.is_finite().then_some(force),
            planned_offset_m: problem.offset_magnitude(),
            clearance_m: problem.engagement().clearance_m,
            boundaries,
            need: None,
            map: None,
        }
    }

    /// The text of the file.
    ///
    /// # Errors
    /// When it cannot be written as JSON, which is a mistake of the program.
    pub fn json(&self) -> Result<String, PlannerError> {
        let text = serde_json::to_string_pretty(self).map_err(|_| PlannerError::Internal("tolerances without JSON"))?;
        Ok(text + "\n")
    }
}
