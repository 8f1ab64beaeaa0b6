//! Shapes that move with the arm besides the body: collision shapes of its links, and parts of the gripper. They are
//! not part of the optimal control problem; users of a plan are warned where they meet the environment.

use std::fmt;

use collision::Polytope;
use link::{LinkShape, Model};
use nalgebra::{Isometry3, Point3};

use crate::error::SceneError;
use crate::file::read_text;
use crate::known_meshes::KnownMeshes;
use crate::model::triangles;
use crate::part::{GivenPart, Part, Shape, given_parts};
use crate::robot::Robot;
use crate::table::Table;

/// A convex shape that moves with the arm.
#[derive(Debug, Clone)]
pub struct Carried {
    /// Name of its link, or of the part of the gripper.
    pub name: String,
    /// The link or tool that it is fixed to.
    pub carrier: Carrier,
    /// In the frame of its carrier: the convex hull of a shape that is not convex.
    pub shape: Polytope,
}

/// The link or tool that a shape is fixed to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Carrier {
    /// A link of the arm, by its index among those that move.
    Link(usize),
    /// The tip of the arm. Without an arm, that is the body as the robot believes it to be held.
    Tip,
}

/// All that an arm carries besides the body.
#[derive(Debug, Clone, Default)]
pub struct CarriedShapes {
    /// Shapes of links and of the gripper.
    pub shapes: Vec<Carried>,
    /// Links whose shapes cannot be read, and why: they are not checked against the environment.
    pub unread: Vec<String>,
}

impl fmt::Display for Carried {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.carrier {
            Carrier::Link(_) => write!(formatter, "link `{}` of the arm", self.name),
            Carrier::Tip => write!(formatter, "part `{}` of the gripper", self.name),
        }
    }
}

/// Parts of the gripper in the frame of the tip, as convex hulls.
pub fn gripper(scene: &Table) -> Result<Vec<Part>, SceneError> {
    if scene.find("gripper").is_none() {
        return Ok(Vec::new());
    }
    let table = scene.table("gripper")?;
    let hull = |given: &GivenPart| {
        let points: Vec<[f64; 3]> = match &given.shape {
            Shape::Convex(shape) => shape.vertices().to_vec(),
            Shape::Mesh(mesh) => mesh.solid.points().collect(),
        };
        let shape = hull_of(points.into_iter(), &given.placement());
        let name = given.name.clone();
        Ok(Part { shape: shape.map_err(|error| table.refuse(format!("part `{name}`: {error}")))?, name })
    };
    given_parts(&table, &KnownMeshes::default())?.iter().map(hull).collect()
}

impl CarriedShapes {
    /// From an arm and the parts of its gripper.
    pub fn new(robot: Option<&Robot>, gripper: &[Part]) -> Self {
        let mut all = robot.map_or(Self::default(), Self::of_arm);
        all.shapes.extend(gripper.iter().map(|part| Carried {
            name: part.name.clone(),
            carrier: Carrier::Tip,
            shape: part.shape.clone(),
        }));
        all
    }

    /// The collision shapes of an arm's links, as far as its file has some.
    fn of_arm(robot: &Robot) -> Self {
        let mut all = Self::default();
        match links(robot) {
            Ok(links) => {
                for (index, name, shapes) in links {
                    match shapes {
                        Ok(shapes) => all.shapes.extend(shapes.into_iter().map(|shape| Carried {
                            name: name.clone(),
                            carrier: Carrier::Link(index),
                            shape,
                        })),
                        Err(reason) => all.unread.push(format!("link `{name}`: {reason}")),
                    }
                }
            }
            Err(reason) => all.unread.push(reason),
        }
        all
    }
}

/// A link that moves, by index and name, and its shapes or why they cannot be read.
type LinkShapes = (usize, String, Result<Vec<Polytope>, String>);

fn links(robot: &Robot) -> Result<Vec<LinkShapes>, String> {
    let text = read_text(&robot.urdf, "model").map_err(|error| error.to_string())?;
    let model = Model::parse(&robot.urdf, &text).map_err(|error| error.to_string())?;
    let with_shapes = model.links().map_err(|error| error.to_string())?;
    let moved = robot.arm.moved_links().iter().enumerate();
    let shapes = moved.filter_map(|(index, moved)| {
        let link = with_shapes.iter().find(|link| link.name == moved.name)?;
        let shapes = link.shapes().map_err(|error| error.to_string());
        let hulls = shapes.and_then(|shapes| shapes.iter().map(hull).collect());
        Some((index, moved.name.clone(), hulls))
    });
    Ok(shapes.collect())
}

/// The convex hull of a collision shape in the frame of its link.
fn hull(shape: &LinkShape) -> Result<Polytope, String> {
    hull_of(triangles(shape)?.corners(), &shape.pose)
}

fn hull_of(points: impl Iterator<Item = [f64; 3]>, placement: &Isometry3<f64>) -> Result<Polytope, String> {
    let points: Vec<[f64; 3]> = points.map(|point| (placement * Point3::from(point)).into()).collect();
    Polytope::from_vertices(&points).map_err(|error| error.to_string())
}
