//! The arm that moves the body.

use nalgebra::Vector6;
use robot::Arm;
use scene::{Scene, SceneError, Source, default_homotopy, resolved};

use crate::support::{SCENE, apparent_inertia, folder};

fn load(robot: &str) -> Result<Scene, SceneError> {
    Scene::parse(Source { file: "test.toml".as_ref(), text: &format!("{SCENE}[robot]\n{robot}\n") })
}

#[test]
fn an_apparent_inertia_replaces_that_of_the_body() {
    let rows = apparent_inertia([12.0, 7.0, 8.0, 1.5, 1.2, 0.8]).replacen("0.0, 0.0]", "0.0, 0.5]", 1);
    let rows = rows.replacen("[0.0, 0.0, 0.0, 0.0, 0.0, 0.8]", "[0.5, 0.0, 0.0, 0.0, 0.0, 0.8]", 1);
    let scene = load(&format!("apparent_inertia = {rows}")).unwrap();
    assert_eq!((scene.inertia.translational()[(0, 0)], scene.inertia.coupling()[(0, 2)]), (12.0, 0.5));
    assert_eq!(scene.inertia.mass(), None);
    // Critical damping follows.
    let stiffness = scene.impedance.translational_stiffness;
    let damping = scene.impedance.translational_damping[(1, 1)];
    assert!((damping - 2.0 * (7.0 * stiffness).sqrt()).abs() < 1e-9, "{damping}");
    let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
    let again = Scene::parse(Source { file: "resolved.toml".as_ref(), text: &text }).unwrap();
    assert_eq!((again.inertia, again.impedance), (scene.inertia, scene.impedance));
}

#[test]
fn an_apparent_inertia_that_is_none_is_refused() {
    let right = apparent_inertia([1.0; 6]);
    for (wrong, words) in [
        (right.replacen("[1.0, 0.0", "[1.0, 0.5", 1), "robot.apparent_inertia must be symmetric (kg, kg m, kg m^2)"),
        (apparent_inertia([1.0, 1.0, 0.0, 1.0, 1.0, 1.0]), "robot.apparent_inertia must be positive definite"),
        (apparent_inertia([1.0, 1.0, -1.0, 1.0, 1.0, 1.0]), "robot.apparent_inertia must be positive definite"),
        (right.replacen("1.0", "nan", 1), "robot.apparent_inertia: nan must lie between -1e6 and 1e6"),
        (
            "[1, 1, 1, 1, 1, 1]".to_owned(),
            "each row of robot.apparent_inertia must be a list of 6 numbers, not a number",
        ),
        ("[[1]]".to_owned(), "robot.apparent_inertia must have 6 rows, not 1"),
        ("5.0".to_owned(), "robot.apparent_inertia must be a list of 6 rows, not a number"),
    ] {
        let error = load(&format!("apparent_inertia = {wrong}")).unwrap_err();
        assert!(error.message().contains(words), "{error}");
    }
}

const CONFIGURATION: [f64; 6] = [0.3, -1.2, 1.7, -1.9, -1.5, 0.4];

/// Keys of an arm that holds the body at its goal.
fn arm() -> String {
    let urdf = folder("crates/robot/tests/arms/six.urdf");
    let arm = Arm::read(&urdf, "tip").unwrap();
    let base = arm.pose(&arm.configuration(&CONFIGURATION).unwrap()).inverse();
    let (p, q) = (base.translation.vector, base.rotation);
    format!(
        "urdf = {urdf:?}\ntip = \"tip\"\nconfiguration = {CONFIGURATION:?}\nrotor_inertia = 0.1\nbase = {{ position = \
         [{:?}, {:?}, {:?}], orientation = [{:?}, {:?}, {:?}, {:?}] }}",
        p.x, p.y, p.z, q.w, q.i, q.j, q.k
    )
}

/// The scene without controller and mass, with an arm and other lines of its robot.
fn with_arm(arm: &str, lines: &str) -> Result<Scene, SceneError> {
    let text = SCENE.replace("[impedance]\ntranslational_stiffness = 50.0\nrotational_stiffness = 5.0\n", "");
    let text = format!("{text}[robot]\n{arm}\n{lines}\n");
    Scene::parse(Source { file: "test.toml".as_ref(), text: &text })
}

#[test]
fn an_arm_gives_the_body_its_inertia_and_its_controller_a_stiffness() {
    let scene = with_arm(&arm(), "").unwrap();
    let robot = scene.robot.as_ref().unwrap();
    let configured = robot.arm.at(&robot.configuration);
    assert_eq!(scene.inertia.matrix(), &configured.apparent_inertia().unwrap());
    let similar = 50.0 * scene.inertia.mean_mass();
    assert!((scene.impedance.translational_stiffness / similar - 1.0).abs() < 1e-9);
    let stiff = with_arm(&arm(), "joint_friction = 0.5").unwrap();
    let holds = stiff.robot.as_ref().unwrap().friction_wrench.unwrap();
    let deadband = holds.deadband(stiff.impedance.translational_stiffness, stiff.impedance.rotational_stiffness);
    assert!(deadband.distance < 4.000001e-3 && deadband.angle < 0.040001, "{deadband:?}");
    // Where contact forces allow no more, the deadband may be 0.3 of the offset magnitude.
    let gentle = with_arm(&arm(), "joint_friction = 0.5\n[limits]\ncontact_force = 20.0").unwrap();
    let softer = gentle.impedance.translational_stiffness;
    assert!((softer * gentle.offset_magnitude - 20.0).abs() < 1e-9, "{softer}");
    assert_eq!(gentle.impedance.rotational_stiffness, stiff.impedance.rotational_stiffness);
    assert!(stiff.impedance.translational_stiffness > scene.impedance.translational_stiffness);

    // Whatever the directions, no joint is too slow.
    let limits = scene.limits;
    assert!(
        scene.chosen.iter().any(|chosen| chosen.starts_with("limits.translational_velocity")),
        "{:?}",
        scene.chosen
    );
    let joints = configured.jacobian().fixed_columns::<6>(0).try_inverse().unwrap();
    let (v, w) = (limits.translational_velocity, limits.rotational_velocity);
    for signs in 0..64u32 {
        let sign = |axis: usize| if signs >> axis & 1 == 0 { 1.0 } else { -1.0 };
        let speeds = joints * Vector6::from_fn(|axis, _| sign(axis) * if axis < 3 { v } else { w });
        for (joint, speed) in robot.arm.joints().iter().zip(speeds.iter()) {
            assert!(speed.abs() <= joint.velocity * (1.0 + 1e-9), "{}: {speed}", joint.name);
        }
    }

    let text = resolved(&stiff, &stiff.starts[0], stiff.offset_magnitude, &default_homotopy());
    let again = Scene::parse(Source { file: "resolved.toml".as_ref(), text: &text }).unwrap();
    assert_eq!((again.inertia, again.impedance), (stiff.inertia, stiff.impedance));
    assert_eq!(again.robot.unwrap().joint_friction, [0.5; 6]);
}

#[test]
fn what_is_wrong_with_an_arm_is_said_where_it_stands() {
    let arm = arm();
    let force = "\n[limits]\ncontact_force = 1.0";
    for (arm, lines, words) in [
        ("tip = \"tip\"", "", "robot.tip needs `urdf`"),
        (&*arm.replace("\"tip\"", "\"tipp\""), "", "did you mean `tip`?"),
        (&*arm.replace("six.urdf", "none.urdf"), "", "none.urdf"),
        (&*arm.replace("0.3, ", ""), "", "5"),
        (&*arm.replace("[0.3, -1.2", "[99.0, -1.2"), "", "99"),
        (
            &*arm.replace("position = [", "position = [9"),
            "",
            "the arm does not reach the goal from these joint positions",
        ),
        (
            &*arm,
            "joint_friction = [0.1, 0.2]",
            "robot.joint_friction has 2 numbers: one for all joints, or one for each of 6",
        ),
        (&*arm, "control_period = 0", "robot.control_period = 0: must lie between"),
        (&*arm, "stiffness_range = { translational = [200, 100] }", "must be the lowest and the highest stiffness"),
        (&*arm, "joint_friction = 5", "no stiffness of translations suits this robot"),
        (&*arm, &*format!("joint_friction = 0.5{force}"), "no stiffness of translations suits this robot"),
    ] {
        let error = with_arm(arm, lines).map(|scene| scene.impedance).unwrap_err();
        assert!(error.message().contains(words), "{words}: {error}");
        assert!(error.line().is_some());
    }
    let far = SCENE.replace("position = [0, 0, 0.09]", "position = [0, 0, 3]");
    let error =
        Scene::parse(Source { file: "test.toml".as_ref(), text: &format!("{far}[robot]\n{arm}\n") }).unwrap_err();
    assert!(error.message().contains("the arm does not reach start `a` on the straight path from the goal"), "{error}");
    let given = format!("{SCENE}[robot]\n{arm}\nstiffness_range = {{ translational = [100, 3000] }}\n");
    let error = Scene::parse(Source { file: "test.toml".as_ref(), text: &given }).unwrap_err();
    assert!(error.message().contains("must lie in robot.stiffness_range, 100 to 3000"), "{error}");
}

#[test]
fn what_an_arm_replaces_is_remarked() {
    let text =
        format!("{}[robot]\n{}\n", SCENE.replacen("[[body.part]]", "[body]\nmass = 2.0\n[[body.part]]", 1), arm());
    let scene = Scene::parse(Source { file: "test.toml".as_ref(), text: &text }).unwrap();
    assert!(
        scene.warnings[0].contains("body.mass is not used: the robot's inertia replaces it"),
        "{:?}",
        scene.warnings
    );
}

#[test]
fn a_stiffness_that_is_chosen_beside_a_given_one_is_in_the_range_of_the_robot() {
    let range = "stiffness_range = { rotational = [150, 200] }\n[impedance]\ntranslational_stiffness = 425.0";
    let impedance = with_arm(&arm(), range).unwrap().impedance;
    assert_eq!((impedance.translational_stiffness, impedance.rotational_stiffness), (425.0, 150.0));
}
