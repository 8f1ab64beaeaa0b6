//! The state of a rollout.

use task::{Impedance, Pose};

use crate::body::Body;
use crate::contact::ContactFinder;
use crate::loads::LoadMeter;
use crate::overshoot::Overshoot;
use crate::plant::Plant;
use crate::reference::Reference;
use crate::step_length::Substeps;
use crate::timed_state::TimedState;

/// The state of a rollout after some intervals of its reference. The rest depends on nothing but this and the rest of
/// the reference, so a rollout of another reference with the same beginning continues from a copy.
#[derive(Debug, Clone)]
pub struct RolloutState<'rollout> {
    pub body: Body,
    pub plant: Plant<'rollout>,
    pub finder: ContactFinder<'rollout>,
    /// The controller's impedance, and the pose of the believed part in the frame of the part.
    pub impedance: Impedance,
    pub grasp: Pose,
    /// Length of the shortest steps (s), and their number in an interval.
    pub steps: (f64, usize),
    /// Intervals so far.
    pub intervals: usize,
    /// Deepest penetration of a pair (m) so far.
    pub max_penetration: f64,
    pub loads: LoadMeter,
    pub overshoot: Overshoot,
    /// Normal impulse (Ns) of every pair in the last step, and since the last knot.
    pub step_impulses: Vec<f64>,
    pub impulses: Vec<f64>,
}

impl RolloutState<'_> {
    /// Follows a reference to its next knot, or rests at its end. The reference is given as the robot tracks it
    /// (`believed`) and as the part should move ([`Reference::of_part`]).
    pub fn follow(
        &mut self,
        believed: &Reference,
        reference: &Reference,
        observe: &mut impl FnMut(&TimedState, &[f64]),
    ) {
        let (interval, (time_step, count)) = (self.intervals, self.steps);
        self.impulses.fill(0.0);
        let mut done = 0;
        while done < count {
            let Self { body, finder, step_impulses, .. } = self;
            let target = |steps: f64| reference.at(interval, steps / count as f64);
            let before = *body;
            step_impulses.fill(0.0);
            let (taken, penetration) = self.plant.step(body, Substeps { done, count }, target, finder, step_impulses);
            self.max_penetration = self.max_penetration.max(penetration);
            self.impulses.iter_mut().zip(&*step_impulses).for_each(|(sum, impulse)| *sum += impulse);
            let part = (done + taken) as f64 / count as f64;
            let tracked = believed.at(interval, part);
            let of_law = || self.impedance.wrench(&tracked.state(), &TimedState::new(0.0, body).state(), &self.grasp);
            let wrench = self.plant.wrench().unwrap_or_else(of_law);
            if self.loads.add(taken as f64 * time_step, step_impulses, &wrench) {
                let fraction = (interval as f64 + part) / reference.intervals() as f64;
                self.overshoot = Overshoot::new(fraction, &reference.at(interval, part).pose, &body.pose);
            }
            for moment in 1..=taken {
                let time = (interval * count + done + moment) as f64 * time_step;
                let state = before.towards(body, moment as f64 / taken as f64);
                let flange = self.plant.flange().copied();
                observe(&TimedState { flange, ..TimedState::new(time, &state) }, &self.impulses);
            }
            done += taken;
        }
        self.intervals += 1;
    }

    /// Whether the state is finite.
    pub fn is_finite(&self) -> bool {
        let Body { pose, velocity, angular_velocity } = &self.body;
        let pose = Pose::from(pose);
        pose.iter().chain(velocity).chain(angular_velocity).all(|component| component.is_finite())
    }
}
