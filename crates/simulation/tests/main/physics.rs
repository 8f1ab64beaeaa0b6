//! Rollouts compared with closed-form mechanics.

use collision::Polytope;
use nalgebra::{Matrix3, UnitQuaternion, Vector3, Vector6};
use simulation::{Disturbance, Injection, Reference, Rollout, Settings, TimedState};
use task::{AssemblyTask, GraspError, Impedance, Inertia, State};

use crate::world::{
    INERTIA, MASS, ROTATIONAL_STIFFNESS, STIFFNESS, at_rest, block, floor, hole, states, task, through,
};

/// Fraction of its initial deviation that a critically damped body has after a time (s).
fn critically_damped(frequency: f64, time: f64) -> f64 {
    (1.0 + frequency * time) * (-frequency * time).exp()
}

/// Largest deviation from the motion of a critically damped body whose target jumps once: in position (m) and in angle
/// (rad).
fn deviations_in_free_motion(time_step: f64) -> (f64, f64) {
    const JUMP: f64 = 0.02;
    const ROTATION: f64 = 1e-3;
    let rollout = Rollout::new(&task(&block([0.1; 3], [0.0; 3]), &[]), Settings { time_step, ..Settings::default() });
    let mut target = at_rest([JUMP, 0.0, 0.0]);
    (target.0[3], target.0[5]) = ((0.5 * ROTATION).cos(), (0.5 * ROTATION).sin());
    let mut largest = (0.0_f64, 0.0_f64);
    for state in states(&rollout, &Reference::new(time_step, &[at_rest([0.0; 3]), target])) {
        let position = JUMP * (1.0 - critically_damped((STIFFNESS / MASS).sqrt(), state.time));
        let angle = ROTATION * (1.0 - critically_damped((ROTATIONAL_STIFFNESS / INERTIA).sqrt(), state.time));
        largest.0 = largest.0.max((state.pose[0] - position).abs());
        largest.1 = largest.1.max((2.0 * state.pose[5].asin() - angle).abs());
    }
    largest
}

#[test]
fn free_motion_is_that_of_a_critically_damped_body() {
    let deviations = [4e-3, 2e-3, 1e-3, 5e-4].map(deviations_in_free_motion);
    assert!(deviations[2].0 < 5e-5 && deviations[2].1 < 5e-6, "{deviations:?}");
    for pair in deviations.windows(2) {
        assert!((1.8..2.2).contains(&(pair[0].0 / pair[1].0)), "first order: {deviations:?}");
        assert!((1.8..2.2).contains(&(pair[0].1 / pair[1].1)), "first order: {deviations:?}");
    }
}

#[test]
fn free_motion_with_anisotropic_damping_is_that_of_the_impedance_law() {
    let mut task = task(&block([0.1; 3], [0.0; 3]), &[]);
    task.impedance.translational_damping = anisotropic(2.0, 30.0);
    task.impedance.rotational_damping = anisotropic(0.1, 2.0);
    assert_converges(&task);
}

#[test]
fn free_motion_of_a_full_inertia_is_that_of_the_impedance_law() {
    let mut task = task(&block([0.1; 3], [0.0; 3]), &[]);
    let lever = Vector3::new(0.05, -0.1, 0.15).cross_matrix();
    let mut matrix = *Inertia::of_body(MASS, anisotropic(INERTIA, 3.0 * INERTIA) - lever * lever * MASS).matrix();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&anisotropic(MASS, 2.0 * MASS));
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-lever * MASS));
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(lever * MASS));
    task.inertia = Inertia::from_matrix(matrix);
    task.impedance = Impedance::critically_damped(STIFFNESS, ROTATIONAL_STIFFNESS, &task.inertia);
    assert_converges(&task);
}

/// Largest distance (m) from the motion of a critically damped body whose target moves at constant speed within a long
/// interval, so that steps can be long, too.
fn deviation_from_a_lag(time_step: f64) -> f64 {
    const SECONDS: f64 = 2.048;
    const SPEED: f64 = 0.1;
    let rollout = Rollout::new(
        &task(&block([0.1; 3], [0.0; 3]), &[]),
        Settings { time_step, settling_time: 0.0, ..Settings::default() },
    );
    let reference = Reference::new(SECONDS, &[at_rest([0.0; 3]), at_rest([SPEED * SECONDS, 0.0, 0.0])]);
    let states = states(&rollout, &reference);
    assert_eq!(states.len(), (SECONDS / time_step).round() as usize);
    let frequency = (STIFFNESS / MASS).sqrt();
    let deviation = |(index, state): (usize, &TimedState)| {
        assert!((state.time - (index + 1) as f64 * time_step).abs() < 1e-9);
        let decay = (-frequency * state.time).exp();
        let position = SPEED * (state.time - 2.0 / frequency + (2.0 / frequency + state.time) * decay);
        (state.pose[0] - position).abs()
    };
    states.iter().enumerate().map(deviation).fold(0.0, f64::max)
}

#[test]
fn long_steps_are_no_less_accurate_than_short_ones() {
    let deviations = [4e-3, 2e-3, 1e-3].map(deviation_from_a_lag);
    assert!(deviations[2] < 5e-6, "{deviations:?}");
    assert!(deviations.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{deviations:?}");
}

/// Damping that is different along every axis, and along none of the world's or the body's.
fn anisotropic(least: f64, most: f64) -> Matrix3<f64> {
    let rotation = UnitQuaternion::from_euler_angles(0.4, -0.9, 1.3).to_rotation_matrix();
    let damping =
        rotation * Matrix3::from_diagonal(&Vector3::new(least, 0.5 * (least + most), most)) * rotation.inverse();
    0.5 * (damping + damping.transpose())
}

/// A free body: position, velocity, orientation, angular velocity.
type FreeBody = (Vector3<f64>, Vector3<f64>, UnitQuaternion<f64>, Vector3<f64>);

/// What a body becomes in some seconds with the velocities and the wrench that it has `at` a time.
fn advanced(task: &AssemblyTask, target: &State, body: FreeBody, at: FreeBody, seconds: f64) -> FreeBody {
    let (position, velocity, orientation, angular_velocity) = at;
    let mut state = at_rest(position.into());
    state.0[3..7].copy_from_slice(&[orientation.w, orientation.i, orientation.j, orientation.k]);
    state.0[7..10].copy_from_slice(velocity.as_slice());
    state.0[10..].copy_from_slice(angular_velocity.as_slice());
    let wrench = Vector6::from(task.impedance.wrench(target, &state, &GraspError::default().pose()).0);
    let acceleration = task.inertia.inverse().unwrap() * wrench;
    (
        body.0 + velocity * seconds,
        body.1 + acceleration.fixed_rows::<3>(0) * seconds,
        body.2 * UnitQuaternion::from_scaled_axis(angular_velocity * seconds),
        body.3 + acceleration.fixed_rows::<3>(3) * seconds,
    )
}

/// Largest distance (m) and angle (rad) of a rollout of a free body from what the midpoint rule makes of the impedance
/// law in finer steps.
fn deviations_from_the_impedance_law(task: &AssemblyTask, time_step: f64) -> (f64, f64) {
    const FINER: usize = 20;
    let mut target = at_rest([0.02, -0.01, 0.03]);
    let rotation = UnitQuaternion::from_scaled_axis(Vector3::new(0.1, 0.2, -0.15));
    target.0[3..7].copy_from_slice(&[rotation.w, rotation.i, rotation.j, rotation.k]);
    let rollout = Rollout::new(task, Settings { time_step, ..Settings::default() });
    let step = time_step / FINER as f64;
    let mut body: FreeBody = (Vector3::zeros(), Vector3::zeros(), UnitQuaternion::identity(), Vector3::zeros());
    let mut largest = (0.0_f64, 0.0_f64);
    for state in states(&rollout, &Reference::new(time_step, &[at_rest([0.0; 3]), target])) {
        for _ in 0..FINER {
            let middle = advanced(task, &target, body, body, 0.5 * step);
            body = advanced(task, &target, body, middle, step);
        }
        largest.0 = largest.0.max((position(&state) - body.0).norm());
        largest.1 = largest.1.max(state.pose.orientation().angle_to(&body.2));
    }
    largest
}

/// Rollouts of a free body are nearer and nearer to the impedance law.
fn assert_converges(task: &AssemblyTask) {
    let deviations = [4e-3, 2e-3, 1e-3, 5e-4].map(|time_step| deviations_from_the_impedance_law(task, time_step));
    assert!(deviations[2].0 < 1e-3 && deviations[2].1 < 1e-2, "{deviations:?}");
    for pair in deviations.windows(2) {
        assert!((1.8..2.2).contains(&(pair[0].0 / pair[1].0)), "first order: {deviations:?}");
        assert!((1.8..2.2).contains(&(pair[0].1 / pair[1].1)), "first order: {deviations:?}");
    }
}

#[test]
fn an_offset_displaces_the_body_and_the_controller_never_learns_of_it() {
    let rollout = Rollout::new(&task(&block([0.1; 3], [0.0; 3]), &[]), Settings::default());
    let outcome = rollout.play(&through(&[[0.1, 0.0, 0.0], [0.0; 3]], 1.0), [0.003, 0.004, 0.0], |_, _| {});
    assert!((Vector3::new(outcome.pose[0], outcome.pose[1], 0.0) - Vector3::new(-0.003, -0.004, 0.0)).norm() < 2e-4);
    assert!((outcome.position_error - 0.005).abs() < 2e-4 && outcome.orientation_error < 1e-12);
}

/// A rotated part in the gripper is a body whose shape is rotated the other way.
#[test]
fn a_rotated_grasp_is_a_rotated_shape() {
    let rotation = [0.006, -0.004, 0.03];
    let quaternion = UnitQuaternion::from_scaled_axis(Vector3::from(rotation));
    let [w, i, j, k] = {
        let back = quaternion.inverse();
        [back.w, back.i, back.j, back.k]
    };
    let peg = block([0.04, 0.04, 0.08], [0.0; 3]);
    let reference = through(&[[0.0, 0.0, 0.06], [0.0005, 0.0, -0.005]], 1.5);
    for friction in [0.0, 0.2] {
        let settings = Settings { friction, ..Settings::default() };
        let play = |peg: &Polytope, grasp: GraspError| {
            let mut poses = Vec::new();
            let rollout = Rollout::new(&task(peg, &hole(0.0415)), settings);
            let outcome = rollout.play(&reference, grasp, |state, _| poses.push(state.pose));
            assert!(outcome.loads.contact_force > 0.1, "it touches: {outcome:?}");
            poses
        };
        let held = play(&peg, GraspError { offset: [0.0; 3], rotation });
        let shaped = play(&peg.placed([0.0; 3], [w, i, j, k]), GraspError::default());
        for (held, shaped) in held.iter().zip(&shaped) {
            let moved = (0..3).map(|axis| (held[axis] - shaped[axis]).abs()).fold(0.0, f64::max);
            assert!(moved < 1e-8, "{moved}");
            assert!((held.orientation() * quaternion).angle_to(&shaped.orientation()) < 1e-6);
        }
    }
}

/// Positions every 8 ms of a box that falls on a floor, tilted by contact, and slides into a wall.
fn bumpy_motion(time_step: f64, friction: f64) -> Vec<Vector3<f64>> {
    let wall = block([0.1, 0.6, 0.4], [-0.05, 0.0, 0.2]);
    let mut start = at_rest([0.1, 0.0, 0.08]);
    (start.0[3], start.0[5]) = (0.15_f64.cos(), 0.15_f64.sin());
    let target = at_rest([0.045, 0.0, 0.02]);
    let rollout = Rollout::new(
        &task(&block([0.1, 0.08, 0.06], [0.0; 3]), &[floor(), wall]),
        Settings { time_step, friction, ..Settings::default() },
    );
    let states = states(&rollout, &Reference::new(0.4, &[start, target]));
    let every = (8e-3 / time_step).round() as usize;
    states.iter().skip(every - 1).step_by(every).map(position).collect()
}

fn position(state: &TimedState) -> Vector3<f64> {
    Vector3::new(state.pose[0], state.pose[1], state.pose[2])
}

#[test]
fn motion_with_contacts_converges_as_steps_get_finer() {
    for friction in [0.0, 0.3] {
        let exact = bumpy_motion(6.25e-5, friction);
        let deviations = [4e-3, 2e-3, 1e-3, 5e-4].map(|time_step| {
            let positions = bumpy_motion(time_step, friction);
            positions.iter().zip(&exact).map(|(one, other)| (one - other).norm()).fold(0.0, f64::max)
        });
        assert!(deviations[2] < 1e-3, "friction {friction}: {deviations:?}");
        assert!(deviations[3] < 0.2 * deviations[0], "friction {friction}: {deviations:?}");
    }
}

#[test]
fn a_wall_is_pushed_with_the_force_of_the_spring() {
    const DEPTH: f64 = 0.03;
    let body = block([0.1, 0.1, 0.06], [0.0; 3]);
    let rollout = Rollout::new(&task(&body, &[floor()]), Settings::default());
    let outcome = rollout.play(&through(&[[0.0, 0.0, 0.03], [0.0, 0.0, 0.03 - DEPTH]], 1.0), [0.0; 3], |_, _| {});
    assert!((outcome.loads.contact_force / (STIFFNESS * DEPTH) - 1.0).abs() < 1e-6, "{outcome:?}");
    assert!((outcome.pose[2] - 0.03).abs() < 1e-9 && outcome.max_penetration < 1e-9, "{outcome:?}");
}

#[test]
fn friction_holds_up_to_its_limit_and_then_drags() {
    const DEPTH: f64 = 0.03;
    let body = block([0.1, 0.1, 0.06], [0.0; 3]);
    for friction in [0.1, 0.5] {
        let settings = Settings { friction, settling_time: 4.0, ..Settings::default() };
        let rollout = Rollout::new(&task(&body, &[floor()]), settings);
        // The normal force is that of the spring; a pull along the floor moves the body when it exceeds mu times that.
        let limit = friction * DEPTH;
        for (pull, rest) in [(0.9 * limit, 0.0), (1.1 * limit, 0.1 * limit), (3.0 * limit, 2.0 * limit)] {
            let (pressed, above) = ([0.0, 0.0, 0.03 - DEPTH], [0.0, 0.0, 0.03]);
            // Along a direction that the friction cone is not built around.
            let (x, y) = (0.8 * pull, 0.6 * pull);
            let reference = through(&[above, pressed, [x, y, pressed[2]]], 1.0);
            let outcome = rollout.play(&reference, [0.0; 3], |_, _| {});
            let moved = outcome.pose[0].hypot(outcome.pose[1]);
            assert!((moved - rest).abs() < 1e-5, "friction {friction}, pull {pull}: {moved}, not {rest}");
            assert!((outcome.pose[2] - 0.03).abs() < 1e-6);
        }
    }
}

#[test]
fn a_peg_enters_a_hole_that_it_meets_and_rests_on_a_rim_that_it_does_not() {
    let peg = block([0.04, 0.04, 0.08], [0.0; 3]);
    let rollout = Rollout::new(&task(&peg, &hole(0.041)), Settings::default());
    // From above the rim to a little above the bottom, with the lower end of the peg 0.04 m below its centre.
    let reference = through(&[[0.0, 0.0, 0.06], [0.0, 0.0, -0.005]], 2.0);
    let heights = [0.0, 4e-4, 2e-3].map(|offset| {
        let outcome = rollout.play(&reference, [offset, 0.0, 0.0], |_, _| {});
        assert!(outcome.max_penetration < 1e-6, "{outcome:?}");
        outcome.pose[2]
    });
    assert!((heights[0] + 0.005).abs() < 1e-3 && (heights[1] + 0.005).abs() < 1e-3, "{heights:?}");
    assert!((heights[2] - 0.04).abs() < 1e-3, "{heights:?}");
}

#[test]
fn faces_that_overlap_by_less_than_the_radius_of_their_edges_slip_past_each_other() {
    const OVERLAP: f64 = 5e-5;
    const HEIGHT: f64 = 1e-3;
    // A plate, so that the step turns it little, which hangs on springs over a step that is a little too high for it.
    let plate = block([0.02, 0.06, 2.0 * HEIGHT], [0.0; 3]);
    let step = block([0.4, 0.4, 0.1], [0.3, 0.0, -0.05 + OVERLAP]);
    let rollout = Rollout::new(&task(&plate, &[step]), Settings::default());
    let reference = through(&[[0.07, 0.0, HEIGHT], [0.1, 0.0, HEIGHT]], 2.0);
    let end = |edge_radius: f64| {
        let disturbance = Disturbance { edge_radius, ..Disturbance::default() };
        let outcome = rollout.play(&reference, Injection { grasp: GraspError::default(), disturbance }, |_, _| {});
        assert!(outcome.max_penetration < 1.5 * OVERLAP, "{outcome:?}");
        outcome.pose
    };
    for held in [0.0, 0.8 * OVERLAP].map(end) {
        assert!((held[0] - 0.09).abs() < 1e-5 && (held[2] - HEIGHT).abs() < 1e-5, "{held:?}");
    }
    let past = end(1.5 * OVERLAP);
    assert!((past[0] - 0.1).abs() < 1e-3 && (past[2] - HEIGHT - OVERLAP).abs() < 1e-5, "{past:?}");
}

#[test]
fn a_fast_body_does_not_pass_a_thin_plate() {
    let plate = block([1.0, 1.0, 0.001], [0.0, 0.0, 0.0]);
    let body: Polytope = block([0.02, 0.02, 0.002], [0.0; 3]);
    for friction in [0.0, 0.3] {
        let settings = Settings { friction, ..Settings::default() };
        let rollout = Rollout::new(&task(&body, std::slice::from_ref(&plate)), settings);
        // Pulled 2 m down it would cross the plate at about 5 m/s, five thicknesses in a step.
        let reference = Reference::new(1e-3, &[at_rest([0.0, 0.0, 1.0]), at_rest([0.0, 0.0, -1.0])]);
        let outcome = rollout.play(&reference, [0.0; 3], |_, _| {});
        assert!((outcome.pose[2] - 0.0015).abs() < 1e-6, "{outcome:?}");
    }
}
