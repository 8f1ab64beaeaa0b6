//! What may be off.

use serde::{Deserialize, Serialize};

/// An error, or a property of the parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Quantity {
    /// How far the part is off in the gripper, in the directions that the scene covers (m).
    Offset,
    /// How far it is rotated in the gripper, about any axis (rad).
    Rotation,
    /// How far the environment is off across the insertion (m).
    Hole,
    /// Coulomb's coefficient of friction.
    Friction,
    /// Clearance between the parts at the goal from side to side where it is tightest (m).
    Clearance,
    /// Width of a chamfer of 45 degrees at the mouth of the hole (m).
    Chamfer,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Offset, Self::Rotation, Self::Hole, Self::Friction, Self::Clearance, Self::Chamfer];

    /// Those that parts have, which a requirement can be met by.
    pub const OF_PARTS: [Self; 2] = [Self::Clearance, Self::Chamfer];

    /// The name in commands and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Offset => "offset",
            Self::Rotation => "rotation",
            Self::Hole => "hole",
            Self::Friction => "friction",
            Self::Clearance => "clearance",
            Self::Chamfer => "chamfer",
        }
    }

    /// The quantity of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// Whether small values are the hard ones.
    pub fn is_hard_when_small(self) -> bool {
        Self::OF_PARTS.contains(&self)
    }

    /// The unit in which people read it, and how many of these are one SI unit.
    pub fn unit(self) -> (&'static str, f64) {
        match self {
            Self::Offset | Self::Hole | Self::Clearance | Self::Chamfer => ("mm", 1e3),
            Self::Rotation => ("mrad", 1e3),
            Self::Friction => ("", 1.0),
        }
    }

    /// A value with its unit, such as `1.25 mm`.
    pub fn in_words(self, value: f64) -> String {
        let (unit, scale) = self.unit();
        let digits = if self == Self::Clearance { 3 } else { 2 };
        format!("{:.digits$} {unit}", scale * value).trim_end().to_owned()
    }

    /// No larger value is tried.
    pub(crate) fn limit(self) -> f64 {
        match self {
            Self::Offset | Self::Hole => 0.2,
            Self::Rotation => 0.5,
            Self::Friction => 1.0,
            Self::Clearance | Self::Chamfer => 0.02,
        }
    }
}
