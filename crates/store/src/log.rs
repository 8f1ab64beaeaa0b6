//! `executed.csv`: what the player of an export writes of one execution.

use std::path::Path;

use plan::PlannerError;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use task::{State, Wrench};

use crate::atomic::read_text;
use crate::table::{Value, read_csv};
use crate::trajectory::StateRow;

/// Version of the log that is read.
const FORMAT: u32 = 1;
/// How far the norm of a quaternion may be from 1: other tools write few digits.
const NORM: f64 = 1e-3;
/// The phase in which the plan is executed.
pub const PLAYING: &str = "playing";
/// The phase with which a log ends unless the robot was stopped.
pub const RESTING: &str = "resting";

#[derive(Deserialize)]
struct Version {
    format: u32,
}

/// The measurements of a row.
#[derive(Deserialize)]
struct MeasuredRow {
    fx_n: Option<Value>,
    fy_n: Option<Value>,
    fz_n: Option<Value>,
    tx_nm: Option<Value>,
    ty_nm: Option<Value>,
    tz_nm: Option<Value>,
    phase: String,
}

impl MeasuredRow {
    fn wrench(&self) -> Option<Wrench> {
        let &Self { fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm, .. } = self;
        Some(Wrench([fx_n?, fy_n?, fz_n?, tx_nm?, ty_nm?, tz_nm?].map(|value| value.0)))
    }
}

/// The believed pose of the part at one time, and the measurements then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExecutedState {
    /// Time since the plan was started (s).
    pub time: f64,
    /// Believed pose and twist.
    pub believed: State,
    /// Force (N) and torque (Nm) at the tool point as measured by the robot, along the axes of its base.
    pub wrench: Option<Wrench>,
}

/// The part of a log in which the plan was executed.
#[derive(Debug, Clone)]
pub struct PlayedRows {
    /// One state per row, at least one; their times increase.
    pub course: Vec<ExecutedState>,
    /// Whether the log ends with the rest at the end of the plan.
    pub rested: bool,
}

/// The line above the columns, JSON after a `#`; `None` if the file begins otherwise.
///
/// # Errors
/// With the column, when the line cannot be read or is of another format.
pub fn read_log_header<T: DeserializeOwned>(file: &Path) -> Result<Option<T>, PlannerError> {
    let text = read_text(file)?;
    let Some(json) = text.lines().next().and_then(|first| first.strip_prefix('#')) else { return Ok(None) };
    let unreadable = |error: serde_json::Error| {
        // The `#` is the first column.
        let problem = format!(
            "column {}: the session in the first line cannot be read: {error}; do not change this line",
            error.column() + 1
        );
        PlannerError::line(file, 1, problem)
    };
    let Version { format } = serde_json::from_str(json).map_err(unreadable)?;
    if format != FORMAT {
        let problem =
            format!("format {format}, this program reads {FORMAT}: export the plan again, and repeat the run");
        return Err(PlannerError::line(file, 1, problem));
    }
    serde_json::from_str(json).map(Some).map_err(unreadable)
}

/// The rows of a log since the plan was started; `None` if it was not.
///
/// # Errors
/// With line and column, when a row is wrong or times do not increase.
pub fn read_played_rows(file: &Path) -> Result<Option<PlayedRows>, PlannerError> {
    let (states, measured) = (read_csv::<StateRow>(file)?, read_csv::<MeasuredRow>(file)?);
    let Some(begin) = measured.iter().position(|row| row.phase == PLAYING) else { return Ok(None) };
    let above = 1 + read_text(file)?.lines().take_while(|line| line.starts_with('#')).count();
    let wrong = |index: usize, problem: &str| Err(PlannerError::line(file, index + 1 + above, problem));
    let mut course: Vec<ExecutedState> = Vec::new();
    // The time of the rest phase restarts.
    let (mut phase, mut begun) = (PLAYING, 0.0);
    for (index, (state, row)) in states.iter().zip(&measured).enumerate().skip(begin) {
        let before = course.last().map(|state| state.time);
        if row.phase != phase {
            if row.phase != RESTING {
                return wrong(index, "column phase: the plan is followed by `resting` only; do not join logs");
            }
            (phase, begun) = (RESTING, before.unwrap_or(0.0));
        }
        if let Some(problem) = state.problem(NORM) {
            return wrong(index, problem);
        }
        let time = begun + state.time();
        if before.is_some_and(|before| time < before) || time < 0.0 {
            return wrong(index, "column time_s: times must increase; keep the rows as the player wrote them");
        }
        course.push(ExecutedState { time, believed: state.state(), wrench: row.wrench() });
    }
    Ok(Some(PlayedRows { course, rested: phase == RESTING }))
}
