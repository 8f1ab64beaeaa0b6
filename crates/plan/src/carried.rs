//! Whether the arm and the gripper meet the environment.

use std::fmt;

use collision::Pair;
use nalgebra::{Isometry3, Point3, Vector3};
use robot::JointVector;
use scene::{Carrier, Scene};
use task::Pose;

use crate::clearance::bounds;

/// Penetration (m) that is rounding.
const ROUNDING: f64 = 1e-6;

/// Shapes that an arm carries besides the body, and the environment: convex, with exact distances.
pub struct CarriedWorld<'scene> {
    scene: &'scene Scene,
    pairs: Vec<CarriedPair>,
}

struct CarriedPair {
    /// Indices of the carried shape and of the part of the environment.
    carried: usize,
    part: usize,
    shapes: Pair,
    /// Middle (m) of the carried shape in its frame, and radius (m) around it.
    ball: (Point3<f64>, f64),
    /// Lowest and highest corner (m) of the part.
    bounds: [Vector3<f64>; 2],
}

/// Frames of an arm in the world.
#[derive(Debug, Clone)]
pub struct Frames {
    /// Frames of the moving links, in their order.
    links: Vec<Isometry3<f64>>,
    /// Frame of the tip.
    tip: Isometry3<f64>,
}

impl Frames {
    /// For the arm of a scene at joint positions (rad or m).
    fn of_arm(robot: &scene::Robot, configuration: &JointVector) -> Self {
        let grasp = robot.grasp.isometry();
        Self { links: robot.arm.link_poses(configuration), tip: robot.arm.pose(configuration) * grasp.inverse() }
    }

    /// For the arm of a scene along its joint positions.
    pub fn along(robot: &scene::Robot, configurations: &[JointVector]) -> Vec<Self> {
        configurations.iter().map(|configuration| Self::of_arm(robot, configuration)).collect()
    }

    /// Without an arm: the gripper where the robot believes the body to be.
    pub fn of_body(believed: Isometry3<f64>) -> Self {
        Self { links: Vec::new(), tip: believed }
    }
}

/// A carried shape and a part of the environment that penetrate.
#[derive(Debug, Clone, PartialEq)]
pub struct Meeting {
    /// The carried shape, in words.
    pub carried: String,
    /// Name of the part of the environment.
    pub part: String,
    /// m; infinite where it cannot be computed.
    pub depth: f64,
    /// Index of the frames.
    pub at: usize,
}

impl fmt::Display for Meeting {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { carried, part, depth, .. } = self;
        if depth.is_finite() {
            write!(f, "{carried} penetrates `{part}` by {:.1} mm", 1e3 * depth)
        } else {
            write!(f, "the distance between {carried} and `{part}` cannot be computed")
        }
    }
}

impl<'scene> CarriedWorld<'scene> {
    /// For a scene; `None` where only the body is known to move.
    pub fn new(scene: &'scene Scene) -> Option<Self> {
        let all = scene.carried.shapes.iter().enumerate();
        let pairs: Vec<CarriedPair> = all
            .flat_map(|(carried, shape)| {
                let ball = ball(shape.shape.vertices());
                scene.environment.iter().enumerate().map(move |(part, other)| CarriedPair {
                    carried,
                    part,
                    shapes: Pair::new(shape.shape.clone(), other.shape.clone()),
                    ball,
                    bounds: bounds(other.shape.vertices(), |vertex| vertex),
                })
            })
            .collect();
        (!pairs.is_empty()).then_some(Self { scene, pairs })
    }

    /// The deepest penetration at any of these frames.
    pub fn meeting(&self, course: &[Frames]) -> Option<Meeting> {
        let (distance, pair, at) = self.nearest(course, 0.0)?;
        let names = &self.pairs[pair];
        (distance < -ROUNDING).then(|| Meeting {
            carried: self.scene.carried.shapes[names.carried].to_string(),
            part: self.scene.environment[names.part].name.clone(),
            depth: -distance,
            at,
        })
    }

    /// How to keep the arm and its gripper away from the environment.
    pub fn advice(&self) -> &'static str {
        match self.scene.robot {
            Some(_) => {
                "move robot.base, choose another branch by robot.configuration, or hold the body farther from the gripper"
            }
            None => "hold the body farther from the gripper",
        }
    }

    /// Whether all shapes are farther from each other than a margin (m) at all of these frames. Distances that cannot
    /// be computed count as too small.
    pub fn is_free(&self, course: &[Frames], margin: f64) -> bool {
        self.nearest(course, margin).is_none_or(|(distance, ..)| distance >= margin)
    }

    /// The smallest distance (m) of those that may be below a margin, with the pair and the frames: minus infinity where it
    /// cannot be computed.
    fn nearest(&self, course: &[Frames], margin: f64) -> Option<(f64, usize, usize)> {
        let mut nearest: Option<(f64, usize, usize)> = None;
        for (at, frames) in course.iter().enumerate() {
            for (index, pair) in self.pairs.iter().enumerate() {
                let frame = match self.scene.carried.shapes[pair.carried].carrier {
                    Carrier::Link(link) => &frames.links[link],
                    Carrier::Tip => &frames.tip,
                };
                if pair.is_apart(frame, margin) {
                    continue;
                }
                let distance = pair.shapes.exact_distance(&Pose::from(frame));
                let distance = if distance.is_nan() { f64::NEG_INFINITY } else { distance };
                if nearest.is_none_or(|(least, ..)| distance < least) {
                    nearest = Some((distance, index, at));
                }
            }
        }
        nearest
    }
}

impl CarriedPair {
    /// Whether the ball around the carried shape is farther from the box around the part than a margin (m).
    fn is_apart(&self, frame: &Isometry3<f64>, margin: f64) -> bool {
        let (center, radius) = &self.ball;
        let center = (frame * center).coords;
        let [low, high] = &self.bounds;
        let outside = (low - center).sup(&(center - high)).sup(&Vector3::zeros());
        outside.norm() > radius + margin
    }
}

fn ball(points: &[[f64; 3]]) -> (Point3<f64>, f64) {
    let [low, high] = bounds(points, |point| point);
    let center = Point3::from((low + high) / 2.0);
    (center, points.iter().map(|point| (Point3::from(*point) - center).norm()).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use nalgebra::Translation3;
    use scene::Source;

    use super::*;

    /// A cube of 0.1 m on the floor, with a jaw whose lower side is 0.1 m above its middle.
    const TEXT: &str = "
        [body]
        mass = 1.0
        inertia = [0.1, 0.1, 0.1]
        [[body.part]]
        name = 'cube'
        box = [0.1, 0.1, 0.1]
        [[environment.part]]
        name = 'floor'
        box = [1.0, 1.0, 0.1]
        position = [0.0, 0.0, -0.05]
        [[environment.part]]
        name = 'shelf'
        box = [0.1, 1.0, 0.1]
        position = [0.35, 0.0, 0.2]
        [[gripper.part]]
        name = 'jaw'
        box = [0.4, 0.02, 0.02]
        position = [0.0, 0.0, 0.11]
        [[start]]
        name = 'above'
        position = [0.0, 0.0, 0.2]
        orientation = [1, 0, 0, 0]
        [goal]
        position = [0.0, 0.0, 0.051]
        orientation = [1, 0, 0, 0]
        [robustness]
        offset_magnitude = 0.001
    ";

    fn at(x: f64, z: f64) -> Frames {
        Frames::of_body(Translation3::new(x, 0.0, z).into())
    }

    #[test]
    fn the_deepest_overlap_is_named_with_its_frames() {
        let scene = Scene::parse(Source { file: Path::new("scene.toml"), text: TEXT }).unwrap();
        let world = CarriedWorld::new(&scene).unwrap();
        assert_eq!(world.meeting(&[at(0.0, 0.05), at(0.09, 0.1)]), None);
        let meeting = world.meeting(&[at(0.0, 0.05), at(0.105, 0.06), at(0.11, 0.06), at(0.106, 0.06)]).unwrap();
        assert_eq!(
            (meeting.carried.as_str(), meeting.part.as_str(), meeting.at),
            ("part `jaw` of the gripper", "shelf", 2)
        );
        assert!((meeting.depth - 0.01).abs() < 1e-9, "{meeting:?}");
        assert_eq!(meeting.to_string(), "part `jaw` of the gripper penetrates `shelf` by 10.0 mm");
    }

    #[test]
    fn a_distance_that_cannot_be_computed_is_said_without_a_number() {
        let scene = Scene::parse(Source { file: Path::new("scene.toml"), text: TEXT }).unwrap();
        let meeting = CarriedWorld::new(&scene).unwrap().meeting(&[at(f64::NAN, 0.05)]).unwrap();
        assert_eq!(
            meeting.to_string(),
            "the distance between part `jaw` of the gripper and `floor` cannot be computed"
        );
    }

    #[test]
    fn free_air_begins_at_the_margin() {
        let scene = Scene::parse(Source { file: Path::new("scene.toml"), text: TEXT }).unwrap();
        let world = CarriedWorld::new(&scene).unwrap();
        // The jaw ends 0.2 m from the middle, the shelf begins at 0.3 m.
        for (x, is_free) in [(0.0, true), (0.0799, true), (0.0801, false), (0.2, false)] {
            assert_eq!(world.is_free(&[at(0.0, 0.3), at(x, 0.09)], 0.02), is_free, "{x}");
        }
        assert!(!world.is_free(&[at(f64::NAN, 0.09)], 0.02), "what is no pose is not free");
    }

    #[test]
    fn nothing_is_looked_at_where_nothing_is_known() {
        let text = TEXT.replace("[[gripper.part]]", "[[body.part]]");
        let scene = Scene::parse(Source { file: Path::new("scene.toml"), text: &text }).unwrap();
        assert!(CarriedWorld::new(&scene).is_none());
    }
}
