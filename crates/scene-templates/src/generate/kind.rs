//! Which cross-section a peg has.

use std::f64::consts::PI;

use fastrand::Rng;
use scene::Range;

use super::section::Section;
use super::{LENGTH, PegError, metres, metres_within, random, require, within};

/// Cross-section of a peg. Lengths are in metres.
#[derive(Debug, Clone, PartialEq)]
pub enum PegSection {
    /// A union of convex polygons, drawn at random.
    Random {
        /// The same seed gives the same section and start poses.
        seed: u64,
        /// Number of convex polygons.
        prisms: usize,
        /// Number of edges of the union.
        facets: usize,
        /// Diameter of the circle that holds it.
        diameter: f64,
    },
    /// A regular polygon around a circle.
    Round {
        /// Diameter of the circle.
        diameter: f64,
        /// Number of edges of the polygon.
        facets: usize,
        /// A key on one side.
        key: Option<PegKey>,
    },
    /// A rectangle.
    Rectangular {
        /// Length along x.
        width: f64,
        /// Length along y.
        depth: f64,
        /// A key on the side across the x axis.
        key: Option<PegKey>,
    },
}

/// A rectangular key along a peg. Lengths are in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PegKey {
    /// Its width.
    pub width: f64,
    /// How far it stands out of the peg.
    pub height: f64,
}

const FACETS: Range = Range::closed(3.0, 64.0);
const PRISMS: Range = Range::closed(1.0, 8.0);

impl PegSection {
    pub(super) fn check(&self) -> Result<(), PegError> {
        let facets_within = |facets: usize| within(FACETS, "facets", facets as f64);
        match *self {
            Self::Random { prisms, facets, diameter, .. } => {
                within(PRISMS, "prisms", prisms as f64)?;
                facets_within(facets)?;
                metres_within(LENGTH, "diameter", diameter)
            }
            Self::Round { diameter, facets, key } => {
                facets_within(facets)?;
                metres_within(LENGTH, "diameter", diameter)?;
                key.map_or(Ok(()), |key| key.check(diameter))
            }
            Self::Rectangular { width, depth, key } => {
                metres_within(LENGTH, "width", width)?;
                metres_within(LENGTH, "depth", depth)?;
                key.map_or(Ok(()), |key| key.check(depth))
            }
        }
    }

    /// The section itself, such that there is a hole with this clearance and with these chamfers (m) around it.
    pub(super) fn section(&self, rng: &mut Rng, clearance: f64, chamfer: f64) -> Result<Section, PegError> {
        let with_key = |core: Section, key: Option<PegKey>| match key {
            Some(key) => core.with_key(key.width, key.height, clearance + chamfer).ok_or_else(|| PegError {
                name: "key width",
                value: metres(key.width),
                rule: "leaves too little of the peg's side beside the key; choose a narrower key".to_owned(),
            }),
            None => Ok(core),
        };
        match *self {
            Self::Random { prisms, facets, diameter, .. } => {
                let moves = [-chamfer, clearance, clearance + chamfer];
                random::section(rng, diameter, prisms, facets, &moves).ok_or_else(|| {
                    let rule = format!(
                        "hardly any section has this many, {facets} facets and these sizes; choose fewer prisms, other \
                         facets, or less clearance and chamfer"
                    );
                    PegError { name: "prisms", value: prisms.to_string(), rule }
                })
            }
            Self::Round { diameter, facets, key } => with_key(Section::round(diameter, facets), key),
            Self::Rectangular { width, depth, key } => with_key(Section::rectangle(width, depth), key),
        }
    }

    pub(super) fn key(&self) -> Option<PegKey> {
        match *self {
            Self::Random { .. } => None,
            Self::Round { key, .. } | Self::Rectangular { key, .. } => key,
        }
    }

    /// Smallest width without a key (m).
    pub(super) fn smallest_width(&self) -> f64 {
        match *self {
            Self::Random { diameter, .. } | Self::Round { diameter, .. } => diameter,
            Self::Rectangular { width, depth, .. } => width.min(depth),
        }
    }

    /// Offset magnitude, as a fraction of the smallest width: of a random peg, that of the paper's.
    pub(super) fn usual_offset(&self) -> f64 {
        if matches!(self, Self::Random { .. }) { 0.22 } else { 0.25 }
    }

    /// Name of the body part that a piece becomes.
    pub(super) fn name_of(&self, piece: usize) -> String {
        match (self, self.key()) {
            (Self::Random { .. }, _) => format!("prism{}", piece + 1),
            (_, Some(_)) if piece == 1 => "key".to_owned(),
            _ => "shaft".to_owned(),
        }
    }

    /// Description of the section, in lines of text. `clearance` (m) is that of the hole.
    pub(super) fn about(&self, clearance: f64) -> Vec<String> {
        let keyed = |key: Option<PegKey>| match key {
            Some(key) => format!("with a key of {} x {} m", key.width, key.height),
            None => "without a key".to_owned(),
        };
        match *self {
            Self::Random { seed, prisms, facets, diameter } => vec![format!(
                "A random peg (seed {seed}): {prisms} convex prisms with {facets} sides, {} m in diameter.",
                diameter
            )],
            Self::Round { diameter, facets, key } => {
                let hole = (diameter + 2.0 * clearance) / (PI / facets as f64).cos();
                vec![
                    format!("A round peg of {} m, {}, as a prism with {facets} sides around it.", diameter, keyed(key)),
                    format!(
                        "The sides of its hole are inside a round hole of {hole:.6} m: the plan holds for this one"
                    ),
                    "and for larger ones.".to_owned(),
                ]
            }
            Self::Rectangular { width, depth, key } => {
                vec![format!("A rectangular peg of {} x {} m, {}.", width, depth, keyed(key))]
            }
        }
    }
}

impl PegKey {
    /// Whether the key fits onto a peg of some width (m).
    fn check(&self, width: f64) -> Result<(), PegError> {
        require(self.width > 0.0 && self.width <= width, "key width", self.width, || {
            format!("must be above 0 and at most {} m, the peg's side", metres(width))
        })?;
        require(self.height > 0.0 && self.height <= width, "key height", self.height, || {
            format!("must be above 0 and at most {} m, the peg's side", metres(width))
        })
    }
}
