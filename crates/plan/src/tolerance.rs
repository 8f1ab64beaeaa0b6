//! The position tolerance of scenes that state none.

use std::fmt;

use nalgebra::{DMatrix, Vector3};
use scene::Scene;
use task::{AssemblyTask, Coverage};

use crate::engagement::Engagement;

/// Largest chosen tolerance (m), also in sizes of the body, in distances of the start from the goal and in engagement
/// depths, and the smallest in resting errors. Where the resting error exceeds what the depth allows, the depth
/// decides: a body that is not engaged must not count as success.
const LARGEST: f64 = 3e-3;
const IN_SIZES: f64 = 0.1;
const IN_PATHS: f64 = 0.25;
const IN_DEPTHS: f64 = 0.25;
const IN_RESTS: f64 = 1.5;
/// Distance between start and goal that is rounding (m).
const NO_PATH: f64 = 1e-6;
/// Offsets in evaluations, in offsets of the scene.
const OFFSETS: f64 = 1.05;

/// A position tolerance (m) that was chosen, and why it is no larger or smaller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChosenTolerance {
    /// Tolerance in guided directions (m).
    guided: f64,
    reason: Reason,
    /// Offset that stays along free directions (m).
    free_offset: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Reason {
    Usual,
    BodySize(f64),
    Path(f64),
    Depth(f64),
    Rest(f64),
}

impl ChosenTolerance {
    /// From a task's size, engagement and clearance.
    pub fn new(scene: &Scene, task: &AssemblyTask, engagement: &Engagement) -> Self {
        let (size, path) = (scene.body_size(), (task.start.position() - task.goal.position()).norm());
        let of_depth = engagement.depth_m.map(|depth| (IN_DEPTHS * depth, Reason::Depth(depth)));
        let of_rest = engagement.rest_m.map(|rest| (IN_RESTS * rest, Reason::Rest(rest)));
        let smallest = |one: (f64, Reason), other: (f64, Reason)| if other.0 < one.0 { other } else { one };
        // A motion that only rotates has no path.
        let of_path = (path > NO_PATH).then_some((IN_PATHS * path, Reason::Path(path)));
        let usual = [(IN_SIZES * size, Reason::BodySize(size))];
        let usual = usual.into_iter().chain(of_path).chain(of_depth).fold((LARGEST, Reason::Usual), smallest);
        let of_rest = of_rest.map(|rest| of_depth.into_iter().fold(rest, smallest));
        let (guided, reason) = of_rest.filter(|rest| rest.0 > usual.0).unwrap_or(usual);
        Self { guided, reason, free_offset: OFFSETS * engagement.free_offset(task, &scene.coverage) }
    }

    /// The tolerance (m). It includes offsets along free directions, as no plan reduces these.
    pub fn position(&self) -> f64 {
        self.guided.hypot(self.free_offset)
    }
}

impl ChosenTolerance {
    /// Why it is what it is, in words.
    pub fn reason(&self) -> String {
        let reason = match self.reason {
            Reason::Usual => "the usual one".to_owned(),
            Reason::BodySize(size) => format!("a tenth of the body's size of {:.2} mm", 1e3 * size),
            Reason::Path(path) => format!("a quarter of the path of {:.2} mm from start to goal", 1e3 * path),
            Reason::Depth(depth) => format!("a quarter of the engagement depth of {:.2} mm", 1e3 * depth),
            Reason::Rest(rest) => format!("1.5 times the error of {:.3} mm that clearance allows", 1e3 * rest),
        };
        if self.free_offset == 0.0 {
            return reason;
        }
        let [guided, free] = [self.guided, self.free_offset].map(|length| 1e3 * length);
        format!("{guided:.3} mm in guided directions ({reason}), and offsets of up to {free:.3} mm stay in free ones")
    }
}

impl fmt::Display for ChosenTolerance {
    /// As a key with its value and the reason.
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "goal.position_tolerance = {:.3} mm ({})", 1e3 * self.position(), self.reason())
    }
}

impl Engagement {
    /// Longest part of the covered offsets along free directions (m).
    pub fn free_offset(&self, task: &AssemblyTask, coverage: &Coverage) -> f64 {
        let rotation = task.goal.orientation();
        let along_free = |offset: Vector3<f64>| -> Vec<f64> {
            self.free.iter().map(|axis| (rotation * offset).dot(&Vector3::from(*axis))).collect()
        };
        let planned = || task.offsets().into_iter().map(Vector3::from);
        let span: Vec<f64> = coverage.span().into_iter().flat_map(along_free).collect();
        if span.is_empty() {
            let length = |along: Vec<f64>| along.iter().map(|part| part * part).sum::<f64>().sqrt();
            return planned().map(along_free).map(length).fold(0.0, f64::max);
        }
        // The extent of a disc or a ball along them is its radius times the largest singular value of their projection.
        let radius = planned().map(|offset| offset.norm()).fold(0.0, f64::max);
        radius * DMatrix::from_vec(self.free.len(), span.len() / self.free.len(), span).singular_values().max()
    }
}
