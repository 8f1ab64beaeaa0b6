//! Dynamic similarity: a body that is heavier by a factor, and held more stiffly by the same, moves alike, and its optimal
//! control problem is the same one.

use std::path::Path;

use nlp::{Iterate, Problem};
use ocp::{CONTACT_FORCE, ConstraintIndex, Member, PRODUCT, Residual, Transcription};
use task::{AssemblyTask, Complementarity, HessianKind, Inertia};

/// How many times as heavy and stiff.
const FACTOR: f64 = 16.0;

fn light() -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = 3;
    task.frictions = vec![0.1];
    task.limits.contact_force = 5.0;
    task
}

fn heavy() -> AssemblyTask {
    let mut task = light();
    task.inertia = Inertia::from_matrix(task.inertia.matrix() * FACTOR);
    task.impedance.translational_stiffness *= FACTOR;
    task.impedance.rotational_stiffness *= FACTOR;
    task.impedance.translational_damping *= FACTOR;
    task.impedance.rotational_damping *= FACTOR;
    task.limits.contact_force *= FACTOR;
    task
}

fn transcription(task: &AssemblyTask) -> Transcription {
    let mut transcription = Transcription::new(task, Complementarity::Relaxation, HessianKind::Exact);
    transcription.set_smoothing(1e-3, 1e-3);
    transcription
}

/// A point that is no solution.
fn point(transcription: &Transcription) -> Vec<f64> {
    let guess = transcription.formulation().initial_guess();
    guess.iter().zip(1..).map(|(value, index)| value + 0.01 * f64::sin(index as f64).abs()).collect()
}

fn assert_close(one: &[f64], other: &[f64]) {
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(other) {
        assert!(one == other || (one - other).abs() < 1e-12 * one.abs().max(1.0), "{one} {other}");
    }
}

#[test]
fn heavy_and_stiff_is_the_same_problem_as_light_and_soft() {
    let evaluated = [light(), heavy()].map(|task| {
        let mut transcription = transcription(&task);
        let x = point(&transcription);
        transcription.set_point(&x).unwrap();
        let mut constraints = vec![0.0; transcription.layout().constraint_count()];
        transcription.constraints(&mut constraints).unwrap();
        let mut jacobian = vec![0.0; transcription.jacobian_pattern().rows.len()];
        transcription.jacobian(&mut jacobian).unwrap();
        (constraints, jacobian, transcription.variable_bounds(), transcription.constraint_bounds())
    });
    let [light, heavy] = evaluated;
    assert_close(&light.0, &heavy.0);
    assert_close(&light.1, &heavy.1);
    assert_close(&light.2.upper, &heavy.2.upper);
    assert_close(&light.3.upper, &heavy.3.upper);
}

#[test]
fn motions_and_residuals_have_forces_in_newtons() {
    let [light, heavy] = [light(), heavy()].map(|task| transcription(&task));
    let x = point(&light);
    let [light_motion, heavy_motion] =
        [&light, &heavy].map(|transcription| transcription.formulation().motion(&x, 1e-3));
    for (light, heavy) in light_motion.scenarios.iter().zip(&heavy_motion.scenarios) {
        for (light, heavy) in light.contacts.iter().flatten().zip(heavy.contacts.iter().flatten()) {
            assert_eq!(light.force * FACTOR, heavy.force);
        }
        let wrenches: Vec<f64> = light.wrenches.iter().flat_map(|wrench| wrench.map(|c| c * FACTOR)).collect();
        assert_close(&wrenches, &heavy.wrenches.iter().flat_map(|wrench| wrench.0).collect::<Vec<_>>());
    }
    assert_close(&light.formulation().point_at(&light_motion), &heavy.formulation().point_at(&heavy_motion));
    let members = light.layout().variable_members();
    let multiplied = |Member { block, .. }: &Member| [CONTACT_FORCE, PRODUCT].contains(block);
    let [(light, light_gradients), (heavy, heavy_gradients)] = [light, heavy].map(|mut transcription| {
        let ones = |count: usize| vec![1.0; count];
        let iterate = Iterate {
            constraint_multipliers: ones(transcription.layout().constraint_count()),
            lower_multipliers: ones(x.len()),
            upper_multipliers: ones(x.len()),
            x: x.clone(),
        };
        let residuals = transcription.residuals(&iterate).unwrap();
        let products: Vec<ConstraintIndex> = residuals
            .iter()
            .filter(|residual| residual.member.block == PRODUCT)
            .map(|residual| residual.index)
            .collect();
        let gradients = transcription.gradients(&x, &products).unwrap();
        (residuals, gradients)
    });
    for (light, heavy) in light.iter().zip(&heavy) {
        let factor = if multiplied(&light.member) { FACTOR } else { 1.0 };
        let values = |of: &Residual, factor: f64| [of.value, of.lower, of.upper].map(|value| value * factor);
        assert_close(&values(light, factor), &values(heavy, 1.0));
        assert!((light.multiplier / factor - heavy.multiplier).abs() < 1e-12);
    }
    // By its force, a product changes by the gap; by all other variables it changes with the force.
    for (light, heavy) in light_gradients.iter().flatten().zip(heavy_gradients.iter().flatten()) {
        let expected = if members[light.0].block == CONTACT_FORCE { 1.0 } else { FACTOR };
        let ratio = heavy.1 / light.1;
        assert!((ratio - expected).abs() < 1e-9, "{} of {:?}, not {expected}", ratio, members[light.0]);
    }
}
