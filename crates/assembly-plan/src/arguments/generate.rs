//! What the user can say of pegs.

use std::path::PathBuf;

use clap::{ArgGroup, Args, Subcommand};
use scene_templates::{Peg, PegKey, PegSection};

use crate::values::{self, not_negative, positive};

#[derive(Debug, Args)]
pub struct GenerateArguments {
    #[command(subcommand)]
    pub kind: Kind,
}

#[derive(Debug, Subcommand)]
pub enum Kind {
    /// A union of convex prisms with random sections, like the paper's pegs
    Random(RandomArguments),
    /// A round peg, as a prism around it
    Round(RoundArguments),
    /// A rectangular peg
    Rectangular(RectangularArguments),
    /// A round or rectangular peg with a key along one side
    Keyed(KeyedArguments),
}

/// What all pegs have. All lengths are in metres.
#[derive(Debug, Args)]
pub struct PegArguments {
    /// Length of the peg (m) [default: 0.1 of a random one, else 0.04]
    #[arg(long, value_name = "M", value_parser = positive)]
    length: Option<f64>,
    /// Distance between the sides of peg and hole (m) [default: 0.0008 of a random one, else 0.0003]
    #[arg(long, value_name = "M", value_parser = positive)]
    clearance: Option<f64>,
    /// Bevel of the peg's lower and of the hole's upper edge (m)
    #[arg(long, value_name = "M", default_value_t = 0.0, value_parser = not_negative)]
    chamfer: f64,
    /// How far the peg may be off in the gripper (m) [default: a quarter of its width; 0.22 of a random one's]
    #[arg(long, value_name = "M", value_parser = positive)]
    offset: Option<f64>,
    /// Scene file to write
    #[arg(short, long, value_name = "FILE")]
    pub out: PathBuf,
    /// Replace the file if it exists
    #[arg(short, long)]
    pub force: bool,
}

#[derive(Debug, Args)]
pub struct RandomArguments {
    /// The same seed gives the same peg
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::seed)]
    seed: u64,
    /// Number of convex prisms
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::whole::<usize>(0..=values::BILLION))]
    prisms: usize,
    /// Number of sides of the peg
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = values::whole::<usize>(0..=values::BILLION))]
    facets: usize,
    /// Diameter (m) of the circle that holds the section
    #[arg(long, value_name = "M", default_value_t = 0.09, value_parser = positive)]
    diameter: f64,
    #[command(flatten)]
    peg: PegArguments,
}

#[derive(Debug, Args)]
pub struct RoundArguments {
    /// Diameter of the peg (m)
    #[arg(long, value_name = "M", default_value_t = 0.008, value_parser = positive)]
    diameter: f64,
    #[command(flatten)]
    facets: FacetArguments,
    #[command(flatten)]
    peg: PegArguments,
}

#[derive(Debug, Args)]
pub struct FacetArguments {
    /// Number of sides of a round peg's prism
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = values::whole::<usize>(0..=values::BILLION))]
    facets: usize,
}

#[derive(Debug, Args)]
pub struct RectangularArguments {
    /// Length of the section along x (m)
    #[arg(long, value_name = "M", default_value_t = 0.008, value_parser = positive)]
    width: f64,
    /// Length of the section along y (m)
    #[arg(long, value_name = "M", default_value_t = 0.008, value_parser = positive)]
    depth: f64,
    #[command(flatten)]
    peg: PegArguments,
}

#[derive(Debug, Args)]
#[command(group = ArgGroup::new("core").required(true).args(["diameter", "width"]))]
pub struct KeyedArguments {
    /// Diameter of a round peg (m)
    #[arg(long, value_name = "M", value_parser = positive, conflicts_with = "depth")]
    diameter: Option<f64>,
    /// Length of a rectangular section along x (m); the key is on a side across x
    #[arg(long, value_name = "M", value_parser = positive, requires = "depth", conflicts_with = "facets")]
    width: Option<f64>,
    /// Length of a rectangular section along y (m)
    #[arg(long, value_name = "M", value_parser = positive, requires = "width")]
    depth: Option<f64>,
    /// Width of the key (m)
    #[arg(long, value_name = "M", default_value_t = 0.002, value_parser = positive)]
    key_width: f64,
    /// How far the key stands out of the peg (m)
    #[arg(long, value_name = "M", default_value_t = 0.001, value_parser = positive)]
    key_height: f64,
    #[command(flatten)]
    facets: FacetArguments,
    #[command(flatten)]
    peg: PegArguments,
}

impl GenerateArguments {
    /// The peg, and how it is to be written.
    pub fn peg(&self) -> (Peg, &PegArguments) {
        let (section, arguments, (length, clearance)) = match &self.kind {
            Kind::Random(RandomArguments { seed, prisms, facets, diameter, peg }) => {
                let (seed, prisms, facets, diameter) = (*seed, *prisms, *facets, *diameter);
                (PegSection::Random { seed, prisms, facets, diameter }, peg, (0.1, 0.0008))
            }
            Kind::Round(RoundArguments { diameter, facets, peg }) => {
                (PegSection::Round { diameter: *diameter, facets: facets.facets, key: None }, peg, SMALL)
            }
            Kind::Rectangular(RectangularArguments { width, depth, peg }) => {
                (PegSection::Rectangular { width: *width, depth: *depth, key: None }, peg, SMALL)
            }
            Kind::Keyed(keyed) => (keyed.section(), &keyed.peg, SMALL),
        };
        let peg = Peg {
            section,
            length: arguments.length.unwrap_or(length),
            clearance: arguments.clearance.unwrap_or(clearance),
            chamfer: arguments.chamfer,
            offset: arguments.offset,
        };
        (peg, arguments)
    }
}

/// Length and clearance of pegs that are not random (m).
const SMALL: (f64, f64) = (0.04, 0.0003);

impl KeyedArguments {
    fn section(&self) -> PegSection {
        let key = Some(PegKey { width: self.key_width, height: self.key_height });
        match (self.diameter, self.width, self.depth) {
            (None, Some(width), Some(depth)) => PegSection::Rectangular { width, depth, key },
            (diameter, ..) => {
                let diameter = diameter.unwrap_or_default();
                PegSection::Round { diameter, facets: self.facets.facets, key }
            }
        }
    }
}
