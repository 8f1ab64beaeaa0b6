//! Pairs of a body part and an environment part, and their distances.

use crate::batch::{Evaluation, Instructions, Request};
use crate::error::DistanceError;
use crate::interior_point::TOLERANCE;
use crate::polytope::Polytope;
use crate::pose_chart::{CONTACT, CONTACT_AND_POINT, POSE};
use crate::solutions::Solutions;

/// Smoothed distance and contact normal at one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// `Phi_tau = 2 alpha_tau` (m).
    pub smoothed_distance: f64,
    /// `n_tau` in R^7 (Eq. contactvectordef).
    pub contact_normal: [f64; POSE],
}

/// A polytope of the moved body (in the body frame) and one of the environment (in the world frame).
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    body: Polytope,
    environment: Polytope,
}

/// Smoothing for exact distances. It changes a distance by about as much as rounding does.
const EXACT_TAU: f64 = 1e-13;
/// Tolerance for exact distances: the products `dual slack` need only be small, not equal.
const EXACT_TOLERANCE: f64 = 0.5;

impl Pair {
    /// A pair of parts already placed in the body frame and in the world frame.
    pub fn new(body: Polytope, environment: Polytope) -> Self {
        Self { body, environment }
    }

    /// The body's part, in the body frame.
    pub fn body(&self) -> &Polytope {
        &self.body
    }

    /// The environment's part, in the world frame.
    pub fn environment(&self) -> &Polytope {
        &self.environment
    }

    /// Number of halfspaces `n_g` of both parts.
    pub fn row_count(&self) -> usize {
        self.body.normals().len() + self.environment.normals().len()
    }

    /// Exact distance `Phi_0` (m, Eq. sdfopt) at a pose (position, quaternion of any norm), negative where the parts
    /// overlap. Accurate to about 1e-11 m; of parts of a metre whose faces lie in one plane, to some 1e-6 m.
    pub fn exact_distance(&self, pose: &[f64; POSE]) -> f64 {
        let mut bound = [f64::NAN];
        // Where the smallest smoothing fails, a larger one still gives an upper bound, though a looser one.
        for tau in [EXACT_TAU, 1e-11, 1e-9, 1e-8, 1e-7] {
            if self.bound(std::slice::from_ref(pose), tau, &mut bound).is_ok() {
                break;
            }
        }
        bound[0]
    }

    /// Exact distances at many poses, which take less time together.
    pub fn exact_distances(&self, poses: &[[f64; POSE]]) -> Vec<f64> {
        let mut bounds = vec![f64::NAN; poses.len()];
        match self.bound(poses, EXACT_TAU, &mut bounds) {
            Ok(_) => bounds,
            Err(_) => poses.iter().map(|pose| self.exact_distance(pose)).collect(),
        }
    }

    /// Smoothed distances `Phi_tau` (m) at many poses, which take less time together; NaN where one cannot be computed.
    pub fn smoothed_distances(&self, poses: &[[f64; POSE]], tau: f64) -> Vec<f64> {
        let mut values = vec![[f64::NAN; CONTACT]; poses.len()];
        let alone = |pose| self.distance(pose, tau).map_or(f64::NAN, |distance| distance.smoothed_distance);
        match self.contacts(poses, tau, &mut Solutions::default(), &mut values) {
            Ok(()) => values.iter().map(|[distance, ..]| *distance).collect(),
            Err(_) => poses.iter().map(alone).collect(),
        }
    }

    /// Upper bounds on exact distances, tight for a small smoothing.
    fn bound(&self, poses: &[[f64; POSE]], tau: f64, bounds: &mut [f64]) -> Result<usize, DistanceError> {
        let request = Request::<CONTACT>::Bounds(bounds);
        self.run(Instructions::best(), poses, tau, EXACT_TOLERANCE, &mut Solutions::default(), request)
    }

    /// `(Phi_tau, n_tau)` at the normalised pose.
    ///
    /// # Errors
    /// When the problem cannot be solved, with the remaining residual.
    pub fn distance(&self, pose: &[f64; POSE], tau: f64) -> Result<Distance, DistanceError> {
        let mut normal = [[0.0; 1 + POSE]];
        let poses = std::slice::from_ref(pose);
        let (solutions, request) = (&mut Solutions::default(), Request::<CONTACT>::Normals(&mut normal));
        self.run(Instructions::best(), poses, tau, TOLERANCE, solutions, request)?;
        let [smoothed_distance, contact_normal @ ..] = normal[0];
        Ok(Distance { smoothed_distance, contact_normal })
    }

    /// Contact information `W(q) = (Phi_tau(q~), Q(q~)' n_tau(q~))` in R^7 at many poses: distance (m), then the normal
    /// as force in the world frame and torque in the body frame. With ten components, the contact point (m, world
    /// frame) follows, where the grown or shrunk parts meet.
    ///
    /// # Errors
    /// When a problem cannot be solved; results are then incomplete.
    pub fn contacts<const COMPONENTS: usize>(
        &self,
        poses: &[[f64; POSE]],
        tau: f64,
        solutions: &mut Solutions,
        values: &mut [[f64; COMPONENTS]],
    ) -> Result<(), DistanceError> {
        self.evaluate(Instructions::best(), poses, tau, solutions, Request::Values(values)).map(drop)
    }

    /// `W` and `DW` (rows are components of `W`, columns raw pose coordinates) at many poses.
    ///
    /// # Errors
    /// When a problem cannot be solved; results are then incomplete.
    pub fn contact_jacobians<const COMPONENTS: usize>(
        &self,
        poses: &[[f64; POSE]],
        tau: f64,
        solutions: &mut Solutions,
        values: &mut [[f64; COMPONENTS]],
        jacobians: &mut [[[f64; POSE]; COMPONENTS]],
    ) -> Result<(), DistanceError> {
        self.evaluate(Instructions::best(), poses, tau, solutions, Request::Jacobians(values, jacobians)).map(drop)
    }

    /// `<s, D2W>` (symmetric) at many poses, with one seed `s` per pose, in R^7, or in R^10 with the contact point.
    ///
    /// # Errors
    /// When a problem cannot be solved; results are then incomplete.
    pub fn contact_hessians<const COMPONENTS: usize>(
        &self,
        poses: &[[f64; POSE]],
        tau: f64,
        seeds: &[[f64; COMPONENTS]],
        solutions: &mut Solutions,
        hessians: &mut [[[f64; POSE]; POSE]],
    ) -> Result<(), DistanceError> {
        self.evaluate(Instructions::best(), poses, tau, solutions, Request::Hessians(seeds, hessians)).map(drop)
    }

    /// Evaluates any request with a given instruction set. Returns the largest number of iterations of any pose; none
    /// are needed where the solutions are kept.
    ///
    /// # Errors
    /// When a problem cannot be solved; results are then incomplete.
    pub fn evaluate<const COMPONENTS: usize>(
        &self,
        instructions: Instructions,
        poses: &[[f64; POSE]],
        tau: f64,
        solutions: &mut Solutions,
        request: Request<COMPONENTS>,
    ) -> Result<usize, DistanceError> {
        self.run(instructions, poses, tau, TOLERANCE, solutions, request)
    }

    fn run<const COMPONENTS: usize>(
        &self,
        instructions: Instructions,
        poses: &[[f64; POSE]],
        tau: f64,
        tolerance: f64,
        solutions: &mut Solutions,
        request: Request<COMPONENTS>,
    ) -> Result<usize, DistanceError> {
        const { assert!(COMPONENTS == CONTACT || COMPONENTS == CONTACT_AND_POINT) };
        let (body, environment) = (&self.body, &self.environment);
        instructions.0.dispatch(Evaluation { body, environment, poses, tau, tolerance, solutions, request })
    }
}
