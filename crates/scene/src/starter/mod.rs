//! Scenes to begin with: they are solved as they are, and changed into one's own.

mod bounding_box;
mod relative;

use std::path::{Path, PathBuf};

use crate::draft::{Draft, DraftPart, DraftShape, rounded};
use crate::error::SceneError;
use crate::keys::{SCALES, UNITS};
use crate::warnings::USUAL_SIZES;
use bounding_box::BoundingBox;
use relative::relative_path;

/// Two meshes or links in one frame, in the pose that the body shall reach. Links are those of SDF, URDF and MJCF files.
#[derive(Debug, Clone)]
pub struct FilePair {
    /// File of the body.
    pub body: PathBuf,
    /// File of the environment.
    pub environment: PathBuf,
    /// Unit of meshes, which need one: one of the words of `part.unit`.
    pub unit: Option<String>,
    /// Direction in which the body is taken out.
    pub axis: Axis,
}

/// Extensions of model files.
const MODELS: [&str; 3] = ["sdf", "urdf", "xml"];

/// A direction along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Axis {
    /// 0, 1, 2 for x, y, z.
    pub index: usize,
    /// Whether it is the opposite direction.
    pub is_negative: bool,
}

impl Axis {
    /// Of a name such as `z` or `-x`.
    pub fn from_name(name: &str) -> Option<Self> {
        let (is_negative, letter) = name.strip_prefix('-').map_or((false, name), |letter| (true, letter));
        let index = ["x", "y", "z"].iter().position(|known| *known == letter)?;
        Some(Self { index, is_negative })
    }
}

/// Text of a scene that is written to `file`: with two files, or with a square shaft and its hole.
///
/// # Errors
/// When a file cannot be read.
pub fn starter_scene(file: &Path, files: Option<&FilePair>) -> Result<String, SceneError> {
    match files {
        Some(files) => file_draft(file, files).map(|draft| draft.text()),
        None => Ok(shaft_draft().text()),
    }
}

/// A square shaft goes into a square hole.
fn shaft_draft() -> Draft {
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
        "A square shaft goes into a square hole, half a millimetre wider on every side. Solve it, then make it yours:",
        "  1. body and environment: the shapes of your parts",
        "  2. goal: where the body shall end; start: where it comes from, without touching anything",
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
        starts: vec![[0.0, 0.0, LENGTH, 1.0, 0.0, 0.0, 0.0]],
        goal: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        offset: 0.005,
    }
}

fn file_draft(file: &Path, files: &FilePair) -> Result<Draft, SceneError> {
    /// Offset magnitude, as a fraction of the body's shortest edge, and the largest one (m).
    const OFFSET: f64 = 0.1;
    const LARGEST_OFFSET: f64 = 0.02;
    /// Height (m) of the goal above the place of the mesh, where parts touch; at most this fraction of the body's height.
    const LIFT: f64 = 2e-4;
    const LARGEST_LIFT: f64 = 0.01;
    let part = |name: &str, source: &Path| -> Result<(DraftPart, BoundingBox), SceneError> {
        let (shape, bounds) = shape(source, files.unit.as_deref(), file)?;
        Ok((DraftPart { name: name.to_owned(), shape, position: None }, bounds))
    };
    let ((body_part, body), (environment, _)) = (part("body", &files.body)?, part("environment", &files.environment)?);
    let [x, y, z] = body.center();
    let height = body.edges()[files.axis.index];
    let above = |distance: f64| {
        let mut pose = [x, y, z, 1.0, 0.0, 0.0, 0.0];
        pose[files.axis.index] += if files.axis.is_negative { -distance } else { distance };
        pose
    };
    let shortest = body.edges().into_iter().fold(f64::INFINITY, f64::min);
    let lines = [
        "The body goes to where its file has it in the frame of both files. Check what was guessed of them:",
        "  1. goal: the pose of the body's centre when it is assembled, lifted a little so that it touches nothing",
        "  2. start: above the goal by the body's height; the body must touch nothing there, and on its way to the goal",
        "     nothing but what guides it",
        "  3. impedance: the stiffness of your robot's controller",
        "  4. robustness: how inaccurate the grasp is, across the direction in which the body is put in",
    ];
    Ok(Draft {
        about: lines.map(str::to_owned).to_vec(),
        // The frame of the body has its origin at the centre of mass, which is near the middle.
        body: vec![DraftPart { position: Some([-x, -y, -z]), ..body_part }],
        environment: vec![environment],
        starts: vec![above(height)],
        goal: above(LIFT.min(LARGEST_LIFT * height)),
        offset: rounded(OFFSET * shortest).min(LARGEST_OFFSET),
    })
}

/// The shape of a part that is a file, named relative to the scene, and its bounds.
fn shape(source: &Path, unit: Option<&str>, scene: &Path) -> Result<(DraftShape, BoundingBox), SceneError> {
    let extension = source.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    if extension.is_some_and(|extension| MODELS.contains(&extension.as_str())) {
        let bounds = BoundingBox::of_model(source)?;
        return Ok((DraftShape::Model(relative_path(source, scene)?), bounds));
    }
    let Some(unit) = unit else {
        return Err(SceneError::about(source, format!("a mesh needs its unit (--unit): {}", UNITS.join(", "))));
    };
    let Some(unit) = UNITS.iter().position(|known| *known == unit) else {
        return Err(SceneError::about(scene, format!("unknown unit `{unit}`: choose one of {}", UNITS.join(", "))));
    };
    let bounds = BoundingBox::of_mesh(source, SCALES[unit])?;
    let size = bounds.edges().into_iter().fold(0.0, f64::max);
    if !USUAL_SIZES.contains(&size) {
        let message = format!("the mesh is {} m long: is `--unit {}` right?", (1e9 * size).round() / 1e9, UNITS[unit]);
        return Err(SceneError::about(source, message));
    }
    Ok((DraftShape::Mesh(relative_path(source, scene)?, UNITS[unit]), bounds))
}
