//! What the user can say about a batch.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use planner::batch::{Matrix, Starts};
use task::LinearSolver;

use crate::exit::CommandError;
use crate::progress::ProgressArguments;
use crate::values;

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct BatchArguments {
    #[command(subcommand)]
    pub step: Option<BatchCommand>,
    #[command(flatten)]
    pub matrix: MatrixArguments,
    /// How many cells are solved at once, each by one thread [default: the number of cores]
    #[arg(short, long, value_name = "N", value_parser = values::jobs)]
    pub jobs: Option<u16>,
    /// Also write report.html, a page that shows all cells, and one into the folder of each finished cell
    #[arg(long)]
    pub report: bool,
    #[command(flatten)]
    pub progress: ProgressArguments,
}

#[derive(Debug, Subcommand)]
pub enum BatchCommand {
    /// Write the manifest: one line per cell, never changed afterwards
    Expand(MatrixArguments),
    /// Solve the cells of a manifest that are not finished
    Run(RunArguments),
    /// Count the cells that are planned, running, failed or to do, with the reasons of failures
    Status(FolderArguments),
    /// Write cells.csv and cells.json: convergence, iterations, times, errors, penetration and force of every cell
    Collect(FolderArguments),
    /// Write a job array for a cluster
    Submit(SubmitArguments),
}

/// What is combined with what.
#[derive(Debug, Clone, Args)]
pub struct MatrixArguments {
    /// Scene files (TOML)
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// File (TOML) with `scenes`, `starts`, `deltas`, `homotopies` and `linear_solver`, instead of the flags
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scenes", "starts", "deltas", "homotopies", "linear_solver"])]
    pub matrix: Option<PathBuf>,
    /// Names of start poses, or `all` [default: each scene's first]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub starts: Vec<String>,
    /// Offset magnitudes delta-hat in metres [default: each scene's]
    #[arg(long, value_name = "M,M,...", value_delimiter = ',')]
    pub deltas: Vec<f64>,
    /// Homotopy files (TOML) [default: each scene's own, else the built-in one]
    #[arg(long, value_name = "FILES", value_delimiter = ',')]
    pub homotopies: Vec<PathBuf>,
    /// Linear solver of all cells [default: the homotopy's]
    #[arg(long, value_name = "NAME", value_parser = values::linear_solver())]
    pub linear_solver: Option<LinearSolver>,
    /// Folder of the batch [default: runs/NAME, after the matrix or the first scene]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

impl MatrixArguments {
    /// The matrix of the flags, or of the file that they name.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn matrix(&self) -> Result<Matrix, CommandError> {
        if let Some(file) = &self.matrix {
            return Ok(Matrix::load(file)?);
        }
        let mut matrix = Matrix::of_scenes(self.scenes.clone());
        matrix.starts = Starts::new(self.starts.clone());
        matrix.deltas.clone_from(&self.deltas);
        matrix.homotopies.clone_from(&self.homotopies);
        matrix.linear_solver = self.linear_solver;
        Ok(matrix)
    }

    /// Folder of the batch.
    pub fn folder(&self) -> Result<PathBuf, CommandError> {
        if let Some(out) = &self.out {
            return Ok(out.clone());
        }
        let name = self.matrix.as_ref().or(self.scenes.first()).and_then(|file| file.file_stem());
        name.map(|name| Path::new("runs").join(name))
            .ok_or_else(|| CommandError::Usage("name scenes, or a matrix file with --matrix".to_owned()))
    }
}

#[derive(Debug, Args)]
pub struct FolderArguments {
    /// Folder of the batch
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

#[derive(Debug, Args)]
pub struct RunArguments {
    /// Folder of the batch
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Only the cells from this one, counted from 0 [default: HQ_TASK_ID or SLURM_ARRAY_TASK_ID, else all cells]
    #[arg(long, value_name = "K", value_parser = values::whole::<usize>(0..=values::BILLION))]
    pub index: Option<usize>,
    /// How many cells from --index
    #[arg(long, value_name = "C", value_parser = values::whole::<usize>(1..=values::BILLION))]
    pub count: Option<usize>,
    /// How many cells are solved at once, each by one thread [default: the number of cores]
    #[arg(short, long, value_name = "N", value_parser = values::jobs)]
    pub jobs: Option<u16>,
    #[command(flatten)]
    pub progress: ProgressArguments,
}

#[derive(Debug, Args)]
pub struct SubmitArguments {
    /// Folder of the batch
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// For Slurm: writes submit.sh
    #[arg(long, required = true)]
    pub slurm: bool,
    /// Submit it as well
    #[arg(long)]
    pub now: bool,
    /// Cells per task of the array, solved one after the other
    #[arg(long, value_name = "C", default_value = "1", value_parser = values::whole::<usize>(1..=values::BILLION))]
    pub count: usize,
    /// Options of sbatch, such as `-- --partition=long --time=2:00:00`
    #[arg(last = true, value_name = "SBATCH OPTIONS")]
    pub options: Vec<String>,
}
