//! One time step of the body: impedance control, contacts, motion.

use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use task::{Impedance, Inertia};

use crate::contact::{Contact, ContactFinder};
use crate::least_distance::{Halfspace, LeastDistance, Vector6};
use crate::metric::Metric;
use crate::reference::Knot;

/// Pose and twist of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Position (m) and orientation.
    pub pose: Isometry3<f64>,
    /// Velocity in the world frame (m/s).
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame (rad/s).
    pub angular_velocity: Vector3<f64>,
}

/// The time step of a body under the impedance law (Eq. ts with Eq. impedancewrench). It is linearly implicit in
/// stiffness and damping, so that stiff controllers and light bodies stay stable. Contacts are hard and without
/// restitution.
#[derive(Debug, Clone)]
pub struct Stepper {
    time_step: f64,
    inertia: Inertia,
    impedance: Impedance,
    friction: f64,
    metric: Metric,
    solver: LeastDistance,
    halfspaces: Vec<Halfspace>,
}

/// Number of facets of a friction cone. It is even: the direction of sliding and its opposite are among them.
const CONE_FACETS: usize = 8;
/// Smaller overlaps (m), as integration leaves them, are not corrected.
const OVERLAP: f64 = 1e-7;
/// Largest number of corrections per step, each with new contacts.
const CORRECTIONS: usize = 8;

impl Stepper {
    /// For steps of `time_step` seconds and a friction coefficient; `None` unless the effective inertia is positive
    /// definite and finite.
    pub fn new(time_step: f64, inertia: &Inertia, impedance: &Impedance, friction: f64) -> Option<Self> {
        Some(Self {
            time_step,
            metric: Metric::new(time_step, inertia, impedance)?,
            inertia: inertia.clone(),
            impedance: impedance.clone(),
            friction,
            solver: LeastDistance::default(),
            halfspaces: Vec::new(),
        })
    }

    /// Moves the body by one step towards `target`, the reference at the end of the step. Adds the normal impulse (Ns)
    /// of every pair to `impulses`. Returns the overlap (m) that the previous step has left.
    pub fn step(
        &mut self,
        body: &mut Body,
        target: &Knot,
        offset: &Vector3<f64>,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> f64 {
        let free = self.free_velocity(body, target, offset);
        // Contacts only dissipate: with or without them, no point of the body moves further than this.
        let reach = self.time_step * self.metric.fastest(&free, finder.radius());
        let overlap = self.correct(body, finder, reach);
        let velocity = self.resolve(&free, &body.pose, &finder.contacts, impulses);
        (body.velocity, body.angular_velocity) = self.metric.unscale(&velocity);
        body.pose = moved(&body.pose, &(body.velocity * self.time_step), &(body.angular_velocity * self.time_step));
        overlap
    }

    /// The scaled velocity that the body would have without contacts.
    fn free_velocity(&self, body: &Body, target: &Knot, offset: &Vector3<f64>) -> Vector6 {
        let (h, impedance) = (self.time_step, &self.impedance);
        // Eq. impedancewrench at the believed pose: k_t (rho_r - rho_c) + D_t nu_r and 2 k_r eta eps + D_r omega_r. The
        // body's own damping is in the effective inertia.
        let tracked = body.pose.translation.vector + body.pose.rotation * offset;
        let force = (target.pose.translation.vector - tracked) * impedance.translational_stiffness;
        let error = body.pose.rotation.inverse() * target.pose.rotation;
        let torque = error.imag() * (2.0 * impedance.rotational_stiffness * error.w);
        let momentum =
            body.velocity * self.inertia.mass + (force + impedance.translational_damping * target.velocity) * h;
        let angular = self.inertia.rotational * body.angular_velocity
            + (torque + impedance.rotational_damping * target.angular_velocity) * h;
        self.metric.scale(&momentum, &angular)
    }

    /// Finds the contacts within `reach` (m). Where linearised gaps have left an overlap, moves the body out of it by
    /// the shortest way and without changing its velocity. Returns the overlap before (m).
    fn correct(&mut self, body: &mut Body, finder: &mut ContactFinder, reach: f64) -> f64 {
        let before = -finder.find(&body.pose, reach);
        let mut overlap = before;
        for _ in 0..CORRECTIONS {
            if overlap <= OVERLAP {
                break;
            }
            self.halfspaces.clear();
            for Contact { point, normal, gap, .. } in &finder.contacts {
                self.halfspaces.push(self.metric.halfspace(&body.pose, point, normal, -gap));
            }
            let correction = self.solver.solve(&Vector6::zeros(), &self.halfspaces);
            let (shift, turn) = self.metric.unscale(&correction);
            body.pose = moved(&body.pose, &shift, &turn);
            overlap = -finder.find(&body.pose, reach);
        }
        before.max(0.0)
    }

    /// Eq. ts3 for all contacts at once: of all velocities with `gap + time_step normal' v >= 0` at every contact, the
    /// one nearest to the free velocity in kinetic energy.
    fn resolve(
        &mut self,
        free: &Vector6,
        pose: &Isometry3<f64>,
        contacts: &[Contact],
        impulses: &mut [f64],
    ) -> Vector6 {
        if contacts.is_empty() {
            return *free;
        }
        let (velocity, angular_velocity) = self.metric.unscale(free);
        let angular_velocity = pose.rotation * angular_velocity;
        self.halfspaces.clear();
        for Contact { point, normal, gap, .. } in contacts {
            let bound = -gap.max(0.0) / self.time_step;
            if self.friction == 0.0 {
                self.halfspaces.push(self.metric.halfspace(pose, point, normal, bound));
                continue;
            }
            // Anitescu's convex friction: the contact force lies in a polyhedral friction cone, whose edges these are.
            let sliding = velocity + angular_velocity.cross(&(point - pose.translation.vector));
            for tangent in tangents(normal, &sliding) {
                let direction = normal + tangent * self.friction;
                self.halfspaces.push(self.metric.halfspace(pose, point, &direction, bound));
            }
        }
        let resolved = self.solver.solve(free, &self.halfspaces);
        let per_contact = self.halfspaces.len() / contacts.len();
        for &(index, impulse) in &self.solver.active {
            impulses[contacts[index / per_contact].pair] += impulse;
        }
        resolved
    }
}

/// A pose shifted in the world frame and turned in the body frame.
fn moved(pose: &Isometry3<f64>, shift: &Vector3<f64>, turn: &Vector3<f64>) -> Isometry3<f64> {
    let mut rotation = pose.rotation * UnitQuaternion::from_scaled_axis(*turn);
    rotation.renormalize_fast();
    Isometry3::from_parts((pose.translation.vector + shift).into(), rotation)
}

/// Unit tangents around a normal, at equal angles. The first is along the tangential velocity, if there is one.
fn tangents(normal: &Vector3<f64>, velocity: &Vector3<f64>) -> [Vector3<f64>; CONE_FACETS] {
    let tangential = velocity - normal * normal.dot(velocity);
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let any = axes[normal.abs().imin()];
    let first = tangential.try_normalize(1e-9).unwrap_or_else(|| normal.cross(&any).normalize());
    let second = normal.cross(&first);
    std::array::from_fn(|index| {
        let (sine, cosine) = (std::f64::consts::TAU * index as f64 / CONE_FACETS as f64).sin_cos();
        first * cosine + second * sine
    })
}
