//! A log in the form in which rollouts are compared with it.

use admittance::PositionRobot;
use nalgebra::{Isometry3, Vector3};
use plan::{Millimetres, PlannerError, Problem};
use simulation::Reference;
use task::pose::interpolate;
use task::{AssemblyTask, GraspError, Impedance, Pose, State, Twist};

use crate::commanded::biases;
use crate::deviation::{COMPONENTS, deviation};
use crate::log::{Log, Row};
use crate::swing::end_before_swing;

/// Shortest time between two samples that are compared (s): closer ones add no information.
const SAMPLE_INTERVAL: f64 = 0.01;

/// A log that is compared with rollouts.
#[derive(Debug, Clone)]
pub struct Run {
    /// Name of its file.
    pub name: String,
    /// The environment of the run, with the gains that were set; without pairs of parts in free air.
    pub task: AssemblyTask,
    /// The robot and its law, if it is commanded by position or force.
    pub robot: Option<PositionRobot>,
    /// Where the robot first believed the part.
    pub beginning: Pose,
    /// The robot's reference, which starts there unless it is commanded by position or force.
    pub reference: Reference,
    /// Times (s) and believed poses of the part.
    pub samples: Vec<(f64, Isometry3<f64>)>,
    /// Tracking errors of the robot at these times (m, rad).
    pub tracking_errors: Vec<[f64; COMPONENTS]>,
    /// The grasp error, as far as the end of the log determines it.
    pub grasp: GraspError,
    /// Errors of the measured force (N) and torque (Nm), as far as the distance from the reference in free air says them.
    pub bias: [f64; 6],
    /// Reason if only a part of the log is used.
    pub end: Option<String>,
    /// Whether the robot oscillates by itself after that part.
    pub swings: bool,
}

impl Run {
    /// From a log. The reference has a step for each control period of a robot, else for each row.
    ///
    /// # Errors
    /// When the part did not end at its goal, so that its grasp error is unknown.
    pub fn new(log: &Log, problem: &Problem) -> Result<Self, PlannerError> {
        let mut task = AssemblyTask { impedance: Impedance::from(&log.impedance), ..problem.world() };
        let mut grasp = GraspError::default();
        if log.in_free_air {
            task.pairs.clear();
        } else {
            grasp = grasp_at_end(log, problem)?;
        }
        let scene = problem.scene();
        let robot =
            scene.position_robot.as_ref().zip(log.law.as_ref()).map(|(robot, law)| law.on(robot, &log.impedance));
        let of_arm = || scene.robot.as_ref().map(|robot| robot.control_period);
        let period = robot.as_ref().map(|robot| robot.period).or_else(of_arm);
        let time_step = period.unwrap_or_else(|| median_gap(log));
        let reference = match &robot {
            Some(_) => smooth_reference(&log.rows, time_step),
            None => reference(&log.rows, time_step),
        };
        let bias = robot.as_ref().map_or([0.0; 6], |robot| biases(robot, log.sag()));
        task.start = reference.start();
        let every = (SAMPLE_INTERVAL / time_step).round().max(1.0) as usize;
        let times = (every..reference.intervals()).step_by(every).map(|knot| knot as f64 * time_step);
        let samples: Vec<(f64, Isometry3<f64>)> = times.map(|time| (time, believed(&log.rows, time))).collect();
        let end = log.stopped.as_ref().map(|reason| format!("used until it was stopped ({reason})"));
        let name = log.file.display().to_string();
        let beginning = Pose::from(&log.rows[0].believed);
        let tracking_errors = Vec::new();
        let mut run =
            Self { name, task, robot, beginning, reference, samples, tracking_errors, grasp, bias, end, swings: false };
        run.compare_with_reference(every);
        Ok(run)
    }

    /// Computes the tracking error at every `every`-th knot. In free air, the run ends where the robot starts to
    /// oscillate: no rollout follows an oscillation for long.
    fn compare_with_reference(&mut self, every: usize) {
        let believed: Vec<Isometry3<f64>> = self.samples.iter().map(|(_, pose)| *pose).collect();
        let followed: Vec<Isometry3<f64>> =
            (1..=believed.len()).map(|sample| self.reference.at(sample * every, 0.0).pose).collect();
        if let Some(first) =
            end_before_swing(&believed, &followed).filter(|_| !self.has_contact() && self.robot.is_none())
        {
            let swing = format!(
                "used up to {:.1} s, after which the robot swings by itself: torques come too late for the damping; repeat the \
                 run with --damping-factor 0.7, then also --stiffness-factor 0.7",
                self.samples[first].0
            );
            self.swings = true;
            self.end = Some(self.end.iter().chain([&swing]).map(String::as_str).collect::<Vec<_>>().join("; "));
            self.samples.truncate(first);
            self.reference = self.reference.cut(first * every + 1);
        }
        self.tracking_errors =
            self.samples.iter().zip(&followed).map(|((_, pose), from)| deviation(pose, from)).collect();
    }

    /// Whether the parts could touch.
    pub fn has_contact(&self) -> bool {
        !self.task.pairs.is_empty()
    }
}

/// Once the part is at its goal, believed pose minus goal is the grasp error.
fn grasp_at_end(log: &Log, problem: &Problem) -> Result<GraspError, PlannerError> {
    let end = log.rows.last().map_or_else(Isometry3::identity, |row| row.believed);
    let grasp = GraspError::of_believed(&(problem.scene().goal.isometry().inverse() * end));
    let (length, most) = (Vector3::from(grasp.offset).norm(), log.offset_magnitude + problem.success().position);
    if length > most {
        let problem = format!(
            "the part did not end at its goal, or sat {} mm beside where it was believed, more than the {} mm that the \
             plan covers: leave this log out",
            Millimetres(length),
            Millimetres(most)
        );
        return Err(PlannerError::file(&log.file, problem));
    }
    Ok(grasp)
}

/// Median of the times between two rows (s).
fn median_gap(log: &Log) -> f64 {
    let mut gaps: Vec<f64> = log.rows.windows(2).map(|pair| pair[1].time - pair[0].time).collect();
    gaps.sort_by(f64::total_cmp);
    gaps[gaps.len() / 2]
}

/// The reference on a regular grid: that of a row holds until the next one. It starts at the believed pose of the part,
/// where rollouts start at rest.
fn reference(rows: &[Row], time_step: f64) -> Reference {
    let last = rows.last().map_or(0.0, |row| row.time);
    let mut states: Vec<State> = Vec::new();
    for knot in 0..=(last / time_step).ceil() as usize {
        let mut state = rows[row_at(rows, knot as f64 * time_step)].reference;
        // The twist of a knot leads to it from the one before.
        if let Some(before) = knot.checked_sub(1) {
            state = State::new(&state.pose(), &rows[row_at(rows, before as f64 * time_step)].reference.twist());
        }
        states.push(state);
    }
    states[0] = State::new(&Pose::from(&rows[0].believed), &states[0].twist());
    Reference::new(time_step, &states)
}

/// The reference of a robot that is commanded by position or force: its law samples it more often than rows may be written, so it
/// is interpolated between them.
fn smooth_reference(rows: &[Row], time_step: f64) -> Reference {
    let last = rows.last().map_or(0.0, |row| row.time);
    let mut states: Vec<State> = Vec::new();
    // The twist of a knot holds from the one before.
    let mut before = rows[0].reference.twist();
    for knot in 0..=(last / time_step).ceil() as usize {
        let (pose, twist) = between(rows, knot as f64 * time_step);
        states.push(State::new(&pose, &before));
        before = twist;
    }
    Reference::new(time_step, &states)
}

/// The reference at a time (s), between two rows.
fn between(rows: &[Row], time: f64) -> (Pose, Twist) {
    let index = row_at(rows, time);
    let from = &rows[index];
    let Some(to) = rows.get(index + 1) else { return (from.reference.pose(), from.reference.twist()) };
    let share = ((time - from.time) / (to.time - from.time)).clamp(0.0, 1.0);
    let pose = interpolate(&from.reference.pose().isometry(), &to.reference.pose().isometry(), share);
    let (one, other) = (from.reference.twist(), to.reference.twist());
    let twist = std::array::from_fn(|axis| (1.0 - share) * one[axis] + share * other[axis]);
    (Pose::from(&pose), Twist(twist))
}

/// Index of the last row at or before a time (s).
fn row_at(rows: &[Row], time: f64) -> usize {
    /// Times are written to a microsecond.
    const ROUNDING: f64 = 1e-5;
    rows.partition_point(|row| row.time <= time + ROUNDING).saturating_sub(1)
}

/// The believed pose of the part at a time (s).
fn believed(rows: &[Row], time: f64) -> Isometry3<f64> {
    let index = row_at(rows, time);
    let (from, Some(to)) = (&rows[index], rows.get(index + 1)) else { return rows[index].believed };
    let fraction = ((time - from.time) / (to.time - from.time)).clamp(0.0, 1.0);
    interpolate(&from.believed, &to.believed, fraction)
}
