//! Tables and values of a TOML file with their places, read as the declared keys want them.

use std::ops::Range as Span;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{SceneError, Source, clipped, suggest};
use crate::keys::{self, Absent, Key, MAX_NAME_LENGTH, Range, Values};

/// A table of a file. It has no keys but the declared ones.
pub struct Table<'text> {
    source: Source<'text>,
    /// Name of the table among the declared keys.
    declared: &'static str,
    /// Name of the table in messages.
    path: String,
    /// Place of its header; the top level has none.
    header: Option<Span<usize>>,
    entries: &'text DeTable<'text>,
}

/// The value of a key.
pub struct Entry<'text> {
    source: Source<'text>,
    key: &'static Key,
    path: String,
    value: &'text Spanned<DeValue<'text>>,
}

type Value<'text> = Spanned<DeValue<'text>>;

impl<'text> Table<'text> {
    /// The top level of a scene.
    pub fn top(source: Source<'text>, entries: &'text DeTable<'text>) -> Result<Self, SceneError> {
        Self { source, declared: "", path: String::new(), header: None, entries }.checked()
    }

    /// Refuses unknown keys, the first one in the file.
    fn checked(self) -> Result<Self, SceneError> {
        let declared = keys::keys().iter().filter(|key| key.table == self.declared);
        let valid: Vec<&str> = declared.map(|key| key.name).collect();
        let unknown = self.entries.keys().filter(|key| !valid.contains(&key.get_ref().as_ref()));
        match unknown.min_by_key(|key| key.span().start) {
            None => Ok(self),
            Some(key) => {
                let name = clipped(key.get_ref());
                let hint = match owner(&name) {
                    Some(table) => format!(" here: it belongs to [{table}]"),
                    None => suggest(&name, &valid),
                };
                Err(self.source.error(key.span(), format!("unknown key `{name}`{hint}")))
            }
        }
    }

    /// The value of a key, if it is given.
    pub fn find(&self, name: &str) -> Option<Entry<'text>> {
        let key = keys::key(self.declared, name);
        let path = if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) };
        self.entries.get(name).map(|value| Entry { source: self.source, key, path, value })
    }

    /// The value of a key that must be given.
    pub fn require(&self, name: &str) -> Result<Entry<'text>, SceneError> {
        self.find(name).ok_or_else(|| {
            let key = keys::key(self.declared, name);
            let unit = if key.unit.is_empty() { String::new() } else { format!(" ({})", key.unit) };
            self.refuse(format!("missing key `{name}` in {}: {}{unit}", self.title(), key.meaning))
        })
    }

    /// A number, or the key's default.
    pub fn number(&self, name: &str) -> Result<f64, SceneError> {
        match (self.find(name), keys::key(self.declared, name).absent) {
            (None, Absent::Number(default)) => Ok(default),
            _ => self.require(name)?.number(),
        }
    }

    /// A table that may be left out.
    pub fn find_table(&self, name: &str) -> Result<Option<Table<'text>>, SceneError> {
        let Some(entry) = self.find(name) else { return Ok(None) };
        let declared = keys::keys().iter().map(|key| key.table).find(|table| *table == entry.path);
        let declared = declared.expect("a table has declared keys");
        let name = &entry.path;
        match entry.value.get_ref() {
            DeValue::Table(_) => entry.table(declared, entry.value).map(Some),
            DeValue::Array(list) if list.first().is_some_and(|first| first.get_ref().is_table()) => {
                Err(entry.refuse(format!("{name} is a single table: write [{name}], not [[{name}]]")))
            }
            _ => Err(entry.wrong_kind(entry.value, "a table")),
        }
    }

    /// A table that must be there. It may be given by its parts alone.
    pub fn require_table(&self, name: &str) -> Result<Table<'text>, SceneError> {
        self.find_table(name)?.ok_or_else(|| {
            let has_parts = keys::keys().iter().any(|key| key.table == name && key.name == "part");
            let header = if has_parts { format!("[[{name}.part]]") } else { format!("[{name}]") };
            self.refuse(format!("the scene has no {header}: {}", keys::key(self.declared, name).meaning))
        })
    }

    /// Tables with headers in double brackets, whose keys are declared under another name.
    pub fn tables(&self, name: &str, declared: &'static str) -> Result<Vec<Table<'text>>, SceneError> {
        let Some(entry) = self.find(name) else {
            return Err(match &self.header {
                Some(_) => self.refuse(format!("[{0}] has no part: add a [[{0}.{name}]]", self.path)),
                None => self.refuse(format!("the scene has no [[{name}]]: {}", keys::key(self.declared, name).meaning)),
            });
        };
        let header = &entry.path;
        match entry.value.get_ref() {
            DeValue::Array(_) => entry.list()?.iter().map(|value| entry.table(declared, value)).collect(),
            DeValue::Table(_) => Err(entry.refuse(format!("there may be several: write [[{header}]], not [{header}]"))),
            _ => Err(entry.wrong_kind(entry.value, &format!("given as [[{header}]]"))),
        }
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

impl<'text> Entry<'text> {
    /// The file.
    pub fn source(&self) -> Source<'text> {
        self.source
    }

    /// Place of the value.
    pub fn span(&self) -> Span<usize> {
        self.value.span()
    }

    /// Name of the key with its tables.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// An error about the value.
    pub fn refuse(&self, message: impl Into<String>) -> SceneError {
        self.source.error(self.span(), message)
    }

    /// A number in the key's range.
    pub fn number(&self) -> Result<f64, SceneError> {
        self.number_of(self.value, self.key.bounds())
    }

    /// An integer in the key's range.
    pub fn integer(&self) -> Result<usize, SceneError> {
        match self.value.get_ref() {
            DeValue::Integer(_) => self.number().map(|number| number as usize),
            DeValue::Float(_) => Err(self.refuse(format!("{} must be an integer", self.subject(self.value)))),
            _ => Err(self.wrong_kind(self.value, "an integer")),
        }
    }

    /// Three or four numbers in the key's range.
    pub fn vector<const N: usize>(&self) -> Result<[f64; N], SceneError> {
        self.vector_of(self.value, &self.path, self.key.bounds())
    }

    /// Four numbers.
    pub fn quaternion(&self) -> Result<[f64; 4], SceneError> {
        self.vector_of(self.value, &self.path, COMPONENT)
    }

    /// A list of numbers in the key's range.
    pub fn numbers(&self) -> Result<Vec<f64>, SceneError> {
        let range = self.key.bounds();
        self.list()?.iter().map(|value| self.number_of(value, range)).collect()
    }

    /// A list of three numbers each, with their places.
    pub fn vectors(&self) -> Result<Vec<Spanned<[f64; 3]>>, SceneError> {
        let range = self.key.range().unwrap_or(COMPONENT);
        let label = format!("each entry of {}", self.path);
        let vector = |value: &Value| Ok(Spanned::new(value.span(), self.vector_of(value, &label, range)?));
        self.list()?.iter().map(vector).collect()
    }

    /// Three numbers in the key's range as a diagonal, or the rows of a 3x3 matrix of numbers that are no larger.
    pub fn matrix(&self) -> Result<[[f64; 3]; 3], SceneError> {
        let words = "3 numbers or a 3x3 matrix";
        let DeValue::Array(rows) = self.value.get_ref() else { return Err(self.wrong_kind(self.value, words)) };
        if !rows.iter().any(|row| row.get_ref().is_array()) {
            if rows.len() != 3 {
                return Err(self.refuse(format!("{} must be {words}, not {} numbers", self.path, rows.len())));
            }
            let [x, y, z] = self.vector()?;
            return Ok([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]);
        }
        if rows.len() != 3 {
            return Err(self.refuse(format!("{} must have 3 rows, not {}", self.path, rows.len())));
        }
        let range = Range::closed(-self.key.bounds().high, self.key.bounds().high);
        let label = format!("each row of {}", self.path);
        let mut matrix = [[0.0; 3]; 3];
        for (row, value) in matrix.iter_mut().zip(rows) {
            *row = self.vector_of(value, &label, range)?;
        }
        Ok(matrix)
    }

    /// A text.
    pub fn text(&self) -> Result<&'text str, SceneError> {
        self.text_of(self.value)
    }

    /// A text in one line that is neither empty nor too long.
    pub fn name(&self) -> Result<String, SceneError> {
        let name = self.text()?;
        let length = name.chars().count();
        if name.trim().is_empty() {
            return Err(self.refuse(format!("{} is empty: 1 to {MAX_NAME_LENGTH} characters are needed", self.path)));
        }
        if name.chars().any(is_control) {
            return Err(self.refuse(format!("{} must not contain line breaks or control characters", self.path)));
        }
        if length > MAX_NAME_LENGTH {
            let message = format!("{} has {length} characters: at most {MAX_NAME_LENGTH} are possible", self.path);
            return Err(self.refuse(message));
        }
        Ok(name.to_owned())
    }

    /// Index of one of the key's words.
    pub fn choice(&self) -> Result<usize, SceneError> {
        let Values::Choice(words) = self.key.values else { unreachable!("{} has no words", self.path) };
        let text = self.text()?;
        words.iter().position(|word| *word == text).ok_or_else(|| {
            let text = clipped(text);
            self.refuse(format!("{}: unknown value `{text}`{}", self.path, suggest(&text, words)))
        })
    }

    /// A list of pairs of names, with their places.
    pub fn pairs(&self) -> Result<Vec<Spanned<[&'text str; 2]>>, SceneError> {
        let pair = |value: &'text Value<'text>| {
            let label = format!("each entry of {}", self.path);
            let names = self.fixed(value, &label, 2, "names")?;
            Ok(Spanned::new(value.span(), [self.text_of(&names[0])?, self.text_of(&names[1])?]))
        };
        self.list()?.iter().map(pair).collect()
    }

    /// A list with a number of entries that the key allows.
    fn list(&self) -> Result<&'text [Value<'text>], SceneError> {
        let DeValue::Array(list) = self.value.get_ref() else { return Err(self.wrong_kind(self.value, "a list")) };
        let count = self.key.count().unwrap_or_else(|| panic!("{} is a list", self.path));
        let entries = if list.len() == 1 { "entry" } else { "entries" };
        let bound = if list.len() < *count.start() {
            format!("at least {}", count.start())
        } else if list.len() > *count.end() {
            format!("at most {}", count.end())
        } else {
            return Ok(list);
        };
        Err(self.refuse(format!("{} has {} {entries}: it must have {bound}", self.path, list.len())))
    }

    fn table(&self, declared: &'static str, value: &'text Value<'text>) -> Result<Table<'text>, SceneError> {
        let DeValue::Table(entries) = value.get_ref() else { return Err(self.wrong_kind(value, "a table")) };
        let (source, path, header) = (self.source, self.path.clone(), Some(value.span()));
        Table { source, declared, path, header, entries }.checked()
    }

    /// A list of so many entries.
    fn fixed(
        &self,
        value: &'text Value<'text>,
        label: &str,
        length: usize,
        entries: &str,
    ) -> Result<&'text [Value<'text>], SceneError> {
        match value.get_ref() {
            DeValue::Array(list) if list.len() == length => Ok(list),
            DeValue::Array(list) => {
                let message = format!("{label} must have {length} {entries}, not {}", list.len());
                Err(self.source.error(value.span(), message))
            }
            other => {
                let message = format!("{label} must be a list of {length} {entries}, not {}", kind(other));
                Err(self.source.error(value.span(), message))
            }
        }
    }

    fn vector_of<const N: usize>(
        &self,
        value: &'text Value<'text>,
        label: &str,
        range: Range,
    ) -> Result<[f64; N], SceneError> {
        let mut vector = [0.0; N];
        for (number, value) in vector.iter_mut().zip(self.fixed(value, label, N, "numbers")?) {
            *number = self.number_of(value, range)?;
        }
        Ok(vector)
    }

    fn number_of(&self, value: &Value, range: Range) -> Result<f64, SceneError> {
        let number = match value.get_ref() {
            // Integers and floats beyond all ranges count as infinite.
            DeValue::Integer(integer) => {
                i128::from_str_radix(integer.as_str(), integer.radix()).map_or(f64::INFINITY, |integer| integer as f64)
            }
            DeValue::Float(float) => float.as_str().parse().unwrap_or(f64::NAN),
            _ => return Err(self.wrong_kind(value, "a number")),
        };
        if range.contains(number) {
            return Ok(number);
        }
        let unit = if self.key.unit.is_empty() { String::new() } else { format!(" {}", self.key.unit) };
        Err(self.source.error(value.span(), format!("{} must lie {range}{unit}", self.subject(value))))
    }

    fn text_of(&self, value: &'text Value<'text>) -> Result<&'text str, SceneError> {
        value.get_ref().as_str().ok_or_else(|| self.wrong_kind(value, "text in quotes"))
    }

    fn wrong_kind(&self, value: &Value, wanted: &str) -> SceneError {
        let message = format!("{} must be {wanted}, not {}", self.subject(value), kind(value.get_ref()));
        self.source.error(value.span(), message)
    }

    /// The entry, or a value within it, at the beginning of a message.
    fn subject(&self, value: &Value) -> String {
        let written = clipped(&self.source.text[value.span()]);
        match value.get_ref() {
            DeValue::Array(_) | DeValue::Table(_) if value.span() == self.span() => self.path.clone(),
            _ if value.span() == self.span() => format!("{} = {written}:", self.path),
            _ => format!("{}: {written}", self.path),
        }
    }
}

/// The one table of a scene that has a key, if only one has it.
fn owner(name: &str) -> Option<&'static str> {
    let mut tables = keys::keys().iter().filter(|key| key.name == name && key.table != "homotopy").map(|key| key.table);
    match (tables.next(), tables.next()) {
        (Some("part"), None) => Some("body.part] or [environment.part"),
        (Some(table), None) if !table.is_empty() => Some(table),
        _ => None,
    }
}

/// Numbers that are only bounded to be finite, as their norm is checked afterwards.
const COMPONENT: Range = Range::closed(-1e3, 1e3);

/// Whether a character breaks a line or does not show.
pub fn is_control(character: char) -> bool {
    character.is_control() || matches!(character, '\u{2028}' | '\u{2029}')
}

/// What a value is, in words.
fn kind(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "text in quotes",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
