//! Assembly of a front from matrix entries, leaves and the next front.

/// A row's position in a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Position in the stage's front.
    Front(usize),
    /// Position in its separator.
    Separator(usize),
}

/// A place of a front: in its store, which is kept for the solves, or in its Schur complement, which is passed to the
/// previous stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Target(u32);

const SCHUR: u32 = 1 << 31;

impl Target {
    /// In the store.
    pub fn store(offset: usize) -> Self {
        Self(offset as u32)
    }

    /// In the Schur complement.
    pub fn schur(offset: usize) -> Self {
        Self(offset as u32 | SCHUR)
    }
}

/// Consecutive values with consecutive targets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    source: u32,
    length: u32,
    target: Target,
}

/// Everything that is added to a front: entries and blocks.
#[derive(Debug, Default)]
pub struct Assembly {
    /// Values of the matrix: target and position.
    entries: Vec<(Target, u32)>,
    /// Schur complements: of every leaf, then of the next stage.
    blocks: Vec<Vec<Run>>,
}

impl Assembly {
    /// Adds an entry of the matrix.
    pub fn add_entry(&mut self, target: Target, source: usize) {
        self.entries.push((target, source as u32));
    }

    /// Adds the lower triangle of a block with a padded stride, whose rows are at `places`; `None` when a coupling has
    /// no place in the layout.
    pub fn add_block(
        &mut self,
        places: &[Place],
        stride: usize,
        target: impl Fn(Place, Place) -> Option<Target>,
    ) -> Option<()> {
        let mut runs: Vec<Run> = Vec::new();
        for column in 0..places.len() {
            let first = runs.len();
            for row in column..places.len() {
                let target = target(places[row], places[column])?;
                match runs[first..].last_mut() {
                    Some(run) if run.target.0 + run.length == target.0 => run.length += 1,
                    _ => runs.push(Run { source: (row + column * stride) as u32, length: 1, target }),
                }
            }
        }
        self.blocks.push(runs);
        Some(())
    }

    /// Adds the values of the matrix.
    pub fn scatter_entries(&self, values: &[f64], store: &mut [f64], schur: &mut [f64]) {
        for &(Target(target), source) in &self.entries {
            let value = values[source as usize];
            if target & SCHUR == 0 {
                store[target as usize] += value;
            } else {
                schur[(target ^ SCHUR) as usize] += value;
            }
        }
    }

    /// Adds a Schur complement: of a leaf, by its number in the stage, or, after these, of the next stage.
    pub fn scatter_block(&self, block: usize, source: &[f64], store: &mut [f64], schur: &mut [f64]) {
        for run in &self.blocks[block] {
            let (length, from, Target(to)) = (run.length as usize, run.source as usize, run.target);
            let target = if to & SCHUR == 0 { &mut store[to as usize..] } else { &mut schur[(to ^ SCHUR) as usize..] };
            for (target, source) in target[..length].iter_mut().zip(&source[from..from + length]) {
                *target += source;
            }
        }
    }
}
