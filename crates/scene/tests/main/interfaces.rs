//! Robots that are commanded by position or force.

use scene::{Scene, SceneError, Source, default_homotopy, resolved};

use crate::support::SCENE;

/// A scene without gains, with other tables.
fn load(tables: &str) -> Result<Scene, SceneError> {
    let (start, rest) = SCENE.split_once("[impedance]").unwrap();
    let (_, rest) = rest.split_once("[robustness]").unwrap();
    let text = format!("{start}[robustness]{rest}{tables}\n");
    Scene::parse(Source { file: "test.toml".as_ref(), text: &text })
}

fn refusal(robot: &str) -> String {
    load(robot).unwrap_err().to_string()
}

const POSITION: &str = "[robot]\ninterface = \"position\"\n";
const FORCE: &str =
    "[robot]\ninterface = \"force\"\nforce_mode = { translational_gain = 1e-4, rotational_gain = 0.02 }\n";

#[test]
fn a_robot_with_torques_has_no_admittance() {
    assert_eq!(load("").unwrap().position_robot, None);
    assert_eq!(load("[robot]\ninterface = \"torque\"").unwrap().position_robot, None);
    for (key, value) in
        [("delay", "0.01"), ("bandwidth", "10.0"), ("contact_stiffness", "1e5"), ("virtual_mass", "1.0")]
    {
        let message = refusal(&format!("[robot]\n{key} = {value}"));
        assert!(
            message.contains(&format!("robot.{key} is for robots that are commanded by position or force")),
            "{message}"
        );
    }
}

#[test]
fn the_chosen_law_is_stable_and_the_plan_has_its_lag() {
    let scene = load(POSITION).unwrap();
    let robot = scene.position_robot.as_ref().unwrap();
    let of = robot.contact_loop();
    assert!(of.sensitivity(&robot.gains) <= admittance::LARGEST_SENSITIVITY);
    assert_eq!(scene.impedance, robot.gains.impedance());
    let (inertia, impedance) = scene.planned_dynamics();
    assert!(inertia.mean_mass() > robot.gains.mass[0] + robot.gains.damping[0] * of.lag());
    assert_eq!(impedance.translational_stiffness, scene.impedance.translational_stiffness);
    let task = scene.task(None, None).unwrap();
    assert_eq!((task.inertia, task.impedance), (inertia, impedance));
    // A third of 60 N at the largest offset.
    let pressing = 20.0 / scene.offset_magnitude;
    assert!((robot.gains.stiffness[0] - pressing.min(5e3)).abs() < 1e-9);
}

#[test]
fn a_resolved_scene_is_the_same_robot() {
    for robot in [
        POSITION,
        FORCE,
        "[robot]\ninterface = \"position\"\ndelay = 0.02\ncontrol_period = 0.008\ncontact_stiffness = 5e4\n\
         sensor = { cutoff = 30.0, force_noise = 0.2 }\ncommand = { translational_velocity = 0.5 }\n",
    ] {
        let scene = load(robot).unwrap();
        let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
        let again = Scene::parse(Source { file: "resolved.toml".as_ref(), text: &text }).unwrap();
        assert_eq!(again.position_robot, scene.position_robot, "{text}");
        let written = resolved(&again, &again.starts[0], again.offset_magnitude, &default_homotopy());
        assert_eq!(written, text);
    }
}

#[test]
fn the_chosen_stiffness_stays_in_the_range_of_the_controller() {
    let scene =
        load(&format!("{POSITION}stiffness_range = {{ translational = [100, 300], rotational = [1, 20] }}")).unwrap();
    assert_eq!(scene.position_robot.unwrap().gains.stiffness, [300.0, 20.0]);
    let range = "stiffness_range = { translational = [100, 300] }";
    let message = refusal(&format!("[impedance]\ntranslational_stiffness = 500.0\n{POSITION}{range}"));
    assert!(message.contains("must lie in robot.stiffness_range, 100 to 300"), "{message}");
}

#[test]
fn a_force_mode_is_a_law_with_the_inverse_gains() {
    let scene = load(FORCE).unwrap();
    let robot = scene.position_robot.unwrap();
    assert_eq!(robot.gains.damping, [1e4, 50.0]);
    assert!(robot.force_mode.is_some());
}

#[test]
fn laws_that_are_unstable_in_contact_are_refused_with_those_that_are_not() {
    let message = refusal("[impedance]\ntranslational_damping = 100.0\n[robot]\ninterface = \"position\"");
    assert!(
        message.contains("not stable against a contact of 100000 N/m with a lag of 19.4 ms: chosen are"),
        "{message}"
    );
    let message = refusal(&FORCE.replace("1e-4", "1e-2"));
    assert!(message.contains("this force mode is not stable against a contact of 100000 N/m"), "{message}");
    let message = refusal("[robot]\ninterface = \"force\"");
    assert!(message.contains("missing key `translational_gain` in [robot.force_mode]"), "{message}");
    let message = refusal(&format!("{FORCE}virtual_mass = 3.0"));
    assert!(message.contains("robot.virtual_mass is not used with the interface `force`"), "{message}");
    let message = refusal("[impedance]\ntranslational_damping = [1e4, 1e4, 2e4]\n[robot]\ninterface = \"position\"");
    assert!(message.contains("must be positive and the same along every axis"), "{message}");
}
