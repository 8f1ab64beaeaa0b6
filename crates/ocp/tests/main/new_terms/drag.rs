//! Viscous drag in every scenario, `f = -c nu`, which is added to the velocity dynamics; the term has no rows.

use autodiff::Tape;
use ocp::{Layout, Owners, Point, Points, Source, StepTerm, VELOCITY_DYNAMICS};
use task::{AssemblyTask, POSE};

pub struct ViscousDrag {
    /// `dt c / m`
    factor: f64,
}

impl ViscousDrag {
    /// With a coefficient `c` (Ns/m).
    pub fn new(task: &AssemblyTask, coefficient: f64) -> Self {
        Self { factor: task.horizon.time_step * coefficient / task.inertia.mass().unwrap() }
    }
}

impl StepTerm for ViscousDrag {
    fn points(&self) -> Points {
        Points::Stages(Owners::Scenarios)
    }

    fn tape(&self) -> Tape {
        Tape::record(3, |velocity| velocity.iter().map(|&component| component * self.factor).collect())
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        Source::Variable(layout.state(point.stage, point.owner) + POSE + input)
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(VELOCITY_DYNAMICS, point.stage, point.owner) + output
    }
}
