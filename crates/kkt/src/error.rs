//! Why a matrix does not have the structure of its labels.

use crate::label::Label;

/// Why a matrix cannot be factorised stage by stage.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StructureError {
    /// The labels are of another problem.
    #[error("{labels} labels for a matrix of {dimension} rows")]
    Dimension {
        /// Number of labels.
        labels: usize,
        /// Rows of the matrix.
        dimension: usize,
    },
    /// Row and column numbers do not come in pairs.
    #[error("{rows} row numbers but {columns} column numbers")]
    Length {
        /// Number of row numbers.
        rows: usize,
        /// Number of column numbers.
        columns: usize,
    },
    /// An entry lies outside of the matrix.
    #[error("entry {entry} lies in row {row}, column {column} of a matrix of {dimension} rows")]
    Range {
        /// Position among the triplets.
        entry: usize,
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Rows of the matrix.
        dimension: usize,
    },
    /// Stages are numbered from 1.
    #[error("row {row} is labelled as {label}: stages count from 1")]
    Stage {
        /// The row.
        row: usize,
        /// Its label.
        label: Label,
    },
    /// An entry couples rows that the elimination takes for independent.
    #[error("row {row} and column {column} couple {first} with {second}: {reason}")]
    Coupling {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Label of the row.
        first: Label,
        /// Label of the column.
        second: Label,
        /// The rule that this breaks.
        reason: &'static str,
    },
}
