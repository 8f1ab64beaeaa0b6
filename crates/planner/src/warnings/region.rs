//! Whether the body leaves the region for which meshes of the environment were made convex parts, near such a mesh.

use nalgebra::{Isometry3, Point3, Quaternion, UnitQuaternion, Vector3};
use scene::{MeshPart, MotionRegion};

use crate::plan::Plan;

/// A warning with the time at which the body of some scenario first leaves the region.
pub fn warning(plan: &Plan) -> Option<String> {
    let scene = plan.problem.scene();
    let region = scene.region.as_ref()?;
    let corners: Vec<Point3<f64>> =
        scene.body.iter().flat_map(|part| part.shape.vertices()).map(|vertex| Point3::from(*vertex)).collect();
    let leaves = |pose: &[f64; 7]| {
        let placement = isometry(pose);
        let mut points = corners.iter().map(|corner| placement.transform_point(corner));
        points
            .any(|point| !contains(region, &point) && scene.environment_meshes.iter().any(|mesh| is_near(mesh, &point)))
    };
    let steps = plan.trajectory.scenarios.iter().enumerate().filter_map(|(scenario, motion)| {
        let step = motion.states.iter().position(|state| leaves(&std::array::from_fn(|index| state[index])))?;
        Some((step, scenario + 1))
    });
    let (step, scenario) = steps.min()?;
    Some(format!(
        "in scenario {scenario} the body leaves at {:.2} s the region around the straight motions from start to goal, \
         outside of which meshes of the environment were left out: add a [[start]] near there, or give the mesh as parts \
         of its own",
        step as f64 * plan.trajectory.time_step
    ))
}

fn contains(region: &MotionRegion, point: &Point3<f64>) -> bool {
    region.places.iter().any(|place| {
        let sides = place.normals().iter().zip(place.offsets());
        sides.into_iter().all(|(normal, offset)| Vector3::from(*normal).dot(&point.coords) <= *offset)
    })
}

/// Whether a point is in the bounding box of a mesh.
fn is_near(mesh: &MeshPart, point: &Point3<f64>) -> bool {
    let [low, high] = mesh.solid.bounding_box();
    let point = mesh.placement.inverse_transform_point(point);
    (0..3).all(|axis| (low[axis]..=high[axis]).contains(&point[axis]))
}

fn isometry(&[x, y, z, w, i, j, k]: &[f64; 7]) -> Isometry3<f64> {
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k));
    Isometry3::from_parts(Vector3::new(x, y, z).into(), rotation)
}
