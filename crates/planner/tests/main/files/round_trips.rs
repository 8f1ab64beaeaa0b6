//! Every record is read back as it was written.

use std::sync::atomic::AtomicBool;

use planner::batch::{Manifest, Matrix, collect, expand};
use planner::files::batch::cells::{CellElement, CellRow};
use planner::files::trajectory::{read_reference, read_trajectory, write_trajectory};
use planner::files::{
    Checkpoint, Format, PlanResult, RolloutRow, SimulationRecord, StoredPlan, SuccessRow, read_csv,
    write_rollout_tables,
};
use planner::{Event, Motion, Session, SimulationRequest, SuccessTable, simulate};

use crate::files::support::{claim, plan, problem, scene};

#[test]
fn the_tables_of_a_motion_are_read_back_exactly() {
    let folder = tempfile::tempdir().unwrap();
    for iteration in &plan().iterations {
        write_trajectory(folder.path(), &iteration.trajectory, &plan().task).unwrap();
        let again = read_trajectory(folder.path(), &plan().task).unwrap();
        assert_eq!(again.reference, iteration.trajectory.reference);
        assert_eq!(again.scenarios, iteration.trajectory.scenarios);
        assert_eq!(again.reference_keeps, iteration.trajectory.reference_keeps);
    }
}

#[test]
fn a_plan_is_read_back_with_its_result() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let result = claim(&out).finish(plan()).unwrap();
    let stored = StoredPlan::open(&out).unwrap();
    assert_eq!(stored.result, result);
    assert!(stored.require_made_for(&problem(0.01)).unwrap());
    assert_eq!(stored.iteration_references().unwrap().len(), plan().iterations.len());
    let again: PlanResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(again, result);
}

#[test]
fn a_plan_fits_the_scene_that_it_writes() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    claim(&out).finish(plan()).unwrap();
    let stored = StoredPlan::open(&out).unwrap();
    let resolved = planner::Problem::load(&out.join("resolved.toml"), &planner::Choices::default()).unwrap();
    stored.require_made_for(&resolved).unwrap();
    assert!(!stored.require_made_for(&problem(0.02)).unwrap(), "another offset is another setting");
}

#[test]
fn a_checkpoint_is_read_back_exactly_and_only_for_its_own_problem() {
    let folder = tempfile::tempdir().unwrap();
    let keeper = claim(&folder.path().join("out"));
    let iterate = nlp::Iterate {
        x: vec![0.1, 1.0 / 3.0, -0.0],
        constraint_multipliers: vec![1e-300],
        lower_multipliers: vec![f64::MAX],
        upper_multipliers: vec![],
    };
    let records = plan().iterations.iter().map(|iteration| iteration.record.clone()).collect();
    let checkpoint = Checkpoint::new("identity", 0, records, &iterate);
    checkpoint.save(&keeper).unwrap();
    let again = Checkpoint::load(&keeper, "identity").unwrap().unwrap();
    assert_eq!(again, checkpoint);
    assert_eq!(again.iterate(), iterate);
    assert_eq!(Checkpoint::load(&keeper, "another"), Err(planner::Unusable::OtherProblem));
    let file = keeper.work().join("checkpoint.json");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replace("{\"format\":1,", "{\"format\":9,")).unwrap();
    assert_eq!(Checkpoint::load(&keeper, "identity"), Err(planner::Unusable::Newer));
    std::fs::write(&file, text.replace("{\"format\":1,", "{")).unwrap();
    assert_eq!(Checkpoint::load(&keeper, "identity"), Ok(Some(checkpoint)), "version 0.1 states no format");
}

#[test]
fn files_of_a_newer_format_are_refused_and_older_ones_read() {
    let result = serde_json::to_string(&PlanResult::new(plan(), [].into())).unwrap();
    let read = |format: &str| serde_json::from_str::<PlanResult>(&result.replace("\"format\":1,", format));
    assert_eq!(read("").unwrap().format, Format::default());
    let problem = read("\"format\":9,").unwrap_err().to_string();
    assert!(problem.contains("format 9 is that of a newer version") && problem.contains("up to 1"), "{problem}");
}

#[test]
fn manifest_and_cells_are_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut matrix = Matrix::of_scenes(vec![scene()]);
    matrix.deltas = vec![0.005, 0.01];
    let (cells, warnings) = expand(&matrix).unwrap();
    assert_eq!((cells.len(), warnings.len()), (2, 0));
    let manifest = Manifest::new(folder.path(), cells).unwrap();
    assert!(manifest.write().unwrap());
    assert!(!Manifest::new(folder.path(), expand(&matrix).unwrap().0).unwrap().write().unwrap(), "it stands already");
    let again = Manifest::load(folder.path()).unwrap();
    assert_eq!(again.cells, manifest.cells);

    claim(&folder.path().join(&manifest.cells[1].folder)).finish(plan()).unwrap();
    assert_eq!(collect(&manifest).unwrap().len(), 2);
    assert_eq!(collect(&manifest).unwrap().len(), 0, "nothing has changed");
    let rows: Vec<CellRow> = read_csv(&folder.path().join("cells.csv")).unwrap();
    assert_eq!(rows.iter().map(|row| row.state.as_str()).collect::<Vec<_>>(), ["to do", "planned"]);
    let json = std::fs::read_to_string(folder.path().join("cells.json")).unwrap();
    let elements: Vec<CellElement> = serde_json::from_str(&json).unwrap();
    assert_eq!(elements[1].result.as_ref().unwrap().scenarios.len(), plan().task.grasps.len());
    assert_eq!(elements[0].cell, manifest.cells[0]);

    for (name, mine) in [("cells.csv", "my,own,table\n"), ("cells.json", "[\n{\"mine\": 1}]")] {
        let file = folder.path().join(name);
        let ours = std::fs::read(&file).unwrap();
        std::fs::write(&file, mine).unwrap();
        assert!(collect(&manifest).unwrap_err().to_string().contains("is not a table of an earlier run"));
        assert_eq!(std::fs::read_to_string(&file).unwrap(), mine);
        std::fs::write(&file, ours).unwrap();
    }
}

#[test]
fn the_tables_of_a_simulation_are_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let motions = [(Motion::Plan, plan().reference())];
    let never = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &never);
    let rollouts = simulate(&problem(0.01), &motions, &SimulationRequest::default(), &session).unwrap();
    let rows: Vec<RolloutRow> = rollouts.iter().map(|rollout| RolloutRow::new(folder.path(), "1", rollout)).collect();
    let successes: Vec<SuccessRow> = SuccessTable::new(&rollouts).groups().iter().map(SuccessRow::from).collect();
    let record = SimulationRecord::new(&problem(0.01), vec!["plan".to_owned()], &SimulationRequest::default().errors);
    write_rollout_tables(folder.path(), &record, &rows, &successes).unwrap();
    let read = SimulationRecord::read(folder.path()).unwrap();
    assert_eq!(SimulationRecord { files: record.files.clone(), ..read.clone() }, record);
    assert_eq!(read.files.keys().collect::<Vec<_>>(), ["rollouts.csv", "success.csv"]);
    assert_eq!(read_csv::<RolloutRow>(&folder.path().join("rollouts.csv")).unwrap(), rows);
    assert_eq!(read_csv::<SuccessRow>(&folder.path().join("success.csv")).unwrap(), successes);
    // What a run leaves that is killed between two files is not taken for a simulation.
    write_rollout_tables(folder.path(), &record, &rows[1..], &successes).unwrap();
    let newer = std::fs::read(folder.path().join("rollouts.csv")).unwrap();
    write_rollout_tables(folder.path(), &record, &rows, &successes).unwrap();
    std::fs::write(folder.path().join("rollouts.csv"), newer).unwrap();
    let problem = SimulationRecord::read(folder.path()).unwrap_err().to_string();
    assert!(problem.contains("rollouts.csv: is not of the simulation that simulation.json is of"), "{problem}");
    std::fs::write(folder.path().join("success.csv"), "my,own,table\n").unwrap();
    assert!(write_rollout_tables(folder.path(), &record, &rows, &successes).is_err());
}

#[test]
fn a_reference_that_is_none_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("reference.csv");
    write_trajectory(folder.path(), &plan().trajectory, &plan().task).unwrap();
    let good = std::fs::read_to_string(&file).unwrap();
    let lines: Vec<&str> = good.lines().collect();
    let with_line = |line: usize, text: String| {
        let mut lines: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
        lines[line] = text;
        lines.join("\n")
    };
    let column = |line: usize, column: usize, value: &str| {
        let mut cells: Vec<&str> = lines[line].split(',').collect();
        cells[column] = value;
        with_line(line, cells.join(","))
    };
    for (text, words) in [
        (lines[..2].join("\n"), "at least two rows"),
        (column(3, 4, "5"), "reference.csv:4: qw, qx, qy, qz are not a unit quaternion"),
        (column(3, 1, "1e300"), "out of any reasonable range"),
        (column(3, 1, "nan"), "`nan` is not a finite number"),
        (column(3, 0, "7"), "equal steps"),
        (with_line(3, "1,2".to_owned()), "2 columns where the header has 14"),
        (with_line(0, "a,b".to_owned()), "columns"),
    ] {
        std::fs::write(&file, text).unwrap();
        let error = read_reference(&file).unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("reference.csv:"), "{error}");
    }
}
