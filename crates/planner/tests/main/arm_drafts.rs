//! Robust plans of an arm whose own plan fails begin at the best of many drafts, and at the next one where that gets stuck.

use crate::support;

use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use planner::{Choices, Event, RobustnessTarget, Session, refine, solve};

#[test]
#[ignore = "slow, eight drafts for an arm: scripts/test and CI run it"]
fn the_best_draft_is_refined_where_the_plan_of_an_arm_fails() {
    // Nothing is as accurate as that: every plan fails.
    let accurate = Choices { position_tolerance: Some(1e-6), ..Choices::default() };
    let problem = support::problem_of_arm(0.002, &accurate);
    let said = Mutex::new(Vec::new());
    let observer = |event: &Event| match event {
        Event::Variant { name, .. } => said.lock().unwrap().push((*name).to_owned()),
        Event::VariantSolved { status } => said.lock().unwrap().push((*status).to_owned()),
        _ => {}
    };
    let interrupted = AtomicBool::new(false);
    let session = Session::new(&observer, &interrupted);
    let plan = solve(&problem, &session).unwrap();
    // Ended by the count of changes: in so much time, all drafts are made on any machine.
    let time_limit = Duration::from_secs(10_000);
    let mut target =
        RobustnessTarget { stall_limit: 1, max_perturbations: Some(20), time_limit, ..RobustnessTarget::default() };
    target.parameters.drafts.most = 8;
    let plan = refine(plan, &target, &session).unwrap();
    let report = plan.robustness.unwrap();
    let planned: Vec<&str> = report.rounds.iter().map(|round| round.planned.as_str()).collect();
    let drafts: Vec<_> = report.rounds.iter().filter(|round| round.planned.starts_with("draft with")).collect();
    assert!(planned[1].starts_with("draft with"), "the best of them is refined first: {planned:?}");
    // As nothing is promising, others follow until all changes have been tried.
    let names: BTreeSet<&str> = drafts.iter().map(|round| round.planned.trim_end_matches(", continued")).collect();
    // So few steps are not halved.
    let steps = problem.task().horizon.steps;
    assert!(drafts.iter().all(|round| [steps, steps + steps / 2].contains(&round.steps)), "{drafts:?}");
    assert!(!planned.iter().any(|name| name.starts_with("a straight push")), "{planned:?}");
    let said = said.into_inner().unwrap();
    assert_eq!(said[0], "drafts");
    let count: usize = said[1].strip_suffix(" drafts").unwrap().parse().unwrap();
    assert!(count >= names.len(), "{said:?}");
}
