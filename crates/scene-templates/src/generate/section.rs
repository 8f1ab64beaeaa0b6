//! Cross-sections of pegs and holes.

use std::f64::consts::PI;

/// A point of a section (m).
pub type Point = [f64; 2];

/// Distance (m) that counts as rounding.
const ROUNDING: f64 = 1e-12;

/// A polygon and its partition into convex pieces.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Corners (m), counterclockwise.
    pub outline: Vec<Point>,
    /// Indices of corners, counterclockwise, one list per convex piece.
    pub pieces: Vec<Vec<usize>>,
}

impl Section {
    /// A section of one convex piece.
    pub fn convex(outline: Vec<Point>) -> Self {
        let pieces = vec![(0..outline.len()).collect()];
        Self { outline, pieces }
    }

    /// A regular polygon around a circle, with one side across the positive x axis.
    pub fn round(diameter: f64, facets: usize) -> Self {
        let turn = 2.0 * PI / facets as f64;
        let radius = 0.5 * diameter / (0.5 * turn).cos();
        let corner = |index: usize| (index as f64 + 0.5) * turn;
        Self::convex((0..facets).map(|index| [radius * corner(index).cos(), radius * corner(index).sin()]).collect())
    }

    /// A rectangle with edges along x and y.
    pub fn rectangle(width: f64, depth: f64) -> Self {
        let (x, y) = (0.5 * width, 0.5 * depth);
        Self::convex(vec![[x, y], [-x, y], [-x, -y], [x, -y]])
    }

    /// The section with a rectangular key across the positive x axis, `height` beyond its side. The key is the second
    /// piece, its three sides are edges [`Self::key_edges`]. The section must be convex and symmetric about the x axis;
    /// beside the key, sides are longer than `shoulder`, if need be by extending the next one. None where the key is too
    /// wide for that.
    pub fn with_key(&self, width: f64, height: f64, shoulder: f64) -> Option<Self> {
        let half = 0.5 * width;
        let count = self.outline.len();
        let is_beside =
            |index: &usize| self.outline[*index][0] < 0.0 || self.outline[*index][1].abs() > half + shoulder;
        let angle = |index: &usize| self.outline[*index][1].atan2(self.outline[*index][0]).rem_euclid(2.0 * PI);
        let mut beside: Vec<usize> = (0..count).filter(is_beside).collect();
        beside.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
        let side = self.edge((beside.first()? + count - 1) % count);
        let [root, _] = side.intersection(&Line::through([0.0, half], [-1.0, half]))?;
        let tip = self.outline.iter().map(|[x, _]| *x).fold(root, f64::max) + height;
        let from = beside.len();
        let mut outline: Vec<Point> = beside.into_iter().map(|index| self.outline[index]).collect();
        outline.extend([[root, -half], [tip, -half], [tip, half], [root, half]]);
        let core = (0..=from).chain([from + 3]).collect();
        Some(Self { outline, pieces: vec![core, (from..from + 4).collect()] })
    }

    /// The edges of a key's sides in a section with a key.
    pub fn key_edges(&self) -> std::ops::Range<usize> {
        self.outline.len() - 4..self.outline.len() - 1
    }

    fn corner_after(&self, index: usize) -> Point {
        self.outline[(index + 1) % self.outline.len()]
    }

    /// The line of the edge after a corner.
    pub fn edge(&self, index: usize) -> Line {
        Line::through(self.outline[index], self.corner_after(index))
    }

    /// Corners of a piece, but for those in the middle of a straight side.
    pub fn piece(&self, piece: &[usize]) -> Vec<Point> {
        let at = |place: usize| self.outline[piece[place % piece.len()]];
        let is_corner = |place: &usize| {
            let side = Line::through(at(place + piece.len() - 1), at(place + 1));
            side.distance(at(*place)).abs() > ROUNDING
        };
        (0..piece.len()).filter(is_corner).map(at).collect()
    }

    /// The section whose edges are moved outwards by a distance (m), inwards by a negative one; none where edges would
    /// vanish or pieces would not be convex any more.
    pub fn offset(&self, distance: f64) -> Option<Self> {
        let count = self.outline.len();
        let moved = |index: usize| self.edge(index % count).moved(distance);
        let outline: Option<Vec<Point>> =
            (0..count).map(|index| moved(index + count - 1).intersection(&moved(index))).collect();
        let section = Self { outline: outline?, pieces: self.pieces.clone() };
        let keeps_direction = |index: usize| dot(section.edge(index).direction(), self.edge(index).direction()) > 0.0;
        let is_right = (0..count).all(keeps_direction) && section.pieces.iter().all(|piece| section.is_convex(piece));
        is_right.then_some(section)
    }

    fn is_convex(&self, piece: &[usize]) -> bool {
        let corners: Vec<Point> = piece.iter().map(|&index| self.outline[index]).collect();
        let count = corners.len();
        (0..count).all(|index| {
            let line = Line::through(corners[index], corners[(index + 1) % count]);
            corners.iter().all(|corner| line.distance(*corner) <= ROUNDING)
        })
    }

    /// Diameter of the circle about the origin that holds the section (m).
    pub fn diameter(&self) -> f64 {
        2.0 * self.outline.iter().map(|&corner| length(corner)).fold(0.0, f64::max)
    }
}

/// A line with a left and a right side; the inside of a counterclockwise polygon is to the left of its edges.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Unit normal to the right: outwards.
    normal: Point,
    offset: f64,
}

impl Line {
    /// From one point to another.
    pub fn through(from: Point, to: Point) -> Self {
        let [x, y] = subtract(to, from);
        let length = length([x, y]);
        let normal = [y / length, -x / length];
        Self { normal, offset: dot(normal, from) }
    }

    /// Unit vector along the line.
    pub fn direction(&self) -> Point {
        [-self.normal[1], self.normal[0]]
    }

    /// Unit vector to the outside.
    pub fn outwards(&self) -> Point {
        self.normal
    }

    /// Signed distance of a point, positive outside.
    pub fn distance(&self, point: Point) -> f64 {
        dot(self.normal, point) - self.offset
    }

    fn moved(&self, distance: f64) -> Self {
        Self { offset: self.offset + distance, ..*self }
    }

    /// The common point of two lines that are not parallel.
    fn intersection(&self, other: &Self) -> Option<Point> {
        let ([a, b], [c, d]) = (self.normal, other.normal);
        let determinant = a * d - b * c;
        let point =
            [(self.offset * d - b * other.offset) / determinant, (a * other.offset - self.offset * c) / determinant];
        point.iter().all(|coordinate| coordinate.is_finite()).then_some(point)
    }

    /// The part of a convex polygon outside the line.
    pub fn outside_of(&self, polygon: &[Point]) -> Vec<Point> {
        let mut outside = Vec::new();
        for (index, &corner) in polygon.iter().enumerate() {
            let next = polygon[(index + 1) % polygon.len()];
            let (here, there) = (self.distance(corner), self.distance(next));
            if here >= -ROUNDING {
                outside.push(corner);
            }
            if here.min(there) < -ROUNDING && here.max(there) > ROUNDING {
                let part = here / (here - there);
                outside.push([corner[0] + part * (next[0] - corner[0]), corner[1] + part * (next[1] - corner[1])]);
            }
        }
        outside
    }
}

/// Area of a counterclockwise polygon (m^2).
pub fn area(polygon: &[Point]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    0.5 * polygon.iter().zip(next).map(|([x1, y1], [x2, y2])| x1 * y2 - x2 * y1).sum::<f64>()
}

/// The vector from one point to another.
pub fn subtract(to: Point, from: Point) -> Point {
    [to[0] - from[0], to[1] - from[1]]
}

/// Scalar product.
pub fn dot(one: Point, other: Point) -> f64 {
    one[0] * other[0] + one[1] * other[1]
}

/// Length of a vector.
pub fn length(vector: Point) -> f64 {
    vector[0].hypot(vector[1])
}
