//! A robust plan: play the plan, refine what fails, play again.
//!
//! Of a solved problem's homotopy steps the one whose reference passes most training cases is taken, with an oscillation at
//! its end where these help. Random changes of this reference are kept when more test cases pass ([`simulation::Refinement`]).
//! Then an evaluation at grasp errors that were never trained on decides; what fails there is trained on next. When this
//! does not help any more, a straight push is refined instead, which needs no plan; then other problems are solved, the
//! promising first, and their plans are refined. The plan with the best evaluation is kept; where none is robust in the
//! end, the latest are compared in the same test cases. With an arm, the best of several drafts takes the place of a plan that
//! fails too often, no push is refined, and a robust plan is refined with margins while there is time.
//!
//! Time goes where it decides: evaluations end when they are decided, homotopy steps are compared in few test cases,
//! and every problem has its share of the time.

mod again;
mod candidate;
mod checkpoint;
mod comparison;
mod draft;
mod drafts;
mod ends;
mod evaluation;
mod evaluators;
mod loss;
mod margins;
mod origin;
mod portfolio;
mod push;
mod race;
mod resume;
mod schedule;
mod simplify;
mod tested;
mod training;
mod variants;

use std::collections::VecDeque;
use std::time::Duration;

use plan::ranges::require_threads;
use plan::{
    Event, Plan, PlannerError, Problem, RobustnessReport, RobustnessTarget, Round, Session, Stop, SuccessRates, Variant,
};
use simulation::{Evaluator, FinalOscillation, Reference, TestCase, TestResult};
use task::Trajectory;

use crate::candidate::{Candidate, Kept};
use crate::evaluation::{ErrorRange, Evaluation};
use crate::evaluators::evaluators;
use crate::loss::loss;
use crate::origin::{Origin, Solved};
use crate::schedule::{Deadline, Schedule};

pub use checkpoint::{BestRecord, RefinementCheckpoint, TestCaseRecord};
pub use evaluation::Drawn;
pub use tested::test;

/// Makes a plan robust. With a folder in the session, the best plan so far is kept there, and the refinement of an
/// earlier run of the same problem is continued.
///
/// # Errors
/// When the target is out of range, or a linear solver or a file fails. A plan that does not reach the target is one
/// whose status says so; a plan that was interrupted, or had no time to become whole, comes back as it is.
pub fn refine(plan: Plan, target: &RobustnessTarget, session: &Session) -> Result<Plan, PlannerError> {
    target.validate()?;
    require_threads(session.threads)?;
    if plan.stopped == Some(Stop::User) || plan.stopped.is_some() && !plan.is_converged() {
        return Ok(plan);
    }
    let mut world = plan.problem.world();
    let (problem, attempts, threads) = (plan.problem.clone(), plan.attempts.clone(), plan.threads);
    let [evaluator, trainer] = evaluators(&problem, target, &plan.reference(), session)?;
    let mut refiner = Refiner::new(&problem, target, (&evaluator, &trainer), session);
    let best = refiner.run(plan)?;
    let report = refiner.report(&best);
    // Reality is the problem's; only the grid of time is the reference's.
    world.horizon = best.reference.horizon();
    let tau = best.solved.iterations[best.solved.iterations.len() - 1].record.tau;
    // One friction in the plan is not what is shown: the least that is tolerated is.
    let mut shown = world.clone();
    if let [friction] = &mut shown.frictions[..] {
        *friction = target.least_friction();
    }
    let trajectory = problem.motions(&shown, &best.reference, tau)?;
    let Solved { variant, iterations, .. } = best.solved;
    let is_cut = report.unplayed > 0 || !report.reached && refiner.schedule.is_over(refiner.schedule.end());
    let stopped = if session.is_interrupted() { Some(Stop::User) } else { is_cut.then_some(Stop::TimeLimit) };
    let (task, robustness, tested) = (world, Some(report), None);
    Ok(Plan { problem, attempts, variant, iterations, trajectory, task, robustness, tested, threads, stopped })
}

/// Refines any reference of a problem in the same way for the whole time limit, but solves nothing: what the optimal
/// control problem is worth shows in comparison with [`refine`].
///
/// # Errors
/// When the target is out of range.
pub fn refine_reference(
    problem: &Problem,
    reference: Reference,
    target: &RobustnessTarget,
    session: &Session,
) -> Result<(Reference, RobustnessReport), PlannerError> {
    target.validate()?;
    require_threads(session.threads)?;
    let session = Session { folder: None, ..*session };
    let [evaluator, trainer] = evaluators(problem, target, &reference, &session)?;
    let mut refiner = Refiner::new(problem, target, (&evaluator, &trainer), &session);
    refiner.judge_first(Solved::new(Origin::Given, Variant::of_scene(problem), Vec::new()), reference)?;
    let until = refiner.schedule.end();
    while refiner.goes_on(until) {
        refiner.refine_best(until)?;
    }
    refiner.compare_latest()?;
    let best = refiner.take_best()?;
    Ok((best.reference.clone(), refiner.report(&best)))
}

/// The loop's state.
struct Refiner<'run> {
    problem: &'run Problem,
    target: &'run RobustnessTarget,
    /// What must be tolerated.
    range: ErrorRange,
    evaluator: &'run Evaluator,
    /// Of training cases.
    trainer: &'run Evaluator,
    session: &'run Session<'run>,
    /// Where dry friction may hold the body short of its goal.
    oscillation: Option<FinalOscillation>,
    /// Drafts that were not refined; at least one of their homotopy steps has all steps.
    drafts: Vec<Solved>,
    schedule: Schedule<'run>,
    /// Test cases that every reference is refined in; failures of evaluations are added.
    training: Vec<TestCase>,
    evaluations: u64,
    /// Changes of references that were tried.
    tried: usize,
    /// Of the changes of references.
    seed: u64,
    before: SuccessRates,
    rounds: Vec<Round>,
    best: Option<Kept>,
    /// The latest that were evaluated.
    latest: VecDeque<Kept>,
    /// Smallest fraction of training cases that failed after a refinement.
    least_failing: f64,
}

impl<'run> Refiner<'run> {
    fn new(
        problem: &'run Problem,
        target: &'run RobustnessTarget,
        (evaluator, trainer): (&'run Evaluator, &'run Evaluator),
        session: &'run Session<'run>,
    ) -> Self {
        let range = ErrorRange::new(problem, target);
        let (count, seed) = (target.parameters.training.random, target.parameters.seeds.first);
        let training = Evaluation::new(problem.task(), &range, &target.frictions, count, seed).into_training(&range);
        Self {
            problem,
            target,
            range,
            evaluator,
            trainer,
            session,
            oscillation: ends::final_oscillation(problem, target),
            drafts: Vec::new(),
            schedule: Schedule::new(session, target.time_limit, target.parameters.time),
            training,
            evaluations: 0,
            tried: 0,
            seed,
            before: SuccessRates(Vec::new()),
            rounds: Vec::new(),
            best: None,
            latest: VecDeque::new(),
            least_failing: 1.0,
        }
    }

    /// Refines the plan of the scene; where that is given up, a straight push; after each of the two the best so far again, if
    /// it is nearly robust; then the plans of other problems, and the best once more, while there is time. With an arm,
    /// no push is refined. What is not robust then is the best of the latest in a comparison; what is robust is simplified, or
    /// gets margins.
    fn run(&mut self, plan: Plan) -> Result<Kept, PlannerError> {
        let homotopy = plan.iterations.clone();
        let solving = homotopy.iter().map(|iteration| Duration::from_secs_f64(iteration.record.wall_s)).sum();
        self.refine_own(plan)?;
        self.refine_if_nearly_robust()?;
        if self.problem.arm().is_some() {
            // A straight push has never become robust with an arm.
            self.refine_again()?;
        } else {
            self.refine_push(homotopy)?;
            self.refine_if_nearly_robust()?;
        }
        self.refine_variants(solving)?;
        self.refine_again()?;
        self.compare_latest()?;
        self.simplify()?;
        self.add_margins()?;
        self.take_best()
    }

    /// Evaluates the plan of the scene and refines it unless it is good enough: refinement knows nothing of margins. Or
    /// goes on with what an earlier run has left.
    fn refine_own(&mut self, plan: Plan) -> Result<(), PlannerError> {
        if let Some(kept) = self.earlier_work()?.and_then(|checkpoint| self.restore(checkpoint, &plan)) {
            let count = plan.iterations.len();
            self.session.tell(Event::Resumed { done: count, most: count, refining: true });
            self.best = Some(kept);
            return self.refine_best(self.schedule.own());
        }
        let spent = plan.iterations.iter().map(|iteration| Duration::from_secs_f64(iteration.record.wall_s)).sum();
        let (last, chosen) = (plan.reference(), plan.chosen_stage());
        let solved = Solved { chosen, ..Solved::new(Origin::Scene, plan.variant, plan.iterations) };
        self.judge_first(solved.clone(), last)?;
        let until = self.schedule.own();
        if self.goes_on(until)
            && let Some(candidate) = self.candidate(solved, until)
        {
            self.rounds.clear();
            self.refine_better(candidate, spent)?;
        }
        Ok(())
    }

    /// Evaluates a reference that was not refined, and keeps it.
    fn judge_first(&mut self, solved: Solved, reference: Reference) -> Result<(), PlannerError> {
        let judgement = self.judge(&reference, self.schedule.end());
        let (rate, failing) = (judgement.rates.overall(), judgement.failing());
        if judgement.rates.rollouts() > 0 {
            self.session.tell(Event::Evaluated { rate });
        }
        self.before = judgement.rates.clone();
        let round = Round { rate: Some(rate), ..round(&solved, &[]) };
        let kept = Kept {
            solved,
            reference,
            rates: judgement.rates,
            reached: judgement.reached,
            evaluation: judgement.evaluation,
            unplayed: judgement.unplayed,
            failing,
            round: 1,
            changes: 0,
        };
        self.remember(kept.clone());
        self.keep_if_best(kept, &round)?;
        self.rounds.push(round);
        Ok(())
    }

    /// The candidate of a solved problem: of the homotopy steps with all steps, the one whose reference passes most
    /// training cases; of equals the later, which is smoothed less. `None` without such iterations or time.
    fn candidate(&self, solved: Solved, until: Deadline) -> Option<Candidate<'run>> {
        let fine = solved.with_all_steps();
        let references: Vec<Reference> =
            fine.iter().map(|&index| Reference::from(&solved.iterations[index].trajectory)).collect();
        let best = self.best_of(&references, until)?;
        let chosen = fine[best.winner.index] + 1;
        Some(self.candidate_of(best, Solved { chosen, ..solved }))
    }

    /// Keeps a plan if it is better than the best so far; `round` goes on.
    fn keep_if_best(&mut self, kept: Kept, round: &Round) -> Result<(), PlannerError> {
        if self.best.as_ref().is_some_and(|best| !kept.is_better_than(best)) {
            return Ok(());
        }
        self.keep(kept, self.rounds.iter().chain([round]).cloned().collect())
    }

    /// Keeps a plan in memory and in the session's folder.
    fn keep(&mut self, kept: Kept, rounds: Vec<Round>) -> Result<(), PlannerError> {
        if let Some(folder) = self.session.folder {
            let are_kept = self.best.as_ref().is_some_and(|best| best.round == kept.round);
            if !kept.solved.origin.has_homotopy_of_scene() && !are_kept {
                let motions: Vec<&Trajectory> =
                    kept.solved.iterations.iter().map(|iteration| &iteration.trajectory).collect();
                folder.keep_refined(kept.round, &motions, &kept.solved.variant.task)?;
            }
            self.checkpoint(&kept, rounds).save(folder)?;
        }
        self.best = Some(kept);
        Ok(())
    }

    /// Whether there is something to do and time to do it.
    fn goes_on(&self, until: Deadline) -> bool {
        let is_robust = self.best.as_ref().is_some_and(|best| best.reached);
        !is_robust && self.may_change() && !self.schedule.is_over(until)
    }

    /// Whether changes are wanted, and not all of them have been tried.
    fn may_change(&self) -> bool {
        self.target.stall_limit > 0 && self.target.max_perturbations.is_none_or(|most| self.tried < most)
    }

    fn take_best(&mut self) -> Result<Kept, PlannerError> {
        self.best.take().ok_or(PlannerError::Internal("no plan was evaluated"))
    }

    fn report(&self, best: &Kept) -> RobustnessReport {
        RobustnessReport {
            target_rate: self.target.target_rate,
            reached: best.reached,
            rate_before: self.before.overall(),
            rate_after: best.rates.overall(),
            wall_s: self.schedule.total().as_secs_f64(),
            before: self.before.clone(),
            after: best.rates.clone(),
            unplayed: best.unplayed,
            push: self.judge_push(best),
            kept_round: best.round,
            kept_stage: best.solved.chosen,
            kept_changes: best.changes,
            rounds: self.rounds.clone(),
            loss: loss(self.problem, self.target, best),
            parameters: self.target.parameters.clone(),
        }
    }
}

/// A round whose homotopy has run and whose chosen reference is still to be refined; with its results in the training cases.
fn round(solved: &Solved, results: &[TestResult]) -> Round {
    let Solved { variant, iterations, chosen, .. } = solved;
    Round::new(solved.planned(), variant, iterations, *chosen, results)
}

#[cfg(test)]
pub(crate) mod tests {
    use std::sync::atomic::AtomicBool;

    use plan::Choices;

    use super::*;

    /// The file of the corner scene.
    pub(crate) fn corner() -> std::path::PathBuf {
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml")
    }

    impl Refiner<'_> {
        /// The scene as it is, of which nothing was solved.
        pub(super) fn of_scene(&self) -> Solved {
            Solved::new(Origin::Scene, Variant::of_scene(self.problem), Vec::new())
        }
    }

    /// Hands over a refiner of the corner scene without friction, before its first plan. It has no stall_limit.
    pub(super) fn in_corner<T>(time_limit: Duration, work: impl FnOnce(&mut Refiner) -> T) -> T {
        in_corner_for(RobustnessTarget { time_limit, stall_limit: 1, ..RobustnessTarget::default() }, work)
    }

    /// Hands over a refiner of the corner scene without friction, before its first plan.
    pub(super) fn in_corner_for<T>(target: RobustnessTarget, work: impl FnOnce(&mut Refiner) -> T) -> T {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let target = RobustnessTarget { frictions: vec![0.0], ..target };
        let evaluator = problem.evaluator(&target.frictions).unwrap();
        let interrupted = AtomicBool::new(false);
        let session = Session::new(&|_: &Event| {}, &interrupted);
        work(&mut Refiner::new(&problem, &target, (&evaluator, &evaluator), &session))
    }
}
