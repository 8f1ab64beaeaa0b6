//! The format of the files, by which readers recognise what they can read.

use serde::{Deserialize, Serialize};

/// Format of a file, its first key. One number covers all files; it is raised where a change would mislead older
/// readers. Formats after [`Format::CURRENT`] are refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(try_from = "u32", into = "u32")]
pub struct Format(u32);

impl Format {
    /// The format of this version. Files of version 0.1 do not state theirs, which is then 0, the default.
    pub const CURRENT: Self = Self(1);
}

impl TryFrom<u32> for Format {
    type Error = String;

    fn try_from(number: u32) -> Result<Self, String> {
        let Self(newest) = Self::CURRENT;
        match number <= newest {
            true => Ok(Self(number)),
            false => Err(format!(
                "format {number} is that of a newer version of assembly-plan; this one reads formats up to {newest}: use a \
                 newer version"
            )),
        }
    }
}

impl From<Format> for u32 {
    fn from(format: Format) -> Self {
        format.0
    }
}
