//! Settings of covers and their ranges.

use std::ops::RangeInclusive;

use crate::error::MeshError;

/// Allowed facets per full turn.
const FACETS: RangeInclusive<usize> = 3..=360;

/// How to cover a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoverSettings {
    /// Facets per full turn of curved surfaces, 3 to 360.
    pub facets: usize,
    /// Distance (m) between a curved surface and its facets that is small enough: surfaces that keep it with fewer facets
    /// have fewer. Zero if all shall have as many.
    pub error: f64,
    /// Distance (m) by which pieces may be larger than the faceted part to have fewer halfspaces; zero for none.
    pub tolerance: f64,
    /// Lower and upper corner (m) of a box outside of which the part is left out.
    pub crop: Option<[[f64; 3]; 2]>,
    /// Distance (m) by which all surfaces are moved into the material.
    pub clearance: f64,
    /// Largest number of cells of the partition; covering a part with more takes too long.
    pub most_cells: usize,
}

impl Default for CoverSettings {
    fn default() -> Self {
        Self { facets: 24, error: 0.0, tolerance: 0.0, crop: None, clearance: 0.0, most_cells: 2500 }
    }
}

impl CoverSettings {
    /// Checks the ranges.
    ///
    /// # Errors
    /// With the first setting that is out of its range.
    pub(crate) fn check(&self) -> Result<(), MeshError> {
        if !FACETS.contains(&self.facets) {
            return Err(MeshError::Setting { name: "facets", value: self.facets as f64, range: "3 to 360" });
        }
        for (name, value) in [("error", self.error), ("tolerance", self.tolerance), ("clearance", self.clearance)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(MeshError::Setting { name, value, range: "zero or a positive length" });
            }
        }
        let not_finite = self.crop.iter().flatten().flatten().find(|coordinate| coordinate.is_nan());
        not_finite
            .map_or(Ok(()), |&value| Err(MeshError::Setting { name: "crop", value, range: "two corners of a box" }))
    }
}
