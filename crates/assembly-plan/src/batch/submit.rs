//! A batch as a job array of Slurm.

use std::fs;
use std::path::Path;
use std::process::Command;

use planner::PlannerError;
use planner::batch::Manifest;
use planner::files::{read_text, write_file};

use super::process::in_system;
use crate::arguments::SubmitArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};
use crate::program::Program;
use crate::shell::word;

/// Tells a script of ours from another one.
const MARK: &str = "# Written by `assembly-plan batch submit`.";

/// Writes `submit.sh` and, if asked to, submits it.
///
/// # Errors
/// When the script cannot be written, or Slurm refuses it.
pub fn submit(manifest: &Manifest, arguments: &SubmitArguments) -> Result<Exit, CommandError> {
    let folder = manifest.folder.canonicalize().map_err(in_system(&manifest.folder))?;
    require_plain(&folder, &arguments.options)?;
    let file = manifest.folder.join("submit.sh");
    if file.exists() && !read_text(&file).is_ok_and(|text| text.contains(MARK)) {
        let problem = "was not written by `batch submit` and would be replaced; move it away";
        return Err(PlannerError::file(&file, problem).into());
    }
    let tasks = manifest.cells.len().div_ceil(arguments.count);
    let logs = folder.join("slurm");
    fs::create_dir_all(&logs).map_err(in_system(&logs))?;
    write_file(&file, script(&folder, tasks, arguments)?.as_bytes())?;
    if !arguments.now {
        say!("{} written; sbatch {} submits its {tasks} tasks", file.display(), word(&file));
        return Ok(Exit::Done);
    }
    let status = Command::new("sbatch")
        .arg(&file)
        .status()
        .map_err(|error| CommandError::System(format!("sbatch cannot be started: {error}")))?;
    match status.success() {
        true => Ok(Exit::Done),
        false => Err(CommandError::System(format!("sbatch {}: {status}", file.display()))),
    }
}

/// A task finds its cells by its number. It replaces the shell, so that it gets Slurm's request to terminate.
fn script(folder: &Path, tasks: usize, arguments: &SubmitArguments) -> Result<String, CommandError> {
    let program: Vec<String> = Program::words().iter().map(|part| word(Path::new(part))).collect();
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let options: String = arguments.options.iter().map(|option| format!("#SBATCH {option}\n")).collect();
    Ok(format!(
        "#!/bin/sh\n\
         {MARK}\n\
         #SBATCH --job-name=\"{name}\"\n\
         #SBATCH --array=0-{last}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task=1\n\
         #SBATCH --output=\"{folder}/slurm/%A_%a.txt\"\n\
         {options}\
         exec {program} batch run {quoted} --index $((SLURM_ARRAY_TASK_ID * {count})) --count {count} --jobs 1\n",
        last = tasks.saturating_sub(1),
        folder = folder.display().to_string().replace('%', "%%"),
        program = program.join(" "),
        quoted = word(folder),
        count = arguments.count,
    ))
}

/// Refuses names that a comment of the script cannot hold: they would end it, and the rest would be run.
fn require_plain(folder: &Path, options: &[String]) -> Result<(), CommandError> {
    let Some(name) = folder.to_str() else {
        return Err(CommandError::Usage(format!(
            "{}: the name is not UTF-8 text; rename the folder",
            folder.display()
        )));
    };
    if name.chars().any(|letter| letter.is_control() || letter == '"' || letter == '\\') {
        let problem = "the name has a quotation mark, a backslash or a line break, which Slurm cannot take";
        return Err(CommandError::Usage(format!("{name:?}: {problem}; rename the folder")));
    }
    match options.iter().find(|option| option.chars().any(char::is_control) || !option.starts_with('-')) {
        Some(option) => Err(CommandError::Usage(format!("{option:?}: no option of sbatch, such as --time=1:00:00"))),
        None => Ok(()),
    }
}
