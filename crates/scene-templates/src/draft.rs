//! Scenes as text that people read and change: every key has a comment with its meaning, unit and usual values.

use scene::{duration, horizon, key, rotational_stiffness, translational_stiffness};
use task::{Horizon, Pose};
use toml::Value;

/// The individual content of a scene to be written. Lengths are in metres.
pub struct Draft {
    /// Description of the scene: lines of a comment at its top.
    pub about: Vec<String>,
    /// Parts of the body, in its frame.
    pub body: Vec<DraftPart>,
    /// Parts of the environment, in the world frame.
    pub environment: Vec<DraftPart>,
    /// Start poses (position, unit quaternion w x y z), named by their numbers.
    pub starts: Vec<Pose>,
    /// Goal pose.
    pub goal: Pose,
    /// Position tolerance, where it is not to be chosen.
    pub position_tolerance: Option<f64>,
    /// Offset magnitude, above zero; the stiffness is chosen for it.
    pub offset: f64,
    /// Largest contact force (N), if plans should keep one.
    pub contact_force: Option<f64>,
}

/// A part of a scene to be written.
pub struct DraftPart {
    /// Its name.
    pub name: String,
    /// Its shape.
    pub shape: DraftShape,
    /// Position of the shape, where that is not the origin.
    pub position: Option<[f64; 3]>,
}

/// The shape of a part.
pub enum DraftShape {
    /// Edge lengths of a box.
    Box([f64; 3]),
    /// Points whose convex hull it is.
    Vertices(Vec<[f64; 3]>),
    /// A file, relative to the scene, and its unit.
    Mesh(String, &'static str),
    /// A file of a model, relative to the scene, and the name of the link where it has several.
    Model(String, Option<String>),
}

/// Comment at the top of all scenes.
const HELP: &str = "\
#
# Lengths are in metres, orientations are quaternions [w, x, y, z]. `assembly-plan check` explains this file,
# `assembly-plan solve` plans it, docs/reference/scene.md lists all keys. To use a line that begins with #key, remove the #.

# name of the scene in results; without it, the name of this file
#title = \"my scene\"
";

/// Mass (kg) of the body.
const MASS: f64 = 1.0;

impl Draft {
    /// Text of the scene file.
    pub fn text(&self) -> String {
        let mut text: String = self.about.iter().map(|line| format!("# {line}\n")).collect();
        text += HELP;
        self.write_parts(&mut text);
        self.write_poses(&mut text);
        self.write_controller(&mut text);
        self.write_robustness(&mut text);
        text
    }

    fn write_parts(&self, text: &mut String) {
        *text += "\n[body]\n";
        entry(text, "body", "mass", &number(MASS), "0.5 to 20");
        entry(text, "body", "inertia", "[0.1, 0.1, 0.1]", "0.01 to 1");
        *text += "\n# The convex parts of the body, in its frame, whose origin is the centre of mass. Each has one shape: `box` (edge\n\
                  # lengths), `vertices` (corners), `mesh` with `unit`, or `model`; `position` and `orientation` place it.\n";
        self.body.iter().for_each(|part| part.write("body", text));
        *text += "# The convex parts of the environment, which does not move, in the world frame.\n";
        self.environment.iter().for_each(|part| part.write("environment", text));
        *text += "# Which parts may touch; without this table, all. Each pair costs time.\n#[contact]\n";
        *text += &format!("#pairs = [[{}, {}]]\n", name(&self.body), name(&self.environment));
    }

    fn write_poses(&self, text: &mut String) {
        for (number, pose) in (1..).zip(&self.starts) {
            *text += if number == 1 { "\n# Poses to start from; the first is the default.\n" } else { "\n" };
            *text += &format!("[[start]]\nname = \"{number}\"\n{}", pose_lines(pose));
        }
        *text += &format!("\n# Pose of the body at the end.\n[goal]\n{}", pose_lines(&self.goal));
        if let Some(tolerance) = self.position_tolerance {
            entry(text, "goal", "position_tolerance", &number(tolerance), "0.0002 to 0.003");
        }
    }

    fn write_controller(&self, text: &mut String) {
        let translational = self.stiffness();
        let rotational = rounded(rotational_stiffness(translational, MASS));
        *text += "\n# The robot's Cartesian impedance controller, as it will be set.\n[impedance]\n";
        entry(text, "impedance", "translational_stiffness", &number(translational), "50 to 1000");
        entry(text, "impedance", "rotational_stiffness", &number(rotational), "5 to 50");
    }

    fn stiffness(&self) -> f64 {
        rounded(translational_stiffness(self.offset, MASS))
    }

    fn horizon(&self) -> Horizon {
        let time_constant = (MASS / self.stiffness()).sqrt();
        horizon(duration(self.starts.iter(), &self.goal, time_constant), None, None)
    }

    fn write_robustness(&self, text: &mut String) {
        *text += "\n# How far the body may be off in the gripper: one plan is made for all of these offsets.\n[robustness]\n";
        entry(text, "robustness", "offset_magnitude", &number(self.offset), "0.001 to 0.02");
        entry(text, "robustness", "coverage", "\"disc\"", "\"disc\"");
        *text += "\n[horizon]\n";
        let horizon = self.horizon();
        entry(text, "horizon", "steps", &horizon.steps.to_string(), "50 to 200");
        entry(text, "horizon", "time_step", &number(horizon.time_step), "0.02 to 0.08");
        self.write_limits(text);
    }

    fn write_limits(&self, text: &mut String) {
        *text += "\n# What the plan must not exceed; without this table, there are no limits.\n";
        let force = self.contact_force;
        let sign = if force.is_some() { "" } else { "#" };
        *text += &format!("{sign}[limits]\n");
        comment(text, "limits", "contact_force", "5 to 60");
        *text += &format!("{sign}contact_force = {}\n", number(force.unwrap_or(20.0)));
        comment(text, "limits", "translational_velocity", "0.05 to 1");
        *text += "#translational_velocity = 0.25\n";
    }
}

impl DraftPart {
    fn write(&self, parent: &str, text: &mut String) {
        *text += &format!("[[{parent}.part]]\nname = {}\n", Value::from(self.name.as_str()));
        *text += &match &self.shape {
            DraftShape::Box(edges) => format!("box = {}\n", numbers(edges)),
            DraftShape::Vertices(vertices) => {
                let vertices: Vec<String> = vertices.iter().map(|vertex| numbers(vertex)).collect();
                format!("vertices = [{}]\n", vertices.join(", "))
            }
            DraftShape::Model(file, link) => {
                let link = link.iter().map(|link| format!("link = {}\n", Value::from(link.as_str())));
                format!("model = {}\n{}", Value::from(file.as_str()), link.collect::<String>())
            }
            DraftShape::Mesh(file, unit) => format!("mesh = {}\nunit = \"{unit}\"\n", Value::from(file.as_str())),
        };
        if let Some(position) = &self.position {
            *text += &format!("position = {}\n", numbers(position));
        }
        text.push('\n');
    }
}

/// The quoted name of the first of some parts.
fn name(parts: &[DraftPart]) -> String {
    Value::from(parts[0].name.as_str()).to_string()
}

/// A key with its comment.
fn entry(text: &mut String, table: &str, name: &str, value: &str, usual: &str) {
    comment(text, table, name, usual);
    *text += &format!("{name} = {value}\n");
}

/// Comment on a key: its meaning, unit and usual values.
fn comment(text: &mut String, table: &str, name: &str, usual: &str) {
    let key = key(table, name);
    let unit = if key.unit.is_empty() { String::new() } else { format!(" ({})", key.unit) };
    *text += &format!("# {}{unit}; usual: {usual}\n", key.meaning);
}

fn pose_lines(pose: &Pose) -> String {
    format!("position = {}\norientation = {}\n", numbers(&pose[..3]), numbers(&pose[3..]))
}

fn numbers(numbers: &[f64]) -> String {
    format!("[{}]", numbers.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "))
}

/// A number to the picometre, so that what lies in a plane still does.
fn number(value: f64) -> String {
    // Adding zero makes -0 a plain one.
    format!("{:?}", (value * 1e12).round() / 1e12 + 0.0)
}

/// A number with two digits, for values that need no more.
pub fn rounded(value: f64) -> f64 {
    let unit = 10f64.powf(value.abs().log10().floor() - 1.0);
    if value == 0.0 { 0.0 } else { (value / unit).round() * unit }
}
