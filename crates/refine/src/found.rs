//! Results of a refinement so far.

use std::collections::{BTreeMap, VecDeque};

use plan::{PlannerError, Round, SuccessRates};

use crate::candidate::Evaluated;

/// The best plan so far, the latest ones, and the rounds.
pub struct Found {
    /// Success rates of the first reference, before any change.
    pub before: SuccessRates,
    pub rounds: Vec<Round>,
    pub best: Option<Evaluated>,
    /// Names and hashes of the tables that are kept of its homotopy.
    pub tables: BTreeMap<String, String>,
    /// The latest that were evaluated, for a comparison.
    pub latest: VecDeque<Evaluated>,
}

impl Found {
    /// Nothing yet.
    pub fn nothing() -> Self {
        Self {
            before: SuccessRates(Vec::new()),
            rounds: Vec::new(),
            best: None,
            tables: BTreeMap::new(),
            latest: VecDeque::new(),
        }
    }

    /// Success rate of the best plan so far; 0 without one.
    pub fn rate(&self) -> f64 {
        self.best.as_ref().map_or(0.0, |best| best.rates.overall())
    }

    /// Whether the best plan so far is robust.
    pub fn is_robust(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.reached)
    }

    /// Takes note of a reference for the comparison of the latest `count`.
    pub fn remember(&mut self, evaluated: Evaluated, count: usize) {
        if self.latest.len() == count {
            self.latest.pop_front();
        }
        self.latest.push_back(evaluated);
    }

    /// Takes out the best plan so far.
    pub fn take_best(&mut self) -> Result<Evaluated, PlannerError> {
        self.best.take().ok_or(PlannerError::Internal("no plan was evaluated"))
    }
}
