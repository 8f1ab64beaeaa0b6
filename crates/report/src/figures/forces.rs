//! Contact force of every scenario over time.

use super::chart::{Chart, Line};
use super::svg::COLOURS;
use crate::model::PlanData;

/// Draws the plan's contact forces.
pub fn draw(plan: &PlanData) -> String {
    let motion = &plan.motions[0];
    let lines: Vec<Line> = motion
        .scenarios
        .iter()
        .enumerate()
        .map(|(index, scenario)| Line {
            name: format!("scenario {}", index + 1),
            colour: COLOURS[index % COLOURS.len()],
            points: (1..)
                .zip(&scenario.forces)
                .map(|(step, &force)| [f64::from(step) * motion.time_step, force])
                .collect(),
        })
        .collect();
    Chart { title: "Contact force of the pair that pushes most", axes: ["time (s)", "force (N)"], logarithmic: false }
        .draw(&lines)
}
