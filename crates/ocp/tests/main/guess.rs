//! Starting points.

use std::path::Path;

use ocp::{CONTACT_FORCE, Owners, Points, Transcription};
use task::{Complementarity, HessianKind};

#[test]
fn a_solve_may_begin_at_a_motion() {
    const TAU: f64 = 1e-3;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = 4;
    let transcription = Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact);
    let layout = transcription.layout();
    let mut x = transcription.formulation().initial_guess();
    // All coordinates of a state but 3 to 6, the quaternion, which a trajectory normalises.
    for (index, (stage, owner)) in layout.stages_of(Owners::All).enumerate() {
        for coordinate in [0, 1, 2, 7, 8, 9, 10, 11, 12] {
            x[layout.state(stage, owner) + coordinate] += 0.01 * (index * 10 + coordinate) as f64;
        }
    }
    for point in layout.points(Points::Pairs) {
        let forces = layout.variable(CONTACT_FORCE, point.stage, point.owner);
        x[forces + point.pair] += (point.stage + point.scenario() + point.pair) as f64;
    }
    let again = transcription.formulation().point_at(&transcription.formulation().motion(&x, TAU));
    let largest = x.iter().zip(&again).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
    assert!(largest < 1e-12, "{largest}");
}
