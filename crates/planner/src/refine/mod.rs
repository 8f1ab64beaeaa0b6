//! A robust plan: play the plan, refine what fails, play again.
//!
//! Of a solved problem's homotopy iterations the one whose reference passes most training trials is taken. Random changes
//! of this reference are kept when more trials pass ([`simulation::Refinement`]). Then an evaluation at grasp errors
//! that were never trained on decides; what fails there is trained on next. When refinement is stuck, a
//! portfolio of other problems is solved side by side, and these are refined, the best first. The plan with the
//! best evaluation is kept.

mod candidate;
mod evaluation;
mod portfolio;
mod resume;
mod target;

use std::time::{Duration, Instant};

use nlp::Control;
use simulation::{Evaluator, Reference, Refinement, Rollout, Settings, Trial, in_parallel};
use task::LinearSolver;

use crate::error::PlannerError;
use crate::iteration::PlanIteration;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::refine::candidate::{Candidate, Kept, Training};
use crate::refine::evaluation::{Evaluation, GraspTolerance};
use crate::refine::portfolio::portfolio;
use crate::robustness::{RobustnessReport, Round};
use crate::session::{Event, Session};
use crate::solve::run_homotopy;
use crate::success_rates::SuccessRates;
use crate::variant::Variant;

pub use target::RobustnessTarget;
pub(crate) use target::{require, require_frictions, require_threads, require_turn};

/// Random offsets per friction and magnitude to train with at first: what fails in an evaluation is trained on next, so
/// that few are needed.
const TRAINING: usize = 4;
/// Random offsets per friction and magnitude of an evaluation.
const EVALUATION: usize = 50;
/// Misses that shrink by less than this factor are no improvement: refinement could creep until the time is over.
const CREEPING: f64 = 0.99;
/// Seed of training offsets and changes; evaluations have the seeds after it.
const SEED: u64 = 1;
/// Distance between the seeds of evaluations, which need one per magnitude.
const SEED_STRIDE: u64 = 100;

/// Makes a plan robust. With a folder in the session, the best plan so far is kept there, and the refinement of an
/// earlier run of the same problem is continued.
///
/// # Errors
/// When the target is out of range, or a linear solver or a file fails. A plan that does not reach the target is one
/// whose status says so; a plan that was interrupted comes back as it is.
pub fn refine(plan: Plan, target: &RobustnessTarget, session: &Session) -> Result<Plan, PlannerError> {
    target.validate()?;
    if plan.interrupted {
        return Ok(plan);
    }
    let mut world = plan.problem.world();
    let evaluator = Evaluator::new(&world, &target.frictions, plan.problem.success());
    let problem = plan.problem.clone();
    let mut refiner = Refiner::new(&problem, target, &evaluator, session);
    let best = refiner.run(plan)?;
    let report = refiner.report(&best);
    // Reality is the problem's; only the grid of time is the variant's.
    world.horizon = best.variant.task.horizon;
    let tau = best.iterations[best.iterations.len() - 1].record.tau;
    let rollout = Rollout::new(&world, Settings { friction: target.least_friction(), ..Settings::default() });
    let trajectory = rollout.trajectory(&best.reference, &world.offsets, tau);
    let Kept { variant, iterations, .. } = best;
    let (robustness, interrupted) = (Some(report), session.is_interrupted());
    Ok(Plan { problem, variant, iterations, trajectory, task: world, robustness, interrupted })
}

/// The loop's state.
struct Refiner<'run> {
    problem: &'run Problem,
    target: &'run RobustnessTarget,
    evaluator: &'run Evaluator,
    session: &'run Session<'run>,
    begin: Instant,
    /// Time that was spent before.
    spent: Duration,
    /// Trials that every reference is refined in; failures of evaluations are added.
    training: Vec<Trial>,
    evaluations: u64,
    /// Of the changes of references.
    seed: u64,
    before: SuccessRates,
    rounds: Vec<Round>,
    best: Option<Kept>,
}

impl<'run> Refiner<'run> {
    fn new(
        problem: &'run Problem,
        target: &'run RobustnessTarget,
        evaluator: &'run Evaluator,
        session: &'run Session<'run>,
    ) -> Self {
        let tolerance = GraspTolerance { delta: problem.delta(), turn: target.turn };
        Self {
            problem,
            target,
            evaluator,
            session,
            begin: Instant::now(),
            spent: Duration::ZERO,
            training: Evaluation::new(problem.task(), tolerance, &target.frictions, TRAINING, SEED).trials,
            evaluations: 0,
            seed: SEED,
            before: SuccessRates(Vec::new()),
            rounds: Vec::new(),
            best: None,
        }
    }

    /// Refines the plan of the scene and, where that does not reach the target, those of the portfolio.
    fn run(&mut self, plan: Plan) -> Result<Kept, PlannerError> {
        self.begin(plan)?;
        if self.goes_on() {
            for candidate in self.solve_portfolio()? {
                if self.goes_on() {
                    self.refine(candidate)?;
                } else {
                    self.rounds.push(candidate.round);
                }
            }
        }
        self.best.take().ok_or(PlannerError::Internal("no plan was evaluated"))
    }

    /// Evaluates the plan of the scene and refines it unless it is good enough: refinement knows nothing of margins. Or
    /// goes on with what an earlier run has left.
    fn begin(&mut self, plan: Plan) -> Result<(), PlannerError> {
        if let Some(kept) = self.earlier_work()?.and_then(|checkpoint| self.restore(checkpoint, &plan)) {
            self.session.tell(Event::Resumed {
                done: plan.iterations.len(),
                most: plan.iterations.len(),
                refining: true,
            });
            self.best = Some(kept.clone());
            return if self.goes_on() {
                self.refine(Candidate::resumed(kept, self.training(), &self.training))
            } else {
                Ok(())
            };
        }
        self.spent = plan.iterations.iter().map(|iteration| Duration::from_secs_f64(iteration.record.wall_s)).sum();
        let (last, chosen) = (plan.reference(), plan.chosen_stage());
        let (_, before) = self.evaluate(&last);
        self.before = before.clone();
        self.session.tell(Event::Evaluated { rate: before.overall() });
        let Plan { variant, iterations, .. } = plan;
        if !before.satisfy(self.target.wanted_rate) {
            let candidate = Candidate::best_of(variant, iterations, self.training(), &self.training, true);
            return self.refine(candidate);
        }
        let refinement = self.training().refinement(last.clone(), &self.training);
        let rate = Some(before.overall());
        self.rounds.push(Round { rate, ..Round::new(&variant, &iterations, chosen, &refinement) });
        self.best = Some(Kept {
            variant,
            iterations,
            reference: last,
            rates: before,
            failing: Vec::new(),
            round: 1,
            is_scenes_own: true,
        });
        Ok(())
    }

    /// Refines a reference and evaluates it, until it is good enough, stuck, or the time is over.
    fn refine(&mut self, candidate: Candidate<'run>) -> Result<(), PlannerError> {
        let begin = Instant::now();
        let Candidate { variant, iterations, mut refinement, mut round, is_scenes_own } = candidate;
        self.session.tell(Event::Refining { planned: &round.planned });
        loop {
            let passes = self.train(&mut refinement, &mut round.changes);
            let (failures, rates) = self.evaluate(refinement.reference());
            self.session.tell(Event::Refined { rate: rates.overall() });
            let is_last = rates.satisfy(self.target.wanted_rate) || !passes || self.is_over();
            round.rate = Some(round.rate.map_or(rates.overall(), |rate| rate.max(rates.overall())));
            round.refinement_s = begin.elapsed().as_secs_f64();
            let kept = Kept {
                variant: variant.clone(),
                iterations: iterations.clone(),
                reference: refinement.reference().clone(),
                failing: failures.iter().map(|trial| trial.grasp.offset).collect(),
                rates,
                round: self.rounds.len() + 1,
                is_scenes_own,
            };
            self.keep_if_best(kept, &round)?;
            if is_last {
                break;
            }
            round.added_trials += failures.len();
            refinement.add(&failures);
            self.training.extend(failures);
        }
        self.rounds.push(round);
        Ok(())
    }

    /// Improves until all training trials pass, which is what it returns, or it is stuck or the time is over.
    fn train(&self, refinement: &mut Refinement, changes: &mut usize) -> bool {
        let (mut vain, mut last) = (0, refinement.score());
        while refinement.score().0 > 0 && vain < self.target.patience && !self.is_over() {
            *changes += usize::from(refinement.improve(self.target.threads, &|| self.is_over()));
            let (failing, miss) = refinement.score();
            if failing < last.0 || miss < CREEPING * last.1 {
                (vain, last) = (0, (failing, miss));
            } else {
                vain += 1;
            }
            self.session.tell(Event::Change { failing, trials: refinement.trials().len(), changes: *changes });
        }
        refinement.score().0 == 0
    }

    /// Plays new grasp errors: what fails, and the success rates.
    fn evaluate(&mut self, reference: &Reference) -> (Vec<Trial>, SuccessRates) {
        self.evaluations += 1;
        let seed = SEED + SEED_STRIDE * self.evaluations;
        let tolerance = GraspTolerance { delta: self.problem.delta(), turn: self.target.turn };
        let evaluation = Evaluation::new(self.problem.task(), tolerance, &self.target.frictions, EVALUATION, seed);
        let results = self.evaluator.evaluate_all(reference, &evaluation.trials, self.target.threads);
        let failures = evaluation.trials.iter().zip(&results).filter(|(_, result)| !result.passed);
        (failures.map(|(trial, _)| *trial).collect(), evaluation.rates(&results))
    }

    /// Keeps a plan in memory and in the session's folder if it is better than the best so far.
    fn keep_if_best(&mut self, kept: Kept, round: &Round) -> Result<(), PlannerError> {
        let wanted = self.target.wanted_rate;
        if self.best.as_ref().is_some_and(|best| !kept.rates.are_better_than(&best.rates, wanted)) {
            return Ok(());
        }
        if let Some(folder) = self.session.folder {
            let rounds = self.rounds.iter().chain([round]).cloned().collect();
            let are_kept = self.best.as_ref().is_some_and(|best| best.round == kept.round);
            if !kept.is_scenes_own && !are_kept {
                let motions = kept.iterations.iter().map(|iteration| &iteration.trajectory);
                folder.keep_refined_iterations(kept.round, motions, &kept.variant.task)?;
            }
            folder.keep_refinement(&self.checkpoint(&kept, rounds))?;
        }
        self.best = Some(kept);
        Ok(())
    }

    /// Solves variants side by side, as many as there is time for; what passes most training trials comes first.
    fn solve_portfolio(&self) -> Result<Vec<Candidate<'run>>, PlannerError> {
        let Some(best) = &self.best else { return Ok(Vec::new()) };
        let variants = portfolio(&Variant::of_scene(self.problem), &best.reference, &best.failing);
        self.session.tell(Event::Variants { count: variants.len() });
        // MUMPS cannot run twice in a process.
        let own_solver = self.problem.homotopy().linear_solver == LinearSolver::Stage;
        let solvers = if own_solver { self.target.threads } else { 1 };
        // Half of the time left is for refining them.
        let (begin, budget) = (Instant::now(), self.target.time_limit.saturating_sub(self.elapsed()) / 2);
        let is_over = || self.is_over() || begin.elapsed() > budget;
        let solved = in_parallel(variants.len(), solvers, |index| -> Result<_, PlannerError> {
            if is_over() {
                return Ok(Vec::new());
            }
            let observe = |_: &ocp::Event| if is_over() { Control::Stop } else { Control::Continue };
            let iterations = run_homotopy(&variants[index], &[], None, observe, |_, _| {})?;
            let status = iterations.last().map_or_else(String::new, |last| last.status.to_string());
            self.session.tell(Event::VariantSolved { name: &variants[index].name, status: &status });
            Ok(iterations)
        });
        let mut candidates = Vec::with_capacity(variants.len());
        for (variant, iterations) in variants.into_iter().zip(solved) {
            // What an interrupted homotopy has finished may do.
            let finished =
                iterations?.into_iter().filter(|iteration| iteration.status != nlp::SolveStatus::Interrupted);
            let iterations: Vec<PlanIteration> = finished.map(PlanIteration::from).collect();
            if iterations.iter().all(|iteration| iteration.record.is_coarse(&variant.task)) {
                continue;
            }
            let candidate = Candidate::best_of(variant, iterations, self.training(), &self.training, false);
            let (failing, trials) = (candidate.round.training_failures, self.training.len());
            self.session.tell(Event::VariantTried { name: &candidate.round.planned, failing, trials });
            candidates.push(candidate);
        }
        candidates.sort_by_key(|candidate| candidate.round.training_failures);
        Ok(candidates)
    }

    fn training(&self) -> Training<'run> {
        Training { evaluator: self.evaluator, seed: self.seed, threads: self.target.threads }
    }

    fn goes_on(&self) -> bool {
        let is_robust = self.best.as_ref().is_some_and(|best| best.rates.satisfy(self.target.wanted_rate));
        !is_robust && !self.is_over()
    }

    fn elapsed(&self) -> Duration {
        self.spent + self.begin.elapsed()
    }

    fn is_over(&self) -> bool {
        self.session.is_interrupted() || self.elapsed() > self.target.time_limit
    }

    fn report(&self, best: &Kept) -> RobustnessReport {
        RobustnessReport {
            wanted_rate: self.target.wanted_rate,
            reached: best.rates.satisfy(self.target.wanted_rate),
            rate_before: self.before.overall(),
            rate_after: best.rates.overall(),
            wall_s: self.elapsed().as_secs_f64(),
            before: self.before.clone(),
            after: best.rates.clone(),
            kept_round: best.round,
            rounds: self.rounds.clone(),
        }
    }
}
