//! `executed.csv`, the log of a player.

use std::path::{Path, PathBuf};

use nalgebra::Isometry3;
use plan::PlannerError;
use plan::records::{AdmittanceRecord, ImpedanceRecord};
use scene::Scene;
use serde::Deserialize;
use store::{PLAYING, RESTING, StateRow, Value, read_csv, read_log_header, state_problem};
use task::{Pose, State};

use crate::commanded::{Law, SpringActsOn};
use crate::deviation::{COMPONENTS, deviation};

/// Longest time between two rows (s): the motion between them is unknown.
const LONGEST_GAP: f64 = 0.1;
/// Reason for an early end of a log without a reason of its own.
const CUT: &str = "the log ends before the plan does";
/// Poses whose numbers differ by less (m, or a component of a quaternion) are the same.
const SAME: f64 = 1e-5;

/// First line of a log: its session. Poses are position (m) and unit quaternion (w x y z).
#[derive(Debug, Clone, Deserialize)]
struct Header {
    scene: String,
    base: Pose,
    grasp: Pose,
    goal: Pose,
    delta_m: f64,
    dry_run_m: f64,
    impedance: ImpedanceRecord,
    /// The law of a robot that is commanded by position or force.
    admittance: Option<AdmittanceRecord>,
    spring_acts_on: Option<SpringActsOn>,
    /// Why the robot was stopped, if it was.
    stopped: Option<String>,
}

/// The part of a row besides the state.
#[derive(Deserialize)]
struct FollowedRow {
    elapsed_s: Value,
    reference_px_m: Value,
    reference_py_m: Value,
    reference_pz_m: Value,
    reference_qw: Value,
    reference_qx: Value,
    reference_qy: Value,
    reference_qz: Value,
    reference_vx_m_s: Value,
    reference_vy_m_s: Value,
    reference_vz_m_s: Value,
    reference_wx_rad_s: Value,
    reference_wy_rad_s: Value,
    reference_wz_rad_s: Value,
    phase: String,
}

impl FollowedRow {
    fn state(&self) -> State {
        let numbers = [
            self.reference_px_m,
            self.reference_py_m,
            self.reference_pz_m,
            self.reference_qw,
            self.reference_qx,
            self.reference_qy,
            self.reference_qz,
            self.reference_vx_m_s,
            self.reference_vy_m_s,
            self.reference_vz_m_s,
            self.reference_wx_rad_s,
            self.reference_wy_rad_s,
            self.reference_wz_rad_s,
        ];
        State(numbers.map(|value| value.0))
    }
}

/// A measurement.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Since the first row (s).
    pub time: f64,
    /// Where the robot believed the part.
    pub believed: Isometry3<f64>,
    /// Reference from then on: pose and twist.
    pub reference: State,
}

/// One execution of a plan.
#[derive(Debug, Clone)]
pub struct Log {
    /// Its file.
    pub file: PathBuf,
    /// All rows, at least two, their times increasing.
    pub rows: Vec<Row>,
    /// The gains that were set.
    pub impedance: ImpedanceRecord,
    /// The law of a robot that is commanded by position or force.
    pub law: Option<Law>,
    /// Number of first rows that are in free air for certain.
    pub approach: usize,
    /// Whether all of its rows are of motions in free air.
    pub in_free_air: bool,
    /// Why it ends before its plan does, if so: then it only has rows in free air.
    pub stopped: Option<String>,
    /// Offset magnitude that the plan covers (m).
    pub offset_magnitude: f64,
}

impl Log {
    /// Reads a log of a plan of a scene. Of a run that was stopped, only the motion in free air is kept, as its grasp
    /// error is unknown.
    ///
    /// # Errors
    /// With file, line and column, when it is not a log, is of another scene, or was stopped without a motion
    /// in free air.
    pub fn read(file: &Path, scene: &Scene) -> Result<Self, PlannerError> {
        let header = read_header(file)?;
        header.require_scene(file, scene)?;
        let (states, followed) = (read_csv::<StateRow>(file)?, read_csv::<FollowedRow>(file)?);
        require_states(file, &states, &followed)?;
        let Header { impedance, admittance, spring_acts_on, dry_run_m, delta_m, stopped, .. } = header;
        let law = admittance.zip(spring_acts_on).map(|(record, spring)| Law { record, spring });
        let stopped = stopped.or_else(|| followed.last().filter(|row| row.phase != RESTING).map(|_| CUT.to_owned()));
        let is_dry = dry_run_m > 0.0;
        let in_free_air = |row: &&FollowedRow| is_dry || (row.phase != PLAYING && row.phase != RESTING);
        let kept = if stopped.is_some() { followed.iter().take_while(in_free_air).count() } else { followed.len() };
        let approach = followed.iter().take(kept).take_while(in_free_air).count();
        let rows: Vec<Row> = states
            .iter()
            .zip(&followed)
            .map(|(state, followed)| Row {
                time: followed.elapsed_s.0,
                believed: state.state().pose().isometry(),
                reference: followed.state(),
            })
            .take(kept)
            .collect();
        if let Some(reason) = stopped.as_ref().filter(|_| rows.len() < 2 && followed.len() >= 2) {
            let problem = format!(
                "the run was stopped ({reason}) and has no motion in free air: leave this log out, or repeat the run with \
                 --dry-run or without --skip-self-test"
            );
            return Err(PlannerError::file(file, problem));
        }
        require_rows(file, &rows)?;
        let in_free_air = is_dry || stopped.is_some();
        Ok(Self {
            file: file.to_owned(),
            rows,
            impedance,
            law,
            approach,
            in_free_air,
            stopped,
            offset_magnitude: delta_m,
        })
    }
}

impl Log {
    /// Mean distance of the robot from its reference (m, rad) in the second half of the approach, or of a dry run.
    pub fn sag(&self) -> [f64; COMPONENTS] {
        let settled = &self.rows[self.approach / 2..self.approach];
        let far = |row: &Row| deviation(&row.believed, &row.reference.pose().isometry());
        let sum = settled
            .iter()
            .map(far)
            .fold([0.0; COMPONENTS], |sum, far| std::array::from_fn(|component| sum[component] + far[component]));
        sum.map(|sum| sum / settled.len().max(1) as f64)
    }
}

/// The line above the columns, which must be there.
fn read_header(file: &Path) -> Result<Header, PlannerError> {
    read_log_header(file)?.ok_or_else(|| {
        let problem =
            "the line `# {...}` with the gains that were set is missing: export the plan again, and repeat the run";
        PlannerError::line(file, 1, problem)
    })
}

impl Header {
    /// Refuses logs of another scene.
    fn require_scene(&self, file: &Path, scene: &Scene) -> Result<(), PlannerError> {
        let refuse = |what: String| {
            Err(PlannerError::line(file, 1, format!("the log is of another scene: {what}; name the scene of its plan")))
        };
        if self.scene != scene.title {
            return refuse(format!("its title is `{}`, that of the scene `{}`", self.scene, scene.title));
        }
        let is_same = |one: &Pose, other: &Pose| {
            let near =
                |sign: f64| one[3..].iter().zip(&other[3..]).all(|(one, other)| (one - sign * other).abs() < SAME);
            one[..3].iter().zip(&other[..3]).all(|(one, other)| (one - other).abs() < SAME) && (near(1.0) || near(-1.0))
        };
        if !is_same(&self.goal, &scene.goal) {
            return refuse("its goal is another pose".to_owned());
        }
        let own = self.admittance.as_ref().map_or("torque", |law| &law.interface);
        let of_scene = match &scene.position_robot {
            None => "torque",
            Some(robot) if robot.force_mode.is_some() => "force",
            Some(_) => "position",
        };
        if own != of_scene {
            return refuse(format!(
                "its robot has the interface `{own}`, and robot.interface is `{of_scene}`; logs of former versions say none: \
                 export the plan again, and repeat the run"
            ));
        }
        if self.admittance.is_some() && self.spring_acts_on.is_none() {
            return refuse("`spring_acts_on` is missing, with what the law acts on".to_owned());
        }
        let Some(robot) = &scene.robot else { return Ok(()) };
        for (name, own, given) in [("base", &self.base, &robot.base), ("grasp", &self.grasp, &robot.grasp)] {
            if !is_same(own, given) {
                return refuse(format!("robot.{name} is another pose"));
            }
        }
        Ok(())
    }
}

/// Lines above the first row.
const ABOVE: usize = 2;
/// Largest deviation of the norm of a quaternion from 1: robots give few digits.
const NORM: f64 = 1e-3;

/// Refuses measurements and references that are impossible.
fn require_states(file: &Path, states: &[StateRow], followed: &[FollowedRow]) -> Result<(), PlannerError> {
    for (index, (state, followed)) in states.iter().zip(followed).enumerate() {
        let problem = state_problem(&state.state(), NORM).or_else(|| state_problem(&followed.state(), NORM));
        if let Some(problem) = problem {
            return Err(PlannerError::line(file, index + 1 + ABOVE, format!("{problem}; leave this log out")));
        }
    }
    Ok(())
}

/// Refuses tables that are not one motion.
fn require_rows(file: &Path, rows: &[Row]) -> Result<(), PlannerError> {
    if rows.len() < 2 {
        return Err(PlannerError::file(file, "has fewer than two rows: the player measured nothing; repeat the run"));
    }
    for (index, pair) in rows.windows(2).enumerate() {
        let gap = pair[1].time - pair[0].time;
        if !(gap > 0.0 && gap <= LONGEST_GAP) {
            let problem = format!(
                "column elapsed_s: {gap:.3} s after the row before; times must increase, by {LONGEST_GAP} s at most: \
                 repeat the run"
            );
            return Err(PlannerError::line(file, index + 2 + ABOVE, problem));
        }
    }
    Ok(())
}
