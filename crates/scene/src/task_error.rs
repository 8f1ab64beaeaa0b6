//! Why a scene has no task for what is asked.

use crate::limits::OutOfReach;
use crate::range::short;
use crate::words::listed;

/// Why there is no planning task for a start and an offset magnitude.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TaskError {
    /// No start has this name.
    #[error("{}", unknown_start(name, known, suggestion.as_deref()))]
    UnknownStart {
        /// The requested name.
        name: String,
        /// Names of all starts.
        known: Vec<String>,
        /// The nearest of them, if one is near.
        suggestion: Option<String>,
    },
    /// The offset magnitude is outside the range of `robustness.offset_magnitude`.
    #[error("{}", offset_magnitude(*value, *most))]
    OffsetMagnitude {
        /// The requested magnitude (m).
        value: f64,
        /// The largest one possible (m).
        most: f64,
    },
    /// With this offset magnitude the goal cannot be reached within the limits.
    #[error("with an offset magnitude of {magnitude} m, {reason}")]
    OutOfReach {
        /// The requested magnitude (m).
        magnitude: f64,
        /// The limit that is too small.
        reason: Box<OutOfReach>,
    },
}

fn unknown_start(name: &str, known: &[String], suggestion: Option<&str>) -> String {
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let hint = suggestion.map_or(String::new(), |nearest| format!("; did you mean `{nearest}`?"));
    format!("there is no start `{name}`; the scene has {}{hint}", listed(&known))
}

fn offset_magnitude(value: f64, most: f64) -> String {
    let words = if !value.is_finite() {
        "be a finite number".to_owned()
    } else if value < 0.0 {
        "not be negative".to_owned()
    } else {
        format!("be at most {most} m")
    };
    format!("the offset magnitude must {words}, got {}", short(value))
}
