//! Reading scene files.

use std::path::Path;
use task::algebra::norm;

use crate::carried::{CarriedShapes, gripper};
use crate::chosen;
use crate::error::{SceneError, Source};
use crate::file::read_toml;
use crate::homotopy;
use crate::inertia::inertia;
use crate::keys::{Form, MAX_CONTACT_FORCES, MAX_NAME_LENGTH};
use crate::known_meshes::KnownMeshes;
use crate::limits::{Motion, limits};
use crate::material::Material;
use crate::motion_region::Motions;
use crate::pairs::{Side, pairs};
use crate::part::{GivenPart, given_parts};
use crate::pose::{Endpoints, pose};
use crate::robot::{Interface, Robot, Surroundings, position_robot, stiffness};
use crate::scene::Scene;
use crate::sections;
use crate::shapes::{Shapes, shapes};
use crate::table::{self, Table};
use crate::warnings::warnings;

impl Scene {
    /// Reads a scene file and the files it names.
    ///
    /// # Errors
    /// The first error, with its place.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = read_toml(path, "scene")?;
        Self::parse(Source { file: path, text: &text })
    }

    /// Reads a scene from text. Names of other files are relative to the source's file.
    ///
    /// # Errors
    /// The first error, with its place.
    pub fn parse(source: Source) -> Result<Self, SceneError> {
        Self::parse_knowing(source, &KnownMeshes::default())
    }

    /// As [`parse`](Self::parse), but without reading meshes again that are known.
    ///
    /// # Errors
    /// The first error, with its place.
    pub fn parse_knowing(source: Source, known: &KnownMeshes) -> Result<Self, SceneError> {
        let is_blank = |character: char| character.is_whitespace() || character == '\u{feff}';
        if source.text.chars().all(is_blank) {
            return Err(SceneError::about(source.file, "the scene is empty"));
        }
        table::read(source, Form::scene(), |table| {
            let scene = Self::read(source.file, table, known)?;
            Ok(Self { warnings: warnings(table, &scene)?, chosen: chosen::remarks(table, &scene)?, ..scene })
        })
    }

    fn read(file: &Path, table: &Table, known: &KnownMeshes) -> Result<Self, SceneError> {
        let body_table = table.require_table("body")?;
        let robustness = table.require_table("robustness")?;
        let title = match table.find("title") {
            Some(title) => title.name()?,
            None => title_of(file),
        };
        let environment_parts = || given_parts(&table.require_table("environment")?, known);
        let (body, environment) = workers::both(|| given_parts(&body_table, known), environment_parts);
        let (body, environment) = (body?, environment?);
        let (starts, goal_table) = (sections::starts(table)?, table.require_table("goal")?);
        let goal = pose(&goal_table)?;
        let ends = Endpoints { starts: &starts, goal: &goal };
        sections::require_motions(table, ends)?;
        let offset_magnitude = robustness.number("offset_magnitude")?;
        let coverage = sections::coverage(&robustness, ends)?;
        let offset_directions = sections::offset_directions(&robustness, &coverage)?;
        let rotation_axes = sections::rotation_axes(&robustness, &offset_directions)?;
        let material = Material::of(&body)?;
        let robot = Robot::read(&table.table("robot")?, material.as_ref(), ends)?;
        let gripper = gripper(table)?;
        // A robot that is commanded by position hides its own inertia.
        let is_felt = Interface::read(&table.table("robot")?)? == Interface::Torque;
        let inertia = inertia(table, robot.as_ref().filter(|_| is_felt), material.as_ref(), &body, &goal)?;
        let points: Vec<[f64; 3]> = body.iter().flat_map(GivenPart::points).collect();
        let radius = points.iter().map(|point| norm(point)).fold(0.0, f64::max);
        let spec = sections::robustness_spec(&robustness)?;
        let motions = Motions::new(ends, offset_magnitude, spec.rotation_error, &points);
        let Shapes { body, environment, body_meshes, environment_meshes, fit, region, gaps } =
            shapes(&body, &environment, &motions, &goal)?;
        let (pairs, culled_pairs) = pairs(
            table,
            Side { parent: "body", parts: &body, meshes: &body_meshes },
            Side { parent: "environment", parts: &environment, meshes: &environment_meshes },
            region.as_ref(),
        )?;
        let about = Surroundings { inertia: &inertia, offset_magnitude, radius };
        let position_robot = position_robot(table, &about)?;
        let impedance = match &position_robot {
            Some(robot) => robot.gains.impedance(),
            None => {
                let stiffness = stiffness(table, &inertia, offset_magnitude, robot.as_ref())?;
                sections::impedance(table, &inertia, stiffness)?
            }
        };
        let horizon = sections::horizon(table, ends, &inertia, &impedance, position_robot.as_ref(), offset_magnitude)?;
        let motion = Motion {
            starts: &starts,
            goal: &goal,
            horizon,
            inertia: &inertia,
            radius,
            robot: robot.as_ref(),
            position_robot: position_robot.as_ref(),
        };
        let limits = limits(&table.table("limits")?, &motion)?;
        let scene = Self {
            title,
            horizon,
            impedance,
            position_tolerance: goal_table.find("position_tolerance").map(|entry| entry.number()).transpose()?,
            angle_tolerance: goal_table.number("angle_tolerance")?,
            cost: sections::cost(table)?,
            limits,
            homotopy: homotopy::of_scene(table)?,
            body,
            environment,
            body_meshes,
            environment_meshes,
            fit,
            region,
            gaps,
            pairs,
            culled_pairs,
            frictions: sections::frictions(table)?,
            starts,
            goal,
            offset_magnitude,
            coverage,
            offset_directions,
            rotation_axes,
            inertia,
            robustness: spec,
            carried: CarriedShapes::new(robot.as_ref(), &gripper),
            gripper,
            robot,
            position_robot,
            chosen: Vec::new(),
            warnings: Vec::new(),
        };
        scene.check_size(table)?;
        scene.check_limits(table)?;
        Ok(scene)
    }

    /// Refuses a problem that is too large to be solved.
    fn check_size(&self, table: &Table) -> Result<(), SceneError> {
        let (steps, offsets, pairs) =
            (self.horizon.steps, self.grasps_of(self.offset_magnitude).len(), self.pairs.len());
        let frictions = self.frictions.len();
        let forces = steps * offsets * pairs * frictions;
        if forces <= MAX_CONTACT_FORCES {
            return Ok(());
        }
        let place = match table.table("horizon")?.find("steps") {
            Some(steps) => steps,
            None => table.require_table("robustness")?.require("offset_magnitude")?,
        };
        let (several, or_friction) = if frictions > 1 {
            (format!(" x {frictions} coefficients of friction"), ", contact.friction")
        } else {
            Default::default()
        };
        Err(place.refuse(format!(
            "{steps} steps x {offsets} planned offsets x {pairs} contact pairs{several} make {forces} contact forces, more than \
             {MAX_CONTACT_FORCES}: lower horizon.steps, or list fewer robustness.offset_directions{or_friction} or contact.pairs"
        )))
    }

    /// Refuses limits within which the goal cannot be reached from a start.
    fn check_limits(&self, table: &Table) -> Result<(), SceneError> {
        let limits = table.table("limits")?;
        for start in &self.starts {
            if let Err(error) = self.check_reach(start, self.offset_magnitude) {
                return Err(match limits.find(error.key) {
                    Some(limit) => limit.refuse(error.to_string()),
                    None => table.table("horizon")?.refuse(format!("{error}; the limit is that of the robot")),
                });
            }
        }
        Ok(())
    }
}

/// The name of a file without its ending, where it can be a title.
fn title_of(file: &Path) -> String {
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let title: String = stem.chars().filter(|character| !input::is_control(*character)).take(MAX_NAME_LENGTH).collect();
    if title.trim().is_empty() { "scene".to_owned() } else { title }
}
