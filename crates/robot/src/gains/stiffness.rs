//! How stiff an arm may and has to be.

/// What the stiffness of translations (in N/m, m, N), or of rotations (in Nm/rad, rad, Nm), has to satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// What joint friction holds (N or Nm): [`crate::gains::FrictionWrench`].
    pub friction: f64,
    /// Largest deadband that is wanted (m or rad), positive.
    pub deadband: f64,
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
    /// No one factor suits translations and rotations.
    #[error(
        "translations need gains of {:.2} to {:.2} times the plan's, rotations of {:.2} to {:.2} times; plan with another ratio of rotational to translational stiffness", translations[0], translations[1], rotations[0], rotations[1]
    )]
    Proportion {
        /// Smallest and largest factor for translations.
        translations: [f64; 2],
        /// Smallest and largest factor for rotations.
        rotations: [f64; 2],
    },
}

impl Demand {
    /// Smallest stiffness that keeps the deadband: at rest `k e <= friction`, so `k >= friction / deadband`.
    pub fn smallest(&self) -> f64 {
        self.friction / self.deadband
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
}

/// The factor for all gains of a plan that is nearest to that of similarity ([`crate::gains::Similarity::factor`]) and
/// satisfies the demands on translation and rotation, for a plan with a translational (N/m) and a rotational stiffness
/// (Nm/rad).
///
/// # Errors
/// When there is none.
pub fn execution_factor(
    similarity: f64,
    translational_stiffness: f64,
    rotational_stiffness: f64,
    translation: &Demand,
    rotation: &Demand,
) -> Result<f64, Refusal> {
    let translations = translation.stiffnesses()?.map(|stiffness| stiffness / translational_stiffness);
    let rotations = rotation.stiffnesses()?.map(|stiffness| stiffness / rotational_stiffness);
    let (smallest, largest) = (translations[0].max(rotations[0]), translations[1].min(rotations[1]));
    if smallest > largest {
        return Err(Refusal::Proportion { translations, rotations });
    }
    Ok(similarity.clamp(smallest, largest))
}
