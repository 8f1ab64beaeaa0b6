//! Rollouts of a plan with hard contacts at injected grasp errors, beside an unplanned straight push.

use std::fmt;

use scene::Scene;
use simulation::{Outcome, Reference, Settings, larger, offsets};
use task::{Coverage, GraspError};
use workers::Workers;

use crate::error::PlannerError;
use crate::problem::Problem;
use crate::ranges::{require, require_frictions, require_rotation_error, require_threads};
use crate::session::{Event, Session};

/// The motion that is played.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// The reference after a homotopy step (counted from 1).
    HomotopyStep(usize),
    /// The plan's reference.
    Plan,
    /// Straight from start to goal, unplanned: what a plan has to beat.
    StraightPush,
}

impl fmt::Display for Motion {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            // As the folder of its tables.
            Self::HomotopyStep(number) => formatter.pad(&format!("stage {number}")),
            Self::Plan => formatter.pad("plan"),
            Self::StraightPush => formatter.pad("straight push"),
        }
    }
}

/// Which offsets are injected.
#[derive(Debug, Clone, PartialEq)]
pub enum OffsetSource {
    /// The planned ones, with their rotation errors unless there are random ones.
    Planned,
    /// A number of random ones, as [`offsets::covered`] draws them.
    Random(usize, Region),
    /// A grid in the hull of the planned ones, with this number of intervals along each of its edges.
    Grid(usize),
    /// These (m, body frame); magnitudes do not scale them.
    Listed(Vec<[f64; 3]>),
}

/// Region of random offsets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Region {
    /// The offsets that the scene covers.
    #[default]
    Covered,
    /// In the hull of the planned ones.
    Hull,
    /// In the disc across the insertion.
    Disc,
    /// In the ball.
    Ball,
}

impl Region {
    fn coverage(self, scene: &Scene) -> Coverage {
        match self {
            Self::Covered => scene.coverage,
            Self::Hull => Coverage::Hull,
            Self::Disc => scene.disc(),
            Self::Ball => Coverage::Ball,
        }
    }
}

/// Which grasp errors are injected.
#[derive(Debug, Clone, PartialEq)]
pub struct GraspErrors {
    /// Which offsets.
    pub offsets: OffsetSource,
    /// Magnitudes (m) to which the planned offsets are scaled; the problem's own where there are none.
    pub magnitudes: Vec<f64>,
    /// Largest random rotation error of the part in the gripper (rad), about any axis.
    pub rotation_error: f64,
    /// Seed of random offsets and rotations.
    pub seed: u64,
}

impl GraspErrors {
    /// The offsets in words, such as `20 random offsets in the disc across the insertion, half of them on its rim`.
    pub fn offsets_in_words(&self, problem: &Problem) -> String {
        match &self.offsets {
            OffsetSource::Planned => "the planned offsets".to_owned(),
            OffsetSource::Random(count, region) => {
                let place = match region.coverage(problem.scene()) {
                    Coverage::Hull => "in the hull of the planned ones",
                    Coverage::Disc { .. } => "in the disc across the insertion, half of them on its rim",
                    Coverage::Ball => "in the ball, half of them on its surface",
                };
                format!("{count} random offsets {place}")
            }
            OffsetSource::Grid(_) => "a grid of offsets in the hull of the planned ones".to_owned(),
            OffsetSource::Listed(offsets) => format!("{} offsets of a list", offsets.len()),
        }
    }
}

impl Default for GraspErrors {
    fn default() -> Self {
        Self { offsets: OffsetSource::Planned, magnitudes: Vec::new(), rotation_error: 0.0, seed: 1 }
    }
}

/// Settings of a simulation.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationRequest {
    /// Injected errors.
    pub errors: GraspErrors,
    /// Coulomb coefficients, each once.
    pub frictions: Vec<f64>,
    /// Time step of the simulation (s).
    pub time_step: f64,
    /// How long the end of the reference is held before a rollout is judged (s).
    pub settling_time: f64,
}

impl Default for SimulationRequest {
    fn default() -> Self {
        let Settings { time_step, settling_time, friction } = Settings::default();
        Self { errors: GraspErrors::default(), frictions: vec![friction], time_step, settling_time }
    }
}

/// One rollout and what it was.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlayedRollout {
    /// The motion.
    pub motion: Motion,
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Modelled magnitude delta-hat (m).
    pub offset_magnitude: f64,
    /// Injected magnitude (m): the largest length of listed offsets.
    pub magnitude: f64,
    /// Injected error.
    pub grasp: GraspError,
    /// How it ended.
    pub outcome: Outcome,
    /// Whether it ends at the goal.
    pub at_goal: bool,
    /// Whether it ends there and keeps the limits of forces.
    pub success: bool,
}

/// More rollouts than anyone waits for.
const MOST_ROLLOUTS: usize = 10_000_000;
/// More offsets of one magnitude than anyone needs.
const MOST_OFFSETS: usize = 1_000_000;
/// Largest magnitude of an offset (m).
const LARGEST_MAGNITUDE: f64 = 10.0;
/// Rollouts between two events.
const TOLD: usize = 64;

impl SimulationRequest {
    /// Checks all values.
    ///
    /// # Errors
    /// With the first that is out of its range.
    pub fn validate(&self) -> Result<(), PlannerError> {
        require_frictions(&self.frictions)?;
        require_rotation_error(self.errors.rotation_error)?;
        self.frictions.iter().try_for_each(|&friction| self.settings(friction).validate())?;
        for (index, magnitude) in self.errors.magnitudes.iter().enumerate() {
            let in_range = (0.0..=LARGEST_MAGNITUDE).contains(magnitude);
            require(in_range, "magnitude", magnitude, "must lie between 0 and 10 m")?;
            require(!self.errors.magnitudes[..index].contains(magnitude), "magnitude", magnitude, "is given twice")?;
        }
        match &self.errors.offsets {
            OffsetSource::Random(count, _) => require(
                (1..=MOST_OFFSETS).contains(count),
                "number of offsets",
                count,
                "must lie between 1 and 1000000",
            ),
            OffsetSource::Grid(divisions) => {
                require((1..=MOST_OFFSETS).contains(divisions), "grid", divisions, "must lie between 1 and 1000000")
            }
            OffsetSource::Planned | OffsetSource::Listed(_) => Ok(()),
        }
    }

    /// How a rollout of a friction is computed.
    pub fn settings(&self, friction: f64) -> Settings {
        Settings { time_step: self.time_step, friction, settling_time: self.settling_time }
    }
}

/// All rollouts of [`simulate_each`].
///
/// # Errors
/// When the request is out of range.
pub fn simulate(
    problem: &Problem,
    motions: &[(Motion, Reference)],
    request: &SimulationRequest,
    session: &Session,
) -> Result<Vec<PlayedRollout>, PlannerError> {
    let mut played = Vec::new();
    simulate_each(problem, motions, request, session, &mut |rollout| {
        played.push(rollout);
        Ok(())
    })?;
    Ok(played)
}

/// Plays motions, and the straight push, with all frictions and grasp errors, in this order, with all pairs, also those
/// that the plan leaves out. `take` gets every rollout, in this order, as soon as it has been played.
///
/// The session's observer gets the progress. If the session is interrupted, there are no more rollouts; its folder and its
/// deadline are not used.
///
/// # Errors
/// When the request is out of range, and those of `take`.
pub fn simulate_each(
    problem: &Problem,
    motions: &[(Motion, Reference)],
    request: &SimulationRequest,
    session: &Session,
    take: &mut dyn FnMut(PlayedRollout) -> Result<(), PlannerError>,
) -> Result<(), PlannerError> {
    request.validate()?;
    require_threads(session.threads)?;
    let world = problem.world();
    let injections = injections(problem, &request.errors)?;
    let push = (Motion::StraightPush, Reference::straight(&world.start, &world.goal, world.horizon));
    let offsets: usize = injections.iter().map(|injection| injection.errors.len()).sum();
    let count = offsets.saturating_mul(request.frictions.len()).saturating_mul(motions.len() + 1);
    require(count <= MOST_ROLLOUTS, "number of rollouts", count, "must not be above 10000000; play fewer offsets")?;
    for (_, reference) in motions.iter().chain([&push]) {
        request.frictions.iter().try_for_each(|&friction| request.settings(friction).validate_for(reference))?;
    }
    let (success, workers) = (problem.success(), Workers::new(session.threads));
    let mut done = 0;
    for &friction in &request.frictions {
        let rollout = problem.rollout_in(&world, request.settings(friction))?;
        for (motion, reference) in motions.iter().chain([&push]) {
            for Injection { magnitude, errors } in &injections {
                for errors in errors.chunks(TOLD) {
                    if session.is_interrupted() {
                        return Ok(());
                    }
                    let outcomes = rollout.simulate(reference, errors, &workers);
                    for (&grasp, outcome) in errors.iter().zip(outcomes) {
                        take(PlayedRollout {
                            motion: *motion,
                            friction,
                            offset_magnitude: problem.offset_magnitude(),
                            magnitude: *magnitude,
                            grasp,
                            outcome,
                            at_goal: outcome.reaches_goal(&success),
                            success: outcome.succeeds(&success, &problem.task().limits),
                        })?;
                    }
                    done += errors.len();
                    session.tell(Event::Rollouts { done, count });
                }
            }
        }
    }
    Ok(())
}

/// Grasp errors that are counted together.
struct Injection {
    /// Magnitude, or the largest length in a list (m).
    magnitude: f64,
    errors: Vec<GraspError>,
}

fn injections(problem: &Problem, errors: &GraspErrors) -> Result<Vec<Injection>, PlannerError> {
    if let OffsetSource::Listed(offsets) = &errors.offsets {
        let length = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
        let magnitude = offsets.iter().map(length).fold(0.0, f64::max);
        require(magnitude <= LARGEST_MAGNITUDE, "offset", magnitude, "must not be longer than 10 m")?;
        return Ok(vec![Injection { magnitude, errors: with_turns(offsets, errors) }]);
    }
    let mut magnitudes = errors.magnitudes.clone();
    if magnitudes.is_empty() {
        magnitudes.push(problem.offset_magnitude());
    }
    magnitudes.sort_by(f64::total_cmp);
    let of_magnitude = |&magnitude: &f64| {
        let grasps = problem.scene().grasps(magnitude)?;
        let planned: Vec<[f64; 3]> = grasps.iter().map(|grasp| grasp.offset).collect();
        let offsets = match &errors.offsets {
            OffsetSource::Planned if errors.rotation_error == 0.0 => {
                return Ok(Injection { magnitude, errors: GraspError::distinct(grasps) });
            }
            OffsetSource::Random(count, region) => {
                let coverage = region.coverage(problem.scene());
                offsets::covered(&coverage, &planned, magnitude, *count, errors.seed)
            }
            OffsetSource::Grid(divisions) => grid(&planned, *divisions)?,
            _ => planned,
        };
        Ok(Injection { magnitude, errors: with_turns(&offsets, errors) })
    };
    magnitudes.iter().map(of_magnitude).collect()
}

fn grid(planned: &[[f64; 3]], divisions: usize) -> Result<Vec<[f64; 3]>, PlannerError> {
    const LARGEST: f64 = 10_000.0;
    let size = offsets::grid_size(planned.len(), divisions);
    let rule = format!("has {size:.0} offsets, more than {LARGEST}; use fewer intervals, or random offsets");
    require(size <= LARGEST, "grid", divisions, &rule)?;
    Ok(offsets::grid(planned, divisions))
}

/// Every offset with a random rotation error.
fn with_turns(offsets: &[[f64; 3]], errors: &GraspErrors) -> Vec<GraspError> {
    let turns = offsets::rotations(errors.rotation_error, offsets.len(), errors.seed);
    GraspError::distinct(offsets.iter().zip(turns).map(|(&offset, rotation)| GraspError { offset, rotation }))
}

/// What is noteworthy about some rollouts.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RolloutRemarks {
    rollouts: usize,
    /// Rollouts in which parts penetrate.
    penetrating: usize,
    /// Rollouts of the plan that end at the goal, and those of them that press with more than the limit.
    at_goal: usize,
    beyond: usize,
    /// Largest force of these (N).
    force: f64,
}

impl RolloutRemarks {
    /// Takes note of a rollout of a task with a limit of contact forces (N).
    pub fn add(&mut self, played: &PlayedRollout, limit: f64) {
        /// More than time steps leave (m).
        const PENETRATION: f64 = 1e-4;
        let outcome = &played.outcome;
        self.rollouts += 1;
        // Comparisons are false for what is no number.
        self.penetrating += usize::from(!(outcome.max_penetration <= PENETRATION));
        if played.at_goal && played.motion == Motion::Plan {
            self.at_goal += 1;
            let force = outcome.loads.contact_force;
            // Comparisons are false for what is no number.
            if !(force <= limit) {
                self.beyond += 1;
                self.force = larger(self.force, force);
            }
        }
    }

    /// A warning about rollouts that end at the goal and press with more than the limit of contact forces (N), and so fail.
    pub fn force_warning(&self, limit: f64) -> Option<String> {
        let Self { at_goal, beyond, force, .. } = self;
        (*beyond > 0).then(|| {
            format!(
                "{beyond} of the {at_goal} rollouts of the plan that end at the goal press with more than contact_force = \
                 {limit:.1} N, with up to {force:.1} N, and count as failures"
            )
        })
    }

    /// A warning about rollouts in which parts penetrate. Contacts are hard, so these parts have done so from the
    /// beginning.
    pub fn penetration_warning(&self) -> Option<String> {
        let Self { rollouts, penetrating, .. } = self;
        (*penetrating > 0).then(|| {
            format!(
                "in {penetrating} of {rollouts} rollouts parts penetrate; is the offset so large that the body starts inside the \
                 environment?"
            )
        })
    }
}
