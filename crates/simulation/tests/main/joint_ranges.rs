//! Ranges of joints in refinement.

use std::path::Path;

use simulation::{ArmModel, Disturbance, Evaluator, FrictionIndex, Reference, Refinement, Success, TestCase};

use crate::arms::{self, Record};

/// Positions (rad) of the elbow along a reference.
fn elbow(model: &ArmModel, reference: &Reference) -> Vec<f64> {
    let poses = reference.states().into_iter().enumerate();
    let motion: Vec<_> = poses.map(|(index, state)| (index as f64, state.pose().isometry())).collect();
    let path = model.arm.follow_back(&motion, &model.arm.configuration(&model.configuration).unwrap()).unwrap();
    path.configurations.iter().map(|configuration| configuration[2]).collect()
}

#[test]
fn refinement_keeps_the_ranges_of_joints() {
    let content = arms::content("rubbing");
    let record = Record::read("rubbing");
    let ends = |positions: &[f64]| positions.iter().fold([f64::MAX, f64::MIN], |[a, b], q| [a.min(*q), b.max(*q)]);
    let [least, most] = ends(&elbow(&record.model, &record.reference));
    let [lower, upper] = [least - 0.01, most + 0.01];
    let wide = std::fs::read_to_string(arms::urdf(&content)).unwrap();
    let narrow = wide.replace(r#"lower="-3" upper="3""#, &format!(r#"lower="{lower}" upper="{upper}""#));
    assert_ne!(wide, narrow);
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("narrow.urdf");
    std::fs::write(&file, narrow).unwrap();
    let refined = |held: Record| {
        let mut task = held.task.clone();
        task.goal.0[0] += 0.03;
        let evaluator = Evaluator::new(&task, &[0.0], Success::default()).with_arm(&held.model).unwrap();
        let cases = [TestCase { friction: FrictionIndex(0), grasp: held.grasp, disturbance: Disturbance::default() }];
        let results = evaluator.evaluate_all(&held.reference, &cases, &|| false).unwrap();
        let mut refinement = Refinement::new(&evaluator, held.reference, cases.to_vec(), results, 1);
        let improvements = (0..40).filter(|_| refinement.improve(&|| false)).count();
        assert!(improvements > 0);
        ends(&elbow(&record.model, refinement.reference()))
    };
    let [least, most] = refined(Record::of(&content, &file));
    assert!(least >= lower + 0.01 - 1e-6 && most <= upper - 0.01 + 1e-6, "{least} to {most} rad");
    let [least, most] = refined(Record::read("rubbing"));
    assert!(least < lower || most > upper, "without these ends of the range, they are passed: {least} to {most} rad");
}
