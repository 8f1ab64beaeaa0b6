//! Values of a TOML file with their places, read as their declared keys want them.

use std::ops::Range as Span;
use std::path::PathBuf;

use toml::Spanned;
use toml::de::{DeString, DeValue};

use crate::error::{SceneError, Source};
use crate::keys::{Key, MAX_NAME_LENGTH, SCALES, UNITS, Values};
use crate::range::Range;
use crate::words::{clipped, suggest};

/// A value with its place.
pub type Value<'text> = Spanned<DeValue<'text>>;

/// The value of a key.
pub struct Entry<'text> {
    source: Source<'text>,
    key: &'static Key,
    /// Name of the key with its tables.
    path: String,
    /// Place of the key's name.
    name: Span<usize>,
    value: &'text Value<'text>,
}

impl<'text> Entry<'text> {
    /// The value of a key in a table whose name in messages is `table`, empty for the top of a file.
    pub fn new(
        source: Source<'text>,
        key: &'static Key,
        table: &str,
        (name, value): (&Spanned<DeString>, &'text Value<'text>),
    ) -> Self {
        let path = if table.is_empty() { key.name.to_owned() } else { format!("{table}.{}", key.name) };
        Self { source, key, path, name: name.span(), value }
    }

    /// The file.
    pub fn source(&self) -> Source<'text> {
        self.source
    }

    /// Place of the value.
    pub fn span(&self) -> Span<usize> {
        self.value.span()
    }

    /// The declaration of the key.
    pub fn key(&self) -> &'static Key {
        self.key
    }

    /// Name of the key with its tables.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The value as it was parsed.
    pub fn value(&self) -> &'text Value<'text> {
        self.value
    }

    /// An error about the key.
    pub fn refuse_name(&self, message: impl Into<String>) -> SceneError {
        self.source.error(self.name.clone(), message)
    }

    /// An error about the value.
    pub fn refuse(&self, message: impl Into<String>) -> SceneError {
        self.source.error(self.span(), message)
    }

    /// A number in the key's range.
    pub fn number(&self) -> Result<f64, SceneError> {
        self.number_of(self.value, self.key.bounds())
    }

    /// A length (m) in the key's range: a number, or a text with its unit such as `"0.02 mm"`.
    pub fn length(&self) -> Result<f64, SceneError> {
        let Some(text) = self.value.get_ref().as_str() else { return self.number() };
        let wanted = || {
            let units = UNITS.join(", ");
            self.refuse(format!(
                "{} must be a number (m) or a number with its unit ({units}), as \"0.02 mm\"",
                self.path
            ))
        };
        let text = text.trim();
        let end = text.find(|letter: char| letter.is_ascii_alphabetic() && letter != 'e').ok_or_else(wanted)?;
        let unit = UNITS.iter().position(|unit| *unit == &text[end..]).ok_or_else(wanted)?;
        let number: f64 = text[..end].trim().parse().map_err(|_| wanted())?;
        let length = number * SCALES[unit];
        let range = self.key.bounds();
        if range.contains(length) { Ok(length) } else { Err(self.refuse(format!("{} must lie {range} m", self.path))) }
    }

    /// An integer in the key's range.
    pub fn integer(&self) -> Result<i64, SceneError> {
        match self.value.get_ref() {
            DeValue::Integer(_) => self.number().map(|number| number as i64),
            DeValue::Float(_) => Err(self.refuse(format!("{} must be an integer", self.subject(self.value)))),
            _ => Err(self.wrong_kind(self.value, "an integer")),
        }
    }

    /// Three or four numbers in the key's range.
    pub fn vector<const N: usize>(&self) -> Result<[f64; N], SceneError> {
        self.vector_of(self.value, &self.path, self.key.bounds())
    }

    /// Three numbers, as a unit vector has them.
    pub fn direction(&self) -> Result<[f64; 3], SceneError> {
        self.vector_of(self.value, &self.path, COMPONENT)
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

    /// One number, or a list of numbers, in the key's range.
    pub fn number_or_numbers(&self) -> Result<Vec<f64>, SceneError> {
        if self.value.get_ref().is_array() { self.numbers() } else { Ok(vec![self.number()?]) }
    }

    /// A list of three numbers each, with their places.
    pub fn vectors(&self) -> Result<Vec<Spanned<[f64; 3]>>, SceneError> {
        let range = self.key.range().unwrap_or(COMPONENT);
        let label = format!("each entry of {}", self.path);
        let vector = |value: &Value| Ok(Spanned::new(value.span(), self.vector_of(value, &label, range)?));
        self.list()?.iter().map(vector).collect()
    }

    /// Numbers in the key's range as a diagonal, or the rows of a 3x3 matrix of numbers that are no larger.
    pub fn matrix(&self) -> Result<[[f64; 3]; 3], SceneError> {
        let may_be_number = matches!(self.key.values, Values::NumberOrMatrix(_));
        let words = if may_be_number { "a number, 3 numbers or a 3x3 matrix" } else { "3 numbers or a 3x3 matrix" };
        let rows = match self.value.get_ref() {
            DeValue::Array(rows) => rows,
            DeValue::Integer(_) | DeValue::Float(_) if may_be_number => return Ok(diagonal([self.number()?; 3])),
            _ => return Err(self.wrong_kind(self.value, words)),
        };
        if !rows.iter().any(|row| row.get_ref().is_array()) {
            if rows.len() != 3 {
                return Err(self.refuse(format!("{} must be {words}, not {} numbers", self.path, rows.len())));
            }
            return Ok(diagonal(self.vector()?));
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

    /// The rows of a square matrix of numbers in the key's range.
    pub fn rows<const N: usize>(&self) -> Result<[[f64; N]; N], SceneError> {
        let rows = self.fixed(self.value, &self.path, N, "rows")?;
        let label = format!("each row of {}", self.path);
        let mut matrix = [[0.0; N]; N];
        for (row, value) in matrix.iter_mut().zip(rows) {
            *row = self.vector_of(value, &label, self.key.bounds())?;
        }
        Ok(matrix)
    }

    /// A text.
    pub fn text(&self) -> Result<&'text str, SceneError> {
        self.text_of(self.value)
    }

    /// The path of a file, whose name is relative to the one that names it.
    pub fn file(&self) -> Result<PathBuf, SceneError> {
        let name = self.text()?;
        if name.is_empty() {
            return Err(self.refuse(format!("{} is empty", self.path)));
        }
        let scene = self.source.file;
        Ok(scene.parent().unwrap_or(scene).join(name))
    }

    /// A text in one line that is neither empty nor too long.
    pub fn name(&self) -> Result<String, SceneError> {
        let name = self.text()?;
        let length = name.chars().count();
        if name.trim().is_empty() {
            return Err(self.refuse(format!("{} is empty: 1 to {MAX_NAME_LENGTH} characters are needed", self.path)));
        }
        if name.chars().any(input::is_control) {
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
        let words = self.key.words();
        let Some(text) = self.value.get_ref().as_str() else {
            return Err(self.wrong_kind(self.value, &format!("one of \"{}\"", words.join("\", \""))));
        };
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
    pub fn list(&self) -> Result<&'text [Value<'text>], SceneError> {
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

    /// A list with a given number of entries.
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

    /// An error about a value of the wrong kind.
    pub fn wrong_kind(&self, value: &Value, wanted: &str) -> SceneError {
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

/// Numbers that are only bounded to be finite, as their norm is checked afterwards.
const COMPONENT: Range = Range::closed(-1e3, 1e3);

fn diagonal([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]
}

/// The kind of a value, in words.
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
