//! Gains for execution: similarity, joint friction, bounds of stiffness.

use nalgebra::{Matrix6, Vector6};
use proptest::prelude::*;
use robot::Jacobian;
use robot::gains::{Demand, FrictionWrench, Refusal, Similarity, execution_factor};

fn matrix() -> impl Strategy<Value = Matrix6<f64>> {
    prop::collection::vec(-1.0..1.0f64, 36).prop_map(|numbers| Matrix6::from_column_slice(&numbers))
}

fn inertia() -> impl Strategy<Value = Matrix6<f64>> {
    matrix().prop_map(|matrix| matrix * matrix.transpose() + Matrix6::from_diagonal_element(0.3))
}

fn planned() -> Matrix6<f64> {
    Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 0.1, 0.1, 0.1))
}

/// Error after each of many short steps of `inertia dv/dt = -stiffness e - damping v`.
fn motion(inertia: &Matrix6<f64>, stiffness: &Matrix6<f64>, damping: &Matrix6<f64>) -> Vec<Vector6<f64>> {
    let inverse = inertia.try_inverse().unwrap();
    let (mut error, mut velocity) = (Vector6::new(0.02, -0.01, 0.03, 0.1, 0.2, -0.1), Vector6::zeros());
    let step = |_| {
        velocity -= inverse * (stiffness * error + damping * velocity) * 1e-3;
        error += velocity * 1e-3;
        error
    };
    (0..500).map(step).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn an_arm_with_a_multiple_of_the_inertia_moves_as_planned(inertia in inertia(), factor in 0.1..50.0f64) {
        let similarity = Similarity::new(&inertia, &(inertia * factor)).unwrap();
        prop_assert!((similarity.factor / factor - 1.0).abs() < 1e-9);
        prop_assert!((similarity.smallest / similarity.largest - 1.0).abs() < 1e-9);
        let (stiffness, damping) = (Matrix6::from_diagonal_element(50.0), Matrix6::from_diagonal_element(10.0));
        let plan = motion(&inertia, &stiffness, &damping);
        let arm = motion(&(inertia * factor), &(stiffness * similarity.factor), &(damping * similarity.factor));
        for (plan, arm) in plan.iter().zip(&arm) {
            prop_assert!((plan - arm).amax() < 1e-9);
        }
    }

    #[test]
    fn similarity_depends_neither_on_units_nor_on_the_frame(
        planned in inertia(),
        apparent in inertia(),
        change in matrix(),
    ) {
        prop_assume!(change.determinant().abs() > 0.01);
        let one = Similarity::new(&planned, &apparent).unwrap();
        let changed = |inertia: &Matrix6<f64>| change.transpose() * inertia * change;
        let other = Similarity::new(&changed(&planned), &changed(&apparent)).unwrap();
        for (one, other) in
            [(one.factor, other.factor), (one.smallest, other.smallest), (one.largest, other.largest)]
        {
            prop_assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
        }
        prop_assert!(one.smallest <= one.factor && one.factor <= one.largest);
    }

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
fn directions_count_with_their_share_of_kinetic_energy() {
    let apparent = Matrix6::from_diagonal(&Vector6::new(12.0, 7.0, 8.0, 0.5, 1.0, 0.1));
    let similarity = Similarity::new(&planned(), &apparent).unwrap();
    assert!((similarity.factor - (12.0 + 7.0 + 8.0 + 5.0 + 10.0 + 1.0) / 6.0).abs() < 1e-12);
    assert!((similarity.smallest - 1.0).abs() < 1e-12 && (similarity.largest - 12.0).abs() < 1e-12);
    let [smallest, largest] = similarity.damping_ratios(3.0);
    assert!((smallest - 0.5).abs() < 1e-12 && (largest - 3f64.sqrt()).abs() < 1e-12);
}

#[test]
fn what_is_not_positive_definite_has_no_similarity() {
    let mut indefinite = planned();
    indefinite[(0, 0)] = -1.0;
    assert_eq!(Similarity::new(&planned(), &indefinite), None);
    assert_eq!(Similarity::new(&indefinite, &planned()), None);
    assert_eq!(Similarity::new(&planned(), &Matrix6::from_element(f64::NAN)), None);
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

const TRANSLATION: Demand = Demand { friction: 1.0, deadband: 0.002, press: 0.01, load: 20.0, range: [100.0, 3000.0] };
const ROTATION: Demand = Demand { friction: 0.2, deadband: 0.01, press: 0.0, load: f64::INFINITY, range: [5.0, 200.0] };

#[test]
fn stiffness_keeps_deadband_and_force_within_what_the_controller_accepts() {
    assert_eq!(TRANSLATION.stiffnesses(), Ok([500.0, 2000.0]));
    assert_eq!(ROTATION.stiffnesses(), Ok([20.0, 200.0]));
    assert_eq!(Demand { friction: 0.0, load: 1e3, ..TRANSLATION }.stiffnesses(), Ok([100.0, 3000.0]));
}

#[test]
fn one_factor_for_all_gains_is_as_near_to_similarity_as_demands_allow() {
    let factor = |similarity| execution_factor(similarity, 50.0, 5.0, &TRANSLATION, &ROTATION);
    assert_eq!(factor(8.5), Ok(10.0));
    assert_eq!(factor(17.0), Ok(17.0));
    assert_eq!(factor(100.0), Ok(40.0));
}

#[test]
fn demands_that_contradict_each_other_are_refused_with_both_numbers() {
    let cases = [
        (
            Demand { load: 4.0, ..TRANSLATION },
            Refusal::Force { smallest: 500.0, largest: 400.0 },
            "the deadband needs a stiffness of 500.00 or more, and the contact force allows 400.00 or less; allow a \
             larger deadband or force, or let the reference press less",
        ),
        (
            Demand { range: [100.0, 400.0], ..TRANSLATION },
            Refusal::TooStiff { smallest: 500.0, highest: 400.0 },
            "the deadband needs a stiffness of 500.00 or more, and the controller accepts 400.00 or less; allow a \
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
        assert_eq!(execution_factor(8.5, 50.0, 5.0, &demand, &ROTATION), Err(refusal));
        assert_eq!(refusal.to_string(), message);
    }
}

#[test]
fn translations_and_rotations_without_a_common_factor_are_refused() {
    let refusal = execution_factor(8.5, 50.0, 0.25, &TRANSLATION, &ROTATION).unwrap_err();
    assert_eq!(refusal, Refusal::Proportion { translations: [10.0, 40.0], rotations: [80.0, 800.0] });
    assert_eq!(
        refusal.to_string(),
        "translations need gains of 10.00 to 40.00 times the plan's, rotations of 80.00 to 800.00 times; plan with \
         another ratio of rotational to translational stiffness"
    );
}
