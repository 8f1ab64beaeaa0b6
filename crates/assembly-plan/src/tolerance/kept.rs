//! Files of finished boundaries, until all are finished.

use std::fs;
use std::path::{Path, PathBuf};

use planner::PlannerError;
use planner::files::{WorkFolder, read_text, remove_file};
use tolerance::{Question, TOLERANCE, Trials, Work};

use crate::progress::Progress;

/// Folder of the boundaries that runs with `--index` have measured, a file each.
const BOUNDARIES: &str = "boundaries";

/// The files.
pub struct Kept {
    /// What this run, or an interrupted one, has finished.
    pub own: PathBuf,
    /// The folder of those by runs with `--index`.
    others: PathBuf,
}

impl Kept {
    /// Of a measurement whose results go to a folder, with its folder of unfinished work.
    pub fn new(work: &WorkFolder, out: &Path) -> Self {
        Self { own: work.path().join(TOLERANCE), others: out.join(BOUNDARIES) }
    }

    /// Removes all; whether there was any.
    pub fn discard(&self) -> Result<bool, PlannerError> {
        let files = self.files()?;
        files.iter().try_for_each(|file| remove_file(file))?;
        if self.others.is_dir() {
            // What else is there is not ours.
            let _ = fs::remove_dir(&self.others);
        }
        Ok(!files.is_empty())
    }

    /// Work with all boundaries that are kept.
    pub fn begun<'store>(&self, mut work: Work<'store>, progress: &Progress) -> Result<Work<'store>, PlannerError> {
        for file in self.files()? {
            work = work.resumed(&read_text(&file)?).map_err(|error| {
                let advice =
                    "repeat the command that was interrupted, or leave out --resume to measure from the beginning";
                PlannerError::file(&file, format!("cannot be resumed: {error}; {advice}"))
            })?;
        }
        if work.count() > 0 {
            let noun = if work.count() == 1 { "boundary" } else { "boundaries" };
            progress.say(&format!("resuming after {} finished {noun} of an earlier run", work.count()));
        }
        Ok(work)
    }

    /// All files that are there.
    fn files(&self) -> Result<Vec<PathBuf>, PlannerError> {
        let mut files: Vec<PathBuf> = Vec::new();
        if self.own.symlink_metadata().is_ok() {
            files.push(self.own.clone());
        }
        if self.others.is_dir() {
            for entry in fs::read_dir(&self.others).map_err(PlannerError::read(&self.others))? {
                let path = entry.map_err(PlannerError::read(&self.others))?.path();
                let number = path.file_stem().and_then(|stem| stem.to_str()).map(str::parse::<usize>);
                if matches!(number, Some(Ok(_))) && path.extension().is_some_and(|extension| extension == "json") {
                    files.push(path);
                }
            }
        }
        files.sort();
        Ok(files)
    }
}

/// The file of one boundary, by its number, below the folder of results.
pub fn file_of(out: &Path, index: usize) -> PathBuf {
    out.join(BOUNDARIES).join(format!("{index}.json"))
}

/// Work with the boundary of a file, if that is there and of the same question; otherwise it is measured again.
pub fn resumed_if_usable<'store>(file: &Path, trials: &Trials, question: &Question) -> Work<'store> {
    let begun = || Work::new(trials, question);
    read_text(file).ok().and_then(|text| begun().resumed(&text).ok()).unwrap_or_else(begun)
}
