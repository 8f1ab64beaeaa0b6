//! Convex pieces of parts, cut open by a plane.

use nalgebra::{Isometry3, Point3, Vector3};

use crate::figures::{others, section};
use crate::model::PartData;

/// A plane across an axis of the world, and which side of it is left.
#[derive(Debug, Clone, Copy)]
pub struct Cut {
    /// The axis: 0, 1 or 2.
    pub axis: usize,
    /// Where the plane cuts it (m).
    pub at: f64,
    /// 1 if what lies beyond is left, -1 if what lies before.
    pub side: f64,
}

impl Cut {
    /// Signed distance (m) of a point, positive in what is left.
    fn inside(&self, point: &Vector3<f64>) -> f64 {
        self.side * (point[self.axis] - self.at)
    }
}

/// A facet of a piece.
#[derive(Debug, Clone)]
pub struct Facet {
    /// Its corners (m), counter-clockwise as seen from outside.
    pub corners: Vec<Vector3<f64>>,
    /// Its unit normal, outwards.
    pub normal: Vector3<f64>,
    /// Whether the cut made it.
    pub is_cut: bool,
}

/// What a cut leaves of a convex part.
#[derive(Debug, Clone, Default)]
pub struct Piece {
    /// Its facets.
    pub facets: Vec<Facet>,
}

impl Piece {
    /// A part at a pose, cut; in world coordinates. None if nothing is left.
    pub fn cut(part: &PartData, pose: &Isometry3<f64>, cut: Cut) -> Option<Self> {
        let corners: Vec<Vector3<f64>> =
            part.vertices.chunks_exact(3).map(|corner| (pose * Point3::from_slice(corner)).coords).collect();
        let whole = part.facets.iter().map(|facet| facet.iter().map(|&corner| corners[corner]).collect());
        let mut facets: Vec<Facet> =
            whole.filter_map(|facet: Vec<_>| Facet::new(clipped(&facet, cut), false)).collect();
        if facets.is_empty() {
            return None;
        }
        let outwards = Vector3::ith(cut.axis, -cut.side);
        let face = section(part, pose, cut.axis, cut.at).into_iter().map(|point| in_plane(point, cut)).collect();
        facets.extend(Facet::new(face, true).map(|facet| facet.turned_to(outwards)));
        Some(Self { facets })
    }

    /// The same piece elsewhere.
    pub fn moved(&self, by: &Isometry3<f64>) -> Self {
        let moved = |facet: &Facet| Facet {
            corners: facet.corners.iter().map(|&corner| (by * Point3::from(corner)).coords).collect(),
            normal: by * facet.normal,
            is_cut: facet.is_cut,
        };
        Self { facets: self.facets.iter().map(moved).collect() }
    }

    /// Corners of all facets.
    pub fn corners(&self) -> impl Iterator<Item = &Vector3<f64>> {
        self.facets.iter().flat_map(|facet| &facet.corners)
    }
}

impl Facet {
    /// A facet of at least three corners that span a plane; none otherwise.
    fn new(corners: Vec<Vector3<f64>>, is_cut: bool) -> Option<Self> {
        // The sum over all edges is exact where the first corners lie in a line.
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let normal = edges.map(|(from, to)| from.cross(to)).sum::<Vector3<f64>>().try_normalize(1e-18)?;
        Some(Self { corners, normal, is_cut })
    }

    /// The same facet, as seen from where a direction points to.
    fn turned_to(mut self, outwards: Vector3<f64>) -> Self {
        if self.normal.dot(&outwards) < 0.0 {
            self.corners.reverse();
            self.normal = -self.normal;
        }
        self
    }
}

/// What a cut leaves of a convex polygon.
fn clipped(polygon: &[Vector3<f64>], cut: Cut) -> Vec<Vector3<f64>> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (before, after) = (cut.inside(from), cut.inside(to));
        if before >= 0.0 {
            left.push(*from);
        }
        if (before >= 0.0) != (after >= 0.0) {
            left.push(from.lerp(to, before / (before - after)));
        }
    }
    left
}

/// A point of the plane from its two other coordinates.
fn in_plane(point: [f64; 2], cut: Cut) -> Vector3<f64> {
    let mut place = Vector3::ith(cut.axis, cut.at);
    for (axis, coordinate) in others(cut.axis).into_iter().zip(point) {
        place[axis] = coordinate;
    }
    place
}

#[cfg(test)]
pub mod tests {
    use simulation::Solid;

    use super::*;

    /// A box with a half extent along each axis.
    pub fn cuboid(extents: [f64; 3]) -> PartData {
        let solid = Solid::new(&collision::Polytope::from_box(extents).unwrap());
        PartData {
            name: "box".to_owned(),
            vertices: solid.vertices.iter().flatten().copied().collect(),
            facets: solid.facets.iter().map(|facet| facet.corners.clone()).collect(),
        }
    }

    /// Volume of a piece, from its facets.
    fn volume(piece: &Piece) -> f64 {
        let fan = |facet: &Facet| {
            let first = facet.corners[0];
            facet.corners[1..].windows(2).map(|two| first.dot(&two[0].cross(&two[1])) / 6.0).sum::<f64>()
        };
        piece.facets.iter().map(fan).sum()
    }

    #[test]
    fn a_cut_leaves_a_closed_piece() {
        let part = cuboid([0.2, 0.4, 0.6]);
        let whole = volume(&Piece::cut(&part, &Isometry3::identity(), Cut { axis: 1, at: -9.0, side: 1.0 }).unwrap());
        for (side, share) in [(1.0, 0.25), (-1.0, 0.75)] {
            // The box ends at half of its size along each axis, or at all of it: the share is that of either.
            let end = part.vertices.iter().skip(1).step_by(3).copied().fold(0.0, f64::max);
            let cut = Cut { axis: 1, at: 0.5 * end, side };
            let piece = Piece::cut(&part, &Isometry3::identity(), cut).unwrap();
            assert!((volume(&piece) / whole - share).abs() < 1e-12, "{side}: {}", volume(&piece) / whole);
            assert!(piece.corners().all(|corner| cut.inside(corner) >= -1e-12));
            let faces: Vec<_> = piece.facets.iter().filter(|facet| facet.is_cut).collect();
            assert_eq!((faces.len(), faces[0].normal), (1, Vector3::new(0.0, -side, 0.0)));
        }
        assert!(Piece::cut(&part, &Isometry3::identity(), Cut { axis: 1, at: 9.0, side: 1.0 }).is_none());
    }
}
