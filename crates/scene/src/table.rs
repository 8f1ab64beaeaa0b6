//! Tables of a TOML file. They have no keys but the declared ones.

use std::ops::Range as Span;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::entry::{Entry, Value};
use crate::error::{SceneError, Source};
use crate::keys::{self, Absent, Form, Key};
use crate::words::{clipped, suggest};

/// A table of a file.
pub struct Table<'text> {
    source: Source<'text>,
    form: Form,
    declared: &'static [Key],
    /// Name of the table in messages, empty for the top of a file.
    path: String,
    /// Place of its header; the top has none.
    header: Option<Span<usize>>,
    /// Nothing where the table is not given.
    entries: Option<&'text DeTable<'text>>,
}

/// Reads a file from the table that is its top.
///
/// # Errors
/// The first thing that is wrong, with its place.
pub fn read<T>(
    source: Source,
    form: Form,
    read: impl FnOnce(&Table) -> Result<T, SceneError>,
) -> Result<T, SceneError> {
    let entries = DeTable::parse(source.text).map_err(|error| source.parse_error(&error))?;
    let (path, entries) = (String::new(), Some(entries.get_ref()));
    read(&Table { source, form, declared: form.top, path, header: None, entries }.checked()?)
}

impl<'text> Table<'text> {
    /// Refuses unknown keys, the first one in the file, and keys under their former and present names at once.
    fn checked(self) -> Result<Self, SceneError> {
        for (old, new) in self.renamed() {
            if let (Some(old), Some(_)) = (self.written(old), self.written(new)) {
                return Err(
                    old.refuse_name(format!("this is the former name of `{new}`, which is given too: delete it"))
                );
            }
        }
        let valid: Vec<&str> = self.declared.iter().map(|key| key.name).collect();
        let names = self.entries.into_iter().flat_map(DeTable::keys);
        let unknown = names.filter(|name| !valid.contains(&self.present(name.get_ref())));
        match unknown.min_by_key(|name| name.span().start) {
            None => Ok(self),
            Some(name) => {
                let place = name.span();
                let name = clipped(name.get_ref());
                let hint = match self.form.owner(&name) {
                    Some(table) => format!(" here: it belongs to [{table}]"),
                    None => suggest(&name, &valid),
                };
                Err(self.source.error(place, format!("unknown key `{name}`{hint}")))
            }
        }
    }

    /// Former and present names of the table's keys.
    fn renamed(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let own = |name: &'static str| name.strip_prefix(self.path.as_str())?.strip_prefix('.');
        input::KEYS.iter().filter_map(move |renamed| Some((own(renamed.old)?, own(renamed.new)?)))
    }

    /// The present name of a key.
    fn present<'name>(&self, name: &'name str) -> &'name str {
        self.renamed().find(|(old, _)| *old == name).map_or(name, |(_, new)| new)
    }

    fn key(&self, name: &str) -> &'static Key {
        let found = self.declared.iter().find(|key| key.name == name);
        found.unwrap_or_else(|| panic!("`{name}` of `{}` is declared", self.path))
    }

    fn entry(&self, (name, value): (&Spanned<DeString>, &'text Value<'text>)) -> Entry<'text> {
        Entry::new(self.source, self.key(self.present(name.get_ref())), &self.path, (name, value))
    }

    /// The value of a key, if it is given, under its former name too.
    pub fn find(&self, name: &str) -> Option<Entry<'text>> {
        let former = self.renamed().find(|(_, new)| *new == name);
        self.written(name).or_else(|| self.written(former?.0))
    }

    /// The value of a key that is written by just this name.
    pub fn written(&self, name: &str) -> Option<Entry<'text>> {
        self.entries?.get_key_value(name).map(|entry| self.entry(entry))
    }

    /// All values, as they stand in the file.
    pub fn given(&self) -> Vec<Entry<'text>> {
        let mut entries: Vec<_> = self.entries.into_iter().flatten().collect();
        entries.sort_by_key(|(name, _)| name.span().start);
        entries.into_iter().map(|entry| self.entry(entry)).collect()
    }

    /// The value of a key that must be given.
    pub fn require(&self, name: &str) -> Result<Entry<'text>, SceneError> {
        self.find(name).ok_or_else(|| {
            let key = self.key(name);
            let unit = if key.unit.is_empty() { String::new() } else { format!(" ({})", key.unit) };
            self.refuse(format!("missing key `{name}` in {}: {}{unit}", self.title(), key.meaning))
        })
    }

    /// A number, or the key's default.
    pub fn number(&self, name: &str) -> Result<f64, SceneError> {
        match (self.find(name), self.key(name).absent) {
            (None, Absent::Number(default)) => Ok(default),
            _ => self.require(name)?.number(),
        }
    }

    /// An integer, or the key's default.
    pub fn integer(&self, name: &str) -> Result<i64, SceneError> {
        match (self.find(name), self.key(name).absent) {
            (None, Absent::Number(default)) => Ok(default as i64),
            _ => self.require(name)?.integer(),
        }
    }

    /// Index of one of the key's words, the first where none is given.
    pub fn choice(&self, name: &str) -> Result<usize, SceneError> {
        self.find(name).map_or(Ok(0), |entry| entry.choice())
    }

    /// A table that may be left out; it is empty then.
    pub fn table(&self, name: &str) -> Result<Self, SceneError> {
        let path = if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) };
        let Some(entry) = self.find(name) else {
            let (declared, header, entries) = (keys::table(&path), None, None);
            return Ok(Self { source: self.source, form: self.form, declared, path, header, entries });
        };
        match entry.value().get_ref() {
            DeValue::Table(_) => self.within(&entry, keys::table(&path), entry.value()),
            DeValue::Array(list) if list.first().is_some_and(|first| first.get_ref().is_table()) => {
                Err(entry.refuse(format!("{path} is a single table: write [{path}], not [[{path}]]")))
            }
            _ => Err(entry.wrong_kind(entry.value(), "a table")),
        }
    }

    /// A table that must be there. It may be given by its parts alone.
    pub fn require_table(&self, name: &str) -> Result<Self, SceneError> {
        if self.find(name).is_some() {
            return self.table(name);
        }
        let has_parts = keys::table(name).iter().any(|key| key.name == "part");
        let header = if has_parts { format!("[[{name}.part]]") } else { format!("[{name}]") };
        Err(self.refuse(format!("the scene has no {header}: {}", self.key(name).meaning)))
    }

    /// Tables with headers in double brackets, whose keys are declared under another name.
    pub fn tables(&self, name: &str, declared: &str) -> Result<Vec<Self>, SceneError> {
        let Some(entry) = self.find(name) else {
            return Err(match &self.header {
                Some(_) => self.refuse(format!("[{0}] has no part: add a [[{0}.{name}]]", self.path)),
                None => self.refuse(format!("the scene has no [[{name}]]: {}", self.key(name).meaning)),
            });
        };
        let header = entry.path();
        match entry.value().get_ref() {
            DeValue::Array(_) => {
                let declared = keys::table(declared);
                entry.list()?.iter().map(|value| self.within(&entry, declared, value)).collect()
            }
            DeValue::Table(_) => Err(entry.refuse(format!("there may be several: write [[{header}]], not [{header}]"))),
            _ => Err(entry.wrong_kind(entry.value(), &format!("given as [[{header}]]"))),
        }
    }

    /// A table that is a value of an entry.
    fn within(&self, entry: &Entry, declared: &'static [Key], value: &'text Value<'text>) -> Result<Self, SceneError> {
        let DeValue::Table(entries) = value.get_ref() else { return Err(entry.wrong_kind(value, "a table")) };
        let (path, header, entries) = (entry.path().to_owned(), Some(value.span()), Some(entries));
        Self { source: self.source, form: self.form, declared, path, header, entries }.checked()
    }

    /// Its header as it is written, where it has one.
    fn title(&self) -> String {
        let written = self.header.clone().map_or("", |header| &self.source.text[header]);
        if written.starts_with('[') { clipped(written) } else { format!("[{}]", self.path) }
    }

    /// An error about the table.
    pub fn refuse(&self, message: String) -> SceneError {
        match &self.header {
            Some(header) => self.source.error(header.clone(), message),
            None => SceneError::about(self.source.file, message),
        }
    }
}
