//! One homotopy step: the problem solved with one smoothing, and its solution.

use nlp::{Control, Iterate, Options, Progress, SolveError, SolveStatus, Start};
use task::{HessianKind, HomotopySettings, IpoptValue, LinearSolver, Smoothing, Trajectory};
use workers::Workers;

use crate::active_contacts::ActiveContacts;
use crate::formulation::Formulation;
use crate::stage_solver::TranscriptionSolver;
use crate::stagnation::{self, Stagnation};
use crate::transcription::Transcription;

/// Result of a homotopy step.
#[derive(Debug, Clone)]
pub struct HomotopyStep {
    /// Its smoothing.
    pub smoothing: Smoothing,
    /// Outcome of the solve.
    pub status: SolveStatus,
    /// The last failure to evaluate the problem, if there was one.
    pub message: Option<String>,
    /// Number of iterations, including those of a first attempt that stagnated.
    pub iterations: usize,
    /// Cost (Sec. ocp:cost).
    pub objective: f64,
    /// Largest violation of a constraint or bound.
    pub constraint_violation: f64,
    /// Wall times.
    pub timing: IterationTiming,
    /// The linear solver that ran.
    pub linear_solver: String,
    /// Statistics of the stage solver, if it ran.
    pub stage_solver: Option<kkt::Report>,
    /// The motion.
    pub trajectory: Trajectory,
    /// The primal-dual point.
    pub iterate: Iterate,
}

impl HomotopyStep {
    /// Adds the effort of a first attempt, if there was one; nothing else of it is kept.
    fn after(mut self, first: Option<&Self>) -> Self {
        if let Some(first) = first {
            self.iterations += first.iterations;
            self.timing = self.timing + first.timing;
        }
        self
    }
}

/// Wall seconds of a homotopy step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct IterationTiming {
    /// Total.
    pub total: f64,
    /// Distances and their derivatives.
    pub distances: f64,
    /// Model functions and assembly of the sparse matrices.
    pub model: f64,
    /// Factorisations and solves.
    pub linear_solver: f64,
    /// The rest, which is Ipopt's own work.
    pub rest: f64,
}

impl std::ops::Add for IterationTiming {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            total: self.total + other.total,
            distances: self.distances + other.distances,
            model: self.model + other.model,
            linear_solver: self.linear_solver + other.linear_solver,
            rest: self.rest + other.rest,
        }
    }
}

/// Solves with one smoothing.
pub(crate) struct IterationSolver<'run> {
    /// Settings of all homotopy steps.
    pub settings: &'run HomotopySettings,
    /// Smoothing of this one.
    pub smoothing: Smoothing,
    /// The threads.
    pub workers: &'run Workers,
    /// Gets every iteration of Ipopt.
    pub observer: &'run mut dyn FnMut(&Progress) -> Control,
}

impl IterationSolver<'_> {
    /// With the contacts that may matter. If a pair without a contact penetrates in the solution, it gets one and the solve
    /// continues. Points are those of the whole formulation.
    pub fn solve(&mut self, whole: &Formulation, start: &Start) -> Result<HomotopyStep, SolveError> {
        let mut formulation = match start {
            Start::Cold(_) => whole.with_contacts(ActiveContacts::on_straight_paths(whole.task())),
            Start::Warm(point) => whole.near(&point.x),
        };
        let mut start = start.clone();
        let mut before: Option<HomotopyStep> = None;
        loop {
            let mut last = self.solve_with(&formulation, whole, &start)?;
            last.iterate = whole.point_of(&formulation, &last.iterate);
            let last = last.after(before.as_ref());
            match formulation.layout().contacts().with_missing(&last.trajectory) {
                Some(more) if last.status != SolveStatus::Interrupted => {
                    formulation = whole.with_contacts(more);
                    start = Start::Warm(last.iterate.clone());
                    before = Some(last);
                }
                _ => return Ok(last),
            }
        }
    }

    /// With the contacts of a formulation.
    fn solve_with(
        &mut self,
        formulation: &Formulation,
        whole: &Formulation,
        start: &Start,
    ) -> Result<HomotopyStep, SolveError> {
        let (settings, Smoothing { tau, sigma, .. }) = (self.settings, self.smoothing);
        let transcription = Transcription::of(formulation.clone(), settings.complementarity, settings.hessian);
        let mut transcription = transcription.with_workers(self.workers.clone());
        transcription.set_smoothing(tau, sigma);
        match start {
            Start::Cold(x) => self.attempt(&mut transcription, &Start::Cold(formulation.variables_of(whole, x))),
            Start::Warm(point) => self.watch(&mut transcription, &formulation.point_of(whole, point)),
        }
    }

    /// From a warm start. If it stagnates, tries once more with a larger barrier parameter.
    fn watch(&mut self, transcription: &mut Transcription, start: &Iterate) -> Result<HomotopyStep, SolveError> {
        let Self { settings, smoothing, workers, observer } = self;
        let start = &Start::Warm(start.clone());
        let mut stagnation = Stagnation::default();
        let mut watch = |progress: &Progress| {
            stagnation.see(progress);
            if stagnation.is_found() { Control::Stop } else { observer(progress) }
        };
        let mut watched = IterationSolver { settings, smoothing: *smoothing, workers, observer: &mut watch };
        let first = watched.attempt(transcription, start)?;
        if !stagnation.is_found() {
            return Ok(first);
        }
        let wider = Smoothing { mu_init: smoothing.mu_init * stagnation::WIDER, ..*smoothing };
        let mut again = IterationSolver { settings, smoothing: wider, workers, observer: &mut **observer };
        Ok(again.attempt(transcription, start)?.after(Some(&first)))
    }

    /// From a start, unchanged.
    fn attempt(&mut self, transcription: &mut Transcription, start: &Start) -> Result<HomotopyStep, SolveError> {
        let options = options(self.settings, self.smoothing);
        transcription.distances().reset_seconds();
        let mut stage_solver = TranscriptionSolver::new(transcription.layout(), transcription.workers().clone());
        let chosen = match self.settings.linear_solver {
            LinearSolver::Stage if nlp::takes_own_solver() => nlp::LinearSystemSolver::Own(&mut stage_solver),
            LinearSolver::Stage => nlp::LinearSystemSolver::Named(LinearSolver::Mumps.name()),
            other => nlp::LinearSystemSolver::Named(other.name()),
        };
        let solution = nlp::solve(transcription, start, &options, chosen, &mut *self.observer)?;
        let distances = transcription.distances().seconds();
        let timing = IterationTiming {
            total: solution.timing.total,
            distances,
            model: solution.timing.evaluation - distances,
            linear_solver: solution.timing.linear_solver,
            rest: solution.timing.total - solution.timing.evaluation - solution.timing.linear_solver,
        };
        Ok(HomotopyStep {
            smoothing: self.smoothing,
            status: solution.status,
            message: solution.evaluation_error.map(|error| error.to_string()),
            iterations: solution.iterations,
            objective: solution.objective,
            constraint_violation: solution.constraint_violation,
            timing,
            linear_solver: solution.linear_solver,
            stage_solver: stage_solver.report().copied(),
            trajectory: transcription.formulation().motion(&solution.iterate.x, self.smoothing.tau),
            iterate: solution.iterate,
        })
    }
}

/// Options that keep a warm start in place. Ipopt's defaults move it so far from its bounds that the next homotopy step
/// may converge to a worse optimum.
const WARM_START_PUSHES: [&str; 5] = [
    "warm_start_bound_push",
    "warm_start_bound_frac",
    "warm_start_slack_bound_push",
    "warm_start_slack_bound_frac",
    "warm_start_mult_bound_push",
];

/// Options of Ipopt for one smoothing.
pub(crate) fn options(settings: &HomotopySettings, smoothing: Smoothing) -> Options {
    let mut options = Options::default();
    options.set("mu_init", smoothing.mu_init);
    for push in WARM_START_PUSHES {
        options.set(push, 1e-9);
    }
    if settings.linear_solver == LinearSolver::Stage && nlp::takes_own_solver() {
        // The stage solver refines its solutions itself where necessary.
        options.set("min_refinement_steps", 0);
    }
    if settings.hessian == HessianKind::LimitedMemory {
        options.set("hessian_approximation", "limited-memory");
    }
    for option in &settings.ipopt {
        options.set(
            &option.name,
            match &option.value {
                IpoptValue::Integer(value) => (*value).into(),
                IpoptValue::Number(value) => (*value).into(),
                IpoptValue::Text(value) => nlp::OptionValue::from(value.as_str()),
            },
        );
    }
    options
}
