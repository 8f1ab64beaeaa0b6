//! Settings of the homotopy (Sec. ocp:homotopy) and of the solver underneath.

use nlp::Options;

/// How the complementarity conditions are relaxed (Sec. diffphys:dsctime).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Complementarity {
    /// Scholtes' relaxation `a lambda <= sigma`.
    Relaxation,
    /// Scholtes' smoothing `a lambda = sigma`.
    Smoothing,
}

/// Second derivatives that the solver gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HessianKind {
    /// Exact Hessian of the Lagrangian.
    Exact,
    /// Gauss-Newton Hessian of the cost; constraints count as linear.
    GaussNewton,
    /// Ipopt's limited-memory BFGS.
    LimitedMemory,
}

/// Homotopy parameters.
#[derive(Debug, Clone)]
pub struct HomotopySettings {
    /// Number of homotopy iterations `n_hom`.
    pub iterations: usize,
    /// Smoothing of the distances in the first iteration, `tau_1` (N m, the barrier parameter of Eq. KKTsystem).
    pub tau: f64,
    /// Relaxation of complementarity in the first iteration, `sigma_1` (N m).
    pub sigma: f64,
    /// Ipopt's initial barrier parameter in the first iteration, `mu_init_1`.
    pub mu_init: f64,
    /// `kappa_tau` in (0, 1).
    pub tau_rate: f64,
    /// `kappa_sigma` in (0, 1).
    pub sigma_rate: f64,
    /// `kappa_mu` in (0, 1].
    pub mu_rate: f64,
    /// Relaxation or smoothing.
    pub complementarity: Complementarity,
    /// Second derivatives.
    pub hessian: HessianKind,
    /// Linear solver by name.
    pub linear_solver: String,
    /// Ipopt's options by their own names.
    pub options: Options,
}

/// The smoothing of one homotopy iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smoothing {
    /// Smoothing of the distances.
    pub tau: f64,
    /// Relaxation of complementarity.
    pub sigma: f64,
    /// Ipopt's initial barrier parameter.
    pub mu_init: f64,
}

impl HomotopySettings {
    /// Smoothing of every iteration: `tau_n = kappa_tau^(n-1) tau_1`, and so on.
    pub fn schedule(&self) -> impl Iterator<Item = Smoothing> + use<> {
        let first = Smoothing { tau: self.tau, sigma: self.sigma, mu_init: self.mu_init };
        let (tau_rate, sigma_rate, mu_rate) = (self.tau_rate, self.sigma_rate, self.mu_rate);
        std::iter::successors(Some(first), move |last| {
            Some(Smoothing {
                tau: last.tau * tau_rate,
                sigma: last.sigma * sigma_rate,
                mu_init: last.mu_init * mu_rate,
            })
        })
        .take(self.iterations)
    }
}
