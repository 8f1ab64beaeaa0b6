//! Hashes that identify content.

use sha2::{Digest, Sha256};
use simulation::Reference;

/// Hash (SHA-256, hexadecimal) of some bytes.
pub fn hash(content: &[u8]) -> String {
    let mut hasher = Hasher::default();
    hasher.add(content);
    hasher.finish()
}

/// Hash (SHA-256, hexadecimal) of a reference motion.
pub fn reference_hash(reference: &Reference) -> String {
    let mut hasher = Hasher::default();
    hasher.add(&reference.time_step().to_le_bytes());
    for number in reference.states().iter().flat_map(|state| state.0) {
        hasher.add(&number.to_le_bytes());
    }
    hasher.finish()
}

/// The same hash of content that comes in pieces.
#[derive(Debug, Clone, Default)]
pub struct Hasher(Sha256);

impl Hasher {
    /// Adds a piece.
    pub fn add(&mut self, piece: &[u8]) {
        self.0.update(piece);
    }

    /// The hash of all pieces.
    pub fn finish(self) -> String {
        self.0.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
    }
}
