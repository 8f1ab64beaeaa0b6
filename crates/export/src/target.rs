//! Targets of exports.

use std::fmt;

/// Modules that every folder with a player has.
const SHARED: [File; 12] = [
    ("exported_plan.py", include_str!("../players/shared/exported_plan.py")),
    ("failures.py", include_str!("../players/shared/failures.py")),
    ("guards.py", include_str!("../players/shared/guards.py")),
    ("impedance.py", include_str!("../players/shared/impedance.py")),
    ("interruption.py", include_str!("../players/shared/interruption.py")),
    ("journal.py", include_str!("../players/shared/journal.py")),
    ("kinematics.py", include_str!("../players/shared/kinematics.py")),
    ("log_file.py", include_str!("../players/shared/log_file.py")),
    ("motions.py", include_str!("../players/shared/motions.py")),
    ("rotations.py", include_str!("../players/shared/rotations.py")),
    ("session.py", include_str!("../players/shared/session.py")),
    ("settings.py", include_str!("../players/shared/settings.py")),
];

/// Modules of players behind topics of ROS 2.
const TOPICS: [File; 3] = [
    ("inbox.py", include_str!("../players/topics/inbox.py")),
    ("node.py", include_str!("../players/topics/node.py")),
    ("topic_robot.py", include_str!("../players/topics/topic_robot.py")),
];

/// Name and text of a file.
pub type File = (&'static str, &'static str);

/// The target of an export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Tables alone.
    Csv,
    /// A player for robots of Universal Robots, over RTDE.
    UrRtde,
    /// A player for robots of Franka Robotics.
    Franka,
    /// A script that a controller of Universal Robots runs itself.
    UrScript,
    /// A node for Cartesian impedance controllers of ROS 2.
    Ros2,
    /// A player for robots that take position corrections over UDP.
    Correction,
    /// Parameters and a node for the admittance controller of ros2_controllers.
    Ros2Control,
    /// A model for MuJoCo that plays the plan.
    Mjcf,
    /// A model in SDF.
    Sdf,
    /// A model in OpenUSD.
    Usd,
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Csv,
        Self::UrRtde,
        Self::Franka,
        Self::UrScript,
        Self::Ros2,
        Self::Correction,
        Self::Ros2Control,
        Self::Mjcf,
        Self::Sdf,
        Self::Usd,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::UrRtde => "ur-rtde",
            Self::Franka => "franka",
            Self::UrScript => "urscript",
            Self::Ros2 => "ros2",
            Self::Correction => "correction",
            Self::Ros2Control => "ros2-control",
            Self::Mjcf => "mjcf",
            Self::Sdf => "sdf",
            Self::Usd => "usd",
        }
    }

    /// The target of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|target| target.name() == name)
    }

    /// Whether it is a model for simulators, not for a robot.
    pub fn is_model(self) -> bool {
        matches!(self, Self::Mjcf | Self::Sdf | Self::Usd)
    }

    /// Whether it needs an arm in the scene.
    pub fn needs_arm(self) -> bool {
        matches!(self, Self::UrRtde | Self::UrScript | Self::Franka | Self::Ros2Control)
    }

    /// Number of joints of the arms that it can move, if it matters.
    pub fn joints(self) -> Option<usize> {
        match self {
            Self::UrRtde | Self::UrScript => Some(6),
            Self::Franka => Some(7),
            _ => None,
        }
    }

    /// Largest step of a joint torque (Nm) within a millisecond, where its robots stop beyond it.
    pub fn torque_step(self) -> Option<f64> {
        match self {
            Self::Franka => Some(1.0),
            _ => None,
        }
    }

    /// The files of its player.
    pub(crate) fn player(self) -> Vec<File> {
        let own: &[File] = match self {
            Self::Csv | Self::Mjcf | Self::Sdf | Self::Usd => return Vec::new(),
            Self::UrScript => &[("receive.py", include_str!("../players/urscript/receive.py"))],
            Self::UrRtde => &[
                ("play.py", include_str!("../players/ur_rtde/play.py")),
                ("ur_robot.py", include_str!("../players/ur_rtde/ur_robot.py")),
            ],
            Self::Franka => &[
                ("play.py", include_str!("../players/franka/play.py")),
                ("franka_robot.py", include_str!("../players/franka/franka_robot.py")),
            ],
            Self::Ros2 => &[
                ("play.py", include_str!("../players/ros2/play.py")),
                ("ros2_robot.py", include_str!("../players/ros2/ros2_robot.py")),
                ("middleware.py", include_str!("../players/ros2/middleware.py")),
            ],
            Self::Correction => &[
                ("play.py", include_str!("../players/correction/play.py")),
                ("admittance.py", include_str!("../players/correction/admittance.py")),
                ("correction_robot.py", include_str!("../players/correction/correction_robot.py")),
            ],
            Self::Ros2Control => &[
                ("play.py", include_str!("../players/ros2_control/play.py")),
                ("joint_reference.py", include_str!("../players/ros2_control/joint_reference.py")),
                ("admittance_robot.py", include_str!("../players/ros2_control/admittance_robot.py")),
                ("middleware.py", include_str!("../players/ros2_control/middleware.py")),
            ],
        };
        let of_topics: &[File] = if matches!(self, Self::Ros2 | Self::Ros2Control) { &TOPICS } else { &[] };
        own.iter().chain(of_topics).chain(&SHARED).copied().collect()
    }

    /// The text of its README, with `{{names}}` for the numbers of a plan.
    pub(crate) fn readme(self) -> &'static str {
        match self {
            Self::Csv => include_str!("../players/csv/README.md"),
            Self::UrRtde => include_str!("../players/ur_rtde/README.md"),
            Self::Franka => include_str!("../players/franka/README.md"),
            Self::UrScript => include_str!("../players/urscript/README.md"),
            Self::Ros2 => include_str!("../players/ros2/README.md"),
            Self::Correction => include_str!("../players/correction/README.md"),
            Self::Ros2Control => include_str!("../players/ros2_control/README.md"),
            Self::Mjcf => include_str!("../models/mjcf.md"),
            Self::Sdf => include_str!("../models/sdf.md"),
            Self::Usd => include_str!("../models/usd.md"),
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.pad(self.name())
    }
}
