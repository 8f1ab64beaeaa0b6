//! Choice of the controller's stiffness.

use ::robot::gains::Demand;
use task::Inertia;

use super::Robot;
use crate::chosen;
use crate::error::SceneError;
use crate::table::Table;

/// Stiffness of translations (N/m) and rotations (Nm/rad).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    pub translational: f64,
    pub rotational: f64,
}

/// Target for the error (m, rad) at which joint friction holds the arm. The final oscillation of a reference overcomes
/// the first; a stiffer arm pushes harder.
const DEADBAND: f64 = 4e-3;
const ANGULAR_DEADBAND: f64 = 0.04;
/// Part of the offset magnitude that the deadband may be where the contact force or the controller allows no less; the angle
/// in proportion. A plan that tolerates larger offsets also tolerates a larger deadband.
const DEADBAND_OF_OFFSETS: f64 = 0.3;
/// Largest contact force (N) where the scene has no limit.
pub const LARGEST_FORCE: f64 = 60.0;

/// The stiffness that the scene gives. By default: the one with which a body of this inertia moves as light ones do
/// under soft controllers, which is dynamic similarity; with an arm as stiff as joint friction demands, and as soft as
/// the limit of contact forces and the controller's range allow. Translations and rotations are chosen separately: a
/// part with a rotation error wedges with the rotational stiffness, so more of it than rotations need only harms.
pub fn stiffness(
    scene: &Table,
    inertia: &Inertia,
    offset_magnitude: f64,
    robot: Option<&Robot>,
) -> Result<Stiffness, SceneError> {
    let Given { ranges, stiffness: [translational, rotational] } = Given::read(scene)?;
    let mass = inertia.mean_mass();
    let similar = translational.unwrap_or_else(|| chosen::translational_stiffness(offset_magnitude, mass));
    let similar = Stiffness {
        translational: similar,
        rotational: rotational.unwrap_or_else(|| chosen::rotational_stiffness(similar, mass)),
    };
    if translational.is_some() || rotational.is_some() {
        let [[softest, stiffest], [softest_turning, stiffest_turning]] = ranges;
        return Ok(Stiffness {
            translational: similar.translational.clamp(softest, stiffest),
            rotational: similar.rotational.clamp(softest_turning, stiffest_turning),
        });
    }
    let Some(entry) = scene.find("robot") else { return Ok(similar) };
    let [translation, rotation] = demands(scene, offset_magnitude, robot, ranges)?;
    let chosen = |of: &str, demand: Demand, similar: f64| {
        demand.stiffness(similar).map_err(|refusal| {
            entry.refuse(format!("no stiffness of {of} suits this robot: {refusal}; or set impedance yourself"))
        })
    };
    Ok(Stiffness {
        translational: chosen("translations", translation, similar.translational)?,
        rotational: chosen("rotations", rotation, similar.rotational)?,
    })
}

/// What a scene gives of translations and rotations: the range that the controller accepts, and the stiffness in it.
pub struct Given {
    pub ranges: [[f64; 2]; 2],
    pub stiffness: [Option<f64>; 2],
}

impl Given {
    /// Refuses a stiffness outside of its range.
    pub fn read(scene: &Table) -> Result<Self, SceneError> {
        let (accepted, table) = (scene.table("robot")?.table("stiffness_range")?, scene.table("impedance")?);
        let range = |name: &str| -> Result<[f64; 2], SceneError> {
            let Some(entry) = accepted.find(name) else { return Ok([0.0, f64::INFINITY]) };
            match entry.numbers()?[..] {
                [low, high] if low <= high => Ok([low, high]),
                _ => Err(entry.refuse(format!("{} must be the lowest and the highest stiffness", entry.path()))),
            }
        };
        let ranges = [range("translational")?, range("rotational")?];
        let given = |name: &str, [low, high]: [f64; 2]| match table.find(name) {
            None => Ok(None),
            Some(entry) => match entry.number()? {
                value if (low..=high).contains(&value) => Ok(Some(value)),
                _ => Err(entry.refuse(format!("{} must lie in robot.stiffness_range, {low} to {high}", entry.path()))),
            },
        };
        let stiffness = [given("translational_stiffness", ranges[0])?, given("rotational_stiffness", ranges[1])?];
        Ok(Self { ranges, stiffness })
    }
}

/// Demands of joint friction and contact forces on the stiffness of translations and rotations, which lie in these
/// ranges.
fn demands(
    scene: &Table,
    offset_magnitude: f64,
    robot: Option<&Robot>,
    [translational, rotational]: [[f64; 2]; 2],
) -> Result<[Demand; 2], SceneError> {
    let holds = robot.and_then(|robot| robot.friction_wrench);
    let limit = scene.table("limits")?.find("contact_force").map(|entry| entry.number()).transpose()?;
    let load = if robot.is_some() { limit.unwrap_or(LARGEST_FORCE) } else { f64::INFINITY };
    let allowed = (DEADBAND_OF_OFFSETS * offset_magnitude / DEADBAND).max(1.0);
    let translation = Demand {
        friction: holds.map_or(0.0, |wrench| wrench.force),
        deadband: DEADBAND,
        allowed: DEADBAND * allowed,
        press: offset_magnitude,
        load,
        range: translational,
    };
    let rotation = Demand {
        friction: holds.map_or(0.0, |wrench| wrench.torque),
        deadband: ANGULAR_DEADBAND,
        allowed: ANGULAR_DEADBAND * allowed,
        press: 0.0,
        load: f64::INFINITY,
        range: rotational,
    };
    Ok([translation, rotation])
}
