//! Rates of success by modelled and injected magnitude (Fig. realworldresults).

use std::cmp::Ordering;
use std::fmt;

use simulation::{larger, wilson_interval};

use crate::length::Millimetres;
use crate::simulate::{Motion, PlayedRollout};

/// Rollouts that differ only in plan (of the same delta-hat) and grasp error (of the same magnitude).
#[derive(Debug, Clone, PartialEq)]
pub struct SuccessGroup {
    /// The motion.
    pub motion: Motion,
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Modelled magnitude delta-hat (m).
    pub offset_magnitude: f64,
    /// Injected magnitude (m).
    pub magnitude: f64,
    /// Rollouts.
    pub rollouts: usize,
    /// Those that reach the goal.
    pub successes: usize,
    /// Largest final distance from the goal (m).
    pub position_error: f64,
    /// Largest final angle to the goal (rad).
    pub orientation_error: f64,
    /// Deepest penetration (m).
    pub max_penetration: f64,
    /// Largest contact force (N).
    pub max_force: f64,
}

/// Rollouts from which on rates are known to more than a percent.
const MANY: usize = 1000;

impl SuccessGroup {
    fn new(played: &PlayedRollout) -> Self {
        Self {
            motion: played.motion,
            friction: played.friction,
            offset_magnitude: played.offset_magnitude,
            magnitude: played.magnitude,
            rollouts: 0,
            successes: 0,
            position_error: 0.0,
            orientation_error: 0.0,
            max_penetration: 0.0,
            max_force: 0.0,
        }
    }

    fn takes(&self, played: &PlayedRollout) -> bool {
        let key = (played.motion, played.friction, played.offset_magnitude, played.magnitude);
        (self.motion, self.friction, self.offset_magnitude, self.magnitude) == key
    }

    fn add(&mut self, played: &PlayedRollout) {
        let outcome = &played.outcome;
        self.rollouts += 1;
        self.successes += usize::from(played.success);
        self.position_error = larger(self.position_error, outcome.position_error);
        self.orientation_error = larger(self.orientation_error, outcome.orientation_error);
        self.max_penetration = larger(self.max_penetration, outcome.max_penetration);
        self.max_force = larger(self.max_force, outcome.loads.contact_force);
    }

    /// By motion, friction, modelled and injected magnitude.
    fn order(&self, other: &Self) -> Ordering {
        let motion = |group: &Self| match group.motion {
            Motion::HomotopyStep(number) => number,
            Motion::Plan => usize::MAX - 1,
            Motion::StraightPush => usize::MAX,
        };
        let by_motion = motion(self).cmp(&motion(other)).then(self.friction.total_cmp(&other.friction));
        by_motion
            .then(self.offset_magnitude.total_cmp(&other.offset_magnitude))
            .then(self.magnitude.total_cmp(&other.magnitude))
    }

    /// `17/20 (64-95 %)`.
    fn rate(&self) -> String {
        let [low, high] = wilson_interval(self.successes, self.rollouts).map(|rate| 100.0 * rate);
        let digits = if self.rollouts < MANY { 0 } else { 2 };
        format!("{}/{} ({low:.digits$}-{high:.digits$} %)", self.successes, self.rollouts)
    }
}

/// All groups, in the order of motion, friction, modelled and injected magnitude.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SuccessTable {
    groups: Vec<SuccessGroup>,
}

impl SuccessTable {
    /// Counts rollouts.
    pub fn new(played: &[PlayedRollout]) -> Self {
        let mut table = Self::default();
        played.iter().for_each(|played| table.add(played));
        table
    }

    /// Counts one more rollout.
    pub fn add(&mut self, played: &PlayedRollout) {
        if !self.groups.iter().any(|group| group.takes(played)) {
            self.groups.push(SuccessGroup::new(played));
            self.groups.sort_by(SuccessGroup::order);
        }
        self.groups.iter_mut().filter(|group| group.takes(played)).for_each(|group| group.add(played));
    }

    /// All groups.
    pub fn groups(&self) -> &[SuccessGroup] {
        &self.groups
    }

    /// The straight push that a group is compared with.
    fn baseline(&self, group: &SuccessGroup) -> Option<&SuccessGroup> {
        let key = (Motion::StraightPush, group.friction, group.offset_magnitude, group.magnitude);
        self.groups.iter().find(|other| (other.motion, other.friction, other.offset_magnitude, other.magnitude) == key)
    }

    /// Largest errors, penetration and force of every group, beside the straight push.
    fn write_details(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            formatter,
            "{:<8} {:>8} {:>8} {:>8}  {:<20} {:>9} {:>9} {:>9} {:>7}  straight push",
            "motion", "friction", "modelled", "injected", "success", "error", "angle", "penetration", "force"
        )?;
        for group in self.groups.iter().filter(|group| group.motion != Motion::StraightPush) {
            writeln!(
                formatter,
                "{:<8} {:>8} {:>5} mm {:>5} mm  {:<20} {:>6.2} mm {:>5.3} rad {:>6.3} mm {:>5.1} N  {}",
                group.motion,
                group.friction,
                Millimetres(group.offset_magnitude),
                Millimetres(group.magnitude),
                group.rate(),
                1e3 * group.position_error,
                group.orientation_error,
                1e3 * group.max_penetration,
                group.max_force,
                self.baseline(group).map(SuccessGroup::rate).unwrap_or_default()
            )?;
        }
        Ok(())
    }

    /// Rates of success in %: one row per motion, friction and modelled magnitude, one column per injected magnitude.
    fn write_matrix(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut magnitudes: Vec<f64> = self.groups.iter().map(|group| group.magnitude).collect();
        magnitudes.sort_by(f64::total_cmp);
        magnitudes.dedup();
        let same_row = |one: &SuccessGroup, other: &SuccessGroup| {
            (one.motion, one.friction, one.offset_magnitude) == (other.motion, other.friction, other.offset_magnitude)
        };
        write!(formatter, "{:<14} {:>8} {:>8}", "success in %", "friction", "modelled")?;
        magnitudes.iter().try_for_each(|magnitude| write!(formatter, " {:>5} mm", Millimetres(*magnitude)))?;
        writeln!(formatter)?;
        for row in self.groups.chunk_by(same_row) {
            write!(
                formatter,
                "{:<14} {:>8} {:>5} mm",
                row[0].motion,
                row[0].friction,
                Millimetres(row[0].offset_magnitude)
            )?;
            for magnitude in &magnitudes {
                match row.iter().find(|group| group.magnitude == *magnitude) {
                    Some(group) => {
                        write!(formatter, " {:>8.0}", 100.0 * group.successes as f64 / group.rollouts as f64)?;
                    }
                    None => write!(formatter, " {:>8}", "")?,
                }
            }
            writeln!(formatter)?;
        }
        Ok(())
    }
}

impl fmt::Display for SuccessTable {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        self.write_details(formatter)?;
        let first = self.groups.first().map(|group| group.magnitude);
        if self.groups.iter().any(|group| Some(group.magnitude) != first) {
            writeln!(formatter)?;
            self.write_matrix(formatter)?;
        }
        Ok(())
    }
}
