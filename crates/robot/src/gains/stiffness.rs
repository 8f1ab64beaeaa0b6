//! How stiff an arm may and has to be.

/// Requirements on the stiffness of translations (in N/m, m, N), or of rotations (in Nm/rad, rad, Nm).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// Wrench that joint friction can hold (N or Nm): [`crate::gains::FrictionWrench`].
    pub friction: f64,
    /// Target deadband (m or rad), positive.
    pub deadband: f64,
    /// Largest deadband where no smaller one is possible (m or rad), not smaller than the target.
    pub allowed: f64,
    /// Largest overshoot of the reference into contact (m or rad), not negative.
    pub press: f64,
    /// Target for the largest contact force (N or Nm); infinity without a limit.
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
        /// Smallest stiffness for the deadband.
        smallest: f64,
        /// Largest stiffness for the contact force.
        largest: f64,
    },
    /// Joint friction asks for more than the controller accepts.
    #[error(
        "the deadband needs a stiffness of {smallest:.2} or more, and the controller accepts {highest:.2} or less; allow a larger deadband"
    )]
    TooStiff {
        /// Smallest stiffness for the deadband.
        smallest: f64,
        /// Largest stiffness of the controller.
        highest: f64,
    },
    /// Contact forces ask for less than the controller accepts.
    #[error(
        "the contact force allows a stiffness of {largest:.2} or less, and the controller accepts {lowest:.2} or more; allow a larger force, or let the reference press less"
    )]
    TooSoft {
        /// Largest stiffness for the contact force.
        largest: f64,
        /// Smallest stiffness of the controller.
        lowest: f64,
    },
}

impl Demand {
    /// Smallest stiffness that keeps the allowed deadband: at rest `k e <= friction`, so `k >= friction / allowed`.
    pub fn smallest(&self) -> f64 {
        self.friction / self.allowed
    }

    /// Largest stiffness for the contact force: the spring alone pushes with `k press`, so `k <= load / press`.
    /// Infinity without overshoot. Impacts come on top.
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

    /// The stiffness for execution: that of similarity, or more where the target deadband requires it, within the other
    /// requirements.
    ///
    /// # Errors
    /// When there is none.
    pub fn stiffness(&self, similar: f64) -> Result<f64, Refusal> {
        let [smallest, largest] = self.stiffnesses()?;
        Ok(similar.max(self.friction / self.deadband).clamp(smallest, largest))
    }
}
