//! Errors of a transcription that cannot be evaluated.

use std::path::Path;

use nlp::Problem;
use ocp::{MissingDistance, Owners, Transcription};
use task::{Complementarity, HessianKind};
use workers::Workers;

#[test]
fn a_distance_that_cannot_be_computed_is_named_by_pair_scenario_and_step() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = 3;
    let mut problem = Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact);
    problem.set_smoothing(0.0025, 0.00125);
    let mut x = problem.formulation().initial_guess();
    let (stage, owner) = problem.layout().stages_of(Owners::Scenarios).nth(1).unwrap();
    x[problem.layout().state(stage, owner)] = f64::NAN;
    problem.set_point(&x).unwrap();
    let error = problem.constraints(&mut vec![0.0; problem.layout().constraint_count()]).unwrap_err();
    let missing: &MissingDistance = error.reason().downcast_ref().unwrap();
    assert_eq!((missing.scenario, missing.step), (1, 1));
    assert_eq!((&missing.body, &missing.environment), (&task.pairs[0].body, &task.pairs[0].environment));
    assert!(error.to_string().contains("in scenario 2 at step 1: "), "{error}");
    // Any later pose and pair, with any number of threads: the first one that fails is named.
    task.horizon.steps = 100;
    for threads in [1, 3] {
        let problem = Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact);
        let mut problem = problem.with_workers(Workers::new(threads));
        problem.set_smoothing(0.0025, 0.00125);
        let mut x = problem.formulation().initial_guess();
        let (stage, owner) = problem.layout().stages_of(Owners::Scenarios).nth(150).unwrap();
        x[problem.layout().state(stage, owner)] = f64::NAN;
        problem.set_point(&x).unwrap();
        let error = problem.constraints(&mut vec![0.0; problem.layout().constraint_count()]).unwrap_err();
        let missing: &MissingDistance = error.reason().downcast_ref().unwrap();
        assert_eq!((missing.scenario, missing.step, &missing.body), (0, 76, &task.pairs[0].body));
    }
}
