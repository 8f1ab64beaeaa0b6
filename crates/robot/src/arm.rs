//! An arm that holds a part.

use std::io::ErrorKind;
use std::path::Path;

use nalgebra::{Isometry3, IsometryMatrix3, Vector3};

use crate::chain::{Chain, MovedLink};
use crate::error::{Fault, RobotError};
use crate::inertia::RigidInertia;
use crate::joint::{Joint, JointVector};
use crate::urdf::Urdf;

/// Larger files (bytes) are a mistake.
const LARGEST_FILE: u64 = 1 << 20;
/// Masses (kg) of all moving links together that need no remark.
const USUAL_MASSES: std::ops::Range<f64> = 0.2..1000.0;
/// Part of its inertia that a joint has to move while those behind it are free.
const LEAST_SHARE: f64 = 1e-10;

/// A serial arm with fixed base whose tip holds a part.
#[derive(Debug, Clone, PartialEq)]
pub struct Arm {
    root: String,
    joints: Vec<Joint>,
    moved: Vec<MovedLink>,
    /// Frame of the tip in that of the last moving link.
    tip: IsometryMatrix3<f64>,
    base: IsometryMatrix3<f64>,
    grasp: IsometryMatrix3<f64>,
    payload: RigidInertia,
    remarks: Vec<String>,
}

/// Why numbers do not fit an arm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ArmError {
    /// Not one number per joint.
    #[error("{given} numbers for {}: give one per joint, from the base to the tip", joints.join(", "))]
    Count {
        /// How many were given.
        given: usize,
        /// Names of all joints.
        joints: Vec<String>,
    },
    /// A position that is no number or beyond a limit.
    #[error("joint `{joint}` cannot be at {position} {unit}: its range is {lower} to {upper} {unit}")]
    Position {
        /// Name of the joint.
        joint: String,
        /// The given position (rad or m).
        position: f64,
        /// Lowest position (rad or m).
        lower: f64,
        /// Highest position (rad or m).
        upper: f64,
        /// Unit of these.
        unit: &'static str,
    },
    /// A rotor inertia that is no number or negative.
    #[error(
        "joint `{joint}` cannot have a rotor inertia of {inertia} {unit}: give a finite number that is not negative"
    )]
    RotorInertia {
        /// Name of the joint.
        joint: String,
        /// The given inertia (kg m^2 or kg).
        inertia: f64,
        /// Its unit.
        unit: &'static str,
    },
}

impl Arm {
    /// Reads the joints between the root of a URDF file and the link `tip`, of which at most [`crate::MOST_JOINTS`] may
    /// move. The part's frame is that of the tip, the base is at the origin of the world; there is no payload.
    ///
    /// Links that hang on the arm beside its chain, or behind the tip, add their inertia to the link that carries them;
    /// their joints stay at zero, or at the limit next to it. Damping and friction in the file are not used, and what the
    /// type of a joint or the chain does not use is not checked.
    ///
    /// # Errors
    /// When the file cannot be read, is no URDF, has no such tip, or a joint or inertia that an arm cannot have.
    pub fn read(path: &Path, tip: &str) -> Result<Self, RobotError> {
        let at = |fault| RobotError::new(path, fault);
        let (arm, remarks) = read_text(path).and_then(|text| Self::from_urdf(&text, tip)).map_err(at)?;
        let remarks = remarks.into_iter().map(|remark| at(remark).to_string()).collect();
        Ok(Self { remarks, ..arm })
    }

    fn from_urdf(text: &str, tip: &str) -> Result<(Self, Vec<Fault>), Fault> {
        let Chain { root, joints, lines, tip, moved, mut remarks } = Chain::to_tip(&Urdf::parse(text)?, tip)?;
        let arm = Self {
            root,
            joints,
            moved,
            tip,
            base: IsometryMatrix3::identity(),
            grasp: IsometryMatrix3::identity(),
            payload: RigidInertia::zero(),
            remarks: Vec::new(),
        };
        if let Some(joint) = arm.joint_without_inertia() {
            return Err(without_inertia(&arm.joints[joint].name, lines[joint]));
        }
        let mass = arm.joints.iter().map(|joint| joint.link_inertia.mass()).sum();
        if !USUAL_MASSES.contains(&mass) {
            remarks.push(Fault::somewhere(format!(
                "the links that move weigh {mass} kg together: are their masses in kilograms?"
            )));
        }
        Ok((arm, remarks))
    }

    /// The links that move, also those that hang on the chain beside it.
    pub fn moved_links(&self) -> &[MovedLink] {
        &self.moved
    }

    /// Poses of all links that move in the world frame, in the order of [`Arm::moved_links`], at joint positions (rad or m).
    pub fn link_poses(&self, configuration: &JointVector) -> Vec<Isometry3<f64>> {
        let mut frame = self.base;
        let behind = |(index, joint): (usize, &Joint)| {
            frame *= joint.link_frame(configuration[index]);
            frame
        };
        let frames: Vec<IsometryMatrix3<f64>> = self.joints.iter().enumerate().map(behind).collect();
        self.moved.iter().map(|link| nalgebra::convert(frames[link.joint] * link.frame)).collect()
    }

    /// Unusual properties of its file that an arm may have, each with file and line.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// The joint nearest to the tip that moves no inertia while those behind it are free: the mass matrix of the links
    /// is then not positive definite. `None` where it is. It depends on the joint positions only in special ones.
    fn joint_without_inertia(&self) -> Option<usize> {
        let mut mass = self.at(&JointVector::from_fn(|joint, _| 0.3 + 0.37 * joint as f64)).mass_matrix();
        let whole = mass.diagonal();
        for pivot in (0..self.joints.len()).rev() {
            let left = mass[(pivot, pivot)];
            if !(left > LEAST_SHARE * whole[pivot]) {
                return Some(pivot);
            }
            for row in 0..pivot {
                for column in 0..pivot {
                    mass[(row, column)] -= mass[(row, pivot)] * mass[(pivot, column)] / left;
                }
            }
        }
        None
    }

    /// With the frame of its root link at `base` in the world frame.
    pub fn with_base(self, base: &Isometry3<f64>) -> Self {
        Self { base: nalgebra::convert(*base), ..self }
    }

    /// With the part's frame at `grasp` in the frame of the tip.
    pub fn with_grasp(self, grasp: &Isometry3<f64>) -> Self {
        Self { grasp: nalgebra::convert(*grasp), ..self }
    }

    /// With a part of this inertia, which is given in the part's frame.
    pub fn with_payload(self, payload: RigidInertia) -> Self {
        Self { payload, ..self }
    }

    /// With inertias of motors and gears as the joints feel them: gear ratio squared times the rotor's (kg m^2, kg for a
    /// prismatic joint), one per joint.
    ///
    /// # Errors
    /// When there is not one number per joint, or one is negative or not finite.
    pub fn with_rotor_inertia(mut self, inertias: &[f64]) -> Result<Self, ArmError> {
        self.check_count(inertias)?;
        for (joint, &inertia) in self.joints.iter_mut().zip(inertias) {
            if !(inertia >= 0.0 && inertia.is_finite()) {
                let unit = joint.kind.inertia_unit();
                return Err(ArmError::RotorInertia { joint: joint.name.clone(), inertia, unit });
            }
            joint.rotor_inertia = inertia;
        }
        Ok(self)
    }

    /// Name of its root link, which is the base.
    pub fn root(&self) -> &str {
        &self.root
    }

    /// The moving joints from the base to the tip.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Inertia of each link in its own frame, with everything that is fixed to it; that of the last one includes the part.
    pub fn link_inertias(&self) -> Vec<RigidInertia> {
        let mut inertias: Vec<RigidInertia> = self.joints.iter().map(|joint| joint.link_inertia).collect();
        if let Some(last) = inertias.last_mut() {
            *last = last.joined(&self.payload.seen_from(&self.part_frame()));
        }
        inertias
    }

    /// Frame of the tip in that of the last moving link.
    pub fn tip_frame(&self) -> Isometry3<f64> {
        nalgebra::convert(self.tip)
    }

    /// Joint positions (rad or m) as one vector.
    ///
    /// # Errors
    /// When there is not one number per joint, or one is beyond its joint's limits or not finite.
    pub fn configuration(&self, positions: &[f64]) -> Result<JointVector, ArmError> {
        self.check_count(positions)?;
        let mut configuration = JointVector::zeros();
        configuration.as_mut_slice()[..positions.len()].copy_from_slice(positions);
        self.check_limits(&configuration)?;
        Ok(configuration)
    }

    /// Checks that all joints are within their limits.
    ///
    /// # Errors
    /// At the first joint that is not.
    pub fn check_limits(&self, configuration: &JointVector) -> Result<(), ArmError> {
        let beyond = |(joint, position): &(&Joint, &f64)| !(position.is_finite() && joint.allows(**position));
        match self.joints.iter().zip(configuration.iter()).find(beyond) {
            Some((joint, &position)) => Err(ArmError::Position {
                joint: joint.name.clone(),
                position,
                lower: joint.lower,
                upper: joint.upper,
                unit: joint.kind.unit(),
            }),
            None => Ok(()),
        }
    }

    /// Points (m, world frame) that outline the arm at joint positions (rad or m): the origins of its base, of each joint and
    /// of the part.
    pub fn skeleton(&self, configuration: &JointVector) -> Vec<Vector3<f64>> {
        let mut frame = self.base;
        let mut points = vec![frame.translation.vector];
        for (joint, &position) in self.joints.iter().zip(configuration) {
            frame *= joint.link_frame(position);
            points.push(frame.translation.vector);
        }
        points.push((frame * self.part_frame()).translation.vector);
        points
    }

    /// Frame of the part in that of the last moving link.
    pub(crate) fn part_frame(&self) -> IsometryMatrix3<f64> {
        self.tip * self.grasp
    }

    pub(crate) fn base(&self) -> &IsometryMatrix3<f64> {
        &self.base
    }

    pub(crate) fn payload(&self) -> &RigidInertia {
        &self.payload
    }

    fn check_count(&self, numbers: &[f64]) -> Result<(), ArmError> {
        if numbers.len() == self.joints.len() {
            return Ok(());
        }
        let joints = self.joints.iter().map(|joint| joint.name.clone()).collect();
        Err(ArmError::Count { given: numbers.len(), joints })
    }
}

fn without_inertia(joint: &str, line: usize) -> Fault {
    Fault::at(
        line,
        format!(
            "joint `{joint}` moves nothing with inertia: give <inertial> to the link behind it, which is in this line, or to \
             one that is fixed to that"
        ),
    )
}

fn read_text(path: &Path) -> Result<String, Fault> {
    let bytes = input::read(path, LARGEST_FILE).map_err(|error| match error.kind() {
        ErrorKind::FileTooLarge => Fault::somewhere(format!("{error}: remove what is not links and joints")),
        _ => Fault::somewhere(format!("cannot be read: {error}")),
    })?;
    String::from_utf8(bytes).map_err(|_| Fault::somewhere("the file is not UTF-8 text: save it as UTF-8"))
}
