//! The order in which pieces are painted: what is behind first.

use nalgebra::Vector3;

use super::camera::Camera;
use super::solid::Piece;

/// Facets nearer than this to the line of sight hide nothing.
const GRAZING: f64 = 1e-9;

/// A piece as the camera sees it.
#[derive(Debug)]
pub struct Seen {
    /// The piece in world coordinates (m).
    pub piece: Piece,
    /// Its corners, each once for every facet.
    corners: Vec<Vector3<f64>>,
    /// Left, top, right and bottom (pixels).
    bounds: [f64; 4],
    /// Mean of its corners towards the viewer (m).
    depth: f64,
}

impl Seen {
    /// A piece in world coordinates.
    pub fn new(piece: Piece, camera: &Camera) -> Self {
        let corners: Vec<Vector3<f64>> = piece.corners().copied().collect();
        let [mut left, mut top, mut right, mut bottom] =
            [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        for [x, y] in corners.iter().map(|corner| camera.pixel(corner)) {
            (left, top, right, bottom) = (left.min(x), top.min(y), right.max(x), bottom.max(y));
        }
        let depth = corners.iter().map(|corner| camera.back.dot(corner)).sum::<f64>() / corners.len() as f64;
        Self { piece, corners, bounds: [left, top, right, bottom], depth }
    }

    fn overlaps(&self, other: &Self) -> bool {
        let [left, top, right, bottom] = self.bounds;
        let [others_left, others_top, others_right, others_bottom] = other.bounds;
        left < others_right && others_left < right && top < others_bottom && others_top < bottom
    }

    /// The facet beyond which another piece lies most: how far (m), and the facet's normal.
    fn parting(&self, other: &Self) -> (f64, Vector3<f64>) {
        let beyond = |normal: &Vector3<f64>, on: &Vector3<f64>| {
            other.corners.iter().map(|corner| normal.dot(&(corner - on))).fold(f64::INFINITY, f64::min)
        };
        let facets = self.piece.facets.iter().map(|facet| (beyond(&facet.normal, &facet.corners[0]), facet.normal));
        facets.fold((f64::NEG_INFINITY, Vector3::zeros()), |best, one| if one.0 > best.0 { one } else { best })
    }

    /// Whether this piece is to be painted before another: true or false, none where it does not matter.
    pub fn is_behind(&self, other: &Self, camera: &Camera) -> Option<bool> {
        if !self.overlaps(other) {
            return None;
        }
        let (own, theirs) = (self.parting(other), other.parting(self));
        // What lies beyond a facet that the viewer sees is in front.
        let towards = if own.0 >= theirs.0 { own.1.dot(&camera.back) } else { -theirs.1.dot(&camera.back) };
        (towards.abs() > GRAZING).then_some(towards > 0.0)
    }
}

/// Pairs of pieces, the first of each to be painted before the second.
pub type Pairs = Vec<[usize; 2]>;

/// The pairs among some pieces, given by their indices.
pub fn pairs(seen: &[&Seen], among: impl Iterator<Item = [usize; 2]>, camera: &Camera) -> Pairs {
    let ordered = |[one, other]: [usize; 2]| match seen[one].is_behind(seen[other], camera)? {
        true => Some([one, other]),
        false => Some([other, one]),
    };
    among.filter_map(ordered).collect()
}

/// Indices of pieces in the order of painting. Where pieces hide each other in a circle, the farthest is first.
pub fn painted(seen: &[&Seen], pairs: &[&Pairs]) -> Vec<usize> {
    let mut before = vec![0_usize; seen.len()];
    let mut after = vec![Vec::new(); seen.len()];
    for &[behind, front] in pairs.iter().copied().flatten() {
        before[front] += 1;
        after[behind].push(front);
    }
    let mut left: Vec<usize> = (0..seen.len()).collect();
    left.sort_by(|&one, &other| seen[one].depth.total_cmp(&seen[other].depth));
    let mut order = Vec::with_capacity(seen.len());
    while !left.is_empty() {
        let place = left.iter().position(|&index| before[index] == 0).unwrap_or(0);
        let next = left.remove(place);
        order.push(next);
        for &front in &after[next] {
            before[front] = before[front].saturating_sub(1);
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use nalgebra::{Isometry3, Translation3, UnitQuaternion};

    use super::*;
    use crate::animation::solid::tests::cuboid;
    use crate::animation::solid::{Cut, Facet};

    /// How far towards the viewer (m) a line of sight through a point meets a piece.
    fn met(piece: &Piece, through: Vector3<f64>, back: Vector3<f64>) -> Option<f64> {
        let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
        for Facet { corners, normal, .. } in &piece.facets {
            let (speed, height) = (normal.dot(&back), normal.dot(&(corners[0] - through)));
            if speed.abs() < 1e-12 && height < 0.0 {
                return None;
            } else if speed > 0.0 {
                leaves = leaves.min(height / speed);
            } else if speed < 0.0 {
                enters = enters.max(height / speed);
            }
        }
        (enters < leaves).then_some(leaves)
    }

    #[test]
    fn what_is_painted_last_is_what_the_viewer_sees() {
        let cut = Cut { axis: 1, at: -9.0, side: 1.0 };
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
        };
        // Boxes in the cells of a lattice touch nothing.
        let mut pieces = Vec::new();
        for cell in 0..27 {
            let [x, y, z] = [cell % 3, cell / 3 % 3, cell / 9].map(f64::from);
            let turn = UnitQuaternion::from_euler_angles(random(), random(), random());
            let pose = Isometry3::from_parts(Translation3::new(x, y, z), turn);
            let extents = [0.5 + 0.2 * random(), 0.4, 0.5 + 0.2 * random()];
            pieces.push(Piece::cut(&cuboid(extents), &pose, cut).unwrap());
        }
        let camera = Camera::new(cut, &pieces, &pieces[..1], &[Isometry3::identity()]);
        let seen: Vec<Seen> = pieces.into_iter().map(|piece| Seen::new(piece, &camera)).collect();
        let all: Vec<&Seen> = seen.iter().collect();
        let among = (0..all.len()).flat_map(|one| (0..one).map(move |other| [one, other]));
        let order = painted(&all, &[&pairs(&all, among, &camera)]);
        let mut hits = 0;
        for _ in 0..5000 {
            let through = Vector3::new(1.0 + 3.0 * random(), 1.0 + 3.0 * random(), 1.0 + 3.0 * random());
            let met = |index: usize| met(&all[index].piece, through, camera.back);
            let last = order.iter().rev().copied().find(|&index| met(index).is_some());
            let nearest = (0..all.len())
                .filter(|&index| met(index).is_some())
                .max_by(|&one, &other| met(one).unwrap().total_cmp(&met(other).unwrap()));
            assert_eq!(last, nearest, "through {through}");
            hits += usize::from(last.is_some());
        }
        assert!(hits > 1000, "{hits} lines of sight meet a box");
    }
}
