//! What accompanies a long computation: who watches it, how it is stopped, where unfinished work is kept.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::Unusable;
use crate::files::PlanFolder;
use crate::iteration::IterationRecord;

/// What accompanies a long computation.
pub struct Session<'run> {
    /// Who is told what happens.
    pub observer: &'run dyn Observer,
    /// Once set, the computation ends as soon as it can, with what it has.
    pub interrupted: &'run AtomicBool,
    /// Where finished homotopy iterations and refined references are kept, so that another run can go on with them.
    pub folder: Option<&'run PlanFolder>,
}

impl Session<'_> {
    /// Whether the user wants the computation to end.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    pub(crate) fn tell(&self, event: Event) {
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

/// What can happen.
#[derive(Debug)]
pub enum Event<'event> {
    /// An iteration of the solver.
    Iteration(ocp::Event<'event>),
    /// The end of a homotopy iteration.
    HomotopyIteration {
        /// Its number, from 1.
        number: usize,
        /// How many there are, at most.
        most: usize,
        /// What came of it.
        record: &'event IterationRecord,
        /// Largest final position error of all scenarios (m).
        position_error: f64,
    },
    /// An earlier run is continued.
    Resumed {
        /// Homotopy iterations that it has finished.
        done: usize,
        /// How many there are, at most.
        most: usize,
        /// Whether it had begun to refine.
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
    /// A change of the reference has been tried.
    Change {
        /// Training rollouts that still fail.
        failing: usize,
        /// How many there are.
        trials: usize,
        /// Changes kept so far.
        changes: usize,
    },
    /// A refined plan has been evaluated at grasp errors that it was not trained on.
    Refined {
        /// Success rate, 0 to 1.
        rate: f64,
    },
    /// Refinement is stuck; variants of the problem are solved.
    Variants {
        /// How many.
        count: usize,
    },
    /// A variant has been solved.
    VariantSolved {
        /// Its name.
        name: &'event str,
        /// How its solve ended.
        status: &'event str,
    },
    /// A variant's plan has been tried.
    VariantTried {
        /// Its name.
        name: &'event str,
        /// Training rollouts that fail.
        failing: usize,
        /// How many there are.
        trials: usize,
    },
}
