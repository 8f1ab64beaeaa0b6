//! Labels of the rows of a KKT matrix.

/// The trajectory that a row belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Owner {
    /// A scenario's compliant trajectory, numbered from 0.
    Scenario(usize),
    /// The reference trajectory.
    Reference,
}

/// Kind of variable, slack or multiplier.
///
/// Rows of a *front* are eliminated together, stage by stage. Rows of a *leaf* (one stage and owner) are eliminated
/// before the front. They must not be coupled with other leaves, and with no fronts but those of their own and the
/// previous stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Class {
    /// Front: coordinate of a pose (7 per state).
    Pose,
    /// Front: multiplier of the kinematics that define a pose (as many as coordinates).
    PoseMultiplier,
    /// Front: coordinate of a velocity.
    Velocity,
    /// Front: multiplier of the velocity dynamics.
    VelocityMultiplier,
    /// Front: any other variable of a stage.
    OtherVariable,
    /// Front: multiplier of any other equality constraint of a stage.
    OtherMultiplier,
    /// Leaf: contact force of a pair.
    ContactForce,
    /// Leaf: gap of a pair, if it is a variable.
    Gap,
    /// Leaf: multiplier of the equality that defines a gap variable.
    GapMultiplier,
    /// Leaf: multiplier of a complementarity product that is an equality (Scholtes' smoothing).
    ComplementarityMultiplier,
    /// Leaf: slack that Ipopt adds to an inequality constraint.
    InequalitySlack,
    /// Leaf: multiplier of an inequality constraint.
    InequalityMultiplier,
}

impl Class {
    /// Whether rows of this class are eliminated before the fronts.
    pub fn is_leaf(self) -> bool {
        matches!(
            self,
            Self::ContactForce
                | Self::Gap
                | Self::GapMultiplier
                | Self::ComplementarityMultiplier
                | Self::InequalitySlack
                | Self::InequalityMultiplier
        )
    }

    /// Whether rows of this class are multipliers of constraints. A matrix of the right inertia has as many negative
    /// eigenvalues as multipliers.
    pub fn is_multiplier(self) -> bool {
        matches!(
            self,
            Self::PoseMultiplier
                | Self::VelocityMultiplier
                | Self::OtherMultiplier
                | Self::GapMultiplier
                | Self::ComplementarityMultiplier
                | Self::InequalityMultiplier
        )
    }
}

/// Label of one row of a KKT matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Label {
    /// Stage, 1 to `N`. The constraints of the step from stage `k` to `k + 1` belong to stage `k + 1`.
    pub stage: usize,
    /// The trajectory that it belongs to.
    pub owner: Owner,
    /// Kind of variable or multiplier.
    pub class: Class,
    /// Component of a state, or number of a pair; rows of a leaf that belong to no pair are numbered after the pairs.
    /// Only the order matters, except that a pose and its multiplier have the same index.
    pub index: usize,
}

impl std::fmt::Display for Label {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{:?} {} of ", self.class, self.index)?;
        match self.owner {
            Owner::Reference => write!(formatter, "the reference")?,
            Owner::Scenario(number) => write!(formatter, "scenario {number}")?,
        }
        write!(formatter, " at stage {}", self.stage)
    }
}
