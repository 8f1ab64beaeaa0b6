//! A small problem and its plan.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use planner::files::PlanFolder;
use planner::{Choices, Event, Keeper, Plan, Problem, Session};

/// The smallest scene of the project.
pub fn scene() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml")
}

/// One of its problems.
pub fn problem(offset_magnitude: f64) -> Problem {
    Problem::load(&scene(), &Choices { offset_magnitude: Some(offset_magnitude), ..Choices::default() }).unwrap()
}

/// Its plan, solved once.
pub fn plan() -> &'static Plan {
    static PLAN: OnceLock<Plan> = OnceLock::new();
    PLAN.get_or_init(|| solve(0.01, None, &AtomicBool::new(false)))
}

/// Solves a problem, with a folder for unfinished work.
pub fn solve(offset_magnitude: f64, folder: Option<&PlanFolder>, interrupted: &AtomicBool) -> Plan {
    let folder = folder.map(|folder| folder as &dyn Keeper);
    let session = Session { folder, ..Session::new(&|_: &Event| {}, interrupted) };
    planner::solve(&problem(offset_magnitude), &session).unwrap()
}

/// Claims a folder that holds nothing of others.
pub fn claim(out: &Path) -> PlanFolder {
    PlanFolder::claim(out, &[]).unwrap()
}
