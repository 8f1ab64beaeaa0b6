//! A validated scene.

use std::path::Path;

use nalgebra::Matrix3;
use task::{
    AssemblyTask, ContactPair, CostWeights, HomotopySettings, Horizon, Impedance, Inertia, Limits, TrajectoryCost,
};
use toml::Spanned;

use crate::document::{
    ContactDocument, CostDocument, HorizonDocument, ImpedanceDocument, InertiaDocument, PoseDocument,
    RobustnessDocument, SceneDocument, StartDocument, WeightsDocument,
};
use crate::error::{SceneError, Source, suggest};
use crate::homotopy;
use crate::limits::{check_reach, limits};
use crate::part::{Part, parts, size_warnings};
use crate::pose::{direction, not_negative, orientation, position, positive, within};

/// Mass of a body that gives none (kg), and its rotational inertia (kg m^2): apparent values under impedance control.
const DEFAULT_MASS: f64 = 1.0;
const DEFAULT_INERTIA: f64 = 0.1;

/// A start pose with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct StartPose {
    /// Unique name.
    pub name: String,
    /// Position (m) and unit quaternion (w x y z).
    pub pose: [f64; 7],
}

/// Everything that a scene file says, checked.
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
    /// What no plan may exceed.
    pub limits: Limits,
    /// Homotopy of the scene's own, from its file entry or its tables.
    pub homotopy: Option<HomotopySettings>,
    /// Remarks that do not stop anything.
    pub warnings: Vec<String>,
}

impl Scene {
    /// Reads a scene file and the files it names.
    ///
    /// # Errors
    /// The first thing that is wrong, with its place.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = std::fs::read_to_string(path)
            .map_err(|error| SceneError::about(path, format!("the scene cannot be read: {error}")))?;
        Self::parse(Source { file: path, text: &text })
    }

    /// Reads a scene from text; other files are looked for beside the source's file.
    ///
    /// # Errors
    /// The first thing that is wrong, with its place.
    pub fn parse(source: Source) -> Result<Self, SceneError> {
        let document: SceneDocument = toml::from_str(source.text).map_err(|error| source.parse_error(&error))?;
        let body = parts(source, &document.body.get_ref().part)?;
        let environment = parts(source, &document.environment.get_ref().part)?;
        for (parts, parent, span) in
            [(&body, "body", document.body.span()), (&environment, "environment", document.environment.span())]
        {
            if parts.is_empty() {
                return Err(source.error(span, format!("[{parent}] has no part: add a [[{parent}.part]]")));
            }
        }
        let mut warnings = size_warnings(source.file, &body);
        warnings.extend(size_warnings(source.file, &environment));
        let inertia = inertia(source, &document)?;
        let (offset_magnitude, offset_directions) = offsets(source, &document.robustness)?;
        let title = source.file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let scene = Self {
            title: document.title.clone().unwrap_or(title),
            pairs: pairs(source, document.contact.as_ref(), &body, &environment)?,
            starts: starts(source, &document.start)?,
            goal: goal(source, &document.goal)?,
            impedance: impedance(source, &document.impedance, &inertia)?,
            horizon: horizon(source, &document.horizon)?,
            cost: cost(source, &document.cost)?,
            limits: limits(source, &document.limits)?,
            homotopy: homotopy::of_scene(source, document.homotopy.as_ref(), document.ipopt.as_ref())?,
            body,
            environment,
            inertia,
            offset_magnitude,
            offset_directions,
            warnings,
        };
        for start in &scene.starts {
            for direction in &scene.offset_directions {
                let offset = direction.map(|component| scene.offset_magnitude * component);
                let pose = task::pose::without_offset(&start.pose, &offset);
                check_reach(source, &document.limits, (&start.name, &pose), &scene.goal, scene.horizon)?;
            }
        }
        Ok(scene)
    }

    /// The start of a given name, or the first.
    ///
    /// # Errors
    /// With all names, when there is none of this name.
    pub fn start(&self, name: Option<&str>) -> Result<&StartPose, String> {
        let Some(name) = name else { return Ok(&self.starts[0]) };
        self.starts.iter().find(|start| start.name == name).ok_or_else(|| {
            let names: Vec<&str> = self.starts.iter().map(|start| start.name.as_str()).collect();
            format!("there is no start `{name}`; the scene has {}", names.join(", "))
        })
    }

    /// The planning task of a start and an offset magnitude (m), by default the scene's own.
    ///
    /// # Errors
    /// When the start is unknown or the magnitude negative.
    pub fn task(&self, start: Option<&str>, offset_magnitude: Option<f64>) -> Result<AssemblyTask, String> {
        let magnitude = offset_magnitude.unwrap_or(self.offset_magnitude);
        if !(magnitude >= 0.0 && magnitude.is_finite()) {
            return Err(format!("the offset magnitude must not be negative, got {magnitude}"));
        }
        Ok(AssemblyTask {
            inertia: self.inertia.clone(),
            pairs: self.pairs.iter().map(|&(part, other)| self.pair(part, other)).collect(),
            start: self.start(start)?.pose,
            goal: self.goal,
            impedance: self.impedance.clone(),
            offsets: self.offset_directions.iter().map(|d| d.map(|component| magnitude * component)).collect(),
            horizon: self.horizon,
            cost: self.cost,
            limits: self.limits,
        })
    }

    /// Every body part with every environment part, also those that a plan leaves out.
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

fn pose(source: Source, at: &Spanned<[f64; 3]>, turned: &Spanned<[f64; 4]>) -> Result<[f64; 7], SceneError> {
    let ([x, y, z], [w, i, j, k]) = (position(source, at)?, orientation(source, turned)?);
    Ok([x, y, z, w, i, j, k])
}

fn goal(source: Source, document: &Spanned<PoseDocument>) -> Result<[f64; 7], SceneError> {
    pose(source, &document.get_ref().position, &document.get_ref().orientation)
}

fn starts(source: Source, documents: &Spanned<Vec<Spanned<StartDocument>>>) -> Result<Vec<StartPose>, SceneError> {
    let mut starts: Vec<StartPose> = Vec::new();
    for document in documents.get_ref() {
        let StartDocument { name, position, orientation } = document.get_ref();
        if starts.iter().any(|other| other.name == *name.get_ref()) {
            return Err(source.error(name.span(), format!("start name `{}` is used twice", name.get_ref())));
        }
        starts.push(StartPose { name: name.get_ref().clone(), pose: pose(source, position, orientation)? });
    }
    if starts.is_empty() {
        return Err(source.error(documents.span(), "a scene needs at least one [[start]]"));
    }
    Ok(starts)
}

fn inertia(source: Source, document: &SceneDocument) -> Result<Inertia, SceneError> {
    let body = document.body.get_ref();
    let mass = match &body.mass {
        Some(mass) => positive(source, "body.mass", mass)?,
        None => DEFAULT_MASS,
    };
    let Some(entry) = &body.inertia else {
        return Ok(Inertia { mass, rotational: Matrix3::identity() * DEFAULT_INERTIA });
    };
    let rotational = match entry.get_ref() {
        InertiaDocument::Diagonal(diagonal) => Matrix3::from_diagonal(&(*diagonal).into()),
        InertiaDocument::Full(rows) => Matrix3::from_fn(|row, column| rows[row][column]),
    };
    let symmetric = (rotational - rotational.transpose()).amax() <= 1e-9 * rotational.amax();
    if !symmetric || rotational.cholesky().is_none() {
        return Err(source.error(entry.span(), "body.inertia must be symmetric and positive definite (kg m^2)"));
    }
    Ok(Inertia { mass, rotational })
}

fn impedance(source: Source, document: &ImpedanceDocument, inertia: &Inertia) -> Result<Impedance, SceneError> {
    let mut impedance = Impedance::critically_damped(
        positive(source, "impedance.translational_stiffness", &document.translational_stiffness)?,
        positive(source, "impedance.rotational_stiffness", &document.rotational_stiffness)?,
        inertia,
    );
    if let Some(damping) = &document.translational_damping {
        impedance.translational_damping = not_negative(source, "impedance.translational_damping", damping)?;
    }
    if let Some(damping) = &document.rotational_damping {
        let diagonal = *damping.get_ref();
        if diagonal.iter().any(|&axis| !(axis >= 0.0 && axis.is_finite())) {
            return Err(source.error(damping.span(), "impedance.rotational_damping must not be negative"));
        }
        impedance.rotational_damping = Matrix3::from_diagonal(&diagonal.into());
    }
    Ok(impedance)
}

fn offsets(source: Source, document: &RobustnessDocument) -> Result<(f64, Vec<[f64; 3]>), SceneError> {
    let magnitude = not_negative(source, "robustness.offset_magnitude", &document.offset_magnitude)?;
    let entries = &document.offset_directions;
    if entries.get_ref().is_empty() {
        return Err(source.error(entries.span(), "at least one offset direction is needed; [0, 0, 0] is no offset"));
    }
    let directions: Result<_, _> = entries.get_ref().iter().map(|entry| direction(source, entry)).collect();
    Ok((magnitude, directions?))
}

fn horizon(source: Source, document: &HorizonDocument) -> Result<Horizon, SceneError> {
    let steps = within(source, "horizon.steps", &document.steps, |steps| steps >= 1, "must be at least 1")?;
    Ok(Horizon { steps: steps as usize, time_step: positive(source, "horizon.time_step", &document.time_step)? })
}

fn cost(source: Source, document: &CostDocument) -> Result<TrajectoryCost, SceneError> {
    let paper = |terminal_position, terminal_orientation| CostWeights {
        translational_velocity: 1.0,
        rotational_velocity: 0.1,
        terminal_position,
        terminal_orientation,
    };
    Ok(TrajectoryCost {
        reference: weights(source, "cost.reference", document.reference.as_ref(), paper(100.0, 10.0))?,
        compliant: weights(source, "cost.compliant", document.compliant.as_ref(), paper(10_000.0, 1000.0))?,
    })
}

fn weights(
    source: Source,
    table: &str,
    document: Option<&WeightsDocument>,
    default: CostWeights,
) -> Result<CostWeights, SceneError> {
    let Some(document) = document else { return Ok(default) };
    let weight = |key: &str, value: &Option<Spanned<f64>>, default: f64| match value {
        Some(value) => not_negative(source, &format!("{table}.{key}"), value),
        None => Ok(default),
    };
    Ok(CostWeights {
        translational_velocity: weight(
            "translational_velocity",
            &document.translational_velocity,
            default.translational_velocity,
        )?,
        rotational_velocity: weight("rotational_velocity", &document.rotational_velocity, default.rotational_velocity)?,
        terminal_position: weight("terminal_position", &document.terminal_position, default.terminal_position)?,
        terminal_orientation: weight(
            "terminal_orientation",
            &document.terminal_orientation,
            default.terminal_orientation,
        )?,
    })
}

/// The named pairs, by default every body part with every environment part.
fn pairs(
    source: Source,
    document: Option<&ContactDocument>,
    body: &[Part],
    environment: &[Part],
) -> Result<Vec<(usize, usize)>, SceneError> {
    let Some(named) = document.and_then(|contact| contact.pairs.as_ref()) else {
        let all = (0..body.len()).flat_map(|part| (0..environment.len()).map(move |other| (part, other)));
        return Ok(all.collect());
    };
    let mut pairs = Vec::new();
    for entry in named {
        let find = |parts: &[Part], parent: &str, name: &str| {
            parts.iter().position(|part| part.name == name).ok_or_else(|| {
                let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                source.error(entry.span(), format!("[{parent}] has no part `{name}`{}", suggest(name, &names)))
            })
        };
        let [first, second] = entry.get_ref();
        let pair = (find(body, "body", first)?, find(environment, "environment", second)?);
        if pairs.contains(&pair) {
            return Err(source.error(entry.span(), format!("the pair `{first}`, `{second}` is listed twice")));
        }
        pairs.push(pair);
    }
    Ok(pairs)
}
