//! How the optimal cost of a plan changes with what was measured.

use std::fmt;

use nalgebra::Vector3;
use ocp::{Formulation, Transcription};
use plan::Plan;
use task::{AssemblyTask, Pose};

use crate::explain::{End, end};

/// Change of a parameter (m, rad) from which slopes are taken, both ways.
const STEP: f64 = 1e-6;

/// Something that was measured: one component of a grasp error, of the start pose or of the goal pose. Positions are in the world
/// frame, offsets and all rotations in the body frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameter {
    /// What it belongs to.
    pub of: Measured,
    /// Component: 0 to 2 of the position or offset (m), 3 to 5 of the rotation vector (rad).
    pub component: usize,
}

/// What a parameter belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measured {
    /// The offset of a planned grasp error, by its index.
    Offset(usize),
    /// The start pose.
    Start,
    /// The goal pose; the environment stays.
    Goal,
}

impl fmt::Display for Parameter {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let component = ["x", "y", "z", "rotation x", "rotation y", "rotation z"][self.component];
        match self.of {
            Measured::Offset(index) => write!(formatter, "offset {} {component}", index + 1),
            Measured::Start => write!(formatter, "start {component}"),
            Measured::Goal => write!(formatter, "goal {component}"),
        }
    }
}

impl Parameter {
    /// All of a task.
    fn all(task: &AssemblyTask) -> Vec<Self> {
        let components = |of, count| (0..count).map(move |component| Self { of, component });
        let offsets = (0..task.grasps.len()).flat_map(|index| components(Measured::Offset(index), 3));
        offsets.chain(components(Measured::Start, 6)).chain(components(Measured::Goal, 6)).collect()
    }

    /// A task in which it is larger.
    fn changed(&self, task: &AssemblyTask, by: f64) -> AssemblyTask {
        let mut task = task.clone();
        let moved = |pose: &Pose| {
            let mut change = [Vector3::zeros(); 2];
            change[self.component / 3][self.component % 3] = by;
            Pose::from(&task::pose::moved(&pose.isometry(), &change[0], &change[1]))
        };
        match self.of {
            Measured::Offset(index) => task.grasps[index].offset[self.component] += by,
            Measured::Start => task.start = moved(&task.start),
            Measured::Goal => task.goal = moved(&task.goal),
        }
        task
    }
}

/// The derivative of the optimal cost of the chosen homotopy step by each parameter, to first order (envelope theorem), where
/// the solver ended. `None` where that point is not known any more, or a distance has no value there.
pub fn sensitivities(plan: &Plan) -> Option<Vec<(Parameter, f64)>> {
    let End { task, transcription, point, .. } = end(plan)?;
    let (settings, record) = (&plan.variant.settings, &plan.chosen().record);
    let at = |task: &AssemblyTask| {
        let contacts = transcription.layout().contacts().clone();
        let formulation = Formulation::new(task, settings.complementarity).with_contacts(contacts);
        let mut changed = Transcription::of(formulation, settings.complementarity, settings.hessian);
        changed.set_smoothing(record.tau, record.sigma);
        changed.lagrangian(&point).ok()
    };
    let slope = |parameter: Parameter| {
        let [more, less] = [STEP, -STEP].map(|by| at(&parameter.changed(&task, by)));
        Some((parameter, (more? - less?) / (2.0 * STEP)))
    };
    Parameter::all(&task).into_iter().map(slope).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_have_names_and_change_what_they_name() {
        let scene = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
        let task = scene::Scene::load(&scene).unwrap().task(None, None).unwrap();
        let all = Parameter::all(&task);
        assert_eq!(all.len(), 3 * task.grasps.len() + 12);
        let names: Vec<String> = all.iter().map(ToString::to_string).collect();
        assert_eq!((names[1].as_str(), names[names.len() - 1].as_str()), ("offset 1 y", "goal rotation z"));
        for parameter in all {
            let changed = parameter.changed(&task, 0.25);
            let offset: f64 = (0..task.grasps.len()).map(|index| changed.grasps[index].offset[1]).sum();
            let before: f64 = task.grasps.iter().map(|grasp| grasp.offset[1]).sum();
            let is_offset_y = matches!(parameter, Parameter { of: Measured::Offset(_), component: 1 });
            assert_eq!((offset - before).abs() > 0.2, is_offset_y, "{parameter}");
            let turned = changed.goal.error(&task.goal).orientation;
            let is_turned = parameter.of == Measured::Goal && parameter.component > 2;
            assert!((turned - if is_turned { 0.25 } else { 0.0 }).abs() < 1e-9, "{parameter}: {turned}");
        }
    }
}
