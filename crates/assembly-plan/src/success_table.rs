//! Rates of success by modelled and injected magnitude (Fig. realworldresults).

use std::fmt;

use simulation::wilson_interval;

use crate::failure::Failure;
use crate::output::table;
use crate::played::{Motion, Played};

/// Rollouts that differ by nothing but plan (of the same delta-hat) and offset (of the same magnitude).
struct Cell {
    motion: Motion,
    friction: f64,
    /// Modelled magnitude delta-hat (m).
    delta: f64,
    /// Injected magnitude (m).
    magnitude: f64,
    rollouts: usize,
    successes: usize,
    position_error: f64,
    orientation_error: f64,
    max_penetration: f64,
    max_force: f64,
}

impl Cell {
    fn new(played: &Played) -> Self {
        Self {
            motion: played.motion,
            friction: played.friction,
            delta: played.plan.delta,
            magnitude: played.magnitude,
            rollouts: 0,
            successes: 0,
            position_error: 0.0,
            orientation_error: 0.0,
            max_penetration: 0.0,
            max_force: 0.0,
        }
    }

    fn takes(&self, played: &Played) -> bool {
        let key = (played.motion, played.friction, played.plan.delta, played.magnitude);
        (self.motion, self.friction, self.delta, self.magnitude) == key
    }

    fn add(&mut self, played: &Played) {
        let outcome = &played.outcome;
        self.rollouts += 1;
        self.successes += usize::from(played.success);
        self.position_error = self.position_error.max(outcome.position_error);
        self.orientation_error = self.orientation_error.max(outcome.orientation_error);
        self.max_penetration = self.max_penetration.max(outcome.max_penetration);
        self.max_force = self.max_force.max(outcome.max_force);
    }

    /// `17/20 (64-95 %)`.
    fn rate(&self) -> String {
        let [low, high] = wilson_interval(self.successes, self.rollouts).map(|rate| 100.0 * rate);
        format!("{}/{} ({low:.0}-{high:.0} %)", self.successes, self.rollouts)
    }
}

/// All cells, in the order of motion, friction, modelled and injected magnitude.
pub struct SuccessTable {
    cells: Vec<Cell>,
}

impl SuccessTable {
    /// Counts rollouts.
    pub fn new(played: &[Played]) -> Self {
        let mut cells: Vec<Cell> = Vec::new();
        for played in played {
            let known = cells.iter().position(|cell| cell.takes(played));
            let index = known.unwrap_or_else(|| {
                cells.push(Cell::new(played));
                cells.len() - 1
            });
            cells[index].add(played);
        }
        let order = |cell: &Cell| match cell.motion {
            Motion::Stage(number) => number,
            Motion::Plan => usize::MAX - 1,
            Motion::StraightPush => usize::MAX,
        };
        cells.sort_by(|one, other| {
            let by_motion = order(one).cmp(&order(other)).then(one.friction.total_cmp(&other.friction));
            by_motion.then(one.delta.total_cmp(&other.delta)).then(one.magnitude.total_cmp(&other.magnitude))
        });
        Self { cells }
    }

    /// One line per cell.
    pub fn to_csv(&self) -> Result<Vec<u8>, Failure> {
        let header = [
            "motion",
            "friction",
            "delta_m",
            "magnitude_m",
            "rollouts",
            "successes",
            "rate",
            "rate_low",
            "rate_high",
            "largest_position_error_m",
            "largest_orientation_error_rad",
            "max_penetration_m",
            "max_force_n",
        ];
        let rows = self.cells.iter().map(|cell| {
            let [low, high] = wilson_interval(cell.successes, cell.rollouts);
            vec![
                cell.motion.to_string(),
                cell.friction.to_string(),
                cell.delta.to_string(),
                cell.magnitude.to_string(),
                cell.rollouts.to_string(),
                cell.successes.to_string(),
                (cell.successes as f64 / cell.rollouts as f64).to_string(),
                low.to_string(),
                high.to_string(),
                cell.position_error.to_string(),
                cell.orientation_error.to_string(),
                cell.max_penetration.to_string(),
                cell.max_force.to_string(),
            ]
        });
        table(header.into_iter(), rows)
    }

    /// The straight push that a cell is compared with.
    fn baseline(&self, cell: &Cell) -> Option<&Cell> {
        let key = (Motion::StraightPush, cell.friction, cell.delta, cell.magnitude);
        self.cells.iter().find(|other| (other.motion, other.friction, other.delta, other.magnitude) == key)
    }

    /// Largest errors, overlap and force of every cell, beside the straight push.
    fn write_details(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            formatter,
            "{:<8} {:>8} {:>8} {:>8}  {:<20} {:>9} {:>9} {:>9} {:>7}  straight push",
            "motion", "friction", "modelled", "injected", "success", "error", "angle", "overlap", "force"
        )?;
        for cell in self.cells.iter().filter(|cell| cell.motion != Motion::StraightPush) {
            writeln!(
                formatter,
                "{:<8} {:>8} {:>5.1} mm {:>5.1} mm  {:<20} {:>6.2} mm {:>5.3} rad {:>6.3} mm {:>5.1} N  {}",
                cell.motion,
                cell.friction,
                1e3 * cell.delta,
                1e3 * cell.magnitude,
                cell.rate(),
                1e3 * cell.position_error,
                cell.orientation_error,
                1e3 * cell.max_penetration,
                cell.max_force,
                self.baseline(cell).map(Cell::rate).unwrap_or_default()
            )?;
        }
        Ok(())
    }

    /// Rates of success in %: one row per motion, friction and modelled magnitude, one column per injected magnitude.
    fn write_matrix(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut magnitudes: Vec<f64> = self.cells.iter().map(|cell| cell.magnitude).collect();
        magnitudes.sort_by(f64::total_cmp);
        magnitudes.dedup();
        let same_row = |one: &Cell, other: &Cell| {
            (one.motion, one.friction, one.delta) == (other.motion, other.friction, other.delta)
        };
        write!(formatter, "{:<14} {:>8} {:>8}", "success in %", "friction", "modelled")?;
        magnitudes.iter().try_for_each(|magnitude| write!(formatter, " {:>5.1} mm", 1e3 * magnitude))?;
        writeln!(formatter)?;
        for row in self.cells.chunk_by(same_row) {
            write!(formatter, "{:<14} {:>8} {:>5.1} mm", row[0].motion, row[0].friction, 1e3 * row[0].delta)?;
            for magnitude in &magnitudes {
                match row.iter().find(|cell| cell.magnitude == *magnitude) {
                    Some(cell) => {
                        write!(formatter, " {:>8.0}", 100.0 * cell.successes as f64 / cell.rollouts as f64)?;
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
        let first = self.cells.first().map(|cell| cell.magnitude);
        if self.cells.iter().any(|cell| Some(cell.magnitude) != first) {
            writeln!(formatter)?;
            self.write_matrix(formatter)?;
        }
        Ok(())
    }
}
