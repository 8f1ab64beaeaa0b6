//! The declarations of all keys but Ipopt's options.

use super::Absent::{Means, Number as Default, Refused};
use super::Values::{
    Choice, Direction, Directions, File, FileOrTable, Inertia, Integer, Length, Matrix, Name, Number, NumberOrMatrix,
    NumberOrNumbers, Numbers, Pairs, Quaternion, Table, Tables, Vector, Vectors,
};
use super::{Absent, Key, Values};
use crate::range::Range;

/// Units of mesh files.
pub const UNITS: &[&str] = &["m", "cm", "mm", "inch"];
/// Their lengths (m).
pub const SCALES: [f64; 4] = [1.0, 0.01, 0.001, 0.0254];
/// Which offsets are covered where the scene gives no directions.
pub const COVERAGES: &[&str] = &["disc", "ball"];
/// What a robot may be commanded.
pub const INTERFACES: &[&str] = &["torque", "position", "force"];
const _: () = assert!(SCALES.len() == UNITS.len());

const COORDINATE: Range = Range::closed(-1e3, 1e3);
const LENGTH: Range = Range::closed(1e-5, 1e3);
const NORMAL: Range = Range::closed(-1e6, 1e6);
const OFFSET: Range = Range::closed(-1e9, 1e9);
const STIFFNESS: Range = Range::closed(1e-3, 1e7);
const DAMPING: Range = Range::closed(0.0, 1e7);
const NOISE: Range = Range::closed(0.0, 1e3);
const WEIGHT: Range = Range::closed(0.0, 1e12);
const LIMIT: Range = Range::closed(1e-9, 1e9);
const RATE: Range = Range::open(0.0, 1.0);

const fn key(
    table: &'static str,
    name: &'static str,
    values: Values,
    unit: &'static str,
    absent: Absent,
    meaning: &'static str,
) -> Key {
    Key { table, name, values, unit, absent, meaning }
}

const UNLIMITED: Absent = Means("no limit");

/// Every key, in the order of the documentation.
#[rustfmt::skip]
pub const KEYS: &[Key] = &[
    key("", "title", Name, "", Means("the file's name without `.toml`"), "name of the scene in results"),
    key("", "homotopy", FileOrTable, "", Means("built-in homotopy"), "how the scene is solved: a homotopy file, or the table itself"),
    key("", "ipopt", Table, "", Means("Ipopt's defaults"), "options of Ipopt, only beside a `[homotopy]` table"),
    key("", "body", Table, "", Refused, "the moved object"),
    key("", "environment", Table, "", Refused, "what does not move"),
    key("", "contact", Table, "", Means("all pairs"), "which parts may touch"),
    key("", "start", Tables(1..=1000), "", Refused, "poses to start from; the first is the default"),
    key("", "goal", Table, "", Refused, "pose of the body at the end"),
    key("", "impedance", Table, "", Means("chosen"), "the robot's Cartesian impedance controller"),
    key("", "robustness", Table, "", Refused, "position errors to tolerate"),
    key("", "robot", Table, "", Means("a free body"), "the robot that moves the body"),
    key("", "gripper", Table, "", Means("none"), "what holds the body: warned of where it meets the environment, as are the collision shapes of the arm"),
    key("", "horizon", Table, "", Means("chosen"), "time grid of the plan"),
    key("", "cost", Table, "", Means("default weights"), "weights of the cost"),
    key("", "limits", Table, "", Means("no limits"), "what the plan must not exceed"),

    key("body", "mass", Number(Range::closed(1e-6, 1e6)), "kg", Default(1.0), "mass that the controller makes the robot feel like"),
    key("body", "inertia", Matrix(Range::closed(1e-12, 1e6)), "kg m^2", Default(0.1), "rotational inertia about the centre of mass: diagonal, or 3x3 matrix; by default the same about every axis"),
    key("body", "part", Tables(1..=1000), "", Refused, "convex parts of the body, in its frame; its origin is the centre of mass unless the parts have a `density`"),

    key("environment", "part", Tables(1..=1000), "", Refused, "convex parts of the environment, in the world frame"),

    key("gripper", "part", Tables(1..=1000), "", Refused, "convex parts of the gripper in the frame of the arm's `tip` (without an arm: of the body as the robot believes it to be held); a mesh or link stands for its convex hull"),

    key("part", "name", Name, "", Refused, "name of the part, unique in its body or environment"),
    key("part", "vertices", Vectors(COORDINATE, 4..=10_000), "m", Means("another shape"), "points whose convex hull is the part"),
    key("part", "box", Vector(LENGTH), "m", Means("another shape"), "edge lengths of a box with its centre at the part's origin"),
    key("part", "normals", Vectors(NORMAL, 4..=10_000), "", Means("another shape"), "outward normals of the halfspaces whose intersection is the part, of any length"),
    key("part", "offsets", Numbers(OFFSET, 4..=10_000), "m", Means("another shape"), "one per normal: all points p with `normal . p <= offset`; metres for unit normals"),
    key("part", "mesh", File, "", Means("another shape"), "a closed triangle mesh, convex or not: an STL or OBJ file; [its convex parts](meshes.md)"),
    key("part", "model", File, "", Means("another shape"), "an SDF, URDF or MJCF file: the part is the collision shapes of one of its links; [their convex parts](meshes.md)"),
    key("part", "link", Name, "", Means("the only link with collision shapes"), "link of the model, or body of an MJCF file"),
    key("part", "unit", Choice(UNITS), "", Means("no mesh"), "unit of the mesh file; needed with `mesh`, refused without"),
    key("part", "facets", Integer(Range::closed(3.0, 360.0)), "", Means("chosen from the gap"), "facets of a full turn that stand for round surfaces of the mesh or model"),
    key("part", "clearance", Length(Range::closed(0.0, 0.1)), "m", Means("nothing"), "length by which all surfaces of the mesh or model are moved into the material, for parts that are modelled without their fit; a number, or a text with its unit as `\"0.02 mm\"`"),
    key("part", "density", Number(Range::closed(1e-3, 1e6)), "kg/m^3", Means("`mass` and `inertia` of the body hold"), "density of the material of a mesh or model: gives the body its mass, centre of mass and inertia"),
    key("part", "position", Vector(COORDINATE), "m", Means("`[0, 0, 0]`"), "moves the part, after its rotation"),
    key("part", "orientation", Quaternion, "", Means("`[1, 0, 0, 0]`"), "rotates the part about its origin"),

    key("contact", "pairs", Pairs(1..=10_000), "", Means("every body part with every environment part"), "pairs that may touch: a body part and an environment part, each pair once"),
    key("contact", "friction", NumberOrNumbers(Range::closed(0.0, 2.0), 1..=5), "", Default(0.0), "Coulomb's coefficient of friction in the plan, or several that it tolerates at once; [the friction model](../concepts/friction.md)"),

    key("start", "name", Name, "", Refused, "unique name of the start, for `--start`"),
    key("start", "position", Vector(COORDINATE), "m", Refused, "position of the body's frame in the world"),
    key("start", "orientation", Quaternion, "", Refused, "orientation of the body's frame in the world"),

    key("goal", "position", Vector(COORDINATE), "m", Refused, "position of the body's frame in the world"),
    key("goal", "orientation", Quaternion, "", Refused, "orientation of the body's frame in the world"),
    key("goal", "position_tolerance", Number(Range::closed(1e-9, 1e3)), "m", Means("0.003, less for small bodies, short paths and shallow engagement, more where clearance or free directions leave more"), "largest final distance from the goal of a success"),
    key("goal", "angle_tolerance", Number(Range::closed(1e-9, 10.0)), "rad", Default(0.1), "largest final angle to the goal of a success"),

    key("impedance", "translational_stiffness", Number(STIFFNESS), "N/m", Means("1 m/s^2 x mass / offset_magnitude, 50 to 1000 N/m per kg"), "stiffness along every axis"),
    key("impedance", "rotational_stiffness", Number(STIFFNESS), "Nm/rad", Means("5 beside 50 N/m for 1 kg, and as the root of the stiffness"), "stiffness about every axis"),
    key("impedance", "translational_damping", NumberOrMatrix(DAMPING), "Ns/m", Means("critical damping"), "damping in the world frame: along every axis, along each, or 3x3 matrix"),
    key("impedance", "rotational_damping", Matrix(DAMPING), "Nms/rad", Means("critical damping"), "damping in the body frame: about each axis, or 3x3 matrix"),

    key("robustness", "offset_magnitude", Number(Range::closed(0.0, 10.0)), "m", Refused, "how far the body may be from where the robot believes it to be: a radius"),
    key("robustness", "coverage", Choice(COVERAGES), "", Means("`disc`"), "which offsets of up to `offset_magnitude` are covered: those across the insertion (`disc`) or in any direction (`ball`); not beside `offset_directions`"),
    key("robustness", "insertion_axis", Direction, "", Means("the straight line from the first start to the goal"), "axis of the disc, in the body frame"),
    key("robustness", "offset_directions", Directions(1..=1000), "", Means("chosen for `coverage`"), "one planned motion for each: its offset is magnitude x direction, in the body frame; `[0, 0, 0]` is no offset; covered is their convex hull"),
    key("robustness", "rotation_error", Number(Range::closed(0.0, 1.57)), "rad", Default(0.0), "how far the body may also be rotated in the gripper, about any axis; `--robust` tolerates it"),
    key("robustness", "rotation_axes", Directions(1..=1000), "", Means("no rotation errors"), "one for each of `offset_directions`: the axis (body frame) about which the body of the same planned motion is rotated by `rotation_error`; `[0, 0, 0]` is no rotation"),
    key("robustness", "friction", Numbers(Range::closed(0.0, 10.0), 1..=20), "", Means("`[0, 0.1, 0.3]`"), "Coulomb coefficients of contacts that `--robust` tolerates"),
    key("robustness", "inertia_error", Number(Range::closed(0.0, 0.9)), "", Default(0.0), "relative error of the inertia that `--robust` tolerates"),
    key("robustness", "stiffness_error", Number(Range::closed(0.0, 0.9)), "", Default(0.0), "relative error of the stiffness that `--robust` tolerates"),
    key("robustness", "delay", Number(Range::closed(0.0, 0.1)), "s", Default(0.0), "delay beyond that of the controller that `--robust` tolerates, of an arm or of a robot that is commanded by position or force"),
    key("robustness", "force_bias", Number(Range::closed(0.0, 1e3)), "N", Default(0.0), "error of every component of the measured force that `--robust` tolerates; not with the interface `torque`"),
    key("robustness", "torque_bias", Number(Range::closed(0.0, 1e3)), "Nm", Default(0.0), "error of every component of the measured torque that `--robust` tolerates; not with the interface `torque`"),
    key("robustness", "edge_radius", Number(Range::closed(0.0, 0.01)), "m", Means("half of the clearance at the goal, at most 0.0001"), "largest radius of edges: `--robust` tolerates that faces with a smaller overlap slip past each other"),

    key("robot", "urdf", File, "", Means("a free body"), "URDF file of the arm; the inertia is that of the arm at the goal"),
    key("robot", "tip", Name, "", Means("needed with `urdf`"), "link that holds the body"),
    key("robot", "grasp", Table, "", Means("the frame of the tip"), "pose of the body's frame in that of the tip"),
    key("robot", "base", Table, "", Means("the world frame"), "pose of the arm's base in the world frame"),
    key("robot", "configuration", Numbers(COORDINATE, 1..=8), "rad or m", Means("needed with `urdf`"), "joint positions near the goal, from the base on: they name the IK branch"),
    key("robot", "rotor_inertia", NumberOrNumbers(Range::closed(0.0, 1e3), 1..=8), "kg m^2 or kg", Default(0.0), "inertia of rotors and gears as the joints feel it, for all joints or for each"),
    key("robot", "joint_friction", NumberOrNumbers(Range::closed(0.0, 1e4), 1..=8), "Nm or N", Default(0.0), "friction that the controller leaves, for all joints or for each"),
    key("robot", "control_period", Number(Range::closed(1e-5, 0.1)), "s", Default(0.002), "time between two commands of the controller"),
    key("robot", "interface", Choice(INTERFACES), "", Means("`torque`"), "what the robot is commanded: joint torques, poses that an admittance law moves, or a wrench that the maker's force mode follows; [robots without a torque interface](../guide/position-robots.md)"),
    key("robot", "delay", Number(Range::closed(0.0, 0.1)), "s", Default(0.004), "time from a command to the motion that it causes; not with the interface `torque`"),
    key("robot", "bandwidth", Number(Range::closed(0.5, 1e3)), "Hz", Default(20.0), "frequency at which the motion is 3 dB smaller than its command; not with the interface `torque`"),
    key("robot", "contact_stiffness", Number(Range::closed(1e2, 1e8)), "N/m", Default(1e5), "stiffness of parts, gripper, sensor and joints together while parts touch: gains are stable up to it; not with the interface `torque`"),
    key("robot", "virtual_mass", Number(Range::closed(1e-3, 1e5)), "kg", Means("what is stable in contact"), "mass of the admittance law; not with the interface `torque`"),
    key("robot", "virtual_inertia", Number(Range::closed(1e-6, 1e4)), "kg m^2", Means("what is stable in contact"), "rotational inertia of the admittance law; not with the interface `torque`"),
    key("robot", "command", Table, "", Means("usual limits"), "largest speeds and accelerations that are commanded; not with the interface `torque`"),
    key("robot", "sensor", Table, "", Means("a usual sensor"), "the force-torque sensor at the flange; not with the interface `torque`"),
    key("robot", "force_mode", Table, "", Means("needed with the interface `force`"), "the maker's force mode; only with the interface `force`"),
    key("robot", "stiffness_range", Table, "", Means("any stiffness"), "stiffness that the controller accepts"),
    key("robot", "apparent_inertia", Inertia(Range::closed(-1e6, 1e6)), "kg, kg m, kg m^2", Means("that of the arm, else of the body"), "effective inertia of the body at the goal: for its velocity in the world frame and its angular velocity in the body frame; replaces `mass` and `inertia` of the body"),

    key("robot.grasp", "position", Vector(COORDINATE), "m", Means("`[0, 0, 0]`"), "position in the frame of the tip"),
    key("robot.grasp", "orientation", Quaternion, "", Means("`[1, 0, 0, 0]`"), "orientation in the frame of the tip"),

    key("robot.base", "position", Vector(COORDINATE), "m", Means("`[0, 0, 0]`"), "position in the world frame"),
    key("robot.base", "orientation", Quaternion, "", Means("`[1, 0, 0, 0]`"), "orientation in the world frame"),

    key("robot.stiffness_range", "translational", Numbers(STIFFNESS, 2..=2), "N/m", Means("any stiffness"), "lowest and highest"),
    key("robot.stiffness_range", "rotational", Numbers(STIFFNESS, 2..=2), "Nm/rad", Means("any stiffness"), "lowest and highest"),

    key("robot.command", "translational_velocity", Number(LIMIT), "m/s", Default(0.25), "largest speed"),
    key("robot.command", "rotational_velocity", Number(LIMIT), "rad/s", Default(1.0), "largest angular speed"),
    key("robot.command", "translational_acceleration", Number(LIMIT), "m/s^2", Default(2.5), "largest acceleration"),
    key("robot.command", "rotational_acceleration", Number(LIMIT), "rad/s^2", Default(10.0), "largest angular acceleration"),

    key("robot.sensor", "cutoff", Number(Range::closed(0.1, 1e5)), "Hz", Default(50.0), "cutoff frequency of its first-order filter"),
    key("robot.sensor", "force_noise", Number(NOISE), "N", Default(0.1), "standard deviation of every component of a sample"),
    key("robot.sensor", "torque_noise", Number(NOISE), "Nm", Default(0.005), "standard deviation of every component of a sample"),
    key("robot.sensor", "force_resolution", Number(NOISE), "N", Default(0.0), "smallest step of a component"),
    key("robot.sensor", "torque_resolution", Number(NOISE), "Nm", Default(0.0), "smallest step of a component"),

    key("robot.force_mode", "translational_gain", Number(Range::closed(1e-7, 1.0)), "m/s per N", Refused, "speed at which a difference between commanded and measured force moves the robot"),
    key("robot.force_mode", "rotational_gain", Number(Range::closed(1e-6, 1e3)), "rad/s per Nm", Refused, "speed at which a difference between commanded and measured torque rotates the robot"),
    key("robot.force_mode", "force_deadband", Number(NOISE), "N", Default(0.0), "part of the measured force that is ignored"),
    key("robot.force_mode", "torque_deadband", Number(NOISE), "Nm", Default(0.0), "part of the measured torque that is ignored"),

    key("horizon", "steps", Integer(Range::closed(1.0, 10_000.0)), "", Means("enough for the path and the controller: 3 s or more"), "number of time steps"),
    key("horizon", "time_step", Number(Range::closed(1e-5, 10.0)), "s", Means("0.04, or what makes `steps` last as long"), "length of a step"),

    key("cost", "reference", Table, "", Means("default weights"), "weights of the reference trajectory"),
    key("cost", "compliant", Table, "", Means("default weights"), "weights of the motion with each offset"),

    key("cost.reference", "translational_velocity", Number(WEIGHT), "", Default(1.0), "weight of the squared velocity in every step"),
    key("cost.reference", "rotational_velocity", Number(WEIGHT), "", Default(0.1), "weight of the squared angular velocity in every step"),
    key("cost.reference", "terminal_position", Number(WEIGHT), "", Default(100.0), "weight of the squared final position error"),
    key("cost.reference", "terminal_orientation", Number(WEIGHT), "", Default(10.0), "weight of the squared final error of the rotation matrix"),

    key("cost.compliant", "translational_velocity", Number(WEIGHT), "", Default(1.0), "weight of the squared velocity in every step"),
    key("cost.compliant", "rotational_velocity", Number(WEIGHT), "", Default(0.1), "weight of the squared angular velocity in every step"),
    key("cost.compliant", "terminal_position", Number(WEIGHT), "", Default(10_000.0), "weight of the squared final position error"),
    key("cost.compliant", "terminal_orientation", Number(WEIGHT), "", Default(1000.0), "weight of the squared final error of the rotation matrix"),

    key("limits", "translational_velocity", Number(LIMIT), "m/s", Means("what arm and `contact_force` allow, else no limit"), "velocity, in the world frame"),
    key("limits", "rotational_velocity", Number(LIMIT), "rad/s", Means("what arm and `contact_force` allow, else no limit"), "angular velocity, in the body frame"),
    key("limits", "translational_acceleration", Number(LIMIT), "m/s^2", UNLIMITED, "change of the velocity from step to step"),
    key("limits", "rotational_acceleration", Number(LIMIT), "rad/s^2", UNLIMITED, "change of the angular velocity from step to step"),
    key("limits", "contact_force", Number(LIMIT), "N", UNLIMITED, "normal force of each pair of parts"),
    key("limits", "force", Number(LIMIT), "N", UNLIMITED, "force of the impedance controller, in the world frame"),
    key("limits", "torque", Number(LIMIT), "Nm", UNLIMITED, "torque of the impedance controller, in the body frame"),

    key("homotopy", "iterations", Integer(Range::closed(1.0, 100.0)), "", Default(5.0), "smallest number of homotopy steps, each with less smoothing than the one before"),
    key("homotopy", "further_iterations", Integer(Range::closed(0.0, 100.0)), "", Default(10.0), "largest number of further homotopy steps, until parts penetrate by less than a tenth of the clearance at the goal"),
    key("homotopy", "coarse_iterations", Integer(Range::closed(0.0, 100.0)), "", Default(4.0), "number of first homotopy steps with half of the time steps and merged pieces, which saves time; at most all but one of `iterations`"),
    key("homotopy", "tau", Number(Range::closed(1e-9, 1.0)), "N m", Default(0.003), "smoothing of the distances in the first homotopy step"),
    key("homotopy", "sigma", Number(Range::closed(1e-12, 1.0)), "N m", Default(0.0015), "how far force x gap may be from zero in the first homotopy step, at 50 N/m; in proportion to the stiffness at others"),
    key("homotopy", "mu_init", Number(Range::above(1e-12, 1e6)), "", Default(0.01), "initial barrier parameter of Ipopt in the first homotopy step"),
    key("homotopy", "tau_rate", Number(RATE), "", Default(0.3), "factor of `tau` from one homotopy step to the next"),
    key("homotopy", "sigma_rate", Number(RATE), "", Default(0.5), "factor of `sigma` from one homotopy step to the next"),
    key("homotopy", "mu_rate", Number(Range::above(0.0, 1.0)), "", Default(0.3), "factor of `mu_init` from one homotopy step to the next"),
    key("homotopy", "complementarity", Choice(&["relaxation", "smoothing"]), "", Means("`relaxation`"), "whether force x gap is at most `sigma` (relaxation) or equal to it (smoothing)"),
    key("homotopy", "hessian", Choice(&["exact", "gauss-newton", "l-bfgs"]), "", Means("`exact`"), "second derivatives of the solver"),
    key("homotopy", "linear_solver", Choice(&["stage", "mumps", "ma27", "ma57", "ma97"]), "", Means("`stage`"), "solver of the linear systems in Ipopt"),
];

/// The tables of a homotopy file.
#[rustfmt::skip]
pub const HOMOTOPY_FILE: &[Key] = &[
    key("", "homotopy", Table, "", Means("default values"), "how the problem is solved"),
    key("", "ipopt", Table, "", Means("Ipopt's defaults"), "options of Ipopt"),
];
