//! A picture of a map.

use std::fmt::Write;

use crate::boundary::Boundary;
use crate::map::{ToleranceMap, ToleranceMapRow};

/// Size of the picture, and of its margins to the left and below (pixels).
const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 320.0;
const MARGIN: f64 = 56.0;
const EDGE: f64 = 16.0;
/// Marks along each axis, at most.
const MARKS: f64 = 6.0;

/// The boundary as a line, its confidence interval as a band, as an SVG document.
pub fn svg(map: &ToleranceMap) -> String {
    let (x_unit, x_scale) = map.over.unit();
    let (y_unit, y_scale) = map.quantity.unit();
    // Where nothing is tolerated, or no value suffices, there is no point.
    let rows: Vec<&ToleranceMapRow> = map.rows.iter().filter(|row| row.boundary.value.is_some()).collect();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let x_step = step(largest(&mut map.rows.iter().map(|row| x_scale * row.at)));
    // Whichever end of an interval is the larger one.
    let of_rows = |row: &&ToleranceMapRow| {
        let Boundary { value, interval: [first, last], .. } = row.boundary;
        [value, first, last]
    };
    let y_step = step(largest(&mut rows.iter().flat_map(of_rows).flatten().map(|value| y_scale * value)));
    let [x_most, y_most] = [x_step, y_step].map(|(step, count)| step * count as f64);
    let x = |value: f64| MARGIN + (WIDTH - MARGIN - EDGE) * x_scale * value / x_most;
    let y = |value: f64| HEIGHT - MARGIN - (HEIGHT - MARGIN - EDGE) * y_scale * value / y_most;
    let value = |value: Option<f64>| value.unwrap_or(0.0);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    let point = |at: f64, height: f64| format!("{:.1},{:.1}", x(at), y(height));
    let low = rows.iter().map(|row| point(row.at, value(row.boundary.interval[0].or(row.boundary.value))));
    let high = rows.iter().rev().map(|row| point(row.at, value(row.boundary.interval[1].or(row.boundary.value))));
    let band: Vec<String> = low.chain(high).collect();
    let line: Vec<String> = rows.iter().map(|row| point(row.at, value(row.boundary.value))).collect();
    let _ = writeln!(text, "<polygon points=\"{}\" fill=\"#cfe2f3\"/>", band.join(" "));
    let _ =
        writeln!(text, "<polyline points=\"{}\" fill=\"none\" stroke=\"#1f5c99\" stroke-width=\"2\"/>", line.join(" "));
    for row in &rows {
        let (cx, cy) = (x(row.at), y(value(row.boundary.value)));
        let _ = writeln!(text, "<circle cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"3\" fill=\"#1f5c99\"/>");
    }
    let (left, bottom) = (MARGIN, HEIGHT - MARGIN);
    let _ = writeln!(text, "<path d=\"M{left} {EDGE}V{bottom}H{:.0}\" fill=\"none\" stroke=\"black\"/>", WIDTH - EDGE);
    for at in (0..=x_step.1).map(|mark| mark as f64 * x_step.0) {
        let (px, py) = (x(at / x_scale), bottom + 16.0);
        let _ = writeln!(text, "<text x=\"{px:.1}\" y=\"{py:.1}\" text-anchor=\"middle\">{}</text>", number(at));
    }
    for at in (0..=y_step.1).map(|mark| mark as f64 * y_step.0) {
        let (px, py) = (left - 6.0, y(at / y_scale) + 4.0);
        let _ = writeln!(text, "<text x=\"{px:.1}\" y=\"{py:.1}\" text-anchor=\"end\">{}</text>", number(at));
    }
    let label = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") };
    let middle = 0.5 * (MARGIN + WIDTH - EDGE);
    let (x_label, y_label) = (label(map.over.name(), x_unit), label(map.quantity.name(), y_unit));
    let _ =
        writeln!(text, "<text x=\"{middle:.0}\" y=\"{:.0}\" text-anchor=\"middle\">{x_label}</text>", HEIGHT - 16.0);
    let center = 0.5 * (HEIGHT - MARGIN + EDGE);
    let _ = writeln!(
        text,
        "<text transform=\"translate(14 {center:.0}) rotate(-90)\" text-anchor=\"middle\">{y_label}</text>\n</svg>"
    );
    text
}

/// The distance between marks from zero to a largest value, 1, 2 or 5 times a power of ten, and their number after zero.
fn step(most: f64) -> (f64, usize) {
    let power = 10.0_f64.powf((most / MARKS).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let step = steps.into_iter().find(|step| most <= MARKS * step).unwrap_or(steps[3]);
    (step, (most / step - 1e-9).ceil().max(1.0) as usize)
}

/// A mark without the rounding of its computation.
fn number(mark: f64) -> f64 {
    (1e9 * mark).round() / 1e9
}

#[cfg(test)]
mod tests {
    use crate::quantity::Quantity;

    use super::*;

    #[test]
    fn marks_are_round_and_reach_the_largest_value() {
        for (most, expected) in
            [(3.25, (1.0, 4)), (2.0, (0.5, 4)), (0.0123, (0.005, 3)), (60.0, (10.0, 6)), (61.0, (20.0, 4))]
        {
            let (found, count) = step(most);
            assert!((found - expected.0).abs() < 1e-12 * found && count == expected.1, "{most}: {found}, {count}");
        }
    }

    #[test]
    fn every_point_and_the_whole_band_are_in_the_picture() {
        // The first end of the interval of a clearance is the larger one; no clearance suffices for the last row.
        let row = |at: f64, value: Option<f64>| {
            let interval = [value.map(|value| 2.0 * value), value.map(|value| 0.5 * value)];
            let quantity = Quantity::Clearance;
            let boundary = Boundary { quantity, value, interval, successes: 99, rollouts: 100, is_open: false };
            ToleranceMapRow { at, boundary }
        };
        let rows = vec![row(0.001, Some(1e-4)), row(0.002, Some(2e-4)), row(0.003, None)];
        let map = ToleranceMap { quantity: Quantity::Clearance, over: Quantity::Offset, rows, sensitivity: None };
        let picture = svg(&map);
        assert_eq!(picture.matches("<circle").count(), 2, "{picture}");
        let band = picture.split_once("<polygon points=\"").unwrap().1.split_once('"').unwrap().0;
        let corners: Vec<[f64; 2]> = band
            .split(' ')
            .map(|corner| corner.split_once(',').map(|(x, y)| [x, y].map(|number| number.parse().unwrap())).unwrap())
            .collect();
        assert_eq!(corners.len(), 4, "{band}");
        for [x, y] in corners {
            assert!((MARGIN..=WIDTH - EDGE).contains(&x) && (EDGE..=HEIGHT - MARGIN).contains(&y), "{band}");
        }
    }
}
