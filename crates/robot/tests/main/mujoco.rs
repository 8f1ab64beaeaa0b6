//! Kinematics and dynamics are those of MuJoCo: of an arm with fixed side branches, of a redundant one with a gripper, and
//! of one with slides; each with a base, a grasp, a payload and rotor inertia. `scripts/lab record arm` writes the records.

use std::path::Path;

use crate::record::Record;

fn record(name: &str) -> Record {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms").join(name);
    Record::read(&file.with_extension("urdf"), &file.with_extension("json"))
}

fn check(name: &str) {
    let record = record(name);
    let joints: Vec<&str> = record.arm.joints().iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(joints, record.joints);
    for (quantity, difference) in record.differences() {
        assert!(difference < 1e-9, "{quantity} of {name}: {difference:e}");
    }
}

#[test]
fn six_joints_and_fixed_branches_agree() {
    check("six");
}

#[test]
fn seven_joints_and_a_gripper_agree() {
    check("seven");
}

#[test]
fn slides_agree() {
    check("gantry");
}
