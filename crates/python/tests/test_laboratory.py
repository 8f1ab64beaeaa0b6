"""What scenes answer about geometry and motions of the user: against finite differences, other methods and plans."""

import pickle
import tomllib
from typing import Any

import numpy as np
import pytest
from assembly_plan import Plan, Reference, Scene, SceneError
from conftest import CORNER, PEG, ROOT

TETRAHEDRON = np.array([[0.0, 0.0, 0.0], [0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def poses(scene: Scene, count: int) -> Any:
    """Poses near the start, with quaternions of other norms."""
    random = np.random.default_rng(1)
    return scene.starts["1"] + random.normal(scale=0.01, size=(count, 7))


def with_mesh(**mesh: Any) -> Scene:
    return Scene.from_dict(
        {
            "title": "mesh",
            "body": {"mass": 1.0, "inertia": np.diag([0.1, 0.1, 0.1]), "part": [{"name": "tip", "mesh": mesh}]},
            "environment": {"part": [{"name": "floor", "box": [0.6, 0.6, 0.1], "position": [0.0, 0.0, -0.05]}]},
            "start": [{"name": "1", "position": [0.0, 0.0, 0.1], "orientation": [1, 0, 0, 0]}],
            "goal": {"position": [0.0, 0.0, 0.001], "orientation": [1, 0, 0, 0]},
            "robustness": {"offset_magnitude": 0.002},
        }
    )


def test_contacts_are_the_distances_of_single_poses(scene: Scene) -> None:
    at = poses(scene, 5)
    contacts = scene.contacts(at, tau=1e-4, points=True)
    assert contacts.values.shape == (5, 2, 10) and contacts.pairs == ("box/floor", "box/wall")
    for pose, distances, normals in zip(at, contacts.distance, contacts.normal, strict=True):
        reports = scene.distances(pose, tau=1e-4)
        assert [report["smoothed_distance_m"] for report in reports] == pytest.approx(distances, abs=1e-12)
        for report, normal in zip(reports, normals, strict=True):
            assert report["normal"][:3] == pytest.approx(normal[:3], abs=1e-9)
    with pytest.raises(ValueError, match="read-only"):
        contacts.distance[0, 0] = 0.0


def test_derivatives_of_contacts_are_those_of_finite_differences(scene: Scene) -> None:
    at, step = poses(scene, 3), 1e-6
    contacts = scene.contacts(at, tau=1e-3, derivatives=2)
    assert contacts.jacobian is not None and contacts.hessian is not None
    assert contacts.jacobian.shape == (3, 2, 7, 7) and contacts.hessian.shape == (3, 2, 7, 7, 7)
    for axis in range(7):
        ahead, behind = (
            scene.contacts(at + sign * step * np.eye(7)[axis], tau=1e-3, derivatives=1) for sign in (1, -1)
        )
        assert ahead.jacobian is not None and behind.jacobian is not None
        first, second = (ahead.values - behind.values) / (2 * step), (ahead.jacobian - behind.jacobian) / (2 * step)
        assert contacts.jacobian[..., axis] == pytest.approx(first, rel=1e-5, abs=1e-5)
        assert contacts.hessian[..., axis] == pytest.approx(second, rel=1e-4, abs=1e-3)
    assert scene.contacts(at).jacobian is None and scene.contacts(at, derivatives=1).hessian is None


def test_wrong_poses_are_refused_by_name(scene: Scene) -> None:
    with pytest.raises(SceneError, match=r"poses: has shape \(3, 6\), must have shape \(K, 7\)"):
        scene.contacts(np.zeros((3, 6)))
    with pytest.raises(SceneError, match="poses: has a number that is not finite"):
        scene.contacts([[np.nan, 0, 0, 1, 0, 0, 0]])
    with pytest.raises(SceneError, match="derivatives = 3: must be 0, 1 or 2"):
        scene.contacts(scene.goal, derivatives=3)
    with pytest.raises(SceneError, match="real numbers"):
        scene.contacts(np.zeros((1, 7), dtype=complex))


def test_a_mesh_may_be_arrays() -> None:
    scene = with_mesh(vertices=TETRAHEDRON, faces=FACES)
    assert len(scene.body) == 1 and np.ptp(scene.body[0].vertices, axis=0) == pytest.approx([0.05] * 3)
    assert scene.check()["meshes"]
    for wrong, message in [
        ({"vertices": TETRAHEDRON}, r"body.part\[0\].mesh: needs the keys vertices and faces"),
        ({"vertices": TETRAHEDRON[:, :2], "faces": FACES}, r"vertices: has shape \(4, 2\)"),
        ({"vertices": TETRAHEDRON, "faces": FACES + 1}, "must be indices of the 4 vertices"),
        ({"vertices": TETRAHEDRON, "faces": FACES.astype(float)}, "must be whole numbers"),
    ]:
        with pytest.raises(SceneError, match=message):
            with_mesh(**wrong)
    with pytest.raises(SceneError) as raised:
        with_mesh(vertices=TETRAHEDRON, faces=FACES[:3])
    assert "body.part[0].obj" in str(raised.value) and "/tmp" not in str(raised.value)


def test_a_reference_is_played_as_the_plan_that_it_is_from(scene: Scene, plan: Plan) -> None:
    played = scene.simulate(plan, friction=0.1)
    own = scene.simulate(Reference.of(plan), friction=0.1)
    assert np.array_equal(played.rollouts["position_error_m"], own.rollouts["position_error_m"])
    # Poses alone get velocities; the plan's own are those of its poses but for rounding of the solver.
    poses = scene.simulate(Reference(plan.reference[:, :7], plan.time_step), friction=0.1)
    assert poses.rollouts["position_error_m"] == pytest.approx(played.rollouts["position_error_m"], abs=5e-4)
    still = np.repeat(plan.reference[:1, :7], 21, axis=0)
    assert scene.simulate(Reference(still)).rate() == 0.0
    with pytest.raises(SceneError, match="a reference has none"):
        scene.simulate(Reference(still), stages=True)
    with pytest.raises(SceneError, match=r"states: has shape \(21, 8\)"):
        Reference(np.zeros((21, 8)))
    with pytest.raises(SceneError, match=r"knot 0: .* are not a unit quaternion"):
        scene.simulate(Reference(np.ones((21, 7))))


def test_rollouts_have_whole_trajectories(scene: Scene, plan: Plan) -> None:
    rollouts = scene.rollouts(plan, friction=0.1)
    rows = scene.simulate(plan, friction=0.1).rollouts
    own = rows["motion"] == "plan"
    assert rollouts.position_errors == pytest.approx(rows["position_error_m"][own], abs=1e-12)
    assert rollouts.max_forces == pytest.approx(rows["max_force_n"][own], abs=1e-9)
    assert rollouts.success.tolist() == [bool(value) for value in rows["success"][own]]
    assert rollouts.offsets == pytest.approx(plan.offsets)
    scenarios, knots, pairs = len(plan.states), len(plan.time), len(rollouts.pairs)
    assert rollouts.states.shape == (scenarios, knots, 13) and rollouts.torques.shape == (scenarios, knots - 1, 3)
    assert rollouts.contact_points.shape == (scenarios, knots - 1, pairs, 3)
    # Contact points lie on the floor, whose upper side is at z = 0, where it presses.
    floor = rollouts.pairs.index("box/floor")
    pressed = (rollouts.forces[..., floor] > 1.0) & (np.abs(rollouts.distances[..., floor]) < 1e-4)
    assert pressed.any() and np.abs(rollouts.contact_points[..., floor, 2][pressed]).max() < 1e-3
    one = scene.rollouts(plan, offsets=[0.001, 0.0, 0.0], rotations=[[0.0, 0.02, 0.0]])
    assert one.offsets.tolist() == [[0.001, 0.0, 0.0]] and one.turns.tolist() == [[0.0, 0.02, 0.0]]
    with pytest.raises(SceneError, match="rotations: has 1 rows, offsets 2"):
        scene.rollouts(plan, offsets=np.zeros((2, 3)), rotations=np.zeros((1, 3)))


def test_a_reference_is_refined(scene: Scene) -> None:
    straight = np.linspace(scene.starts["1"], scene.goal, 21)
    straight[:, 3:] /= np.linalg.norm(straight[:, 3:], axis=1, keepdims=True)
    before = Reference(straight)
    refined, report = scene.refine(before, friction=0.0, time_limit=5.0, target_rate=0.9)
    assert report["rate_after"] >= report["rate_before"] and len(refined.states) >= 21
    assert scene.simulate(refined).rate() >= scene.simulate(before).rate()


def test_constraints_of_the_optimum_have_residuals_and_multipliers(scene: Scene) -> None:
    plan = scene.replace(limits={"translational_velocity": 0.034, "contact_force": 20.0}).solve()
    constraints = plan.constraints
    value, lower, upper = (constraints[name] for name in ("value", "lower", "upper"))
    assert np.maximum(lower - value, value - upper).max() < 1e-3
    assert set(constraints["kind"]) >= {"gap", "motion of the body", "contact force"}
    assert set(constraints["scenario"]) == {0, 1, 2}
    # At the end of an interior-point method, multipliers are mu over the distances from both bounds, with one mu.
    fast = (constraints["kind"] == "limits.translational_velocity") & (constraints["scenario"] > 0)
    expected = 1 / (upper - value)[fast] - 1 / (value - lower)[fast]
    large = np.abs(expected) > 100
    assert large.sum() > 3
    barriers = constraints["multiplier"][fast][large] / expected[large]
    assert barriers.min() > 0 and barriers == pytest.approx(np.median(barriers), rel=0.1)
    again: Plan = pickle.loads(pickle.dumps(plan))
    with pytest.raises(SceneError, match="solve again"):
        _ = again.constraints


def test_gains_are_arrays(scene: Scene) -> None:
    assert scene.impedance.translational_stiffness == 50.0
    damping = scene.impedance.translational_damping
    assert damping.shape == (3, 3) and np.array_equal(damping, damping.T) and (np.linalg.eigvalsh(damping) > 0).all()
    assert Scene.load(PEG).arm is None


@pytest.fixture(scope="module")
def with_arm() -> Scene:
    arms = ROOT / "examples/arms"
    return Scene.from_dict(
        tomllib.loads(CORNER.read_text()) | tomllib.loads((arms / "six.toml").read_text()), base=arms
    )


@pytest.mark.filterwarnings("ignore::assembly_plan.SceneWarning")
def test_an_arm_has_kinematics_and_inertia(with_arm: Scene) -> None:
    arm = with_arm.arm
    assert arm is not None and len(arm.joints) == 6
    near = arm.configuration
    assert arm.pose(near) == pytest.approx(with_arm.goal, abs=1e-9)
    lower, upper = arm.position_limits
    assert (lower < near).all() and (near < upper).all() and (arm.speed_limits > 0).all()
    # The first three rows of the Jacobian are derivatives of the position.
    step = 1e-6
    ahead, behind = (arm.pose(near + sign * step * np.eye(6)) for sign in (1, -1))
    moving = (ahead - behind)[:, :3] / (2 * step)
    assert np.abs(arm.jacobian(near)[:3].T - moving).max() < 1e-8
    # The rows below: of a rotation by w dt from the identity, the vector part of the quaternion is w dt / 2.
    turning = (ahead - behind)[:, 4:] / step
    assert np.abs(arm.jacobian(near)[3:].T - turning).max() < 1e-8
    mass, jacobian = arm.mass_matrix(near), arm.jacobian(near)
    assert np.linalg.eigvalsh(mass).min() > 0
    inertia = np.linalg.inv(jacobian @ np.linalg.inv(mass) @ jacobian.T)
    assert arm.apparent_inertia(near) == pytest.approx(inertia, rel=1e-6)
    start = arm.inverse_kinematics(with_arm.starts["1"])
    assert arm.pose(start) == pytest.approx(with_arm.starts["1"], abs=1e-6)
    assert arm.jacobian(np.stack([near, start]))[1] == pytest.approx(arm.jacobian(start))
    with pytest.raises(SceneError, match="pose: "):
        arm.inverse_kinematics([9.0, 0, 0, 1, 0, 0, 0])
    with pytest.raises(SceneError, match=r"configuration: has shape \(5,\), must have shape \(K, 6\)"):
        arm.pose(np.zeros(5))


@pytest.mark.filterwarnings("ignore::assembly_plan.SceneWarning")
def test_joints_follow_the_body(with_arm: Scene) -> None:
    arm, plan = with_arm.arm, with_arm.solve(homotopy={"homotopy": {"iterations": 4}})
    assert arm is not None
    course = arm.course(plan)
    assert course.positions.shape == (len(plan.states), len(plan.time), 6) == course.torques.shape
    for states, offset, positions in zip(plan.states, plan.offsets, course.positions, strict=True):
        # The robot believes the part to be where its offset says, in the frame of the body; the body hardly rotates.
        believed = arm.pose(positions)[:, :3] - states[:, :3]
        assert np.linalg.norm(believed, axis=1) == pytest.approx(np.linalg.norm(offset), abs=1e-6)
    speeds = np.diff(course.positions, axis=1) / plan.time_step
    assert course.speeds[:, 1:] == pytest.approx(speeds) and not course.speeds[:, 0].any()
