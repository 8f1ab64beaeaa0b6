//! The homotopy (Sec. ocp:homotopy): solve with strong smoothing, reduce it, solve again from the last solution. After
//! the paper's number of homotopy steps it continues until contact is hard.
//!
//! A *homotopy step* is one solve with one smoothing; an *iteration* is one of Ipopt's.

use nlp::{Control, Progress, SolveError, SolveStatus, Start};
use task::{AssemblyTask, HomotopySettings, LinearSolver, Penetration, Smoothing, Trajectory};
use workers::Workers;

use crate::coarse_pieces::CoarsePieces;
use crate::formulation::Formulation;
use crate::grid::{coarsened, transferred};
use crate::homotopy_step::{HomotopyStep, IterationSolver, options};

/// Hulls that are no more than this outside of their pieces (m) are the same shapes.
const ROUNDING: f64 = 1e-9;

/// Report to the observer of a homotopy at every iteration.
#[derive(Debug, Clone, Copy)]
pub struct Event<'event> {
    /// Number of the homotopy step, from 1.
    pub number: usize,
    /// Largest number of homotopy steps.
    pub most: usize,
    /// Its smoothing.
    pub smoothing: Smoothing,
    /// The iteration.
    pub progress: &'event Progress,
}

/// The end of a homotopy step, as far as it decides whether another one follows.
#[derive(Debug, Clone, Copy)]
pub struct IterationEnd<'motion> {
    /// Whether it found a solution.
    pub converged: bool,
    /// Its smoothing of the distances.
    pub tau: f64,
    /// Its motion.
    pub motion: &'motion Trajectory,
}

impl<'motion> From<&'motion HomotopyStep> for IterationEnd<'motion> {
    fn from(iteration: &'motion HomotopyStep) -> Self {
        Self { converged: iteration.status.is_success(), tau: iteration.smoothing.tau, motion: &iteration.trajectory }
    }
}

/// A homotopy that is run step by step.
pub struct Homotopy {
    /// On the grid of the task.
    fine: Formulation,
    /// On a coarser one, for the first homotopy steps.
    coarse: Option<Formulation>,
    settings: HomotopySettings,
    workers: Workers,
}

impl Homotopy {
    /// Of a task.
    pub fn new(task: &AssemblyTask, settings: HomotopySettings) -> Self {
        let formulate = |task: &AssemblyTask| Formulation::new(task, settings.complementarity);
        let coarse = (settings.coarse_iterations() > 0).then(|| coarsened(task)).flatten();
        Self { fine: formulate(task), coarse: coarse.as_ref().map(formulate), settings, workers: Workers::default() }
    }

    /// Runs with some threads; they do not affect results. The default is one.
    pub fn with_threads(self, threads: usize) -> Self {
        Self { workers: Workers::new(threads), ..self }
    }

    /// The problem of a homotopy step, counted from 1, with all contacts.
    pub fn formulation(&self, number: usize) -> &Formulation {
        match &self.coarse {
            Some(coarse) if number <= self.settings.coarse_iterations() => coarse,
            _ => &self.fine,
        }
    }

    /// Runs all homotopy steps, each from the final primal-dual point of the one before, whether that converged or
    /// not. An interrupted one is the last, and one after which `finished` stops.
    ///
    /// # Errors
    /// When an option or the linear solver is rejected. Numerical failure is a status.
    pub fn run(
        &self,
        observe: impl FnMut(Event) -> Control,
        finished: impl FnMut(usize, &HomotopyStep) -> Control,
    ) -> Result<Vec<HomotopyStep>, SolveError> {
        self.run_from(&[], Start::Cold(self.formulation(1).initial_guess()), observe, finished)
    }

    /// Runs the homotopy steps after `earlier` ones, which another run has completed with `start` as the final
    /// point.
    ///
    /// # Errors
    /// As [`Homotopy::run`].
    pub fn run_from(
        &self,
        earlier: &[IterationEnd],
        mut start: Start,
        mut observe: impl FnMut(Event) -> Control,
        mut finished: impl FnMut(usize, &HomotopyStep) -> Control,
    ) -> Result<Vec<HomotopyStep>, SolveError> {
        let mut iterations: Vec<HomotopyStep> = Vec::new();
        for (index, smoothing) in self.settings.schedule().enumerate().skip(earlier.len()) {
            let ends: Vec<IterationEnd> =
                earlier.iter().copied().chain(iterations.iter().map(IterationEnd::from)).collect();
            if !self.continues(&ends) {
                break;
            }
            let mut observer = |progress: &Progress| {
                observe(Event { number: index + 1, most: self.settings.most_iterations(), smoothing, progress })
            };
            if let (Some(coarse), Start::Warm(point)) = (&self.coarse, &start)
                && index == self.settings.coarse_iterations()
            {
                start = Start::Warm(transferred(point, coarse, &self.fine));
            }
            let result = self.solve(index + 1, smoothing, &start, &mut observer)?;
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

    /// A homotopy step. Pieces of coarse ones are as coarse as their smoothing, those of later ones merged where that changes no
    /// shape; points and motion are of all pieces. Without coarse steps, nothing is merged.
    fn solve(
        &self,
        number: usize,
        smoothing: Smoothing,
        start: &Start,
        observer: &mut dyn FnMut(&Progress) -> Control,
    ) -> Result<HomotopyStep, SolveError> {
        let Self { settings, workers, .. } = self;
        let fine = self.formulation(number);
        let error = if number <= settings.coarse_iterations() { smoothing.tau } else { ROUNDING };
        let merges = settings.coarse_iterations() > 0;
        let coarse = merges.then(|| CoarsePieces::within(error, fine, settings.complementarity)).flatten();
        let mut solver = IterationSolver { settings, smoothing, workers, observer };
        let Some(coarse) = coarse else { return solver.solve(fine, start) };
        let mut step = solver.solve(coarse.formulation(), &coarse.start_of(fine, start))?;
        step.iterate = coarse.fine_point(fine, &step.iterate);
        step.trajectory = fine.motion(&step.iterate.x, smoothing.tau);
        Ok(step)
    }

    /// Whether another homotopy step follows: fewer than requested have run, or less smoothing makes contact harder.
    fn continues(&self, ends: &[IterationEnd]) -> bool {
        if ends.len() < self.settings.iterations {
            return true;
        }
        let before = ends.len().checked_sub(2).map(|index| ends[index].motion);
        let last = ends[ends.len() - 1];
        last.converged && Penetration::of(self.fine.task(), last.motion, last.tau, before) == Penetration::Soft
    }
}

/// Checks that the installed Ipopt can run these settings, before anything is solved.
///
/// # Errors
/// When it refuses an option, or the linear solver cannot run.
pub fn check_settings(settings: &HomotopySettings) -> Result<(), SolveError> {
    let named = (settings.linear_solver != LinearSolver::Stage).then(|| settings.linear_solver.name());
    settings.schedule().take(1).try_for_each(|first| nlp::check(&options(settings, first), named))
}
