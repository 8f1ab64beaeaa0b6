//! Cover and mesh compared by means that neither was made with.

use workers::Workers;

use crate::bvh::BoxTree;
use crate::cell::Cell;
use crate::cover::Cover;
use crate::geometry::{Vector, area_vector, bounds, boxes_meet, clip};
use crate::nearest::squared_distance;
use crate::solid::Solid;

/// Points on each surface for the distances.
const SURFACE_POINTS: f64 = 20_000.0;
/// Points in the box for the volumes.
const VOLUME_POINTS: usize = 20_000;

/// Points of a piece of work.
const CHUNK: usize = 1000;

/// Facets of pieces are boundary where no piece is this many tolerances in front of them: thinner gaps are none.
const IN_FRONT: f64 = 4.0;

/// How a cover differs from the mesh it covers, within the crop box and where it covers it. Distances are sampled at the corners and at about
/// 20 000 points of each surface. A clearance counts as a difference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Largest distance from the surface of the mesh to the boundary of the cover (m).
    pub mesh_to_cover: f64,
    /// Largest distance from the boundary of the cover to the surface of the mesh (m).
    pub cover_to_mesh: f64,
    /// Largest distance of a point of the mesh outside of the cover from the cover's boundary (m), about zero.
    pub uncovered: f64,
    /// Volume of the part that is not covered (m^3), about zero.
    pub missing_volume: f64,
    /// Volume of the cover outside of the part (m^3).
    pub outside_volume: f64,
    /// Standard error of the volumes (m^3), or the volume of one sample when that is larger.
    pub volume_error: f64,
}

impl Deviation {
    /// Compares a cover with the solid it was made of.
    pub fn measure(solid: &Solid, cover: &Cover) -> Self {
        let mesh = Triangles::new((0..solid.triangles.len()).map(|triangle| solid.corners(triangle)).collect());
        let boundary = Triangles::new(boundary(cover));
        let is_inside = |point: &Vector| {
            let margin = 2.0 * cover.tolerance;
            (0..3)
                .all(|axis| point[axis] >= cover.box_[0][axis] - margin && point[axis] <= cover.box_[1][axis] + margin)
                && cover.crop_planes.iter().all(|side| side.plane.height(point) < -margin)
        };
        let mut deviation = Self {
            mesh_to_cover: 0.0,
            cover_to_mesh: 0.0,
            uncovered: 0.0,
            missing_volume: 0.0,
            outside_volume: 0.0,
            volume_error: 0.0,
        };
        let workers = Workers::of_all_processors();
        let from_mesh = |points: &[(Vector, Vector)]| {
            let mut most = (0.0_f64, 0.0_f64);
            for (point, normal) in points {
                // Where bodies touch, triangles are no surface.
                if mesh.contains(&(point + normal * (IN_FRONT * cover.tolerance))) {
                    continue;
                }
                let distance = boundary.distance(point);
                let uncovered = if depth(cover, point) < -cover.tolerance { distance } else { 0.0 };
                most = (most.0.max(distance), most.1.max(uncovered));
            }
            most
        };
        let is_compared = |(point, _): &(Vector, Vector)| is_inside(point) && cover.places.contain(point);
        let samples: Vec<(Vector, Vector)> = mesh.samples().filter(is_compared).collect();
        for (distance, uncovered) in workers.map(samples.chunks(CHUNK), from_mesh) {
            deviation.mesh_to_cover = deviation.mesh_to_cover.max(distance);
            deviation.uncovered = deviation.uncovered.max(uncovered);
        }
        // Where not all is covered, pieces end inside of the material.
        let is_boundary = |point: &Vector| cover.places.are_everywhere() || !mesh.contains(point);
        let from_cover = |points: &[(Vector, Vector)]| {
            let points = points.iter().map(|(point, _)| point).filter(|point| is_boundary(point));
            points.map(|point| mesh.distance(point)).fold(0.0, f64::max)
        };
        let samples: Vec<(Vector, Vector)> = boundary.samples().collect();
        let distances = workers.map(samples.chunks(CHUNK), from_cover);
        deviation.cover_to_mesh = distances.into_iter().fold(0.0, f64::max);
        deviation.measure_volumes(&mesh, cover, &workers);
        deviation
    }

    fn measure_volumes(&mut self, mesh: &Triangles, cover: &Cover, workers: &Workers) {
        let extent = cover.box_[1] - cover.box_[0];
        let volume = extent.x * extent.y * extent.z;
        let is_in = |leaf: &Cell, point: &Vector| leaf.bounds.iter().all(|bound| bound.plane.height(point) <= 0.0);
        let is_wanted =
            |point: &Vector| cover.places.are_everywhere() || cover.leaves.iter().any(|leaf| is_in(leaf, point));
        let counts = workers.map((0..VOLUME_POINTS).step_by(CHUNK), |first| {
            let (mut missing, mut outside) = (0, 0);
            for index in first..VOLUME_POINTS.min(first + CHUNK) {
                let point = cover.box_[0] + extent.component_mul(&quasi_random(index));
                let depth = depth(cover, &point);
                if depth.abs() <= cover.tolerance {
                    continue;
                }
                match (mesh.contains(&point), depth > 0.0) {
                    (true, false) if is_wanted(&point) => missing += 1,
                    (false, true) => outside += 1,
                    _ => {}
                }
            }
            [missing, outside]
        });
        let [missing, outside] = [0, 1].map(|which| counts.iter().map(|counts| counts[which]).sum());
        let count = VOLUME_POINTS as f64;
        let share = |points: i32| f64::from(points) / count;
        let error = |points: i32| (share(points) * (1.0 - share(points)) / count).sqrt().max(1.0 / count);
        self.missing_volume = volume * share(missing);
        self.outside_volume = volume * share(outside);
        self.volume_error = volume * error(missing).max(error(outside));
    }
}

/// A sequence that fills the unit cube evenly: multiples of powers of the root of x^4 = x + 1, modulo one.
fn quasi_random(index: usize) -> Vector {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    let step = Vector::new(1.0 / ROOT, 1.0 / (ROOT * ROOT), 1.0 / (ROOT * ROOT * ROOT));
    (step * (index as f64 + 0.5)).map(|value| value.fract())
}

/// How deep a point is in the piece in which it is deepest (m), negative outside.
fn depth(cover: &Cover, point: &Vector) -> f64 {
    let depth = |cell: &Cell| cell.bounds.iter().map(|bound| -bound.plane.height(point)).fold(f64::INFINITY, f64::min);
    cover.cells.iter().map(depth).fold(f64::NEG_INFINITY, f64::max)
}

/// Triangles of the facets of pieces as far as no other piece covers them, without those on the crop box.
fn boundary(cover: &Cover) -> Vec<[Vector; 3]> {
    let tolerance = cover.tolerance;
    let boxes: Vec<[Vector; 2]> = cover.cells.iter().map(Cell::bounding_box).collect();
    let mut triangles = Vec::new();
    for (index, cell) in cover.cells.iter().enumerate() {
        for (bound, polygon) in cell.bounds.iter().zip(&cell.polygons) {
            if cover.crop_planes.iter().any(|side| side.is(bound)) {
                continue;
            }
            let margin = IN_FRONT * tolerance;
            let polygon = cover
                .crop_planes
                .iter()
                .fold(polygon.clone(), |polygon, side| clip(&polygon, &side.plane.moved(-2.0 * margin), 0.0));
            // Just in front of the facet, so that one on the boundary of another piece is inside of that or not.
            let shift = bound.plane.normal * margin;
            let mut open = vec![polygon.iter().map(|corner| corner + shift).collect::<Vec<_>>()];
            for (other, piece) in cover.cells.iter().enumerate() {
                if other != index && boxes_meet(&boxes[index], &boxes[other], margin) {
                    open = open.iter().flat_map(|polygon| outside(polygon, piece, tolerance)).collect();
                }
            }
            for polygon in &open {
                let back = |corner: usize| polygon[corner] - shift;
                triangles.extend((2..polygon.len()).map(|corner| [back(0), back(corner - 1), back(corner)]));
            }
        }
    }
    triangles
}

/// The parts of a polygon outside of a piece that are wider than the tolerance (m).
fn outside(polygon: &[Vector], piece: &Cell, tolerance: f64) -> Vec<Vec<Vector>> {
    let is_visible = |polygon: &Vec<Vector>| crate::cell::is_wide(polygon, 4.0 * tolerance);
    let mut inside = polygon.to_vec();
    let mut parts = Vec::new();
    for bound in &piece.bounds {
        if bound.plane.heights(&inside).0 >= -0.1 * tolerance {
            return vec![polygon.to_vec()];
        }
        parts.push(clip(&inside, &bound.plane.flipped(), 0.1 * tolerance));
        inside = clip(&inside, &bound.plane, 0.1 * tolerance);
    }
    parts.retain(is_visible);
    parts
}

/// Triangles with a tree of their boxes.
struct Triangles {
    triangles: Vec<[Vector; 3]>,
    tree: BoxTree,
}

impl Triangles {
    fn new(triangles: Vec<[Vector; 3]>) -> Self {
        let tree = BoxTree::new(&triangles.iter().map(bounds).collect::<Vec<_>>());
        Self { triangles, tree }
    }

    fn distance(&self, point: &Vector) -> f64 {
        let to = |triangle: usize, most: f64| squared_distance(point, &self.triangles[triangle], most);
        self.tree.nearest(point, f64::INFINITY, to).1.sqrt()
    }

    /// The corners, the middles and evenly spaced points of all triangles, with the normals.
    fn samples(&self) -> impl Iterator<Item = (Vector, Vector)> {
        let area = |triangle: &[Vector; 3]| area_vector(triangle).norm();
        let total: f64 = self.triangles.iter().map(area).sum();
        self.triangles.iter().flat_map(move |triangle| {
            let [a, b, c] = *triangle;
            let parts = (area(triangle) / total * SURFACE_POINTS).sqrt().ceil().clamp(1.0, 200.0) as usize;
            let middle = (a + b + c) / 3.0;
            let grid = (0..=parts).flat_map(move |i| {
                (0..=parts - i).map(move |j| {
                    let share = |count: usize| count as f64 / parts as f64;
                    a + (b - a) * share(i) + (c - a) * share(j)
                })
            });
            let normal = area_vector(triangle).try_normalize(0.0).unwrap_or_default();
            grid.chain([middle]).map(move |point| (point, normal))
        })
    }

    /// Whether a point is inside, as most of three rays see it.
    fn contains(&self, point: &Vector) -> bool {
        const DIRECTIONS: [[f64; 3]; 3] = [[0.83, 0.39, 0.41], [-0.35, 0.87, -0.33], [0.29, -0.31, 0.91]];
        let vote = |direction: [f64; 3]| self.turns(point, &Vector::from(direction)) > 0;
        let [one, other, last] = DIRECTIONS;
        let first = vote(one);
        if first == vote(other) { first } else { vote(last) }
    }

    /// How often a ray leaves the inside more than it enters it.
    fn turns(&self, point: &Vector, direction: &Vector) -> i32 {
        let mut turns = 0;
        let enters = |[low, high]: &[Vector; 2]| {
            let (mut from, mut to) = (0.0_f64, f64::INFINITY);
            for axis in 0..3 {
                let one = (low[axis] - point[axis]) / direction[axis];
                let other = (high[axis] - point[axis]) / direction[axis];
                from = from.max(one.min(other));
                to = to.min(one.max(other));
            }
            from <= to
        };
        self.tree.visit(enters, |triangle| {
            let [a, b, c] = self.triangles[triangle].map(|corner| corner - point);
            let (u, v, w) = (direction.dot(&a.cross(&b)), direction.dot(&b.cross(&c)), direction.dot(&c.cross(&a)));
            let is_ahead = |volume: f64| volume * (u + v + w) > 0.0;
            let is_hit = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
            if is_hit && is_ahead(a.dot(&b.cross(&c))) {
                turns += if u > 0.0 { 1 } else { -1 };
            }
        });
        turns
    }
}
