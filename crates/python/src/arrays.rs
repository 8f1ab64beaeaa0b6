//! Arrays of numbers as bytes in native byte order, which is how they pass between Rust and NumPy.

use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Bytes of a number.
const SIZE: usize = size_of::<f64>();

/// The bytes of some numbers.
pub fn bytes<'py>(py: Python<'py>, numbers: &[f64]) -> PyResult<Bound<'py, PyBytes>> {
    PyBytes::new_with(py, SIZE * numbers.len(), |target| {
        for (target, number) in target.chunks_exact_mut(SIZE).zip(numbers) {
            target.copy_from_slice(&number.to_ne_bytes());
        }
        Ok(())
    })
}

/// The rows of an array that was checked to have this number of columns.
pub fn rows<const COLUMNS: usize>(bytes: &[u8]) -> Vec<[f64; COLUMNS]> {
    let number = |bytes: &[u8]| bytes.try_into().map_or(f64::NAN, f64::from_ne_bytes);
    let row = |row: &[u8]| std::array::from_fn(|column| number(&row[SIZE * column..][..SIZE]));
    bytes.chunks_exact(SIZE * COLUMNS).map(row).collect()
}
