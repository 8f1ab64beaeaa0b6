//! The folder of an export. All files are made in a hidden folder beside it, under a lock; only a whole export is moved in, and an
//! interrupted move is finished by the next export into the folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use plan::{PlannerError, hash};
use store::{WorkFolder, read_bytes, read_text, remove_file, write_file};

/// Hashes of all files of an export, as `sha256sum --check` reads them. It is moved out first and in last: where it stands, the
/// export is whole.
pub const SUMS: &str = "SHA256SUMS";
/// The sums of the export that is being replaced, while its files are.
const REPLACED: &str = "replaced";

/// A folder that this process alone exports into.
pub struct ExportFolder {
    work: WorkFolder,
}

impl ExportFolder {
    /// Claims a folder. Nothing in it changes until [`ExportFolder::fill`].
    ///
    /// # Errors
    /// When another process writes into it.
    pub fn claim(target: &Path) -> Result<Self, PlannerError> {
        let folder = Self { work: WorkFolder::claim(target)? };
        if folder.work.whole().join(SUMS).exists() {
            // An export was killed while it moved its files in.
            folder.move_in()?;
        }
        Ok(folder)
    }

    /// Replaces the files of an earlier export by these.
    ///
    /// # Errors
    /// When a file would be replaced that is not from an earlier export, or one cannot be written. The earlier export then still
    /// stands, or the next export into the folder finishes this one.
    pub fn fill(self, files: &[(String, Vec<u8>)]) -> Result<(), PlannerError> {
        self.require_free(files.iter().map(|(name, _)| name.as_str()))?;
        self.work.discard()?;
        for (name, content) in files {
            write_file(&self.work.whole().join(name), content)?;
        }
        let sums: String = files.iter().map(|(name, content)| format!("{}  {name}\n", hash(content))).collect();
        write_file(&self.work.whole().join(SUMS), sums.as_bytes())?;
        self.move_in()
    }

    /// Moves a whole export in, from wherever an earlier try has come to.
    fn move_in(&self) -> Result<(), PlannerError> {
        let (whole, target, replaced) = (self.work.whole(), self.work.target(), self.work.path().join(REPLACED));
        fs::create_dir_all(target).map_err(PlannerError::written(target))?;
        let standing = target.join(SUMS);
        if standing.exists() {
            rename(&standing, &replaced)?;
        }
        let names = read_sums(&whole.join(SUMS))?;
        for name in read_sums(&replaced).unwrap_or_default().keys().filter(|name| !names.contains_key(*name)) {
            remove_file(&target.join(name))?;
        }
        for name in names.keys().map(String::as_str).chain([SUMS]) {
            let from = whole.join(name);
            if from.exists() {
                rename(&from, &target.join(name))?;
            }
        }
        self.work.discard().map(|_| ())
    }

    /// Refuses to replace what is not from an earlier export.
    fn require_free<'name>(&self, names: impl Iterator<Item = &'name str>) -> Result<(), PlannerError> {
        let target = self.work.target();
        let refuse = |file: &Path| {
            let problem =
                "would be replaced and is not from an earlier export, or was changed since; choose another --out";
            Err(PlannerError::file(file, problem))
        };
        let stands = |file: &Path| file.symlink_metadata().is_ok();
        let sums = target.join(SUMS);
        let earlier = match stands(&sums) {
            true => match read_sums(&sums) {
                Ok(earlier) => earlier,
                Err(_) => return refuse(&sums),
            },
            false => BTreeMap::new(),
        };
        let is_ours = |name: &str, file: &Path| {
            earlier.get(name).is_some_and(|own| read_bytes(file).is_ok_and(|content| hash(&content) == *own))
        };
        for name in names {
            let file = target.join(name);
            if stands(&file) && !is_ours(name, &file) {
                return refuse(&file);
            }
        }
        Ok(())
    }
}

/// Hashes of files by their names, all of them in one folder.
fn read_sums(file: &Path) -> Result<BTreeMap<String, String>, PlannerError> {
    let is_name = |name: &str| PathBuf::from(name).file_name().is_some_and(|file| file == name);
    let wrong = |line: usize| PlannerError::line(file, line + 1, "is no hash and name of a file of an export");
    let text = read_text(file)?;
    let entry = |(index, line): (usize, &str)| {
        let (hash, name) = line.split_once("  ").filter(|(_, name)| is_name(name)).ok_or_else(|| wrong(index))?;
        Ok((name.to_owned(), hash.to_owned()))
    };
    text.lines().enumerate().map(entry).collect()
}

fn rename(from: &Path, to: &Path) -> Result<(), PlannerError> {
    fs::rename(from, to).map_err(PlannerError::written(to))
}
