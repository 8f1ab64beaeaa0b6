//! Settings of the homotopy (Sec. ocp:homotopy) and of Ipopt.

/// How the complementarity conditions are relaxed (Sec. diffphys:dsctime).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Complementarity {
    /// Scholtes' relaxation `a lambda <= sigma`.
    Relaxation,
    /// Scholtes' smoothing `a lambda = sigma`.
    Smoothing,
}

/// Second derivatives that Ipopt uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HessianKind {
    /// Exact Hessian of the Lagrangian.
    Exact,
    /// Gauss-Newton Hessian of the cost; constraints are treated as linear.
    GaussNewton,
    /// Ipopt's limited-memory BFGS.
    LimitedMemory,
}

/// Solver of the linear systems in Ipopt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearSolver {
    /// The built-in solver, which exploits the stage structure of the problem.
    Stage,
    /// MUMPS, which comes with Ipopt.
    Mumps,
    /// MA27 of the HSL library.
    Ma27,
    /// MA57 of the HSL library.
    Ma57,
    /// MA97 of the HSL library.
    Ma97,
}

impl LinearSolver {
    /// All solvers, the default first.
    pub const ALL: [Self; 5] = [Self::Stage, Self::Mumps, Self::Ma27, Self::Ma57, Self::Ma97];

    /// Name in files and flags. Ipopt uses the same names, except for the built-in solver.
    pub fn name(self) -> &'static str {
        match self {
            Self::Stage => "stage",
            Self::Mumps => "mumps",
            Self::Ma27 => "ma27",
            Self::Ma57 => "ma57",
            Self::Ma97 => "ma97",
        }
    }

    /// The solver with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|solver| solver.name() == name)
    }
}

impl std::fmt::Display for LinearSolver {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        formatter.write_str(self.name())
    }
}

/// An Ipopt option.
#[derive(Debug, Clone, PartialEq)]
pub struct IpoptOption {
    /// Name in Ipopt.
    pub name: String,
    /// Value.
    pub value: IpoptValue,
}

/// Value of an Ipopt option.
#[derive(Debug, Clone, PartialEq)]
pub enum IpoptValue {
    /// An integer. Options that take a real number accept it too.
    Integer(i32),
    /// A real number.
    Number(f64),
    /// A string.
    Text(String),
}

/// Homotopy parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct HomotopySettings {
    /// Number of homotopy steps `n_hom`, at least.
    pub iterations: usize,
    /// Largest number of further homotopy steps, as long as they make contact harder.
    pub further_iterations: usize,
    /// Number of first homotopy steps with half of the time steps and merged pieces.
    pub coarse_iterations: usize,
    /// Smoothing of the distances in the first iteration, `tau_1` (N m, the barrier parameter of Eq. KKTsystem).
    pub tau: f64,
    /// Relaxation of complementarity in the first iteration, `sigma_1` (N m at 50 N/m: see
    /// [`Impedance::force_unit`](crate::Impedance::force_unit)).
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
    /// Solver of the linear systems.
    pub linear_solver: LinearSolver,
    /// Ipopt options, in the order in which they are set.
    pub ipopt: Vec<IpoptOption>,
}

/// The smoothing of one homotopy step.
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
    /// Largest number of homotopy steps.
    pub fn most_iterations(&self) -> usize {
        self.iterations + self.further_iterations
    }

    /// Number of homotopy steps with half of the time steps and merged pieces; the last regular one always has all.
    pub fn coarse_iterations(&self) -> usize {
        self.coarse_iterations.min(self.iterations - 1)
    }

    /// Smoothing of every iteration there may be: `tau_n = kappa_tau^(n-1) tau_1`, and so on.
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
        .take(self.most_iterations())
    }
}
