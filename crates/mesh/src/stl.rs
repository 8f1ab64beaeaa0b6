//! STL files: triangles as text or as records of 50 bytes.

use crate::error::MeshError;
use crate::foreign::refuse_foreign;
use crate::precision::{self, Digits};
use crate::read::{Format, MOST_TRIANGLES, Triangles};
use crate::text::{at, is_blank, lines, number, shown, without_mark, words};

/// A header with the number of triangles, then that many records.
const HEADER: usize = 84;
const RECORD: usize = 50;
/// A record begins with a normal, which says nothing that the corners do not.
const NORMAL: usize = 12;
/// Largest count in files of the largest size: its last byte, and the last one of the header, is zero.
const COUNT: std::ops::Range<usize> = 80..HEADER;

/// The triangles of a file. The size decides whether it is binary, as some programs begin binary files with the word that
/// marks text.
///
/// # Errors
/// When it is neither, is cut off or has something that is read as no triangle.
pub fn read(bytes: &[u8]) -> Result<Triangles, MeshError> {
    if is_binary(bytes) {
        return binary(bytes);
    }
    if is_text(bytes) {
        return text(bytes);
    }
    refuse_foreign(bytes, Format::Stl)?;
    binary(bytes)
}

/// Whether a file has the size of the binary triangles that its header states.
pub fn is_binary(bytes: &[u8]) -> bool {
    stated(bytes).is_some_and(|count| bytes.len() as u64 == end_of(count))
}

/// Whether a file that is not binary by its size begins like text.
pub fn is_text(bytes: &[u8]) -> bool {
    let begin = words(without_mark(bytes)).next();
    let has_count = bytes.get(COUNT).is_some_and(|count| count.contains(&0));
    !has_count && begin.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

fn stated(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(COUNT)?.try_into().ok()?))
}

fn end_of(count: u32) -> u64 {
    HEADER as u64 + RECORD as u64 * u64::from(count)
}

fn binary(bytes: &[u8]) -> Result<Triangles, MeshError> {
    let size = bytes.len();
    let Some(count) = stated(bytes) else {
        let reason = format!("it is no STL file: it has {size} bytes and does not begin with `solid`");
        return Err(MeshError::Read { reason });
    };
    if end_of(count) > size as u64 {
        return Err(MeshError::CutOff { count, needed: end_of(count), size });
    }
    let end = HEADER + RECORD * count as usize;
    if !bytes[end..].iter().all(|byte| is_blank(*byte)) {
        return Err(MeshError::LeftOver { count, end, left: size - end });
    }
    if count as usize > MOST_TRIANGLES {
        return Err(MeshError::TooManyTriangles { most: MOST_TRIANGLES });
    }
    let mut vertices = Vec::with_capacity(3 * count as usize);
    for (index, record) in (1..).zip(bytes[HEADER..end].chunks_exact(RECORD)) {
        for corner in record[NORMAL..].chunks_exact(12) {
            let coordinate = |axis: usize| {
                let bytes = std::array::from_fn(|byte| corner[4 * axis + byte]);
                f64::from(f32::from_le_bytes(bytes))
            };
            let corner = [0, 1, 2].map(coordinate);
            if !corner.iter().all(|coordinate| coordinate.is_finite()) {
                let reason =
                    format!("triangle {index} (counted from one) has a coordinate that is not a finite number");
                return Err(MeshError::Read { reason });
            }
            vertices.push(corner);
        }
    }
    Ok(separate(vertices, 0.0))
}

/// Each triangle with corners of its own, whose coordinates had single precision when they were written.
fn separate(vertices: Vec<[f64; 3]>, rounding: f64) -> Triangles {
    let triangles = (0..vertices.len() / 3).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect();
    let rounding = rounding.max(precision::single(&vertices));
    Triangles { vertices, triangles, rounding }
}

fn text(bytes: &[u8]) -> Result<Triangles, MeshError> {
    let mut words = Words::of(bytes);
    let mut vertices = Vec::new();
    let mut digits = Digits::default();
    while words.expect_if_any("solid")? {
        words.skip_name()?;
        while words.one_of(["facet", "endsolid"])? == "facet" {
            words.skip_normal()?;
            for _ in 0..3 {
                words.expect("vertex")?;
                vertices.push(words.corner(&mut digits)?);
            }
            words.expect("endloop")?;
            words.expect("endfacet")?;
            if vertices.len() > 3 * MOST_TRIANGLES {
                return Err(MeshError::TooManyTriangles { most: MOST_TRIANGLES });
            }
        }
        words.skip_name()?;
    }
    Ok(separate(vertices, digits.rounding()))
}

/// The words of a file, in small letters or capitals, with `end facet` for `endfacet`.
struct Words<'a> {
    lines: Box<dyn Iterator<Item = (usize, &'a [u8])> + 'a>,
    line: usize,
    /// The words of the line that are not taken, the last one first.
    waiting: Vec<&'a [u8]>,
}

impl<'a> Words<'a> {
    fn of(bytes: &'a [u8]) -> Self {
        Self { lines: Box::new(lines(bytes)), line: 1, waiting: Vec::new() }
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        while self.waiting.is_empty() {
            let (line, text) = self.lines.next()?;
            let is_empty = text.iter().all(|byte| is_blank(*byte));
            // A file that is cut off ends in its last line with words.
            if !is_empty {
                self.line = line;
                self.waiting.extend(words(text));
                self.waiting.reverse();
            }
        }
        self.waiting.pop()
    }

    /// The next word, which must be one of these.
    fn one_of<const N: usize>(&mut self, expected: [&'static str; N]) -> Result<&'static str, MeshError> {
        let wanted = || expected.map(|word| format!("`{word}`")).join(" or ");
        let Some(word) = self.next() else {
            return Err(at(self.line, format!("the file is cut off: it ends where {} should follow", wanted())));
        };
        let end = word.eq_ignore_ascii_case(b"end").then(|| self.next().unwrap_or_default());
        let whole = end.map_or(word.to_ascii_lowercase(), |rest| [b"end", rest].concat().to_ascii_lowercase());
        if let Some(found) = expected.into_iter().find(|expected| expected.as_bytes() == whole) {
            return Ok(found);
        }
        let line = self.line;
        let cut = if self.next().is_none() { "the file is cut off: it ends with " } else { "" };
        Err(at(line, format!("{cut}{} where {} should be", shown(&whole), wanted())))
    }

    fn expect(&mut self, expected: &'static str) -> Result<(), MeshError> {
        self.one_of([expected]).map(|_| ())
    }

    /// Whether there is another word, which must be this one.
    fn expect_if_any(&mut self, expected: &'static str) -> Result<bool, MeshError> {
        match self.next() {
            None => Ok(false),
            Some(word) => {
                self.waiting.push(word);
                self.expect(expected).map(|()| true)
            }
        }
    }

    /// Passes over the name of a solid: the rest of its line.
    fn skip_name(&mut self) -> Result<(), MeshError> {
        if self.waiting.iter().any(|word| word.eq_ignore_ascii_case(b"vertex")) {
            return Err(at(self.line, "a name that ends with the line has triangles in it: begin a new line after it"));
        }
        self.waiting.clear();
        Ok(())
    }

    /// Passes over the normal of a facet, whatever its numbers are: the corners say it too.
    fn skip_normal(&mut self) -> Result<(), MeshError> {
        if self.one_of(["normal", "outer"])? == "normal" {
            for _ in 0..3 {
                self.next();
            }
            self.expect("outer")?;
        }
        self.expect("loop")
    }

    fn corner(&mut self, digits: &mut Digits) -> Result<[f64; 3], MeshError> {
        let mut corner = [0.0; 3];
        for coordinate in &mut corner {
            let Some(word) = self.next() else {
                return Err(at(self.line, "the file is cut off: it ends where a coordinate should follow"));
            };
            *coordinate = number(word, self.line)?;
            digits.note(word);
        }
        Ok(corner)
    }
}
