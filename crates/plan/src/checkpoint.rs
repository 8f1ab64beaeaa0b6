//! The checkpoint of an unfinished solve, from which another one resumes after the last finished homotopy step.

use std::collections::BTreeMap;

use nlp::Iterate;
use ocp::{Layout, blocks, standard_terms};
use serde::{Deserialize, Serialize};
use task::{AssemblyTask, Complementarity};

use crate::error::{PlannerError, Unusable};
use crate::iteration::IterationRecord;
use crate::keeper::Keeper;
use crate::sealed::{seal, unseal};

/// Name of the record.
const CHECKPOINT: &str = "checkpoint.json";

/// The finished homotopy steps of a problem and the point where the next one starts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checkpoint {
    /// [`crate::Problem::identity`] of the problem.
    pub identity: String,
    /// Index of the attempt among those at the problem.
    pub attempt: usize,
    /// All finished iterations.
    pub iterations: Vec<IterationRecord>,
    /// Hash (SHA-256, hexadecimal) of each of their tables, by its path in the folder.
    pub tables: BTreeMap<String, String>,
    x: Vec<f64>,
    constraint_multipliers: Vec<f64>,
    lower_multipliers: Vec<f64>,
    upper_multipliers: Vec<f64>,
}

impl Checkpoint {
    /// After the finished iterations of an attempt at a problem, which ended at a primal-dual point.
    pub fn new(identity: &str, attempt: usize, iterations: Vec<IterationRecord>, iterate: &Iterate) -> Self {
        let Iterate { x, constraint_multipliers, lower_multipliers, upper_multipliers } = iterate.clone();
        Self {
            identity: identity.to_owned(),
            attempt,
            iterations,
            tables: BTreeMap::new(),
            x,
            constraint_multipliers,
            lower_multipliers,
            upper_multipliers,
        }
    }

    /// The stored checkpoint, if there is one; `Err` with the reason where it or a table is truncated or modified, or
    /// belongs to another problem, so that the solve has to start from the beginning.
    pub fn load(keeper: &dyn Keeper, identity: &str) -> Result<Option<Self>, Unusable> {
        let Some(text) = keeper.record(CHECKPOINT) else { return Ok(None) };
        let checkpoint: Self = unseal(&text, Unusable::DamagedCheckpoint)?;
        if checkpoint.identity != identity {
            return Err(Unusable::OtherProblem);
        }
        match checkpoint.tables.iter().all(|(name, hash)| keeper.is_unchanged(name, hash)) {
            true => Ok(Some(checkpoint)),
            false => Err(Unusable::DamagedTables),
        }
    }

    /// Keeps the checkpoint. Values are written so that they are read back exactly.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn save(&self, keeper: &dyn Keeper) -> Result<(), PlannerError> {
        keeper.keep_record(CHECKPOINT, &seal(self)?)
    }

    /// Whether the primal-dual point is one of a task: as many numbers as its transcription has, all of them finite.
    pub fn is_point_of(&self, task: &AssemblyTask, complementarity: Complementarity) -> bool {
        let layout = Layout::new(task, &blocks(&standard_terms(task, complementarity)));
        let Self { x, constraint_multipliers, lower_multipliers, upper_multipliers, .. } = self;
        let variables = layout.variable_count();
        [x, lower_multipliers, upper_multipliers].iter().all(|values| values.len() == variables)
            && constraint_multipliers.len() == layout.constraint_count()
            && [x, constraint_multipliers, lower_multipliers, upper_multipliers]
                .into_iter()
                .flatten()
                .all(|value| value.is_finite())
    }

    /// The primal-dual point where the next iteration starts.
    pub fn iterate(&self) -> Iterate {
        let Self { x, constraint_multipliers, lower_multipliers, upper_multipliers, .. } = self.clone();
        Iterate { x, constraint_multipliers, lower_multipliers, upper_multipliers }
    }
}
