//! What all tests of the program share: a folder of their own, the program in it, what it says and what it writes.

mod process;
pub mod reached;
pub mod round;
pub mod small;
pub mod table;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

pub use process::{Run, Running, TestCommand, WATCHDOG};
pub use table::Table;

/// A file or folder of the project.
pub fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// A folder of its own for a test, in which the program runs. It has the smallest scene, `corner.toml`, and its
/// homotopy, `homotopy.toml`.
pub struct Dir(TempDir);

impl Dir {
    pub fn new() -> Self {
        let dir = Self(tempfile::tempdir().unwrap());
        dir.add_scene("corner");
        dir.write("homotopy.toml", fs::read(project("configs/homotopy_peg.toml")).unwrap());
        dir
    }

    /// Adds a scene of the project, `NAME.toml`, with the homotopy in `homotopy.toml`.
    pub fn add_scene(&self, name: &str) {
        let text = fs::read_to_string(project(&format!("scenes/{name}.toml"))).unwrap();
        self.write(format!("{name}.toml"), text.replacen('\n', "\nhomotopy = \"homotopy.toml\"\n", 1));
    }

    /// Adds a variant of the corner scene in which some texts are replaced by others.
    #[track_caller]
    pub fn add_variant(&self, name: &str, changes: &[(&str, &str)]) {
        let mut text = self.read("corner.toml");
        for (from, to) in changes {
            assert!(text.contains(from), "{from}");
            text = text.replacen(from, to, 1);
        }
        self.write(name, text);
    }

    /// Adds a homotopy file.
    pub fn add_homotopy(&self, name: &str, homotopy: &str, ipopt: &str) {
        self.write(name, format!("[homotopy]\n{homotopy}\n[ipopt]\n{ipopt}\n"));
    }

    pub fn folder(&self) -> &Path {
        self.0.path()
    }

    pub fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.folder().join(name)
    }

    pub fn exists(&self, name: impl AsRef<Path>) -> bool {
        self.path(name).exists()
    }

    #[track_caller]
    pub fn bytes(&self, name: impl AsRef<Path>) -> Vec<u8> {
        let file = self.path(name);
        fs::read(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
    }

    #[track_caller]
    pub fn read(&self, name: impl AsRef<Path>) -> String {
        String::from_utf8(self.bytes(name)).unwrap()
    }

    /// Writes a file, and the folders it needs.
    #[track_caller]
    pub fn write(&self, name: impl AsRef<Path>, content: impl AsRef<[u8]>) {
        let file = self.path(name);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, content).unwrap();
    }

    pub fn make_folder(&self, name: &str) {
        fs::create_dir_all(self.path(name)).unwrap();
    }

    #[track_caller]
    pub fn remove(&self, name: impl AsRef<Path>) {
        let path = self.path(name);
        if path.is_dir() { fs::remove_dir_all(path).unwrap() } else { fs::remove_file(path).unwrap() }
    }

    #[track_caller]
    pub fn copy(&self, from: &str, to: &str) {
        let (from, to) = (self.path(from), self.path(to));
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        copy_all(&from, &to);
    }

    #[track_caller]
    pub fn rename(&self, from: &str, to: &str) {
        fs::rename(self.path(from), self.path(to)).unwrap();
    }

    #[track_caller]
    pub fn json(&self, name: impl AsRef<Path>) -> Value {
        serde_json::from_slice(&self.bytes(name)).unwrap()
    }

    /// `result.json` of a plan's folder.
    #[track_caller]
    pub fn result(&self, folder: impl AsRef<Path>) -> Value {
        self.json(folder.as_ref().join("result.json"))
    }

    #[track_caller]
    pub fn table(&self, file: impl AsRef<Path>) -> Table {
        Table::parse(&self.read(file))
    }

    /// The program with the words of a line as its arguments; `'single quotes'` hold a word together.
    pub fn program(&self, line: &str) -> TestCommand {
        TestCommand::new(self.folder(), line)
    }

    /// Runs the program to its end.
    #[track_caller]
    pub fn run(&self, line: &str) -> Run {
        self.program(line).run()
    }

    /// Everything in the folder, or in one below it: files with their content, folders without.
    pub fn snapshot(&self, below: &str) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
        let mut found = BTreeMap::new();
        collect(&self.path(below), &mut found);
        found
    }
}

fn collect(folder: &Path, found: &mut BTreeMap<PathBuf, Option<Vec<u8>>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let kind = path.symlink_metadata().unwrap();
        let content = if kind.is_dir() {
            collect(&path, found);
            None
        } else if kind.is_symlink() {
            Some(fs::read_link(&path).unwrap().into_os_string().into_encoded_bytes())
        } else {
            Some(fs::read(&path).unwrap())
        };
        found.insert(path, content);
    }
}

fn copy_all(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).unwrap();
        for entry in fs::read_dir(from).unwrap() {
            let name = entry.unwrap().file_name();
            copy_all(&from.join(&name), &to.join(&name));
        }
    } else {
        fs::copy(from, to).unwrap();
    }
}

/// A number in a JSON value, by a path such as `robust.rounds.0.rate`.
#[track_caller]
pub fn number(value: &Value, path: &str) -> f64 {
    let pointer = format!("/{}", path.replace('.', "/"));
    value.pointer(&pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number {path} in {value:#}"))
}

/// The elements of a list in a JSON value.
#[track_caller]
pub fn list<'value>(value: &'value Value, key: &str) -> &'value [Value] {
    value[key].as_array().unwrap_or_else(|| panic!("no list {key} in {value:#}"))
}

/// A record of unfinished work (JSON) with the hash of itself, as the program writes it.
pub fn sealed(record: &str) -> String {
    format!("{{\"hash\":\"{}\",\"record\":{record}}}", planner::files::hash(record.as_bytes()))
}
