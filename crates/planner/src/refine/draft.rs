//! Drafts: plans of the scene with other weights, offsets and smoothing, on half of the steps, which cost little.

use fastrand::Rng;
use nalgebra::{Rotation3, Unit, Vector3};
use task::GraspError;

use crate::variant::Variant;

/// What makes a draft differ from the scene as it is. Whether that helps differs from scene to scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draft {
    /// By how much the planned offsets are turned about the axis around which they lie (rad).
    pub angle: f64,
    /// Factor of the weight of the reference's translational velocity.
    pub reference_weight: f64,
    /// Factor of the weight of the translational velocity of compliant motions.
    pub compliant_weight: f64,
    /// Coulomb coefficient, where the scene has no friction.
    pub friction: f64,
    /// Whether it takes half as long again.
    pub is_slower: bool,
    /// Whether the first smoothing is twice as strong.
    pub is_smoother: bool,
}

/// Exponents of ten of the least and largest factors of weights.
const REFERENCE_WEIGHT: [f64; 2] = [-0.5, 1.0];
const COMPLIANT_WEIGHT: [f64; 2] = [0.0, 1.5];
/// Fraction of drafts with friction, and their coefficient as a fraction of the largest that must be borne: more costs
/// more, and is no better.
const WITH_FRICTION: f64 = 0.5;
const FRICTION: f64 = 1.0 / 3.0;
/// Fractions of drafts that are slower and that are smoother.
const SLOWER: f64 = 0.5;
const SMOOTHER: f64 = 1.0 / 3.0;
/// Largest part of the product of two offsets that may be rounding.
const PARALLEL: f64 = 1e-9;

impl Draft {
    /// Any. `friction` is the largest that must be borne.
    pub fn random(random: &mut Rng, friction: f64) -> Self {
        let mut power = |[least, most]: [f64; 2]| 10_f64.powf(least + (most - least) * random.f64());
        let (reference_weight, compliant_weight) = (power(REFERENCE_WEIGHT), power(COMPLIANT_WEIGHT));
        Self {
            angle: std::f64::consts::TAU * random.f64(),
            reference_weight,
            compliant_weight,
            friction: if random.f64() < WITH_FRICTION { FRICTION * friction } else { 0.0 },
            is_slower: random.f64() < SLOWER,
            is_smoother: random.f64() < SMOOTHER,
        }
    }

    /// The changed problem.
    pub fn variant(&self, scene: &Variant) -> Variant {
        let mut variant = Variant { name: self.name(), near: None, ..scene.clone() };
        let (task, settings) = (&mut variant.task, &mut variant.settings);
        *task = ocp::coarsened(task).unwrap_or_else(|| task.clone());
        settings.coarse_iterations = 0;
        turn_offsets(&mut task.grasps, self.angle);
        task.cost.reference.translational_velocity *= self.reference_weight;
        task.cost.compliant.translational_velocity *= self.compliant_weight;
        if task.frictions.iter().all(|&friction| friction == 0.0) {
            task.frictions = vec![self.friction];
        }
        if self.is_slower {
            task.horizon.steps += task.horizon.steps / 2;
        }
        if self.is_smoother {
            settings.tau *= 2.0;
            settings.sigma *= 2.0;
        }
        variant
    }

    fn name(&self) -> String {
        let Self { angle, reference_weight, compliant_weight, friction, is_slower, is_smoother } = self;
        let mut name = format!(
            "draft with offsets turned by {:.0} degrees, weights of velocities times {reference_weight:.1} (reference) \
             and {compliant_weight:.1} (compliant), friction {friction:.2}",
            angle.to_degrees()
        );
        for (is_so, words) in [(is_slower, ", 1.5 times the time"), (is_smoother, ", twice the first smoothing")] {
            if *is_so {
                name += words;
            }
        }
        name
    }
}

/// Turns offsets about the axis around which they lie, if they do not all lie on one line.
fn turn_offsets(grasps: &mut [GraspError], angle: f64) {
    let offset = |index: usize| Vector3::from(grasps[index % grasps.len()].offset);
    let around: Vector3<f64> = (0..grasps.len()).map(|index| offset(index).cross(&offset(index + 1))).sum();
    let longest = (0..grasps.len()).map(|index| offset(index).norm_squared()).fold(0.0, f64::max);
    let Some(axis) = Unit::try_new(around, PARALLEL * longest) else { return };
    let turn = Rotation3::from_axis_angle(&axis, angle);
    for grasp in grasps {
        grasp.offset = (turn * Vector3::from(grasp.offset)).into();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::{Choices, Problem};

    #[test]
    fn drafts_have_half_of_the_steps_and_what_they_say() {
        let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
        let of_scene = Variant::of_scene(&Problem::load(&scene, &Choices::default()).unwrap());
        let task = &of_scene.task;
        let mut random = Rng::with_seed(1);
        let drafts: Vec<Draft> = (0..100).map(|_| Draft::random(&mut random, 0.3)).collect();
        for draft in &drafts {
            let variant = draft.variant(&of_scene);
            let half = task.horizon.steps / 2;
            assert_eq!(variant.task.horizon.steps, if draft.is_slower { half + half / 2 } else { half });
            assert_eq!(variant.task.frictions, [draft.friction]);
            assert_eq!(variant.settings.tau > of_scene.settings.tau, draft.is_smoother);
            for (turned, grasp) in variant.task.grasps.iter().zip(&task.grasps) {
                let [turned, grasp] = [turned, grasp].map(|grasp| Vector3::from(grasp.offset));
                assert!((turned.norm() - grasp.norm()).abs() < 1e-12 && turned.z.abs() < 1e-12, "in their plane");
                assert!((turned.angle(&grasp).cos() - draft.angle.cos()).abs() < 1e-9);
            }
        }
        for has in
            [|draft: &Draft| draft.friction > 0.0, |draft: &Draft| draft.is_slower, |draft: &Draft| draft.is_smoother]
        {
            let count = drafts.iter().filter(|draft| has(draft)).count();
            assert!((10..90).contains(&count), "{count} of 100");
        }
    }

    #[test]
    fn a_friction_that_the_scene_states_and_offsets_on_a_line_stay() {
        let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
        let mut of_scene = Variant::of_scene(&Problem::load(&scene, &Choices::default()).unwrap());
        of_scene.task.frictions = vec![0.0, 0.2];
        of_scene.task.grasps = [-0.02, 0.0, 0.02].map(|shift| GraspError::from([shift, 0.0, 0.0])).to_vec();
        let mut random = Rng::with_seed(1);
        let variant = Draft::random(&mut random, 0.3).variant(&of_scene);
        assert_eq!(variant.task.frictions, of_scene.task.frictions);
        assert_eq!(variant.task.grasps, of_scene.task.grasps);
    }
}
