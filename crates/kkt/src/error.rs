//! Mismatches between a matrix and its labels.

use crate::label::Label;

/// The reason why a matrix cannot be factorised stage by stage.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StructureError {
    /// The number of labels is not the number of rows.
    #[error("{labels} labels for a matrix of {dimension} rows")]
    Dimension {
        /// Number of labels.
        labels: usize,
        /// Rows of the matrix.
        dimension: usize,
    },
    /// The lists of rows and columns differ in length.
    #[error("{rows} row indices but {columns} column indices")]
    Length {
        /// Number of row indices.
        rows: usize,
        /// Number of column indices.
        columns: usize,
    },
    /// An entry lies outside the matrix.
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
    /// A stage is numbered 0; stages start at 1.
    #[error("row {row} is labelled {label}: stages are numbered from 1")]
    Stage {
        /// The row.
        row: usize,
        /// Its label.
        label: Label,
    },
    /// An entry couples rows that the elimination assumes to be independent.
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
        /// The rule that the entry violates.
        reason: &'static str,
    },
}
