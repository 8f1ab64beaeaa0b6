//! `tolerance.json`, and its lines.

use planner::files::Format;
use planner::{PlannerError, Problem, VERSION};
use serde::Serialize;
use tolerance::{Boundary, Quantity, ToleranceMap, ToleranceRequest};

/// Name of the file.
pub const TOLERANCE: &str = "tolerance.json";

/// What was measured, in SI units.
#[derive(Debug, Serialize)]
pub struct ToleranceRecord {
    format: Format,
    assembly_plan: &'static str,
    /// Title of the scene.
    pub scene: String,
    /// Folders of the plans.
    plans: Vec<String>,
    /// Share of the rollouts that has to succeed.
    pub rate: f64,
    /// Frictions of the rollouts.
    pub frictions: Vec<f64>,
    seed: u64,
    position_tolerance_m: f64,
    angle_tolerance_rad: f64,
    contact_force_limit_n: Option<f64>,
    /// The clearance of the scene from side to side.
    pub clearance_m: Option<f64>,
    /// Boundaries of single quantities.
    pub boundaries: Vec<Boundary>,
    /// The answer to --need.
    pub need: Option<NeedRecord>,
    /// The map.
    pub map: Option<ToleranceMap>,
}

/// The smallest clearance at which something is tolerated.
#[derive(Debug, Serialize)]
pub struct NeedRecord {
    /// What is to be tolerated.
    pub quantity: Quantity,
    /// Its value (m, rad, or 1).
    pub value: f64,
    /// The clearance.
    pub clearance: Boundary,
}

impl ToleranceRecord {
    /// Of a problem.
    pub fn new(
        problem: &Problem,
        plans: &[String],
        request: &ToleranceRequest,
        boundaries: Vec<Boundary>,
        need: Option<NeedRecord>,
        map: Option<ToleranceMap>,
    ) -> Self {
        let force = problem.task().limits.contact_force;
        Self {
            format: Format::CURRENT,
            assembly_plan: VERSION,
            scene: problem.scene().title.clone(),
            plans: plans.to_vec(),
            rate: request.rate,
            frictions: request.frictions.clone(),
            seed: request.seed,
            position_tolerance_m: problem.success().position,
            angle_tolerance_rad: problem.success().orientation,
            contact_force_limit_n: force.is_finite().then_some(force),
            clearance_m: problem.engagement().clearance_m,
            boundaries,
            need,
            map,
        }
    }

    /// The text of the file.
    ///
    /// # Errors
    /// When it cannot be written as JSON, which is a mistake of the program.
    pub fn json(&self) -> Result<Vec<u8>, PlannerError> {
        let mut text =
            serde_json::to_vec_pretty(self).map_err(|_| PlannerError::Internal("tolerances without JSON"))?;
        text.push(b'\n');
        Ok(text)
    }
}

/// A boundary in words, such as `offset up to 3.12 mm (2.97 to 3.44 mm), where 994 of 1000 succeed`.
pub fn line(boundary: &Boundary) -> String {
    let Boundary { quantity, value, interval, successes, rollouts, is_open } = boundary;
    let [bound, hardest] = if quantity.is_hard_when_small() { ["down to", "no"] } else { ["up to", "the largest"] };
    let Some(value) = value else {
        return format!("{}: too few succeed at any value that was tried", quantity.name());
    };
    let [surely, surely_not] = interval.map(|end| end.map(|end| quantity.in_words(end)));
    let surely = surely.unwrap_or_else(|| "unknown".to_owned());
    let surely_not = surely_not.unwrap_or_else(|| "beyond".to_owned());
    let range = match quantity.is_hard_when_small() {
        true => format!("{surely_not} to {surely}"),
        false => format!("{surely} to {surely_not}"),
    };
    let open = if *is_open { format!(", {hardest} value that was tried") } else { String::new() };
    format!(
        "{} {bound} {} ({range}){open}, where {successes} of {rollouts} succeed",
        quantity.name(),
        quantity.in_words(*value)
    )
}
