//! Pictures of a film as pixels. They are drawn three times as large and averaged, which smooths edges.

use super::film::{Film, Item, Outline, Picture, Shape};
use super::outline::Point;
use crate::figures::Colour;

/// Samples per pixel along each side.
const SAMPLES: usize = 3;
const GROUND: Colour = [255; 3];
const BAR: Colour = [0x59, 0x65, 0x79];
/// Height of the bar of time, width of lines and of dashed ones, dash and gap (pixels).
const BAR_HEIGHT: f64 = 3.0;
const LINE: f64 = 1.6;
const DASHED_LINE: f64 = 1.2;
const DASHES: [f64; 2] = [5.0, 4.0];

/// A sheet of samples.
#[derive(Debug)]
struct Sheet {
    width: usize,
    height: usize,
    samples: Vec<Colour>,
}

/// The colours of all pixels of a picture, row by row.
pub fn pixels(film: &Film, picture: &Picture) -> Vec<Colour> {
    let [width, height] = film.size.map(|length| length as usize);
    let mut sheet = Sheet::new(width, height);
    for item in &picture.items {
        let shapes = match item {
            Item::Fixed(index) => &film.fixed[*index],
            Item::Moving(shapes) => shapes,
        };
        shapes.iter().for_each(|Shape { corners, colour }| sheet.fill(corners, *colour));
    }
    picture.outlines.iter().for_each(|outline| sheet.outline(outline));
    let [done, bottom] = [picture.share * film.size[0], film.size[1]];
    sheet.fill(&[[0.0, bottom - BAR_HEIGHT], [done, bottom - BAR_HEIGHT], [done, bottom], [0.0, bottom]], BAR);
    sheet.averaged()
}

impl Sheet {
    fn new(width: usize, height: usize) -> Self {
        let [width, height] = [width, height].map(|length| SAMPLES * length);
        Self { width, height, samples: vec![GROUND; width * height] }
    }

    /// Fills a convex polygon: all samples whose middle is within.
    fn fill(&mut self, corners: &[Point], colour: Colour) {
        let corners: Vec<Point> = corners.iter().map(|corner| corner.map(|place| place * SAMPLES as f64)).collect();
        let (top, bottom) = extent(corners.iter().map(|corner| corner[1]));
        for row in rounded(top, self.height)..rounded(bottom, self.height) {
            let y = row as f64 + 0.5;
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            let crossed = edges.filter(|(from, to)| (from[1] <= y) != (to[1] <= y));
            let (left, right) =
                extent(crossed.map(|(from, to)| from[0] + (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1])));
            let (left, right) = (rounded(left, self.width), rounded(right, self.width));
            if left < right {
                self.samples[row * self.width + left..row * self.width + right].fill(colour);
            }
        }
    }

    fn outline(&mut self, outline: &Outline) {
        for line in &outline.lines {
            if !outline.dashed {
                line.windows(2).for_each(|two| self.line(two[0], two[1], LINE, outline.colour));
                continue;
            }
            for [from, to] in dashes(line) {
                self.line(from, to, DASHED_LINE, outline.colour);
            }
        }
    }

    /// A line of a width in pixels, half of which it is longer at both ends.
    fn line(&mut self, from: Point, to: Point, width: f64, colour: Colour) {
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let [x, y] = [0, 1].map(|axis| if length > 0.0 { 0.5 * width * (to[axis] - from[axis]) / length } else { 0.0 });
        let corner = |[u, v]: Point, along: f64, across: f64| [u + along * x - across * y, v + along * y + across * x];
        self.fill(
            &[corner(from, -1.0, -1.0), corner(to, 1.0, -1.0), corner(to, 1.0, 1.0), corner(from, -1.0, 1.0)],
            colour,
        );
    }

    fn averaged(&self) -> Vec<Colour> {
        let mean = |row: usize, column: usize| {
            let mut sums = [0_usize; 3];
            for line in SAMPLES * row..SAMPLES * (row + 1) {
                for sample in &self.samples[line * self.width + SAMPLES * column..][..SAMPLES] {
                    sums = [0, 1, 2].map(|part| sums[part] + usize::from(sample[part]));
                }
            }
            sums.map(|sum| (sum / (SAMPLES * SAMPLES)) as u8)
        };
        (0..self.height / SAMPLES)
            .flat_map(|row| (0..self.width / SAMPLES).map(move |column| mean(row, column)))
            .collect()
    }
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The first sample whose middle is beyond a place.
fn rounded(place: f64, most: usize) -> usize {
    (place - 0.5).ceil().clamp(0.0, most as f64) as usize
}

/// The dashes of a line.
fn dashes(line: &[Point]) -> Vec<[Point; 2]> {
    let mut dashes = Vec::new();
    // How much is left of the dash or gap that is being drawn.
    let (mut is_dash, mut left) = (true, DASHES[0]);
    for two in line.windows(2) {
        let [from, to] = [two[0], two[1]];
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let at = |place: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * place / length);
        let mut place = 0.0;
        while length - place > 1e-9 {
            let end = (place + left).min(length);
            if is_dash {
                dashes.push([at(place), at(end)]);
            }
            left -= end - place;
            if left <= 1e-9 {
                is_dash = !is_dash;
                left = DASHES[usize::from(!is_dash)];
            }
            place = end;
        }
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_fill_their_area() {
        let mut sheet = Sheet::new(60, 40);
        let corners = [[10.0, 5.0], [50.0, 12.0], [41.0, 36.0], [8.0, 30.0]];
        sheet.fill(&corners, [0; 3]);
        let area: f64 = (0..4)
            .map(|index| [corners[index], corners[(index + 1) % 4]])
            .map(|[a, b]| a[0] * b[1] - a[1] * b[0])
            .sum();
        let filled: f64 = sheet.averaged().iter().map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0).sum();
        assert!((filled / (0.5 * area) - 1.0).abs() < 0.01, "{filled}, not {}", 0.5 * area);
        // What is outside of the sheet is left out, wherever it is.
        for far in [-1e9, 1e9, f64::NAN] {
            sheet.fill(&corners.map(|[x, y]| [x + far, y]), [0; 3]);
            sheet.fill(&corners.map(|[x, y]| [x, y + far]), [0; 3]);
        }
        assert_eq!(filled, sheet.averaged().iter().map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0).sum::<f64>());
    }

    #[test]
    fn dashes_run_around_corners() {
        let dashes = dashes(&[[0.0, 0.0], [7.0, 0.0], [7.0, 6.0]]);
        assert_eq!(dashes, [[[0.0, 0.0], [5.0, 0.0]], [[7.0, 2.0], [7.0, 6.0]]]);
    }
}
