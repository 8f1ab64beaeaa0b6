//! Builds a scene in code and plans it, without a file: `cargo run -p planner --example scene_in_code`.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use planner::{Choices, Event, Plan, PlannerError, Problem, Session};
use scene::{Scene, Source};

fn main() -> Result<(), PlannerError> {
    for offset in [0.005, 0.01, 0.02] {
        let plan = plan(&scene([0.1, 0.08, 0.06], offset))?;
        println!("offsets of {:.0} mm: {}", 1e3 * offset, plan.status());
    }
    Ok(())
}

/// Text of a scene: a box of these edge lengths (m) is pushed against a wall, with offsets (m) along the push.
pub fn scene(edges: [f64; 3], offset: f64) -> String {
    let contact = 0.5 * edges[0];
    format!(
        r#"
        title = "box pushed against a wall"
        body.part = [{{ name = "box", box = {edges:?} }}]
        environment.part = [{{ name = "wall", box = [0.1, 0.6, 0.4], position = [-0.05, 0.0, 0.0] }}]
        start = [{{ name = "1", position = [{}, 0.0, 0.0], orientation = [1, 0, 0, 0] }}]
        goal = {{ position = [{}, 0.0, 0.0], orientation = [1, 0, 0, 0] }}
        impedance = {{ translational_stiffness = 50.0, rotational_stiffness = 5.0 }}
        robustness = {{ offset_magnitude = {offset}, offset_directions = [[1, 0, 0], [-1, 0, 0]] }}
        "#,
        contact + 0.05,
        contact + 0.001
    )
}

/// Plans the scene of a text. Errors name `scene.toml` and the line.
///
/// # Errors
/// When the text is not a valid scene.
pub fn plan(text: &str) -> Result<Plan, PlannerError> {
    let file = Path::new("scene.toml");
    let scene = Scene::parse(Source { file, text })?;
    let problem = Problem::choose(scene, file, &Choices::default())?;
    planner::solve(&problem, &Session::new(&|_: &Event| {}, &AtomicBool::new(false)))
}
