//! Success rates by motion, friction and injected magnitude.

use store::SuccessRow;

use super::svg::{Anchor, Drawing};
use crate::model::SimulationData;

const CELL: [f64; 2] = [96.0, 40.0];
const LEFT: f64 = 270.0;
const TOP: f64 = 44.0;

/// Draws one row per motion, friction and modelled magnitude, one column per injected magnitude.
pub fn draw(simulation: &SimulationData) -> String {
    let mut magnitudes: Vec<f64> = simulation.groups.iter().map(|group| group.magnitude_m.0).collect();
    magnitudes.sort_by(f64::total_cmp);
    magnitudes.dedup();
    let rows: Vec<&[SuccessRow]> = simulation.groups.chunk_by(|one, other| key(one) == key(other)).collect();
    let [width, height] = CELL;
    let size = [LEFT + width * magnitudes.len() as f64 + 8.0, TOP + height * rows.len() as f64 + 8.0];
    let mut drawing = Drawing::new(size[0], size[1]);
    drawing.text([8.0, 17.0], Anchor::Start, "Success in rollouts, with Wilson's interval of 95 %");
    for (column, magnitude) in magnitudes.iter().enumerate() {
        let middle = LEFT + width * (column as f64 + 0.5);
        drawing.text([middle, TOP - 8.0], Anchor::Middle, &format!("{} mm", millimetres(*magnitude)));
    }
    for (row, groups) in rows.iter().enumerate() {
        let top = TOP + height * row as f64;
        let (motion, friction, delta) = key(&groups[0]);
        let name = format!("{motion}, friction {friction}, {} mm planned", millimetres(delta));
        drawing.text([LEFT - 10.0, top + 0.5 * height + 4.0], Anchor::End, &name);
        for group in *groups {
            let column = magnitudes.iter().position(|magnitude| *magnitude == group.magnitude_m.0).unwrap_or_default();
            cell(&mut drawing, [LEFT + width * column as f64, top], group);
        }
    }
    drawing.finish()
}

fn key(group: &SuccessRow) -> (&str, f64, f64) {
    (&group.motion, group.friction.0, group.delta_m.0)
}

fn cell(drawing: &mut Drawing, [left, top]: [f64; 2], group: &SuccessRow) {
    let rate = group.rate.0;
    // From a light red to a light green. Few rollouts prove little: the lower end of the interval counts.
    let mixed = |none: f64, all: f64| none + (all - none) * group.rate_low.0;
    let [red, green, blue] = [mixed(250.0, 207.0), mixed(221.0, 237.0), mixed(214.0, 222.0)];
    let style = format!("rx=\"4\" fill=\"rgb({red:.0},{green:.0},{blue:.0})\"");
    drawing.rectangle([left + 2.0, top + 2.0], [CELL[0] - 4.0, CELL[1] - 4.0], &style);
    let middle = left + 0.5 * CELL[0];
    drawing.text([middle, top + 17.0], Anchor::Middle, &format!("{:.1} %", 100.0 * rate));
    let (low, high) = (100.0 * group.rate_low.0, 100.0 * group.rate_high.0);
    drawing.text([middle, top + 32.0], Anchor::Middle, &format!("{low:.0} to {high:.0} %"));
}

/// A length in mm without the rounding of its computation.
fn millimetres(metres: f64) -> f64 {
    (metres * 1e6).round() / 1e3
}
