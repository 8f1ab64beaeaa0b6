//! Files and numbers that are no arm are refused with file, line and what to do.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use robot::{Arm, JointVector, RigidInertia, RobotError};

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms").join(name)
}

fn six() -> String {
    fs::read_to_string(path("six.urdf")).unwrap()
}

/// What reading a text says, with the line that the message points to.
fn refusal(text: &str, tip: &str) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.urdf");
    fs::write(&file, text).unwrap();
    let error: RobotError = Arm::read(&file, tip).unwrap_err();
    let line = error.line().map(|line| text.lines().nth(line - 1).unwrap().trim().to_owned());
    let place = error.line().map_or(String::new(), |line| format!(":{line}"));
    assert_eq!(error.to_string(), format!("{}{place}: {}", file.display(), error.message()));
    (error.message().to_owned(), line.unwrap_or_default())
}

/// Checks the message for the arm of six joints with `from` replaced, and the beginning of the line that it points to.
fn check(from: &str, to: &str, message: &str, line: &str) {
    let original = six();
    assert!(original.contains(from), "{from}");
    let (actual, place) = refusal(&original.replacen(from, to, 1), "tip");
    assert_eq!(actual, message);
    assert!(if line.is_empty() { place.is_empty() } else { place.starts_with(line) }, "{message}: {place}");
}

#[test]
fn the_test_arms_are_read() {
    let arm = Arm::read(&path("six.urdf"), "tip").unwrap();
    let joints = arm.joints();
    assert_eq!(joints.len(), 6);
    assert_eq!((joints[2].lower, joints[2].upper, joints[2].velocity, joints[2].effort), (-3.0, 3.0, 3.1, 150.0));
    assert_eq!((joints[5].lower, joints[5].upper), (f64::NEG_INFINITY, f64::INFINITY));
    // A tip further back has fewer joints.
    assert_eq!(Arm::read(&path("six.urdf"), "wrist_1").unwrap().joints().len(), 4);
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let error = Arm::read(Path::new("no/such.urdf"), "tip").unwrap_err();
    assert!(error.to_string().starts_with("no/such.urdf: cannot be read: "), "{error}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.urdf");
    fs::write(&file, [0xff, 0xfe, 0x00]).unwrap();
    assert_eq!(Arm::read(&file, "tip").unwrap_err().message(), "the file is not UTF-8 text: save it as UTF-8");
    fs::write(&file, vec![b' '; (1 << 20) + 1]).unwrap();
    let message = "it is larger than 1 MiB: remove what is not links and joints";
    assert_eq!(Arm::read(&file, "tip").unwrap_err().message(), message);
}

#[test]
fn text_that_is_no_urdf_is_refused() {
    let (message, line) = refusal("<robot>\n<link name=\"a\">\n</robot>\n", "a");
    assert!(message.starts_with("this is not valid XML: "), "{message}");
    assert_eq!(line, "</robot>");
    let sdf = "<sdf/>";
    assert_eq!(refusal(sdf, "a"), ("a URDF begins with <robot>, this file with <sdf>".to_owned(), sdf.to_owned()));
    let message = "the file has no <link>: an arm needs links and joints";
    assert_eq!(refusal("<robot/>", "a"), (message.to_owned(), String::new()));
    let xacro = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<xacro:include filename=\"a\"/>\n</robot>";
    let message =
        "this is a xacro file: expand it first, with `xacro FILE.urdf.xacro > FILE.urdf` in a ROS environment";
    assert_eq!(refusal(xacro, "a"), (message.to_owned(), "<xacro:include filename=\"a\"/>".to_owned()));
}

#[test]
fn a_tip_that_is_no_link_behind_a_joint_is_refused() {
    let message = |tip: &str| refusal(&six(), tip).0;
    assert_eq!(message("wrist3"), "there is no link `wrist3`, did you mean `wrist_3`?");
    assert_eq!(
        message("%"),
        "there is no link `%`; there are: base, shoulder, upper_arm, forearm, camera, wrist_1, wrist_2, wrist_3, flange, \
         tip, plate"
    );
    assert_eq!(message("base"), "no joint moves between `base` and `base`: choose a tip behind the joints");
}

#[test]
fn links_and_joints_that_are_not_written_as_they_should_are_refused() {
    check("<link name=\"base\"/>", "<link/>", "<link> needs the attribute `name`", "<link/>");
    check(
        "<link name=\"flange\"/>",
        "<link name=\"camera\"/>",
        "there is another link `camera` in line 48: give each link its own name",
        "<link name=\"camera\"/>",
    );
    check(
        "name=\"lift\"",
        "name=\"pan\"",
        "there is another joint `pan` in line 13: give each joint its own name",
        "<joint name=\"pan\" type=\"revolute\">",
    );
    check(
        "<mass value=\"3.4\"/>",
        "<mass value=\"3,4\"/>",
        "link `shoulder`: `value` of <mass> is `3,4`: give a number from -1e9 to 1e9",
        "<mass value=\"3,4\"/>",
    );
    check("<mass value=\"3.4\"/>", "", "link `shoulder`: <inertial> needs <mass>", "<inertial>");
    check(
        "<mass value=\"3.4\"/>",
        "<mass value=\"3\"/>\n<mass value=\"4\"/>",
        "link `shoulder`: a second <mass>: remove one of them",
        "<mass value=\"4\"/>",
    );
    check(
        "izz=\"0.0066\" ",
        "",
        "link `shoulder`: <inertia> needs the attribute `izz`",
        "<inertia ixx=\"0.0081\" iyy=\"0.0075\" ixy",
    );
    check(
        "xyz=\"0 0 0.17\"",
        "xyz=\"0 0.17\"",
        "joint `pan`: `xyz` of <origin> is `0 0.17`: give three numbers from -1e9 to 1e9",
        "<origin xyz=\"0 0.17\"",
    );
    check(
        "rpy=\"0.1 -0.2 0.3\"",
        "quat_xyzw=\"0 0 0 1\"",
        "link `shoulder`: <origin> has xyz and rpy, and no `quat_xyzw`",
        "<origin xyz=\"0.002 -0.004 -0.03\" quat_xyzw",
    );
    check("<axis xyz=\"0 0 2\"/>", "<axis xyz=\"0 0 0\"/>", "joint `wrist_1_joint`: the axis has no length", "<axis");
    check(
        "type=\"continuous\"",
        "type=\"continous\"",
        "joint `wrist_3_joint`: unknown type `continous`, did you mean `continuous`?",
        "<joint name=\"wrist_3_joint\"",
    );
    check(
        "<parent link=\"wrist_1\"/>",
        "<parent link=\"wrist1\"/>",
        "joint `wrist_2_joint`: parent link `wrist1` does not exist, did you mean `wrist_1`?",
        "<parent link=\"wrist1\"/>",
    );
}

#[test]
fn inertias_of_no_body_are_refused() {
    check(
        "<mass value=\"3.4\"/>",
        "<mass value=\"-3.4\"/>",
        "link `shoulder`: a mass of -3.4 kg makes no sense: give a finite number that is not negative",
        "<inertial>",
    );
    check(
        "ixx=\"0.0004\"",
        "ixx=\"-0.0004\"",
        "link `camera`: the rotational inertia has a principal moment of -4.000e-4 kg m^2: none may be negative; check \
         the signs of the products of inertia",
        "<inertial>",
    );
    let new = |mass: f64, centre: f64, matrix: Matrix3<f64>| {
        RigidInertia::new(mass, Vector3::from_element(centre), matrix).unwrap_err().to_string()
    };
    assert_eq!(
        new(1.0, f64::NAN, Matrix3::identity()),
        "the centre of mass has a coordinate that is not a finite number"
    );
    let message = "the rotational inertia must be a symmetric matrix of finite numbers";
    assert_eq!(new(1.0, 0.0, Matrix3::new(1.0, 0.2, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 1.0)), message);
    assert_eq!(new(1.0, 0.0, Matrix3::from_element(f64::NAN)), message);
}

#[test]
fn joints_that_an_arm_cannot_have_are_refused() {
    let elbow = "<limit lower=\"-3\" upper=\"3\" effort=\"150\" velocity=\"3.1\"/>";
    let line = "<joint name=\"elbow\"";
    check(elbow, "", "joint `elbow`: a revolute joint needs <limit lower=... upper=...>", line);
    check(
        "lower=\"-3\" upper=\"3\"",
        "lower=\"3\" upper=\"-3\"",
        "joint `elbow`: `lower` = 3 must be below `upper` = -3",
        line,
    );
    check(
        "upper=\"3\" effort=\"150\" velocity=\"3.1\"",
        "upper=\"3\" effort=\"150\" velocity=\"-1\"",
        "joint `elbow`: `velocity` = -1 must not be negative",
        line,
    );
    check(
        elbow,
        &format!("{elbow}<mimic joint=\"lift\"/>"),
        "joint `elbow`: it mimics another joint; an arm's joints must move on their own",
        line,
    );
    check(
        "name=\"elbow\" type=\"revolute\"",
        "name=\"elbow\" type=\"floating\"",
        "joint `elbow`: an arm cannot have a floating joint: use joints with one axis",
        line,
    );
}

/// The arm of six joints with `from` replaced.
fn read(from: &str, to: &str) -> Result<Arm, RobotError> {
    let original = six();
    assert!(original.contains(from), "{from}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.urdf");
    fs::write(&file, original.replacen(from, to, 1)).unwrap();
    Arm::read(&file, "tip")
}

#[test]
fn what_an_arm_does_not_use_is_not_checked() {
    let mount = "<joint name=\"camera_mount\" type=\"fixed\">";
    let camera = "<link name=\"camera\"/>";
    let hung = |joint: &str, inside: &str| {
        format!(
            "{camera}<link name=\"lens\"/><joint name=\"focus\" type=\"{joint}\"><parent link=\"camera\"/><child \
             link=\"lens\"/>{inside}</joint>"
        )
    };
    let plain = Arm::read(&path("six.urdf"), "tip").unwrap();
    for (from, to) in [
        // Fixed joints have no axis and no limits.
        (mount, format!("{mount}<axis xyz=\"0 0 0\"/>")),
        (mount, format!("{mount}<axis xyz=\"z\"/><limit effort=\"none\"/>")),
        // The base does not move.
        ("<link name=\"base\"/>", "<link name=\"base\"><inertial/></link>".to_owned()),
        ("<link name=\"base\"/>", "<link name=\"base\"><inertial><mass value=\"-1\"/></inertial></link>".to_owned()),
    ] {
        let arm = read(from, &to).unwrap();
        assert_eq!((arm.joints(), arm.remarks()), (plain.joints(), plain.remarks()), "{to}");
    }
    for (joint, inside) in [
        ("floating", "<axis xyz=\"0 0 0\"/>"),
        ("continuous", "<axis xyz=\"0 0 0\"/><limit effort=\"0\"/>"),
        ("revolute", ""),
        ("revolute", "<limit lower=\"a\" upper=\"b\"/>"),
        ("ball", "<mimic joint=\"pan\"/><mimic joint=\"lift\"/>"),
    ] {
        let arm = read(
            "<link name=\"flange\"/>",
            &format!("<link name=\"flange\"/>{}", hung(joint, inside)).replace(camera, ""),
        );
        assert!(arm.is_ok(), "{joint}: {arm:?}");
    }
}

#[test]
fn limits_of_zero_are_unknown() {
    let arm = read("effort=\"28\" velocity=\"3.1\"", "effort=\"0\" velocity=\"0.0\"").unwrap();
    let joint = &arm.joints()[3];
    assert_eq!((joint.effort, joint.velocity), (f64::INFINITY, f64::INFINITY));
    let [velocity, effort] = arm.remarks() else { panic!("{:?}", arm.remarks()) };
    assert!(velocity.contains("arm.urdf:67: joint `wrist_1_joint`: `velocity` = 0 is taken as unknown"), "{velocity}");
    assert!(effort.contains("`effort` = 0 is taken as unknown"), "{effort}");
}

#[test]
fn masses_are_judged_together() {
    // A link without mass between two joints moves with those behind it.
    let wrist = "<mass value=\"1.25\"/>\n      <inertia ixx=\"0.0014\" iyy=\"0.0013\" izz=\"0.0010\"";
    let none = "<mass value=\"0\"/>\n      <inertia ixx=\"0\" iyy=\"0\" izz=\"0\"";
    let arm = read(wrist, none).unwrap();
    assert!(arm.remarks().is_empty(), "{:?}", arm.remarks());
    // Nothing is behind the last joint, or none has any.
    let massless =
        |text: &str| text.split("<inertial>").map(|part| part.split("</inertial>").last().unwrap()).collect();
    let all: String = massless(&six());
    let (message, line) = refusal(&all, "tip");
    assert!(message.starts_with("joint `wrist_3_joint` moves nothing with inertia: give <inertial>"), "{message}");
    assert!(line.starts_with("<link name=\"wrist_3\">"), "{line}");
}

#[test]
fn implausible_masses_and_inertias_are_remarked_on() {
    let remarks = |from: &str, to: &str| read(from, to).unwrap().remarks().join("\n");
    let grams = remarks("<mass value=\"7.9\"/>", "<mass value=\"7900\"/>");
    assert!(grams.contains("the links that move weigh 7910.71 kg together: are their masses in kilograms?"), "{grams}");
    let shape = remarks("izz=\"0.0066\"", "izz=\"0.066\"");
    assert!(shape.contains("arm.urdf:6: link `shoulder`: no body has principal moments of"), "{shape}");
    assert!(Arm::read(&path("six.urdf"), "tip").unwrap().remarks().is_empty());
    assert!(Arm::read(&path("seven.urdf"), "tip").unwrap().remarks().is_empty());
}

#[test]
fn joints_that_form_no_tree_are_refused() {
    check(
        "<child link=\"plate\"/>",
        "<child link=\"tip\"/>",
        "joint `plate_joint`: its child link `tip` hangs on joint `tip_joint` already; links and joints must form a tree",
        "<joint name=\"plate_joint\"",
    );
    check(
        "<link name=\"flange\"/>",
        "<link name=\"flange\"/>\n<link name=\"table\"/>",
        "link `base` and link `table` (line 103) both have no parent: connect them with joints",
        "<link name=\"base\"/>",
    );
    check(
        "<parent link=\"base\"/>",
        "<parent link=\"tip\"/>",
        "joint `tip_joint` hangs on itself: links and joints must form a tree",
        "<joint name=\"tip_joint\"",
    );
    let loop_of_two = "<robot><link name=\"a\"/><link name=\"b\"/>
        <joint name=\"one\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>
        <joint name=\"two\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint></robot>";
    let message = "the joints form a loop: no link is without a parent, so there is no base";
    assert_eq!(refusal(loop_of_two, "a"), (message.to_owned(), String::new()));
}

#[test]
fn more_joints_than_eight_are_refused() {
    let mut text = "<robot><link name=\"link0\"/>\n".to_owned();
    for joint in 1..=9 {
        let parent = joint - 1;
        text += &format!(
            "<link name=\"link{joint}\"/><joint name=\"joint{joint}\" type=\"continuous\"><parent link=\"link{parent}\"/>\
             <child link=\"link{joint}\"/></joint>\n"
        );
    }
    text += "</robot>";
    let (message, line) = refusal(&text, "link9");
    assert_eq!(message, "9 joints move between `link0` and `link9`: at most 8 are allowed; fix some of them");
    assert!(line.starts_with("<link name=\"link9\"/>"), "{line}");
}

#[test]
fn numbers_that_do_not_fit_the_arm_are_refused() {
    let arm = Arm::read(&path("six.urdf"), "tip").unwrap();
    let message = |positions: &[f64]| arm.configuration(positions).unwrap_err().to_string();
    assert_eq!(
        message(&[0.0; 5]),
        "5 numbers for pan, lift, elbow, wrist_1_joint, wrist_2_joint, wrist_3_joint: give one per joint, from the base to \
         the tip"
    );
    assert_eq!(
        message(&[0.0, 0.0, 3.5, 0.0, 0.0, 0.0]),
        "joint `elbow` cannot be at 3.5 rad: its range is -3 to 3 rad"
    );
    assert_eq!(message(&[f64::NAN; 6]), "joint `pan` cannot be at NaN rad: its range is -6.2 to 6.2 rad");
    assert!(arm.configuration(&[0.0, 0.0, 0.0, 0.0, 0.0, 100.0]).is_ok(), "a continuous joint has no limits");
    let rotors = |inertias: &[f64]| arm.clone().with_rotor_inertia(inertias).unwrap_err().to_string();
    assert!(rotors(&[0.1]).starts_with("1 numbers for pan"));
    assert_eq!(
        rotors(&[0.1, -0.1, 0.1, 0.1, 0.1, 0.1]),
        "joint `lift` cannot have a rotor inertia of -0.1 kg m^2: give a finite number that is not negative"
    );
}

/// Pieces of URDF files in places where they do not belong.
const PIECES: [&str; 12] =
    ["", "\"", "<", ">", "/>", "é", "1e300", "-7", "NaN", "tip", "<link name=\"a\"/>", "<mimic joint=\"pan\"/>"];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_damaged_file_is_refused_or_read_to_finite_numbers(
        damages in prop::collection::vec((0.0..1.0f64, 0usize..40, prop::sample::select(&PIECES[..])), 1..4),
    ) {
        let mut text = six();
        for (place, length, piece) in damages {
            let boundary = |index: usize| (0..=index.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap();
            let start = boundary((place * text.len() as f64) as usize);
            text.replace_range(start..boundary(start + length), piece);
        }
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("arm.urdf");
        fs::write(&file, &text).unwrap();
        match Arm::read(&file, "tip") {
            Ok(arm) => {
                let mass_matrix = arm.at(&JointVector::from_element(0.3)).mass_matrix();
                prop_assert!(mass_matrix.iter().all(|entry| entry.is_finite()));
            }
            Err(error) => prop_assert!(!error.message().is_empty()),
        }
    }
}

#[test]
fn elements_in_elements_without_end_are_refused() {
    let (message, _) = refusal(&("<robot>".to_owned() + &"<a>".repeat(300_000)), "a");
    assert!(message.starts_with("this is not valid XML: "), "{message}");
}
