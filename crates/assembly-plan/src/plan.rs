//! Plans as `solve` has written them.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use simulation::Reference;

use crate::failure::Failure;
use crate::output::STATE_COLUMNS;

/// A folder with a plan.
#[derive(Debug)]
pub struct Plan {
    pub folder: PathBuf,
    /// Name of the start pose.
    pub start: String,
    /// Offset magnitude delta-hat that the plan was made for (m).
    pub delta: f64,
    pub converged: bool,
}

/// What is needed of `result.json`.
#[derive(Deserialize)]
struct PlanFile {
    start: String,
    delta_m: f64,
    converged: bool,
}

const RESULT: &str = "result.json";
const STAGES: &str = "stages";

impl Plan {
    /// The plan in a folder, or all plans in folders below it, by name.
    pub fn find(folder: &Path) -> Result<Vec<Self>, Failure> {
        let mut plans = Vec::new();
        collect(folder, &mut plans)?;
        if plans.is_empty() {
            let advice = "`assembly-plan solve SCENE --out DIR` writes a plan";
            return Err(Failure::Input(format!("{}: no {RESULT} in it or below; {advice}", folder.display())));
        }
        Ok(plans)
    }

    fn load(folder: &Path) -> Result<Self, Failure> {
        let file = folder.join(RESULT);
        let text = read(&file)?;
        let PlanFile { start, delta_m: delta, converged } = serde_json::from_str(&text)
            .map_err(|error| Failure::Input(format!("{}: not a result of `solve`: {error}", file.display())))?;
        Ok(Self { folder: folder.to_owned(), start, delta, converged })
    }

    /// The reference motion.
    pub fn reference(&self) -> Result<Reference, Failure> {
        read_reference(&self.folder.join("reference.csv"))
    }

    /// The reference motion after every homotopy iteration.
    pub fn stage_references(&self) -> Result<Vec<Reference>, Failure> {
        let files = (1..).map(|stage: usize| self.folder.join(STAGES).join(stage.to_string()).join("reference.csv"));
        let references: Vec<_> =
            files.take_while(|file| file.exists()).map(|file| read_reference(&file)).collect::<Result<_, _>>()?;
        if references.is_empty() {
            let folder = self.folder.join(STAGES);
            return Err(Failure::Input(format!("{}: no homotopy iterations, leave out --stages", folder.display())));
        }
        Ok(references)
    }
}

fn collect(folder: &Path, plans: &mut Vec<Plan>) -> Result<(), Failure> {
    if folder.join(RESULT).exists() {
        plans.push(Plan::load(folder)?);
        return Ok(());
    }
    let unreadable = |error| Failure::Input(format!("{}: the folder cannot be read: {error}", folder.display()));
    let entries: Vec<_> = fs::read_dir(folder).and_then(Iterator::collect).map_err(unreadable)?;
    let mut folders: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).filter(|path| path.is_dir()).collect();
    folders.sort();
    folders.iter().try_for_each(|folder| collect(folder, plans))
}

fn read(file: &Path) -> Result<String, Failure> {
    fs::read_to_string(file).map_err(|error| Failure::Input(format!("{}: cannot be read: {error}", file.display())))
}

fn read_reference(file: &Path) -> Result<Reference, Failure> {
    let columns: Vec<&str> = std::iter::once("time_s").chain(STATE_COLUMNS).collect();
    let rows = read_numbers(file, &columns)?;
    let wrong = |line: usize, problem: &str| Err(Failure::Input(format!("{}:{line}: {problem}", file.display())));
    if rows.len() < 2 {
        return wrong(rows.len() + 1, "a reference has at least two rows");
    }
    let time_step = (rows[rows.len() - 1][0] - rows[0][0]) / (rows.len() - 1) as f64;
    let mut states = Vec::with_capacity(rows.len());
    for (index, row) in rows.iter().enumerate() {
        let state: [f64; 13] = std::array::from_fn(|column| row[column + 1]);
        if !(time_step > 0.0 && (row[0] - rows[0][0] - index as f64 * time_step).abs() < 1e-3 * time_step) {
            return wrong(index + 2, "times must increase in equal steps");
        }
        if state[3..7].iter().all(|&component| component == 0.0) {
            return wrong(index + 2, "the quaternion is zero");
        }
        states.push(state);
    }
    Ok(Reference::new(time_step, &states))
}

/// Numbers of the named columns of a CSV file, by row.
pub fn read_numbers(file: &Path, columns: &[&str]) -> Result<Vec<Vec<f64>>, Failure> {
    let text = read(file)?;
    let wrong = |line: usize, problem: String| Failure::Input(format!("{}:{line}: {problem}", file.display()));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| wrong(1, error.to_string()))?.clone();
    let position = |name: &&str| {
        let missing = || wrong(1, format!("there is no column `{name}`; needed are {}", columns.join(",")));
        header.iter().position(|column| column.trim() == *name).ok_or_else(missing)
    };
    let positions: Vec<usize> = columns.iter().map(position).collect::<Result<_, _>>()?;
    let mut rows = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let line = index + 2;
        let record = record.map_err(|error| wrong(line, error.to_string()))?;
        let number = |(name, &position): (&&str, &usize)| match record[position].trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(wrong(line, format!("column `{name}`: `{}` is not a finite number", &record[position]))),
        };
        rows.push(columns.iter().zip(&positions).map(number).collect::<Result<_, _>>()?);
    }
    Ok(rows)
}
