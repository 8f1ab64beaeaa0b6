//! Chains of planar strips that run around cylinders and cones.

use std::collections::{BTreeMap, BTreeSet};

use crate::edges::{Edges, directed, undirected};
use crate::faces::{Faces, NONE};
use crate::geometry::Vector;

/// Neighbouring strips of a curved surface differ by less than this angle (rad): a 12-gon is a prism.
pub const LARGEST_ANGLE: f64 = 25.0 / 180.0 * std::f64::consts::PI;

/// A strip between two lines across the chain, each from the one rim to the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    pub face: usize,
    /// Vertices (indices) of the line where the chain comes in and of that where it goes out.
    pub lines: [(usize, usize); 2],
}

/// Strips each of which begins where the one before ends.
#[derive(Debug, Clone)]
pub struct Chain {
    pub strips: Vec<Strip>,
    pub is_closed: bool,
}

/// The faces behind the sides of faces, by their directed corners: `(from, to)` as the face runs through it.
pub struct Sides {
    behind: BTreeMap<(usize, usize), usize>,
}

impl Sides {
    /// Sides with one smooth neighbour each.
    pub fn of(faces: &Faces, triangles: &[[usize; 3]], edges: &Edges) -> Self {
        let mut neighbors: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for (index, face) in faces.faces.iter().enumerate() {
            if !(3..=4).contains(&face.corners.len()) {
                continue;
            }
            for side in directed_sides(&face.corners) {
                neighbors.insert(side, index);
            }
        }
        let mut touching: BTreeSet<(usize, usize)> = BTreeSet::new();
        for (triangle, corners) in triangles.iter().enumerate() {
            for edge in directed(*corners) {
                for other in edges.at(undirected(edge)) {
                    touching.insert((faces.of_triangle[triangle], faces.of_triangle[other.triangle]));
                }
            }
        }
        let is_smooth = |one: usize, other: usize| {
            let cosine = faces.faces[one].plane.normal.dot(&faces.faces[other].plane.normal);
            cosine > LARGEST_ANGLE.cos()
        };
        let behind = neighbors.iter().filter_map(|(&(from, to), &face)| {
            let other = *neighbors.get(&(to, from))?;
            (other != face && other != NONE && touching.contains(&(face, other)) && is_smooth(face, other))
                .then_some(((from, to), other))
        });
        Self { behind: behind.collect() }
    }

    fn next(&self, faces: &Faces, strip: &Strip) -> Option<Strip> {
        let (near, far) = strip.lines[1];
        let corners = &faces.faces[strip.face].corners;
        let side = directed_sides(corners).find(|&side| side == (near, far) || side == (far, near))?;
        let face = *self.behind.get(&side)?;
        let apex = [near, far].into_iter().find(|vertex| [strip.lines[0].0, strip.lines[0].1].contains(vertex));
        crossing(face, &faces.faces[face].corners, strip.lines[1], apex)
    }

    /// All chains of at least `least` strips.
    pub fn chains(&self, faces: &Faces, least: usize) -> Vec<Chain> {
        let mut is_used: BTreeSet<(usize, [(usize, usize); 2])> = BTreeSet::new();
        let key = |strip: &Strip| {
            let mut lines = strip.lines.map(undirected);
            lines.sort_unstable();
            (strip.face, lines)
        };
        let mut chains = Vec::new();
        for (index, face) in faces.faces.iter().enumerate() {
            for start in starts(index, &face.corners) {
                if is_used.contains(&key(&start)) {
                    continue;
                }
                let mut strips = self.walk(faces, start);
                let is_closed =
                    strips.len() > 2 && self.next(faces, &strips[strips.len() - 1]).is_some_and(|next| next == start);
                if !is_closed {
                    let mut before = self.walk(faces, reversed(start));
                    before.remove(0);
                    before.reverse();
                    strips = before.into_iter().map(reversed).chain(strips).collect();
                }
                is_used.extend(strips.iter().map(key));
                if strips.len() >= least {
                    chains.push(Chain { strips, is_closed });
                }
            }
        }
        chains
    }

    fn walk(&self, faces: &Faces, start: Strip) -> Vec<Strip> {
        let mut strips = vec![start];
        let mut faces_used = BTreeSet::from([start.face]);
        while let Some(next) = strips.last().and_then(|last| self.next(faces, last)) {
            if !faces_used.insert(next.face) {
                break;
            }
            strips.push(next);
        }
        strips
    }
}

fn reversed(strip: Strip) -> Strip {
    Strip { lines: [strip.lines[1], strip.lines[0]], ..strip }
}

fn directed_sides(corners: &[usize]) -> impl Iterator<Item = (usize, usize)> {
    (0..corners.len()).map(|at| (corners[at], corners[(at + 1) % corners.len()]))
}

/// The ways to cross a face.
fn starts(face: usize, corners: &[usize]) -> Vec<Strip> {
    match *corners {
        [a, b, c, d] => vec![Strip { face, lines: [(a, b), (d, c)] }, Strip { face, lines: [(b, c), (a, d)] }],
        [a, b, c] => vec![
            Strip { face, lines: [(a, b), (a, c)] },
            Strip { face, lines: [(b, c), (b, a)] },
            Strip { face, lines: [(c, a), (c, b)] },
        ],
        _ => Vec::new(),
    }
}

/// The strip of a face that begins at a line; in a triangle the chain turns around its apex.
fn crossing(face: usize, corners: &[usize], line: (usize, usize), apex: Option<usize>) -> Option<Strip> {
    let is_start = |lines: [(usize, usize); 2]| undirected(lines[0]) == undirected(line);
    let strips = starts(face, corners).into_iter().flat_map(|strip| [strip, reversed(strip)]);
    let mut strips = strips.filter(|strip| is_start(strip.lines)).map(|strip| {
        // The lines run from the same rim as the given one.
        let turn = |(from, to): (usize, usize)| if strip.lines[0] == line { (from, to) } else { (to, from) };
        Strip { face, lines: strip.lines.map(turn) }
    });
    strips.find(|strip| {
        corners.len() == 4 || {
            let [(a, b), (c, d)] = strip.lines;
            let shared = if a == c { a } else { b };
            (a == c || b == d) && apex == Some(shared)
        }
    })
}

/// The points of the lines across a run of strips: one list for each rim.
pub fn rims(strips: &[Strip], vertices: &[Vector]) -> [Vec<Vector>; 2] {
    let lines = strips.first().map(|strip| strip.lines[0]).into_iter().chain(strips.iter().map(|strip| strip.lines[1]));
    let lines: Vec<(usize, usize)> = lines.collect();
    [lines.iter().map(|line| vertices[line.0]).collect(), lines.iter().map(|line| vertices[line.1]).collect()]
}
