//! The factor between the inertia of a plan and that of an arm.

use nalgebra::{Cholesky, Matrix6};

/// How the apparent inertia of an arm compares with that of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Similarity {
    /// Factor for stiffness and damping of the plan.
    pub factor: f64,
    /// Smallest inertia of the arm over that of the plan, among all directions of motion.
    pub smallest: f64,
    /// Largest inertia of the arm over that of the plan, among all directions of motion.
    pub largest: f64,
}

impl Similarity {
    /// Of the arm's `apparent` inertia and the `planned` one, symmetric and positive definite 6x6 matrices (kg, kg m,
    /// kg m^2) for the same velocities. `None` if one of them is not positive definite.
    ///
    /// With generalised eigenvalues `s_i` of `apparent v = s planned v`, the arm is `s_i` times as heavy as the plan along
    /// `v_i`. The factor is their mean, `trace(planned^-1 apparent) / 6`: with it, the plan's kinetic energy is that of the
    /// arm on average over these directions, and `factor planned` is the multiple nearest to `apparent` when both are
    /// measured in the planned metric. It depends neither on units nor on the frame. Heavy directions count most, and it
    /// is these that oscillate with gains that are too soft. If all `s_i` are equal, the arm moves exactly as planned.
    pub fn new(planned: &Matrix6<f64>, apparent: &Matrix6<f64>) -> Option<Self> {
        let lower = Cholesky::new(*planned)?.l();
        let half = lower.solve_lower_triangular(apparent)?;
        let ratio = lower.solve_lower_triangular(&half.transpose())?;
        if !ratio.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let ratios = ((ratio + ratio.transpose()) * 0.5).symmetric_eigenvalues();
        let (smallest, largest) = (ratios.min(), ratios.max());
        (smallest > 0.0).then_some(Self { factor: ratios.mean(), smallest, largest })
    }

    /// Smallest and largest damping ratio, over that of the plan, with gains of the plan times `factor`: a direction with
    /// `s_i` times the planned inertia has `d / (2 sqrt(k m))` times `sqrt(factor / s_i)`. Far below 1, the arm oscillates.
    pub fn damping_ratios(&self, factor: f64) -> [f64; 2] {
        [(factor / self.largest).sqrt(), (factor / self.smallest).sqrt()]
    }
}
