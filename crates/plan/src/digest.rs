//! Hashes that identify content.

use sha2::{Digest, Sha256};

/// Hash (SHA-256, hexadecimal) of some bytes.
pub fn hash(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}
