//! How often a reference succeeds, by friction and magnitude of the offsets.

use serde::{Deserialize, Serialize};
use simulation::{larger, wilson_interval};

use crate::length::Millimetres;
use crate::or_null;

/// Region of the offsets of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OffsetRegion {
    /// In the hull of the planned offsets, scaled to the magnitude.
    #[default]
    Hull,
    /// Anywhere in a disc or a ball with the magnitude as its radius.
    Inside,
    /// On the rim of such a disc or ball.
    Rim,
}

/// Successes at one friction, magnitude and region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SuccessRate {
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Magnitude of the offsets: their length, or the largest that they can have.
    pub magnitude_m: f64,
    /// Region of the offsets.
    #[serde(default)]
    pub region: OffsetRegion,
    /// Whether they are the planned ones, not random ones.
    pub planned: bool,
    /// Rollouts that were made.
    pub rollouts: usize,
    /// Rollouts that succeeded.
    pub successes: usize,
    /// Largest contact force of all of them, the mean over 10 ms.
    #[serde(default, with = "or_null")]
    pub max_force_n: f64,
}

impl SuccessRate {
    /// Before the first rollout.
    pub fn unplayed(friction: f64, magnitude_m: f64, region: OffsetRegion, planned: bool) -> Self {
        Self { friction, magnitude_m, region, planned, rollouts: 0, successes: 0, max_force_n: 0.0 }
    }

    /// Counts a rollout with its contact force (N); what is no number counts as infinite.
    pub fn count(&mut self, passed: bool, force: f64) {
        self.rollouts += 1;
        self.successes += usize::from(passed);
        self.max_force_n = larger(self.max_force_n, force);
    }

    /// The offsets, such as `random offsets of up to 0.80 mm`.
    pub fn offsets_in_words(&self) -> String {
        let length = Millimetres(self.magnitude_m);
        match (self.planned, self.region) {
            (true, _) => format!("planned offsets of {length} mm"),
            (false, OffsetRegion::Hull) => format!("random offsets of {length} mm"),
            (false, OffsetRegion::Inside) => format!("random offsets of up to {length} mm"),
            (false, OffsetRegion::Rim) => format!("random offsets on the rim, of {length} mm"),
        }
    }
}

/// All groups of an evaluation, in the order of friction, then magnitude.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SuccessRates(pub Vec<SuccessRate>);

impl SuccessRates {
    /// Success rate of all rollouts together; 0 without rollouts.
    pub fn overall(&self) -> f64 {
        rate(&self.0)
    }

    /// Number of all rollouts.
    pub fn rollouts(&self) -> usize {
        self.0.iter().map(|group| group.rollouts).sum()
    }

    /// Whether every planned offset succeeds at every friction.
    pub fn planned_succeed(&self) -> bool {
        self.0.iter().filter(|group| group.planned).all(|group| group.rollouts > 0 && group.successes == group.rollouts)
    }

    /// Whether a plan is robust: every planned offset succeeds at every friction, and the target rate holds at each.
    pub fn satisfy(&self, wanted: f64) -> bool {
        self.planned_succeed() && self.by_friction().all(|groups| rate(groups) >= wanted)
    }

    /// Whether random offsets show the rate that is wanted at each friction with some confidence: none of them fails, which would
    /// happen with a probability of at most `1 - confidence` at a lower rate. Every planned offset has to succeed.
    pub fn show(&self, wanted: f64, confidence: f64) -> bool {
        let is_shown = |groups: &[SuccessRate]| {
            let [successes, rollouts] = counts(groups.iter().filter(|group| !group.planned));
            successes == rollouts && rollouts > 0 && wanted.powi(rollouts as i32) <= 1.0 - confidence
        };
        self.planned_succeed() && self.by_friction().all(is_shown)
    }

    /// The groups of each friction.
    pub fn by_friction(&self) -> impl Iterator<Item = &[SuccessRate]> {
        self.0.chunk_by(|one, other| one.friction == other.friction)
    }
}

/// Largest contact force (N, the mean over 10 ms) in some groups; 0 without rollouts.
pub fn max_force(groups: &[SuccessRate]) -> f64 {
    groups.iter().map(|group| group.max_force_n).fold(0.0, f64::max)
}

/// Success rate of some groups together; 0 without rollouts.
pub fn rate(groups: &[SuccessRate]) -> f64 {
    let [successes, rollouts] = counts(groups);
    successes as f64 / rollouts.max(1) as f64
}

/// Wilson's 95 % confidence interval of the success rate of some groups together.
pub fn interval(groups: &[SuccessRate]) -> [f64; 2] {
    let [successes, rollouts] = counts(groups);
    wilson_interval(successes, rollouts)
}

fn counts<'group>(groups: impl IntoIterator<Item = &'group SuccessRate>) -> [usize; 2] {
    groups
        .into_iter()
        .fold([0; 2], |[successes, rollouts], group| [successes + group.successes, rollouts + group.rollouts])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(friction: f64, planned: bool, successes: usize) -> SuccessRate {
        SuccessRate { rollouts: 10, successes, ..SuccessRate::unplayed(friction, 0.01, OffsetRegion::Hull, planned) }
    }

    #[test]
    fn a_rate_that_holds_on_the_average_only_is_not_robust() {
        let rates =
            SuccessRates(vec![group(0.0, true, 10), group(0.0, false, 10), group(0.1, true, 10), group(0.1, false, 7)]);
        assert!(rates.overall() > 0.9);
        assert!(!rates.satisfy(0.9), "at friction 0.1 only 85 % succeed");
        assert!(rates.satisfy(0.85));
    }

    #[test]
    fn a_planned_offset_that_fails_is_not_robust() {
        let rates = SuccessRates(vec![group(0.0, true, 9), group(0.0, false, 10)]);
        assert!(!rates.satisfy(0.5));
        assert!(SuccessRates(vec![group(0.0, true, 10), group(0.0, false, 5)]).satisfy(0.5));
    }

    #[test]
    fn the_rate_of_99_percent_is_shown_by_299_successes_in_a_row() {
        let random = |friction, rollouts, failures| SuccessRate {
            rollouts,
            successes: rollouts - failures,
            ..group(friction, false, 0)
        };
        let show = |rollouts, failures, confidence| {
            SuccessRates(vec![group(0.1, true, 10), random(0.1, rollouts, failures)]).show(0.99, confidence)
        };
        assert!(show(299, 0, 0.95) && !show(298, 0, 0.95) && !show(500, 1, 0.95));
        assert!(!show(10_000, 0, 1.0) && !show(0, 0, 0.0), "never for certain, and never by planned offsets alone");
        assert!(!SuccessRates(vec![group(0.1, true, 9), random(0.1, 500, 0)]).show(0.99, 0.95), "a planned one fails");
        let only_one = SuccessRates(vec![random(0.1, 500, 0), random(0.3, 10, 0)]);
        assert!(!only_one.show(0.99, 0.95), "it has to be shown at each friction");
    }

    #[test]
    fn the_largest_force_is_that_of_all_rollouts() {
        let pressing = |forces: &[f64]| {
            let mut group = SuccessRate::unplayed(0.0, 0.01, OffsetRegion::Hull, false);
            forces.iter().for_each(|force| group.count(*force < 10.0, *force));
            group
        };
        let groups = [pressing(&[3.0, 12.0, 5.0]), pressing(&[7.0])];
        assert_eq!((groups[0].rollouts, groups[0].successes, max_force(&groups)), (3, 2, 12.0));
        assert_eq!(max_force(&[pressing(&[f64::NAN, 2.0])]), f64::INFINITY);
    }
}
