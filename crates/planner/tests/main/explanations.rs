//! Plans that are not done name what is wrong with their scene.

use std::sync::atomic::AtomicBool;

use planner::explain::{DependencyRecord, FailureExplanation, explanation};
use planner::{
    Choices, Event, GraspErrors, Motion, OffsetSource, Plan, PlanStatus, Problem, RobustnessTarget, Session,
    SimulationRequest, refine, simulate, solve,
};

/// A flat box above the middle of a floor; a homotopy that tries nothing else.
const SCENE: &str = r#"
title = "floor"
[[body.part]]
name = "box"
box = [0.1, 0.08, 0.06]
[[environment.part]]
name = "floor"
box = [0.6, 0.6, 0.1]
position = [0.0, 0.0, -0.05]
[[start]]
name = "above"
position = [0.0, 0.0, 0.08]
orientation = [1, 0, 0, 0]
[goal]
position = [0.0, 0.0, 0.031]
orientation = [1, 0, 0, 0]
[impedance]
translational_stiffness = 50.0
rotational_stiffness = 5.0
[robustness]
offset_magnitude = 0.01
offset_directions = [[0, 0, 0], [0, 0, 1]]
[horizon]
steps = 10
time_step = 0.08
[homotopy]
iterations = 4
tau = 0.0025
further_iterations = 0
[ipopt]
max_iter = 500
"#;

/// The scene with some texts replaced and others added at its end.
fn problem_with(changes: &[(&str, &str)], added: &str, choices: &Choices) -> Problem {
    let mut text = SCENE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text + added).unwrap();
    Problem::load(&file, choices).unwrap()
}

fn plan_of(problem: &Problem) -> Plan {
    solve(problem, &Session::new(&|_: &Event| {}, &AtomicBool::new(false))).unwrap()
}

fn plan_with(changes: &[(&str, &str)], added: &str) -> Plan {
    plan_of(&problem_with(changes, added, &Choices::default()))
}

#[track_caller]
fn explained(plan: &Plan) -> FailureExplanation {
    explanation(plan).unwrap_or_else(|| panic!("{}", plan.status()))
}

#[track_caller]
fn advises(explanation: &FailureExplanation, words: &[&str]) {
    let found = explanation.advice.iter().any(|advice| words.iter().all(|word| advice.contains(word)));
    assert!(found, "no advice with {words:?}: {:#?}", explanation.advice);
}

#[track_caller]
fn says_nothing_of(explanation: &FailureExplanation, word: &str) {
    assert!(!explanation.advice.iter().any(|advice| advice.contains(word)), "{:#?}", explanation.advice);
}

const SHELF: &str = "\n[[environment.part]]\nname = \"shelf\"\nbox = [0.6, 0.6, 0.02]\nposition = [0, 0, 0.1]\n";

#[test]
fn a_plan_that_is_done_needs_no_explanation() {
    let plan = plan_with(&[], "");
    assert_eq!(plan.status(), PlanStatus::Planned);
    assert_eq!(explanation(&plan), None);
}

#[test]
fn a_shelf_in_the_way_is_named_as_what_holds_the_body() {
    let plan = plan_with(&[("position = [0.0, 0.0, 0.08]", "position = [0.0, 0.0, 0.17]")], SHELF);
    assert_eq!(plan.status(), PlanStatus::GoalMissed);
    let explanation = explained(&plan);
    assert_eq!(explanation.scenarios.len(), 2, "both scenarios");
    for scenario in &explanation.scenarios {
        // The middle of the shelf is 69 mm above the goal.
        assert!(scenario.end.position_error_m > 0.069, "{scenario}");
        assert_eq!(scenario.end.goal_direction.as_deref(), Some("-z"));
        let pairs: Vec<&str> = scenario.end.held_by.iter().map(|hold| hold.pair.as_str()).collect();
        assert_eq!(pairs, ["box/shelf"]);
    }
    advises(&explanation, &["[[start]]", "box/shelf"]);
    // More time would not help.
    says_nothing_of(&explanation, "[horizon]");
    assert!(explanation.dependencies.is_empty(), "what holds does not contradict");
}

#[test]
fn a_goal_inside_of_a_part_is_named_with_its_depth() {
    let plan = plan_with(&[("position = [0.0, 0.0, 0.031]", "position = [0.0, 0.0, 0.01]")], "");
    let explanation = explained(&plan);
    advises(&explanation, &["[goal]", "box/floor", "20.00 mm"]);
    says_nothing_of(&explanation, "[[start]]");
}

#[test]
fn a_horizon_that_is_too_short_is_named_and_the_advised_one_is_long_enough() {
    let limits = "\n[limits]\nforce = 1.0\n";
    let plan = plan_with(&[("steps = 10", "steps = 3")], limits);
    assert_eq!(plan.status(), PlanStatus::GoalMissed);
    let explanation = explained(&plan);
    assert!(explanation.scenarios.iter().all(|scenario| scenario.end.from_s.is_none()), "they still come nearer");
    advises(&explanation, &["[limits]: force = 1 N is reached in 3 of 3 steps"]);
    let advice = explanation.advice.iter().find(|advice| advice.starts_with("[horizon]")).expect("advice of a horizon");
    let after = advice.split("set steps = ").nth(1).unwrap();
    let steps = format!("steps = {}", after.split(' ').next().unwrap());
    let longer = plan_with(&[("steps = 10", &steps)], limits);
    assert!(longer.trajectory.worst_error().position < 0.7 * plan.trajectory.worst_error().position, "{advice}");
}

#[test]
fn a_limit_that_does_not_let_the_start_come_out_of_a_part_contradicts_its_gap() {
    let sunk = ("position = [0.0, 0.0, 0.08]", "position = [0.0, 0.0, 0.0]");
    for (limit, value) in [("translational_acceleration", 0.5), ("translational_velocity", 0.1)] {
        let plan = plan_with(&[sunk], &format!("\n[limits]\n{limit} = {value}\n"));
        assert!(matches!(plan.status(), PlanStatus::NotConverged { .. }), "{}", plan.status());
        let explanation = explained(&plan);
        let named = |dependency: &DependencyRecord, word: &str| {
            dependency.constraints.iter().any(|constraint| constraint.starts_with(word))
        };
        let contradiction = explanation.dependencies.iter().find(|dependency| dependency.contradict);
        let contradiction = contradiction.unwrap_or_else(|| panic!("{explanation:#?}"));
        assert_eq!((contradiction.constraints.len(), contradiction.more), (2, 0), "{contradiction}");
        assert!(named(contradiction, "gap of box/floor in scenario 2 at 0.08 s"), "{contradiction}");
        assert!(named(contradiction, &format!("limits.{limit} (z) in scenario 2 at 0.08 s")), "{contradiction}");
        advises(&explanation, &["[[start]] \"above\"", "box/floor", "40.00 mm"]);
    }
}

#[test]
fn two_parts_that_leave_no_room_contradict_each_other() {
    let part = |name: &str, x: f64| {
        format!("\n[[environment.part]]\nname = \"{name}\"\nbox = [0.1, 0.6, 0.1]\nposition = [{x}, 0, 0.25]\n")
    };
    let walls = part("left", -0.09) + &part("right", 0.09);
    let plan = plan_with(&[("position = [0.0, 0.0, 0.08]", "position = [0.0, 0.0, 0.25]")], &walls);
    let explanation = explained(&plan);
    let contradiction = &explanation.dependencies[0];
    assert!(contradiction.contradict, "{contradiction}");
    for pair in ["box/left", "box/right"] {
        assert!(contradiction.constraints.iter().any(|constraint| constraint.contains(pair)), "{contradiction}");
    }
}

#[test]
fn the_largest_violation_is_that_of_the_solver() {
    let sunk = ("position = [0.0, 0.0, 0.08]", "position = [0.0, 0.0, 0.0]");
    let plan = plan_with(&[sunk], "\n[limits]\ntranslational_acceleration = 0.5\n");
    let residuals = explained(&plan).residuals;
    let [first, ..] = &residuals[..] else { panic!("no violation") };
    assert!((first.violation - plan.chosen().record.constraint_violation).abs() < 1e-9, "{first}");
    assert_eq!((first.kind.as_str(), first.pair.as_deref()), ("gap", Some("box/floor")));
    assert!(residuals.windows(2).all(|pair| pair[0].violation >= pair[1].violation));
    let kinds: Vec<_> = residuals.iter().map(|residual| (&residual.kind, &residual.unit)).collect();
    assert!((1..kinds.len()).all(|index| !kinds[..index].contains(&kinds[index])), "each kind once: {kinds:?}");
}

#[test]
fn an_iteration_limit_is_named() {
    let explanation = explained(&plan_with(&[("max_iter = 500", "max_iter = 2")], ""));
    advises(&explanation, &["[ipopt]: max_iter", "after 2 iterations"]);
}

#[test]
fn a_plan_that_is_not_robust_names_the_friction_and_an_error_that_fails_in_simulation() {
    let choices = Choices { position_tolerance: Some(1.05e-3), ..Choices::default() };
    let sideways = ("offset_directions = [[0, 0, 0], [0, 0, 1]]", "offset_directions = [[0, 0, 0], [1, 0, 0]]");
    let problem = problem_with(&[sideways], "", &choices);
    let target = RobustnessTarget { frictions: vec![0.0, 0.5], stall_limit: 0, ..RobustnessTarget::default() };
    let stopped = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &stopped);
    let plan = refine(plan_of(&problem), &target, &session).unwrap();
    assert_eq!(plan.status(), PlanStatus::NotRobust);
    assert_eq!(explanation(&plan), None, "a refined plan has its own");
    let report = plan.robustness.as_ref().unwrap();
    let loss = report.loss.as_ref().unwrap();
    let least = report.after.by_friction().map(planner::rate).fold(1.0, f64::min);
    assert_eq!(loss.rate, least);
    assert_eq!(loss.offset_direction.as_deref(), Some("+x"), "nothing holds the box along x");
    let request = SimulationRequest {
        errors: GraspErrors { offsets: OffsetSource::Listed(vec![loss.grasp.offset_m]), ..GraspErrors::default() },
        frictions: vec![loss.worst.friction],
        ..SimulationRequest::default()
    };
    let played = simulate(&problem, &[(Motion::Plan, plan.reference())], &request, &session).unwrap();
    assert!(!played[0].success);
    assert!((played[0].outcome.position_error - loss.end.position_error_m).abs() < 1e-12);
}
