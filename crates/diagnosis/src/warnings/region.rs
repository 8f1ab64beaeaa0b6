//! Whether the body leaves the region for which meshes of the environment were made convex parts, near such a mesh.

use nalgebra::{Point3, Vector3};
use plan::Plan;
use scene::{MeshPart, MotionRegion};
use task::Pose;

/// A warning with the time at which the body of some scenario first leaves the region.
pub fn warning(plan: &Plan) -> Option<String> {
    let scene = plan.problem.scene();
    let region = scene.region.as_ref()?;
    let is_lost = |point: Point3<f64>| {
        !contains(region, &point) && scene.environment_meshes.iter().any(|mesh| is_near(mesh, &point))
    };
    let leaves = |pose: &Pose| {
        let placed = scene.body.iter().map(|part| part.shape.placed(pose.position().into(), pose.quaternion()));
        placed.flat_map(|shape| shape.vertices().to_vec()).any(|vertex| is_lost(vertex.into()))
    };
    let steps = plan.trajectory.scenarios.iter().enumerate().filter_map(|(scenario, motion)| {
        let step = motion.states.iter().position(|state| leaves(&state.pose()))?;
        Some((step, scenario + 1))
    });
    let (step, scenario) = steps.min()?;
    let pose = plan.trajectory.scenarios[scenario - 1].states[step].pose();
    let numbers = |numbers: &[f64]| numbers.iter().map(|number| format!("{number:.4}")).collect::<Vec<_>>().join(", ");
    Some(format!(
        "in scenario {scenario} the body leaves at {:.2} s the region around the straight motions from start to goal, \
         outside of which meshes of the environment were left out: add a [[start]] there, with position = [{}] and \
         orientation = [{}], or give the mesh as parts of its own",
        step as f64 * plan.trajectory.time_step,
        numbers(&pose[..3]),
        numbers(&pose[3..])
    ))
}

fn contains(region: &MotionRegion, point: &Point3<f64>) -> bool {
    region.places.iter().flatten().any(|place| {
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
