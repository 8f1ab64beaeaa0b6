//! What an unfinished solve leaves behind so that another one can go on after its last finished homotopy iteration.

use std::fs;
use std::path::Path;

use nlp::Iterate;
use ocp::HomotopyIteration;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::output::{remove_file, write_file};
use crate::stage::Stage;

/// Name of the file, beside the plan's own.
pub const FILE: &str = "checkpoint.json";

/// The finished homotopy iterations of a problem and the point where the next one starts.
#[derive(Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    /// [`crate::problem::Problem::identity`] of the problem.
    identity: String,
    /// All finished iterations.
    pub stages: Vec<Stage>,
    x: Vec<f64>,
    constraint_multipliers: Vec<f64>,
    lower_multipliers: Vec<f64>,
    upper_multipliers: Vec<f64>,
}

impl Checkpoint {
    /// After the iterations in `stages`, of which `last` is the last.
    pub fn new(identity: &str, stages: &[Stage], last: &HomotopyIteration) -> Self {
        let Iterate { x, constraint_multipliers, lower_multipliers, upper_multipliers } = last.iterate.clone();
        let (identity, stages) = (identity.to_owned(), stages.to_vec());
        Self { identity, stages, x, constraint_multipliers, lower_multipliers, upper_multipliers }
    }

    /// The checkpoint in a folder. There is none where the file is missing, unreadable or of another problem: then the
    /// solve starts from the beginning, which is always right.
    pub fn load(folder: &Path, identity: &str) -> Option<Self> {
        let text = fs::read_to_string(folder.join(FILE)).ok()?;
        serde_json::from_str(&text).ok().filter(|checkpoint: &Self| checkpoint.identity == identity)
    }

    /// Writes the checkpoint into a folder. Numbers are written so that they are read back exactly.
    pub fn save(&self, folder: &Path) -> Result<(), Failure> {
        let json = serde_json::to_vec(self).map_err(|error| Failure::Internal(error.to_string()))?;
        write_file(&folder.join(FILE), &json)
    }

    /// Removes the checkpoint of a folder, if there is one.
    pub fn remove(folder: &Path) -> Result<(), Failure> {
        remove_file(&folder.join(FILE))
    }

    /// The primal-dual point where the next iteration starts.
    pub fn iterate(self) -> Iterate {
        let Self { x, constraint_multipliers, lower_multipliers, upper_multipliers, .. } = self;
        Iterate { x, constraint_multipliers, lower_multipliers, upper_multipliers }
    }
}
