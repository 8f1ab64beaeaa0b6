//! Other homotopies where the built-in one misses the goal.

use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use planner::files::PlanFolder;
use planner::{Choices, Event, Plan, PlanStatus, Problem, Session, solve};

fn clamp() -> Problem {
    let scene = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenes/clamp1.toml");
    Problem::load(&scene, &Choices::default()).unwrap()
}

/// Solves in a folder; stops after the given number of homotopy steps of the second attempt.
fn solved(problem: &Problem, folder: &Path, stop_after: Option<usize>) -> Plan {
    let (stopped, attempt) = (AtomicBool::new(false), Mutex::new(Cell::new(1)));
    let observer = |event: &Event| match event {
        Event::Attempt { .. } => {
            let attempt = attempt.lock().unwrap();
            attempt.set(attempt.get() + 1);
        }
        Event::HomotopyStep { number, .. } => {
            let in_second = attempt.lock().unwrap().get() == 2;
            stopped.fetch_or(in_second && Some(*number) == stop_after, Ordering::Relaxed);
        }
        _ => {}
    };
    let folder = PlanFolder::claim(folder, &[]).unwrap();
    solve(problem, &Session { folder: Some(&folder), ..Session::new(&observer, &stopped) }).unwrap()
}

#[test]
#[ignore = "slow, three solves of a clamp: scripts/test and CI run it"]
fn an_interrupted_attempt_goes_on_where_it_was() {
    let problem = clamp();
    let parent = tempfile::tempdir().unwrap();
    let whole = solved(&problem, &parent.path().join("whole"), None);
    assert_eq!((whole.status(), whole.attempts.len()), (PlanStatus::Planned, 2));
    assert_ne!(whole.problem.homotopy().tau, problem.homotopy().tau, "the plan says what it was made with");
    assert_eq!(whole.problem.identity(), problem.identity(), "it is the same problem");

    let cut = parent.path().join("cut");
    let interrupted = solved(&problem, &cut, Some(3));
    assert_eq!(interrupted.status(), PlanStatus::Interrupted);
    let resumed = solved(&problem, &cut, None);
    assert_eq!(resumed.status(), PlanStatus::Planned);
    assert_eq!(resumed.attempts.len(), 1, "the first attempt has missed the goal before");
    assert_eq!(resumed.trajectory.reference, whole.trajectory.reference, "the same bits");
}
