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

/// Where no attempt is a plan, those before the interrupted one are made again, and each gives up as it does without an
/// interrupt.
#[test]
fn resumed_attempts_end_as_uninterrupted_ones() {
    let parent = tempfile::tempdir().unwrap();
    let peg = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
    let text = std::fs::read_to_string(peg).unwrap();
    // Too few steps for any plan.
    let few =
        text.replace("\nsteps = 100\n", "\nsteps = 6\n").replace("\ntime_step = 0.04\n", "\ntime_step = 0.6667\n");
    assert_ne!(few, text);
    let scene = parent.path().join("peg.toml");
    std::fs::write(&scene, few).unwrap();
    let problem = Problem::load(&scene, &Choices::default()).unwrap();
    let whole = solved(&problem, &parent.path().join("whole"), None);
    assert_eq!(whole.attempts.len(), 3);
    assert!(whole.attempts[0].status.starts_with("given up"), "{}", whole.attempts[0].status);
    let cut = parent.path().join("cut");
    assert_eq!(solved(&problem, &cut, Some(1)).status(), PlanStatus::Interrupted);
    let resumed = solved(&problem, &cut, None);
    let ends = |plan: &Plan| {
        let attempts = plan.attempts.iter();
        attempts.map(|attempt| (attempt.status.clone(), attempt.iterations)).collect::<Vec<_>>()
    };
    assert_eq!(ends(&resumed), ends(&whole));
    assert_eq!(resumed.trajectory.reference, whole.trajectory.reference, "the same bits");
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
