//! Texts with changed words and numbers.

use proptest::prelude::*;

/// Values that are put in the place of others.
const VALUES: &[&str] = &[
    "nan",
    "NaN",
    "inf",
    "-inf",
    "1e300",
    "-1e300",
    "-0.0",
    "0",
    "1e-300",
    "5e-324",
    "1",
    "-1",
    "2",
    "1e-9",
    "1e7",
    "1e999",
    "4294967295",
    "18446744073709551615",
    "99999999999999999999999",
    "-9223372036854775808",
    "0.5",
    "null",
    "true",
    "\"x\"",
    "\"\"",
    "\"../../x\"",
    "[]",
    "{}",
    "[0, 0, 0]",
    "\n",
    ",",
    "",
    "é",
    "\0",
];

/// A change of a text; places are counted in tokens, beyond the last one from the first again.
#[derive(Debug, Clone)]
pub enum Mutation {
    Delete(usize),
    Duplicate(usize),
    Replace(usize, &'static str),
    ReplaceNumber(usize, &'static str),
    Scale(usize, f64),
    Swap(usize, usize),
    DeleteLine(usize),
    DuplicateLine(usize),
    Cut(usize),
}

pub fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<usize>();
    let value = prop::sample::select(VALUES);
    prop_oneof![
        1 => at.prop_map(Mutation::Delete),
        1 => at.prop_map(Mutation::Duplicate),
        2 => (at, value.clone()).prop_map(|(at, value)| Mutation::Replace(at, value)),
        8 => (at, value).prop_map(|(at, value)| Mutation::ReplaceNumber(at, value)),
        6 => (at, -4.0..4.0f64).prop_map(|(at, exponent)| Mutation::Scale(at, 10_f64.powf(exponent))),
        1 => (at, at).prop_map(|(one, other)| Mutation::Swap(one, other)),
        1 => at.prop_map(Mutation::DeleteLine),
        1 => at.prop_map(Mutation::DuplicateLine),
        1 => at.prop_map(Mutation::Cut),
    ]
}

/// A text after some changes.
pub fn mutated(text: &str, mutations: Vec<Mutation>) -> String {
    let mut tokens = tokens(text);
    for mutation in mutations {
        if !tokens.is_empty() {
            apply(&mut tokens, mutation);
        }
    }
    tokens.concat()
}

/// Numbers, words, quoted texts, and every other character for itself.
fn tokens(text: &str) -> Vec<String> {
    let is_word = |letter: char| letter.is_alphanumeric() || "_-+.".contains(letter);
    let mut tokens: Vec<String> = Vec::new();
    let mut is_open = false;
    for letter in text.chars() {
        match tokens.last_mut() {
            Some(token) if is_open || is_word(letter) && token.chars().all(is_word) => token.push(letter),
            _ => tokens.push(letter.to_string()),
        }
        is_open = is_open != (letter == '"');
    }
    tokens
}

fn apply(tokens: &mut Vec<String>, mutation: Mutation) {
    let count = tokens.len();
    let is_number = |token: &String| token.parse::<f64>().is_ok_and(f64::is_finite);
    let numbers: Vec<usize> = (0..count).filter(|&index| is_number(&tokens[index])).collect();
    let number = |at: usize| numbers.get(at % numbers.len().max(1)).copied();
    let line = |at: usize| {
        let begin = tokens[..at % count].iter().rposition(|token| token == "\n").map_or(0, |end| end + 1);
        let end = tokens[begin..].iter().position(|token| token == "\n").map_or(count, |length| begin + length + 1);
        begin..end
    };
    match mutation {
        Mutation::Delete(at) => drop(tokens.remove(at % count)),
        Mutation::Duplicate(at) => tokens.insert(at % count, tokens[at % count].clone()),
        Mutation::Replace(at, value) => tokens[at % count] = value.to_owned(),
        Mutation::ReplaceNumber(at, value) => {
            if let Some(index) = number(at) {
                tokens[index] = value.to_owned();
            }
        }
        Mutation::Scale(at, factor) => {
            if let Some(index) = number(at) {
                tokens[index] = (factor * tokens[index].parse::<f64>().unwrap()).to_string();
            }
        }
        Mutation::Swap(one, other) => tokens.swap(one % count, other % count),
        Mutation::DeleteLine(at) => drop(tokens.drain(line(at))),
        Mutation::DuplicateLine(at) => {
            let line = line(at);
            let copy = tokens[line.clone()].to_vec();
            tokens.splice(line.start..line.start, copy);
        }
        Mutation::Cut(at) => tokens.truncate(at % count),
    }
}
