//! Convex walls around a hole: one per edge of its outline.

use std::iter;

use super::section::{Line, Point, Section, area};

/// Distance (m) that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// A wall along an edge of a hole's outline.
pub struct Wall {
    /// Counterclockwise corners (m) of a rectangle outside the edge.
    slab: Vec<Point>,
    /// Pairs of corners of the outline: the edge, and where the hole is not convex, sides of its pieces that the slab
    /// reaches over. The wall is outside the lines through them.
    bounds: Vec<[usize; 2]>,
}

impl Wall {
    /// One wall per edge, around a hole. Walls overlap each other, and not the hole.
    pub fn around(hole: &Section, thickness: f64) -> Vec<Self> {
        let wall = |edge: usize| {
            let (line, slab) = (hole.edge(edge), slab(hole, edge, thickness));
            let reaches_beyond =
                |piece: &&Vec<usize>| hole.piece(piece).into_iter().any(|corner| line.distance(corner) > ROUNDING);
            let others = hole.pieces.iter().filter(reaches_beyond);
            let sides = others.filter_map(|piece| separating(hole, piece, edge, &slab));
            let bounds = iter::once([edge, (edge + 1) % hole.outline.len()]).chain(sides).collect();
            Self { slab, bounds }
        };
        (0..hole.outline.len()).map(wall).collect()
    }

    /// Its section (m) around the hole that it was made for, or around the same hole with its edges moved outwards.
    pub fn section(&self, hole: &Section) -> Vec<Point> {
        let lines = self.bounds.iter().map(|&[from, to]| Line::through(hole.outline[from], hole.outline[to]));
        lines.fold(self.slab.clone(), |section, line| line.outside_of(&section))
    }
}

/// A rectangle outside an edge, longer than the edge by its thickness at both ends, so that corners are closed.
fn slab(hole: &Section, edge: usize, thickness: f64) -> Vec<Point> {
    let line = hole.edge(edge);
    let (along, out) = (line.direction(), line.outwards());
    let (from, to) = (hole.outline[edge], hole.outline[(edge + 1) % hole.outline.len()]);
    let place = |[x, y]: Point, a: f64, b: f64| {
        [x + thickness * (a * along[0] + b * out[0]), y + thickness * (a * along[1] + b * out[1])]
    };
    vec![place(from, -1.0, 0.0), place(from, -1.0, 1.0), place(to, 1.0, 1.0), place(to, 1.0, 0.0)]
}

/// The side of a convex piece that separates it from an edge of the outline and leaves most of the edge's wall.
fn separating(hole: &Section, piece: &[usize], edge: usize, slab: &[Point]) -> Option<[usize; 2]> {
    let ends = [hole.outline[edge], hole.outline[(edge + 1) % hole.outline.len()]];
    let sides = (0..piece.len()).map(|index| [piece[index], piece[(index + 1) % piece.len()]]);
    let line = |side: &[usize; 2]| Line::through(hole.outline[side[0]], hole.outline[side[1]]);
    let separating = sides.filter(|side| ends.iter().all(|&end| line(side).distance(end) >= -ROUNDING));
    let left = |side: &[usize; 2]| area(&line(side).outside_of(slab));
    separating.max_by(|one, other| left(one).total_cmp(&left(other)))
}
