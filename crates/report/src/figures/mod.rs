//! Figures of plans and simulations as SVG files, for papers and slides.
//!
//! | file | content |
//! |---|---|
//! | `keyframes-x.svg`, `-y`, `-z` | sections through the parts at six moments, cut across an axis at the goal |
//! | `forces.svg` | contact force of every scenario over time |
//! | `convergence.svg` | penetration and violation after every homotopy step |
//! | `success.svg` | success rates of the last simulation |

mod chart;
mod convergence;
mod forces;
mod keyframes;
mod section;
mod success;
mod svg;

pub(crate) use section::{others, section};
pub use svg::BEGIN;
pub(crate) use svg::{COLOURS, Colour, Hex};

use crate::model::{PageData, PlanData, SimulationData};

/// Names and contents of the figures of some data; of a batch and of tolerances only those of their simulation, of two plans
/// those of the first.
pub fn figures(data: &PageData) -> Vec<(String, String)> {
    match data {
        PageData::Plan(plan) => of_plan(plan),
        PageData::Beside(beside) => of_plan(&beside.plans[0]),
        PageData::Batch(batch) => of_simulation(batch.simulation.as_ref()).into_iter().collect(),
        PageData::Simulation(simulation) => of_simulation(Some(simulation)).into_iter().collect(),
        PageData::Tolerance(tolerance) => of_simulation(tolerance.simulation.as_ref()).into_iter().collect(),
    }
}

fn of_plan(plan: &PlanData) -> Vec<(String, String)> {
    let mut figures: Vec<(String, String)> =
        (0..3).map(|axis| (format!("keyframes-{}.svg", keyframes::AXES[axis]), keyframes::draw(plan, axis))).collect();
    figures.push(("forces.svg".to_owned(), forces::draw(plan)));
    figures.push(("convergence.svg".to_owned(), convergence::draw(&plan.result.stages)));
    figures.extend(of_simulation(plan.simulation.as_ref()));
    figures
}

fn of_simulation(simulation: Option<&SimulationData>) -> Option<(String, String)> {
    simulation.map(|simulation| ("success.svg".to_owned(), success::draw(simulation)))
}
