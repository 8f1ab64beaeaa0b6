//! The matrix of a batch, from a TOML file or from flags.

use std::ops::Range;
use std::path::{Path, PathBuf};

use plan::PlannerError;
use scene::{SceneError, Source, key, read_text};
use serde::Deserialize;
use task::LinearSolver;
use toml::Spanned;

/// Every scene with every start, offset magnitude and homotopy.
#[derive(Debug)]
pub struct Matrix {
    /// Scene files.
    pub scenes: Vec<PathBuf>,
    /// Start poses.
    pub starts: Starts,
    /// Offset magnitudes (m); empty for each scene's own.
    pub deltas: Vec<f64>,
    /// Homotopy files; empty for each scene's own.
    pub homotopies: Vec<PathBuf>,
    /// Linear solver of all cells; none for the homotopy's.
    pub linear_solver: Option<LinearSolver>,
    places: Places,
}

/// Start poses of a matrix.
#[derive(Debug)]
pub enum Starts {
    /// Each scene's first.
    First,
    /// All of each scene.
    All,
    /// Those with these names.
    Named(Vec<String>),
}

/// Places of the user's values.
#[derive(Debug, Default)]
enum Places {
    #[default]
    Flags,
    File {
        path: PathBuf,
        text: String,
        scenes: Range<usize>,
        starts: Range<usize>,
        deltas: Range<usize>,
    },
}

/// A part of the matrix that can be wrong.
#[derive(Debug, Clone, Copy)]
pub enum Key {
    /// Scene files.
    Scenes,
    /// Start poses.
    Starts,
    /// Offset magnitudes.
    Deltas,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MatrixDocument {
    scenes: Spanned<Vec<PathBuf>>,
    starts: Option<Spanned<StartsDocument>>,
    deltas: Option<Spanned<Vec<Spanned<f64>>>>,
    #[serde(default)]
    homotopies: Vec<PathBuf>,
    linear_solver: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(untagged, expecting = "starts must be \"all\" or a list of names")]
enum StartsDocument {
    Word(String),
    Names(Vec<String>),
}

/// The word for all starts.
const ALL: &str = "all";

impl StartsDocument {
    /// The value in a range of bytes of a file.
    fn read(&self, source: Source, span: Range<usize>) -> Result<Starts, SceneError> {
        match self {
            Self::Word(word) if word == ALL => Ok(Starts::All),
            Self::Names(names) if !names.is_empty() => Ok(Starts::new(names.clone())),
            Self::Names(_) => Err(source.error(span, "no start is named; leave starts out for the first")),
            Self::Word(_) => Err(source.error(span, "starts must be \"all\" or a list of names")),
        }
    }
}

impl Matrix {
    /// From scenes with their own offset magnitudes and homotopies and their first starts.
    pub fn of_scenes(scenes: Vec<PathBuf>) -> Self {
        Self {
            scenes,
            starts: Starts::First,
            deltas: Vec::new(),
            homotopies: Vec::new(),
            linear_solver: None,
            places: Places::Flags,
        }
    }

    /// From a file; the files that it names are looked for beside it.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    pub fn load(path: &Path) -> Result<Self, PlannerError> {
        Self::parse(path, read_text(path, "matrix")?)
    }

    fn parse(path: &Path, text: String) -> Result<Self, PlannerError> {
        let source = Source { file: path, text: &text };
        let document: MatrixDocument = toml::from_str(&text).map_err(|error| source.parse_error(&error))?;
        let solver = |name: &Spanned<String>| -> Result<LinearSolver, SceneError> {
            Ok(LinearSolver::ALL[source.require_known(name, &LinearSolver::ALL.map(LinearSolver::name))?])
        };
        let linear_solver = document.linear_solver.as_ref().map(solver).transpose()?;
        let magnitude = |offset_magnitude: &Spanned<f64>| {
            source.require_within(offset_magnitude, key("robustness", "offset_magnitude"), "deltas")
        };
        let deltas = document.deltas.as_ref().map_or(&[][..], |deltas| deltas.get_ref());
        let deltas = deltas.iter().map(magnitude).collect::<Result<_, SceneError>>()?;
        let beside = |files: &[PathBuf]| files.iter().map(|file| path.parent().unwrap_or(path).join(file)).collect();
        let starts = document
            .starts
            .as_ref()
            .map_or(Ok(Starts::First), |starts| starts.get_ref().read(source, starts.span()))?;
        if let Some(deltas) = document.deltas.as_ref().filter(|deltas| deltas.get_ref().is_empty()) {
            let message = "no magnitude is given; leave deltas out for those of the scenes";
            return Err(source.error(deltas.span(), message).into());
        }
        let places = Places::File {
            path: path.to_owned(),
            scenes: document.scenes.span(),
            starts: document.starts.as_ref().map_or(0..0, Spanned::span),
            deltas: document.deltas.as_ref().map_or(0..0, Spanned::span),
            text,
        };
        Ok(Self {
            scenes: beside(document.scenes.get_ref()),
            starts,
            deltas,
            homotopies: beside(&document.homotopies),
            linear_solver,
            places,
        })
    }

    /// An error that points at the user's value.
    pub fn refuse(&self, key: Key, message: &str) -> PlannerError {
        match &self.places {
            Places::Flags => PlannerError::Choice { name: key.name(), problem: message.to_owned() },
            Places::File { path, text, scenes, starts, deltas } => {
                let span = match key {
                    Key::Scenes => scenes,
                    Key::Starts => starts,
                    Key::Deltas => deltas,
                };
                Source { file: path, text }.error(span.clone(), message).into()
            }
        }
    }
}

impl Key {
    fn name(self) -> &'static str {
        match self {
            Self::Scenes => "scenes",
            Self::Starts => "starts",
            Self::Deltas => "deltas",
        }
    }
}

impl Starts {
    /// All of them for the single word `all`, the first for none.
    pub fn new(names: Vec<String>) -> Self {
        match names.as_slice() {
            [] => Self::First,
            [word] if word == ALL => Self::All,
            _ => Self::Named(names),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delta_out_of_range_is_shown_where_it_stands() {
        let parse = |deltas: &str| {
            let text = format!("scenes = [\"a.toml\"]\ndeltas = {deltas}\n");
            Matrix::parse(Path::new("matrix.toml"), text).map(|matrix| matrix.deltas).map_err(|error| error.to_string())
        };
        assert_eq!(parse("[0, 0.01, 10]"), Ok(vec![0.0, 0.01, 10.0]));
        let error = parse("[0.01, -1e-3]").unwrap_err();
        assert!(error.starts_with("matrix.toml:2:17: deltas: -1e-3 must lie between 0 and 10 m\n"), "{error}");
        assert!(parse("[nan]").unwrap_err().starts_with("matrix.toml:2:11: deltas: nan must lie between 0 and 10 m\n"));
    }
}
