//! Boundaries of motions whose end is known.

use std::sync::atomic::{AtomicBool, Ordering};

use plan::{Event, Problem, Session};
use simulation::Reference;
use tolerance::{
    Boundary, MapQuestion, Quantity, Question, Sensitivity, ToleranceRequest, Trials, Work, answer, boundary,
};

use crate::{SLOT, moved_down};

/// Far from everything.
const FLOOR: &str = "[[environment.part]]\nname = \"floor\"\nbox = [0.1, 0.1, 0.01]\nposition = [0.0, 0.0, -0.5]\n";

pub fn straight(problem: &Problem) -> Reference {
    let task = problem.task();
    Reference::straight(&task.start, &task.goal, task.horizon)
}

pub fn with_trials<R>(problem: &Problem, request: ToleranceRequest, ask: impl FnOnce(&Trials, &Session) -> R) -> R {
    let stopped = AtomicBool::new(false);
    let session = Session { threads: 2, ..Session::new(&|_: &Event| {}, &stopped) };
    ask(&Trials::new(problem, straight(problem), request, &session).unwrap(), &session)
}

fn found(problem: &Problem, quantity: Quantity) -> Boundary {
    let request = ToleranceRequest { cases: 500, ..ToleranceRequest::default() };
    with_trials(problem, request, |trials, session| {
        let base = trials.nominal().with(Quantity::Offset, 0.0).with(Quantity::Rotation, 0.0);
        boundary(trials, &base, quantity, session).unwrap().unwrap()
    })
}

/// Whether a boundary is the largest of the tried values that are not above a known one.
fn assert_at(boundary: &Boundary, known: f64, step: f64) {
    let value = boundary.value.unwrap();
    assert!(
        value <= known + 1e-9 && known < value + step,
        "{} at {value} instead of {known}",
        boundary.quantity.name()
    );
    let [surely, surely_not] = boundary.interval.map(Option::unwrap);
    assert!(surely <= value && value < surely_not && known < surely_not + 1e-9, "{boundary:?}");
    assert!(boundary.successes as f64 >= 0.99 * boundary.rollouts as f64);
}

#[test]
fn in_free_air_the_tolerances_of_the_goal_are_the_boundaries() {
    let problem = moved_down([0.02, 0.02, 0.02], FLOOR);
    // 64 values up to 4 mm, which is the first one that less than half of the rollouts stand, or 0.08 rad.
    assert_at(&found(&problem, Quantity::Offset), 0.003, 0.004 / 64.0 + 1e-9);
    assert_at(&found(&problem, Quantity::Hole), 0.003, 0.004 / 64.0 + 1e-9);
    assert_at(&found(&problem, Quantity::Rotation), 0.08, 0.16 / 64.0 + 1e-9);
    let friction = found(&problem, Quantity::Friction);
    assert!(friction.is_open && friction.value == Some(1.0), "nothing is touched: {friction:?}");
}

#[test]
fn a_slot_is_missed_by_what_is_off_by_more_than_the_clearance() {
    // 1 mm of clearance to each side, and no chamfer: a straight push ends on the rim, 20 mm above the goal, once the offset
    // across the slot is more than that. Along the slot, the tolerance of the goal holds.
    let problem = moved_down([0.02, 0.018, 0.02], SLOT);
    let offset = found(&problem, Quantity::Offset);
    assert_at(&offset, 0.001, 0.002 / 64.0 + 1e-9);
    let clearance =
        with_trials(&problem, ToleranceRequest { cases: 500, ..ToleranceRequest::default() }, |trials, session| {
            assert!((trials.clearance().unwrap() - 0.002).abs() < 1e-6);
            let base = trials.nominal().with(Quantity::Offset, 0.0005);
            boundary(trials, &base, Quantity::Clearance, session).unwrap().unwrap()
        });
    let value = clearance.value.unwrap();
    assert!((0.001..=0.001 + 0.004 / 64.0 + 1e-9).contains(&value), "half a millimetre to each side: {clearance:?}");
}

#[test]
fn more_clearance_buys_as_much_offset_to_each_side() {
    let problem = moved_down([0.02, 0.018, 0.02], SLOT);
    let request = ToleranceRequest { cases: 100, rate: 0.9, ..ToleranceRequest::default() };
    let drawn = with_trials(&problem, request, |trials, session| {
        let map = MapQuestion::new(trials, Quantity::Offset, Quantity::Clearance, &[0.003, 0.001, 0.002]).unwrap();
        let asked = Question { quantities: vec![Quantity::Offset], need: None, map: Some(map) };
        let mut work = Work::new(trials, &asked);
        let mut reference_at = |_| Ok(Some(trials.reference().clone()));
        answer(trials, &asked, &mut work, &mut reference_at, session).unwrap().unwrap().map.unwrap()
    });
    let values: Vec<f64> = drawn.rows.iter().map(|row| row.boundary.value.unwrap()).collect();
    assert_eq!(drawn.rows.iter().map(|row| (1e4 * row.at).round()).collect::<Vec<_>>(), [10.0, 20.0, 30.0]);
    assert!(values.windows(2).all(|pair| (pair[1] - pair[0] - 0.0005).abs() < 1e-4), "{values:?}");
    let Sensitivity { between, slope, interval: [low, high], sentence } = drawn.sensitivity.unwrap();
    assert!(
        between == [0.001, 0.003] && (slope - 0.5).abs() < 0.05 && low < 0.5 && 0.5 < high,
        "{slope}: {low} to {high}"
    );
    assert!(sentence.starts_with("1 mm more clearance buys 0.5"), "{sentence}");
}

#[test]
fn what_cannot_be_tolerated_has_no_boundary() {
    // The tolerance of the position is missed from the beginning: the reference ends somewhere else.
    let problem = moved_down([0.02, 0.018, 0.02], SLOT);
    let stopped = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &stopped);
    let elsewhere = straight(&problem).shifted(&nalgebra::Vector3::new(0.0, 0.0, 0.01));
    let request = ToleranceRequest { cases: 500, ..ToleranceRequest::default() };
    let trials = Trials::new(&problem, elsewhere, request, &session).unwrap();
    let boundary = boundary(&trials, &trials.nominal(), Quantity::Friction, &session).unwrap().unwrap();
    assert_eq!((boundary.value, boundary.interval[0], boundary.successes), (None, None, 0));
}

#[test]
fn an_interrupt_and_wrong_requests_end_it() {
    let problem = moved_down([0.02, 0.02, 0.02], FLOOR);
    with_trials(&problem, ToleranceRequest::default(), |trials, _| {
        let stopped = AtomicBool::new(true);
        let session = Session::new(&|_: &Event| {}, &stopped);
        assert_eq!(boundary(trials, &trials.nominal(), Quantity::Offset, &session).unwrap(), None);
        stopped.store(false, Ordering::Relaxed);
        let error = boundary(trials, &trials.nominal(), Quantity::Clearance, &session).unwrap_err().to_string();
        assert!(error.starts_with("clearance: nothing guides the body"), "{error}");
    });
    for request in [
        ToleranceRequest { rate: 1.0, ..ToleranceRequest::default() },
        ToleranceRequest { rate: f64::NAN, ..ToleranceRequest::default() },
        ToleranceRequest { cases: 3, ..ToleranceRequest::default() },
        ToleranceRequest { frictions: vec![], ..ToleranceRequest::default() },
        ToleranceRequest { frictions: vec![f64::NAN], ..ToleranceRequest::default() },
    ] {
        assert!(request.validate().is_err(), "{request:?}");
    }
}
