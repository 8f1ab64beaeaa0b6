//! The homotopy (Sec. ocp:homotopy): solve with strong smoothing, reduce it, solve again from the last solution. Beyond
//! the paper's number of homotopy iterations it goes on until contact is hard.
//!
//! A *homotopy iteration* is one solve with one smoothing; an *iteration* is one of Ipopt's.

use nlp::{Control, Iterate, Options, Progress, SolveError, SolveStatus, Start};
use task::{AssemblyTask, HessianKind, HomotopySettings, IpoptValue, LinearSolver, Overlap, Smoothing, Trajectory};
use workers::Workers;

use crate::crawl::{self, Crawl};
use crate::grid::{carried_over, coarsened};
use crate::near_pairs::NearPairs;
use crate::stage_solver::TranscriptionSolver;
use crate::transcription::Transcription;

/// Report to the observer of a homotopy at every iteration.
#[derive(Debug, Clone, Copy)]
pub struct Event<'event> {
    /// Number of the homotopy iteration, from 1.
    pub number: usize,
    /// Largest number of homotopy iterations.
    pub most: usize,
    /// Its smoothing.
    pub smoothing: Smoothing,
    /// The iteration.
    pub progress: &'event Progress,
}

/// Result of a homotopy iteration.
#[derive(Debug, Clone)]
pub struct HomotopyIteration {
    /// Its smoothing.
    pub smoothing: Smoothing,
    /// Outcome of the solve.
    pub status: SolveStatus,
    /// The last failure to evaluate the problem, if there was one.
    pub message: Option<String>,
    /// Number of iterations, those of a first try that crawled included.
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

impl HomotopyIteration {
    /// With the effort of a first try, if there was one, of which nothing else is kept.
    fn after(mut self, first: Option<&Self>) -> Self {
        if let Some(first) = first {
            self.iterations += first.iterations;
            self.timing = self.timing + first.timing;
        }
        self
    }
}

/// Wall seconds of a homotopy iteration.
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

/// What came of a homotopy iteration, as far as it decides whether another one follows.
#[derive(Debug, Clone, Copy)]
pub struct IterationEnd<'motion> {
    /// Whether it found a solution.
    pub converged: bool,
    /// Its smoothing of the distances.
    pub tau: f64,
    /// Its motion.
    pub motion: &'motion Trajectory,
}

impl<'motion> From<&'motion HomotopyIteration> for IterationEnd<'motion> {
    fn from(iteration: &'motion HomotopyIteration) -> Self {
        Self { converged: iteration.status.is_success(), tau: iteration.smoothing.tau, motion: &iteration.trajectory }
    }
}

/// A homotopy that is run iteration by iteration.
pub struct Homotopy {
    /// On the grid of the task.
    fine: Transcription,
    /// On a coarser one, for the first homotopy iterations.
    coarse: Option<Transcription>,
    settings: HomotopySettings,
}

impl Homotopy {
    /// Transcribes the task.
    pub fn new(task: &AssemblyTask, settings: HomotopySettings) -> Self {
        let transcribe = |task: &AssemblyTask| Transcription::new(task, settings.complementarity, settings.hessian);
        let coarse = (settings.coarse_iterations() > 0).then(|| coarsened(task)).flatten();
        Self { fine: transcribe(task), coarse: coarse.as_ref().map(transcribe), settings }
    }

    /// Runs with some threads, which change nothing but the time it takes. By default it is one.
    pub fn with_threads(self, threads: usize) -> Self {
        let workers = Workers::new(threads);
        let coarse = self.coarse.map(|coarse| coarse.with_workers(workers.clone()));
        Self { fine: self.fine.with_workers(workers), coarse, ..self }
    }

    /// The transcribed problem of a homotopy iteration, counted from 1.
    pub fn transcription(&self, number: usize) -> &Transcription {
        match &self.coarse {
            Some(coarse) if number <= self.settings.coarse_iterations() => coarse,
            _ => &self.fine,
        }
    }

    /// Runs all homotopy iterations, each from the final primal-dual point of the one before, whether that converged or
    /// not. An interrupted one is the last, and one after which `finished` stops.
    ///
    /// # Errors
    /// When an option or the linear solver is rejected. Numerical failure is a status.
    pub fn run(
        &mut self,
        observe: impl FnMut(Event) -> Control,
        finished: impl FnMut(usize, &HomotopyIteration) -> Control,
    ) -> Result<Vec<HomotopyIteration>, SolveError> {
        self.run_from(&[], Start::Cold(self.transcription(1).initial_guess()), observe, finished)
    }

    /// Runs the homotopy iterations after `earlier` ones, which another run has completed with `start` as the final
    /// point.
    ///
    /// # Errors
    /// As [`Homotopy::run`].
    pub fn run_from(
        &mut self,
        earlier: &[IterationEnd],
        mut start: Start,
        mut observe: impl FnMut(Event) -> Control,
        mut finished: impl FnMut(usize, &HomotopyIteration) -> Control,
    ) -> Result<Vec<HomotopyIteration>, SolveError> {
        let mut iterations: Vec<HomotopyIteration> = Vec::new();
        for (index, smoothing) in self.settings.schedule().enumerate().skip(earlier.len()) {
            let ends: Vec<IterationEnd> =
                earlier.iter().copied().chain(iterations.iter().map(IterationEnd::from)).collect();
            if !self.goes_on(&ends) {
                break;
            }
            let mut observer = |progress: &Progress| {
                observe(Event { number: index + 1, most: self.settings.most_iterations(), smoothing, progress })
            };
            let coarse_iterations = self.settings.coarse_iterations();
            let transcription = match &mut self.coarse {
                Some(coarse) if index < coarse_iterations => coarse,
                coarse => {
                    if let (Some(coarse), Start::Warm(point), true) = (coarse, &start, index == coarse_iterations) {
                        start = Start::Warm(carried_over(point, coarse, &self.fine));
                    }
                    &mut self.fine
                }
            };
            transcription.set_smoothing(smoothing.tau, smoothing.sigma);
            let result = solve_iteration(transcription, &start, &self.settings, smoothing, &mut observer)?;
            let control = finished(index + 1, &result);
            start = Start::Warm(result.iterate.clone());
            let interrupted = result.status == SolveStatus::Interrupted;
            iterations.push(result);
            if interrupted || matches!(control, Control::Stop) {
                break;
            }
        }
        Ok(iterations)
    }

    /// Whether another homotopy iteration follows these: fewer than wanted have run, or less smoothing makes contact
    /// harder.
    fn goes_on(&self, ends: &[IterationEnd]) -> bool {
        if ends.len() < self.settings.iterations {
            return true;
        }
        let before = ends.len().checked_sub(2).map(|index| ends[index].motion);
        let last = ends[ends.len() - 1];
        last.converged && Overlap::of(self.fine.task(), last.motion, last.tau, before) == Overlap::Soft
    }
}

/// Options that keep a warm start in place. Ipopt's defaults move it so far from its bounds that the next homotopy
/// iteration may converge to a worse optimum.
const WARM_START_PUSHES: [&str; 5] = [
    "warm_start_bound_push",
    "warm_start_bound_frac",
    "warm_start_slack_bound_push",
    "warm_start_slack_bound_frac",
    "warm_start_mult_bound_push",
];

/// Checks that the installed Ipopt can run these settings, before anything is solved.
///
/// # Errors
/// When it refuses an option, or the linear solver cannot run.
pub fn check_settings(settings: &HomotopySettings) -> Result<(), SolveError> {
    let named = (settings.linear_solver != LinearSolver::Stage).then(|| settings.linear_solver.name());
    settings.schedule().take(1).try_for_each(|first| nlp::check(&iteration_options(settings, first), named))
}

fn iteration_options(settings: &HomotopySettings, smoothing: Smoothing) -> Options {
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

/// Solves with one smoothing: from a warm start, without the pairs that stay far apart.
fn solve_iteration(
    transcription: &mut Transcription,
    start: &Start,
    settings: &HomotopySettings,
    smoothing: Smoothing,
    observer: &mut dyn FnMut(&Progress) -> Control,
) -> Result<HomotopyIteration, SolveError> {
    let Start::Warm(point) = start else {
        return attempt_iteration(transcription, start, settings, smoothing, observer);
    };
    let mut near = NearPairs::at(&point.x, transcription);
    let mut before: Option<HomotopyIteration> = None;
    loop {
        let point = before.as_ref().map_or(point, |before| &before.iterate);
        if near.are_all() {
            let last = watch_iteration(transcription, point, settings, smoothing, observer)?;
            return Ok(last.after(before.as_ref()));
        }
        let task = near.of_task(transcription.task());
        let mut of_near = Transcription::new(&task, settings.complementarity, settings.hessian)
            .with_workers(transcription.workers().clone());
        of_near.set_smoothing(smoothing.tau, smoothing.sigma);
        let point = near.restrict(point, transcription);
        let mut last = watch_iteration(&mut of_near, &point, settings, smoothing, observer)?;
        last.iterate = near.extend(&last.iterate, transcription);
        last.trajectory = transcription.motion(&last.iterate.x, smoothing.tau);
        let last = last.after(before.as_ref());
        match near.with_missing(&last.trajectory) {
            Some(more) if last.status != SolveStatus::Interrupted => (near, before) = (more, Some(last)),
            _ => return Ok(last),
        }
    }
}

/// Solves with one smoothing from a warm start. Where it crawls, it is tried once more with a larger barrier parameter.
fn watch_iteration(
    transcription: &mut Transcription,
    start: &Iterate,
    settings: &HomotopySettings,
    smoothing: Smoothing,
    observer: &mut dyn FnMut(&Progress) -> Control,
) -> Result<HomotopyIteration, SolveError> {
    let start = &Start::Warm(start.clone());
    let mut crawl = Crawl::default();
    let mut watch = |progress: &Progress| {
        crawl.see(progress);
        if crawl.is_found() { Control::Stop } else { observer(progress) }
    };
    let first = attempt_iteration(transcription, start, settings, smoothing, &mut watch)?;
    if !crawl.is_found() {
        return Ok(first);
    }
    let wider = Smoothing { mu_init: smoothing.mu_init * crawl::WIDER, ..smoothing };
    Ok(attempt_iteration(transcription, start, settings, wider, observer)?.after(Some(&first)))
}

/// Solves with one smoothing from a start.
fn attempt_iteration(
    transcription: &mut Transcription,
    start: &Start,
    settings: &HomotopySettings,
    smoothing: Smoothing,
    observer: &mut dyn FnMut(&Progress) -> Control,
) -> Result<HomotopyIteration, SolveError> {
    let options = iteration_options(settings, smoothing);
    transcription.distances().reset_seconds();
    let mut stage_solver = TranscriptionSolver::new(transcription.layout(), transcription.workers().clone());
    let chosen = match settings.linear_solver {
        LinearSolver::Stage if nlp::takes_own_solver() => nlp::LinearSystemSolver::Own(&mut stage_solver),
        LinearSolver::Stage => nlp::LinearSystemSolver::Named(LinearSolver::Mumps.name()),
        other => nlp::LinearSystemSolver::Named(other.name()),
    };
    let solution = nlp::solve(transcription, start, &options, chosen, observer)?;
    let distances = transcription.distances().seconds();
    let timing = IterationTiming {
        total: solution.timing.total,
        distances,
        model: solution.timing.evaluation - distances,
        linear_solver: solution.timing.linear_solver,
        rest: solution.timing.total - solution.timing.evaluation - solution.timing.linear_solver,
    };
    Ok(HomotopyIteration {
        smoothing,
        status: solution.status,
        message: solution.evaluation_error.map(|error| error.to_string()),
        iterations: solution.iterations,
        objective: solution.objective,
        constraint_violation: solution.constraint_violation,
        timing,
        linear_solver: solution.linear_solver,
        stage_solver: stage_solver.report().copied(),
        trajectory: transcription.motion(&solution.iterate.x, smoothing.tau),
        iterate: solution.iterate,
    })
}
