//! The tables of a simulation: `rollouts.csv`, `success.csv`, and lists of offsets.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use plan::simulate::PlayedRollout;
use plan::{PlannerError, SuccessGroup, hash};
use serde::{Deserialize, Serialize};
use simulation::wilson_interval;

use crate::atomic::{PartialFile, require_folder, write_file};
use crate::simulation_record::{ROLLOUTS, SIMULATION, SUCCESS, SimulationRecord, is_table};
use crate::table::{Value, has_header, read_csv, to_csv};
use crate::work_folder::WorkFolder;

/// A row of `rollouts.csv`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "named with their units")]
pub struct RolloutRow {
    /// Folder of the plan.
    pub plan: String,
    pub start: String,
    pub delta_m: Value,
    /// `plan`, `straight push`, or `stage` with the number of a homotopy step.
    pub motion: String,
    pub friction: Value,
    pub magnitude_m: Value,
    pub x_m: Value,
    pub y_m: Value,
    pub z_m: Value,
    /// 1 or 0.
    pub success: u8,
    pub position_error_m: Value,
    pub orientation_error_rad: Value,
    pub max_penetration_m: Value,
    pub max_force_n: Value,
    pub turn_x_rad: Value,
    pub turn_y_rad: Value,
    pub turn_z_rad: Value,
}

impl RolloutRow {
    /// From a rollout of the plan in a folder.
    pub fn new(plan: &Path, start: &str, rollout: &PlayedRollout) -> Self {
        let [x_m, y_m, z_m] = rollout.grasp.offset.map(Value);
        let [turn_x_rad, turn_y_rad, turn_z_rad] = rollout.grasp.rotation.map(Value);
        Self {
            plan: plan.display().to_string(),
            start: start.to_owned(),
            delta_m: Value(rollout.offset_magnitude),
            motion: rollout.motion.to_string(),
            friction: Value(rollout.friction),
            magnitude_m: Value(rollout.magnitude),
            x_m,
            y_m,
            z_m,
            success: u8::from(rollout.success),
            position_error_m: Value(rollout.outcome.position_error),
            orientation_error_rad: Value(rollout.outcome.orientation_error),
            max_penetration_m: Value(rollout.outcome.max_penetration),
            max_force_n: Value(rollout.outcome.loads.contact_force),
            turn_x_rad,
            turn_y_rad,
            turn_z_rad,
        }
    }
}

/// A row of `success.csv`: rollouts that differ only in plan (of the same delta-hat) and grasp error.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "named with their units")]
pub struct SuccessRow {
    pub motion: String,
    pub friction: Value,
    pub delta_m: Value,
    pub magnitude_m: Value,
    pub rollouts: usize,
    pub successes: usize,
    pub rate: Value,
    /// Wilson's interval of 95 %, here and below.
    pub rate_low: Value,
    pub rate_high: Value,
    pub largest_position_error_m: Value,
    pub largest_orientation_error_rad: Value,
    pub max_penetration_m: Value,
    pub max_force_n: Value,
}

impl From<&SuccessGroup> for SuccessRow {
    fn from(group: &SuccessGroup) -> Self {
        let [low, high] = wilson_interval(group.successes, group.rollouts);
        Self {
            motion: group.motion.to_string(),
            friction: Value(group.friction),
            delta_m: Value(group.offset_magnitude),
            magnitude_m: Value(group.magnitude),
            rollouts: group.rollouts,
            successes: group.successes,
            rate: Value(group.successes as f64 / group.rollouts as f64),
            rate_low: Value(low),
            rate_high: Value(high),
            largest_position_error_m: Value(group.position_error),
            largest_orientation_error_rad: Value(group.orientation_error),
            max_penetration_m: Value(group.max_penetration),
            max_force_n: Value(group.max_force),
        }
    }
}

/// A row of a list of offsets (body frame).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "named with their units")]
pub struct OffsetRow {
    pub x_m: Value,
    pub y_m: Value,
    pub z_m: Value,
}

/// Reads a list of offsets (m, body frame).
///
/// # Errors
/// With the line that is wrong, or when there are none.
pub fn read_offsets(file: &Path) -> Result<Vec<[f64; 3]>, PlannerError> {
    /// More than anyone needs.
    const MOST: usize = 1_000_000;
    let rows: Vec<OffsetRow> = read_csv(file)?;
    match rows.len() {
        0 => Err(PlannerError::file(file, "no offsets: a row each below the header x_m,y_m,z_m")),
        1..=MOST => Ok(rows.iter().map(|row| [row.x_m.0, row.y_m.0, row.z_m.0]).collect()),
        count => Err(PlannerError::file(file, format!("{count} offsets, more than {MOST}"))),
    }
}

/// Refuses a folder in which something else than older files of a simulation would be replaced.
///
/// # Errors
/// With the file that would be.
pub fn require_rollout_tables(folder: &Path) -> Result<(), PlannerError> {
    require_folder(folder)?;
    SimulationRecord::read_if_there(folder)?;
    require_table::<RolloutRow>(&folder.join(ROLLOUTS))?;
    require_table::<SuccessRow>(&folder.join(SUCCESS))
}

/// Whether a file is, or would be, one of the files of a simulation in a folder.
pub fn is_rollout_table(file: &Path, folder: &Path) -> bool {
    // A folder that is missing has no other name yet.
    let place = |folder: &Path| folder.canonicalize().or_else(|_| std::path::absolute(folder)).ok();
    let parent = file.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let has_name = file.file_name().and_then(OsStr::to_str).is_some_and(|name| is_table(name) || name == SIMULATION);
    has_name && place(parent) == place(folder)
}

/// Writes the tables of a simulation and what they are of into a folder, in the place of older ones.
///
/// # Errors
/// When something else stands there, another run is writing there, or they cannot be written.
pub fn write_rollout_tables(
    folder: &Path,
    record: &SimulationRecord,
    rollouts: &[RolloutRow],
    successes: &[SuccessRow],
) -> Result<(), PlannerError> {
    let mut tables = RolloutTables::begin(folder)?;
    rollouts.iter().try_for_each(|row| tables.add(row))?;
    tables.finish(record, successes)
}

/// The tables of a simulation while it runs: rollouts are written as they are played.
pub struct RolloutTables {
    folder: PathBuf,
    /// Two simulations do not mix their tables.
    _lock: WorkFolder,
    rollouts: csv::Writer<PartialFile>,
}

impl RolloutTables {
    /// Begins `rollouts.csv`. Older tables stay until the end.
    ///
    /// # Errors
    /// When another simulation writes into the folder, or other files have the names of the tables.
    pub fn begin(folder: &Path) -> Result<Self, PlannerError> {
        let lock = WorkFolder::claim(folder)?;
        require_rollout_tables(folder)?;
        let rollouts = csv::Writer::from_writer(PartialFile::create(&folder.join(ROLLOUTS))?);
        Ok(Self { folder: folder.to_owned(), _lock: lock, rollouts })
    }

    /// Adds a rollout.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn add(&mut self, row: &RolloutRow) -> Result<(), PlannerError> {
        self.rollouts.serialize(row).map_err(|error| match error.into_kind() {
            csv::ErrorKind::Io(error) => PlannerError::written(&self.folder.join(ROLLOUTS))(error),
            _ => PlannerError::Internal("a row cannot be written"),
        })
    }

    /// Writes all other files, and gives all of them their names.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self, record: &SimulationRecord, successes: &[SuccessRow]) -> Result<(), PlannerError> {
        let Self { folder, rollouts, .. } = self;
        let rollouts = rollouts.into_inner().map_err(|error| {
            PlannerError::written(&folder.join(ROLLOUTS))(std::io::Error::new(error.error().kind(), error.to_string()))
        })?;
        let successes = to_csv(successes)?;
        let files = [(ROLLOUTS.to_owned(), rollouts.finish()?), (SUCCESS.to_owned(), hash(&successes))].into();
        write_file(&folder.join(SUCCESS), &successes)?;
        write_file(&folder.join(SIMULATION), &SimulationRecord { files, ..record.clone() }.to_json()?)
    }
}

/// Refuses a file that is not an older table of these rows.
fn require_table<T: Serialize + Default>(file: &Path) -> Result<(), PlannerError> {
    let table = to_csv([T::default()])?;
    let header = String::from_utf8_lossy(&table);
    if file.symlink_metadata().is_err() || has_header(file, header.lines().next().unwrap_or_default()) {
        return Ok(());
    }
    Err(PlannerError::file(file, "exists and is not an older table of this kind; choose another --out"))
}
