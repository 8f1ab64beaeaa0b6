//! What the user can say: a file per command.

mod batch;
mod calibrate;
mod check;
mod export;
mod generate;
mod help;
mod new;
mod printed;
mod report;
mod simulate;
mod solve;
mod task;
mod tolerance;

use clap::{Parser, Subcommand};

pub use batch::{BatchArguments, BatchCommand, MatrixArguments, SubmitArguments};
pub use calibrate::CalibrateArguments;
pub use check::CheckArguments;
pub use export::ExportArguments;
pub use generate::GenerateArguments;
pub use help::{CLOSINGS, Closing, command_line};
pub use new::NewArguments;
pub use printed::{CompletionsArguments, ManualArguments, SchemaArguments};
pub use report::ReportArguments;
pub use simulate::SimulateArguments;
pub use solve::SolveArguments;
pub use task::ToleranceArguments;
pub use tolerance::ToleranceCommandArguments;

/// Plans motions of a robot that insert a part which may sit several millimetres off in the gripper.
///
/// A scene file (TOML, lengths in metres, quaternions w x y z) names the shapes of the part and its environment, start and
/// goal poses, the robot's stiffness and the size of the offset. The plan is one reference trajectory, which a Cartesian
/// impedance controller tracks; it brings the part to its goal with every modelled offset.
#[derive(Debug, Parser)]
#[command(name = "assembly-plan", version, propagate_version = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Plan one motion and write its files
    Solve(SolveArguments),
    /// Plan every start and offset magnitude of some scenes, here or on a cluster
    Batch(BatchArguments),
    /// Test plans: play them with offsets, hard contacts and friction, and count successes
    Simulate(SimulateArguments),
    /// Measure which errors a plan tolerates: offset, rotation, position of the hole, friction, clearance
    Tolerance(ToleranceCommandArguments),
    /// Write an HTML page that shows a plan, a batch or a simulation
    Report(ReportArguments),
    /// Export a plan for a robot or simulator: motion, gains, limits, player
    Export(ExportArguments),
    /// Fit the robot of a scene to logs of executed plans
    Calibrate(CalibrateArguments),
    /// Check and explain a scene without solving it
    Check(CheckArguments),
    /// Write a commented scene that solves as it is, from two meshes if given
    New(NewArguments),
    /// Write the scene of a peg and its hole: random, round, rectangular or keyed
    Generate(GenerateArguments),
    /// Print a JSON schema of scene files, for editors
    Schema(SchemaArguments),
    /// Print a script that completes the command line in a shell
    Completions(CompletionsArguments),
    /// Write the manual pages
    Man(ManualArguments),
}
