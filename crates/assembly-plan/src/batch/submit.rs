//! A batch as a job array of Slurm.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::arguments::SubmitArguments;
use super::manifest::Manifest;
use crate::DONE;
use crate::console::say;
use crate::failure::Failure;
use crate::output::write_file;

/// Writes `submit.sh` and, if asked to, submits it.
///
/// # Errors
/// When the script cannot be written, or Slurm refuses it.
pub fn submit(manifest: &Manifest, arguments: &SubmitArguments) -> Result<u8, Failure> {
    let folder = manifest.folder.canonicalize().map_err(|error| Failure::io(&manifest.folder, &error))?;
    let logs = folder.join("slurm");
    fs::create_dir_all(&logs).map_err(|error| Failure::io(&logs, &error))?;
    let file = manifest.folder.join("submit.sh");
    let tasks = manifest.cells.len().div_ceil(arguments.count.get());
    write_file(&file, script(&folder, tasks, arguments)?.as_bytes())?;
    if !arguments.now {
        say!("{} written; sbatch {0} submits its {tasks} tasks", file.display());
        return Ok(DONE);
    }
    let status = Command::new("sbatch")
        .arg(&file)
        .status()
        .map_err(|error| Failure::Internal(format!("sbatch cannot be started: {error}")))?;
    if status.success() { Ok(DONE) } else { Err(Failure::Internal(format!("sbatch {}: {status}", file.display()))) }
}

/// A task finds its cells by its number. It replaces the shell, so that it hears Slurm's request to terminate.
fn script(folder: &Path, tasks: usize, arguments: &SubmitArguments) -> Result<String, Failure> {
    let program = std::env::current_exe().map_err(|error| Failure::Internal(error.to_string()))?;
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let options: String = arguments.options.iter().map(|option| format!("#SBATCH {option}\n")).collect();
    Ok(format!(
        "#!/bin/sh\n\
         #SBATCH --job-name=\"{name}\"\n\
         #SBATCH --array=0-{last}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task=1\n\
         #SBATCH --output=\"{folder}/slurm/%A_%a.txt\"\n\
         {options}\
         exec {program} batch run {quoted} --index $((SLURM_ARRAY_TASK_ID * {count})) --count {count} --jobs 1\n",
        last = tasks.saturating_sub(1),
        folder = folder.display(),
        program = quote(&program),
        quoted = quote(folder),
        count = arguments.count,
    ))
}

/// A path as one word of a shell.
fn quote(path: &Path) -> String {
    format!("'{}'", path.display().to_string().replace('\'', r"'\''"))
}
