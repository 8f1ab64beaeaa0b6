//! One time step of the body: impedance control, contacts, motion.

use nalgebra::{Matrix3, Matrix6, Vector3};
use task::pose::moved;
use task::{Impedance, Inertia};

use crate::body::Body;
use crate::contact::ContactFinder;
use crate::contact_solver::ContactSolver;
use crate::least_distance::Vector6;
use crate::metric::{Metric, effective_inertia};
use crate::reference::Knot;
use crate::step_length::{StepLength, Steps, Substeps};

/// Steps of a body under the impedance law (Eq. ts with Eq. impedancewrench). They are linearly implicit in stiffness
/// and damping, so that stiff controllers and light bodies stay stable. Contacts are hard and without restitution.
///
/// Longer steps ([`StepLength`]) follow the midpoint rule, with the contacts of a predicted middle pose, so that they are about
/// as accurate.
#[derive(Debug, Clone)]
pub struct Stepper {
    impedance: Impedance,
    /// Where the controller believes the body's origin (m, body frame).
    offset: Vector3<f64>,
    /// Every length is twice the one before.
    lengths: Vec<Length>,
    steps: StepLength,
    solver: ContactSolver,
}

/// Terms that depend on the length of a step.
#[derive(Debug, Clone)]
struct Length {
    /// In seconds.
    time_step: f64,
    /// Weight of the end of the step in the mean velocity and in forces: 1 in the shortest steps (implicit Euler), 1/2
    /// in longer ones (implicit midpoint rule).
    weight: f64,
    /// For the weighted part of the step.
    metric: Metric,
    /// Multiplies the velocity before the step: `M / w - (1 / w - 1) (M + w h D + w^2 h^2 K)` with the weight `w`
    /// scales the weighted part of a step to the whole.
    carried: Matrix6<f64>,
}

/// Largest penetration (m) that a longer step may leave.
pub const LARGEST_PENETRATION: f64 = 1e-6;
/// The longest step replaces at most two to this power of the shortest ones.
const DOUBLINGS: u32 = 6;
/// Longer steps are at most this part of the shortest time in which the free body answers.
const SMOOTH: f64 = 0.5;

impl Stepper {
    /// For an offset that the controller does not know (m, body frame), and a contact solver; `None` unless the
    /// effective inertia is positive definite and finite.
    pub fn new(
        shortest: &Steps,
        inertia: &Inertia,
        impedance: &Impedance,
        offset: Vector3<f64>,
        solver: ContactSolver,
    ) -> Option<Self> {
        let Steps { time_step, most, .. } = *shortest;
        let rate = fastest_rate(inertia, impedance);
        let length = |doublings: u32| {
            let (time_step, weight) =
                (time_step * f64::from(1_u32 << doublings), if doublings == 0 { 1.0 } else { 0.5 });
            let effective = effective_inertia(weight * time_step, inertia, impedance);
            let metric = Metric::of_inertia(&effective)?;
            let carried = inertia.matrix() / weight - effective * (1.0 / weight - 1.0);
            Some(Length { time_step, weight, metric, carried })
        };
        let is_short = |length: &Option<Length>| {
            length.as_ref().is_none_or(|length| length.weight == 1.0 || length.time_step * rate <= SMOOTH)
        };
        let lengths: Vec<Length> =
            (0..=most.ilog2().min(DOUBLINGS)).map(length).take_while(is_short).collect::<Option<_>>()?;
        Some(Self {
            impedance: impedance.clone(),
            offset,
            steps: StepLength::new(shortest, lengths.len() - 1),
            lengths,
            solver,
        })
    }

    /// Moves the body by one step, after some of the shortest steps of an interval. `target` is the reference after a
    /// number of them. Adds the normal impulse (Ns) of every pair to `impulses`. Returns how many of the
    /// shortest steps this one replaces, and the penetration (m) that the previous step has left.
    pub fn step(
        &mut self,
        body: &mut Body,
        substeps: Substeps,
        target: impl Fn(f64) -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> (usize, f64) {
        let mut steps = self.steps;
        let (taken, penetration) = steps.step(body, substeps, |body, length| {
            let weight = self.lengths[length].weight;
            self.advance(body, length, &target(substeps.done as f64 + weight * f64::from(1_u32 << length)), finder)
        });
        self.steps = steps;
        self.solver.add_impulses(impulses);
        (taken, penetration)
    }

    /// Moves the body by a step of some length. Returns the penetration (m) before it, and the largest change of
    /// velocity (m/s) of any point; infinite if a longer step would leave a penetration or slide with friction.
    fn advance(&mut self, body: &mut Body, length: usize, target: &Knot, finder: &mut ContactFinder) -> (f64, f64) {
        let before = *body;
        let free = self.free_velocity(body, length, target);
        let Length { time_step, weight, metric, .. } = &self.lengths[length];
        let (time_step, weight, radius) = (*time_step, *weight, finder.radius());
        let reach = if length == 0 {
            // Contacts only dissipate: with or without them, no point of the body moves further than this.
            time_step * metric.fastest(free.norm(), radius)
        } else {
            time_step * (body.fastest(radius) + self.steps.largest_change())
        };
        let penetration = self.solver.correct(&self.lengths[0].metric, &mut body.pose, finder, reach);
        let start = body.pose;
        if length > 0 && !finder.contacts.is_empty() {
            // Contacts slide and rotate within the step: forces are those of its middle.
            let half = 0.5 * time_step;
            body.pose = moved(&start, &(body.velocity * half), &(body.angular_velocity * half));
            finder.find(&body.pose, reach);
        }
        let metric = &self.lengths[length].metric;
        self.solver.set(metric, body, time_step, &free, &finder.contacts);
        (body.velocity, body.angular_velocity) = metric.unscale(&self.solver.resolve(&free));
        let mean = |from: &Vector3<f64>, to: &Vector3<f64>| from.lerp(to, weight) * time_step;
        let shift = mean(&before.velocity, &body.velocity);
        body.pose = moved(&start, &shift, &mean(&before.angular_velocity, &body.angular_velocity));
        let mut change = body.change(&before, radius);
        let is_long = length > 0 && change <= self.steps.largest_change();
        if is_long && -finder.find(&body.pose, reach) > LARGEST_PENETRATION {
            change = f64::INFINITY;
        }
        (penetration, change)
    }

    /// The scaled velocity that the body would have without contacts.
    fn free_velocity(&self, body: &Body, length: usize, target: &Knot) -> Vector6 {
        let Self { impedance, offset, .. } = self;
        let Length { time_step, weight, metric, carried } = &self.lengths[length];
        // Eq. impedancewrench at the believed pose: k_t (rho_r - rho_c) + D_t nu_r and 2 k_r eta eps + D_r omega_r. The
        // body's own damping is in the effective inertia.
        let rotated = offset + body.angular_velocity.cross(offset) * ((1.0 - weight) * time_step);
        let tracked = body.pose.translation.vector + body.pose.rotation * rotated;
        let force = (target.pose.translation.vector - tracked) * impedance.translational_stiffness;
        let error = body.pose.rotation.inverse() * target.pose.rotation;
        let torque = error.imag() * (2.0 * impedance.rotational_stiffness * error.w);
        let (velocity, angular_velocity) = (&body.velocity, &body.angular_velocity);
        let twist = Vector6::from_fn(|row, _| if row < 3 { velocity[row] } else { angular_velocity[row - 3] });
        let momentum = carried * twist;
        // What the weighted part of the step adds to the momentum is added once more for the rest of the step.
        let force = force + impedance.translational_damping * target.velocity;
        let torque = torque + impedance.rotational_damping * target.angular_velocity;
        metric.scale(
            &(momentum.fixed_rows::<3>(0) + force * *time_step),
            &(momentum.fixed_rows::<3>(3) + torque * *time_step),
        )
    }
}

/// The fastest rate (1/s) at which a free body answers.
fn fastest_rate(inertia: &Inertia, impedance: &Impedance) -> f64 {
    let rate = |inertia: f64, damping: &Matrix3<f64>, stiffness: f64| {
        (damping.symmetric_eigenvalues().max() / inertia).max((stiffness / inertia).sqrt())
    };
    let (mass, rotational) = inertia.lightest();
    let linear = rate(mass, &impedance.translational_damping, impedance.translational_stiffness);
    linear.max(rate(rotational, &impedance.rotational_damping, impedance.rotational_stiffness))
}

#[cfg(test)]
mod tests {
    use nalgebra::Isometry3;

    use super::*;
    use crate::contact::Shapes;
    use crate::step_length::STEADY;

    const TIME_STEP: f64 = 1e-3;
    const COUNT: usize = 64;

    /// The lengths of the steps of an interval, for a body of 1 kg with a tracking error (m) and a reference at rest.
    fn lengths(lag: f64, stiffness: f64) -> Vec<usize> {
        let inertia = Inertia::of_body(1.0, Matrix3::identity());
        let impedance = Impedance::critically_damped(stiffness, stiffness, &inertia);
        let steps = Steps { time_step: TIME_STEP, most: COUNT, steady: STEADY };
        let mut stepper =
            Stepper::new(&steps, &inertia, &impedance, Vector3::zeros(), ContactSolver::new(0.0, false)).unwrap();
        let shapes = Shapes::new(&[]);
        let mut finder = ContactFinder::new(&shapes, 0.0);
        let still = |x: f64| Knot {
            pose: Isometry3::translation(x, 0.0, 0.0),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
        };
        let mut body = Body { pose: still(0.0).pose, velocity: Vector3::zeros(), angular_velocity: Vector3::zeros() };
        let (mut lengths, mut done) = (Vec::new(), 0);
        while done < COUNT {
            let (taken, _) =
                stepper.step(&mut body, Substeps { done, count: COUNT }, |_| still(lag), &mut finder, &mut []);
            lengths.push(taken);
            done += taken;
        }
        lengths
    }

    #[test]
    fn steps_are_long_where_the_velocity_changes_little_and_the_body_answers_slowly() {
        assert_eq!(lengths(0.0, 25.0), [1, 1, 2, 4, 8, 16, 32]);
        // It is accelerated by 2.5 m/s^2.
        assert_eq!(lengths(0.1, 25.0)[..16], [1; 16]);
        // Its frequency is 100 / s, and it is damped by 200 / s.
        assert_eq!(lengths(0.0, 1e4)[..4], [1, 1, 2, 2]);
        assert!(lengths(f64::NAN, 25.0).len() == COUNT);
    }
}
