//! What is left of plans when the time of a run ends. The time is told by stand-ins: nothing depends on the machine's speed.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use planner::files::{PlanFolder, StoredPlan, read_result};
use planner::{
    Choices, Cut, Event, Keeper, Outcome, Plan, PlanStatus, PlannerError, Problem, RobustnessTarget, RunClock, Session,
    Stop, refine, solve, test,
};

fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name)
}

fn corner() -> Problem {
    Problem::load(&scene("corner.toml"), &Choices::default()).unwrap()
}

/// The limit of every run here: a stand-in of time reaches it or does not.
const LIMIT: Duration = Duration::from_secs(100);

/// Solves in a folder; the time expires once the given number of homotopy steps is finished.
fn solved_until(problem: &Problem, folder: Option<&PlanFolder>, last: Option<usize>) -> Result<Plan, PlannerError> {
    let (begin, passed, stopped) = (Instant::now(), AtomicU64::new(0), AtomicBool::new(false));
    let now = || begin + Duration::from_secs(passed.load(Ordering::Relaxed));
    let observer = |event: &Event| {
        let is_last = match event {
            Event::HomotopyStep { number, .. } => Some(*number) == last,
            Event::Iteration(_) => last == Some(0),
            _ => false,
        };
        passed.fetch_add(200 * u64::from(is_last), Ordering::Relaxed);
    };
    let clock = RunClock::with(&now).limited(Some(LIMIT));
    let folder = folder.map(|folder| folder as &dyn Keeper);
    solve(problem, &Session { folder, clock, threads: 1, ..Session::new(&observer, &stopped) })
}

#[test]
fn what_the_homotopy_has_finished_in_time_is_written_and_gone_on_with() {
    let problem = corner();
    let parent = tempfile::tempdir().unwrap();
    let target = parent.path().join("plan");
    let whole = solved_until(&problem, None, None).unwrap();
    assert_eq!((whole.status(), whole.stopped), (PlanStatus::Planned, None));

    let folder = PlanFolder::claim(&target, &[]).unwrap();
    let cut = solved_until(&problem, Some(&folder), Some(2)).unwrap();
    assert_eq!(cut.status(), PlanStatus::OutOfTime(Cut::Homotopy { finished: 2, of: 5 }));
    assert_eq!(
        cut.status().to_string(),
        "out of time: the time limit ended the solve after 2 of at least 5 homotopy steps"
    );
    assert_eq!(cut.trajectory.reference, whole.iterations[1].trajectory.reference, "the last that is finished");
    assert!(cut.can_go_on() && !cut.is_converged());
    let result = folder.finish(&cut).unwrap();
    assert_eq!((result.outcome, result.done, result.planned), (Outcome::OutOfTime, false, false));
    assert!(result.explanation.is_some(), "it says what the plan lacks");
    assert_eq!(StoredPlan::open(&target).unwrap().result, result);
    assert!(parent.path().join(".plan.unfinished/checkpoint.json").exists(), "another run can go on");

    let folder = PlanFolder::claim(&target, &[]).unwrap();
    let resumed = solved_until(&problem, Some(&folder), None).unwrap();
    assert_eq!(resumed.status(), PlanStatus::Planned);
    assert_eq!(resumed.trajectory.reference, whole.trajectory.reference, "the same bits");
    folder.finish(&resumed).unwrap();
    assert!(read_result(&target).unwrap().planned);
    assert!(!parent.path().join(".plan.unfinished").exists());
}

#[test]
fn a_coarse_homotopy_iteration_is_a_plan_with_fewer_steps() {
    let problem = Problem::load(&scene("peg2.toml"), &Choices::default()).unwrap();
    let parent = tempfile::tempdir().unwrap();
    let folder = PlanFolder::claim(&parent.path().join("plan"), &[]).unwrap();
    let cut = solved_until(&problem, Some(&folder), Some(1)).unwrap();
    let steps = cut.trajectory.reference.len() - 1;
    assert!(cut.is_coarse() && steps < problem.task().horizon.steps, "{steps}");
    assert_eq!((cut.task.horizon.steps, cut.task.horizon.time_step), (steps, cut.trajectory.time_step));
    folder.finish(&cut).unwrap();
    let stored = StoredPlan::open(&parent.path().join("plan")).unwrap();
    assert_eq!(stored.reference().unwrap().states().len(), steps + 1);
}

#[test]
fn without_a_homotopy_iteration_there_is_no_plan() {
    let error = solved_until(&corner(), None, Some(0)).unwrap_err();
    let message = error.to_string();
    assert!(message.contains("before the first homotopy step") && message.contains("--time-limit"), "{message}");
    assert!(message.contains("of 2 pairs of parts in 2 scenarios of 20 steps"), "{message}");
}

/// Refines a plan without changes; every look at the clock takes a second.
fn evaluated_in(plan: Plan, seconds: u64) -> Plan {
    let (begin, passed, stopped) = (Instant::now(), AtomicU64::new(0), AtomicBool::new(false));
    let now = || begin + Duration::from_secs(passed.fetch_add(1, Ordering::Relaxed));
    let session = Session { clock: RunClock::with(&now), threads: 1, ..Session::new(&|_: &Event| {}, &stopped) };
    let time_limit = Duration::from_secs(seconds);
    let target = RobustnessTarget { frictions: vec![0.0], stall_limit: 0, time_limit, ..RobustnessTarget::default() };
    refine(plan, &target, &session).unwrap()
}

#[test]
fn an_evaluation_that_is_cut_says_so() {
    let plan = solved_until(&corner(), None, None).unwrap();
    let whole = evaluated_in(plan.clone(), 1_000_000);
    let cut = evaluated_in(plan, 300);
    let PlanStatus::OutOfTime(Cut::Evaluation { played, of }) = cut.status() else {
        panic!("{}", cut.status());
    };
    assert_eq!(of, 502);
    assert!(0 < played && played < 300, "{played}");
    let expected = format!("out of time: the time limit ended the last evaluation after {played} of 502 rollouts");
    assert_eq!(cut.status().to_string(), expected);
    let report = cut.robustness.as_ref().unwrap();
    assert_eq!((report.after.rollouts(), report.unplayed, cut.stopped), (played, of - played, Some(Stop::TimeLimit)));
    // A look at the clock is a second.
    assert!((290.0..330.0).contains(&report.wall_s), "{}", report.wall_s);
    let report = whole.robustness.as_ref().unwrap();
    assert_eq!((report.unplayed, whole.stopped), (0, None), "what is decided is not cut");
    // Two planned offsets and 299 random ones show 99 %, which is asked after every 24.
    assert_eq!(report.after.rollouts(), 312);
}

#[test]
fn a_plan_that_nobody_refines_is_played_beside_a_straight_push() {
    let plan = solved_until(&corner(), None, None).unwrap();
    let played = |frictions: &[f64], is_stopped: bool| {
        let stopped = AtomicBool::new(is_stopped);
        let session = Session::new(&|_: &Event| {}, &stopped);
        let target = RobustnessTarget { frictions: frictions.to_vec(), ..RobustnessTarget::default() };
        test(&plan, &target, &session).unwrap()
    };
    let tested = played(&[0.0], false).unwrap();
    // Ten random offsets of each of five magnitudes, and two planned ones.
    assert_eq!(tested.rates.rollouts(), 52);
    assert!(tested.push.reached && tested.push.rates.rollouts() == 52, "the same rollouts");
    let with_friction = played(&[0.0, 1.0], false).unwrap();
    assert!(!with_friction.push.reached, "friction holds what is only pushed to its goal");
    assert_eq!(with_friction.rates.rollouts(), 2 * 52, "all rollouts of the plan are played");
    assert!(played(&[0.0], true).is_none(), "an interrupted test says nothing");
    assert_eq!(plan.status(), PlanStatus::Planned);
}
