//! Homotopy files, and the same tables in scenes.

use std::path::Path;

use task::{Complementarity, HessianKind, HomotopySettings, IpoptValue, LinearSolver};
use toml::de::DeValue;

use crate::entry::Entry;
use crate::error::{SceneError, Source};
use crate::file::read_toml;
use crate::ipopt;
use crate::keys::{Form, key};
use crate::table::{self, Table};
use crate::words::clipped_to;

/// The homotopy that is used when neither the command line nor the scene names one.
const DEFAULT: &str = include_str!("../default.toml");

/// Longest path of a file that a message repeats, in characters.
const LONGEST_PATH: usize = 200;

/// Settings in the order of their declared words.
const COMPLEMENTARITIES: [Complementarity; 2] = [Complementarity::Relaxation, Complementarity::Smoothing];
const HESSIANS: [HessianKind; 3] = [HessianKind::Exact, HessianKind::GaussNewton, HessianKind::LimitedMemory];

/// The settings that are used when neither the user nor the scene gives any.
pub fn default_homotopy() -> HomotopySettings {
    let source = Source { file: Path::new("configs/default.toml"), text: DEFAULT };
    parse_homotopy(source).expect("the built-in homotopy is valid")
}

/// Reads a homotopy file.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn load_homotopy(path: &Path) -> Result<HomotopySettings, SceneError> {
    let text = read_toml(path, "homotopy")?;
    parse_homotopy(Source { file: path, text: &text })
}

/// Reads a homotopy from text. Keys that are not given have the values of the built-in one.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn parse_homotopy(source: Source) -> Result<HomotopySettings, SceneError> {
    table::read(source, Form::homotopy(), |top| settings(&top.table("homotopy")?, &top.table("ipopt")?))
}

/// The tables [homotopy] and [ipopt] of a file that gives these settings.
pub fn tables(settings: &HomotopySettings) -> (toml::Table, toml::Table) {
    let mut homotopy = toml::Table::new();
    let mut insert = |key: &str, value: toml::Value| homotopy.insert(key.to_owned(), value);
    insert("iterations", toml::Value::Integer(settings.iterations as i64));
    insert("further_iterations", toml::Value::Integer(settings.further_iterations as i64));
    insert("coarse_iterations", toml::Value::Integer(settings.coarse_iterations as i64));
    insert("tau", settings.tau.into());
    insert("sigma", settings.sigma.into());
    insert("mu_init", settings.mu_init.into());
    insert("tau_rate", settings.tau_rate.into());
    insert("sigma_rate", settings.sigma_rate.into());
    insert("mu_rate", settings.mu_rate.into());
    insert("complementarity", word("complementarity", &COMPLEMENTARITIES, &settings.complementarity));
    insert("hessian", word("hessian", &HESSIANS, &settings.hessian));
    insert("linear_solver", settings.linear_solver.name().into());
    let ipopt = settings.ipopt.iter().map(|option| {
        let value = match &option.value {
            IpoptValue::Integer(value) => toml::Value::Integer(i64::from(*value)),
            IpoptValue::Number(value) => toml::Value::Float(*value),
            IpoptValue::Text(value) => toml::Value::String(value.clone()),
        };
        (option.name.clone(), value)
    });
    (homotopy, ipopt.collect())
}

/// The homotopy that a scene carries: the name of a file beside it, or the tables themselves.
pub fn of_scene(scene: &Table) -> Result<Option<HomotopySettings>, SceneError> {
    let (entry, ipopt) = (scene.find("homotopy"), scene.find("ipopt"));
    let Some(entry) = entry else {
        let stray = ipopt.map(|ipopt| ipopt.refuse("[ipopt] in a scene needs a [homotopy] table beside it"));
        return stray.map_or(Ok(None), Err);
    };
    match (entry.value().get_ref(), ipopt) {
        (DeValue::String(_), Some(_)) => {
            Err(entry.refuse("[ipopt] cannot stand beside the name of a homotopy file; put it into that file"))
        }
        (DeValue::String(file), None) => of_file(&entry, file).map(Some),
        (DeValue::Table(_) | DeValue::Array(_), _) => {
            settings(&scene.table("homotopy")?, &scene.table("ipopt")?).map(Some)
        }
        _ => Err(entry.wrong_kind(entry.value(), "a file name or a table")),
    }
}

/// The homotopy in a file beside a scene. Errors in the file point into the file; that it cannot be read points into
/// the scene.
fn of_file(entry: &Entry, file: &str) -> Result<HomotopySettings, SceneError> {
    let path = entry.source().file.parent().unwrap_or(entry.source().file).join(file);
    let what = format!("homotopy {}", clipped_to(&path.display().to_string(), LONGEST_PATH));
    let text = read_toml(&path, &what).map_err(|error| match error.line() {
        Some(_) => error,
        None => entry.refuse(error.message()),
    })?;
    parse_homotopy(Source { file: &path, text: &text })
}

fn settings(table: &Table, ipopt: &Table) -> Result<HomotopySettings, SceneError> {
    Ok(HomotopySettings {
        iterations: table.integer("iterations")? as usize,
        further_iterations: table.integer("further_iterations")? as usize,
        coarse_iterations: table.integer("coarse_iterations")? as usize,
        tau: table.number("tau")?,
        sigma: table.number("sigma")?,
        mu_init: table.number("mu_init")?,
        tau_rate: table.number("tau_rate")?,
        sigma_rate: table.number("sigma_rate")?,
        mu_rate: table.number("mu_rate")?,
        complementarity: COMPLEMENTARITIES[table.choice("complementarity")?],
        hessian: HESSIANS[table.choice("hessian")?],
        linear_solver: LinearSolver::ALL[table.choice("linear_solver")?],
        ipopt: ipopt::options(ipopt)?,
    })
}

/// The word of a setting.
fn word<T: PartialEq>(name: &str, settings: &[T], setting: &T) -> toml::Value {
    let index = settings.iter().position(|other| other == setting).expect("every setting has a word");
    key("homotopy", name).words()[index].into()
}
