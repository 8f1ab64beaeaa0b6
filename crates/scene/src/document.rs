//! Homotopies as they are deserialised, with the places of the values that are checked later.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

/// What a scene file says about its homotopy.
#[derive(Debug, Deserialize)]
pub struct SceneDocument {
    /// Name of a homotopy file, or its table.
    pub homotopy: Option<Spanned<toml::Value>>,
    pub ipopt: Option<Spanned<IpoptDocument>>,
}

/// A homotopy file, or the same two tables in a scene.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HomotopyFileDocument {
    #[serde(default)]
    pub homotopy: HomotopyDocument,
    #[serde(default)]
    pub ipopt: IpoptDocument,
}

/// Ipopt's options by their own names.
pub type IpoptDocument = BTreeMap<Spanned<String>, Spanned<toml::Value>>;

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HomotopyDocument {
    pub iterations: Option<Spanned<i64>>,
    pub tau: Option<Spanned<f64>>,
    pub sigma: Option<Spanned<f64>>,
    pub mu_init: Option<Spanned<f64>>,
    pub tau_rate: Option<Spanned<f64>>,
    pub sigma_rate: Option<Spanned<f64>>,
    pub mu_rate: Option<Spanned<f64>>,
    pub complementarity: Option<Spanned<String>>,
    pub hessian: Option<Spanned<String>>,
    pub linear_solver: Option<Spanned<String>>,
}
