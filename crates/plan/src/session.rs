//! The context of a long computation: its observer, how it is stopped, where unfinished work is kept.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::clock::RunClock;
use crate::error::Unusable;
use crate::iteration::IterationRecord;
use crate::keeper::Keeper;

/// The context of a long computation.
pub struct Session<'run> {
    /// Observer of all events.
    pub observer: &'run dyn Observer,
    /// Once set, the computation ends as soon as it can, with what it has.
    pub interrupted: &'run AtomicBool,
    /// Storage of finished homotopy steps and refined references, from which another run resumes.
    pub folder: Option<&'run dyn Keeper>,
    /// Number of threads; does not affect results.
    pub threads: usize,
    /// The clock of the run with its time limit.
    pub clock: RunClock<'run>,
}

/// Part of a limited time that is reserved for the end: writing and explaining.
const RESERVE: f64 = 0.03;

impl<'run> Session<'run> {
    /// With one thread per processor, nothing kept, and a clock that starts now and has no limit.
    pub fn new(observer: &'run dyn Observer, interrupted: &'run AtomicBool) -> Self {
        let threads = std::thread::available_parallelism().map_or(1, Into::into);
        Self { observer, interrupted, folder: None, threads, clock: RunClock::start() }
    }

    /// Whether the user wants the computation to end.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// When work has to end, as time since the run began, so that what it has found is written in time. `None` if the time
    /// is not limited.
    pub fn end_of_work(&self) -> Option<Duration> {
        let limit = self.clock.limit()?;
        let writing = self.folder.map_or(Duration::ZERO, Keeper::writing_time);
        Some(limit.saturating_sub(writing.max(limit.mul_f64(RESERVE))))
    }

    /// Whether the time for work is over.
    pub fn is_over(&self) -> bool {
        self.end_of_work().is_some_and(|end| self.clock.elapsed() >= end)
    }

    /// Tells the observer what has happened.
    pub fn tell(&self, event: Event) {
        self.observer.observe(&event);
    }
}

/// Watches a computation. Events may come from several threads.
pub trait Observer: Sync {
    /// Something has happened.
    fn observe(&self, event: &Event);
}

impl<F: Fn(&Event) + Sync> Observer for F {
    fn observe(&self, event: &Event) {
        self(event);
    }
}

/// Events of a computation.
#[derive(Debug)]
pub enum Event<'event> {
    /// An iteration of the solver.
    Iteration(ocp::Event<'event>),
    /// The end of a homotopy step.
    HomotopyStep {
        /// Its number, from 1.
        number: usize,
        /// How many there are, at most.
        most: usize,
        /// Its record.
        record: &'event IterationRecord,
        /// Largest final position error of all scenarios (m).
        position_error: f64,
    },
    /// The plan so far misses the goal: another attempt follows.
    Attempt {
        /// Which, in words.
        planned: &'static str,
        /// Largest final position error of the best plan so far (m).
        position_error: f64,
    },
    /// An earlier run is continued.
    Resumed {
        /// Homotopy steps that it has finished.
        done: usize,
        /// How many there are, at most.
        most: usize,
        /// Whether refinement had started.
        refining: bool,
    },
    /// Unfinished work is not continued.
    Discarded {
        /// Why not.
        reason: Unusable,
    },
    /// The unrefined plan has been evaluated: fraction of rollouts that succeed.
    Evaluated {
        /// Success rate, 0 to 1.
        rate: f64,
    },
    /// The refinement of a plan begins.
    Refining {
        /// Which problem was planned, in words.
        planned: &'event str,
    },
    /// A perturbation of the reference has been tried.
    Perturbation {
        /// Training rollouts that still fail.
        failing: usize,
        /// How many there are.
        cases: usize,
        /// Perturbations accepted so far.
        accepted: usize,
    },
    /// A refined plan has been evaluated at grasp errors that it was not trained on.
    Refined {
        /// Success rate, 0 to 1.
        rate: f64,
    },
    /// Refinement is stuck; a variant of the problem is solved.
    Variant {
        /// Its name.
        name: &'event str,
        /// Its number in the portfolio, from 1.
        number: usize,
        /// How many there are.
        count: usize,
    },
    /// It has been solved.
    VariantSolved {
        /// How its solve ended.
        status: &'event str,
    },
    /// Some rollouts of a simulation have been played.
    Rollouts {
        /// How many so far.
        done: usize,
        /// How many there are.
        count: usize,
    },
    /// Its plan has been tried.
    VariantTried {
        /// Training rollouts that fail.
        failing: usize,
        /// How many there are.
        cases: usize,
    },
}
