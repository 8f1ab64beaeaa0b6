//! The mouth of the hole that a body is in at its goal.

use std::f64::consts::FRAC_PI_2;

use collision::{Polytope, PolytopeError};
use nalgebra::{Rotation3, Unit, Vector3};
use scene::Scene;
use task::Pose;

/// Distance (m), and part of a unit normal, that is rounding.
const ROUNDING: f64 = 1e-6;

/// The mouth of a convex prismatic hole: sides along the insertion that begin at one plane, the rim, and close around the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Mouth {
    /// Direction out of the hole (unit vector, world frame).
    pub(crate) out: Vector3<f64>,
    /// Height of the rim along it (m).
    pub(crate) rim: f64,
    /// Sides of the hole.
    pub(crate) sides: Vec<Side>,
    /// The largest chamfer that leaves half of every side and of the rim beside it (m).
    pub most: f64,
}

/// A side: the halfspace `normal p >= offset` contains the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Side {
    pub(crate) normal: Vector3<f64>,
    pub(crate) offset: f64,
}

/// A face of a part that may be in a side.
struct Face {
    side: Side,
    rim: f64,
    /// Its upper edge: lowest and highest place along [`along`].
    upper: [f64; 2],
    /// Its depth below the rim, and the width of the part's top behind it (m).
    depth: f64,
    width: f64,
}

impl Mouth {
    /// The mouth through which the body leaves its goal in a direction (unit vector, world frame). `None` without a hole
    /// whose sides are along that direction, whose section is convex, and whose upper edge is sharp and in one plane.
    pub fn of(scene: &Scene, out: &Vector3<f64>) -> Option<Self> {
        let goal = Pose::isometry(&scene.goal);
        let vertices = scene.body.iter().flat_map(|part| part.shape.vertices());
        let body: Vec<Vector3<f64>> = vertices.map(|vertex| (goal * nalgebra::Point3::from(*vertex)).coords).collect();
        let surrounds = |face: &Face| {
            let mut inside = body.iter().filter(|vertex| out.dot(vertex) < face.rim - ROUNDING).peekable();
            inside.peek().is_some() && inside.all(|vertex| face.side.normal.dot(vertex) >= face.side.offset - ROUNDING)
        };
        let faces = scene.environment.iter().flat_map(|part| faces(&part.shape, out)).filter(surrounds);
        let mut faces: Vec<Face> = faces.collect();
        faces.sort_by(|one, other| other.rim.total_cmp(&one.rim));
        // Of several holes above each other, the upper one.
        let mut groups = faces.chunk_by(|one, other| (one.rim - other.rim).abs() < ROUNDING);
        groups.find_map(|group| Self::closed(group, out)).filter(|mouth| mouth.is_free(scene))
    }

    /// The mouth of some faces that begin at one height, if they close a convex section.
    fn closed(faces: &[Face], out: &Vector3<f64>) -> Option<Self> {
        let mut sides: Vec<Side> = Vec::new();
        for face in faces {
            if !sides.iter().any(|side| side.is_same(&face.side)) {
                sides.push(face.side);
            }
        }
        let mut closing = Vec::new();
        for side in &sides {
            let Some(edge) = edge(side, &sides, out) else { continue };
            if !edge.iter().all(|end| end.is_finite()) || !is_covered(edge, side, faces) {
                return None;
            }
            closing.push(*side);
        }
        let around = || faces.iter().filter(|face| closing.iter().any(|side| side.is_same(&face.side)));
        let most = around().map(|face| 0.5 * face.depth.min(face.width)).fold(f64::INFINITY, f64::min);
        (closing.len() >= 3).then(|| Self { out: *out, rim: faces[0].rim, sides: closing, most })
    }
}

impl Mouth {
    /// Whether no part of the environment is between the sides below the rim: where one is, the section is not convex.
    fn is_free(&self, scene: &Scene) -> bool {
        let side = |side: &Side| (-side.normal, -side.offset - ROUNDING);
        let slab = [(self.out, self.rim - ROUNDING), (-self.out, self.most - self.rim)];
        let inside: Vec<Halfspace> = self.sides.iter().map(side).chain(slab).collect();
        scene.environment.iter().all(|part| within(&part.shape, &inside).is_err())
    }
}

/// A halfspace `normal p <= offset`.
pub(crate) type Halfspace = (Vector3<f64>, f64);

/// The part of a shape within further halfspaces.
pub(crate) fn within(shape: &Polytope, halfspaces: &[Halfspace]) -> Result<Polytope, PolytopeError> {
    let (further, limits): (Vec<[f64; 3]>, Vec<f64>) =
        halfspaces.iter().map(|(normal, offset)| (<[f64; 3]>::from(*normal), *offset)).unzip();
    Polytope::from_halfspaces(&[shape.normals(), &further].concat(), &[shape.offsets(), &limits].concat())
}

impl Side {
    fn is_same(&self, other: &Self) -> bool {
        (self.normal - other.normal).norm() < ROUNDING && (self.offset - other.offset).abs() < ROUNDING
    }

    /// Direction along the side, across the insertion.
    fn along(&self, out: &Vector3<f64>) -> Vector3<f64> {
        Rotation3::from_axis_angle(&Unit::new_normalize(*out), FRAC_PI_2) * self.normal
    }
}

/// The faces of a shape along a direction that begin at its top, with a sharp edge.
fn faces<'shape>(shape: &'shape Polytope, out: &'shape Vector3<f64>) -> impl Iterator<Item = Face> + 'shape {
    let halfspaces = shape.normals().iter().zip(shape.offsets());
    let vertices: Vec<Vector3<f64>> = shape.vertices().iter().copied().map(Vector3::from).collect();
    let rim = vertices.iter().map(|vertex| out.dot(vertex)).fold(f64::NEG_INFINITY, f64::max);
    let face = move |(normal, &offset): (&[f64; 3], &f64)| {
        let side = Side { normal: Vector3::from(*normal), offset };
        if side.normal.dot(out).abs() > ROUNDING {
            return None;
        }
        let along = side.along(out);
        let is_at = |height: f64, limit: f64| (height - limit).abs() < ROUNDING;
        let on_face: Vec<&Vector3<f64>> =
            vertices.iter().filter(|vertex| is_at(side.normal.dot(vertex), offset)).collect();
        let top: Vec<&Vector3<f64>> = vertices.iter().filter(|vertex| is_at(out.dot(vertex), rim)).collect();
        let edge = on_face.iter().filter(|vertex| is_at(out.dot(vertex), rim)).map(|vertex| along.dot(vertex));
        let upper = edge.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
        let lowest = on_face.iter().map(|vertex| out.dot(vertex)).fold(f64::INFINITY, f64::min);
        let behind = top.iter().map(|vertex| side.normal.dot(vertex)).fold(f64::INFINITY, f64::min);
        // An edge of the top that is not a face has no width behind it.
        let (depth, width) = (rim - lowest, offset - behind);
        (upper[1] - upper[0] > ROUNDING && width > ROUNDING).then_some(Face { side, rim, upper, depth, width })
    };
    halfspaces.filter_map(face)
}

/// The part of a side (its ends along it) that bounds the section between all sides; `None` where others hide it.
fn edge(side: &Side, sides: &[Side], out: &Vector3<f64>) -> Option<[f64; 2]> {
    let along = side.along(out);
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for other in sides.iter().filter(|other| !side.is_same(other)) {
        // On the side's line, normal p >= offset of the other is slope * at >= rest.
        let slope = other.normal.dot(&along);
        let rest = other.offset - side.offset * other.normal.dot(&side.normal);
        if slope > ROUNDING {
            low = low.max(rest / slope);
        } else if slope < -ROUNDING {
            high = high.min(rest / slope);
        } else if rest > 0.0 {
            return None;
        }
    }
    (high - low > ROUNDING).then_some([low, high])
}

/// Whether upper edges of faces cover an edge of the section.
fn is_covered([low, high]: [f64; 2], side: &Side, faces: &[Face]) -> bool {
    let mut uppers: Vec<[f64; 2]> =
        faces.iter().filter(|face| face.side.is_same(side)).map(|face| face.upper).collect();
    uppers.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let reached = uppers.iter().fold(low, |reached, [from, to]| match *from <= reached + ROUNDING {
        true => reached.max(*to),
        false => reached,
    });
    reached >= high - ROUNDING
}
