//! Parts made in code, in millimetres.

// Each test file uses some of them.

use std::f64::consts::TAU;
use std::fmt::Write;

use mesh::{Cover, CoverSettings, Solid, TriangleMesh};

pub type Point = [f64; 3];

/// Vertices and polygons (indices), outward anticlockwise.
#[derive(Debug, Clone, Default)]
pub struct Shape {
    pub vertices: Vec<Point>,
    pub polygons: Vec<Vec<usize>>,
    /// Digits after the point that are lost in its file.
    pub lost: usize,
}

impl Shape {
    pub fn add(&mut self, points: &[Point]) -> Vec<usize> {
        self.vertices.extend_from_slice(points);
        (self.vertices.len() - points.len()..self.vertices.len()).collect()
    }

    /// Triangles between two loops around the z axis that run the same way; outward where the first is below.
    pub fn ring(&mut self, below: &[usize], above: &[usize]) {
        let angle = |vertex: usize| self.vertices[vertex][1].atan2(self.vertices[vertex][0]).rem_euclid(TAU);
        let sorted = |ring: &[usize]| {
            let mut ring = ring.to_vec();
            ring.sort_by(|one, other| {
                (angle(*one) + 1e-9).rem_euclid(TAU).total_cmp(&(angle(*other) + 1e-9).rem_euclid(TAU))
            });
            ring
        };
        let (below, above) = (sorted(below), sorted(above));
        let (mut i, mut j) = (0, 0);
        while i < below.len() || j < above.len() {
            // Each edge is joined to the other loop's vertex that is there at the angle of its middle.
            let turned = |ring: &[usize], at: usize| angle(ring[at % ring.len()]) + TAU * (at / ring.len()) as f64;
            let middle = |ring: &[usize], at: usize| 0.5 * (turned(ring, at) + turned(ring, at + 1));
            let (b, a) = (below[i % below.len()], above[j % above.len()]);
            let is_below = j == above.len() || (i < below.len() && middle(&below, i) <= middle(&above, j) + 1e-9);
            if is_below {
                i += 1;
                self.polygons.push(vec![b, below[i % below.len()], a]);
            } else {
                j += 1;
                self.polygons.push(vec![b, above[j % above.len()], a]);
            }
        }
    }

    pub fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.vertices {
            let digits = 9 - self.lost;
            writeln!(text, "v {x:.digits$} {y:.digits$} {z:.digits$}").unwrap();
        }
        for polygon in &self.polygons {
            let corners: Vec<String> = polygon.iter().map(|corner| (corner + 1).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).unwrap();
        }
        text
    }

    pub fn mesh(&self) -> TriangleMesh {
        let file = tempfile::Builder::new().suffix(".obj").tempfile().unwrap();
        std::fs::write(file.path(), self.obj()).unwrap();
        TriangleMesh::read(file.path(), 1e-3).unwrap()
    }

    pub fn solid(&self) -> Solid {
        Solid::of(&self.mesh()).unwrap()
    }

    pub fn cover(&self, facets: usize) -> Cover {
        Cover::of(&self.solid(), &CoverSettings { facets, ..CoverSettings::default() }).unwrap()
    }

    /// The same turned by a rotation matrix and written with the precision of STL files.
    pub fn turned(&self, rotation: &[[f64; 3]; 3]) -> Self {
        let turn = |point: &Point| -> Point {
            rotation.map(|row| row.iter().zip(point).map(|(one, other)| one * other).sum())
        };
        Self { vertices: self.vertices.iter().map(turn).collect(), polygons: self.polygons.clone(), lost: 4 }
    }

    pub fn moved(&self, by: Point) -> Self {
        let moved = |point: &Point| std::array::from_fn(|axis| point[axis] + by[axis]);
        Self { vertices: self.vertices.iter().map(moved).collect(), ..self.clone() }
    }

    pub fn inverted(&self) -> Self {
        let reverse = |polygon: &Vec<usize>| polygon.iter().rev().copied().collect();
        Self { polygons: self.polygons.iter().map(reverse).collect(), ..self.clone() }
    }

    pub fn and(&self, other: &Self) -> Self {
        let mut both = self.clone();
        let first = both.vertices.len();
        both.vertices.extend(&other.vertices);
        both.polygons
            .extend(other.polygons.iter().map(|polygon| polygon.iter().map(|corner| corner + first).collect()));
        both
    }
}

/// A loop around the z axis.
pub fn circle(radius: f64, z: f64, count: usize, phase: f64) -> Vec<Point> {
    let angle = |index: usize| phase + TAU * index as f64 / count as f64;
    (0..count).map(|index| [radius * angle(index).cos(), radius * angle(index).sin(), z]).collect()
}

pub fn square(half: f64, z: f64) -> Vec<Point> {
    vec![[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]
}

/// The solid between loops around the z axis, from that around its bottom to that around the floor of its hole or its
/// top; a tube when the last loop is joined with the first.
pub fn stack(loops: &[Vec<Point>], is_tube: bool) -> Shape {
    let mut shape = Shape::default();
    let loops: Vec<Vec<usize>> = loops.iter().map(|points| shape.add(points)).collect();
    for pair in loops.windows(2) {
        shape.ring(&pair[0], &pair[1]);
    }
    if is_tube {
        shape.ring(&loops[loops.len() - 1], &loops[0]);
    } else {
        shape.polygons.push(loops[0].iter().rev().copied().collect());
        shape.polygons.push(loops[loops.len() - 1].clone());
    }
    shape
}

/// A polygon in the plane z = 0 swept to a height.
pub fn prism(outline: &[[f64; 2]], height: f64) -> Shape {
    let at = |z: f64| outline.iter().map(|[x, y]| [*x, *y, z]).collect::<Vec<_>>();
    let mut shape = Shape::default();
    let (below, above) = (shape.add(&at(0.0)), shape.add(&at(height)));
    for index in 0..outline.len() {
        let next = (index + 1) % outline.len();
        shape.polygons.push(vec![below[index], below[next], above[next], above[index]]);
    }
    shape.polygons.push(below.iter().rev().copied().collect());
    shape.polygons.push(above);
    shape
}

pub fn cube(edge: f64) -> Shape {
    prism(&[[0.0, 0.0], [edge, 0.0], [edge, edge], [0.0, edge]], edge)
}

/// A block of 30 x 30 x 20 with a blind hole of depth 15.
pub fn block_with_hole(sides: usize, phase: f64) -> Shape {
    let hole = |z| circle(10.0, z, sides, phase);
    stack(&[square(15.0, 0.0), square(15.0, 20.0), hole(20.0), hole(5.0)], false)
}

pub fn countersunk_block(sides: usize) -> Shape {
    let hole = |radius, z| circle(radius, z, sides, 0.0);
    stack(&[square(15.0, 0.0), square(15.0, 20.0), hole(11.0, 20.0), hole(10.0, 19.0), hole(10.0, 5.0)], false)
}

/// Radius 4, length 30, a chamfer of 1 at its tip.
pub fn chamfered_peg(sides: usize) -> Shape {
    let ring = |radius, z| circle(radius, z, sides, 0.0);
    stack(&[ring(3.0, 0.0), ring(4.0, 1.0), ring(4.0, 30.0)], false)
}

pub fn tube(sides: usize) -> Shape {
    let ring = |radius, z| circle(radius, z, sides, 0.0);
    stack(&[ring(10.0, 0.0), ring(10.0, 20.0), ring(6.0, 20.0), ring(6.0, 0.0)], true)
}

pub const L: [[f64; 2]; 6] = [[0.0, 0.0], [20.0, 0.0], [20.0, 5.0], [5.0, 5.0], [5.0, 20.0], [0.0, 20.0]];

pub const CROSS: [[f64; 2]; 12] = [
    [5.0, -15.0],
    [5.0, -5.0],
    [15.0, -5.0],
    [15.0, 5.0],
    [5.0, 5.0],
    [5.0, 15.0],
    [-5.0, 15.0],
    [-5.0, 5.0],
    [-15.0, 5.0],
    [-15.0, -5.0],
    [-5.0, -5.0],
    [-5.0, -15.0],
];

/// A block with an inverted T cut into its top.
pub const T_SLOT: [[f64; 2]; 12] = [
    [0.0, 0.0],
    [30.0, 0.0],
    [30.0, 20.0],
    [19.0, 20.0],
    [19.0, 12.0],
    [24.0, 12.0],
    [24.0, 6.0],
    [6.0, 6.0],
    [6.0, 12.0],
    [11.0, 12.0],
    [11.0, 20.0],
    [0.0, 20.0],
];

/// Rotation by an angle (rad) about (1, 2, 3).
pub fn rotation(angle: f64) -> [[f64; 3]; 3] {
    let length = 14f64.sqrt();
    let [x, y, z] = [1.0 / length, 2.0 / length, 3.0 / length];
    let (sine, cosine) = angle.sin_cos();
    let rest = 1.0 - cosine;
    [
        [cosine + x * x * rest, x * y * rest - z * sine, x * z * rest + y * sine],
        [y * x * rest + z * sine, cosine + y * y * rest, y * z * rest - x * sine],
        [z * x * rest - y * sine, z * y * rest + x * sine, cosine + z * z * rest],
    ]
}
