//! Statistics of a solver.

/// The reason why a matrix went to the general solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FallbackReason {
    /// An entry couples rows that should be independent.
    Structure,
    /// A pivot was too small for its sign to be trusted.
    UncertainPivot,
    /// A pivot was not finite.
    NotFinite,
    /// The residual stayed large after refinement.
    Residual,
    /// More accuracy was requested.
    Quality,
}

/// Numbers of matrices that went to the general solver, by reason.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Fallbacks {
    /// See [`FallbackReason::Structure`].
    pub structure: usize,
    /// See [`FallbackReason::UncertainPivot`].
    pub uncertain_pivot: usize,
    /// See [`FallbackReason::NotFinite`].
    pub not_finite: usize,
    /// See [`FallbackReason::Residual`].
    pub residual: usize,
    /// See [`FallbackReason::Quality`].
    pub quality: usize,
}

impl Fallbacks {
    /// Their sum.
    pub fn total(&self) -> usize {
        self.structure + self.uncertain_pivot + self.not_finite + self.residual + self.quality
    }

    pub(crate) fn count(&mut self, reason: FallbackReason) {
        *match reason {
            FallbackReason::Structure => &mut self.structure,
            FallbackReason::UncertainPivot => &mut self.uncertain_pivot,
            FallbackReason::NotFinite => &mut self.not_finite,
            FallbackReason::Residual => &mut self.residual,
            FallbackReason::Quality => &mut self.quality,
        } += 1;
    }
}

/// Statistics of a solver since its creation.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Report {
    /// Number of matrices.
    pub factorisations: usize,
    /// Matrices that were factorised with the poses of all stages eliminated first.
    pub fast_path: usize,
    /// Matrices with a stage that was factorised as one dense front.
    pub general_path: usize,
    /// Factorisations that stopped at a surplus of negative pivots.
    pub early_exits: usize,
    /// Matrices that went to the general solver.
    pub fallbacks: Fallbacks,
    /// Number of right-hand sides.
    pub solves: usize,
    /// Number of steps of iterative refinement.
    pub refinements: usize,
    /// Largest backward error that was accepted, component by component.
    pub largest_residual: f64,
    /// Largest sum of the absolute values of the terms of a pivot, relative to the largest entry of its matrix.
    pub element_growth: f64,
    /// Wall seconds in factorisations.
    pub factorisation_seconds: f64,
    /// Wall seconds in solves.
    pub solve_seconds: f64,
}
