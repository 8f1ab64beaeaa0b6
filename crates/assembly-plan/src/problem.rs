//! A planning problem after defaults and flags.

use std::path::Path;

use scene::{Scene, StartPose, TaskError, resolved};
use sha2::{Digest, Sha256};
use task::{AssemblyTask, HomotopySettings, LinearSolver};

use crate::failure::Failure;

/// One start and one offset magnitude of a scene, with the homotopy that solves it.
pub struct Problem<'scene> {
    /// The scene.
    pub scene: &'scene Scene,
    /// Start pose.
    pub start: &'scene StartPose,
    /// Offset magnitude `delta-hat` (m).
    pub delta: f64,
    /// The optimal control problem.
    pub task: AssemblyTask,
    /// Its homotopy.
    pub homotopy: HomotopySettings,
    /// `resolved.toml`: everything that the plan depends on, shapes included.
    pub resolved: String,
    /// What makes two problems the same one: a hash (hexadecimal) of [`Self::resolved`] and of the program's version.
    /// Comments and file names do not change it, a mesh's content does.
    pub identity: String,
}

impl<'scene> Problem<'scene> {
    /// By default with the scene's first start and its offset magnitude (m).
    ///
    /// # Errors
    /// When the scene has no task for this start and magnitude.
    pub fn new(
        scene: &'scene Scene,
        start: Option<&str>,
        delta: Option<f64>,
        homotopy: HomotopySettings,
    ) -> Result<Self, TaskError> {
        let start = scene.start(start)?;
        let delta = delta.unwrap_or(scene.offset_magnitude);
        let task = scene.task(Some(&start.name), Some(delta))?;
        let resolved = resolved(scene, start, delta, &homotopy);
        let identity = identity(&resolved);
        Ok(Self { scene, start, delta, task, homotopy, resolved, identity })
    }
}

fn identity(resolved: &str) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let digest = Sha256::new().chain_update(version).chain_update("\n").chain_update(resolved).finalize();
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The homotopy of a file, else of the scene, else the built-in one; `linear_solver` replaces its own.
pub fn homotopy(scene: &Scene, file: Option<&Path>, linear_solver: Option<&str>) -> Result<HomotopySettings, Failure> {
    let mut homotopy = match file {
        Some(file) => scene::load_homotopy(file)?,
        None => scene.homotopy.clone().unwrap_or_else(scene::default_homotopy),
    };
    if let Some(name) = linear_solver {
        homotopy.linear_solver = LinearSolver::from_name(name).expect("clap knows the names");
    }
    Ok(homotopy)
}
