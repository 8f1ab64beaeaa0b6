//! Absurd input: nothing panics or hangs.

use simulation::{
    Disturbance, Evaluator, FrictionIndex, Perturbation, Reference, Refinement, Rollout, Settings, Success, TestCase,
    offsets,
};
use task::{GraspError, Inertia};

use crate::world::{at_rest, block, hole, task, through};

const ABSURD: [f64; 8] = [0.0, -1.0, 1e-300, 1e150, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

fn world() -> task::AssemblyTask {
    task(&block([0.04, 0.04, 0.08], [0.0; 3]), &hole(0.042))
}

fn short() -> Reference {
    through(&[[0.001, 0.0, 0.05], [0.0, 0.0, 0.03]], 0.05)
}

#[test]
fn settings_out_of_range_are_not_simulated() {
    let valid = Settings { settling_time: 0.0, ..Settings::default() };
    for value in ABSURD {
        for settings in [
            Settings { time_step: value, ..valid },
            Settings { friction: value, ..valid },
            Settings { settling_time: value, ..valid },
        ] {
            let outcome = Rollout::new(&world(), settings).play(&short(), [0.0; 3], |_, _| {});
            assert_eq!(outcome.diverged, settings.validate().is_err(), "{settings:?}");
        }
    }
}

#[test]
fn references_with_absurd_time_steps_are_not_simulated() {
    let rollout = Rollout::new(&world(), Settings::default());
    for time_step in ABSURD {
        let reference = Reference::new(time_step, &short().states());
        assert!(rollout.play(&reference, [0.0; 3], |_, _| panic!("not simulated")).diverged);
        let trajectory = rollout.trajectory(&reference, &[[0.0; 3]], 1e-5);
        assert_eq!(trajectory.scenarios[0].states.len(), 1);
    }
}

#[test]
fn references_tasks_and_grasps_with_absurd_values_end() {
    let settings = Settings { settling_time: 0.01, friction: 0.2, ..Settings::default() };
    let rollout = Rollout::new(&world(), settings);
    let evaluator = Evaluator::new(&world(), &[0.0, 0.2], Success { position: 0.0, orientation: f64::NAN });
    for value in ABSURD {
        for component in 0..13 {
            let mut state = at_rest([0.0, 0.0, 0.05]);
            state.0[component] = value;
            let reference = Reference::new(0.01, &[at_rest([0.0, 0.0, 0.05]), state, state]);
            let outcome = rollout.play(&reference, [0.0; 3], |_, _| {});
            assert!(outcome.diverged || outcome.pose.iter().all(|component| component.is_finite()));
            rollout.trajectory(&reference, &[[0.0; 3]], value);
            evaluator.bounds().clone().near(&[&reference], value, value, value).allow(&reference);
        }
        for grasp in [
            GraspError { offset: [value; 3], rotation: [0.0; 3] },
            GraspError { offset: [0.0; 3], rotation: [value; 3] },
        ] {
            rollout.play(&short(), grasp, |_, _| {});
            evaluator.evaluate(
                &short(),
                &TestCase { friction: FrictionIndex(1), grasp, disturbance: Disturbance::default() },
            );
        }
        let mut absurd = world();
        absurd.inertia = Inertia::of_body(value, absurd.inertia.rotational());
        absurd.impedance.translational_stiffness = value;
        Rollout::new(&absurd, settings).play(&short(), [0.0; 3], |_, _| {});
        let mut absurd = world();
        absurd.inertia = Inertia::from_matrix(absurd.inertia.matrix() * value);
        absurd.impedance.rotational_stiffness = value;
        Rollout::new(&absurd, settings).play(&short(), [0.0; 3], |_, _| {});
        offsets::ball(value, 10, 1);
        offsets::hull(&[[value; 3]; 2], 10, 1);
        offsets::grid(&[[value; 3]; 2], 10);
    }
}

#[test]
fn a_reference_of_one_knot_can_be_simulated_and_refined() {
    let reference = Reference::new(0.04, &[at_rest([0.0; 3])]);
    let perturbation = Perturbation::random(&mut fastrand::Rng::with_seed(1), &Success::default());
    assert_eq!(reference.perturbed(&perturbation), reference);
    assert_eq!(reference.at(usize::MAX, 0.5), reference.at(0, 0.0));
    let evaluator = Evaluator::new(&world(), &[0.0], Success::default());
    let cases = vec![TestCase {
        friction: FrictionIndex(0),
        grasp: GraspError::default(),
        disturbance: Disturbance::default(),
    }];
    let results = evaluator.evaluate_all(&reference, &cases, &|| false).unwrap();
    let mut refinement = Refinement::new(&evaluator, reference, cases, results, 1);
    refinement.improve(&|| false);
    assert!(refinement.reference().start().iter().all(|component| component.is_finite()));
}
