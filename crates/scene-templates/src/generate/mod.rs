//! Pegs and their holes as scenes: random ones like the paper's (Sec. results:peginhole), round, rectangular and keyed
//! ones.
//!
//! A peg is its section along z, from half its length below the origin to half above, with its lower edge bevelled. The
//! hole is the section moved outwards by the clearance, through walls whose top is at z = 0, with its upper edge
//! bevelled. At the goal, half of the peg is in the hole.

mod kind;
mod random;
mod section;
mod walls;

use fastrand::Rng;
use task::Pose;

use crate::draft::{Draft, DraftPart, DraftShape, rounded};
pub use kind::{PegKey, PegSection};
use scene::{Range, short};
use section::{Point, Section};
use walls::Wall;

/// A peg and its hole. Lengths are in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Peg {
    /// Cross-section.
    pub section: PegSection,
    /// Length of the peg.
    pub length: f64,
    /// Distance between the sides of peg and hole, when the peg is in the middle.
    pub clearance: f64,
    /// Width and height of the bevels at the lower edge of the peg and at the upper edge of the hole; zero for none.
    pub chamfer: f64,
    /// How far the peg may be off in the gripper; by default a quarter of its smallest width, and 0.22 of the
    /// diameter of a random one.
    pub offset: Option<f64>,
}

/// A size of a peg that is not possible.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{name} = {value}: {rule}")]
pub struct PegError {
    name: &'static str,
    value: String,
    rule: String,
}

const LENGTH: Range = Range::closed(1e-3, 1.0);
const CLEARANCE: Range = Range::closed(1e-6, 0.1);

/// Depth of the hole, as a fraction of the peg's length.
const DEPTH: f64 = 0.6;
/// Thickness of the walls, as a fraction of the section's diameter.
const THICKNESS: f64 = 0.4;
/// Height of the peg's lower end above the hole at the start, as a fraction of its length or diameter.
const LIFT: f64 = 0.4;
/// Angle (rad) by which a peg is tilted at the start.
const TILT: f64 = 0.1;
/// Tilts of random pegs, and their number of starts: that of the paper.
const RANDOM_TILTS: std::ops::Range<f64> = 0.1..0.4;
const RANDOM_STARTS: usize = 5;

impl Peg {
    /// Text of a scene with the peg and its hole.
    ///
    /// # Errors
    /// A size that is out of range or does not fit to the others.
    pub fn scene(&self) -> Result<String, PegError> {
        self.section.check()?;
        let offset = self.check_sizes()?;
        let mut rng = Rng::with_seed(match self.section {
            PegSection::Random { seed, .. } => seed,
            _ => 0,
        });
        let section = self.section.section(&mut rng, self.clearance, self.chamfer)?;
        let draft = Draft {
            about: self.about(),
            body: self.body(&section)?,
            environment: self.environment(&section)?,
            starts: self.starts(&section, &mut rng),
            goal: Pose([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
            position_tolerance: None,
            offset,
            contact_force: None,
        };
        Ok(draft.text())
    }

    /// Checks all sizes but those of the section, and returns the offset (m).
    fn check_sizes(&self) -> Result<f64, PegError> {
        metres_within(LENGTH, "length", self.length)?;
        metres_within(CLEARANCE, "clearance", self.clearance)?;
        let longest = 0.25 * self.length;
        require((0.0..=longest).contains(&self.chamfer), "chamfer", self.chamfer, || {
            format!("must lie between 0 and {} m, a quarter of the length", metres(longest))
        })?;
        let width = self.section.smallest_width();
        let offset = self.offset.unwrap_or_else(|| rounded(self.section.usual_offset() * width));
        require(offset > 0.0 && offset <= 0.5 * width, "offset", offset, || {
            format!("must be above 0 and at most {} m, half of the peg's width", metres(0.5 * width))
        })?;
        Ok(offset)
    }

    fn body(&self, section: &Section) -> Result<Vec<DraftPart>, PegError> {
        let lower = moved(section, -self.chamfer, "chamfer", self.chamfer)?;
        let half = 0.5 * self.length;
        let part = |(index, piece): (usize, &Vec<usize>)| {
            let layers = [
                (lower.piece(piece), -half),
                (section.piece(piece), self.chamfer - half),
                (section.piece(piece), half),
            ];
            self.part(self.section.name_of(index), layers)
        };
        Ok(section.pieces.iter().enumerate().map(part).collect())
    }

    fn environment(&self, section: &Section) -> Result<Vec<DraftPart>, PegError> {
        let hole = moved(section, self.clearance, "clearance", self.clearance)?;
        let rim = moved(&hole, self.chamfer, "chamfer", self.chamfer)?;
        let thickness = THICKNESS * section.diameter();
        let keyway = self.section.key().map(|_| section.key_edges()).unwrap_or_default();
        let part = |(edge, wall): (usize, &Wall)| {
            let layers = [
                (wall.section(&rim), 0.0),
                (wall.section(&hole), -self.chamfer),
                (wall.section(&hole), -DEPTH * self.length),
            ];
            let name = match keyway.contains(&edge) {
                true => format!("keyway{}", edge - keyway.start + 1),
                false if edge < keyway.start => format!("wall{}", edge + 1),
                false => format!("wall{}", edge + 1 - keyway.len()),
            };
            self.part(name, layers)
        };
        Ok(Wall::around(&hole, thickness).iter().enumerate().map(part).collect())
    }

    /// The convex hull of three sections at heights (m) in order.
    fn part(&self, name: String, [first, middle, last]: [(Vec<Point>, f64); 3]) -> DraftPart {
        let is_corner = |point: &Point| !(first.0.contains(point) && last.0.contains(point));
        let middle = (middle.0.into_iter().filter(is_corner).collect(), middle.1);
        let layers: Vec<(Vec<Point>, f64)> = match self.chamfer {
            // The first section stands where the middle one does, and is the same.
            0.0 => vec![first, last],
            _ => vec![first, middle, last],
        };
        let at_height = |(corners, height): (Vec<Point>, f64)| corners.into_iter().map(move |[x, y]| [x, y, height]);
        DraftPart {
            name,
            shape: DraftShape::Vertices(layers.into_iter().flat_map(at_height).collect()),
            position: None,
        }
    }

    fn starts(&self, section: &Section, rng: &mut Rng) -> Vec<Pose> {
        let height = 0.5 * self.length + LIFT * self.length.max(section.diameter());
        let turned = |quaternion| Pose::new([0.0, 0.0, height], quaternion);
        match self.section {
            PegSection::Random { .. } => {
                (0..RANDOM_STARTS).map(|_| turned(random::orientation(rng, RANDOM_TILTS))).collect()
            }
            _ => vec![turned([(0.5 * TILT).cos(), (0.5 * TILT).sin(), 0.0, 0.0])],
        }
    }

    /// Description of the scene, in lines of text.
    fn about(&self) -> Vec<String> {
        let mut about = self.section.about(self.clearance);
        let chamfers = match self.chamfer {
            0.0 => "no chamfers".to_owned(),
            chamfer => format!("chamfers of {chamfer} m"),
        };
        let Self { length, clearance, .. } = self;
        about.push(format!("It is {length} m long and has a clearance of {clearance} m on every side and {chamfers}."));
        about
    }
}

/// A section moved outwards by a distance (m), which a size is too large for.
fn moved(section: &Section, distance: f64, name: &'static str, size: f64) -> Result<Section, PegError> {
    section.offset(distance).ok_or_else(|| PegError {
        name,
        value: metres(size),
        rule: "edges of the section would vanish; choose less, or a section with longer edges".to_owned(),
    })
}

/// A length for a message, to the nanometre.
fn metres(length: f64) -> String {
    short((1e9 * length).round() / 1e9)
}

fn within(range: Range, name: &'static str, value: f64) -> Result<(), PegError> {
    require(range.contains(value), name, value, || format!("must lie {range}"))
}

/// The same for a length in metres.
fn metres_within(range: Range, name: &'static str, value: f64) -> Result<(), PegError> {
    require(range.contains(value), name, value, || format!("must lie {range} m"))
}

fn require(is_right: bool, name: &'static str, value: f64, rule: impl Fn() -> String) -> Result<(), PegError> {
    if is_right { Ok(()) } else { Err(PegError { name, value: short(value), rule: rule() }) }
}
