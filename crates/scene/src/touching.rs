//! Meshes covered where the other side passes them, and gaps between both sides by other means.

use collision::{Pair, Polytope};
use mesh::{Budget, Gauge, Passage, hull_triangles};
use nalgebra::{Isometry3, Point3};

use crate::boxes::{around, boxes_meet, in_frame};
use crate::facets::LARGEST_SHARE;
use crate::motion_region::{Extent, Motions};
use crate::part::{GivenPart, Shape};

/// What pieces may take of the local gap, and no more than this where something can touch (m).
const SHARE: f64 = 0.05;
const MOST: f64 = 5e-5;
/// Smaller errors are not worth a piece (m).
const LEAST: f64 = 2e-6;
/// Distances between places (sizes of the body), of which the first is taken with which pieces keep the gap.
pub const SPACINGS: [f64; 3] = [8e-3, 4e-3, 2e-3];
/// Poses at which gaps are compared, along the path.
const COMPARED: [usize; 4] = [0, 1, 3, 6];

/// Triangles (m) in the frame of their parent.
type Triangles = Vec<[[f64; 3]; 3]>;

/// The distance of both sides at a pose of the straight path between start and goal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Distance from the goal (m).
    pub from_goal: f64,
    /// Between the meshes and shapes as they are given (m), zero where they meet.
    pub given: f64,
    /// Between the convex parts (m), negative where they penetrate.
    pub parts: f64,
}

impl Gap {
    /// How far both distances are apart (m).
    pub fn error(&self) -> f64 {
        (self.given - self.parts).abs()
    }

    /// The share of the gap that convex parts keep; one where shapes meet.
    pub fn kept(&self) -> f64 {
        if self.given > 0.0 { self.parts / self.given } else { 1.0 }
    }

    /// Whether convex parts take no more of the gap than facets may, besides what flat sides of the meshes of round surfaces
    /// are away from these (m).
    pub fn agrees(&self, chord_errors: f64) -> bool {
        let taken = self.given - self.parts;
        let most = (LARGEST_SHARE * self.given).max(2.0 * LEAST) + chord_errors;
        // Where the shapes meet, nobody knows how deep.
        self.given == 0.0 || taken <= most && -taken <= most.max(MOST)
    }
}

/// Both sides as they are given, the body in its frame.
pub struct Sides<'given> {
    body: Triangles,
    environment: Triangles,
    motions: &'given Motions,
    /// Poses of the body at which gaps are compared, and what they are between the sides as given (m).
    compared: Vec<(Isometry3<f64>, f64)>,
}

impl<'given> Sides<'given> {
    pub fn new(body: &[GivenPart], environment: &[GivenPart], motions: &'given Motions) -> Self {
        let (body, environment) = (triangles(body), triangles(environment));
        let gauges = [&body, &environment].map(|triangles| Gauge::new(triangles));
        let path: Vec<Isometry3<f64>> = motions.first_path().collect();
        let poses = COMPARED.into_iter().map(|back| path[path.len() - 1 - back]);
        let compared = poses.map(|pose| (pose, apart(&gauges, &pose))).collect();
        Self { body, environment, motions, compared }
    }

    fn budget(&self, spacing: f64) -> Budget {
        Budget {
            share: SHARE,
            most: MOST,
            least: LEAST,
            reach: self.motions.reach(),
            spacing: spacing * self.motions.size(),
        }
    }

    /// Calls `cover` with what passes a part of the body, or of the environment, in the part's own frame, at places this far
    /// apart (sizes of the body).
    pub fn passing<T>(
        &self,
        is_body: bool,
        placement: &Isometry3<f64>,
        spacing: f64,
        cover: impl FnOnce(&[Passage], Budget) -> T,
    ) -> T {
        let poses = self.motions.path();
        let poses: Vec<Isometry3<f64>> =
            poses.map(|pose| placement.inverse() * if is_body { pose.inverse() } else { pose }).collect();
        let triangles = if is_body { &self.environment } else { &self.body };
        cover(&[Passage { triangles, poses: &poses }], self.budget(spacing))
    }

    /// Gaps at the goal and on the path from it to the first start.
    pub fn gaps(&self, body: &[Polytope], environment: &[Polytope]) -> Vec<Gap> {
        let gauges = [body, environment].map(|parts| {
            Gauge::new(&parts.iter().flat_map(|part| hull_triangles(part.vertices())).collect::<Triangles>())
        });
        let boxes =
            [body, environment].map(|parts| parts.iter().map(|part| around(part.vertices())).collect::<Vec<Extent>>());
        let pairs: Vec<(Pair, [&Extent; 2])> = body
            .iter()
            .zip(&boxes[0])
            .flat_map(|(part, own)| {
                let others = environment.iter().zip(&boxes[1]);
                others.map(move |(other, its)| (Pair::new(part.clone(), other.clone()), [own, its]))
            })
            .collect();
        let goal = self.compared[0].0;
        let gap = |(pose, given): &(Isometry3<f64>, f64)| {
            // Only parts whose boxes meet can penetrate; what cannot be computed counts as penetration.
            let near = pairs.iter().filter(|(_, [own, other])| boxes_meet(&in_frame(own, &pose.inverse()), other));
            let rotation = pose.rotation.quaternion();
            let [x, y, z] = pose.translation.vector.into();
            let coordinates = [x, y, z, rotation.w, rotation.i, rotation.j, rotation.k];
            let distances = near.map(|(pair, _)| pair.exact_distance(&coordinates));
            let least = distances.map(|distance| if distance.is_nan() { f64::NEG_INFINITY } else { distance });
            let least = least.fold(f64::INFINITY, f64::min);
            Gap {
                from_goal: (pose.translation.vector - goal.translation.vector).norm(),
                given: *given,
                // Between edges and corners, distances of the problem are those of halfspaces, which are smaller.
                parts: if least > 0.0 { apart(&gauges, pose) } else { least },
            }
        };
        self.compared.iter().map(gap).collect()
    }
}

/// Distance (m) of body and environment with the body in a pose.
fn apart([body, environment]: &[Gauge; 2], pose: &Isometry3<f64>) -> f64 {
    environment.gap(body, pose)
}

fn triangles(given_parts: &[GivenPart]) -> Triangles {
    let of_part = |given: &GivenPart| {
        let placement = given.placement();
        let own: Triangles = match &given.shape {
            Shape::Convex(shape) => hull_triangles(shape.vertices()),
            Shape::Mesh(mesh) => mesh.solid.corner_triangles().collect(),
        };
        let placed =
            move |corner: [f64; 3]| -> [f64; 3] { placement.transform_point(&Point3::from(corner)).coords.into() };
        own.into_iter().map(move |triangle| triangle.map(placed)).collect::<Triangles>()
    };
    given_parts.iter().flat_map(of_part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_agree_within_a_quarter() {
        let gap = |given: f64, parts: f64| Gap { from_goal: 0.0, given, parts }.agrees(0.0);
        assert!(gap(1e-4, 8e-5) && gap(1e-4, 1.2e-4) && gap(0.0, -1e-3));
        assert!(Gap { from_goal: 0.0, given: 6e-5, parts: 9.5e-5 }.agrees(3.5e-5));
        assert!(!gap(1e-4, 7e-5) && !gap(1e-4, -1e-5) && !gap(1e-3, 1.5e-3));
    }
}
