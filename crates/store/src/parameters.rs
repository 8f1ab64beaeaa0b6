//! Files that replace what steers the search for robust plans.

use std::path::Path;

use plan::{PlannerError, RobustParameters};
use scene::Source;
use toml::de::DeTable;

use crate::atomic::read_text;

/// Reads parameters from a TOML file; those that it does not name keep their defaults.
///
/// # Errors
/// When it cannot be read, or with the place of what is wrong.
pub fn read_robust_parameters(file: &Path) -> Result<RobustParameters, PlannerError> {
    let text = read_text(file)?;
    let source = Source { file, text: &text };
    let wrong = |error: toml::de::Error| source.error(error.span().unwrap_or_default(), error.message());
    require_known(&source, DeTable::parse(&text).map_err(wrong)?.get_ref())?;
    Ok(toml::from_str(&text).map_err(wrong)?)
}

/// Refuses names of no parameter. Results, which have all of them, may be of a version with others.
fn require_known(source: &Source, table: &DeTable) -> Result<(), PlannerError> {
    let known = toml::Table::try_from(RobustParameters::default())
        .map_err(|_| PlannerError::Internal("parameters without TOML"))?;
    for (name, group) in table {
        let parameters = known.get(name.get_ref().as_ref()).and_then(toml::Value::as_table);
        let Some(parameters) = parameters else { return Err(unknown(source, name, &known)) };
        let names = group.get_ref().as_table().into_iter().flat_map(|values| values.keys());
        if let Some(name) = names.into_iter().find(|name| !parameters.contains_key(name.get_ref().as_ref())) {
            return Err(unknown(source, name, parameters));
        }
    }
    Ok(())
}

fn unknown(source: &Source, name: &toml::Spanned<std::borrow::Cow<str>>, known: &toml::Table) -> PlannerError {
    let known = known.keys().map(String::as_str).collect::<Vec<_>>().join(", ");
    source.error(name.span(), format!("unknown key `{}`; there are {known}", name.get_ref())).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<RobustParameters, String> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        read_robust_parameters(file.path()).map_err(|error| error.to_string())
    }

    #[test]
    fn what_a_file_does_not_name_keeps_its_default() {
        let mut expected = RobustParameters::default();
        expected.training.simple = false;
        assert_eq!(read("[training]\nsimple = false\n"), Ok(expected));
        assert_eq!(read(""), Ok(RobustParameters::default()));
    }

    #[test]
    fn wrong_names_and_values_are_refused_with_their_line() {
        let refused = |text: &str, said: &str| {
            let error = read(text).unwrap_err();
            assert!(error.contains(said), "{error}");
        };
        refused("[training]\n\nsimpel = false\n", ":3:1: unknown key `simpel`; there are ");
        refused("[trainings]\n", ":1:2: unknown key `trainings`; there are ");
        refused("[training]\nsimple = 3\n", ":2:10: ");
        refused("training = 3\n", ":1:12: ");
        refused("[training\n", ":1:10: ");
    }

    #[test]
    fn results_with_parameters_of_another_version_are_read() {
        let parameters: RobustParameters =
            serde_json::from_str(r#"{"training": {"polishes": 2, "first": 7}, "former": {}}"#).unwrap();
        assert_eq!(parameters.training.first, 7);
    }
}
