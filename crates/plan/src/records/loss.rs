//! Losses of a refined plan: the worst group of rollouts, and the contact that holds the body there.

use serde::{Deserialize, Serialize};
use simulation::{Disturbance, Injection};
use task::GraspError;
use task::algebra::norm;

use crate::or_null;
use crate::parameters::EvaluationParameters;
use crate::records::{GraspRecord, MotionEnd};
use crate::success_rates::SuccessRate;

/// The worst group of rollouts of a plan, with an example.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LossRecord {
    /// Success rate at the friction where it is smallest.
    pub rate: f64,
    /// The group of rollouts at that friction with the smallest success rate.
    pub worst: SuccessRate,
    /// Wilson's 95 % confidence interval of the success rate of that group.
    pub worst_interval: [f64; 2],
    /// Axes of the body along which failing offsets at that friction lie; null where they have none in common.
    pub offset_direction: Option<String>,
    /// Grasp error of the failing rollout at that friction that ends farthest from the goal.
    #[serde(flatten)]
    pub grasp: GraspRecord,
    /// Its relative error of the inertia.
    pub inertia_error: f64,
    /// Its relative error of the stiffness.
    pub stiffness_error: f64,
    /// Its delay of an arm's controller.
    pub delay_s: f64,
    /// Its bias of the sensor (N, Nm).
    #[serde(default)]
    pub bias: [f64; 6],
    /// Its radius of edges.
    pub edge_radius_m: f64,
    /// Its largest contact force.
    #[serde(with = "or_null")]
    pub max_force_n: f64,
    /// Part of `limits.contact_force` that rollouts may use; version 0.1 does not state it and used this default.
    #[serde(default = "contact_force_share")]
    pub contact_force_share: f64,
    /// Whether that is exceeded.
    pub exceeds_contact_force: bool,
    /// How it ends.
    pub end: MotionEnd,
}

fn contact_force_share() -> f64 {
    EvaluationParameters::default().force_share
}

impl LossRecord {
    /// Two sentences without full stops: what is lost most, and how a rollout ends.
    pub fn sentences(&self) -> [String; 2] {
        let SuccessRate { friction, rollouts, successes, .. } = self.worst;
        let common = self.offset_direction.as_ref();
        let common =
            common.map_or_else(String::new, |axes| format!("; failing offsets lie towards {axes} of the body"));
        let most = format!(
            "most is lost at friction {friction}, where {:.1} % succeed, and there with {}, \
             {successes} of {rollouts} (95 % confidence: {:.0} to {:.0} %){common}",
            100.0 * self.rate,
            self.worst.offsets_in_words(),
            100.0 * self.worst_interval[0],
            100.0 * self.worst_interval[1]
        );
        let force = match self.exceeds_contact_force {
            true => format!(
                "; pushes with {:.1} N, more than {:.0} % of limits.contact_force",
                self.max_force_n,
                100.0 * self.contact_force_share
            ),
            false => String::new(),
        };
        let injected = [vec![self.grasp.to_string()], self.disturbance_in_words()].concat().join(", ");
        [most, format!("with the {injected}, the body {}{force}", self.end)]
    }

    /// The errors of that rollout.
    pub fn injection(&self) -> Injection {
        let Self {
            inertia_error: inertia,
            stiffness_error: stiffness,
            delay_s: delay,
            bias,
            edge_radius_m: edge_radius,
            ..
        } = *self;
        Injection {
            grasp: GraspError::from(&self.grasp),
            disturbance: Disturbance { inertia, stiffness, delay, bias, edge_radius, ..Disturbance::default() },
        }
    }

    /// Disturbance of robot, controller and edges, such as `+10 % of inertia`; empty without one.
    pub fn disturbance_in_words(&self) -> Vec<String> {
        [
            (self.inertia_error, format!("{:+.0} % of inertia", 100.0 * self.inertia_error)),
            (self.stiffness_error, format!("{:+.0} % of stiffness", 100.0 * self.stiffness_error)),
            (self.delay_s, format!("{:.1} ms of delay", 1e3 * self.delay_s)),
            (norm(&self.bias[..3]), format!("{:.1} N of bias", norm(&self.bias[..3]))),
            (norm(&self.bias[3..]), format!("{:.2} Nm of bias", norm(&self.bias[3..]))),
            (self.edge_radius_m, format!("{:.3} mm of radius of edges", 1e3 * self.edge_radius_m)),
        ]
        .into_iter()
        .filter_map(|(size, words)| (size != 0.0).then_some(words))
        .collect()
    }
}
