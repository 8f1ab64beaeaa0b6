//! `solve --robust`: plan, play, refine what fails, play again.
//!
//! A round solves one planning problem ([`variants`]) and takes the homotopy iteration whose reference passes most
//! training trials. Random changes of this reference are kept when more trials pass ([`simulation::Refinement`]). Then an
//! [`exam`] with offsets that were never trained on decides; what fails there is trained on next. When refinement is
//! stuck, the next round plans something else. The plan with the best exam is kept.

mod exam;
mod plan;
mod report;
mod variants;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use nlp::SolveStatus;
use ocp::{AssemblyTask, StageResult};
use simulation::{Examiner, Reference, Refinement, Trial};

use crate::failure::Failure;
use crate::progress::Progress;
use crate::robust::exam::{Exam, Mark, rate};
pub use crate::robust::plan::plan_robustly;
pub use crate::robust::report::Report;
use crate::robust::report::Round;
use crate::robust::variants::{VARIANTS, Variant, variant};

/// Random offsets per friction and magnitude to train with at first, and in an exam: what fails there is trained on next,
/// so that few are needed at first.
const TRAINING: usize = 4;
const EXAM: usize = 50;
/// Attempts in a row without improvement after which refinement is stuck.
const PATIENCE: usize = 150;
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
    /// Coulomb coefficients to play with.
    pub frictions: Vec<f64>,
    /// Threads of rollouts.
    pub jobs: usize,
}

/// The best plan.
pub struct RobustPlan {
    /// The homotopy that it comes from.
    pub stages: Vec<StageResult>,
    /// The refined reference.
    pub reference: Reference,
    pub report: Report,
}

/// A plan, its exam and its round.
struct Kept {
    stages: Vec<StageResult>,
    reference: Reference,
    marks: Vec<Mark>,
    round: usize,
}

/// The loop's state.
pub struct Robust<'run> {
    task: &'run AssemblyTask,
    delta: f64,
    wishes: Wishes,
    examiner: &'run Examiner,
    progress: &'run Progress,
    interrupted: &'run AtomicBool,
    begin: Instant,
    /// Trials that every reference is refined in; failures of exams are added.
    training: Vec<Trial>,
    /// Failing offsets (m) of the best exam.
    failing: Vec<[f64; 3]>,
    exams: u64,
    before: Vec<Mark>,
    kept: Option<Kept>,
    rounds: Vec<Round>,
}

impl<'run> Robust<'run> {
    /// For a task to plan and an examiner with the wished frictions, whose world may have more pairs.
    pub fn new(
        task: &'run AssemblyTask,
        examiner: &'run Examiner,
        delta: f64,
        wishes: Wishes,
        progress: &'run Progress,
        interrupted: &'run AtomicBool,
    ) -> Self {
        let training = Exam::new(task, delta, &wishes.frictions, TRAINING, SEED).trials;
        Self {
            task,
            delta,
            wishes,
            examiner,
            progress,
            interrupted,
            begin: Instant::now(),
            training,
            failing: Vec::new(),
            exams: 0,
            before: Vec::new(),
            kept: None,
            rounds: Vec::new(),
        }
    }

    /// Goes through the rounds until one reaches the wanted rate or the time is over. `solve` runs the homotopy of a task
    /// and gives up when its second argument says so.
    ///
    /// # Errors
    /// What `solve` reports.
    pub fn run(
        mut self,
        mut solve: impl FnMut(&AssemblyTask, &dyn Fn() -> bool) -> Result<Vec<StageResult>, Failure>,
    ) -> Result<RobustPlan, Failure> {
        for round in 0..VARIANTS {
            let Variant { task, name } = variant(self.task, round, &self.failing);
            self.progress.say(&format!("round {}: {name}, {} scenarios", round + 1, task.offsets.len()));
            // Without any plan there is nothing that a time limit could keep.
            let stages = solve(&task, &|| self.kept.is_some() && self.is_over())?;
            let is_whole = stages.last().is_some_and(|last| last.status != SolveStatus::Interrupted);
            if is_whole || self.kept.is_none() {
                self.refine(name, &task, stages);
            }
            if self.is_over() || self.kept.as_ref().is_some_and(|kept| rate(&kept.marks) >= self.wishes.rate) {
                break;
            }
        }
        let Some(Kept { stages, reference, marks, round }) = self.kept else {
            return Err(Failure::Internal("no round has led to a plan".to_owned()));
        };
        let seconds = self.begin.elapsed().as_secs_f64();
        let report = Report::new(self.wishes.rate, seconds, (self.before, marks), round, self.rounds);
        Ok(RobustPlan { stages, reference, report })
    }

    /// Refines the best reference of a homotopy and examines it, until it is good enough, stuck, or the time is over.
    fn refine(&mut self, name: &'static str, task: &AssemblyTask, stages: Vec<StageResult>) {
        let begin = Instant::now();
        if self.before.is_empty() {
            self.before = self.examine(&reference(&stages[stages.len() - 1])).1;
            self.progress.say(&format!("  {:.1} % of rollouts succeed", 100.0 * rate(&self.before)));
        }
        let mut round = Round::new(name, task, &stages, self.training.len());
        let (stage, mut refinement) = self.best_stage(&stages);
        round.chosen_stage = stage + 1;
        let mut best: Option<(Reference, Vec<Mark>)> = None;
        if self.rounds.is_empty() && rate(&self.before) >= self.wishes.rate {
            // A plan that is good enough is left alone: refinement knows nothing of its margins.
            round.chosen_stage = stages.len();
            round.rate = rate(&self.before);
            best = Some((reference(&stages[stages.len() - 1]), self.before.clone()));
        }
        while best.as_ref().is_none_or(|(_, marks)| rate(marks) < self.wishes.rate) {
            let passes = self.train(&mut refinement, &mut round.changes);
            let (failures, marks) = self.examine(refinement.reference());
            let current = rate(&marks);
            self.progress.say(&format!("  {:.1} % succeed at offsets not trained on", 100.0 * current));
            if best.as_ref().is_none_or(|(_, marks)| current > rate(marks)) {
                round.rate = current;
                self.failing = failures.iter().map(|trial| trial.offset).collect();
                best = Some((refinement.reference().clone(), marks));
            }
            if current >= self.wishes.rate || !passes || self.is_over() {
                break;
            }
            round.added_trials += failures.len();
            refinement.add(&failures);
            self.training.extend(failures);
        }
        round.refinement_s = begin.elapsed().as_secs_f64();
        let kept_rate = self.kept.as_ref().map(|kept| rate(&kept.marks));
        if let Some((reference, marks)) = best.filter(|(_, marks)| kept_rate.is_none_or(|kept| rate(marks) > kept)) {
            self.kept = Some(Kept { stages, reference, marks, round: self.rounds.len() + 1 });
        }
        self.rounds.push(round);
    }

    /// The homotopy iteration, from 0, whose reference passes most training trials; of equals the later, which is
    /// smoothed less.
    fn best_stage(&self, stages: &[StageResult]) -> (usize, Refinement<'run>) {
        let seed = SEED + self.rounds.len() as u64;
        let judged = stages.iter().map(|stage| {
            Refinement::new(self.examiner, reference(stage), self.training.clone(), seed, self.wishes.jobs)
        });
        let best = judged.enumerate().min_by(|(one_stage, one), (other_stage, other)| {
            one.score().0.cmp(&other.score().0).then(other_stage.cmp(one_stage))
        });
        best.expect("a homotopy has an iteration")
    }

    /// Improves until all training trials pass, which is what it returns, or it is stuck or the time is over.
    fn train(&self, refinement: &mut Refinement, changes: &mut usize) -> bool {
        let mut vain = 0;
        while refinement.score().0 > 0 && vain < PATIENCE && !self.is_over() {
            let improved = refinement.improve(self.wishes.jobs, &|| self.is_over());
            vain = if improved { 0 } else { vain + 1 };
            *changes += usize::from(improved);
            self.progress.refinement(refinement.score().0, refinement.trials().len(), *changes);
        }
        refinement.score().0 == 0
    }

    /// Plays new offsets: what fails, and the marks.
    fn examine(&mut self, reference: &Reference) -> (Vec<Trial>, Vec<Mark>) {
        self.exams += 1;
        let seed = SEED + SEED_STRIDE * self.exams;
        let exam = Exam::new(self.task, self.delta, &self.wishes.frictions, EXAM, seed);
        let verdicts = self.examiner.judge_all(reference, &exam.trials, self.wishes.jobs);
        let failures =
            exam.trials.iter().zip(&verdicts).filter(|(_, verdict)| !verdict.passed).map(|(trial, _)| *trial);
        (failures.collect(), exam.marks(&verdicts))
    }

    fn is_over(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed) || self.begin.elapsed() > self.wishes.time_limit
    }
}

fn reference(stage: &StageResult) -> Reference {
    Reference::new(stage.trajectory.time_step, &stage.trajectory.reference)
}
