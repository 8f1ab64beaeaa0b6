//! `solve --robust`: plan, play, refine what fails, play again.
//!
//! Of a solved problem's homotopy iterations the one whose reference passes most training trials is taken. Random changes
//! of this reference are kept when more trials pass ([`simulation::Refinement`]). Then an [`exam`] with offsets that were
//! never trained on decides; what fails there is trained on next. When refinement is stuck, a [`mod@portfolio`] of other
//! problems is solved side by side, and these are refined, the best first. The plan with the best exam is kept.

mod candidate;
mod exam;
mod plan;
mod portfolio;
mod report;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use nlp::SolveStatus;
use ocp::HomotopyIteration;
use simulation::{Evaluator, Reference, Refinement, Trial, in_parallel};
use task::{AssemblyTask, HomotopySettings, LinearSolver};

use crate::failure::Failure;
use crate::progress::Progress;
use crate::robust::candidate::{Candidate, Kept, played};
use crate::robust::exam::{Exam, Mark, rate};
pub use crate::robust::plan::plan_robustly;
use crate::robust::portfolio::{Variant, portfolio};
pub use crate::robust::report::Report;
use crate::robust::report::Round;

/// Random offsets per friction and magnitude to train with at first, and in an exam: what fails there is trained on next,
/// so that few are needed at first.
const TRAINING: usize = 4;
const EXAM: usize = 50;
/// Misses that shrink to more than this part are no improvement: refinement could creep until the time is over.
const CREEPING: f64 = 0.99;
/// Seed of training offsets and changes; exams have the seeds after it.
const SEED: u64 = 1;
/// Distance between seeds: an exam has one per magnitude.
const SEED_STRIDE: u64 = 100;

/// What the user wants.
pub struct Wishes {
    /// Rate of success of all rollouts together.
    pub rate: f64,
    /// When to stop refining.
    pub time_limit: Duration,
    /// Attempts in a row without improvement after which refinement is stuck.
    pub patience: usize,
    /// Largest turn of the part in the gripper (rad).
    pub turn: f64,
    /// Coulomb coefficients to play with.
    pub frictions: Vec<f64>,
    /// Threads of rollouts.
    pub jobs: usize,
}

/// The best plan.
pub struct RobustPlan {
    /// The homotopy that it comes from.
    pub stages: Vec<HomotopyIteration>,
    /// The refined reference.
    pub reference: Reference,
    pub report: Report,
}

/// Solves a variant, says so while it does if it runs alone, and gives up when its last argument says so.
pub trait Solve: Fn(&Variant, bool, &dyn Fn() -> bool) -> Result<Vec<HomotopyIteration>, Failure> + Sync {}
impl<F: Fn(&Variant, bool, &dyn Fn() -> bool) -> Result<Vec<HomotopyIteration>, Failure> + Sync> Solve for F {}

/// The loop's state.
pub struct Robust<'run> {
    task: &'run AssemblyTask,
    settings: &'run HomotopySettings,
    delta: f64,
    wishes: Wishes,
    examiner: &'run Evaluator,
    progress: &'run Progress,
    interrupted: &'run AtomicBool,
    begin: Instant,
    /// Trials that every reference is refined in; failures of exams are added.
    training: Vec<Trial>,
    exams: u64,
    before: Vec<Mark>,
    rounds: Vec<Round>,
}

impl<'run> Robust<'run> {
    /// For a task to plan, its homotopy, and an examiner with the wished frictions, whose world may have more pairs.
    pub fn new(
        (task, settings): (&'run AssemblyTask, &'run HomotopySettings),
        examiner: &'run Evaluator,
        delta: f64,
        wishes: Wishes,
        progress: &'run Progress,
        interrupted: &'run AtomicBool,
    ) -> Self {
        Self {
            task,
            settings,
            delta,
            examiner,
            progress,
            interrupted,
            begin: Instant::now(),
            training: Exam::new(task, (delta, wishes.turn), &wishes.frictions, TRAINING, SEED).trials,
            wishes,
            exams: 0,
            before: Vec::new(),
            rounds: Vec::new(),
        }
    }

    /// Plans the scene and refines the plan; where that does not reach the wanted rate, the portfolio's.
    ///
    /// # Errors
    /// What `solve` reports.
    pub fn run(mut self, solve: &impl Solve) -> Result<RobustPlan, Failure> {
        let scene = Variant::scene(self.task, self.settings);
        // Without any plan there is nothing that a time limit could keep.
        let stages = solve(&scene, true, &|| false)?;
        self.before = self.examine(&played(&stages[stages.len() - 1])).1;
        self.progress.say(&format!("{:.1} % of rollouts succeed", 100.0 * rate(&self.before)));
        let mut best = self.first(&scene, stages);
        if !self.is_enough(&best.marks) && !self.is_over() {
            for candidate in self.solve_portfolio(&scene, &best, solve)? {
                if self.is_enough(&best.marks) || self.is_over() {
                    self.rounds.push(candidate.round);
                } else {
                    let other = self.refine(candidate);
                    if rate(&other.marks) > rate(&best.marks) {
                        best = other;
                    }
                }
            }
        }
        let seconds = self.begin.elapsed().as_secs_f64();
        let report = Report::new(self.wishes.rate, seconds, (self.before, best.marks), best.round, self.rounds);
        Ok(RobustPlan { stages: best.stages, reference: best.reference, report })
    }

    /// The plan of the scene, refined unless it is good enough: refinement knows nothing of margins.
    fn first(&mut self, scene: &Variant, stages: Vec<HomotopyIteration>) -> Kept {
        if !self.is_enough(&self.before) {
            return self.refine(self.candidate(scene, stages));
        }
        let reference = played(&stages[stages.len() - 1]);
        let training = self.training.clone();
        let judged = Refinement::new(self.examiner, reference.clone(), training, SEED, self.wishes.jobs);
        let round = Round { rate: Some(rate(&self.before)), ..Round::new(scene, &stages, stages.len(), &judged) };
        self.rounds.push(round);
        let marks = self.before.clone();
        Kept { stages, reference, marks, failing: Vec::new(), round: self.rounds.len() }
    }

    /// Solves variants side by side, as many as there is time for; what passes most training trials comes first.
    fn solve_portfolio(
        &self,
        scene: &Variant,
        refined: &Kept,
        solve: &impl Solve,
    ) -> Result<Vec<Candidate<'run>>, Failure> {
        let variants = portfolio(scene, &refined.reference, &refined.failing);
        self.progress.say(&format!("refinement is stuck; solving {} variants of the problem", variants.len()));
        // MUMPS cannot run twice in a process.
        let solvers = if self.settings.linear_solver == LinearSolver::Stage { self.wishes.jobs } else { 1 };
        // Half of the time left is for refining them.
        let (begin, budget) = (Instant::now(), self.wishes.time_limit.saturating_sub(self.begin.elapsed()) / 2);
        let is_over = || self.is_over() || begin.elapsed() > budget;
        let solved = in_parallel(variants.len(), solvers, |index| -> Result<Vec<HomotopyIteration>, Failure> {
            if is_over() {
                return Ok(Vec::new());
            }
            let stages = solve(&variants[index], false, &is_over)?;
            self.progress.say(&format!("  {}: {}", variants[index].name, stages[stages.len() - 1].status));
            Ok(stages)
        });
        let mut candidates = Vec::with_capacity(variants.len());
        for (variant, stages) in variants.iter().zip(solved) {
            // What an interrupted homotopy has finished may do.
            let mut stages = stages?;
            stages.retain(|stage| stage.status != SolveStatus::Interrupted);
            if stages.is_empty() {
                continue;
            }
            let candidate = self.candidate(variant, stages);
            let (failing, count) = (candidate.round.training_failures, self.training.len());
            self.progress.say(&format!("  {}: {failing} of {count} training rollouts fail", variant.name));
            candidates.push(candidate);
        }
        candidates.sort_by_key(|candidate| candidate.round.training_failures);
        Ok(candidates)
    }

    fn candidate(&self, variant: &Variant, stages: Vec<HomotopyIteration>) -> Candidate<'run> {
        Candidate::new(variant, stages, self.examiner, &self.training, (SEED, self.wishes.jobs))
    }

    /// Refines a reference and examines it, until it is good enough, stuck, or the time is over.
    fn refine(&mut self, candidate: Candidate<'run>) -> Kept {
        let begin = Instant::now();
        let Candidate { stages, mut refinement, mut round } = candidate;
        self.progress.say(&format!("refining: {}", round.planned));
        let mut best: Option<(Reference, Vec<Mark>, Vec<Trial>)> = None;
        loop {
            let passes = self.train(&mut refinement, &mut round.changes);
            let (failures, marks) = self.examine(refinement.reference());
            self.progress.say(&format!("  {:.1} % succeed at offsets not trained on", 100.0 * rate(&marks)));
            let is_last = self.is_enough(&marks) || !passes || self.is_over();
            if best.as_ref().is_none_or(|(_, best, _)| rate(&marks) > rate(best)) {
                best = Some((refinement.reference().clone(), marks, failures.clone()));
            }
            if is_last {
                break;
            }
            round.added_trials += failures.len();
            refinement.add(&failures);
            self.training.extend(failures);
        }
        let (reference, marks, failures) = best.expect("an exam was held");
        let failing = failures.iter().map(|trial| trial.grasp.offset).collect();
        round.rate = Some(rate(&marks));
        round.refinement_s = begin.elapsed().as_secs_f64();
        self.rounds.push(round);
        Kept { stages, reference, marks, failing, round: self.rounds.len() }
    }

    /// Improves until all training trials pass, which is what it returns, or it is stuck or the time is over.
    fn train(&self, refinement: &mut Refinement, changes: &mut usize) -> bool {
        let (mut vain, mut last) = (0, refinement.score());
        while refinement.score().0 > 0 && vain < self.wishes.patience && !self.is_over() {
            *changes += usize::from(refinement.improve(self.wishes.jobs, &|| self.is_over()));
            let (failing, miss) = refinement.score();
            if failing < last.0 || miss < CREEPING * last.1 {
                (vain, last) = (0, (failing, miss));
            } else {
                vain += 1;
            }
            self.progress.refinement(failing, refinement.trials().len(), *changes);
        }
        refinement.score().0 == 0
    }

    /// Plays new offsets: what fails, and the marks.
    fn examine(&mut self, reference: &Reference) -> (Vec<Trial>, Vec<Mark>) {
        self.exams += 1;
        let seed = SEED + SEED_STRIDE * self.exams;
        let exam = Exam::new(self.task, (self.delta, self.wishes.turn), &self.wishes.frictions, EXAM, seed);
        let verdicts = self.examiner.evaluate_all(reference, &exam.trials, self.wishes.jobs);
        let failures =
            exam.trials.iter().zip(&verdicts).filter(|(_, verdict)| !verdict.passed).map(|(trial, _)| *trial);
        (failures.collect(), exam.marks(&verdicts))
    }

    fn is_enough(&self, marks: &[Mark]) -> bool {
        rate(marks) >= self.wishes.rate
    }

    fn is_over(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed) || self.begin.elapsed() > self.wishes.time_limit
    }
}
