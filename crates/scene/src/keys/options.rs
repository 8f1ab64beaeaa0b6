//! Options of Ipopt by their own names, as keys of the table `ipopt`.

use std::sync::LazyLock;

use super::Absent::Means;
use super::{Key, Values};
use crate::range::Range;

/// Integers that Ipopt can represent.
const INTEGERS: Range = Range::closed(i32::MIN as f64, i32::MAX as f64);

static OPTIONS: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let lines = include_str!("../ipopt_options.txt").lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| row(line).expect("the table is written by a script")).collect()
});

/// All options of Ipopt, also those that only some versions have.
pub fn options() -> &'static [Key] {
    &OPTIONS
}

fn row(line: &'static str) -> Option<Key> {
    let (name, rest) = line.split_once(' ')?;
    let (kind, values) = rest.split_once(' ')?;
    let values = match kind {
        "integer" => Values::Integer(within_integers(Range::parse(values)?)),
        "number" => Values::Number(Range::parse(values)?),
        _ => Values::Choice(values.split(' ').collect::<Vec<_>>().leak()),
    };
    Some(Key {
        table: "ipopt",
        name,
        values,
        unit: "",
        absent: Means("Ipopt's default"),
        meaning: "an option of Ipopt",
    })
}

fn within_integers(range: Range) -> Range {
    Range::closed(range.low.max(INTEGERS.low), range.high.min(INTEGERS.high))
}
