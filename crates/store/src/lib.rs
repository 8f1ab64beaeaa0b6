//! Every file of a plan, a batch or a simulation: one type per record, with its writer and reader side by side.
//!
//! | file | type |
//! |---|---|
//! | `reference.csv`, traces | [`StateRow`] |
//! | `scenarios.csv`, `wrench.csv`, `contacts.csv` | [`trajectory`] |
//! | `result.json` | [`PlanResult`] |
//! | unfinished work: `checkpoint.json`, `refinement.json` | [`PlanFolder`], which is a [`Keeper`](plan::Keeper) |
//! | new scenes | [`write_new_scene`] |
//! | `manifest.jsonl` of a batch | [`Manifest`] |
//! | `cells.csv`, `cells.json` of a batch | [`batch::cells`] |
//! | `rollouts.csv`, `success.csv`, `simulation.json` of a simulation | [`RolloutRow`], [`SuccessRow`], [`SimulationRecord`] |
//! | `executed.csv` of a player | [`PlayedRows`], [`Execution`] |
//!
//! [`PlanFolder`] writes a plan, [`StoredPlan`] reads one and refuses it when a file was cut or changed.

mod atomic;
pub mod batch;
mod coverage;
mod executed;
mod folder;
mod log;
mod manifest;
mod new_scene;
mod parameters;
mod result;
mod rollouts;
mod simulation_record;
mod stored_plan;
mod table;
pub mod trajectory;
mod work_folder;

pub use atomic::{read_bytes, read_text, remove_file, require_folder, write_file};
pub use coverage::{CoverageKind, CoverageRecord};
pub use executed::{Ending, Execution};
pub use folder::PlanFolder;
pub use log::{ExecutedState, PLAYING, PlayedRows, RESTING, read_log_header, read_played_rows};
pub use manifest::{Cell, MANIFEST, Manifest};
pub use new_scene::write_new_scene;
pub use parameters::read_robust_parameters;
pub use result::{LimitsRecord, MadeFrom, Place, PlanResult, RESULT, ScenarioRecord, Versions, sealed};
pub use rollouts::{
    OffsetRow, RolloutRow, RolloutTables, SuccessRow, is_rollout_table, read_offsets, require_rollout_tables,
    write_rollout_tables,
};
pub use simulation_record::{ROLLOUTS, SIMULATION, SUCCESS, SimulationRecord};
pub use stored_plan::{RESOLVED, STAGES, StoredPlan, read_result, require_moved};
pub use table::{Value, read_csv, to_csv};
pub use trajectory::{MotionTables, ScenarioTables, StateRow, state_problem};
pub use work_folder::WorkFolder;
