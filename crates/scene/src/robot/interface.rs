//! What the robot is commanded, and the admittance law of one that is commanded poses or a wrench.

use admittance::{ContactLoop, Feedback, ForceMode, Gains, LARGEST_SENSITIVITY, Limits, PositionRobot, Sensor};
use task::Inertia;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::keys::INTERFACES;
use crate::robot::stiffness::{Given, LARGEST_FORCE};
use crate::table::Table;

/// What a robot is commanded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// Joint torques, or a Cartesian impedance.
    Torque,
    /// Poses, which an admittance law computes from a measured wrench.
    Position,
    /// A wrench, which a force mode of the maker follows.
    Force,
}

/// What the law must suit.
pub struct Surroundings<'scene> {
    /// Of body and tool, as the sensor carries them.
    pub inertia: &'scene Inertia,
    /// Largest offset of the part in the gripper (m).
    pub offset_magnitude: f64,
    /// Largest distance of a point of the body from its origin (m).
    pub radius: f64,
}

/// Keys of `[robot]` and `[robustness]` that a robot with a torque interface does not have.
const KEYS: [&str; 8] =
    ["delay", "bandwidth", "contact_stiffness", "virtual_mass", "virtual_inertia", "command", "sensor", "force_mode"];
const BIASES: [&str; 2] = ["force_bias", "torque_bias"];
/// Part of the largest contact force that the stiffness may need at the largest offset; the largest stiffness (N/m).
const PRESSING: f64 = 1.0 / 3.0;
const STIFFEST: f64 = 5e3;
/// Rotational beside translational stiffness (m^2), as usual on robots.
const ROTATIONAL: f64 = 0.1;
/// Smallest lever (m) of contacts, and offset (m), for which gains are chosen.
const SHORTEST_LEVER: f64 = 0.02;
const SMALLEST_OFFSET: f64 = 1e-3;

impl Interface {
    /// Of the table `[robot]`.
    pub fn read(table: &Table) -> Result<Self, SceneError> {
        let interface = table.choice("interface")?;
        Ok([Self::Torque, Self::Position, Self::Force][interface])
    }

    /// Its name in scenes.
    pub fn name(self) -> &'static str {
        INTERFACES[self as usize]
    }
}

/// The robot of a scene whose interface is not `torque`. Gains that the scene leaves out are chosen: the stiffness with which
/// the largest offset needs a third of the largest contact force, and the least damping that is stable in contact.
pub fn position_robot(scene: &Table, about: &Surroundings) -> Result<Option<PositionRobot>, SceneError> {
    let table = scene.table("robot")?;
    let interface = Interface::read(&table)?;
    if interface == Interface::Torque {
        return refuse_keys(scene, &table).map(|()| None);
    }
    if let Some(entry) = table.find("apparent_inertia") {
        return Err(entry.refuse_name(format!(
            "{} is not used with the interface `{}`, which hides the inertia of the arm: leave it out",
            entry.path(),
            interface.name()
        )));
    }
    let (command, sensor) = (table.table("command")?, table.table("sensor")?);
    let pair = |table: &Table, of: [&str; 2]| Ok::<_, SceneError>([table.number(of[0])?, table.number(of[1])?]);
    let mut robot = PositionRobot {
        gains: Gains { mass: [0.0; 2], damping: [0.0; 2], stiffness: stiffness(scene, about)? },
        feedback: Feedback::Commanded,
        period: table.number("control_period")?,
        delay: table.number("delay")?,
        bandwidth: table.number("bandwidth")?,
        limits: Limits {
            speed: pair(&command, ["translational_velocity", "rotational_velocity"])?,
            acceleration: pair(&command, ["translational_acceleration", "rotational_acceleration"])?,
        },
        sensor: Sensor {
            cutoff: sensor.number("cutoff")?,
            noise: pair(&sensor, ["force_noise", "torque_noise"])?,
            resolution: pair(&sensor, ["force_resolution", "torque_resolution"])?,
        },
        force_mode: None,
        contact_stiffness: table.number("contact_stiffness")?,
        lever: about.radius.max(SHORTEST_LEVER),
        carried: about.inertia.clone(),
    };
    if interface == Interface::Force {
        let mode = table.table("force_mode")?;
        let force_mode = ForceMode {
            gain: pair(&mode, ["translational_gain", "rotational_gain"])?,
            deadband: pair(&mode, ["force_deadband", "torque_deadband"])?,
        };
        robot.gains = gains_of(&force_mode, &mode, scene, &robot)?;
        robot.force_mode = Some(force_mode);
    } else {
        robot.gains = gains(scene, &table, &robot)?;
    }
    Ok(Some(robot))
}

/// Refuses keys that a torque interface does not have.
fn refuse_keys(scene: &Table, table: &Table) -> Result<(), SceneError> {
    let of_robot = KEYS.iter().filter_map(|key| table.find(key));
    let robustness = scene.require_table("robustness")?;
    let of_robustness = BIASES.iter().filter_map(|key| robustness.find(key));
    match of_robot.chain(of_robustness).next() {
        None => Ok(()),
        Some(entry) => Err(entry.refuse_name(format!(
            "{} is for robots that are commanded by position or force: set robot.interface to \"position\" or \"force\", or leave \
             it out",
            entry.path()
        ))),
    }
}

/// The stiffness that the scene gives, else the one that is chosen.
fn stiffness(scene: &Table, about: &Surroundings) -> Result<[f64; 2], SceneError> {
    let Given { ranges: [range, rotational_range], stiffness: [given, rotational] } = Given::read(scene)?;
    let force = scene.table("limits")?.find("contact_force").map_or(Ok(LARGEST_FORCE), |entry| entry.number())?;
    let pressing = PRESSING * force / about.offset_magnitude.max(SMALLEST_OFFSET);
    let within = |stiffness: f64, [low, high]: [f64; 2]| stiffness.clamp(low, high);
    let translational = given.unwrap_or(within(pressing.min(STIFFEST), range));
    Ok([translational, rotational.unwrap_or(within(translational * ROTATIONAL, rotational_range))])
}

/// Gains of the admittance law.
fn gains(scene: &Table, table: &Table, robot: &PositionRobot) -> Result<Gains, SceneError> {
    let (of, impedance) = (robot.contact_loop(), scene.table("impedance")?);
    let mut gains = of.gains(robot.gains.stiffness).ok_or_else(|| {
        table.refuse(format!(
            "no damping makes an admittance law stable against {:.0} N/m with a lag of {:.1} ms: check contact_stiffness, delay, \
             bandwidth and the sensor's cutoff",
            robot.contact_stiffness,
            1e3 * of.lag()
        ))
    })?;
    let least = gains;
    let damping = [impedance.find("translational_damping"), impedance.find("rotational_damping")];
    let mass = [table.find("virtual_mass"), table.find("virtual_inertia")];
    for part in 0..2 {
        if let Some(entry) = &damping[part] {
            gains.damping[part] = same_along_every_axis(entry)?;
        }
        if let Some(entry) = &mass[part] {
            gains.mass[part] = entry.number()?;
        }
    }
    match damping.iter().chain(&mass).flatten().next() {
        Some(entry) if !is_stable(&of, &gains) => Err(entry.refuse(format!(
            "this admittance law is not stable against a contact of {:.0} N/m with a lag of {:.1} ms: chosen are {:.0} Ns/m and \
             {:.2} Nms/rad, with a mass of {:.1} kg and {:.4} kg m^2; leave virtual mass and damping out to use these",
            robot.contact_stiffness,
            1e3 * of.lag(),
            least.damping[0],
            least.damping[1],
            least.mass[0],
            least.mass[1],
        ))),
        _ => Ok(gains),
    }
}

/// The law that a force mode is: its gains are inverse dampings, and its mass follows within a period.
fn gains_of(force_mode: &ForceMode, mode: &Table, scene: &Table, robot: &PositionRobot) -> Result<Gains, SceneError> {
    let (table, impedance) = (scene.table("robot")?, scene.table("impedance")?);
    let of_impedance = ["translational_damping", "rotational_damping"].map(|name| impedance.find(name));
    let of_robot = ["virtual_mass", "virtual_inertia"].map(|name| table.find(name));
    if let Some(entry) = of_impedance.iter().chain(&of_robot).flatten().next() {
        let message =
            format!("{} is not used with the interface `force`: robot.force_mode has the gains", entry.path());
        return Err(entry.refuse_name(message));
    }
    let of = robot.contact_loop();
    let damping = force_mode.gain.map(|gain| 1.0 / gain);
    let gains = Gains { mass: damping.map(|damping| damping * robot.period), damping, ..robot.gains };
    if is_stable(&of, &gains) {
        return Ok(gains);
    }
    let largest = of.gains(robot.gains.stiffness).map_or(String::new(), |least| {
        format!("; {:.2e} m/s per N and {:.2e} rad/s per Nm are", 1.0 / least.damping[0], 1.0 / least.damping[1])
    });
    Err(mode.require("translational_gain")?.refuse(format!(
        "this force mode is not stable against a contact of {:.0} N/m with a lag of {:.1} ms{largest}: lower the gain or its \
         scaling at the robot, or state a softer robot.contact_stiffness",
        robot.contact_stiffness,
        1e3 * of.lag()
    )))
}

fn is_stable(of: &ContactLoop, gains: &Gains) -> bool {
    of.sensitivity(gains) <= SLACK * LARGEST_SENSITIVITY
}

/// Given gains may be this much less stable than chosen ones: they are written with fewer digits.
const SLACK: f64 = 1.05;

/// A damping that is the same along every axis.
fn same_along_every_axis(entry: &Entry) -> Result<f64, SceneError> {
    let matrix = entry.matrix()?;
    let first = matrix[0][0];
    let is_same = (0..3).all(|row| (0..3).all(|column| matrix[row][column] == if row == column { first } else { 0.0 }));
    if is_same && first > 0.0 {
        return Ok(first);
    }
    Err(entry.refuse(format!("{} of an admittance law must be positive and the same along every axis", entry.path())))
}
