//! A validated scene.

use std::path::Path;

use task::{AssemblyTask, ContactPair, HomotopySettings, Horizon, Impedance, Inertia, Limits, TrajectoryCost};
use toml::de::DeTable;

use crate::document::SceneDocument;
use crate::error::{SceneError, Source, nearest};
use crate::file::read_text;
use crate::homotopy;
use crate::keys::{MAX_CONTACT_FORCES, MAX_NAME_LENGTH, key};
use crate::limits::{OutOfReach, check_reach, limits};
use crate::part::{Part, parts};
use crate::pose::{directions, pose};
use crate::reader::{Table, is_control};
use crate::sections;
use crate::task_error::TaskError;
use crate::warnings::warnings;

/// A start pose with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct StartPose {
    /// Unique name.
    pub name: String,
    /// Position (m) and unit quaternion (w x y z).
    pub pose: [f64; 7],
}

/// A validated scene.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Title, by default the file's name.
    pub title: String,
    /// Parts of the moved body, in its frame.
    pub body: Vec<Part>,
    /// Parts of the environment, in the world frame.
    pub environment: Vec<Part>,
    /// Pairs that may touch, as indices into body and environment.
    pub pairs: Vec<(usize, usize)>,
    /// Start poses; the first is the default.
    pub starts: Vec<StartPose>,
    /// Goal pose.
    pub goal: [f64; 7],
    /// Mass and inertia of the body.
    pub inertia: Inertia,
    /// The robot's controller.
    pub impedance: Impedance,
    /// `delta-hat` (m).
    pub offset_magnitude: f64,
    /// Directions of the offsets; zero is the nominal scenario.
    pub offset_directions: Vec<[f64; 3]>,
    /// Time grid.
    pub horizon: Horizon,
    /// Weights.
    pub cost: TrajectoryCost,
    /// Limits that every plan must satisfy.
    pub limits: Limits,
    /// The homotopy that the scene names or contains, if any.
    pub homotopy: Option<HomotopySettings>,
    /// Remarks on what looks like a mistake, each with file, line and column.
    pub warnings: Vec<String>,
}

impl Scene {
    /// Reads a scene file and the files it names.
    ///
    /// # Errors
    /// The first error, with its place.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = read_text(path, "scene")?;
        Self::parse(Source { file: path, text: &text })
    }

    /// Reads a scene from text. Names of other files are relative to the source's file.
    ///
    /// # Errors
    /// The first error, with its place.
    pub fn parse(source: Source) -> Result<Self, SceneError> {
        let source = Source { text: source.text.strip_prefix('\u{feff}').unwrap_or(source.text), ..source };
        if source.text.trim().is_empty() {
            return Err(SceneError::about(source.file, "the scene is empty"));
        }
        let entries = DeTable::parse(source.text).map_err(|error| source.parse_error(&error))?;
        let table = Table::top(source, entries.get_ref())?;
        let mut scene = Self::read(source, &table)?;
        scene.warnings = warnings(&table, &scene)?;
        Ok(scene)
    }

    fn read(source: Source, table: &Table) -> Result<Self, SceneError> {
        let body_table = table.require_table("body")?;
        let body = parts(&body_table)?;
        let environment = parts(&table.require_table("environment")?)?;
        let inertia = sections::inertia(&body_table)?;
        let robustness = table.require_table("robustness")?;
        let homotopies: SceneDocument = toml::from_str(source.text).map_err(|error| source.parse_error(&error))?;
        let scene = Self {
            title: match table.find("title") {
                Some(title) => title.name()?,
                None => title_of(source.file),
            },
            pairs: sections::pairs(table, &body, &environment)?,
            starts: sections::starts(table)?,
            goal: pose(&table.require_table("goal")?)?,
            impedance: sections::impedance(&table.require_table("impedance")?, &inertia)?,
            offset_magnitude: robustness.number("offset_magnitude")?,
            offset_directions: directions(&robustness.require("offset_directions")?)?,
            horizon: sections::horizon(&table.require_table("horizon")?)?,
            cost: sections::cost(table)?,
            limits: limits(table.find_table("limits")?.as_ref())?,
            homotopy: homotopy::of_scene(source, homotopies.homotopy.as_ref(), homotopies.ipopt.as_ref())?,
            body,
            environment,
            inertia,
            warnings: Vec::new(),
        };
        scene.check_size(table)?;
        scene.check_limits(table)?;
        Ok(scene)
    }

    /// Refuses a problem that is too large to be solved.
    fn check_size(&self, table: &Table) -> Result<(), SceneError> {
        let (steps, offsets, pairs) = (self.horizon.steps, self.offset_directions.len(), self.pairs.len());
        let forces = steps * offsets * pairs;
        if forces <= MAX_CONTACT_FORCES {
            return Ok(());
        }
        Err(table.require_table("horizon")?.require("steps")?.refuse(format!(
            "{steps} steps x {offsets} offset directions x {pairs} contact pairs make {forces} contact forces, more \
             than {MAX_CONTACT_FORCES}: lower horizon.steps, or list fewer robustness.offset_directions or contact.pairs"
        )))
    }

    /// Refuses limits within which the goal cannot be reached from a start.
    fn check_limits(&self, table: &Table) -> Result<(), SceneError> {
        let Some(limits) = table.find_table("limits")? else { return Ok(()) };
        for start in &self.starts {
            if let Err(error) = self.check_reach(start, self.offset_magnitude) {
                return Err(limits.require(error.key)?.refuse(error.to_string()));
            }
        }
        Ok(())
    }

    /// Whether the limits let the body reach the goal from a start with every offset of a magnitude (m).
    fn check_reach(&self, start: &StartPose, magnitude: f64) -> Result<(), OutOfReach> {
        self.offset_directions.iter().try_for_each(|direction| {
            let pose = task::pose::without_offset(&start.pose, &direction.map(|component| magnitude * component));
            check_reach(&self.limits, (&start.name, &pose), &self.goal, self.horizon)
        })
    }

    /// The offsets of a magnitude, one per direction (m).
    ///
    /// # Errors
    /// When the magnitude is out of range.
    pub fn offsets(&self, magnitude: f64) -> Result<Vec<[f64; 3]>, TaskError> {
        let range = key("robustness", "offset_magnitude").bounds();
        if !range.contains(magnitude) {
            return Err(TaskError::OffsetMagnitude { value: magnitude, most: range.high });
        }
        Ok(self.offset_directions.iter().map(|direction| direction.map(|component| magnitude * component)).collect())
    }

    /// The start of a given name, or the first.
    ///
    /// # Errors
    /// When there is no start of this name. The error lists all names.
    pub fn start(&self, name: Option<&str>) -> Result<&StartPose, TaskError> {
        let Some(name) = name else { return Ok(&self.starts[0]) };
        self.starts.iter().find(|start| start.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.starts.iter().map(|start| start.name.as_str()).collect();
            TaskError::UnknownStart {
                name: name.to_owned(),
                suggestion: nearest(name, &known).map(str::to_owned),
                known: known.into_iter().map(str::to_owned).collect(),
            }
        })
    }

    /// The planning task of a start and an offset magnitude (m), by default the first start and the scene's magnitude.
    ///
    /// # Errors
    /// When the start is unknown, the magnitude is out of range, or the limits are too tight for it.
    pub fn task(&self, start: Option<&str>, offset_magnitude: Option<f64>) -> Result<AssemblyTask, TaskError> {
        let start = self.start(start)?;
        let magnitude = offset_magnitude.unwrap_or(self.offset_magnitude);
        let offsets = self.offsets(magnitude)?;
        self.check_reach(start, magnitude)
            .map_err(|reason| TaskError::OutOfReach { magnitude, reason: Box::new(reason) })?;
        Ok(AssemblyTask {
            inertia: self.inertia.clone(),
            pairs: self.pairs.iter().map(|&(part, other)| self.pair(part, other)).collect(),
            start: start.pose,
            goal: self.goal,
            impedance: self.impedance.clone(),
            offsets,
            horizon: self.horizon,
            cost: self.cost,
            limits: self.limits,
        })
    }

    /// All pairs of a body part and an environment part, including those that the scene leaves out.
    pub fn all_pairs(&self) -> Vec<ContactPair> {
        let others = 0..self.environment.len();
        (0..self.body.len()).flat_map(|part| others.clone().map(move |other| self.pair(part, other))).collect()
    }

    fn pair(&self, part: usize, other: usize) -> ContactPair {
        let (body, environment) = (&self.body[part], &self.environment[other]);
        ContactPair {
            body: body.name.clone(),
            environment: environment.name.clone(),
            shapes: collision::Pair::new(body.shape.clone(), environment.shape.clone()),
        }
    }
}

/// The name of a file without its ending, where it can be a title.
fn title_of(file: &Path) -> String {
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let title: String = stem.chars().filter(|character| !is_control(*character)).take(MAX_NAME_LENGTH).collect();
    if title.trim().is_empty() { "scene".to_owned() } else { title }
}
