//! Storage of unfinished work, from which another run resumes.

use std::time::Duration;

use task::{AssemblyTask, Trajectory};

use crate::error::PlannerError;

/// Keeps unfinished work of one plan: motions of homotopy steps, and records of how far the work is.
pub trait Keeper: Sync {
    /// Keeps the motion of a finished homotopy step, from 1. Returns the hashes of what was written, by its names.
    ///
    /// # Errors
    /// When it cannot be written.
    fn keep_iteration(
        &self,
        number: usize,
        motion: &Trajectory,
        task: &AssemblyTask,
    ) -> Result<Vec<(String, String)>, PlannerError>;

    /// The motion of a kept homotopy step, from 1.
    ///
    /// # Errors
    /// When it is missing, or no motion of the task.
    fn iteration(&self, number: usize, task: &AssemblyTask) -> Result<Trajectory, PlannerError>;

    /// Keeps the motions of the homotopy steps of a round of refinement, where they are not those of the scene itself. Returns
    /// names and hashes of their tables.
    ///
    /// # Errors
    /// When they cannot be written.
    fn keep_refined(
        &self,
        round: usize,
        motions: &[&Trajectory],
        task: &AssemblyTask,
    ) -> Result<Vec<(String, String)>, PlannerError>;

    /// The motion of a kept homotopy step, from 1, of a round of refinement.
    ///
    /// # Errors
    /// When it is missing, or no motion of the task.
    fn refined(&self, round: usize, number: usize, task: &AssemblyTask) -> Result<Trajectory, PlannerError>;

    /// Keeps a record under a name, instead of an older one.
    ///
    /// # Errors
    /// When it cannot be written.
    fn keep_record(&self, name: &str, record: &[u8]) -> Result<(), PlannerError>;

    /// The record that is kept under a name.
    fn record(&self, name: &str) -> Option<String>;

    /// Whether what is kept under a name has a hash.
    fn is_unchanged(&self, name: &str, expected: &str) -> bool;

    /// Removes all of it; whether there was anything.
    ///
    /// # Errors
    /// When it cannot be removed.
    fn discard(&self) -> Result<bool, PlannerError>;

    /// Expected time to write a plan with the stored homotopy steps, with a margin.
    fn writing_time(&self) -> Duration;
}
