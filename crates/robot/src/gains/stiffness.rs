//! How stiff an arm may and has to be.

/// What the stiffness of translations (in N/m, m, N), or of rotations (in Nm/rad, rad, Nm), has to satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// What joint friction holds (N or Nm): [`crate::gains::FrictionWrench`].
    pub friction: f64,
    /// Largest deadband that is wanted (m or rad), positive.
    pub deadband: f64,
    /// Largest deadband where no smaller one is possible (m or rad), not smaller than the wanted one.
    pub allowed: f64,
    /// How far the reference presses beyond contact (m or rad), not negative.
    pub press: f64,
    /// Largest contact force that is wanted (N or Nm); infinity without a limit.
    pub load: f64,
    /// Lowest and highest stiffness that the controller accepts (N/m or Nm/rad).
    pub range: [f64; 2],
}

/// Why no stiffness satisfies all demands. Stiffnesses are in N/m for translations and in Nm/rad for rotations.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// Joint friction asks for more than contact forces allow.
    #[error(
        "the deadband needs a stiffness of {smallest:.2} or more, and the contact force allows {largest:.2} or less; allow a larger deadband or force, or let the reference press less"
    )]
    Force {
        /// That keeps the deadband.
        smallest: f64,
        /// That keeps the contact force.
        largest: f64,
    },
    /// Joint friction asks for more than the controller accepts.
    #[error(
        "the deadband needs a stiffness of {smallest:.2} or more, and the controller accepts {highest:.2} or less; allow a larger deadband"
    )]
    TooStiff {
        /// That keeps the deadband.
        smallest: f64,
        /// That the controller accepts.
        highest: f64,
    },
    /// Contact forces ask for less than the controller accepts.
    #[error(
        "the contact force allows a stiffness of {largest:.2} or less, and the controller accepts {lowest:.2} or more; allow a larger force, or let the reference press less"
    )]
    TooSoft {
        /// That keeps the contact force.
        largest: f64,
        /// That the controller accepts.
        lowest: f64,
    },
}

impl Demand {
    /// Smallest stiffness that keeps the allowed deadband: at rest `k e <= friction`, so `k >= friction / allowed`.
    pub fn smallest(&self) -> f64 {
        self.friction / self.allowed
    }

    /// Largest stiffness that keeps the contact force: the spring alone presses with `k press`, so `k <= load / press`.
    /// Infinity if nothing is pressed. Impacts come on top.
    pub fn largest(&self) -> f64 {
        if self.press > 0.0 { self.load / self.press } else { f64::INFINITY }
    }

    /// Smallest and largest stiffness that satisfy all demands.
    ///
    /// # Errors
    /// When there is none.
    pub fn stiffnesses(&self) -> Result<[f64; 2], Refusal> {
        let (smallest, largest, [lowest, highest]) = (self.smallest(), self.largest(), self.range);
        if smallest > largest {
            Err(Refusal::Force { smallest, largest })
        } else if smallest > highest {
            Err(Refusal::TooStiff { smallest, highest })
        } else if largest < lowest {
            Err(Refusal::TooSoft { largest, lowest })
        } else {
            Ok([smallest.max(lowest), largest.min(highest)])
        }
    }

    /// The stiffness for execution: that of similarity, or more where the wanted deadband asks for it, within what the other
    /// demands allow.
    ///
    /// # Errors
    /// When there is none.
    pub fn stiffness(&self, similar: f64) -> Result<f64, Refusal> {
        let [smallest, largest] = self.stiffnesses()?;
        Ok(similar.max(self.friction / self.deadband).clamp(smallest, largest))
    }
}
