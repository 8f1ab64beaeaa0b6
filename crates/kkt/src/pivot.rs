//! Pivots of an `L D L'` factorisation: 1x1 and 2x2 blocks and their inertia.

/// Bunch and Kaufman's bound between diagonal and off-diagonal pivots, `(1 + sqrt(17)) / 8`.
pub const BUNCH_KAUFMAN: f64 = 0.640_388_203_202_207_6;

/// If a pivot is below this fraction of the sum of the absolute values of its terms, it may be a rounding error and its
/// sign is not trusted. This is some hundred times the unit roundoff, because sums are long and earlier pivots are
/// rounded too.
pub const TRUST: f64 = 5e-14;

/// The reason why a factorisation by stages has to stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Breakdown {
    /// A pivot is so small compared with its terms that its sign is uncertain.
    Uncertain,
    /// A pivot is not finite.
    NotFinite,
}

/// A block of `D`.
#[derive(Debug, Clone, Copy)]
pub enum Pivot {
    /// `d`
    One(f64),
    /// `[a, b; b, c]`
    Two(f64, f64, f64),
}

impl Pivot {
    /// Number of rows.
    pub fn size(self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Two(..) => 2,
        }
    }

    /// Number of negative eigenvalues, or the reason why it is unknown. `scale` is the sum of the absolute values of
    /// the terms of the diagonal entries.
    pub fn negative(self, scale: [f64; 2]) -> Result<usize, Breakdown> {
        let (value, terms) = match self {
            Self::One(d) => (d, scale[0]),
            Self::Two(a, b, c) => {
                let mixed = 2.0 * b.abs() * (scale[0] * scale[1]).sqrt();
                (a * c - b * b, scale[0] * c.abs() + scale[1] * a.abs() + mixed)
            }
        };
        if !value.is_finite() {
            return Err(Breakdown::NotFinite);
        }
        if value == 0.0 || value.abs() <= TRUST * terms {
            return Err(Breakdown::Uncertain);
        }
        Ok(match self {
            Self::One(d) => usize::from(d < 0.0),
            Self::Two(..) if value < 0.0 => 1,
            Self::Two(a, _, _) => 2 * usize::from(a < 0.0),
        })
    }
}

/// The inverse `[a, b; b, c]` of a 2x2 pivot.
#[inline(always)]
pub fn inverse(a: f64, b: f64, c: f64) -> (f64, f64, f64) {
    // The off-diagonal entry is the largest of a 2x2 pivot: dividing by it first avoids overflow.
    let (p, q) = (a / b, c / b);
    let scale = 1.0 / (b * (p * q - 1.0));
    (q * scale, -scale, p * scale)
}

/// `D^{-1}` of a factorisation and the order of its rows, as slices of a larger store.
#[derive(Debug)]
pub struct Pivots<'a> {
    /// Diagonal of `D^{-1}`.
    pub diagonal: &'a mut [f64],
    /// Subdiagonal of `D^{-1}`: nonzero in the first row of every 2x2 pivot.
    pub subdiagonal: &'a mut [f64],
    /// The row at each place.
    pub order: &'a mut [u32],
}

/// `values := D^{-1} values`, given `D^{-1}`.
#[inline(always)]
pub fn apply_inverse(diagonal: &[f64], subdiagonal: &[f64], values: &mut [f64]) {
    let mut j = 0;
    while j < diagonal.len() {
        if subdiagonal[j] == 0.0 {
            values[j] *= diagonal[j];
            j += 1;
        } else {
            let (a, b, c) = (diagonal[j], subdiagonal[j], diagonal[j + 1]);
            let (u, v) = (values[j], values[j + 1]);
            values[j] = a * u + b * v;
            values[j + 1] = b * u + c * v;
            j += 2;
        }
    }
}
