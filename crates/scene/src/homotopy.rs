//! Homotopy files.

use std::path::Path;

use task::{Complementarity, HessianKind, HomotopySettings, IpoptOption, IpoptValue, LinearSolver};
use toml::Spanned;

use crate::document::{HomotopyDocument, HomotopyFileDocument};
use crate::error::{SceneError, Source};
use crate::pose::{positive, within};

/// The homotopy that is used when neither the command line nor the scene names one.
const DEFAULT: &str = include_str!("../../../configs/default.toml");

const COMPLEMENTARITIES: [(&str, Complementarity); 2] =
    [("relaxation", Complementarity::Relaxation), ("smoothing", Complementarity::Smoothing)];
const HESSIANS: [(&str, HessianKind); 3] =
    [("exact", HessianKind::Exact), ("gauss-newton", HessianKind::GaussNewton), ("l-bfgs", HessianKind::LimitedMemory)];

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
    let text = std::fs::read_to_string(path)
        .map_err(|error| SceneError::about(path, format!("the homotopy cannot be read: {error}")))?;
    parse_homotopy(Source { file: path, text: &text })
}

/// Reads a homotopy from text. Keys that are not given have the values of the paper's peg experiments.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn parse_homotopy(source: Source) -> Result<HomotopySettings, SceneError> {
    let document: HomotopyFileDocument = toml::from_str(source.text).map_err(|error| source.parse_error(&error))?;
    settings(source, &document.homotopy, &document.ipopt)
}

/// The tables [homotopy] and [ipopt] of a file that gives these settings.
pub fn tables(settings: &HomotopySettings) -> (toml::Table, toml::Table) {
    let mut homotopy = toml::Table::new();
    let mut insert = |key: &str, value: toml::Value| homotopy.insert(key.to_owned(), value);
    insert("iterations", toml::Value::Integer(settings.iterations as i64));
    insert("tau", settings.tau.into());
    insert("sigma", settings.sigma.into());
    insert("mu_init", settings.mu_init.into());
    insert("tau_rate", settings.tau_rate.into());
    insert("sigma_rate", settings.sigma_rate.into());
    insert("mu_rate", settings.mu_rate.into());
    insert("complementarity", name_of(&COMPLEMENTARITIES, settings.complementarity).into());
    insert("hessian", name_of(&HESSIANS, settings.hessian).into());
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
pub fn of_scene(
    source: Source,
    entry: Option<&Spanned<toml::Value>>,
    ipopt: Option<&toml::Table>,
) -> Result<Option<HomotopySettings>, SceneError> {
    let Some(entry) = entry else {
        if ipopt.is_some() {
            return Err(SceneError::about(source.file, "[ipopt] in a scene needs a [homotopy] table beside it"));
        }
        return Ok(None);
    };
    match entry.get_ref() {
        toml::Value::String(file) => {
            if ipopt.is_some() {
                let message = "[ipopt] cannot stand beside the name of a homotopy file; put it into that file";
                return Err(source.error(entry.span(), message));
            }
            let path = source.file.parent().unwrap_or(source.file).join(file);
            load_homotopy(&path).map(Some)
        }
        toml::Value::Table(_) => {
            #[derive(serde::Deserialize)]
            struct Tables {
                homotopy: HomotopyDocument,
                #[serde(default)]
                ipopt: toml::Table,
            }
            let tables: Tables = toml::from_str(source.text).map_err(|error| source.parse_error(&error))?;
            settings(source, &tables.homotopy, &tables.ipopt).map(Some)
        }
        _ => Err(source.error(entry.span(), "homotopy is the name of a file or a table")),
    }
}

fn settings(source: Source, document: &HomotopyDocument, ipopt: &toml::Table) -> Result<HomotopySettings, SceneError> {
    let number = |key: &str, value: &Option<Spanned<f64>>, default: f64| match value {
        Some(value) => positive(source, &format!("homotopy.{key}"), value),
        None => Ok(default),
    };
    let rate = |key: &str, value: &Option<Spanned<f64>>, default: f64| match value {
        Some(value) => {
            within(source, &format!("homotopy.{key}"), value, |rate| 0.0 < rate && rate < 1.0, "must lie in (0, 1)")
        }
        None => Ok(default),
    };
    let mu_rate = match &document.mu_rate {
        Some(value) => {
            within(source, "homotopy.mu_rate", value, |rate| 0.0 < rate && rate <= 1.0, "must lie in (0, 1]")?
        }
        None => 0.1,
    };
    let iterations = match &document.iterations {
        Some(value) => within(source, "homotopy.iterations", value, |count| count >= 1, "must be at least 1")? as usize,
        None => 5,
    };
    let linear_solver = match &document.linear_solver {
        Some(name) => LinearSolver::ALL[source.require_known(name, &LinearSolver::ALL.map(LinearSolver::name))?],
        None => LinearSolver::Stage,
    };
    Ok(HomotopySettings {
        iterations,
        tau: number("tau", &document.tau, 0.0025)?,
        sigma: number("sigma", &document.sigma, 0.00125)?,
        mu_init: number("mu_init", &document.mu_init, 1.0)?,
        tau_rate: rate("tau_rate", &document.tau_rate, 0.5)?,
        sigma_rate: rate("sigma_rate", &document.sigma_rate, 0.5)?,
        mu_rate,
        complementarity: choice(source, document.complementarity.as_ref(), &COMPLEMENTARITIES)?,
        hessian: choice(source, document.hessian.as_ref(), &HESSIANS)?,
        linear_solver,
        ipopt: options(source, ipopt)?,
    })
}

/// One of several names, by default the first.
fn choice<T: Copy>(source: Source, name: Option<&Spanned<String>>, choices: &[(&str, T)]) -> Result<T, SceneError> {
    let Some(name) = name else { return Ok(choices[0].1) };
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    let index = source.require_known(name, &names)?;
    Ok(choices[index].1)
}

fn name_of<T: PartialEq>(choices: &[(&'static str, T)], value: T) -> &'static str {
    choices.iter().find(|(_, choice)| *choice == value).map_or("", |(name, _)| name)
}

fn options(source: Source, table: &toml::Table) -> Result<Vec<IpoptOption>, SceneError> {
    let mut options = Vec::with_capacity(table.len());
    for (name, value) in table {
        let value = match value {
            toml::Value::Integer(number) => i32::try_from(*number).ok().map(IpoptValue::Integer),
            toml::Value::Float(number) => Some(IpoptValue::Number(*number)),
            toml::Value::String(text) => Some(IpoptValue::Text(text.clone())),
            _ => None,
        };
        let Some(value) = value else {
            let message = format!("ipopt.{name} must be an integer, a number or a string");
            return Err(SceneError::about(source.file, message));
        };
        options.push(IpoptOption { name: name.clone(), value });
    }
    Ok(options)
}
