//! The TOML documents as they are written, with the places of what is checked later.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

/// A scene file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneDocument {
    pub title: Option<String>,
    /// Name of a homotopy file, or its table.
    pub homotopy: Option<Spanned<toml::Value>>,
    pub ipopt: Option<Spanned<IpoptDocument>>,
    pub body: Spanned<BodyDocument>,
    pub environment: Spanned<EnvironmentDocument>,
    pub contact: Option<ContactDocument>,
    pub start: Spanned<Vec<Spanned<StartDocument>>>,
    pub goal: Spanned<PoseDocument>,
    pub impedance: ImpedanceDocument,
    pub robustness: RobustnessDocument,
    pub horizon: HorizonDocument,
    #[serde(default)]
    pub cost: CostDocument,
    #[serde(default)]
    pub limits: LimitsDocument,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyDocument {
    pub mass: Option<Spanned<f64>>,
    pub inertia: Option<Spanned<InertiaDocument>>,
    #[serde(default)]
    pub part: Vec<Spanned<PartDocument>>,
}

/// Diagonal or full matrix (kg m^2).
#[derive(Debug, Deserialize)]
#[serde(untagged, expecting = "inertia must be 3 numbers or a 3x3 matrix")]
pub enum InertiaDocument {
    Diagonal([f64; 3]),
    Full([[f64; 3]; 3]),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EnvironmentDocument {
    #[serde(default)]
    pub part: Vec<Spanned<PartDocument>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartDocument {
    pub name: Spanned<String>,
    pub vertices: Option<Spanned<Vec<[f64; 3]>>>,
    #[serde(rename = "box")]
    pub edge_lengths: Option<Spanned<[f64; 3]>>,
    pub normals: Option<Spanned<Vec<[f64; 3]>>>,
    pub offsets: Option<Spanned<Vec<f64>>>,
    pub mesh: Option<Spanned<String>>,
    pub unit: Option<Spanned<String>>,
    pub position: Option<Spanned<[f64; 3]>>,
    pub orientation: Option<Spanned<[f64; 4]>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ContactDocument {
    pub pairs: Option<Vec<Spanned<[String; 2]>>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StartDocument {
    pub name: Spanned<String>,
    pub position: Spanned<[f64; 3]>,
    pub orientation: Spanned<[f64; 4]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoseDocument {
    pub position: Spanned<[f64; 3]>,
    pub orientation: Spanned<[f64; 4]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ImpedanceDocument {
    pub translational_stiffness: Spanned<f64>,
    pub rotational_stiffness: Spanned<f64>,
    pub translational_damping: Option<Spanned<f64>>,
    pub rotational_damping: Option<Spanned<[f64; 3]>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RobustnessDocument {
    pub offset_magnitude: Spanned<f64>,
    pub offset_directions: Spanned<Vec<Spanned<[f64; 3]>>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HorizonDocument {
    pub steps: Spanned<i64>,
    pub time_step: Spanned<f64>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CostDocument {
    pub reference: Option<WeightsDocument>,
    pub compliant: Option<WeightsDocument>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WeightsDocument {
    pub translational_velocity: Option<Spanned<f64>>,
    pub rotational_velocity: Option<Spanned<f64>>,
    pub terminal_position: Option<Spanned<f64>>,
    pub terminal_orientation: Option<Spanned<f64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LimitsDocument {
    pub translational_velocity: Option<Spanned<f64>>,
    pub rotational_velocity: Option<Spanned<f64>>,
    pub translational_acceleration: Option<Spanned<f64>>,
    pub rotational_acceleration: Option<Spanned<f64>>,
    pub contact_force: Option<Spanned<f64>>,
    pub force: Option<Spanned<f64>>,
    pub torque: Option<Spanned<f64>>,
}

/// A homotopy file, or the two tables of it within a scene.
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
