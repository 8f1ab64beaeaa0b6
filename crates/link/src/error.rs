//! Errors in model files.

use std::ops::Range;

/// An error in a model file, with its place.
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
