//! The number of threads of a solve decides about time only.

use std::path::Path;

use nlp::Control;
use ocp::Homotopy;
use task::HomotopySettings;

#[test]
fn threads_change_no_bit_of_a_homotopy() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    // More poses than one piece of work has.
    task.horizon.steps = 30;
    let settings = HomotopySettings { iterations: 1, ..scene::default_homotopy() };
    let run = |threads: usize| {
        let homotopy = Homotopy::new(&task, settings.clone()).with_threads(threads);
        // A part of a solve has all that a whole one has.
        let observe = |event: ocp::Event| if event.progress.iteration < 40 { Control::Continue } else { Control::Stop };
        let iteration = homotopy.run(observe, |_, _| Control::Continue).unwrap().remove(0);
        assert!(iteration.stage_solver.is_some_and(|report| report.early_exits > 0), "no wrong inertia");
        (iteration.iterate, iteration.objective, iteration.iterations)
    };
    let alone = run(1);
    for threads in [2, 3] {
        assert!(run(threads) == alone, "{threads} threads");
    }
}
