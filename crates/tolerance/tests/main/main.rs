//! Boundaries that are known exactly, work that is resumed, and scenes with another clearance or a chamfer.

mod boundaries;
mod chamfer;
mod clearance;
mod resuming;

use std::path::Path;

use plan::Problem;
use scene::{Scene, Source};

/// The problem of a scene's text.
fn problem(text: &str) -> Problem {
    let scene = Scene::parse(Source { file: Path::new("scene.toml"), text }).unwrap();
    Problem::new(scene, None, None, scene::default_homotopy()).unwrap()
}

/// A box of a size (m) that is moved down by 50 mm, with an offset of up to 4 mm on a disc, and some parts around it.
fn moved_down(size: [f64; 3], parts: &str) -> Problem {
    problem(&format!(
        "[body]\nmass = 1.0\ninertia = [0.1, 0.1, 0.1]\n[[body.part]]\nname = \"box\"\nbox = {size:?}\n{parts}\n\
         [[start]]\nname = \"1\"\nposition = [0.0, 0.0, 0.05]\norientation = [1.0, 0.0, 0.0, 0.0]\n\
         [goal]\nposition = [0.0, 0.0, 0.0]\norientation = [1.0, 0.0, 0.0, 0.0]\nposition_tolerance = 0.003\nangle_tolerance = 0.08\n\
         [impedance]\ntranslational_stiffness = 500.0\nrotational_stiffness = 16.0\n\
         [robustness]\noffset_magnitude = 0.002\ncoverage = \"disc\"\n[horizon]\nsteps = 50\ntime_step = 0.04\n"
    ))
}

/// Walls of a slot along x, 20 mm wide.
const SLOT: &str = "\
[[environment.part]]\nname = \"left\"\nbox = [0.1, 0.02, 0.04]\nposition = [0.0, 0.02, 0.0]\n\
[[environment.part]]\nname = \"right\"\nbox = [0.1, 0.02, 0.04]\nposition = [0.0, -0.02, 0.0]\n";
