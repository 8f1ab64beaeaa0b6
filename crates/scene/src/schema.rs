//! JSON schemas (draft 2020-12) of scene and homotopy files, made of the declared keys. Editors complete and check files
//! with them; only the program itself also knows norms, names, files and meshes.
//!
//! They use only what all drafts since the sixth have in common: editors know older ones.

use serde_json::{Map, Value, json};

use crate::ipopt;
use crate::keys::{self, Absent, Form, Key, MAX_NAME_LENGTH, Values};
use crate::part::{COMPANIONS, SHAPES};
use crate::pose::NORM_TOLERANCE;
use crate::range::Range;

const DRAFT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The schema of scene files.
pub fn scene_schema() -> Value {
    file("scene of assembly-plan", Form::scene())
}

/// The schema of homotopy files.
pub fn homotopy_schema() -> Value {
    file("homotopy of assembly-plan", Form::homotopy())
}

fn file(title: &str, form: Form) -> Value {
    let mut schema = table("", form.top);
    schema["$schema"] = DRAFT.into();
    schema["title"] = title.into();
    schema
}

/// A table with no keys but the declared ones. `path` is its name, empty at the top of a file.
fn table(path: &str, declared: &[Key]) -> Value {
    let keys = || declared.iter().filter(|key| path != "ipopt" || ipopt::refusal(key.name).is_none());
    let properties: Map<String, Value> = keys().map(|key| (key.name.to_owned(), property(key))).collect();
    let needed: Vec<&str> = keys().filter(|key| key.absent == Absent::Refused).map(|key| key.name).collect();
    let mut schema = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !needed.is_empty() {
        schema["required"] = needed.into();
    }
    match path {
        // A scene; homotopy files have no body.
        "" if keys().any(|key| key.name == "body") => {
            let table = json!({ "required": ["homotopy"], "properties": { "homotopy": { "type": "object" } } });
            schema["anyOf"] = json!([{ "not": { "required": ["ipopt"] } }, table]);
        }
        "part" => schema["oneOf"] = SHAPES.iter().map(|shape| only(shape)).collect(),
        "robustness" => {
            schema["not"] = json!({ "anyOf": [
            { "required": ["offset_directions", "coverage"] },
            { "required": ["offset_directions", "insertion_axis"] },
            { "required": ["insertion_axis", "coverage"], "properties": { "coverage": { "const": "ball" } } },
            { "required": ["rotation_axes"], "not": { "required": ["offset_directions"] } },
        ] })
        }
        "ipopt" => schema["maxProperties"] = ipopt::MOST_ENTRIES.into(),
        _ => {}
    }
    schema
}

/// A part of this shape and no other.
fn only(shape: &str) -> Value {
    let companion = |shape: &str| COMPANIONS.iter().find(|(key, _)| *key == shape).map(|(_, companion)| *companion);
    let keys = |shape: &'static str| [Some(shape), companion(shape)].into_iter().flatten();
    let (these, others): (Vec<&'static str>, Vec<&'static str>) = SHAPES.into_iter().partition(|other| *other == shape);
    let needed: Vec<&str> = these.into_iter().flat_map(keys).collect();
    let excluded: Vec<Value> = others.into_iter().flat_map(keys).map(|key| json!({ "required": [key] })).collect();
    json!({ "required": needed, "not": { "anyOf": excluded } })
}

/// The value of a key, and what it means.
fn property(key: &Key) -> Value {
    let mut schema = values(key);
    let Key { values, unit, absent, meaning, .. } = key;
    let unit = if unit.is_empty() { String::new() } else { format!(" ({unit})") };
    let absent = if *absent == Absent::Refused { absent.to_string() } else { format!("by default: {absent}") };
    // Editors show descriptions as they are, without Markdown.
    let text = format!("{}\n\n{values}{unit}; {absent}", without_reference(meaning));
    schema["description"] = text.replace('`', "").into();
    if let Some(default) = default(key) {
        schema["default"] = default;
    }
    schema
}

/// The meaning of a key without its reference to a page, which stands last.
fn without_reference(meaning: &str) -> &str {
    match meaning.rsplit_once("; [") {
        Some((own, reference)) if reference.contains("](") => own,
        _ => meaning,
    }
}

/// The default of a key, where it is a value that could be written.
fn default(key: &Key) -> Option<Value> {
    match (&key.values, key.absent) {
        (Values::Integer(_), Absent::Number(default)) => Some((default as i64).into()),
        (Values::Number(_) | Values::NumberOrMatrix(_), Absent::Number(default)) => Some(default.into()),
        (Values::Choice(words), Absent::Means(default)) => {
            words.iter().find(|word| default == format!("`{word}`")).map(|word| (*word).into())
        }
        _ => None,
    }
}

fn values(key: &Key) -> Value {
    // Norms are checked by the program.
    let component = Range::closed(-1.0 - NORM_TOLERANCE, 1.0 + NORM_TOLERANCE);
    match &key.values {
        Values::Number(range) => number(*range),
        Values::Integer(range) => integer(*range),
        Values::Length(range) => {
            json!({ "anyOf": [number(*range), { "type": "string", "pattern": length_pattern() }] })
        }
        Values::Vector(range) => vector(*range),
        Values::Numbers(range, count) => list(number(*range), count.clone()),
        Values::NumberOrNumbers(range, count) => {
            json!({ "anyOf": [number(*range), list(number(*range), count.clone())] })
        }
        Values::Vectors(range, count) => list(vector(*range), count.clone()),
        Values::Direction => vector(component),
        Values::Directions(count) => list(vector(component), count.clone()),
        Values::Quaternion => list(number(component), 4..=4),
        Values::Matrix(range) => json!({ "anyOf": [vector(*range), matrix(*range)] }),
        Values::NumberOrMatrix(range) => json!({ "anyOf": [number(*range), vector(*range), matrix(*range)] }),
        Values::Inertia(range) => list(list(number(*range), 6..=6), 6..=6),
        Values::Choice(words) => {
            let possible = words.iter().filter(|word| ipopt::refusal_of_choice(key, word).is_none());
            json!({ "type": "string", "enum": possible.collect::<Vec<_>>() })
        }
        Values::Name => json!({ "type": "string", "minLength": 1, "maxLength": MAX_NAME_LENGTH, "pattern": "\\S" }),
        Values::File => json!({ "type": "string", "minLength": 1 }),
        Values::FileOrTable => {
            // Keywords for strings do not apply to tables, nor the reverse.
            let mut either = table(&key.path(), keys::table(&key.path()));
            either["type"] = json!(["string", "object"]);
            either["minLength"] = 1.into();
            either
        }
        Values::Pairs(count) => list(list(json!({ "type": "string" }), 2..=2), count.clone()),
        Values::Table => table(&key.path(), keys::table(&key.path())),
        Values::Tables(count) => list(table(key.name, keys::table(key.name)), count.clone()),
    }
}

/// A number and its unit.
fn length_pattern() -> String {
    format!("^\\s*[0-9.eE+-]+\\s*({})\\s*$", keys::UNITS.join("|"))
}

fn number(range: Range) -> Value {
    let mut schema = json!({ "type": "number" });
    let ends = [
        (range.low, if range.includes_low { "minimum" } else { "exclusiveMinimum" }),
        (range.high, if range.includes_high { "maximum" } else { "exclusiveMaximum" }),
    ];
    for (end, keyword) in ends.into_iter().filter(|(end, _)| end.is_finite()) {
        schema[keyword] = end.into();
    }
    schema
}

fn integer(range: Range) -> Value {
    json!({ "type": "integer", "minimum": range.low as i64, "maximum": range.high as i64 })
}

fn list(items: Value, count: std::ops::RangeInclusive<usize>) -> Value {
    json!({ "type": "array", "items": items, "minItems": count.start(), "maxItems": count.end() })
}

fn vector(range: Range) -> Value {
    list(number(range), 3..=3)
}

/// The rows of a matrix whose principal values lie in a range: no entry of it is larger.
fn matrix(range: Range) -> Value {
    list(vector(Range::closed(-range.high, range.high)), 3..=3)
}
