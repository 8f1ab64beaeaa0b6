//! Files that replace what steers the search for robust plans.

use std::path::Path;

use plan::{PlannerError, RobustParameters};
use scene::Source;

use crate::atomic::read_text;

/// Reads parameters from a TOML file; those that it does not name keep their defaults.
///
/// # Errors
/// When it cannot be read, or with the place of what is wrong.
pub fn read_robust_parameters(file: &Path) -> Result<RobustParameters, PlannerError> {
    let text = read_text(file)?;
    toml::from_str(&text)
        .map_err(|error| Source { file, text: &text }.error(error.span().unwrap_or_default(), error.message()).into())
}
