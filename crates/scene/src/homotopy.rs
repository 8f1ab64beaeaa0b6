//! Homotopy files.

use std::path::Path;

use task::{Complementarity, HessianKind, HomotopySettings, IpoptValue, LinearSolver};
use toml::Spanned;

use crate::document::{HomotopyDocument, HomotopyFileDocument, IpoptDocument};
use crate::error::{SceneError, Source};
use crate::file::read_text;
use crate::ipopt;
use crate::range::Range;

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
    let text = read_text(path, "homotopy")?;
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
    ipopt: Option<&Spanned<IpoptDocument>>,
) -> Result<Option<HomotopySettings>, SceneError> {
    let Some(entry) = entry else {
        return match ipopt {
            Some(ipopt) => Err(source.error(ipopt.span(), "[ipopt] in a scene needs a [homotopy] table beside it")),
            None => Ok(None),
        };
    };
    match entry.get_ref() {
        toml::Value::String(file) => {
            if ipopt.is_some() {
                let message = "[ipopt] cannot stand beside the name of a homotopy file; put it into that file";
                return Err(source.error(entry.span(), message));
            }
            let path = source.file.parent().unwrap_or(source.file).join(file);
            let text = std::fs::read_to_string(&path).map_err(|error| {
                let message = format!("the homotopy {} cannot be read: {error}", path.display());
                source.error(entry.span(), message)
            })?;
            parse_homotopy(Source { file: &path, text: &text }).map(Some)
        }
        toml::Value::Table(_) => {
            #[derive(serde::Deserialize)]
            struct Tables {
                homotopy: HomotopyDocument,
                #[serde(default)]
                ipopt: IpoptDocument,
            }
            let tables: Tables = toml::from_str(source.text).map_err(|error| source.parse_error(&error))?;
            settings(source, &tables.homotopy, &tables.ipopt).map(Some)
        }
        _ => Err(source.error(entry.span(), "homotopy is the name of a file or a table")),
    }
}

fn settings(
    source: Source,
    document: &HomotopyDocument,
    ipopt: &IpoptDocument,
) -> Result<HomotopySettings, SceneError> {
    let number = |key: &str, value: &Option<Spanned<f64>>, range: &'static str, default: f64| match value {
        Some(value) => Range::new(range).check(source, &format!("homotopy.{key}"), value.span(), *value.get_ref()),
        None => Ok(default),
    };
    let iterations = match &document.iterations {
        Some(value) => {
            let count = *value.get_ref() as f64;
            Range::new("[1, 100]").check(source, "homotopy.iterations", value.span(), count)? as usize
        }
        None => 5,
    };
    let linear_solver = match &document.linear_solver {
        Some(name) => LinearSolver::ALL[source.require_known(name, &LinearSolver::ALL.map(LinearSolver::name))?],
        None => LinearSolver::Stage,
    };
    Ok(HomotopySettings {
        iterations,
        tau: number("tau", &document.tau, "[1e-9, 1]", 0.0025)?,
        sigma: number("sigma", &document.sigma, "[1e-12, 1]", 0.00125)?,
        mu_init: number("mu_init", &document.mu_init, "(1e-12, 1e6]", 1.0)?,
        tau_rate: number("tau_rate", &document.tau_rate, "(0, 1)", 0.5)?,
        sigma_rate: number("sigma_rate", &document.sigma_rate, "(0, 1)", 0.5)?,
        mu_rate: number("mu_rate", &document.mu_rate, "(0, 1]", 0.1)?,
        complementarity: choice(source, document.complementarity.as_ref(), &COMPLEMENTARITIES)?,
        hessian: choice(source, document.hessian.as_ref(), &HESSIANS)?,
        linear_solver,
        ipopt: ipopt::options(source, ipopt)?,
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
