//! The velocity of the body under contacts, and the removal of penetrations.

use nalgebra::{Isometry3, Vector3};
use task::pose::moved;

use crate::body::Body;
use crate::contact::{Contact, ContactFinder};
use crate::least_distance::{Active, Cone, LeastDistance, Vector6};
use crate::metric::Metric;

/// Hard contacts without restitution, with friction.
#[derive(Debug, Clone)]
pub struct ContactSolver {
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Whether impulses count friction as if it were reversed.
    reverses_friction: bool,
    solver: LeastDistance,
    /// For penetrations.
    corrector: LeastDistance,
    cones: Vec<Cone>,
    /// Pair of every cone.
    pairs: Vec<usize>,
    /// The velocity (m/s) with which every gap closes within the step, negative.
    closing: Vec<f64>,
    /// The slowest velocity (m/s) that leaves a penetration.
    penetrating: f64,
}

/// Smaller penetrations (m), as integration leaves them, are not corrected.
const PENETRATION: f64 = 1e-7;
/// Largest number of corrections per step, each with new contacts.
const CORRECTIONS: usize = 8;

impl ContactSolver {
    /// For a friction coefficient. With reversed friction, impulses are upper estimates for compliant contacts: parts
    /// that an impact has pressed together separate again, and friction of other contacts then adds what it has taken
    /// off the impact.
    pub fn new(friction: f64, reverses_friction: bool) -> Self {
        Self {
            friction,
            reverses_friction,
            solver: LeastDistance::default(),
            corrector: LeastDistance::default(),
            cones: Vec::new(),
            pairs: Vec::new(),
            closing: Vec::new(),
            penetrating: 0.0,
        }
    }

    /// Finds the contacts within `reach` (m). Where linearised gaps have left a penetration, moves the body out of it
    /// along the shortest path. Returns the penetration before (m).
    pub fn correct(
        &mut self,
        metric: &Metric,
        pose: &mut Isometry3<f64>,
        finder: &mut ContactFinder,
        reach: f64,
    ) -> f64 {
        let before = -finder.find(pose, reach);
        let mut penetration = before;
        for _ in 0..CORRECTIONS {
            if penetration <= PENETRATION {
                break;
            }
            let placed = metric.placed(pose);
            self.cones.clear();
            for Contact { point, normal, gap, .. } in &finder.contacts {
                self.cones.push(Cone { normal: placed.along(point, normal), tangents: None, bound: -gap });
            }
            let correction = self.corrector.solve(&Vector6::zeros(), &self.cones);
            let (shift, rotation) = metric.unscale(&correction);
            *pose = moved(pose, &shift, &rotation);
            penetration = -finder.find(pose, reach);
        }
        before.max(0.0)
    }

    /// Sets up the contacts of a step of `time_step` seconds, for a body with its velocity before. A velocity is
    /// allowed if `gap + time_step normal' v >= 0` at every contact. With friction it is Anitescu's convex problem: a
    /// contact force lies in a polyhedral friction cone, which is built around the direction in which the `free`
    /// velocity slides, and `v` is reduced by the coefficient times the increase of the sliding speed in the step.
    /// Reduced by the whole speed, as in Anitescu's problem, a sliding body would hover.
    pub fn set(&mut self, metric: &Metric, body: &Body, time_step: f64, free: &Vector6, contacts: &[Contact]) {
        let pose = &body.pose;
        self.cones.clear();
        self.pairs.clear();
        self.closing.clear();
        self.penetrating = PENETRATION / time_step;
        if contacts.is_empty() {
            return;
        }
        let placed = metric.placed(pose);
        let (velocity, angular_velocity) = metric.unscale(free);
        let angular_velocity = pose.rotation * angular_velocity;
        let turning = pose.rotation * body.angular_velocity;
        for Contact { pair, point, normal, gap } in contacts {
            let closing = -gap.max(0.0) / time_step;
            let mut bound = closing;
            let tangents = (self.friction > 0.0).then(|| {
                let lever = point - pose.translation.vector;
                let before = body.velocity + turning.cross(&lever);
                bound -= self.friction * (before - normal * normal.dot(&before)).norm();
                let sliding = velocity + angular_velocity.cross(&lever);
                tangents(normal, &sliding).map(|tangent| placed.along(point, &tangent) * self.friction)
            });
            self.cones.push(Cone { normal: placed.along(point, normal), tangents, bound });
            self.pairs.push(*pair);
            self.closing.push(closing);
        }
    }

    /// For a step without active contacts.
    pub fn release(&mut self) {
        self.solver.active.clear();
    }

    /// Eq. ts3 for all contacts at once: of all velocities that are allowed, the one nearest to the free velocity in
    /// kinetic energy.
    pub fn resolve(&mut self, free: &Vector6) -> Vector6 {
        self.resolve_by(LeastDistance::solve, free)
    }

    /// The same, warm-started from the contacts that were active last.
    pub fn resolve_next(&mut self, free: &Vector6) -> Vector6 {
        self.resolve_by(LeastDistance::solve_next, free)
    }

    fn resolve_by(
        &mut self,
        solve: impl Fn(&mut LeastDistance, &Vector6, &[Cone]) -> Vector6,
        free: &Vector6,
    ) -> Vector6 {
        let velocity = solve(&mut self.solver, free, &self.cones);
        if self.friction > 0.0 && self.slow_down(&velocity) {
            solve(&mut self.solver, free, &self.cones)
        } else {
            velocity
        }
    }

    /// Where sliding slows down so much that the parts would penetrate, as at impacts, replaces the speed before the
    /// step by the one after it. Returns whether there is such a contact.
    fn slow_down(&mut self, velocity: &Vector6) -> bool {
        let mut some = false;
        for (cone, &closing) in self.cones.iter_mut().zip(&self.closing) {
            let Some(tangents) = &cone.tangents else { continue };
            if cone.normal.dot(velocity) < closing - self.penetrating {
                let [first, second] = tangents.map(|tangent| tangent.dot(velocity));
                cone.bound = cone.bound.max(closing - first.hypot(second));
                some = true;
            }
        }
        some
    }

    /// Adds the normal impulse (Ns) of every active pair of the last resolved velocity; with reversed friction, the
    /// impulse of a pair grows by the largest gain of its contacts.
    pub fn add_impulses(&self, impulses: &mut [f64]) {
        let active = &self.solver.active;
        for (position, one) in active.iter().enumerate() {
            let pair = self.pairs[one.cone];
            impulses[pair] += one.multiplier;
            let is_first = active[..position].iter().all(|earlier| self.pairs[earlier.cone] != pair);
            if self.reverses_friction && is_first {
                let of_pair = active.iter().filter(|other| self.pairs[other.cone] == pair);
                impulses[pair] += of_pair.map(|contact| self.reversal(contact)).fold(0.0, f64::max);
            }
        }
    }

    /// Growth of the normal impulse (Ns) of a contact when friction of other pairs reverses; negative if it becomes
    /// smaller.
    fn reversal(&self, contact: &Active) -> f64 {
        let (pair, normal) = (self.pairs[contact.cone], &self.cones[contact.cone].normal);
        let others = self.solver.active.iter().filter(|other| self.pairs[other.cone] != pair);
        let slowing: f64 = others.map(|other| self.cones[other.cone].friction(other).dot(normal)).sum();
        2.0 * slowing / normal.norm_squared()
    }

    /// Orthonormal directions in which active contacts fix the scaled velocity that was last resolved.
    pub fn held(&self) -> &[Vector6] {
        self.solver.active_basis()
    }

    /// Whether contacts were active when a velocity was last resolved.
    pub fn pushes(&self) -> bool {
        !self.solver.active.is_empty()
    }
}

/// Two unit tangents, at right angles. The first is along the tangential velocity, if there is one.
fn tangents(normal: &Vector3<f64>, velocity: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let tangential = velocity - normal * normal.dot(velocity);
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let any = axes[normal.abs().imin()];
    let first = tangential.try_normalize(1e-9).unwrap_or_else(|| normal.cross(&any).normalize());
    [first, normal.cross(&first)]
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix6;

    use super::*;

    /// Impulses (Ns) of floor and wall on a ball of 1 kg that arrives in their corner with a velocity (m/s, away from
    /// them), and its velocity afterwards.
    fn impulses(reverses_friction: bool, before: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let metric = Metric::of_inertia(&Matrix6::identity()).unwrap();
        let velocity = Vector3::new(before[1], 0.0, before[0]);
        let body = Body { pose: Isometry3::identity(), velocity, angular_velocity: Vector3::zeros() };
        let touch = |pair: usize, normal: Vector3<f64>| Contact { pair, point: Vector3::zeros(), normal, gap: 0.0 };
        let mut solver = ContactSolver::new(0.25, reverses_friction);
        let free = Vector6::from([before[1], 0.0, before[0], 0.0, 0.0, 0.0]);
        solver.set(&metric, &body, 1e-3, &free, &[touch(0, Vector3::z()), touch(1, Vector3::x())]);
        let after = solver.resolve(&free);
        let mut impulses = [0.0; 2];
        solver.add_impulses(&mut impulses);
        (impulses, [after[2], after[0]])
    }

    #[test]
    fn reversed_friction_adds_to_other_impulses_what_it_took_off() {
        let before = [-1.0, -0.4];
        let (plain, after) = impulses(false, before);
        let (reversed, _) = impulses(true, before);
        for contact in 0..2 {
            // The rest of the change of momentum is friction of the other contact.
            let friction = after[contact] - before[contact] - plain[contact];
            assert!(friction > 0.01, "{plain:?}");
            assert!((reversed[contact] - (plain[contact] + 2.0 * friction)).abs() < 1e-9, "{plain:?} {reversed:?}");
        }
        let alone = [-1.0, 0.0];
        assert_eq!(impulses(true, alone), impulses(false, alone), "no other contact is active");
    }
}
