//! Wrong homotopy files.

use super::Edit;

const FILE: &str = "homotopy.toml";

#[rustfmt::skip]
pub const ROWS: &[(Edit, &str)] = &[
    ((FILE, "", "x"), "homotopy.toml:1:"),
    ((FILE, "[homotopy]", "[homotpy]"), "did you mean `homotopy`?"),
    ((FILE, "[homotopy]", "[body]"), "homotopy.toml:1:"),
    ((FILE, "iterations = 1", "iterations = 0"), "homotopy.toml:2:14: homotopy.iterations = 0: must lie"),
    ((FILE, "iterations = 1", "iterations = 101"), "must lie"),
    ((FILE, "iterations = 1", "iterations = 1.5"), "iterations"),
    ((FILE, "iterations = 1", "iteration = 1"), "did you mean `iterations`?"),
    ((FILE, "tau = 0.0025", "tau = 0"), "homotopy.toml:3:7: homotopy.tau = 0: must lie"),
    ((FILE, "tau = 0.0025", "tau = 1e-300"), "must lie"),
    ((FILE, "tau = 0.0025", "tau = inf"), "must lie"),
    ((FILE, "tau = 0.0025", "sigma = -1"), "must lie"),
    ((FILE, "tau = 0.0025", "mu_init = nan"), "must lie"),
    ((FILE, "tau = 0.0025", "mu_rate = 2"), "mu_rate"),
    ((FILE, "tau = 0.0025", "sigma_rate = 0"), "sigma_rate"),
    ((FILE, "tau = 0.0025", "complementarity = \"smooth\""), "did you mean `smoothing`?"),
    ((FILE, "tau = 0.0025", "hessian = \"exakt\""), "did you mean `exact`?"),
    ((FILE, "tau = 0.0025", "linear_solver = \"ma99\""), "unknown value `ma99`"),
    ((FILE, "tol = 1e-2", "tol = nan"), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "tol = -1"), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "tol = true"), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "toll = 1"), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "mu_strategy = \"adaptiv\""), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "mu_init = 1"), "homotopy.toml:5:"),
    ((FILE, "tol = 1e-2", "hessian_approximation = \"limited-memory\""), "homotopy.toml:5:"),
    ((FILE, "max_iter = 3000", "max_iter = 99999999999"), "homotopy.toml:6:"),
    ((FILE, "max_iter = 3000", "print_user_options = \"maybe\""), "homotopy.toml:6:"),
];
