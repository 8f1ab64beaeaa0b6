//! `controllers.yaml`: parameters with which the `admittance_controller` of ros2_controllers has the law of a plan.

use std::f64::consts::TAU;

use admittance::{Gains, PositionRobot};

use crate::document::{ArmRecord, Document};
use crate::frames::Frames;
use crate::text::filled;

/// Masses (kg, kg m^2) and stiffnesses (N/m, Nm/rad) that the controller takes. It scales the damping by the stiffness, which
/// therefore cannot be zero.
const MASSES: [f64; 2] = [1e-4, 1e6];
const LARGEST_STIFFNESS: f64 = 1e8;
/// The controller manager updates a whole number of times per second, which may differ by this part of it.
const WHOLE: f64 = 1e-6;
/// The law of the controller acts at a link. That of a plan acts at the part, whose origin may be this far (m) from the link.
const SAME_ORIGIN: f64 = 1e-6;
/// The spring of the controller acts on the measured pose, that of a plan on the commanded one. Gains whose largest sensitivity
/// stays below this are as good: a gain margin of 1.7 and a phase margin of 23 degrees.
const LARGEST_SENSITIVITY: f64 = 2.5;
/// Halvings of a stiffness that are tried for advice.
const HALVINGS: i32 = 20;
const UNITS: [[&str; 2]; 2] = [["kg", "N/m"], ["kg m^2", "Nm/rad"]];
const KEYS: [[&str; 2]; 2] = [
    ["robot.virtual_mass", "impedance.translational_stiffness"],
    ["robot.virtual_inertia", "impedance.rotational_stiffness"],
];

/// Parameters of the controller. Pairs of numbers are those of translations and rotations.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    /// Updates per second.
    update_rate: u32,
    /// Share of a new sample in the filtered wrench.
    filter_coefficient: f64,
    mass: [f64; 2],
    damping_ratio: [f64; 2],
    stiffness: [f64; 2],
}

impl Parameters {
    /// Of the law of a robot that is commanded by position.
    ///
    /// # Errors
    /// When the controller cannot run the law: the reason, and what to change in the scene.
    pub fn new(robot: &PositionRobot, frames: &Frames) -> Result<Self, String> {
        let distance = frames.grasp.translation.vector.norm();
        if !(distance <= SAME_ORIGIN) {
            return Err(format!(
                "the law of the plan acts at the origin of the part, which is {:.3} mm from that of robot.tip, and \
                 admittance_controller has no parameter for the lever between them: add a link to the URDF file whose origin is that of \
                 the part, name it as robot.tip, and solve again",
                1e3 * distance
            ));
        }
        let Gains { mass, damping, stiffness } = robot.gains;
        for part in 0..2 {
            let ([mass, stiffness], [of_mass, of_stiffness]) = ([mass[part], stiffness[part]], KEYS[part]);
            let [unit, per] = UNITS[part];
            let [least, most] = MASSES;
            if !(least..=most).contains(&mass) {
                return Err(format!(
                    "admittance_controller takes a mass from {least} to {most} {unit}, and the law has {mass:e} {unit}: set \
                     {of_mass} in the scene and solve again"
                ));
            }
            if !(stiffness > 0.0 && stiffness <= LARGEST_STIFFNESS) {
                return Err(format!(
                    "admittance_controller takes a stiffness above 0 and up to {LARGEST_STIFFNESS:e} {per}, and the law has \
                     {stiffness:e} {per}: set {of_stiffness} in the scene and solve again"
                ));
            }
        }
        let rate = 1.0 / robot.period;
        if !((rate - rate.round()).abs() <= WHOLE * rate) {
            return Err(format!(
                "the controller manager updates a whole number of times per second, and the law has the period {} s: set \
                 robot.control_period in the scene to 1/{:.0} s = {:.6} s, for example, and solve again",
                robot.period,
                rate.round().max(1.0),
                1.0 / rate.round().max(1.0)
            ));
        }
        require_stable(robot)?;
        let ratio = |part: usize| damping[part] / (2.0 * (mass[part] * stiffness[part]).sqrt());
        Ok(Self {
            update_rate: rate.round() as u32,
            filter_coefficient: -(-TAU * robot.sensor.cutoff * robot.period).exp_m1(),
            mass,
            damping_ratio: [ratio(0), ratio(1)],
            stiffness,
        })
    }

    /// The text of the file.
    pub fn yaml(&self, document: &Document, arm: &ArmRecord) -> String {
        let joints: Vec<String> = arm.joints.iter().map(|joint| quoted(&joint.name)).collect();
        let values = [
            ("scene", document.scene.clone()),
            ("start", document.start.clone()),
            ("update_rate", self.update_rate.to_string()),
            ("joints", joints.join(", ")),
            ("root", quoted(&arm.root)),
            ("tip", quoted(&arm.tip)),
            ("filter_coefficient", double(self.filter_coefficient)),
            ("mass", axes(self.mass)),
            ("damping_ratio", axes(self.damping_ratio)),
            ("stiffness", axes(self.stiffness)),
        ];
        filled(include_str!("../players/ros2_control/controllers.yaml"), &values)
    }
}

/// Refuses gains that are not stable with a spring that acts on the measured pose, with stiffnesses that are.
fn require_stable(robot: &PositionRobot) -> Result<(), String> {
    let (of, [along, about]) = (robot.contact_loop(), robot.gains.stiffness);
    let sensitivity = |stiffness| of.sensitivity_with_measured_spring(&Gains { stiffness, ..robot.gains });
    let largest = sensitivity([along, about]);
    if largest <= LARGEST_SENSITIVITY {
        return Ok(());
    }
    let shares = || (1..=HALVINGS).map(|halvings| 0.5_f64.powi(halvings));
    let mut candidates =
        shares().map(|share| [along, share * about]).chain(shares().map(|share| [share * along, share * about]));
    let advice = candidates.find(|stiffness| sensitivity(*stiffness) <= LARGEST_SENSITIVITY).map_or_else(
        || "; check delay and bandwidth of [robot]".to_owned(),
        |[along, about]| {
            format!(": set stiffnesses of up to {along:.3} N/m and {about:.3} Nm/rad in [impedance] and solve again")
        },
    );
    Err(format!(
        "the spring of admittance_controller acts on the measured pose, which comes late, and with {along:.3} N/m and {about:.3} Nm/rad \
         its largest sensitivity is {largest:.2}, more than {LARGEST_SENSITIVITY}{advice}"
    ))
}

/// A pair along x, y, z and about them.
fn axes([along, about]: [f64; 2]) -> String {
    let [along, about] = [double(along), double(about)];
    format!("[{along}, {along}, {along}, {about}, {about}, {about}]")
}

/// A number with all its digits that stays a floating-point number: ROS 2 tells them from integers by their point.
fn double(value: f64) -> String {
    format!("{value:?}")
}

/// A name in quotes, as JSON and YAML both write it.
fn quoted(name: &str) -> String {
    serde_json::Value::from(name).to_string()
}

#[cfg(test)]
mod tests {
    use admittance::{Feedback, Limits, Sensor};
    use nalgebra::Isometry3;
    use task::Inertia;

    use super::*;

    fn robot() -> PositionRobot {
        PositionRobot {
            gains: Gains { mass: [24.0, 0.06], damping: [6000.0, 15.0], stiffness: [500.0, 50.0] },
            feedback: Feedback::Commanded,
            period: 0.002,
            delay: 0.004,
            bandwidth: 20.0,
            limits: Limits { speed: [0.25, 1.0], acceleration: [2.5, 10.0] },
            sensor: Sensor { cutoff: 50.0, noise: [0.0; 2], resolution: [0.0; 2] },
            force_mode: None,
            contact_stiffness: 1e5,
            lever: 0.05,
            carried: Inertia::of_body(1.0, nalgebra::Matrix3::identity()),
        }
    }

    fn frames(lever: f64) -> Frames {
        Frames { base: Isometry3::translation(1.0, 0.0, 0.0), grasp: Isometry3::translation(0.0, 0.0, lever) }
    }

    #[test]
    fn the_controller_makes_the_damping_of_the_law_from_its_ratio() {
        let parameters = Parameters::new(&robot(), &frames(0.0)).unwrap();
        assert_eq!(parameters.update_rate, 500);
        for (part, damping) in [6000.0, 15.0].into_iter().enumerate() {
            // As the controller computes it.
            let own =
                parameters.damping_ratio[part] * 2.0 * (parameters.mass[part] * parameters.stiffness[part]).sqrt();
            assert!((own - damping).abs() < 1e-12 * damping, "{own}");
        }
        // A filter of the first order at 50 Hz passes 1 - exp(-2 pi 50 0.002) of a step within a sample.
        assert!((parameters.filter_coefficient - 0.466_512).abs() < 1e-6);
    }

    #[test]
    fn what_the_controller_has_no_room_for_is_refused_with_the_key() {
        let with = |change: fn(&mut PositionRobot)| {
            let mut robot = robot();
            change(&mut robot);
            Parameters::new(&robot, &frames(0.0)).unwrap_err()
        };
        for (message, words) in [
            (with(|robot| robot.gains.mass[0] = 0.0), "robot.virtual_mass"),
            (
                with(|robot| robot.gains.mass[1] = 9e-5),
                "takes a mass from 0.0001 to 1000000 kg m^2, and the law has 9e-5",
            ),
            (with(|robot| robot.gains.mass[1] = f64::NAN), "robot.virtual_inertia"),
            (with(|robot| robot.gains.stiffness[0] = 0.0), "impedance.translational_stiffness"),
            (with(|robot| robot.gains.stiffness[1] = 2e8), "impedance.rotational_stiffness"),
            (with(|robot| robot.gains.stiffness[1] = 5000.0), "its largest sensitivity is inf"),
            (with(|robot| robot.period = 0.003), "1/333 s"),
            (with(|robot| robot.period = f64::NAN), "robot.control_period"),
            (Parameters::new(&robot(), &frames(0.05)).unwrap_err(), "50.000 mm from that of robot.tip"),
            (Parameters::new(&robot(), &frames(f64::NAN)).unwrap_err(), "robot.tip"),
        ] {
            assert!(message.contains(words), "{message}");
        }
    }

    #[test]
    fn the_stiffness_that_is_named_instead_is_taken() {
        let mut robot = robot();
        robot.gains.stiffness = [500.0, 5000.0];
        let message = Parameters::new(&robot, &frames(0.0)).unwrap_err();
        let about = message.split(" and ").nth(3).and_then(|rest| rest.split(' ').next()).unwrap();
        robot.gains.stiffness[1] = about.parse().unwrap();
        assert!(robot.gains.stiffness[1] > 50.0, "{message}");
        assert!(Parameters::new(&robot, &frames(0.0)).is_ok(), "{message}");
    }

    #[test]
    fn numbers_keep_their_point_and_names_their_quotes() {
        assert_eq!(axes([1000.0, 0.5]), "[1000.0, 1000.0, 1000.0, 0.5, 0.5, 0.5]");
        assert_eq!(quoted("a\"b: c"), "\"a\\\"b: c\"");
    }
}
