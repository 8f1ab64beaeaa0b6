//! Pictures of a film as pixels. They are drawn three times as large and averaged: smooth edges of facets that lie side by
//! side would let the ground through.

use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

use super::film::{Film, Item, Outline, Picture, Shape};
use super::outline::Point;
use crate::figures::Colour;

/// Samples per pixel along each side.
const SAMPLES: usize = 3;
const BAR: Colour = [0x59, 0x65, 0x79];
/// Height of the bar of time, width of lines and of dashed ones, dash and gap (pixels).
const BAR_HEIGHT: f64 = 3.0;
const LINE: f32 = 1.6;
const DASHED_LINE: f32 = 1.2;
const DASHES: [f32; 2] = [5.0, 4.0];

/// A sheet of samples, white at first.
struct Sheet(Pixmap);

/// The colours of all pixels of a picture, row by row. `None` for pictures without a size.
pub fn pixels(film: &Film, picture: &Picture) -> Option<Vec<Colour>> {
    let mut sheet = Sheet::new(film.size)?;
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
    Some(sheet.averaged())
}

impl Sheet {
    fn new(size: Point) -> Option<Self> {
        let [width, height] = size.map(|length| SAMPLES as u32 * length as u32);
        let mut sheet = Pixmap::new(width, height)?;
        sheet.fill(Color::WHITE);
        Some(Self(sheet))
    }

    /// Fills a polygon.
    fn fill(&mut self, corners: &[Point], colour: Colour) {
        if let Some(path) = path(corners, true) {
            self.0.fill_path(&path, &paint(colour), FillRule::Winding, scale(), None);
        }
    }

    fn outline(&mut self, outline: &Outline) {
        let dash = outline.dashed.then(|| StrokeDash::new(DASHES.to_vec(), 0.0)).flatten();
        let width = if outline.dashed { DASHED_LINE } else { LINE };
        let stroke = Stroke { width, dash, ..Stroke::default() };
        for path in outline.lines.iter().filter_map(|line| path(line, false)) {
            self.0.stroke_path(&path, &paint(outline.colour), &stroke, scale(), None);
        }
    }

    fn averaged(&self) -> Vec<Colour> {
        let width = self.0.width() as usize;
        let mean = |row: usize, column: usize| {
            let samples = (SAMPLES * row..SAMPLES * (row + 1))
                .flat_map(|line| &self.0.pixels()[line * width + SAMPLES * column..][..SAMPLES]);
            let sums = samples.fold([0_usize; 3], |[red, green, blue], sample| {
                [
                    red + usize::from(sample.red()),
                    green + usize::from(sample.green()),
                    blue + usize::from(sample.blue()),
                ]
            });
            sums.map(|sum| (sum / (SAMPLES * SAMPLES)) as u8)
        };
        let (rows, columns) = (self.0.height() as usize / SAMPLES, width / SAMPLES);
        (0..rows).flat_map(|row| (0..columns).map(move |column| mean(row, column))).collect()
    }
}

/// A path through some points. `None` where there are too few, or one is not finite.
fn path(points: &[Point], is_closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (index, [x, y]) in points.iter().map(|point| point.map(|place| place as f32)).enumerate() {
        if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    if is_closed {
        path.close();
    }
    path.finish()
}

fn paint([red, green, blue]: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: false, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, 255);
    paint
}

fn scale() -> Transform {
    Transform::from_scale(SAMPLES as f32, SAMPLES as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn darkness(sheet: &Sheet) -> f64 {
        sheet.averaged().iter().map(|pixel| 1.0 - f64::from(pixel[0]) / 255.0).sum()
    }

    #[test]
    fn polygons_fill_their_area() {
        let mut sheet = Sheet::new([60.0, 40.0]).unwrap();
        let corners = [[10.0, 5.0], [50.0, 12.0], [41.0, 36.0], [8.0, 30.0]];
        sheet.fill(&corners, [0; 3]);
        let area: f64 = (0..4)
            .map(|index| [corners[index], corners[(index + 1) % 4]])
            .map(|[a, b]| a[0] * b[1] - a[1] * b[0])
            .sum();
        let filled = darkness(&sheet);
        assert!((filled / (0.5 * area) - 1.0).abs() < 0.01, "{filled}, not {}", 0.5 * area);
        // What is outside of the sheet is left out, wherever it is.
        for far in [-1e9, 1e9, f64::NAN] {
            sheet.fill(&corners.map(|[x, y]| [x + far, y]), [0; 3]);
            sheet.fill(&corners.map(|[x, y]| [x, y + far]), [0; 3]);
        }
        assert_eq!(filled, darkness(&sheet));
    }

    #[test]
    fn lines_have_their_width_and_gaps() {
        let lines = vec![vec![[5.0, 3.0], [50.0, 12.0], [47.0, 37.0]]];
        let drawn = |dashed: bool| {
            let mut sheet = Sheet::new([60.0, 40.0]).unwrap();
            sheet.outline(&Outline { lines: lines.clone(), colour: [0; 3], dashed });
            darkness(&sheet)
        };
        let (whole, dashed) = (71.1 * f64::from(LINE), 40.0 * f64::from(DASHED_LINE));
        assert!((drawn(false) / whole - 1.0).abs() < 0.1, "{}, not {whole}", drawn(false));
        assert!((drawn(true) / dashed - 1.0).abs() < 0.2, "{}, not {dashed}", drawn(true));
    }
}
