//! Gains for execution: joint friction, bounds of stiffness.

use nalgebra::{Matrix6, Vector6};
use proptest::prelude::*;
use robot::Jacobian;
use robot::gains::{Demand, FrictionWrench, Refusal};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn no_wrench_that_friction_holds_is_larger(
        numbers in prop::collection::vec(-1.0..1.0f64, 48),
        direction in prop::array::uniform6(-1.0..1.0f64),
        friction in prop::array::uniform8(0.1..1.0f64),
        joints in 6usize..=8,
    ) {
        let jacobian = Jacobian::from_column_slice(&numbers);
        let direction = Vector6::from(direction);
        let held = FrictionWrench::new(&jacobian, &friction[..joints]).unwrap();
        // The largest multiple of a direction that moves no joint.
        let scale = (0..joints)
            .map(|joint| friction[joint] / jacobian.column(joint).dot(&direction).abs())
            .fold(f64::INFINITY, f64::min);
        prop_assert!(scale * direction.fixed_rows::<3>(0).norm() <= held.force * (1.0 + 1e-6));
        prop_assert!(scale * direction.fixed_rows::<3>(3).norm() <= held.torque * (1.0 + 1e-6));
    }

    #[test]
    fn a_joint_that_doubles_another_one_counts_with_the_smaller_friction(
        numbers in prop::collection::vec(-1.0..1.0f64, 36),
        friction in prop::array::uniform6(0.1..1.0f64),
        share in 0.1..0.9f64,
    ) {
        let columns = Matrix6::from_column_slice(&numbers);
        prop_assume!(columns.determinant().abs() > 0.01);
        let mut jacobian = Jacobian::zeros();
        jacobian.fixed_columns_mut::<6>(0).copy_from(&columns);
        jacobian.set_column(6, &columns.column(2));
        let mut smaller = friction;
        smaller[2] *= share;
        let mut both = friction.to_vec();
        both.push(smaller[2]);
        let (one, other) =
            (FrictionWrench::new(&jacobian, &smaller).unwrap(), FrictionWrench::new(&jacobian, &both).unwrap());
        prop_assert!((one.force / other.force - 1.0).abs() < 1e-6, "{one:?} {other:?}");
        prop_assert!((one.torque / other.torque - 1.0).abs() < 1e-6, "{one:?} {other:?}");
    }
}

#[test]
fn friction_of_half_a_newton_metre_at_half_a_metre_is_a_newton() {
    // Each joint acts on one component, with a lever of half a metre for forces.
    let mut jacobian = Jacobian::zeros();
    for row in 0..6 {
        jacobian[(row, row)] = if row < 3 { 0.5 } else { 1.0 };
    }
    let held = FrictionWrench::new(&jacobian, &[0.5, 0.0, 0.0, 0.1, 0.2, 0.2]).unwrap();
    assert!((held.force - 1.0).abs() < 1e-12 && (held.torque - 0.3).abs() < 1e-12, "{held:?}");
    let deadband = held.deadband(50.0, 5.0);
    assert!((deadband.distance - 0.02).abs() < 1e-12 && (deadband.angle - 0.06).abs() < 1e-12);
}

#[test]
fn friction_holds_any_wrench_of_a_singular_arm() {
    let mut jacobian = Jacobian::identity();
    assert_eq!(FrictionWrench::new(&jacobian, &[0.5; 5]), None);
    jacobian[(5, 5)] = 0.0;
    assert_eq!(FrictionWrench::new(&jacobian, &[0.5; 8]), None);
    assert!(FrictionWrench::new(&Jacobian::identity(), &[0.5; 6]).is_some());
}

const TRANSLATION: Demand =
    Demand { friction: 1.0, deadband: 0.002, allowed: 0.004, press: 0.01, load: 20.0, range: [100.0, 3000.0] };
const ROTATION: Demand =
    Demand { friction: 0.2, deadband: 0.01, allowed: 0.02, press: 0.0, load: f64::INFINITY, range: [5.0, 200.0] };

#[test]
fn stiffness_keeps_deadband_and_force_within_what_the_controller_accepts() {
    assert_eq!(TRANSLATION.stiffnesses(), Ok([250.0, 2000.0]));
    assert_eq!(ROTATION.stiffnesses(), Ok([10.0, 200.0]));
    assert_eq!(Demand { friction: 0.0, load: 1e3, ..TRANSLATION }.stiffnesses(), Ok([100.0, 3000.0]));
}

#[test]
fn stiffness_is_that_of_similarity_unless_a_demand_forbids_it() {
    for (similar, chosen) in [(100.0, 500.0), (600.0, 600.0), (5000.0, 2000.0)] {
        assert_eq!(TRANSLATION.stiffness(similar), Ok(chosen));
    }
    // Contact forces allow less than the wanted deadband asks for.
    assert_eq!(Demand { load: 4.0, ..TRANSLATION }.stiffness(100.0), Ok(400.0));
    assert_eq!(ROTATION.stiffness(47.0), Ok(47.0));
}

#[test]
fn demands_that_contradict_each_other_are_refused_with_both_numbers() {
    let cases = [
        (
            Demand { load: 2.0, ..TRANSLATION },
            Refusal::Force { smallest: 250.0, largest: 200.0 },
            "the deadband needs a stiffness of 250.00 or more, and the contact force allows 200.00 or less; allow a \
             larger deadband or force, or let the reference press less",
        ),
        (
            Demand { range: [100.0, 200.0], ..TRANSLATION },
            Refusal::TooStiff { smallest: 250.0, highest: 200.0 },
            "the deadband needs a stiffness of 250.00 or more, and the controller accepts 200.00 or less; allow a \
             larger deadband",
        ),
        (
            Demand { range: [2500.0, 3000.0], ..TRANSLATION },
            Refusal::TooSoft { largest: 2000.0, lowest: 2500.0 },
            "the contact force allows a stiffness of 2000.00 or less, and the controller accepts 2500.00 or more; \
             allow a larger force, or let the reference press less",
        ),
    ];
    for (demand, refusal, message) in cases {
        assert_eq!(demand.stiffnesses(), Err(refusal));
        assert_eq!(demand.stiffness(100.0), Err(refusal));
        assert_eq!(refusal.to_string(), message);
    }
}
