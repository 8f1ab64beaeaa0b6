//! A picture of a map.

use std::fmt::Write;

use crate::map::ToleranceMap;

/// Size of the picture, and of its margins to the left and below (pixels).
const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 320.0;
const MARGIN: f64 = 56.0;
const EDGE: f64 = 16.0;
/// Marks along each axis.
const MARKS: usize = 4;

/// The boundary as a line, its confidence interval as a band, as an SVG document.
pub fn svg(map: &ToleranceMap) -> String {
    let (x_unit, x_scale) = map.over.unit();
    let (y_unit, y_scale) = map.quantity.unit();
    let rows = &map.rows;
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let x_most = largest(&mut rows.iter().map(|row| x_scale * row.at));
    let of_rows = |row: &crate::ToleranceMapRow| [row.boundary.value, row.boundary.interval[1]];
    let y_most = largest(&mut rows.iter().flat_map(of_rows).flatten().map(|value| y_scale * value));
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
    for row in rows {
        let (cx, cy) = (x(row.at), y(value(row.boundary.value)));
        let _ = writeln!(text, "<circle cx=\"{cx:.1}\" cy=\"{cy:.1}\" r=\"3\" fill=\"#1f5c99\"/>");
    }
    let (left, bottom) = (MARGIN, HEIGHT - MARGIN);
    let _ = writeln!(text, "<path d=\"M{left} {EDGE}V{bottom}H{:.0}\" fill=\"none\" stroke=\"black\"/>", WIDTH - EDGE);
    for mark in 0..=MARKS {
        let share = mark as f64 / MARKS as f64;
        let (at, height) = (share * x_most, share * y_most);
        let (px, py) = (x(at / x_scale), y(height / y_scale));
        let _ = writeln!(text, "<text x=\"{px:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{at:.3}</text>", bottom + 16.0);
        let _ = writeln!(
            text,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{height:.2}</text>",
            left - 6.0,
            py + 4.0
        );
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
