//! The region where a facet faces another part.

use nalgebra::Vector3;

use crate::solid::{Facet, Solid};

/// Sides shorter than this (m) are corners.
const SHORTEST_SIDE: f64 = 1e-9;

/// The points of a contact with their gaps (m).
#[derive(Debug, Clone, Default)]
pub struct Patch {
    pub points: Vec<(Vector3<f64>, f64)>,
    clipped: Vec<(Vector3<f64>, f64)>,
}

/// The sides of a facet that may cut the facet that faces it, while neither moves far.
#[derive(Debug, Clone, Default)]
pub struct Sides {
    /// The facet and the facing one.
    facets: Option<[usize; 2]>,
    /// Positions of the sides' first corners among those of the facet.
    cutting: Vec<usize>,
}

impl Sides {
    /// Leaves no facet.
    pub fn clear(&mut self) {
        self.facets = None;
    }

    /// The sides of a facet of `solid` that cut the facing facet of `other` or are nearer to it than `margin` (m).
    fn find(&mut self, solid: &Solid, facet: usize, other: &Solid, facing: usize, margin: f64) {
        self.facets = Some([facet, facing]);
        self.cutting.clear();
        for side in 0..solid.facets[facet].corners.len() {
            let (corner, outward) = solid.side(facet, side);
            let height = |&point: &usize| outward.dot(&(other.vertices[point] - corner));
            let highest = other.facets[facing].corners.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            if highest > -margin * outward.norm() {
                self.cutting.push(side);
            }
        }
    }
}

impl Patch {
    /// Leaves no point.
    pub fn clear(&mut self) {
        self.points.clear();
    }

    /// Clips the facing facet of `other`, whose nearest vertex is `vertex`, to the prism over a facet of `solid`. The
    /// points are the corners that remain. `sides` are those of this pair of solids, and are found again for other facets:
    /// for all poses between which no point of one solid moves by more than `margin` (m) seen from the other.
    pub fn fill(&mut self, solid: &Solid, facet: usize, other: &Solid, vertex: usize, sides: &mut Sides, margin: f64) {
        let Facet { normal, offset, .. } = &solid.facets[facet];
        let Some(facing) = other.facing_facet(vertex, normal) else { return };
        if sides.facets != Some([facet, facing]) {
            sides.find(solid, facet, other, facing, margin);
        }
        // Until the end the second numbers are heights over the sides of the prism.
        self.points.extend(other.facets[facing].corners.iter().map(|&corner| (other.vertices[corner], 0.0)));
        for &side in &sides.cutting {
            let (corner, outward) = solid.side(facet, side);
            self.clip(|point| outward.dot(&(point - corner)));
        }
        for (point, gap) in &mut self.points {
            *gap = normal.dot(point) - offset;
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
        let mut is_cut = false;
        for (point, above) in &mut self.points {
            *above = height(point);
            is_cut |= *above > 0.0;
        }
        if !is_cut {
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
