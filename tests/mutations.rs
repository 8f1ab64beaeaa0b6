//! Mutated files: whatever stands in a scene, a homotopy, a plan, a batch or unfinished work, reading and using it ends
//! soon, without a panic, and what is accepted has finite numbers.

#[path = "mutations/text.rs"]
mod text;

use std::cell::Cell;
use std::path::Path;
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use crate::support::small::SMALL;
use crate::support::{Dir, WATCHDOG, sealed};
use planner::batch::{CellState, Manifest, collect};
use planner::check::{explain, pair_reports};
use planner::files::{PlanFolder, PlanResult, RolloutRow, StoredPlan, hash, to_csv};
use planner::{
    Choices, Event, Execution, GraspErrors, Motion, OffsetSource, PlannerError, Problem, Region, RobustnessTarget,
    Session, SimulationRequest, SuccessTable, refine, simulate, solve,
};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use text::{Mutation, mutated, mutation};

/// A scene, its plan in `plan`, a batch of two cells, one of them finished, in `runs`, and unfinished work in `work`.
static RIGHT: LazyLock<Dir> = LazyLock::new(|| {
    let dir = Dir::new();
    dir.write("scene.toml", SMALL);
    dir.add_homotopy("homotopy.toml", "iterations = 2\ntau = 0.0025\nsigma = 0.00125", "tol = 1e-2\nmax_iter = 50");
    dir.run("solve scene.toml --out plan").code(0);
    dir.run("batch expand scene.toml --starts all --out runs").code(0);
    dir.run("batch run runs --index 0").code(0);
    dir.run("batch collect runs").code(0);
    add_models(&dir);
    add_log(&dir);
    unfinished_work(&dir);
    dir
});

/// Adds scenes whose body is a model, one for each kind of model: `sdf.toml` and so on.
fn add_models(dir: &Dir) {
    let inertial = "<inertial><mass value=\"0.2\"/></inertial>";
    let shape = "<geometry><box size=\"0.1 0.08 0.06\"/></geometry>";
    let sdf = "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><pose>0 0 0 0 0 0.1</pose><collision name=\"c\">\
               <pose>0 0 0.01 0 0 0</pose><geometry><box><size>0.1 0.08 0.06</size></box></geometry></collision>\
               <collision name=\"d\"><geometry><cylinder><radius>0.03</radius><length>0.02</length></cylinder></geometry>\
               </collision></link></model></sdf>";
    let urdf = format!(
        "<robot name=\"r\"><link name=\"l\">{inertial}<collision><origin xyz=\"0 0 0.01\" rpy=\"0 0 0\"/>{shape}</collision>\
         <collision><geometry><cylinder radius=\"0.03\" length=\"0.02\"/></geometry></collision></link></robot>"
    );
    let mjcf = "<mujoco><compiler angle=\"radian\"/><worldbody><body name=\"b\" pos=\"0 0 0.1\"><geom type=\"box\" size=\"0.05 \
                0.04 0.03\" pos=\"0 0 0.01\"/><geom type=\"cylinder\" fromto=\"0 0 0 0 0 0.02\" size=\"0.02\"/></body></worldbody>\
                </mujoco>";
    for (kind, text) in [("sdf", sdf), ("urdf", &urdf), ("xml", mjcf)] {
        dir.write(format!("model.{kind}"), text.replace("><", ">\n<"));
        let model = format!("model = \"model.{kind}\"\nfacets = 8");
        let scene = SMALL
            .replacen("box = [0.1, 0.08, 0.06]", &model, 1)
            .replace("[contact]\npairs = [[\"box\", \"floor\"], [\"box\", \"wall\"]]\n", "");
        dir.write(format!("{kind}.toml"), scene);
        dir.run(&format!("check {kind}.toml --json")).code(0);
    }
}

/// Adds the log of a robot that was at every pose of the reference: `log.csv`.
fn add_log(dir: &Dir) {
    let reference = dir.read("plan/reference.csv");
    let (columns, rows) = reference.split_once('\n').unwrap();
    let rows: String = rows.lines().map(|row| format!("{row},1.5,playing\n")).collect();
    dir.write("log.csv", format!("{columns},fx_n,phase\n{rows}"));
    // It ends while the plan is played.
    dir.run("simulate plan --executed log.csv").code(1).says("the robot was stopped");
}

/// Leaves a checkpoint and a refinement in the working folder of `work`.
fn unfinished_work(dir: &Dir) {
    let problem = problem(dir.folder());
    let folder = PlanFolder::claim(&dir.path("work"), &[]).unwrap();
    let stopped = AtomicBool::new(false);
    let session = Session { folder: Some(&folder), ..Session::new(&|_: &Event| {}, &stopped) };
    refine(solve(&problem, &session).unwrap(), &hasty(), &session).unwrap();
}

fn problem(folder: &Path) -> Problem {
    Problem::load(&folder.join("scene.toml"), &Choices::default()).unwrap()
}

fn hasty() -> RobustnessTarget {
    RobustnessTarget { frictions: vec![0.0], time_limit: Duration::ZERO, ..RobustnessTarget::default() }
}

/// What is done with mutated files.
type Use = fn(&Path) -> Result<(), PlannerError>;

/// Mutates one of some files, uses it, and says how many of the mutated ones were accepted.
fn run(name: &str, files: &'static [&'static str], default_cases: u32, used: Use) {
    LazyLock::force(&RIGHT);
    let mut config = ProptestConfig { failure_persistence: None, max_shrink_iters: 200, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = default_cases;
    }
    let (cases, accepted) = (config.cases, Cell::new(0_u32));
    let strategy = (any::<usize>(), prop::collection::vec(mutation(), 1..4), any::<bool>());
    let result = TestRunner::new(config).run(&strategy, |(file, mutations, rehashes)| {
        let file = files[file % files.len()];
        let dir = Dir::new();
        dir.copy(RIGHT.folder().to_str().unwrap(), "");
        change(&dir, file, mutations);
        if rehashes {
            rehash(&dir);
            ["checkpoint.json", "refinement.json"].iter().for_each(|name| reseal(&dir, name));
        }
        let folder = dir.folder().to_owned();
        let outcome = in_time(move || used(&folder));
        if let Err(error) = &outcome {
            assert!(!error.to_string().is_empty() && error.to_string().len() < 20_000, "{error}");
            assert!(!matches!(error, PlannerError::Internal(_)), "{error}");
        }
        accepted.set(accepted.get() + u32::from(outcome.is_ok()));
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    assert!(accepted.get() > cases / 20, "{name}: only {} of {cases} mutated files are accepted", accepted.get());
}

/// Mutates a file; `*` in its name stands for the cell that is finished.
fn change(dir: &Dir, file: &str, mutations: Vec<Mutation>) {
    let cell = || {
        let cells = dir.path("runs/cells").read_dir().unwrap().map(|entry| entry.unwrap().path());
        let mut finished = cells.filter(|cell| cell.join("result.json").exists());
        finished.next().unwrap().file_name().unwrap().to_str().unwrap().to_owned()
    };
    let file = if file.contains('*') { file.replace('*', &cell()) } else { file.to_owned() };
    let text = mutated(&dir.read(&file), mutations);
    dir.write(&file, text);
}

/// Gives the plan the hashes of its files as they are, so that they are read.
fn rehash(dir: &Dir) {
    let Ok(mut result) = serde_json::from_str::<serde_json::Value>(&dir.read("plan/result.json")) else { return };
    let Some(files) = result.get_mut("files").and_then(|files| files.as_object_mut()) else { return };
    for (name, expected) in files {
        if let Ok(content) = std::fs::read(dir.path("plan").join(name)) {
            *expected = hash(&content).into();
        }
    }
    dir.write("plan/result.json", planner::files::sealed(result.to_string()));
}

/// Gives a record of unfinished work the hash of its content as it is, so that it is read.
fn reseal(dir: &Dir, name: &str) {
    let file = format!(".work.unfinished/{name}");
    let text = dir.read(&file);
    let record = text.split_once("\"record\":").and_then(|(_, record)| record.strip_suffix('}'));
    record.into_iter().for_each(|record| dir.write(&file, sealed(record)));
}

/// Runs something that must end in time. It may panic, which is the caller's panic then.
fn in_time<T: Send + 'static>(run: impl FnOnce() -> T + Send + 'static) -> T {
    let (sender, receiver) = mpsc::channel();
    let worker = thread::spawn(move || {
        let result = run();
        // Nobody listens after a time-out.
        let _ = sender.send(());
        result
    });
    let waited = receiver.recv_timeout(WATCHDOG);
    assert!(!matches!(waited, Err(mpsc::RecvTimeoutError::Timeout)), "has not ended after {WATCHDOG:?}");
    worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

#[track_caller]
fn require_finite(what: &str, values: impl IntoIterator<Item = f64>) {
    for value in values {
        assert!(value.is_finite(), "{what}: {value}");
    }
}

/// As `check` does.
fn check(folder: &Path) -> Result<(), PlannerError> {
    for homotopy in [None, Some(folder.join("homotopy.toml"))] {
        let problem = Problem::load(&folder.join("scene.toml"), &Choices { homotopy, ..Choices::default() })?;
        let explanation = explain(&problem, problem.homotopy().tau)?;
        require_finite("clearance", explanation.insertion.iter().map(|play| play.clearance_m));
        require_finite("rest", explanation.farthest_rest_m);
        require_finite("overlap", explanation.penetrations.iter().map(|overlap| overlap.distance_m));
        for pair in pair_reports(&problem, &problem.task().start, problem.homotopy().tau)? {
            require_finite("distances", [pair.smoothed_distance_m, pair.exact_distance_m]);
            require_finite("normal", pair.normal);
        }
    }
    Ok(())
}

/// As `simulate` does, with few and coarse rollouts.
fn play(folder: &Path) -> Result<(), PlannerError> {
    let request = SimulationRequest {
        errors: GraspErrors { offsets: OffsetSource::Random(1, Region::Covered), ..GraspErrors::default() },
        time_step: 0.05,
        settling_time: 0.1,
        ..SimulationRequest::default()
    };
    for plan in StoredPlan::find(&folder.join("plan"))? {
        require_finite_result(&plan.result);
        let PlanResult { start, delta_m, .. } = plan.result.clone();
        let choices = Choices { start: Some(start), offset_magnitude: Some(delta_m), ..Choices::default() };
        let problem = Problem::load(&folder.join("scene.toml"), &choices)?;
        plan.require_made_for(&problem)?;
        let mut motions: Vec<_> = (1..).map(Motion::HomotopyStep).zip(plan.iteration_references()?).collect();
        motions.push((Motion::Plan, plan.reference()?));
        let never = AtomicBool::new(false);
        let played = simulate(&problem, &motions, &request, &Session::new(&|_: &planner::Event| {}, &never))?;
        // The name of a temporary folder may contain "inf".
        let rows = played.iter().map(|rollout| RolloutRow::new(Path::new("plan"), &plan.result.start, rollout));
        let rows = to_csv(rows)?;
        for rollout in &played {
            let outcome = rollout.outcome;
            let numbers = [
                outcome.position_error,
                outcome.orientation_error,
                outcome.max_penetration,
                outcome.loads.contact_force,
            ];
            require_finite(&format!("{rollout:?}"), numbers);
        }
        let table = format!("{}{}", SuccessTable::new(&played), String::from_utf8(rows).unwrap());
        assert!(!table.contains("NaN") && !table.contains("inf"), "{table}");
    }
    Ok(())
}

/// Of a plan that is called good, everything must be a number. Null is read as infinite.
fn require_finite_result(result: &PlanResult) {
    if !(result.done || result.planned) {
        return;
    }
    require_finite("result", [result.objective, result.delta_m, result.wall_s, result.time_step_s]);
    for scenario in &result.scenarios {
        require_finite("scenario", [scenario.position_error_m, scenario.orientation_error_rad, scenario.max_force_n]);
    }
}

/// As `check` does with scenes of models.
fn look_at_models(folder: &Path) -> Result<(), PlannerError> {
    for kind in ["sdf", "urdf", "xml"] {
        let problem = Problem::load(&folder.join(format!("{kind}.toml")), &Choices::default())?;
        for pair in pair_reports(&problem, &problem.task().start, problem.homotopy().tau)? {
            require_finite("distances", [pair.smoothed_distance_m, pair.exact_distance_m]);
        }
    }
    Ok(())
}

/// As `simulate --executed` does.
fn compare_log(folder: &Path) -> Result<(), PlannerError> {
    let (problem, plan) = (problem(folder), StoredPlan::open(&folder.join("plan"))?);
    let settings = [SimulationRequest::default().settings(0.0)];
    let said = Execution::read(&folder.join("log.csv"), &problem, &plan, &settings)?.sentences().join("\n");
    assert!(!said.contains("NaN") && !said.contains(" inf"), "{said}");
    Ok(())
}

/// As `batch status` and `batch collect` do.
fn look_at_batch(folder: &Path) -> Result<(), PlannerError> {
    let manifest = Manifest::load(&folder.join("runs"))?;
    for cell in &manifest.cells {
        let state = CellState::of(&manifest, cell);
        assert!(!cell.label().contains("NaN") && !state.word().is_empty());
        if let CellState::Finished(result) = &state {
            require_finite_result(result);
        }
    }
    collect(&manifest)?;
    let table = std::fs::read_to_string(folder.join("runs/cells.csv")).unwrap();
    let cells = table.lines().skip(1).flat_map(|line| line.split(','));
    assert!(cells.into_iter().all(|cell| !["NaN", "inf", "-inf"].contains(&cell)), "{table}");
    Ok(())
}

/// As `solve --resume --robust` does.
fn go_on(folder: &Path) -> Result<(), PlannerError> {
    let problem = problem(folder);
    let work = PlanFolder::claim(&folder.join("work"), &[])?;
    let stopped = AtomicBool::new(false);
    let session = Session { folder: Some(&work), ..Session::new(&|_: &Event| {}, &stopped) };
    let plan = refine(solve(&problem, &session)?, &hasty(), &session)?;
    require_finite_result(&work.finish(&plan)?);
    StoredPlan::open(&folder.join("work")).map(drop)
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn a_mutated_scene_or_homotopy_is_explained_or_refused() {
    run("scenes and homotopies", &["scene.toml", "homotopy.toml"], 150, check);
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn a_mutated_model_is_a_part_or_refused() {
    run("models", &["model.sdf", "model.urdf", "model.xml"], 150, look_at_models);
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn a_mutated_log_of_a_robot_is_compared_or_refused() {
    run("logs", &["log.csv"], 100, compare_log);
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn a_mutated_plan_is_played_or_refused() {
    const FILES: &[&str] =
        &["plan/result.json", "plan/reference.csv", "plan/stages/1/reference.csv", "plan/resolved.toml", "scene.toml"];
    run("plans", FILES, 150, play);
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn a_mutated_batch_is_looked_at_or_refused() {
    const FILES: &[&str] = &["runs/manifest.jsonl", "runs/cells/*/result.json", "runs/cells.csv"];
    run("batches", FILES, 150, look_at_batch);
}

#[test]
#[ignore = "slow, hundreds of mutants: scripts/test and CI run it"]
fn mutated_unfinished_work_is_gone_on_with_or_set_aside() {
    const FILES: &[&str] = &[
        ".work.unfinished/checkpoint.json",
        ".work.unfinished/refinement.json",
        ".work.unfinished/refinement.json",
        ".work.unfinished/stages/1/scenarios.csv",
    ];
    run("unfinished work", FILES, 20, go_on);
}
