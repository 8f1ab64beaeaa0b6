//! Starter scenes: they can be solved as they are, and adapted.

mod bounding_box;
mod relative;

use std::fmt;
use std::path::{Path, PathBuf};

use relative::relative_path;
use scene::{SCALES, SceneError, UNITS, USUAL_SIZES};

use crate::draft::{Draft, DraftPart, DraftShape};

pub use bounding_box::BoundingBox;

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
    /// Unit of meshes, which need one: one of the words of `part.unit`.
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

impl Default for StarterValues {
    fn default() -> Self {
        Self { offset: None, position_tolerance: None, contact_force: 60.0 }
    }
}

/// Offset magnitude (m) of a common gripper.
const OFFSET: f64 = 1e-3;

/// Extensions of model files.
const MODELS: [&str; 3] = ["sdf", "urdf", "xml"];

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
/// When a file cannot be read.
pub fn starter_scene(
    file: &Path,
    files: Option<(&FilePair, &StarterPoses)>,
    values: &StarterValues,
) -> Result<String, SceneError> {
    match files {
        Some((files, poses)) => file_draft(file, files, poses, values).map(|draft| draft.text()),
        None => Ok(shaft_draft(values).text()),
    }
}

/// Text of a minimal scene with two files, as if written to `file`: for measuring how they fit.
///
/// # Errors
/// When a file cannot be read.
pub fn probe_scene(
    file: &Path,
    files: &FilePair,
    poses: &StarterPoses,
    values: &StarterValues,
) -> Result<String, SceneError> {
    file_draft(file, files, poses, values).map(|draft| draft.shapes_and_poses())
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
        starts: vec![[0.0, 0.0, LENGTH, 1.0, 0.0, 0.0, 0.0]],
        goal: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        position_tolerance: values.position_tolerance,
        offset: values.offset.unwrap_or(OFFSET),
        contact_force: Some(values.contact_force),
    }
}

fn file_draft(
    file: &Path,
    files: &FilePair,
    poses: &StarterPoses,
    values: &StarterValues,
) -> Result<Draft, SceneError> {
    let [body, environment] =
        [("body", &files.body, &files.body_link), ("environment", &files.environment, &files.environment_link)].map(
            |(name, source, link)| -> Result<(DraftPart, BoundingBox), SceneError> {
                let (shape, bounds) = shape(source, link.as_deref(), files.unit.as_deref(), file)?;
                Ok((DraftPart { name: name.to_owned(), shape, position: None }, bounds))
            },
        );
    let ((body_part, body), (environment, _)) = (body?, environment?);
    let place = body.center();
    let moved = |by: &[f64; 3]| [place[0] + by[0], place[1] + by[1], place[2] + by[2], 1.0, 0.0, 0.0, 0.0];
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
        offset: values.offset.unwrap_or(OFFSET),
        contact_force: Some(values.contact_force),
    })
}

impl FilePair {
    /// Bounds of the body and of the environment, in the frame of both files.
    ///
    /// # Errors
    /// When a file cannot be read, a mesh has no unit, or a model has several links and none is named.
    pub fn bounds(&self) -> Result<[BoundingBox; 2], SceneError> {
        let unit = self.unit.as_deref();
        Ok([
            bounds(&self.body, self.body_link.as_deref(), unit)?,
            bounds(&self.environment, self.environment_link.as_deref(), unit)?,
        ])
    }
}

/// Whether a file is that of a model.
fn is_model(source: &Path) -> bool {
    let extension = source.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    extension.is_some_and(|extension| MODELS.contains(&extension.as_str()))
}

/// The bounds of a part that is a file.
fn bounds(source: &Path, link: Option<&str>, unit: Option<&str>) -> Result<BoundingBox, SceneError> {
    if is_model(source) {
        return BoundingBox::of_model(source, link);
    }
    if let Some(link) = link {
        return Err(SceneError::about(
            source,
            format!("a mesh has no links, such as `{link}`: name a model, or no link"),
        ));
    }
    let unit = mesh_unit(source, unit)?;
    let bounds = BoundingBox::of_mesh(source, SCALES[unit])?;
    let size = bounds.edges().into_iter().fold(0.0, f64::max);
    if USUAL_SIZES.contains(&size) {
        return Ok(bounds);
    }
    let message = format!("the mesh is {} m long: is `--unit {}` right?", (1e9 * size).round() / 1e9, UNITS[unit]);
    Err(SceneError::about(source, message))
}

/// Index of the unit of a mesh.
fn mesh_unit(source: &Path, unit: Option<&str>) -> Result<usize, SceneError> {
    let Some(unit) = unit else {
        return Err(SceneError::about(source, format!("a mesh needs its unit (--unit): {}", UNITS.join(", "))));
    };
    UNITS
        .iter()
        .position(|known| *known == unit)
        .ok_or_else(|| SceneError::about(source, format!("unknown unit `{unit}`: choose one of {}", UNITS.join(", "))))
}

/// The shape of a part that is a file, named relative to the scene, and its bounds.
fn shape(
    source: &Path,
    link: Option<&str>,
    unit: Option<&str>,
    scene: &Path,
) -> Result<(DraftShape, BoundingBox), SceneError> {
    let bounds = bounds(source, link, unit)?;
    let file = relative_path(source, scene)?;
    let shape = match is_model(source) {
        true => DraftShape::Model(file, link.map(str::to_owned)),
        false => DraftShape::Mesh(file, UNITS[mesh_unit(source, unit)?]),
    };
    Ok((shape, bounds))
}
