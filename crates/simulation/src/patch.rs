//! The region where a facet faces another part.

use nalgebra::Vector3;

use crate::solid::Solid;

/// Sides shorter than this (m) are corners.
const SHORTEST_SIDE: f64 = 1e-9;

/// The points of a contact with their gaps (m).
#[derive(Debug, Clone, Default)]
pub struct Patch {
    pub points: Vec<(Vector3<f64>, f64)>,
    clipped: Vec<(Vector3<f64>, f64)>,
}

impl Patch {
    /// Leaves no point.
    pub fn clear(&mut self) {
        self.points.clear();
    }

    /// Clips the facing facet of `other`, whose nearest vertex is `vertex`, to the prism over a facet of `solid`. The
    /// points are the corners that remain.
    pub fn fill(&mut self, solid: &Solid, facet: usize, other: &Solid, vertex: usize) {
        let facet = &solid.facets[facet];
        // Until the end the second numbers are heights over the sides of the prism.
        self.points.extend(facing_facet(other, vertex, &facet.normal).map(|corner| (corner, 0.0)));
        for (&from, &to) in facet.corners.iter().zip(facet.corners.iter().cycle().skip(1)) {
            let corner = solid.vertices[from];
            let outward = (solid.vertices[to] - corner).cross(&facet.normal);
            self.clip(|point| outward.dot(&(point - corner)));
        }
        for (point, gap) in &mut self.points {
            *gap = facet.normal.dot(point) - facet.offset;
        }
    }

    /// Upper bound on the distance between the parts (m): every point is one of a part, and its projection one of the
    /// other.
    pub fn distance(&self) -> f64 {
        self.points.iter().map(|(_, gap)| gap.abs()).fold(f64::INFINITY, f64::min)
    }

    /// Whether the region, seen along a normal, is narrower than a width (m). Without sides it is not.
    pub fn is_narrower(&self, width: f64, normal: &Vector3<f64>) -> bool {
        let count = self.points.len();
        let corner = |index: usize| self.points[index % count].0;
        (0..count).any(|side| {
            let from = corner(side);
            let Some(across) = normal.cross(&(corner(side + 1) - from)).try_normalize(SHORTEST_SIDE) else {
                return false;
            };
            // Opposite corners come first, as they are the farthest.
            (0..count).all(|next| across.dot(&(corner(side + count / 2 + next) - from)).abs() < width)
        })
    }

    /// Keeps the region where `height` is not positive (Sutherland and Hodgman).
    fn clip(&mut self, height: impl Fn(&Vector3<f64>) -> f64) {
        let mut highest = f64::NEG_INFINITY;
        for (point, above) in &mut self.points {
            *above = height(point);
            highest = highest.max(*above);
        }
        if highest <= 0.0 {
            return;
        }
        self.clipped.clear();
        for (index, &(from, before)) in self.points.iter().enumerate() {
            let (to, after) = self.points[if index + 1 < self.points.len() { index + 1 } else { 0 }];
            if before <= 0.0 {
                self.clipped.push((from, before));
            }
            if (before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0) {
                self.clipped.push((from + (to - from) * (before / (before - after)), 0.0));
            }
        }
        std::mem::swap(&mut self.points, &mut self.clipped);
    }
}

/// Corners of the facet whose normal is most opposed to `normal`, of the facets that meet in a vertex.
fn facing_facet<'solid>(
    solid: &'solid Solid,
    vertex: usize,
    normal: &Vector3<f64>,
) -> impl Iterator<Item = Vector3<f64>> + 'solid {
    let meeting = solid.meeting[vertex].iter().map(|&facet| &solid.facets[facet]);
    let facing = meeting.min_by(|one, other| one.normal.dot(normal).total_cmp(&other.normal.dot(normal)));
    facing.into_iter().flat_map(|facet| facet.corners.iter().map(|&corner| solid.vertices[corner]))
}
