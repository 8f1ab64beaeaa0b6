//! Coordinates of a sparse matrix that has many contributors.

use std::collections::HashMap;

use nlp::Pattern;

/// Marks an entry that does not exist, because its variable is data (the initial state).
pub const ABSENT: u32 = u32::MAX;

/// Collects distinct coordinates. Every contributor keeps the slots that it adds to.
#[derive(Debug, Default)]
pub struct PatternBuilder {
    slots: HashMap<(u32, u32), u32>,
    pattern: Pattern,
}

impl PatternBuilder {
    /// Slot of an entry of a general matrix; [`ABSENT`] if its row or column is.
    pub fn slot(&mut self, row: u32, column: u32) -> u32 {
        if row == ABSENT || column == ABSENT {
            return ABSENT;
        }
        let next = self.pattern.rows.len() as u32;
        *self.slots.entry((row, column)).or_insert_with(|| {
            self.pattern.rows.push(row as usize);
            self.pattern.columns.push(column as usize);
            next
        })
    }

    /// Slot of an entry of a symmetric matrix, in its lower triangle.
    pub fn symmetric_slot(&mut self, one: u32, other: u32) -> u32 {
        if one == ABSENT || other == ABSENT {
            return ABSENT;
        }
        self.slot(one.max(other), one.min(other))
    }

    /// The coordinates in slot order.
    pub fn finish(self) -> Pattern {
        self.pattern
    }
}

/// The patterns of a problem under construction.
#[derive(Debug, Default)]
pub struct Patterns {
    /// Jacobian of the constraints.
    pub jacobian: PatternBuilder,
    /// Lower triangle of the Hessian of the Lagrangian.
    pub hessian: PatternBuilder,
}

/// Adds a value to a slot unless that is absent.
#[inline]
pub fn add(values: &mut [f64], slot: u32, value: f64) {
    if slot != ABSENT {
        values[slot as usize] += value;
    }
}
