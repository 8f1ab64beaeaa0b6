//! Polygons of OBJ files.

use std::cmp::Ordering;
use std::collections::HashMap;

use crate::error::MeshError;
use crate::foreign::refuse_foreign;
use crate::geometry::Vector;
use crate::precision::Digits;
use crate::read::{Format, MOST_TRIANGLES, Triangles};
use crate::text::{at, lines, number, shown, words};
use crate::triangulate::triangulate;

/// Keywords of what has no shape of its own: looks, names, groups, points, lines, curves and the values of free forms.
const SHAPELESS: &[&str] = &[
    "vn",
    "vt",
    "vp",
    "vc",
    "o",
    "g",
    "s",
    "mg",
    "mtllib",
    "usemtl",
    "usemap",
    "maplib",
    "p",
    "l",
    "curv",
    "curv2",
    "cstype",
    "deg",
    "bmat",
    "step",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "cdc",
    "res",
];
/// Keywords of shapes that are not read.
const UNREAD: &[&str] = &["surf", "bsp", "bzp", "cdp", "call", "csh"];

/// The triangles of a file. Textures, colours, normals and groups do not matter.
///
/// # Errors
/// When a line is wrong, or is a shape that is not read.
pub fn read(bytes: &[u8]) -> Result<Triangles, MeshError> {
    refuse_foreign(bytes, Format::Obj)?;
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut faces = Vec::new();
    let mut digits = Digits::default();
    for (line, text) in joined_lines(bytes) {
        let mut words = words(&text);
        let Some(word) = words.next() else { continue };
        let keyword = str::from_utf8(word).unwrap_or_default().to_ascii_lowercase();
        match keyword.as_str() {
            "v" => vertices.push(vertex(&words.collect::<Vec<_>>(), line, &mut digits)?),
            "f" | "fo" => {
                let corners = words.map(|word| Ok(index(word, line)?.counted_from_first(vertices.len())));
                faces.push((line, corners.collect::<Result<Vec<i64>, MeshError>>()?));
            }
            known if SHAPELESS.contains(&known) => {}
            known if UNREAD.contains(&known) => {
                let problem = format!("{} is not read: export polygons without free forms and references", shown(word));
                return Err(at(line, problem));
            }
            _ => return Err(at(line, format!("{} is no keyword of OBJ files", shown(word)))),
        }
    }
    let mut triangles = Vec::new();
    for (line, corners) in faces {
        triangles.extend(face(&corners, &vertices, line)?);
        if triangles.len() > MOST_TRIANGLES {
            return Err(MeshError::TooManyTriangles { most: MOST_TRIANGLES });
        }
    }
    let (vertices, triangles) = used(&vertices, triangles);
    Ok(Triangles { vertices, triangles, rounding: digits.rounding() })
}

/// The lines without comments; those that end with a backslash with the next one.
fn joined_lines(bytes: &[u8]) -> impl Iterator<Item = (usize, Vec<u8>)> {
    let mut lines = lines(bytes);
    std::iter::from_fn(move || {
        let (number, mut text) = lines.next().map(|(number, line)| (number, without_comment(line).to_vec()))?;
        while text.trim_ascii_end().ends_with(b"\\") {
            text.truncate(text.trim_ascii_end().len() - 1);
            let Some((_, next)) = lines.next() else { break };
            text.push(b' ');
            text.extend(without_comment(next));
        }
        Some((number, text))
    })
}

fn without_comment(line: &[u8]) -> &[u8] {
    line.split(|byte| *byte == b'#').next().unwrap_or_default()
}

/// Three coordinates. A fourth number alone is the weight that divides them; more are a colour.
fn vertex(words: &[&[u8]], line: usize, digits: &mut Digits) -> Result<[f64; 3], MeshError> {
    let &[x, y, z, ..] = words else {
        return Err(at(line, format!("a vertex needs three coordinates, not {}", words.len())));
    };
    [x, y, z].iter().for_each(|word| digits.note(word));
    let point = [number(x, line)?, number(y, line)?, number(z, line)?];
    let weight = if let [_, _, _, weight] = words { number(weight, line)? } else { 1.0 };
    if weight == 0.0 {
        return Err(at(line, "the weight of a vertex must not be zero"));
    }
    Ok(point.map(|coordinate| coordinate / weight))
}

/// A vertex of a face as the file names it: from one, or backwards from minus one.
struct Index(i64);

impl Index {
    /// Counted from zero; out of range where there is no such vertex.
    fn counted_from_first(&self, known: usize) -> i64 {
        if self.0 > 0 { self.0 - 1 } else { self.0.saturating_add(known as i64) }
    }
}

/// The index of the vertex alone: those of textures and normals behind slashes do not matter.
fn index(word: &[u8], line: usize) -> Result<Index, MeshError> {
    let vertex = word.split(|byte| *byte == b'/').next().unwrap_or_default();
    let index = str::from_utf8(vertex).ok().and_then(|vertex| vertex.parse().ok());
    match index {
        Some(index) if index != 0 => Ok(Index(index)),
        _ => Err(at(line, format!("{} is no index of a vertex, which are counted from one", shown(word)))),
    }
}

/// The triangles of a polygon of any shape: a fan from its first corner would overlap itself.
fn face(corners: &[i64], vertices: &[[f64; 3]], line: usize) -> Result<Vec<[usize; 3]>, MeshError> {
    if corners.len() < 3 {
        return Err(at(line, format!("a face needs three corners, not {}", corners.len())));
    }
    let place = |&corner: &i64| usize::try_from(corner).ok().filter(|&corner| corner < vertices.len());
    let Some(corners) = corners.iter().map(place).collect::<Option<Vec<usize>>>() else {
        return Err(at(line, format!("the face names a vertex that does not exist: there are {}", vertices.len())));
    };
    let (corners, is_reversed) = from_lowest(corners, vertices);
    let points: Vec<Vector> = corners.iter().map(|&corner| Vector::from(vertices[corner])).collect();
    let triangles = triangulate(&points).into_iter().map(|triangle| {
        let [a, b, c] = triangle.map(|place| corners[place]);
        if is_reversed { [a, c, b] } else { [a, b, c] }
    });
    Ok(triangles.collect())
}

/// The corners from the lowest one on towards the lower of its neighbours, and whether that is backwards: so both sides
/// of a polygon, and its copies, have the same triangles.
fn from_lowest(mut corners: Vec<usize>, vertices: &[[f64; 3]]) -> (Vec<usize>, bool) {
    let order = |one: usize, other: usize| {
        let pairs = vertices[one].iter().zip(&vertices[other]);
        pairs.map(|(one, other)| one.total_cmp(other)).fold(Ordering::Equal, Ordering::then)
    };
    let lowest = (0..corners.len()).min_by(|&one, &other| order(corners[one], corners[other])).unwrap_or(0);
    corners.rotate_left(lowest);
    let is_reversed = order(corners[corners.len() - 1], corners[1]).is_lt();
    if is_reversed {
        corners[1..].reverse();
    }
    (corners, is_reversed)
}

/// The vertices that triangles have, in the order in which these name them.
fn used(vertices: &[[f64; 3]], mut triangles: Vec<[usize; 3]>) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let mut places: HashMap<usize, usize> = HashMap::new();
    let mut used = Vec::new();
    for corner in triangles.iter_mut().flatten() {
        *corner = *places.entry(*corner).or_insert_with_key(|&corner| {
            used.push(vertices[corner]);
            used.len() - 1
        });
    }
    (used, triangles)
}
