//! Robust plans whose problem is not the scene's own: what is written of them is about the plan, not about the scene.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use planner::explain::explanation;
use planner::files::{PlanResult, StateRow, read_csv, trajectory};
use planner::{
    Choices, Cut, Event, Plan, PlanStatus, Problem, RobustnessTarget, Session, Stop, refine, refine_reference, solve,
};
use simulation::{Reference, Success};
use task::State;

fn corner(success: Success) -> Problem {
    let choices = Choices {
        position_tolerance: Some(success.position),
        angle_tolerance: Some(success.orientation),
        ..Choices::default()
    };
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    Problem::load(&scene, &choices).unwrap()
}

fn quietly<T>(run: impl FnOnce(&Session) -> T) -> T {
    run(&Session::new(&|_: &Event| {}, &AtomicBool::new(false)))
}

/// A plan of the corner scene with half the time step and two homotopy steps.
static FINE: LazyLock<Plan> = LazyLock::new(|| {
    let problem = corner(Success::default());
    let mut scene = problem.scene().clone();
    (scene.horizon.steps, scene.horizon.time_step) = (40, 0.04);
    let mut settings = problem.homotopy().clone();
    (settings.iterations, settings.further_iterations) = (2, 0);
    let fine = Problem::new(scene, None, None, settings).unwrap();
    let plan = quietly(|session| solve(&fine, session)).unwrap();
    Plan { problem, ..plan }
});

/// The plan, judged with a tolerance, as `solve --robust` would leave it without changes.
fn refined(position: f64, target: &RobustnessTarget) -> Plan {
    let success = Success { position, ..Success::default() };
    let plan = Plan { problem: corner(success), ..FINE.clone() };
    quietly(|session| refine(plan, target, session)).unwrap()
}

/// Nothing is changed.
fn impatient() -> RobustnessTarget {
    RobustnessTarget { frictions: vec![0.0], stall_limit: 0, ..RobustnessTarget::default() }
}

fn result(plan: &Plan) -> PlanResult {
    PlanResult::new(plan, std::collections::BTreeMap::new())
}

/// The states of a table: one list per scenario, or a single one.
fn states(folder: &Path, name: &str) -> Vec<Vec<State>> {
    let file = folder.join(name);
    let text = std::fs::read_to_string(&file).unwrap();
    let rows: Vec<StateRow> = read_csv(&file).unwrap();
    let scenario = |line: &str| line.split(',').nth(1).unwrap().to_owned();
    let by = if text.starts_with("time_s,scenario,") { scenario } else { |_: &str| String::new() };
    let labels: Vec<String> = text.lines().skip(1).map(by).collect();
    let rows: Vec<_> = labels.into_iter().zip(rows.iter().map(StateRow::state)).collect();
    let motions = rows.chunk_by(|one, other| one.0 == other.0);
    motions.map(|motion| motion.iter().map(|(_, state)| *state).collect()).collect()
}

/// Largest finite difference of the velocities in the components from one to another.
fn largest_acceleration(motions: &[Vec<State>], time_step: f64, axes: std::ops::Range<usize>) -> f64 {
    let pairs = motions.iter().flat_map(|motion| motion.windows(2));
    let change = |pair: &[State], axis: usize| (pair[1].twist()[axis] - pair[0].twist()[axis]).abs() / time_step;
    pairs.flat_map(|pair| axes.clone().map(move |axis| change(pair, axis))).fold(0.0, f64::max)
}

#[test]
fn times_and_accelerations_are_those_of_the_plan_not_of_the_scene() {
    let plan = refined(0.002, &impatient());
    let result = result(&plan);
    let folder: PathBuf = tempfile::tempdir().unwrap().keep();
    trajectory::write_trajectory(&folder, &plan.trajectory, &plan.task).unwrap();

    let reference: Vec<StateRow> = read_csv(&folder.join("reference.csv")).unwrap();
    assert_eq!(reference.len(), 41);
    assert!((reference[1].time() - reference[0].time() - result.time_step_s).abs() < 1e-9);
    assert!((result.time_step_s - 0.04).abs() < 1e-12, "the scene has 0.08 s");
    let end = reference[40].time();
    let places = result.scenarios.iter().flat_map(|scenario| {
        scenario.max_penetration_at.iter().chain(&scenario.max_complementarity_at).collect::<Vec<_>>()
    });
    for place in places {
        assert!(place.time_s <= end && place.step <= 40, "{place:?} lies after the end at {end} s");
        assert!((place.time_s - 0.04 * place.step as f64).abs() < 1e-9, "{place:?}");
    }

    let motions = [states(&folder, "reference.csv"), states(&folder, "scenarios.csv")].concat();
    assert_eq!(motions.len(), 1 + result.scenarios.len());
    for (reached, axes) in
        [(result.reached.translational_acceleration_m_s2, 0..3), (result.reached.rotational_acceleration_rad_s2, 3..6)]
    {
        let shown = largest_acceleration(&motions, result.time_step_s, axes);
        assert!((shown / reached - 1.0).abs() < 1e-9, "the tables show {shown}, the result says {reached}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_variant_of_two_homotopy_iterations_counts_as_converged() {
    let plan = refined(0.0009, &impatient());
    assert_eq!(plan.problem.homotopy().iterations, 5);
    assert!(plan.iterations.len() == 2 && plan.chosen().record.converged);
    assert!(plan.is_converged() && result(&plan).converged);
    let cut = Plan { iterations: plan.iterations[..1].to_vec(), ..plan };
    assert!(!cut.is_converged(), "one of its two homotopy steps did not run");
}

#[test]
fn a_planned_offset_that_fails_is_not_made_up_for_by_others() {
    let target = RobustnessTarget { target_rate: 0.0, ..impatient() };
    // Some of the planned offsets, or all of them, end farther away than this.
    let plan = refined(1e-4, &target);
    let report = plan.robustness.as_ref().unwrap();
    assert!(report.rate_after >= target.target_rate && !report.planned_offsets_succeed());
    assert_eq!(plan.status(), PlanStatus::NotRobust);
    assert!(!result(&plan).done && !result(&plan).goal_reached);
}

#[test]
fn a_limit_that_the_solve_has_used_up_leaves_the_plan_unjudged() {
    let target = RobustnessTarget { time_limit: Duration::ZERO, frictions: vec![0.0], ..RobustnessTarget::default() };
    let plan = refined(0.1, &target);
    let report = plan.robustness.as_ref().unwrap();
    assert!(report.after.0.iter().all(|group| group.rollouts == 0));
    assert_eq!((report.rate_after, report.reached), (0.0, false));
    assert_eq!(plan.status(), PlanStatus::OutOfTime(Cut::Evaluation { played: 0, of: 502 }));
    assert_eq!(plan.status().to_string(), "out of time: the time limit ended before the plan was tested");
    assert!(report.push.is_none() && plan.can_go_on() && explanation(&plan).is_none());
}

#[test]
fn evaluations_end_as_soon_as_they_are_decided() {
    let rollouts =
        |plan: &Plan| plan.robustness.as_ref().unwrap().after.0.iter().map(|group| group.rollouts).sum::<usize>();
    // Of 100 random offsets at each of five magnitudes, 299 show 99 %; they are played in groups of 24, after two planned ones.
    let (robust, lost) = (refined(0.1, &impatient()), refined(1e-5, &impatient()));
    assert!(robust.robustness.as_ref().unwrap().reached);
    assert_eq!(rollouts(&robust), 312);
    assert_eq!(rollouts(&lost), 24, "the first rollouts show that it cannot succeed");
}

#[test]
fn a_refinement_is_given_up_after_three_evaluations_in_vain() {
    let plan = refined(1e-5, &RobustnessTarget { stall_limit: 1, ..impatient() });
    let own = &plan.robustness.as_ref().unwrap().rounds[0];
    assert_eq!((own.planned.as_str(), own.rate), ("the scene as it is", Some(0.0)));
    assert_eq!(own.added_cases, 4 * 24, "what failed in the first evaluation and in three that were not better");
}

#[test]
fn a_count_of_changes_ends_a_refinement() {
    let plan = Plan { problem: corner(Success { position: 1e-5, ..Success::default() }), ..FINE.clone() };
    let tried = AtomicUsize::new(0);
    let count = |event: &Event| {
        tried.fetch_add(usize::from(matches!(event, Event::Perturbation { .. })), Ordering::Relaxed);
    };
    let target = RobustnessTarget { frictions: vec![0.0], max_perturbations: Some(7), ..RobustnessTarget::default() };
    let plan = refine(plan, &target, &Session::new(&count, &AtomicBool::new(false))).unwrap();
    assert_eq!(plan.status(), PlanStatus::NotRobust);
    assert_eq!(tried.into_inner(), 7, "no round begins after that");
}

#[test]
fn any_reference_can_be_refined_without_a_plan() {
    let problem = corner(Success::default());
    let task = problem.task();
    let mut beside = task.goal;
    beside.0[0] += 0.005;
    let push = Reference::straight(&task.start, &beside, task.horizon);
    let target = RobustnessTarget { frictions: vec![0.0], ..RobustnessTarget::default() };
    let (refined, report) = quietly(|session| refine_reference(&problem, push.clone(), &target, session)).unwrap();
    assert!(report.reached && report.kept_perturbations > 0, "{report:?}");
    assert_eq!(refined.start(), push.start());
    assert_eq!(report.kept_stage, 0, "no homotopy has run");
}

#[test]
fn status_and_success_never_contradict_each_other() {
    let plans = [1e-5, 5e-4, 2e-3, 1e-2, 0.1].into_iter().flat_map(|position| {
        // On the heap: plans are large for the stack of a test.
        let rates = [0.0, 0.5, 1.0].into_iter();
        let targets = rates.map(|target_rate| RobustnessTarget { target_rate, ..impatient() });
        let robust: Vec<Plan> = targets.map(|target| refined(position, &target)).collect();
        let success = Success { position, ..Success::default() };
        let plain = Plan { problem: corner(success), ..FINE.clone() };
        let cut = Plan { iterations: plain.iterations[..1].to_vec(), ..plain.clone() };
        let interrupted = Plan { stopped: Some(Stop::User), ..plain.clone() };
        [robust, vec![plain, cut, interrupted]].concat()
    });
    let (mut done, mut planned, mut missed) = (0, 0, 0);
    for plan in plans {
        let (status, result) = (plan.status(), result(&plan));
        assert_eq!((result.done, result.planned), (status == PlanStatus::Done, status == PlanStatus::Planned));
        assert_eq!(result.outcome, status.outcome());
        assert_eq!(result.status, status.to_string());
        let is_good = result.done || result.planned;
        assert!(!is_good || result.goal_reached && result.converged, "{status} {result:?}");
        assert_eq!(result.done, result.done && result.robust.is_some(), "what nobody has played is not done");
        assert!(status != PlanStatus::GoalMissed || !result.goal_reached && result.converged, "{status}");
        assert!(!matches!(status, PlanStatus::NotConverged { .. }) || !result.converged, "{status}");
        if let Some(report) = &result.robust {
            assert_eq!(report.reached, result.done);
        }
        done += usize::from(result.done);
        planned += usize::from(result.planned);
        missed += usize::from(status == PlanStatus::GoalMissed);
    }
    let seen = (done, planned, missed);
    assert!(done > 3 && planned > 1 && missed > 1, "{seen:?} done, planned, missed: not all statuses are seen");
}
