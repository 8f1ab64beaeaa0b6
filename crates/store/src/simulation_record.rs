//! `simulation.json`: what was simulated, beside the tables of it.

use std::collections::BTreeMap;
use std::path::Path;

use plan::simulate::GraspErrors;
use plan::{Format, PlannerError, Problem, VERSION, hash};
use serde::{Deserialize, Serialize};

use crate::atomic::{read_bytes, read_text};

/// Name of the file.
pub const SIMULATION: &str = "simulation.json";
/// Name of the table of every rollout.
pub const ROLLOUTS: &str = "rollouts.csv";
/// Name of the table of success rates.
pub const SUCCESS: &str = "success.csv";

/// Settings of a simulation. The tables beside it have the results.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SimulationRecord {
    /// Format of the file.
    #[serde(default)]
    pub format: Format,
    /// Title of the scene.
    pub scene: String,
    /// Folders of the plans.
    pub plans: Vec<String>,
    /// Seed of random offsets and rotations.
    pub seed: u64,
    /// Largest rotation error of the part in the gripper.
    pub turn_rad: f64,
    /// Largest final distance from the goal that counts as success.
    pub position_tolerance_m: f64,
    /// Largest final angle to the goal that counts as success.
    pub angle_tolerance_rad: f64,
    /// Version of the program that simulated.
    pub assembly_plan: String,
    /// Hash (SHA-256, hexadecimal) of each of the tables, by its name.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
}

impl SimulationRecord {
    /// For the plans of a problem, with these injected errors.
    pub fn new(problem: &Problem, plans: Vec<String>, errors: &GraspErrors) -> Self {
        Self {
            format: Format::CURRENT,
            scene: problem.scene().title.clone(),
            plans,
            seed: errors.seed,
            turn_rad: errors.rotation_error,
            position_tolerance_m: problem.success().position,
            angle_tolerance_rad: problem.success().orientation,
            assembly_plan: VERSION.to_owned(),
            files: BTreeMap::new(),
        }
    }

    /// The record in a folder; none where there is no such file, as beside tables of older versions.
    ///
    /// # Errors
    /// When the file is something else.
    pub fn read_if_there(folder: &Path) -> Result<Option<Self>, PlannerError> {
        let file = folder.join(SIMULATION);
        if file.symlink_metadata().is_err() {
            return Ok(None);
        }
        let record = serde_json::from_str(&read_text(&file)?);
        record.map(Some).map_err(|error| PlannerError::file(&file, format!("is no record of a simulation: {error}")))
    }

    /// The record in a folder, whose tables have the hashes that it lists.
    ///
    /// # Errors
    /// When the record is missing, as after an interrupted simulation, or a table has another hash.
    pub fn read(folder: &Path) -> Result<Self, PlannerError> {
        let record = Self::read_if_there(folder)?.filter(|record| !record.files.is_empty());
        let record = record.ok_or_else(|| {
            let problem =
                "is missing or of an older version, so that its tables may be of two simulations; simulate again";
            PlannerError::file(&folder.join(SIMULATION), problem)
        })?;
        for (name, expected) in &record.files {
            let file = folder.join(name);
            if !is_table(name) || hash(&read_bytes(&file)?) != *expected {
                let problem = "is not of the simulation that simulation.json is of: one was interrupted, or it was changed; \
                               simulate again";
                return Err(PlannerError::file(&file, problem));
            }
        }
        Ok(record)
    }

    /// As the file has it.
    pub(crate) fn to_json(&self) -> Result<Vec<u8>, PlannerError> {
        let mut json =
            serde_json::to_vec_pretty(self).map_err(|_| PlannerError::Internal("the record of a simulation"))?;
        json.push(b'\n');
        Ok(json)
    }
}

/// Whether a name is that of a table of a simulation.
pub(crate) fn is_table(name: &str) -> bool {
    name == ROLLOUTS || name == SUCCESS
}
