//! Measurements that go on where another one was interrupted.

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use plan::{Event, PlannerError, Problem, Session};
use tolerance::{
    MapQuestion, Need, Quantity, Question, ToleranceRecord, ToleranceRequest, Trials, Work, answer, answer_one,
};

use crate::boundaries::{straight, with_trials};
use crate::{SLOT, moved_down};

fn slot() -> Problem {
    moved_down([0.02, 0.018, 0.02], SLOT)
}

fn few() -> ToleranceRequest {
    ToleranceRequest { cases: 40, rate: 0.8, frictions: vec![0.1], seed: 1 }
}

fn question(trials: &Trials) -> Question {
    let map = MapQuestion::new(trials, Quantity::Offset, Quantity::Friction, &[0.0, 0.2]).unwrap();
    Question {
        quantities: vec![Quantity::Offset, Quantity::Hole],
        need: Some(Need { quantity: Quantity::Offset, value: 0.0005, by: Quantity::Clearance }),
        map: Some(map),
    }
}

/// Hands over trials of the slot, a session that `stopped` interrupts, and the number of rollouts so far.
fn with_slot<T>(stopped: &AtomicBool, work: impl FnOnce(&Trials, &Session, &AtomicUsize) -> T) -> T {
    let (problem, played) = (slot(), AtomicUsize::new(0));
    let observer = |event: &Event| {
        if let Event::Rollouts { .. } = event {
            played.fetch_add(1, Ordering::Relaxed);
        }
    };
    let session = Session { threads: 2, ..Session::new(&observer, stopped) };
    let trials = Trials::new(&problem, straight(&problem), few(), &session).unwrap();
    work(&trials, &session, &played)
}

/// Measures with the finished boundaries of a record, until `most` further ones are finished. Returns the answer, all records
/// that were kept, and the number of rollouts.
fn measured(resumed: Option<&str>, most: usize) -> (Option<ToleranceRecord>, Vec<String>, usize) {
    let (stopped, records) = (AtomicBool::new(false), RefCell::new(Vec::new()));
    let keep = |record: &[u8]| {
        records.borrow_mut().push(String::from_utf8(record.to_vec()).unwrap());
        stopped.store(records.borrow().len() == most, Ordering::Relaxed);
        Ok(())
    };
    let (answered, played) = with_slot(&stopped, |trials, session, played| {
        let asked = question(trials);
        let begun = Work::new(trials, &asked);
        let begun = if let Some(text) = resumed { begun.resumed(text).unwrap() } else { begun };
        let mut reference_at = |_| Ok(Some(trials.reference().clone()));
        let answered = answer(trials, &asked, &mut begun.kept_by(&keep), &mut reference_at, session).unwrap();
        (answered, played.load(Ordering::Relaxed))
    });
    (answered, records.into_inner(), played)
}

#[test]
fn an_answer_in_parts_is_the_whole_one() {
    let (whole, records, all) = measured(None, 0);
    let whole = whole.unwrap().json().unwrap();
    assert_eq!(records.len(), 5, "two boundaries, the need, and two rows");
    let (mut resumed, mut played) = (None::<String>, 0);
    for part in 1..=5 {
        let (answered, mut records, rollouts) = measured(resumed.as_deref(), 1);
        played += rollouts;
        resumed = records.pop();
        // The interrupt after the last boundary comes too late.
        assert_eq!(answered.map(|record| record.json().unwrap()), (part == 5).then(|| whole.clone()));
    }
    assert_eq!(played, all, "nothing is measured twice");
    let (answered, records, rollouts) = measured(resumed.as_deref(), 0);
    assert_eq!((answered.unwrap().json().unwrap(), records.len(), rollouts), (whole, 0, 0), "all is finished");
}

#[test]
fn boundaries_of_several_processes_are_one_answer() {
    let (whole, _, all) = measured(None, 0);
    with_slot(&AtomicBool::new(false), |trials, session, played| {
        let (asked, records) = (question(trials), RefCell::new(Vec::new()));
        let keep = |record: &[u8]| {
            records.borrow_mut().push(String::from_utf8(record.to_vec()).unwrap());
            Ok(())
        };
        let mut reference_at = |_| Ok(Some(trials.reference().clone()));
        let mut measure = |index: usize| {
            let mut work = Work::new(trials, &asked).kept_by(&keep);
            answer_one(trials, &asked, index, &mut work, &mut reference_at, session)
        };
        for index in [4, 2, 0, 1, 3] {
            assert!(measure(index).unwrap().is_some());
        }
        assert!(measure(5).unwrap_err().to_string().contains("5 boundaries are asked for, counted from 0"));
        assert_eq!(played.load(Ordering::Relaxed), all, "each measures its own");

        let mut work =
            records.borrow().iter().fold(Work::new(trials, &asked), |work, text| work.resumed(text).unwrap());
        let answered = answer(trials, &asked, &mut work, &mut reference_at, session).unwrap();
        assert_eq!(answered.unwrap().json().unwrap(), whole.unwrap().json().unwrap());
        assert_eq!(played.load(Ordering::Relaxed), all, "nothing is measured twice");
    });
}

#[test]
fn records_of_other_measurements_and_damaged_ones_are_refused() {
    let (_, records, _) = measured(None, 1);
    let text = &records[0];
    let refused = |problem: &Problem, request: ToleranceRequest, change: &dyn Fn(&mut Question)| {
        with_trials(problem, request, |trials, _| {
            let mut asked = question(trials);
            change(&mut asked);
            Work::new(trials, &asked).resumed(text).map(|work| work.count()).map_err(|error| error.to_string())
        })
    };
    let same = |_: &mut Question| {};
    assert_eq!(refused(&slot(), few(), &same), Ok(1));
    let expect = |found: Result<usize, String>, what: &str| assert_eq!(found, Err(format!("it has another {what}")));
    let scene = moved_down([0.02, 0.017, 0.02], SLOT);
    expect(refused(&scene, few(), &same), "scene, start, offset or tolerance of success");
    expect(refused(&slot(), ToleranceRequest { rate: 0.9, ..few() }, &same), "--target-rate");
    expect(refused(&slot(), ToleranceRequest { frictions: vec![0.2], ..few() }, &same), "--friction");
    expect(refused(&slot(), ToleranceRequest { cases: 41, ..few() }, &same), "--cases");
    expect(refused(&slot(), ToleranceRequest { seed: 2, ..few() }, &same), "--seed");
    expect(refused(&slot(), few(), &|asked| asked.quantities.truncate(1)), "--quantity");
    expect(refused(&slot(), few(), &|asked| asked.need = None), "--need or --by");
    expect(refused(&slot(), few(), &|asked| asked.map = None), "map");

    let (problem, stopped) = (slot(), AtomicBool::new(false));
    let session = Session::new(&|_: &Event| {}, &stopped);
    let shifted = straight(&problem).shifted(&nalgebra::Vector3::new(0.0, 0.0, 1e-9));
    let trials = Trials::new(&problem, shifted, few(), &session).unwrap();
    let resumed =
        |text: &str| Work::new(&trials, &question(&trials)).resumed(text).map(|_| ()).unwrap_err().to_string();
    assert_eq!(resumed(text), "it has another plan");
    assert_eq!(resumed(&text.replacen("\"rollouts\":40", "\"rollouts\":41", 1)), "its checkpoint is damaged");
    assert_eq!(resumed(&text[..text.len() / 2]), "its checkpoint is damaged");
    assert_eq!(
        resumed(&text.replacen("\"format\":1", "\"format\":99", 1)),
        "a newer version of assembly-plan has left it"
    );
}

#[test]
fn what_cannot_be_kept_ends_the_measurement() {
    with_trials(&slot(), few(), |trials, session| {
        let asked = question(trials);
        let keep = |_: &[u8]| Err(PlannerError::Internal("full"));
        let mut work = Work::new(trials, &asked).kept_by(&keep);
        let mut reference_at = |_| Ok(Some(trials.reference().clone()));
        let error = answer(trials, &asked, &mut work, &mut reference_at, session).unwrap_err();
        assert!(error.to_string().contains("full"), "{error}");
    });
}
