//! Drafts: cheap plans of the scene with other weights and offsets, on half of the time steps.

use std::fmt;

use fastrand::Rng;
use nalgebra::{Rotation3, Unit, Vector3};
use plan::Variant;
use plan::parameters::DraftParameters;
use serde::{Deserialize, Serialize};
use task::GraspError;

/// Differences of a draft from the scene. Which of them help differs from scene to scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Draft {
    /// Angle by which the planned offsets are rotated about the axis around which they lie (rad).
    pub angle: f64,
    /// Factors of the weights of the reference's velocities.
    pub reference: Factors,
    /// Factors of the weights of the velocities of compliant motions.
    pub compliant: Factors,
    /// Coulomb coefficient, where the scene has no friction.
    pub friction: f64,
    /// Whether it takes 1.5 times the time.
    pub is_slower: bool,
}

/// Factors of weights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Factors {
    /// Of translational velocity.
    pub translational: f64,
    /// Of rotational velocity.
    pub rotational: f64,
}

/// Largest part of the product of two offsets that may be rounding.
const PARALLEL: f64 = 1e-9;

impl Draft {
    /// A random draft. `friction` is the largest that must be tolerated.
    pub fn random(random: &mut Rng, friction: f64, parameters: &DraftParameters) -> Self {
        let mut power = |[least, most]: [f64; 2]| 10_f64.powf(least + (most - least) * random.f64());
        let mut factors =
            |translational, rotational| Factors { translational: power(translational), rotational: power(rotational) };
        let reference = factors(parameters.reference_translational, parameters.reference_rotational);
        let compliant = factors(parameters.compliant_translational, parameters.compliant_rotational);
        Self {
            angle: std::f64::consts::TAU * random.f64(),
            reference,
            compliant,
            friction: if random.f64() < parameters.with_friction { parameters.friction * friction } else { 0.0 },
            is_slower: random.f64() < parameters.slower,
        }
    }

    /// The changed problem.
    pub fn variant(&self, scene: &Variant, parameters: &DraftParameters) -> Variant {
        let mut variant = Variant { near: None, ..scene.clone() };
        let (task, settings) = (&mut variant.task, &mut variant.settings);
        *task = ocp::coarsened(task).unwrap_or_else(|| task.clone());
        settings.coarse_iterations = parameters.coarse_iterations;
        turn_offsets(&mut task.grasps, self.angle);
        for (weights, factors) in
            [(&mut task.cost.reference, self.reference), (&mut task.cost.compliant, self.compliant)]
        {
            weights.translational_velocity *= factors.translational;
            weights.rotational_velocity *= factors.rotational;
        }
        if task.frictions.iter().all(|&friction| friction == 0.0) {
            task.frictions = vec![self.friction];
        }
        if self.is_slower {
            task.horizon.steps += task.horizon.steps / 2;
        }
        variant
    }
}

impl fmt::Display for Draft {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let Self { angle, reference, compliant, friction, is_slower } = self;
        let factors =
            |Factors { translational, rotational }: &Factors| format!("{translational:.1} and {rotational:.2}");
        write!(
            formatter,
            "draft with offsets turned by {:.0} degrees, weights of translational and rotational velocity times {} \
             (reference) and {} (compliant), friction {friction:.2}",
            angle.to_degrees(),
            factors(reference),
            factors(compliant),
        )?;
        if *is_slower { formatter.write_str(", 1.5 times the time") } else { Ok(()) }
    }
}

/// Rotates offsets about the axis around which they lie, unless they all lie on one line.
fn turn_offsets(grasps: &mut [GraspError], angle: f64) {
    let offset = |index: usize| Vector3::from(grasps[index % grasps.len()].offset);
    let around: Vector3<f64> = (0..grasps.len()).map(|index| offset(index).cross(&offset(index + 1))).sum();
    let longest = (0..grasps.len()).map(|index| offset(index).norm_squared()).fold(0.0, f64::max);
    let Some(axis) = Unit::try_new(around, PARALLEL * longest) else { return };
    let rotation = Rotation3::from_axis_angle(&axis, angle);
    for grasp in grasps {
        grasp.offset = (rotation * Vector3::from(grasp.offset)).into();
    }
}

#[cfg(test)]
mod tests {
    use plan::{Choices, Problem};

    use super::*;

    #[test]
    fn drafts_have_half_of_the_steps_and_what_they_say() {
        let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
        let of_scene = Variant::of_scene(&Problem::load(&scene, &Choices::default()).unwrap());
        let task = &of_scene.task;
        let mut random = Rng::with_seed(1);
        let drafts: Vec<Draft> =
            (0..100).map(|_| Draft::random(&mut random, 0.3, &DraftParameters::default())).collect();
        for draft in &drafts {
            let variant = draft.variant(&of_scene, &DraftParameters::default());
            let half = task.horizon.steps / 2;
            assert_eq!(variant.task.horizon.steps, if draft.is_slower { half + half / 2 } else { half });
            assert_eq!(variant.task.frictions, [draft.friction]);
            let (cost, own) = (&variant.task.cost, &task.cost);
            let ratio = cost.compliant.rotational_velocity / own.compliant.rotational_velocity;
            assert!(
                (ratio - 2.0 * draft.compliant.rotational).abs() < 1e-9,
                "the weight of half of the steps is twice as large"
            );
            assert_eq!(cost.compliant.terminal_position, own.compliant.terminal_position);
            for (turned, grasp) in variant.task.grasps.iter().zip(&task.grasps) {
                let [turned, grasp] = [turned, grasp].map(|grasp| Vector3::from(grasp.offset));
                assert!((turned.norm() - grasp.norm()).abs() < 1e-12 && turned.z.abs() < 1e-12, "in their plane");
                assert!((turned.angle(&grasp).cos() - draft.angle.cos()).abs() < 1e-9);
            }
        }
        for has in [|draft: &Draft| draft.friction > 0.0, |draft: &Draft| draft.is_slower] {
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
        let variant = Draft::random(&mut random, 0.3, &DraftParameters::default())
            .variant(&of_scene, &DraftParameters::default());
        assert_eq!(variant.task.frictions, of_scene.task.frictions);
        assert_eq!(variant.task.grasps, of_scene.task.grasps);
    }
}
