//! Line charts.

use super::svg::{Anchor, Colour, Drawing, Hex};

const SIZE: [f64; 2] = [640.0, 300.0];
const LEFT: f64 = 62.0;
const RIGHT: f64 = 130.0;
const TOP: f64 = 28.0;
const BOTTOM: f64 = 44.0;
/// Lines of the grid, about.
const TICKS: f64 = 5.0;

/// A line with its name.
#[derive(Debug)]
pub struct Line {
    /// Its name in the key.
    pub name: String,
    /// Its colour.
    pub colour: Colour,
    /// Its points; those that are not finite, or not positive on a logarithmic scale, are left out.
    pub points: Vec<[f64; 2]>,
}

/// Axes of a chart.
#[derive(Debug)]
pub struct Chart {
    /// Its caption.
    pub title: &'static str,
    /// Names of the axes with their units.
    pub axes: [&'static str; 2],
    /// Whether the vertical axis is logarithmic.
    pub logarithmic: bool,
}

/// A range of values and the pixels that it becomes.
struct Scale {
    low: f64,
    high: f64,
    pixels: [f64; 2],
}

impl Scale {
    fn pixel(&self, value: f64) -> f64 {
        let [from, to] = self.pixels;
        from + (to - from) * (value - self.low) / (self.high - self.low)
    }

    /// Round values, about as many as requested.
    fn ticks(&self) -> Vec<f64> {
        let rough = (self.high - self.low) / TICKS;
        let power = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= rough);
        let step = step.unwrap_or(power);
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        (first..=last).map(|count| count as f64 * step).collect()
    }
}

impl Chart {
    /// Draws lines.
    pub fn draw(&self, lines: &[Line]) -> String {
        let value = |y: f64| if self.logarithmic { y.log10() } else { y };
        let lines: Vec<(&Line, Vec<[f64; 2]>)> = lines
            .iter()
            .map(|line| {
                let points = line.points.iter().map(|&[x, y]| [x, value(y)]);
                (line, points.filter(|point| point.iter().all(|value| value.is_finite())).collect())
            })
            .collect();
        let [width, height] = SIZE;
        let all = || lines.iter().flat_map(|(_, points)| points);
        let x = scale(all().map(|point| point[0]), [LEFT, width - RIGHT], false);
        let y = scale(all().map(|point| point[1]), [height - BOTTOM, TOP], self.logarithmic);
        let mut drawing = Drawing::new(width, height);
        drawing.text([LEFT, 17.0], Anchor::Start, self.title);
        self.grid(&mut drawing, &x, &y);
        for (index, (line, points)) in lines.iter().enumerate() {
            let style = format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"", Hex(line.colour));
            drawing.points("polyline", points.iter().map(|&[u, v]| [x.pixel(u), y.pixel(v)]), &style);
            let height = TOP + 18.0 * index as f64;
            let mark = format!("fill=\"{}\"", Hex(line.colour));
            drawing.rectangle([width - RIGHT + 12.0, height], [12.0, 4.0], &mark);
            drawing.text([width - RIGHT + 30.0, height + 6.0], Anchor::Start, &line.name);
        }
        drawing.finish()
    }

    fn grid(&self, drawing: &mut Drawing, x: &Scale, y: &Scale) {
        let line = "fill=\"none\" stroke=\"#d9dde3\"";
        for tick in y.ticks() {
            let height = y.pixel(tick);
            drawing.points("polyline", x.pixels.into_iter().map(|pixel| [pixel, height]), line);
            let label = if self.logarithmic { format!("{:.0e}", 10_f64.powf(tick)) } else { short(tick) };
            drawing.text([LEFT - 8.0, height + 4.0], Anchor::End, &label);
        }
        for tick in x.ticks() {
            let place = x.pixel(tick);
            drawing.points("polyline", y.pixels.into_iter().map(|pixel| [place, pixel]), line);
            drawing.text([place, y.pixels[0] + 17.0], Anchor::Middle, &short(tick));
        }
        let [horizontal, vertical] = self.axes;
        drawing.text([0.5 * (x.pixels[0] + x.pixels[1]), SIZE[1] - 8.0], Anchor::Middle, horizontal);
        let middle = 0.5 * (y.pixels[0] + y.pixels[1]);
        drawing.push(&format!("<g transform=\"translate(14 {middle:.1}) rotate(-90)\">"));
        drawing.text([0.0, 0.0], Anchor::Middle, vertical);
        drawing.push("</g>");
    }
}

/// The range of some values, including zero unless it is logarithmic.
fn scale(values: impl Iterator<Item = f64>, pixels: [f64; 2], logarithmic: bool) -> Scale {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    let (low, high) = if low.is_finite() { (low, high) } else { (0.0, 1.0) };
    let (low, high) = if logarithmic { (low.floor(), high.ceil()) } else { (low.min(0.0), high) };
    Scale { low, high: if high > low { high } else { low + 1.0 }, pixels }
}

/// A number of a grid without the rounding of its computation.
fn short(value: f64) -> String {
    ((value * 1e6).round() / 1e6 + 0.0).to_string()
}
