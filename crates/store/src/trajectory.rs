//! The four tables of a motion: `reference.csv`, `scenarios.csv`, `wrench.csv`, `contacts.csv`.

use std::path::Path;

use plan::PlannerError;
use serde::{Deserialize, Serialize};
use simulation::Reference;
use task::{
    AssemblyTask, Contact, Limits, POSE, Pose, Quality, Scenario, ScenarioTrajectory, State, Trajectory, Wrench,
};

use crate::atomic::write_file;
use crate::table::{Value, read_csv, seconds, to_csv};

/// Names of the tables in a plan's folder.
pub const TABLES: [&str; 4] = [REFERENCE, SCENARIOS, WRENCH, CONTACTS];
/// The motion to track.
pub const REFERENCE: &str = "reference.csv";
/// Motion of the body in every scenario.
pub const SCENARIOS: &str = "scenarios.csv";
/// Wrench of the impedance controller in every scenario.
pub const WRENCH: &str = "wrench.csv";
/// Distance and force of every pair in every scenario.
pub const CONTACTS: &str = "contacts.csv";

/// Defines a row of a table: a time, columns of its own, and the state of a body.
macro_rules! row_of_state {
    ($(#[$meta:meta])* $name:ident { $($own:ident: $of:ty),* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
        pub struct $name {
            time_s: Value,
            $($own: $of,)*
            px_m: Value,
            py_m: Value,
            pz_m: Value,
            qw: Value,
            qx: Value,
            qy: Value,
            qz: Value,
            vx_m_s: Value,
            vy_m_s: Value,
            vz_m_s: Value,
            wx_rad_s: Value,
            wy_rad_s: Value,
            wz_rad_s: Value,
        }

        impl $name {
            /// At a time (s), with the columns of its own.
            pub fn new(time: f64, $($own: $of,)* state: &State) -> Self {
                let time_s = seconds(time);
                let [px_m, py_m, pz_m, qw, qx, qy, qz, vx_m_s, vy_m_s, vz_m_s, wx_rad_s, wy_rad_s, wz_rad_s] =
                    state.map(Value);
                Self {
                    time_s, $($own,)* px_m, py_m, pz_m, qw, qx, qy, qz, vx_m_s, vy_m_s, vz_m_s, wx_rad_s, wy_rad_s, wz_rad_s,
                }
            }

            /// Time (s).
            pub fn time(&self) -> f64 {
                self.time_s.0
            }

            /// Pose and twist.
            pub fn state(&self) -> State {
                let Self { px_m, py_m, pz_m, qw, qx, qy, qz, vx_m_s, vy_m_s, vz_m_s, wx_rad_s, wy_rad_s, wz_rad_s, .. } =
                    *self;
                let numbers = [px_m, py_m, pz_m, qw, qx, qy, qz, vx_m_s, vy_m_s, vz_m_s, wx_rad_s, wy_rad_s, wz_rad_s];
                State(numbers.map(|value| value.0))
            }

            /// Why the row is no state of a body, if so. The norm of its quaternion may differ from 1 by `norm_error`.
            pub(crate) fn problem(&self, norm_error: f64) -> Option<&'static str> {
                timed_state_problem(self.time(), &self.state(), norm_error)
            }
        }
    };
}

row_of_state!(
    /// A row of `reference.csv`, and of traces: time and state.
    StateRow {}
);

row_of_state!(
    /// A row of `scenarios.csv`: time, scenario from 1, state of the body.
    ScenarioRow { scenario: usize }
);

/// A row of `wrench.csv`: time, scenario from 1, force (N, world frame) and torque (Nm, body frame).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WrenchRow {
    time_s: Value,
    scenario: usize,
    fx_n: Value,
    fy_n: Value,
    fz_n: Value,
    tx_nm: Value,
    ty_nm: Value,
    tz_nm: Value,
}

/// A row of `contacts.csv`: time, scenario from 1, pair, smoothed distance and force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactRow {
    time_s: Value,
    scenario: usize,
    pair: String,
    /// Empty where it could not be computed.
    distance_m: Option<Value>,
    force_n: Value,
}

/// How far the norm of a quaternion in a table may be from 1.
const NORM: f64 = 1e-6;
const ABSURD: &str = "a value is out of any reasonable range";

/// Why a time (s) and numbers are no state of a body, if so. The norm of its quaternion may differ from 1 by `norm_error`.
fn timed_state_problem(time: f64, state: &State, norm_error: f64) -> Option<&'static str> {
    /// Longest time that means anything (s).
    const LONGEST: f64 = 1e6;
    match time.abs() <= LONGEST {
        true => state_problem(state, norm_error),
        false => Some(ABSURD),
    }
}

/// Why numbers are no state of a body (pose, twist), if so. The norm of its quaternion may differ from 1 by `norm_error`.
pub fn state_problem(state: &State, norm_error: f64) -> Option<&'static str> {
    /// Largest value that means anything (m, m/s, rad/s).
    const LARGEST: f64 = 1e3;
    let norm = state[3..POSE].iter().map(|component| component * component).sum::<f64>().sqrt();
    // Comparisons are false for what is no number.
    if !state.iter().all(|value| value.abs() <= LARGEST) {
        return Some(ABSURD);
    }
    (!((norm - 1.0).abs() <= norm_error)).then_some("qw, qx, qy, qz are not a unit quaternion")
}

impl WrenchRow {
    /// At a time (s), of a scenario (from 1).
    pub fn new(time: f64, scenario: usize, wrench: &Wrench) -> Self {
        let [fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm] = wrench.map(Value);
        Self { time_s: seconds(time), scenario, fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm }
    }
}

/// Writes the four tables of a motion into a folder; `task` has its pairs.
///
/// # Errors
/// When a file cannot be written.
pub fn write_trajectory(folder: &Path, motion: &Trajectory, task: &AssemblyTask) -> Result<(), PlannerError> {
    let time = |step: usize| step as f64 * motion.time_step;
    let reference = motion.reference.iter().enumerate().map(|(step, state)| StateRow::new(time(step), state));
    let scenarios = || motion.scenarios.iter().zip(1..);
    let states = scenarios().flat_map(|(scenario, number)| {
        let states = scenario.states.iter().enumerate();
        states.map(move |(step, state)| ScenarioRow::new(time(step), number, state))
    });
    let wrenches = scenarios().flat_map(|(scenario, number)| {
        scenario.wrenches.iter().zip(1..).map(move |(wrench, step)| WrenchRow::new(time(step), number, wrench))
    });
    let contacts = scenarios().flat_map(|(scenario, number)| {
        scenario.contacts.iter().zip(1..).flat_map(move |(contacts, step)| {
            contacts.iter().zip(&task.pairs).map(move |(contact, pair)| ContactRow {
                time_s: seconds(time(step)),
                scenario: number,
                pair: pair.to_string(),
                distance_m: Some(contact.distance).filter(|distance| distance.is_finite()).map(Value),
                force_n: Value(contact.force),
            })
        })
    });
    write_file(&folder.join(REFERENCE), &to_csv(reference)?)?;
    write_file(&folder.join(SCENARIOS), &to_csv(states)?)?;
    write_file(&folder.join(WRENCH), &to_csv(wrenches)?)?;
    write_file(&folder.join(CONTACTS), &to_csv(contacts)?)
}

/// Reads a reference.
///
/// # Errors
/// With the line where it is not one: fewer than two rows, unequal steps, a quaternion that is not of unit norm.
pub fn read_reference(file: &Path) -> Result<Reference, PlannerError> {
    let (time_step, states) = read_states(file)?;
    Ok(Reference::new(time_step, &states))
}

/// Time step (s) and states of a reference.
fn read_states(file: &Path) -> Result<(f64, Vec<State>), PlannerError> {
    /// How far a position may be from where the velocity leads (m).
    const JUMP: f64 = 1e-6;
    let rows: Vec<StateRow> = read_csv(file)?;
    let wrong = |row: usize, problem: &str| Err(PlannerError::line(file, row + 2, problem));
    let [first, .., last] = rows.as_slice() else {
        return wrong(rows.len(), "a reference has at least two rows");
    };
    let time_step = (last.time() - first.time()) / (rows.len() - 1) as f64;
    for (index, row) in rows.iter().enumerate() {
        if !(time_step > 0.0 && (row.time() - first.time() - index as f64 * time_step).abs() < 1e-3 * time_step) {
            return wrong(index, "times must increase in equal steps");
        }
        if let Some(problem) = row.problem(NORM) {
            return wrong(index, problem);
        }
    }
    // As the motion is computed: each position follows from the one before by the velocity at the end of the step.
    for (index, neighbors) in (1..).zip(rows.windows(2)) {
        let [before, after] = [&neighbors[0], &neighbors[1]].map(StateRow::state);
        let is_continuous = |axis: usize| (after[axis] - before[axis] - time_step * after[POSE + axis]).abs() <= JUMP;
        if !(0..3).all(is_continuous) {
            return wrong(index, "the position does not follow from the row before and the velocity");
        }
    }
    Ok((time_step, rows.iter().map(StateRow::state).collect()))
}

/// Poses of the body at the end of every scenario.
///
/// # Errors
/// When the table of scenarios is missing or wrong.
pub fn read_ends(file: &Path) -> Result<Vec<Pose>, PlannerError> {
    let rows: Vec<ScenarioRow> = read_csv(file)?;
    let is_end =
        |(index, row): &(usize, &ScenarioRow)| rows.get(index + 1).is_none_or(|next| next.scenario != row.scenario);
    Ok(rows.iter().enumerate().filter(is_end).map(|(_, row)| row.state().pose()).collect())
}

/// The four tables of a motion as they stand in a folder, whatever task they are of.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionTables {
    /// Length of a step (s).
    pub time_step: f64,
    /// Reference states (pose, twist) at k = 0..N.
    pub reference: Vec<State>,
    /// Names of the pairs, `BODY PART/ENVIRONMENT PART`, in the order of the contacts.
    pub pairs: Vec<String>,
    /// One per scenario.
    pub scenarios: Vec<ScenarioTables>,
}

/// Tables of one scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct ScenarioTables {
    /// States of the body at k = 0..N.
    pub states: Vec<State>,
    /// Wrenches of the impedance controller at k = 1..N: force (N, world frame), torque (Nm, body frame).
    pub wrenches: Vec<Wrench>,
    /// Contacts at k = 1..N, one per pair.
    pub contacts: Vec<Vec<Contact>>,
}

impl MotionTables {
    /// From a motion; `task` has its pairs.
    pub fn new(motion: &Trajectory, task: &AssemblyTask) -> Self {
        let scenario = |scenario: &ScenarioTrajectory| ScenarioTables {
            states: scenario.states.clone(),
            wrenches: scenario.wrenches.clone(),
            contacts: scenario.contacts.clone(),
        };
        Self {
            time_step: motion.time_step,
            reference: motion.reference.clone(),
            pairs: task.pairs.iter().map(ToString::to_string).collect(),
            scenarios: motion.scenarios.iter().map(scenario).collect(),
        }
    }
}

/// Reads the four tables of a folder.
///
/// # Errors
/// When a table is missing or wrong, or does not fit the others.
pub fn read_tables(folder: &Path) -> Result<MotionTables, PlannerError> {
    let (time_step, reference) = read_states(&folder.join(REFERENCE))?;
    let states: Vec<ScenarioRow> = read_csv(&folder.join(SCENARIOS))?;
    let wrenches: Vec<WrenchRow> = read_csv(&folder.join(WRENCH))?;
    let contacts: Vec<ContactRow> = read_csv(&folder.join(CONTACTS))?;
    let steps = reference.len() - 1;
    let scenarios = states.len() / (steps + 1);
    let place = |index: usize, rows: usize, first: usize| Place {
        scenario: index / rows + 1,
        time: (index % rows + first) as f64 * time_step,
    };
    for (index, row) in states.iter().enumerate() {
        let problem = row.problem(NORM).or_else(|| misplaced(row.scenario, row.time_s, place(index, steps + 1, 0)));
        require_none(&folder.join(SCENARIOS), index, problem)?;
    }
    for (index, row) in wrenches.iter().enumerate() {
        let problem = absurd(&wrench(row)).or_else(|| misplaced(row.scenario, row.time_s, place(index, steps, 1)));
        require_none(&folder.join(WRENCH), index, problem)?;
    }
    // Every pair is named in the first step of the first scenario.
    let first_step = |row: &&ContactRow| row.scenario == 1 && row.time_s == contacts[0].time_s;
    let pairs: Vec<String> = contacts.iter().take_while(first_step).map(|row| row.pair.clone()).collect();
    if pairs.is_empty() && (scenarios > 0 || !contacts.is_empty()) {
        let problem = "has no row of the first scenario; solve again";
        return Err(PlannerError::file(&folder.join(CONTACTS), problem));
    }
    for (index, row) in contacts.iter().enumerate() {
        let place = place(index / pairs.len(), steps, 1);
        let problem = no_contact(row).or_else(|| misplaced(row.scenario, row.time_s, place));
        require_none(&folder.join(CONTACTS), index, problem)?;
    }
    for (file, rows, expected) in [
        (SCENARIOS, states.len(), scenarios * (steps + 1)),
        (WRENCH, wrenches.len(), scenarios * steps),
        (CONTACTS, contacts.len(), scenarios * steps * pairs.len()),
    ] {
        require_rows(&folder.join(file), rows, expected)?;
    }
    let scenario = |index: usize| ScenarioTables {
        states: states[index * (steps + 1)..][..steps + 1].iter().map(|row| row.state()).collect(),
        wrenches: wrenches[index * steps..][..steps].iter().map(wrench).collect(),
        contacts: (0..steps)
            .map(|step| contacts[(index * steps + step) * pairs.len()..][..pairs.len()].iter().map(contact).collect())
            .collect(),
    };
    Ok(MotionTables { time_step, reference, scenarios: (0..scenarios).map(scenario).collect(), pairs })
}

/// Refuses a row (from 0) of a table that has a problem.
fn require_none(file: &Path, row: usize, problem: Option<impl Into<String>>) -> Result<(), PlannerError> {
    problem.map_or(Ok(()), |problem| Err(PlannerError::line(file, row + 2, problem)))
}

/// Where a row stands in a table.
struct Place {
    /// Number of the scenario, from 1.
    scenario: usize,
    /// Time (s).
    time: f64,
}

/// Why a row does not belong where it stands, if so.
fn misplaced(scenario: usize, time: Value, place: Place) -> Option<&'static str> {
    /// How far a time may be off (s): it is written in nanoseconds.
    const SAME: f64 = 1e-6;
    (scenario != place.scenario || !((time.0 - place.time).abs() <= SAME))
        .then_some("another scenario or time should be here")
}

/// Why numbers are no wrench, if so.
fn absurd(wrench: &Wrench) -> Option<&'static str> {
    /// Largest value that means anything (N, Nm).
    const LARGEST: f64 = 1e9;
    (!wrench.iter().all(|value| value.abs() <= LARGEST)).then_some(ABSURD)
}

/// Why a row is no contact, if so: a force pushes, but for rounding.
fn no_contact(row: &ContactRow) -> Option<&'static str> {
    /// Largest distance (m) and force (N) that mean anything.
    const LARGEST: f64 = 1e9;
    /// Force (N) of rounding.
    const ROUNDING: f64 = 1e-3;
    let is_distance = row.distance_m.is_none_or(|distance| distance.0.abs() <= LARGEST);
    (!is_distance || !(-ROUNDING..=LARGEST).contains(&row.force_n.0)).then_some(ABSURD)
}

fn require_rows(file: &Path, rows: usize, expected: usize) -> Result<(), PlannerError> {
    if rows == expected {
        return Ok(());
    }
    Err(PlannerError::file(file, format!("{rows} rows where {expected} are expected; solve again")))
}

/// Reads the four tables of a folder exactly as they were written; what they do not hold (final errors, penetration, limits)
/// is computed again from the task. The drift of quaternions, which are written with unit norm, is not known.
///
/// # Errors
/// When a table is missing, wrong, or does not fit the others or the task.
pub fn read_trajectory(folder: &Path, task: &AssemblyTask) -> Result<Trajectory, PlannerError> {
    let MotionTables { reference, pairs, scenarios, .. } = read_tables(folder)?;
    let (time_step, steps) = (task.horizon.time_step, task.horizon.steps);
    for (file, rows, expected) in [
        (REFERENCE, reference.len() - 1, steps),
        (SCENARIOS, scenarios.len() * (steps + 1), task.scenarios().len() * (steps + 1)),
        (CONTACTS, scenarios.len() * steps * pairs.len(), scenarios.len() * steps * task.pairs.len()),
    ] {
        require_rows(&folder.join(file), rows, expected)?;
    }
    let scenario = |(tables, Scenario { grasp, .. }): (ScenarioTables, Scenario)| {
        let ScenarioTables { states, wrenches, contacts } = tables;
        let poses: Vec<_> = states.iter().map(State::pose).collect();
        let quality = Quality::new(task, &poses, &contacts);
        let keeps = Limits::kept_by(&states, time_step, &wrenches, quality.max_force);
        ScenarioTrajectory { grasp, states, wrenches, contacts, quality, keeps }
    };
    Ok(Trajectory {
        time_step,
        reference_keeps: Limits::kept_by(&reference, time_step, &[], 0.0),
        reference,
        scenarios: scenarios.into_iter().zip(task.scenarios()).map(scenario).collect(),
        quaternion_drift: 0.0,
    })
}

fn wrench(row: &WrenchRow) -> Wrench {
    let WrenchRow { fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm, .. } = *row;
    Wrench([fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm].map(|value| value.0))
}

fn contact(row: &ContactRow) -> Contact {
    Contact { distance: row.distance_m.map_or(f64::NAN, |distance| distance.0), force: row.force_n.0 }
}
