//! How the homotopy tightens.

use plan::IterationRecord;

use super::chart::{Chart, Line};
use super::svg::COLOURS;

/// Draws penetration, violation and smoothing after every homotopy step.
pub fn draw(iterations: &[IterationRecord]) -> String {
    let line = |index: usize, name: &str, value: fn(&IterationRecord) -> f64| Line {
        name: name.to_owned(),
        colour: COLOURS[index],
        points: (1..).zip(iterations).map(|(number, iteration)| [f64::from(number), value(iteration)]).collect(),
    };
    let lines = [
        line(0, "penetration (m)", |iteration| iteration.max_penetration_m),
        line(1, "violation", |iteration| iteration.constraint_violation),
        line(2, "tau (N m)", |iteration| iteration.tau),
    ];
    Chart { title: "Homotopy", axes: ["homotopy step", "value"], logarithmic: true }.draw(&lines)
}
