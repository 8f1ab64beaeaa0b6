//! Starter scenes: they can be solved as they are, and adapted.

mod bounding_box;
mod file_part;
mod relative;

use std::fmt;
use std::path::{Path, PathBuf};

use scene::SceneError;
use task::Pose;

use crate::draft::{Draft, DraftPart, DraftShape};

pub use bounding_box::BoundingBox;
pub use file_part::{FilePart, PartPair};

/// Two meshes or links in one frame, in the assembled pose. Links are those of SDF, URDF and MJCF files.
#[derive(Debug, Clone, Default)]
pub struct FilePair {
    /// File of the body.
    pub body: PathBuf,
    /// Name of its link, where that is a model with several.
    pub body_link: Option<String>,
    /// File of the environment.
    pub environment: PathBuf,
    /// Name of the environment's link, where the file has several.
    pub environment_link: Option<String>,
    /// Unit of the mesh files, required for STL and OBJ: one of the words of `part.unit`.
    pub unit: Option<String>,
}

/// Start and end of the body of two files: distances from its place in the file (m).
#[derive(Debug, Clone, PartialEq)]
pub struct StarterPoses {
    /// One start or more; the first is the default.
    pub starts: Vec<[f64; 3]>,
    /// The goal.
    pub goal: [f64; 3],
}

/// Values of a starter scene besides shapes and poses.
#[derive(Debug, Clone, PartialEq)]
pub struct StarterValues {
    /// Offset magnitude (m); by default that of the example, or of an ordinary gripper.
    pub offset: Option<f64>,
    /// Position tolerance (m); by default chosen when the scene is read.
    pub position_tolerance: Option<f64>,
    /// Largest contact force (N).
    pub contact_force: f64,
}

impl StarterValues {
    /// Offset magnitude (m) of a scene with parts of files.
    pub fn offset_magnitude(&self) -> f64 {
        self.offset.unwrap_or(OFFSET)
    }
}

impl Default for StarterValues {
    fn default() -> Self {
        Self { offset: None, position_tolerance: None, contact_force: 60.0 }
    }
}

/// Offset magnitude (m) of a common gripper.
const OFFSET: f64 = 1e-3;

/// Names of the axes.
const NAMES: [&str; 3] = ["x", "y", "z"];

/// A direction along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axis {
    /// 0, 1, 2 for x, y, z.
    pub index: usize,
    /// Whether it is the opposite direction.
    pub is_negative: bool,
}

impl Axis {
    /// All six.
    pub const ALL: [Self; 6] = [
        Self { index: 2, is_negative: false },
        Self { index: 2, is_negative: true },
        Self { index: 0, is_negative: false },
        Self { index: 0, is_negative: true },
        Self { index: 1, is_negative: false },
        Self { index: 1, is_negative: true },
    ];

    /// From a name such as `z`, `+z`, `Z` or `-x`.
    pub fn from_name(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        let letter = name.strip_prefix(['-', '+']).unwrap_or(&name);
        let index = NAMES.iter().position(|known| *known == letter)?;
        Some(Self { index, is_negative: name.starts_with('-') })
    }

    /// The opposite direction.
    pub fn opposite(self) -> Self {
        Self { is_negative: !self.is_negative, ..self }
    }

    /// A vector of some length in this direction.
    pub fn times(self, length: f64) -> [f64; 3] {
        let mut vector = [0.0; 3];
        vector[self.index] = if self.is_negative { -length } else { length };
        vector
    }
}

impl fmt::Display for Axis {
    /// Its name with its sign.
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}{}", if self.is_negative { '-' } else { '+' }, NAMES[self.index])
    }
}

/// Text of a scene that is written to `file`: with two files, or with a square shaft and its hole.
///
/// # Errors
/// When the path of a part's file cannot be told relative to the scene.
pub fn starter_scene(
    file: &Path,
    parts: Option<(&PartPair, &StarterPoses)>,
    values: &StarterValues,
) -> Result<String, SceneError> {
    match parts {
        Some((parts, poses)) => file_draft(file, parts, poses, values).map(|draft| draft.text()),
        None => Ok(shaft_draft(values).text()),
    }
}

/// A square shaft goes into a square hole.
fn shaft_draft(values: &StarterValues) -> Draft {
    const OFFSET: f64 = 0.005;
    const WIDTH: f64 = 0.02;
    const LENGTH: f64 = 0.06;
    const CLEARANCE: f64 = 0.0005;
    const WALL: f64 = 0.02;
    const DEPTH: f64 = 0.04;
    let inside = WIDTH + 2.0 * CLEARANCE;
    let middle = 0.5 * (inside + WALL);
    let long = [inside + 2.0 * WALL, WALL, DEPTH];
    let wall = |name: &str, edges: [f64; 3], [x, y]: [f64; 2]| DraftPart {
        name: name.to_owned(),
        shape: DraftShape::Box(edges),
        position: Some([x, y, -0.5 * DEPTH]),
    };
    let lines = [
        "A square shaft goes into a square hole, half a millimetre wider on every side. Solve it, then adapt it:",
        "  1. body and environment: the shapes of your parts",
        "  2. goal: where the body ends; start: where it comes from, without touching anything",
        "  3. impedance: the stiffness of your robot's controller",
        "  4. robustness: how inaccurate the grasp is",
    ];
    Draft {
        about: lines.map(str::to_owned).to_vec(),
        body: vec![DraftPart { name: "shaft".into(), shape: DraftShape::Box([WIDTH, WIDTH, LENGTH]), position: None }],
        environment: vec![
            wall("left", [WALL, inside, DEPTH], [-middle, 0.0]),
            wall("right", [WALL, inside, DEPTH], [middle, 0.0]),
            wall("front", long, [0.0, -middle]),
            wall("back", long, [0.0, middle]),
        ],
        starts: vec![Pose([0.0, 0.0, LENGTH, 1.0, 0.0, 0.0, 0.0])],
        goal: Pose([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
        position_tolerance: values.position_tolerance,
        offset: values.offset.unwrap_or(OFFSET),
        contact_force: Some(values.contact_force),
    }
}

fn file_draft(
    file: &Path,
    parts: &PartPair,
    poses: &StarterPoses,
    values: &StarterValues,
) -> Result<Draft, SceneError> {
    let draft = |name: &str, part: &FilePart| -> Result<DraftPart, SceneError> {
        Ok(DraftPart { name: name.to_owned(), shape: part.shape(file)?, position: None })
    };
    let (body_part, environment) = (draft("body", &parts.body)?, draft("environment", &parts.environment)?);
    let place = parts.body.bounds().center();
    let moved = |by: &[f64; 3]| Pose([place[0] + by[0], place[1] + by[1], place[2] + by[2], 1.0, 0.0, 0.0, 0.0]);
    let lines = [
        "The body goes to where its file has it in the frame of both files. Check what was found and chosen:",
        "  1. goal: the pose of the body's centre when it is assembled, lifted a little so that it touches nothing",
        "  2. start: straight out from the goal, where nothing is near; on its path in, the body must touch nothing but what",
        "     guides it",
        "  3. impedance: the stiffness of your robot's controller",
        "  4. robustness: how inaccurate the grasp is, across the direction in which the body is put in",
    ];
    Ok(Draft {
        about: lines.map(str::to_owned).to_vec(),
        // The frame of the body has its origin at the centre of mass, which is near the middle.
        body: vec![DraftPart { position: Some(place.map(|coordinate| -coordinate)), ..body_part }],
        environment: vec![environment],
        starts: poses.starts.iter().map(moved).collect(),
        goal: moved(&poses.goal),
        position_tolerance: values.position_tolerance,
        offset: values.offset_magnitude(),
        contact_force: Some(values.contact_force),
    })
}

impl FilePair {
    /// Reads both files.
    ///
    /// # Errors
    /// When a file cannot be read, a mesh has no unit or an unusual size, or a model has several links and none is named.
    pub fn read(&self) -> Result<PartPair, SceneError> {
        let read = |file: &Path, link: &Option<String>| FilePart::read(file, link.as_deref(), self.unit.as_deref());
        let (body, environment) =
            workers::both(|| read(&self.body, &self.body_link), || read(&self.environment, &self.environment_link));
        Ok(PartPair { body: body?, environment: environment? })
    }
}
