//! Events as plain data, for logs and other languages.

use ocp::Event as SolverEvent;
use serde_json::{Value, json};

use crate::session::Event;

impl Event<'_> {
    /// Its name and its fields, which name their units.
    pub fn record(&self) -> (&'static str, Value) {
        match self {
            Self::Iteration(SolverEvent { progress, number, smoothing, .. }) => (
                "solver_iteration",
                json!({
                    "homotopy_step": number,
                    "tau": smoothing.tau,
                    "iteration": progress.iteration,
                    "objective": progress.objective,
                    "primal_infeasibility": progress.primal_infeasibility,
                    "dual_infeasibility": progress.dual_infeasibility,
                    "barrier": progress.mu,
                    "restoration": progress.restoration,
                }),
            ),
            Self::HomotopyStep { number, most, record, position_error } => (
                "homotopy_step",
                json!({ "number": number, "most": most, "position_error_m": position_error, "record": record }),
            ),
            Self::Attempt { planned, position_error } => {
                ("attempt", json!({ "planned": planned, "position_error_m": position_error }))
            }
            Self::Resumed { done, most, refining } => {
                ("resumed", json!({ "done": done, "most": most, "refining": refining }))
            }
            Self::Discarded { reason } => ("discarded", json!({ "reason": reason.to_string() })),
            Self::Evaluated { rate } => ("evaluated", json!({ "rate": rate })),
            Self::Refining { planned } => ("refining", json!({ "planned": planned })),
            Self::Perturbation { failing, cases, accepted } => {
                ("perturbation", json!({ "failing": failing, "cases": cases, "accepted": accepted }))
            }
            Self::Refined { rate } => ("refined", json!({ "rate": rate })),
            Self::Variant { name, number, count } => {
                ("variant", json!({ "planned": name, "number": number, "count": count }))
            }
            Self::VariantSolved { status } => ("variant_solved", json!({ "status": status })),
            Self::VariantTried { failing, cases } => ("variant_tried", json!({ "failing": failing, "cases": cases })),
            Self::Rollouts { done, count } => ("rollouts", json!({ "done": done, "count": count })),
        }
    }
}
