//! What constraints are and how far they are from their bounds.

use std::path::Path;

use kkt::Owner;
use nlp::Iterate;
use ocp::{
    Activity, CONTACT_FORCE, ConstraintIndex, GAP, Member, PRODUCT, REFERENCE_KINEMATICS, Residual, TWIST_VARIABLES,
    Transcription, VELOCITY_DYNAMICS,
};
use task::{AssemblyTask, Complementarity, HessianKind, POSE};

const STEPS: usize = 4;
const SIGMA: f64 = 1e-3;

fn task() -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = STEPS;
    task.limits.translational_velocity = 0.5;
    task.limits.rotational_acceleration = 3.0;
    task.limits.force = 2.0;
    task
}

fn transcription() -> Transcription {
    let mut transcription = Transcription::new(&task(), Complementarity::Relaxation, HessianKind::Exact);
    transcription.set_smoothing(1e-3, SIGMA);
    transcription
}

/// A point with distinct multipliers.
fn point(transcription: &Transcription, x: Vec<f64>) -> Iterate {
    let multipliers = |count: usize| (0..count).map(|index| index as f64).collect();
    Iterate {
        constraint_multipliers: multipliers(transcription.layout().constraint_count()),
        lower_multipliers: vec![0.0; x.len()],
        upper_multipliers: multipliers(x.len()),
        x,
    }
}

fn find(residuals: &[Residual], block: &str, stage: usize, owner: Owner, pair: Option<usize>) -> Vec<Residual> {
    let is_wanted = |Member { block: name, stage: at, owner: of, pair: with, .. }: &Member| {
        (*name, *at, *of, *with) == (block, stage, owner, pair)
    };
    residuals.iter().filter(|residual| is_wanted(&residual.member)).copied().collect()
}

#[test]
fn a_state_that_jumps_violates_the_rows_of_its_own_stage_and_axis() {
    let mut transcription = transcription();
    let mut x = transcription.formulation().initial_guess();
    let owner = Owner::Scenario(1);
    // The pose of the reference at stage 3, and the velocity of scenario 2 at the last stage, both along y.
    let reference = transcription.layout().state(3, Owner::Reference);
    x[reference + 1] += 0.25;
    let velocity = transcription.layout().state(STEPS, owner) + POSE;
    x[velocity + 1] += 0.75;
    let residuals = transcription.residuals(&point(&transcription, x)).unwrap();
    for (stage, expected) in [(2, 0.0), (3, 0.25), (4, 0.25)] {
        let rows = find(&residuals, REFERENCE_KINEMATICS, stage, Owner::Reference, None);
        assert_eq!(rows.len(), POSE);
        for row in rows {
            let expected = if row.member.component == 1 { expected } else { 0.0 };
            assert!((row.violation() - expected).abs() < 1e-12, "{row:?}");
        }
    }
    // The limit of 0.5 m/s is exceeded along y only.
    let bounds = find(&residuals, TWIST_VARIABLES, STEPS, owner, None);
    assert_eq!(bounds.len(), 3, "of translation only");
    for (axis, bound) in bounds.iter().enumerate() {
        assert_eq!(bound.violation(), if axis == 1 { 0.25 } else { 0.0 });
        assert_eq!(bound.activity(), (axis == 1).then_some(Activity::Upper));
        assert_eq!(bound.index, ConstraintIndex::Variable(velocity + axis));
        assert_eq!(bound.multiplier, (velocity + axis) as f64);
    }
    let dynamics = find(&residuals, VELOCITY_DYNAMICS, STEPS, owner, None);
    assert!(dynamics[1].violation() > 0.7 && dynamics[0].violation() < 0.1);
    assert_eq!(dynamics[1].missing(), -dynamics[1].value);
}

#[test]
fn rows_and_bounds_of_contacts_are_those_of_their_pair() {
    let mut transcription = transcription();
    let mut x = transcription.formulation().initial_guess();
    let owner = Owner::Scenario(0);
    let before = transcription.residuals(&point(&transcription, x.clone())).unwrap();
    x[transcription.layout().variable(CONTACT_FORCE, 2, owner) + 1] = 7.0;
    let after = transcription.residuals(&point(&transcription, x)).unwrap();
    for pair in [0, 1] {
        let [gap] = find(&after, GAP, 2, owner, Some(pair))[..] else { panic!("one gap per pair") };
        let [product] = find(&after, PRODUCT, 2, owner, Some(pair))[..] else { panic!("one product per pair") };
        let force = if pair == 1 { 7.0 } else { 1e-3 };
        assert!((product.value - gap.value * force).abs() < 1e-12, "{product:?}");
        assert_eq!((gap.activity(), product.upper), (None, SIGMA));
        assert_eq!(product.activity(), (pair == 1).then_some(Activity::Upper), "{product:?}");
    }
    // Nothing else changes but the balance of forces of that stage.
    for (one, other) in before.iter().zip(&after).filter(|(one, other)| one.value != other.value) {
        let member = other.member;
        assert_eq!((one.member, member.stage, member.owner), (member, 2, owner));
        assert!([VELOCITY_DYNAMICS, PRODUCT, CONTACT_FORCE].contains(&member.block), "{member:?}");
    }
}

#[test]
fn gradients_are_those_of_differences() {
    const STEP: f64 = 1e-6;
    let mut transcription = transcription();
    let x: Vec<f64> = transcription
        .formulation()
        .initial_guess()
        .iter()
        .zip(1..)
        .map(|(value, index)| value + 0.01 * f64::sin(index as f64))
        .collect();
    let residuals = transcription.residuals(&point(&transcription, x.clone())).unwrap();
    let chosen: Vec<Residual> = residuals.iter().step_by(7).copied().collect();
    let indices: Vec<ConstraintIndex> = chosen.iter().map(|residual| residual.index).collect();
    let gradients = transcription.gradients(&x, &indices).unwrap();
    for variable in (0..x.len()).step_by(11) {
        let mut values = |shift: f64| {
            let mut moved = x.clone();
            moved[variable] += shift;
            transcription.residuals(&point(&transcription, moved)).unwrap()
        };
        let (below, above) = (values(-STEP), values(STEP));
        for (number, residual) in chosen.iter().enumerate() {
            let row = 7 * number;
            let difference = (above[row].value - below[row].value) / (2.0 * STEP);
            let entry = gradients[number].iter().find(|(column, _)| *column == variable);
            let derivative = entry.map_or(0.0, |entry| entry.1);
            assert!((difference - derivative).abs() < 1e-5 * (1.0 + derivative.abs()), "{:?}", residual.member);
        }
    }
}
