//! A film as a GIF, which repeats without end. All pictures share one palette, and each holds only what has changed.

use std::collections::{BTreeMap, HashMap};

use ::gif::{AnyExtension, Encoder, Frame, Repeat};
use plan::PlannerError;

use super::film::{Film, REST};
use super::raster::pixels;
use crate::figures::Colour;

/// Comment by which a file is known as ours.
const COMMENT: &[u8] = b"drawn by assembly-plan report";
/// Place in the file before which the comment stands.
const BEGIN: usize = 1024;
/// Colours of the palette; the one after them means that a pixel stays as it is.
const COLOURS: usize = 255;
const UNCHANGED: u8 = 255;

/// Whether a file is an animation of ours.
pub fn is_own(content: &[u8]) -> bool {
    let begin = &content[..content.len().min(BEGIN)];
    begin.starts_with(b"GIF89a") && begin.windows(COMMENT.len()).any(|part| part == COMMENT)
}

/// The content of the file.
///
/// # Errors
/// None that a film of ours causes.
pub fn write(film: &Film) -> Result<Vec<u8>, PlannerError> {
    let drawn: Option<Vec<Vec<Colour>>> = film.pictures.iter().map(|picture| pixels(film, picture)).collect();
    let drawn = drawn.ok_or_else(|| failed("no size"))?;
    let mut palette = Palette::new(&drawn);
    let [width, height] = film.size.map(|length| length as u16);
    let mut content = Vec::new();
    let mut encoder = Encoder::new(&mut content, width, height, &palette.bytes()).map_err(failed)?;
    encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
    encoder.write_raw_extension(AnyExtension(0xfe), &[COMMENT]).map_err(failed)?;
    let mut before: Option<Vec<u8>> = None;
    for (index, colours) in drawn.iter().enumerate() {
        let time = if index + 1 == drawn.len() { REST } else { film.interval };
        let indices = palette.indices(colours);
        let frame = change(before.as_deref(), &indices, usize::from(width), (100.0 * time).round() as u16);
        encoder.write_frame(&frame).map_err(failed)?;
        before = Some(indices);
    }
    drop(encoder);
    Ok(content)
}

fn failed<E>(_: E) -> PlannerError {
    PlannerError::Internal("the writer of GIF files")
}

/// What changes from a picture to the next one, in the least rectangle.
fn change(before: Option<&[u8]>, after: &[u8], width: usize, delay: u16) -> Frame<'static> {
    let height = after.len() / width;
    let differs = |row: usize, column: usize| {
        let place = row * width + column;
        before.is_none_or(|before| before[place] != after[place])
    };
    let rows: Vec<usize> = (0..height).filter(|&row| (0..width).any(|column| differs(row, column))).collect();
    let columns: Vec<usize> = (0..width).filter(|&column| rows.iter().any(|&row| differs(row, column))).collect();
    // Where nothing changes, a single pixel is as it was.
    let [top, bottom] = [*rows.first().unwrap_or(&0), *rows.last().unwrap_or(&0)];
    let [left, right] = [*columns.first().unwrap_or(&0), *columns.last().unwrap_or(&0)];
    let pixel = |row: usize, column: usize| if differs(row, column) { after[row * width + column] } else { UNCHANGED };
    let buffer: Vec<u8> = (top..=bottom).flat_map(|row| (left..=right).map(move |column| pixel(row, column))).collect();
    let mut frame =
        Frame::from_indexed_pixels((right - left + 1) as u16, (bottom - top + 1) as u16, buffer, Some(UNCHANGED));
    (frame.left, frame.top, frame.delay) = (left as u16, top as u16, delay);
    frame
}

/// The most frequent colours.
struct Palette {
    colours: Vec<Colour>,
    /// The nearest one of each colour that was asked for.
    known: HashMap<Colour, u8>,
}

impl Palette {
    fn new(drawn: &[Vec<Colour>]) -> Self {
        let mut counts: BTreeMap<Colour, usize> = BTreeMap::new();
        for run in drawn.iter().flat_map(|colours| colours.chunk_by(PartialEq::eq)) {
            *counts.entry(run[0]).or_default() += run.len();
        }
        let mut colours: Vec<Colour> = counts.keys().copied().collect();
        colours.sort_by_key(|colour| std::cmp::Reverse(counts[colour]));
        colours.truncate(COLOURS);
        Self { colours, known: HashMap::new() }
    }

    /// Three bytes for each colour, and for that of unchanged pixels.
    fn bytes(&self) -> Vec<u8> {
        let mut bytes: Vec<u8> = self.colours.iter().flatten().copied().collect();
        bytes.resize(3 * (COLOURS + 1), 0);
        bytes
    }

    /// The places of the pixels of a picture in the palette.
    fn indices(&mut self, colours: &[Colour]) -> Vec<u8> {
        let mut indices = Vec::with_capacity(colours.len());
        for run in colours.chunk_by(PartialEq::eq) {
            indices.resize(indices.len() + run.len(), self.nearest(run[0]));
        }
        indices
    }

    fn nearest(&mut self, colour: Colour) -> u8 {
        let distance = |other: &Colour| {
            (0..3).map(|part| i32::from(colour[part]) - i32::from(other[part])).map(|by| by * by).sum::<i32>()
        };
        let nearest =
            || (0..).zip(&self.colours).min_by_key(|(_, other)| distance(other)).map_or(0, |(index, _)| index);
        *self.known.entry(colour).or_insert_with(nearest)
    }
}

#[cfg(test)]
mod tests {
    use ::gif::{ColorOutput, DecodeOptions};

    use super::*;
    use crate::animation::film::{Item, Picture, Shape};

    /// A square that moves to the right, then rests.
    fn film() -> Film {
        let square = |left: f64| Shape {
            corners: vec![[left, 10.0], [left + 20.0, 10.0], [left + 20.0, 30.0], [left, 30.0]],
            colour: [200, 30, 30],
        };
        let picture =
            |left: f64, share: f64| Picture { items: vec![Item::Moving(vec![square(left)])], outlines: vec![], share };
        let pictures = vec![picture(0.0, 0.0), picture(15.0, 0.5), picture(30.0, 1.0), picture(30.0, 1.0)];
        Film { size: [60.0, 40.0], fixed: vec![], pictures, interval: 0.07 }
    }

    #[test]
    fn another_reader_sees_the_same_pictures() {
        let film = film();
        let content = write(&film).unwrap();
        assert!(is_own(&content) && !is_own(&content[..20]) && !is_own(b""));
        let mut options = DecodeOptions::new();
        options.set_color_output(ColorOutput::RGBA);
        let mut decoder = options.read_info(&content[..]).unwrap();
        assert_eq!((decoder.width(), decoder.height(), decoder.repeat()), (60, 40, Repeat::Infinite));
        let mut shown = vec![[0_u8; 3]; 60 * 40];
        let mut delays = Vec::new();
        for picture in &film.pictures {
            let frame = decoder.read_next_frame().unwrap().unwrap();
            delays.push(frame.delay);
            for (index, pixel) in frame.buffer.as_chunks::<4>().0.iter().enumerate() {
                let (row, column) = (index / usize::from(frame.width), index % usize::from(frame.width));
                if pixel[3] > 0 {
                    let place = (row + usize::from(frame.top)) * 60 + column + usize::from(frame.left);
                    shown[place] = [pixel[0], pixel[1], pixel[2]];
                }
            }
            assert_eq!(Some(&shown), pixels(&film, picture).as_ref());
        }
        assert!(decoder.read_next_frame().unwrap().is_none());
        assert_eq!(delays, [7, 7, 7, 100]);
    }
}
