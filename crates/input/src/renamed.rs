//! Names that users write and that have changed. The old ones are read for one version more, with a warning.

/// A flag, or a key with its table, by its former and its present name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Renamed {
    /// The former name.
    pub old: &'static str,
    /// The present name.
    pub new: &'static str,
}

/// Flags of the program whose former names version 0.2 reads.
pub const FLAGS: &[Renamed] = &[
    Renamed { old: "--turn", new: "--rotation-error" },
    Renamed { old: "--wanted-rate", new: "--target-rate" },
    Renamed { old: "--patience", new: "--stall-limit" },
    Renamed { old: "--max-changes", new: "--max-perturbations" },
];

/// Keys of scenes whose former names version 0.2 reads.
pub const KEYS: &[Renamed] = &[
    Renamed { old: "robustness.turn", new: "robustness.rotation_error" },
    Renamed { old: "robustness.turn_axes", new: "robustness.rotation_axes" },
];

impl Renamed {
    /// The warning about the former name.
    pub fn warning(&self) -> String {
        let Self { old, new } = self;
        format!("`{old}` is now `{new}`: write the new name, the next version refuses the old one")
    }
}
