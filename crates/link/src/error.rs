//! What is wrong with a model file.

use std::ops::Range;

/// What is wrong with a model file, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ModelError {
    message: String,
    span: Range<usize>,
}

impl ModelError {
    /// An error about a range of bytes of the file.
    pub(crate) fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Self { message: message.into(), span }
    }

    /// Place in the file (bytes).
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }
}
