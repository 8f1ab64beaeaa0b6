//! The region that the motion of the body can reach; parts beyond cannot be touched.

use std::cmp::Ordering;

use collision::{Pair, Polytope};
use mesh::hull_triangles;
use nalgebra::{Isometry3, Point3};
use task::algebra::norm;
use task::pose::interpolate;
use workers::Workers;

use crate::boxes::{around, boxes_meet, corners_of};
use crate::pose::{Endpoints, StartPose};

/// Poses between a start and the goal that are looked at.
const SAMPLES: usize = 9;
/// Poses of the path along which both sides are compared.
const PATH_SAMPLES: usize = 17;
/// Turn (rad) of the body away from these poses, further than in the gripper.
const ROTATION: f64 = 0.1;
/// Offsets by which the body may move away from these poses.
const OFFSETS: f64 = 1.0;
/// Further distance, in sizes of the body.
const MARGIN: f64 = 0.02;

/// Margin around the region, in sizes of the body.
const SURROUNDINGS: f64 = 0.5;

/// A box (m, world frame): lower and upper corner.
pub type Extent = [[f64; 3]; 2];

/// The region that a body can reach.
#[derive(Debug, Clone)]
pub struct MotionRegion {
    /// A box around all of it and as much as half the body on every side: walls there must not be thin.
    pub extent: Extent,
    /// For each part of the body, convex places (world frame) that together cover all it reaches.
    pub places: Vec<Vec<Polytope>>,
}

/// Straight motions from all starts to the goal, and how far the body may leave them.
pub struct Motions {
    poses: Vec<Isometry3<f64>>,
    /// The same paths in smaller steps.
    path: Vec<Isometry3<f64>>,
    size: f64,
    margin: f64,
    rotation_error: f64,
    surroundings: f64,
}

impl Motions {
    /// For a body with points at these coordinates (m), with offsets of a magnitude (m) and a rotation error (rad).
    pub fn new(ends: Endpoints, offset_magnitude: f64, rotation_error: f64, body: &[[f64; 3]]) -> Self {
        let goal = ends.goal.isometry();
        let paths = |samples: usize| -> Vec<Isometry3<f64>> {
            let path = |start: &StartPose| {
                let start = start.pose.isometry();
                (0..samples).map(move |sample| interpolate(&start, &goal, sample as f64 / (samples - 1) as f64))
            };
            ends.starts.iter().flat_map(path).collect()
        };
        let size = body.iter().map(|point| norm(point)).fold(0.0, f64::max);
        Self {
            poses: paths(SAMPLES),
            path: paths(PATH_SAMPLES),
            size,
            margin: OFFSETS * offset_magnitude + MARGIN * size,
            rotation_error: ROTATION + rotation_error,
            surroundings: SURROUNDINGS * size,
        }
    }

    /// Poses on the straight path from each start to the goal, one path after the other.
    pub fn path(&self) -> impl Iterator<Item = Isometry3<f64>> {
        self.path.iter().copied()
    }

    /// Those from the first start.
    pub fn first_path(&self) -> impl Iterator<Item = Isometry3<f64>> {
        self.path.iter().take(PATH_SAMPLES).copied()
    }

    /// Largest distance of a point of the body from its origin (m).
    pub fn size(&self) -> f64 {
        self.size
    }

    /// How far a point of the body may get away from the straight paths (m): offsets and rotation errors of the grasp.
    pub fn reach(&self) -> f64 {
        self.margin + (self.rotation_error - ROTATION) * self.size
    }

    /// The region of a body whose parts are the convex hulls of some points (m, body frame).
    pub fn region(&self, parts: &[Vec<[f64; 3]>]) -> MotionRegion {
        let mut extent = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for [low, high] in self.poses.iter().flat_map(|pose| parts.iter().flat_map(|part| self.reaches(pose, part))) {
            for axis in 0..3 {
                extent[0][axis] = extent[0][axis].min(low[axis]);
                extent[1][axis] = extent[1][axis].max(high[axis]);
            }
        }
        let [low, high] = &mut extent;
        low.iter_mut().for_each(|coordinate| *coordinate -= self.surroundings);
        high.iter_mut().for_each(|coordinate| *coordinate += self.surroundings);
        let workers = Workers::of_all_processors();
        MotionRegion { extent, places: workers.map(parts.iter(), |part| self.swept(part)) }
    }

    /// The places that the convex hull of points reaches: for each pair of neighbouring poses their convex hull.
    fn swept(&self, points: &[[f64; 3]]) -> Vec<Polytope> {
        let at = |pose: &Isometry3<f64>| -> Vec<[f64; 3]> {
            self.reaches(pose, points).flat_map(|place| corners_of(&place)).collect()
        };
        let of_start = |poses: &[Isometry3<f64>]| -> Vec<Polytope> {
            let hull = |pair: &[Isometry3<f64>]| {
                // Most corners of boxes are inside.
                let corners = hull_triangles(&[at(&pair[0]), at(&pair[1])].concat());
                Polytope::from_vertices(&distinct(corners.into_flattened())).ok()
            };
            poses.windows(2).filter_map(hull).collect()
        };
        self.poses.chunks(SAMPLES).flat_map(of_start).collect()
    }

    /// Boxes in which points of the body are near a pose.
    fn reaches<'a>(&'a self, pose: &'a Isometry3<f64>, points: &'a [[f64; 3]]) -> impl Iterator<Item = Extent> + 'a {
        points.iter().map(move |point| {
            let reach = self.margin + self.rotation_error * norm(point);
            let place = pose.transform_point(&Point3::from(*point));
            [-1.0, 1.0].map(|sign| std::array::from_fn(|axis| place[axis] + sign * reach))
        })
    }
}

/// Points without copies.
fn distinct(mut points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    points.sort_by(|one, other| one.partial_cmp(other).unwrap_or(Ordering::Equal));
    points.dedup();
    points
}

/// Whether two parts, both in the world frame, have a point in common.
pub fn meet(one: &Polytope, other: &Polytope) -> bool {
    if !boxes_meet(&around(one.vertices()), &around(other.vertices())) {
        return false;
    }
    let pair = Pair::new(one.clone(), other.clone());
    pair.exact_distance(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]) <= 0.0
}

#[cfg(test)]
mod tests {
    use task::Pose;

    use super::*;

    #[test]
    fn a_region_grows_with_offsets_and_turns_in_the_gripper() {
        let (goal, tip) = (Pose::IDENTITY, [0.0, 0.0, -0.2]);
        let start = StartPose { name: "1".to_owned(), pose: goal };
        let ends = Endpoints { starts: std::slice::from_ref(&start), goal: &goal };
        let reach = |offset_magnitude: f64, rotation_error: f64| {
            let motions = Motions::new(ends, offset_magnitude, rotation_error, &[tip]);
            motions.region(&[vec![tip]]).extent[1][0]
        };
        let exact = reach(0.0, 0.0);
        assert!((exact - (MARGIN + ROTATION + SURROUNDINGS) * 0.2).abs() < 1e-12, "{exact}");
        assert!((reach(0.01, 0.0) - exact - 0.01).abs() < 1e-12);
        assert!((reach(0.0, 0.05) - exact - 0.05 * 0.2).abs() < 1e-12);
    }
}
