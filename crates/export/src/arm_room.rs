//! How far the joints of an arm may be from those at the start before a link or the gripper may touch something.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use plan::carried::{CarriedWorld, Frames};
use robot::{JointKind, JointVector};
use scene::{Carrier, Robot, Scene};
use serde::Serialize;

/// The test of the frames by players: length (m) and angle (rad) along and about every axis.
const TEST: [f64; 2] = [0.01, 0.05];
/// Largest clearance that is looked for, and how close (m).
const LARGEST: f64 = 0.3;
const RESOLUTION: f64 = 0.001;

/// The arm at the start of a reference that is raised for a dry run.
///
/// On the path from other joint positions, no point of it moves further than `s / (1 - a)`, where `a` sums the changes of the
/// joints (rad or m) and `s` these times the reach of each.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ArmStart {
    /// By which the reference is raised (m).
    pub height_m: f64,
    /// Joint positions (rad or m).
    pub configuration: Vec<f64>,
    /// Of every joint: the farthest known point of arm, gripper and part from its axis (m); 1 for a prismatic joint.
    pub reach_m: Vec<f64>,
    /// How far links and gripper may move from here (m). `None` where nothing is known of their shapes.
    pub clearance_m: Option<f64>,
    /// Whether they touch nothing in the test of the frames, as far as they are known.
    pub test_is_free: bool,
}

impl ArmStart {
    /// With a margin (m) around links and gripper, of which `carried` has the shapes that are known. `radius` is the farthest
    /// point of the part from the tool (m).
    pub fn new(
        scene: &Scene,
        carried: Option<&CarriedWorld>,
        margin: f64,
        radius: f64,
        height_m: f64,
        at: &JointVector,
    ) -> Option<Self> {
        let robot = scene.robot.as_ref()?;
        let frames = Frames::along(robot, std::slice::from_ref(at));
        let test_is_free = carried.is_none_or(|carried| {
            tested(robot, at).is_some_and(|course| carried.is_free(&Frames::along(robot, &course), margin))
        });
        Some(Self {
            height_m,
            configuration: at.as_slice()[..robot.arm.joints().len()].to_vec(),
            reach_m: reach(scene, robot, at, radius),
            clearance_m: carried.map(|carried| clearance(carried, &frames, margin)),
            test_is_free,
        })
    }
}

/// Farthest points (m) behind every joint from its axis.
fn reach(scene: &Scene, robot: &Robot, at: &JointVector, radius: f64) -> Vec<f64> {
    let (joints, links) = (robot.arm.joints(), robot.arm.link_poses(at));
    let tool = robot.arm.pose(at) * robot.grasp.isometry().inverse();
    let last = joints.len() - 1;
    // Balls: index of the last joint that moves one, its middle and its radius.
    let mut balls = vec![(last, tool.translation.vector, radius)];
    for shape in &scene.carried.shapes {
        let (joint, frame) = match shape.carrier {
            Carrier::Link(link) => (robot.arm.moved_links()[link].joint, &links[link]),
            Carrier::Tip => (last, &tool),
        };
        let points = shape.shape.vertices().iter();
        balls.extend(points.map(|vertex| (joint, (frame * Point3::from(*vertex)).coords, 0.0)));
    }
    let of_joint = |(index, (origin, axis)): (usize, (Vector3<f64>, Vector3<f64>))| match joints[index].kind {
        JointKind::Prismatic => 1.0,
        JointKind::Revolute => {
            let behind = balls.iter().filter(|(joint, ..)| *joint >= index);
            behind.map(|(_, middle, radius)| (middle - origin).cross(&axis).norm() + radius).fold(0.0, f64::max)
        }
    };
    axes(robot, at).into_iter().enumerate().map(of_joint).collect()
}

/// Origins and directions of the axes of all joints in the world.
fn axes(robot: &Robot, at: &JointVector) -> Vec<(Vector3<f64>, Vector3<f64>)> {
    let mut frame = robot.base.isometry();
    let axis = |(joint, position): (&robot::Joint, &f64)| {
        frame *= joint.frame();
        let axis = (frame.translation.vector, frame.rotation * joint.axis());
        let way = joint.axis() * *position;
        frame *= match joint.kind {
            JointKind::Prismatic => Isometry3::from(Translation3::from(way)),
            JointKind::Revolute => Isometry3::rotation(way),
        };
        axis
    };
    robot.arm.joints().iter().zip(at.iter()).map(axis).collect()
}

/// Distance of links and gripper from the environment, less a margin (m): at least minus the margin.
fn clearance(carried: &CarriedWorld, frames: &[Frames], margin: f64) -> f64 {
    let (mut low, mut high) = (0.0, LARGEST + margin);
    while high - low > RESOLUTION {
        let middle = 0.5 * (low + high);
        *(if carried.is_free(frames, middle) { &mut low } else { &mut high }) = middle;
    }
    low - margin
}

/// Joint positions in the middle and at the end of each motion of the test of the frames; `None` where the arm does not reach
/// one.
fn tested(robot: &Robot, at: &JointVector) -> Option<Vec<JointVector>> {
    let (part, grasp) = (robot.arm.pose(at), robot.grasp.isometry());
    let (tool, base) = (part * grasp.inverse(), robot.base.isometry().rotation);
    let moved = |index: usize| {
        let share = if index < 6 { 0.5 } else { 1.0 };
        let along = base * Vector3::ith(index % 3, share);
        let (way, turn) = match index % 6 {
            0..3 => (along * TEST[0], Vector3::zeros()),
            _ => (Vector3::zeros(), along * TEST[1]),
        };
        let rotation = UnitQuaternion::from_scaled_axis(turn) * tool.rotation;
        let pose = Isometry3::from_parts((tool.translation.vector + way).into(), rotation) * grasp;
        robot.arm.inverse_kinematics(&pose, at).ok()
    };
    (0..12).map(moved).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use scene::Source;

    use super::*;

    /// An arm of six joints over a floor whose top is `below` the jaw at the goal (m).
    fn scene(below: f64) -> Scene {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap();
        let robot = std::fs::read_to_string(root.join("examples/arms/six.toml")).unwrap();
        let robot = robot.replace("six.urdf", root.join("examples/arms/six.urdf").to_str().unwrap());
        // The tool points down: the jaw hangs 0.03 m below the tool point.
        let text = format!(
            "[[body.part]]\nname = 'cube'\nbox = [0.01, 0.01, 0.01]\n\
             [[environment.part]]\nname = 'floor'\nbox = [1.0, 1.0, 0.1]\nposition = [0.0, 0.0, {}]\n\
             [[gripper.part]]\nname = 'jaw'\nbox = [0.02, 0.02, 0.06]\n\
             [[start]]\nname = 'a'\nposition = [0.0, 0.0, 0.05]\norientation = [1, 0, 0, 0]\n\
             [goal]\nposition = [0.0, 0.0, 0.0]\norientation = [1, 0, 0, 0]\n\
             [robustness]\noffset_magnitude = 0.001\n{robot}",
            -0.03 - below - 0.05,
        );
        Scene::parse(Source { file: Path::new("scene.toml"), text: &text }).unwrap()
    }

    fn start(scene: &Scene, margin: f64) -> (ArmStart, JointVector) {
        let robot = scene.robot.as_ref().unwrap();
        let near = &robot.configuration;
        let at = robot.arm.inverse_kinematics(&scene.goal.isometry(), near).unwrap();
        (ArmStart::new(scene, CarriedWorld::new(scene).as_ref(), margin, 0.01, 0.0, &at).unwrap(), at)
    }

    #[test]
    fn clearance_is_that_of_the_jaw_and_a_turn_of_the_test_lowers_its_edge() {
        for (below, is_free) in [(0.05, true), (0.0053, false)] {
            let (start, _) = start(&scene(below), 0.005);
            assert!((start.clearance_m.unwrap() - (below - 0.005)).abs() < 0.002, "{start:?}");
            assert_eq!(start.test_is_free, is_free, "{below}");
        }
    }

    #[test]
    fn no_point_moves_further_than_the_changes_of_joints_say() {
        let scene = scene(0.1);
        let robot = scene.robot.as_ref().unwrap();
        let (start, at) = start(&scene, 0.005);
        let jaw = |at: &JointVector| {
            let tool = robot.arm.pose(at) * robot.grasp.isometry().inverse();
            scene.carried.shapes[0]
                .shape
                .vertices()
                .iter()
                .map(|vertex| tool * Point3::from(*vertex))
                .collect::<Vec<_>>()
        };
        let mut largest = 0.0_f64;
        for number in 0..200 {
            let sine = |joint: usize| (1.7 * f64::from(number) + 2.3 * joint as f64 * f64::from(number % 7)).sin();
            let change = JointVector::from_fn(|joint, _| if joint < 6 { 0.05 * sine(joint) } else { 0.0 });
            let moved =
                jaw(&at).iter().zip(jaw(&(at + change))).map(|(one, other)| (one - other).norm()).fold(0.0, f64::max);
            let sum: f64 = change.iter().map(|change| change.abs()).sum();
            let bound = change.iter().zip(&start.reach_m).map(|(change, reach)| change.abs() * reach).sum::<f64>()
                / (1.0 - sum);
            assert!(moved <= bound, "{moved} {bound}");
            largest = largest.max(moved / bound);
        }
        assert!(largest > 0.3, "bounds are {largest} of what they should be");
    }
}
