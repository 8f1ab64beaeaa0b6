//! Messages of the TOML parser and of serde, in the words of somebody who writes a scene.

use crate::words::{clipped, clipped_to, suggest};

/// Beginnings of messages of the TOML parser, and their replacements.
const SYNTAX: [(&str, &str); 24] = [
    ("cannot extend value", "the key has a value already"),
    ("cannot recurse", "lists or tables are nested too deeply"),
    ("recursion limit", "lists or tables are nested too deeply"),
    ("extra assignment", "a comma or the closing brace `}` of a table is missing"),
    ("missing comma between key-value", "a comma or the closing brace `}` of a table is missing"),
    ("unclosed inline table", "the closing brace `}` of a table is missing"),
    ("missing comma between array", "a comma or the closing bracket `]` of a list is missing"),
    ("extra comma", "a value is missing before this comma"),
    ("unclosed array table", "the closing brackets `]]` of a header are missing"),
    ("unclosed array", "the closing bracket `]` of a list is missing"),
    ("unclosed table", "the closing bracket `]` of a header is missing"),
    ("unquoted keys cannot be empty", "a key is missing"),
    ("key with no value", "a key needs `=` and a value"),
    ("invalid key-value pair", "a key needs `=` and a value"),
    ("missing escaped value", "a backslash is written `\\\\`, or the text is put in single quotes"),
    ("invalid mantissa", "digits are missing before the decimal point"),
    ("invalid fraction", "digits are missing after the decimal point"),
    ("invalid exponent", "digits are missing after the `e`"),
    ("unexpected leading zero", "a number must not begin with a zero"),
    ("invalid float", "not a finite number"),
    ("unexpected key or value", "the line must end here; decimals are written with a point"),
    ("redundant numeric sign", "a number has one sign at most"),
    ("invalid basic string, expected `\"`", "the closing quote of a text is missing"),
    ("invalid literal string, expected `'`", "the closing quote of a text is missing"),
];

/// Kinds of values as serde calls them, and in plain words.
const KINDS: [(&str, &str); 12] = [
    ("f64", "a number"),
    ("i64", "an integer"),
    ("a string", "text in quotes"),
    ("a sequence", "a list"),
    ("a map", "a table"),
    ("struct", "a table"),
    ("string", "text in quotes"),
    ("integer", "a number"),
    ("floating point", "a number"),
    ("boolean", "true or false"),
    ("sequence", "a list"),
    ("map", "a table"),
];

/// Rewords a message about what is `written` in the file, with the nearest valid key for one that is unknown.
pub fn plain_words(message: &str, written: &str) -> String {
    let mut names = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown field") || message.starts_with("unknown variant") {
        let unknown = clipped(names.next().unwrap_or_default());
        return format!("unknown key `{unknown}`{}", suggest(&unknown, &names.collect::<Vec<_>>()));
    }
    if message.starts_with("missing field") {
        return format!("missing key `{}`", names.next().unwrap_or_default());
    }
    if let Some((found, wanted)) =
        message.strip_prefix("invalid type: ").and_then(|message| message.trim_end().split_once(", expected "))
    {
        let (found, wanted) = (kind(found), kind(wanted));
        return if wanted == "an integer" && found == "a number" {
            format!("{} must be an integer", clipped(written))
        } else {
            format!("must be {wanted}, not {found}")
        };
    }
    syntax(message, &clipped(written))
}

fn syntax(message: &str, written: &str) -> String {
    if message.starts_with("duplicate key") {
        return format!("`{written}` is given twice");
    }
    if message.starts_with("string values must be quoted") {
        return match written.chars().next() {
            None => "a value is missing".to_owned(),
            Some('0'..='9' | '+' | '-' | '.') => {
                format!("`{written}` is not a number; units are left out, and lists need commas")
            }
            Some(_) => format!("text needs quotes: \"{written}\""),
        };
    }
    let plain = SYNTAX.iter().find(|(parser, _)| message.starts_with(parser)).map(|(_, plain)| *plain);
    let message = message.trim_end().trim_end_matches(", expected nothing");
    plain.map_or_else(|| clipped_to(message, 300), str::to_owned)
}

fn kind(kind: &str) -> &str {
    KINDS.iter().find(|(serde, _)| kind.starts_with(serde)).map_or(kind, |(_, plain)| plain)
}
