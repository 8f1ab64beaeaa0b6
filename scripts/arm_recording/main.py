"""Kinematics and dynamics of an arm in MuJoCo at random configurations, as JSON."""

import json
import sys
from pathlib import Path

import mujoco
import numpy as np

CONFIGURATIONS = 6
GRAVITY = [0.3, -0.2, -9.7]
BASE = {"position": [-0.5, 0.2, 0.1], "orientation": [0.9, 0.1, -0.3, 0.2]}
GRASP = {"position": [0.01, -0.02, 0.03], "orientation": [0.2, 0.9, 0.3, -0.1]}
PAYLOAD = {"mass": 1.3, "centre": [0.01, 0.02, -0.04], "inertia": [0.004, 0.005, 0.003, 0.0005, -0.0003, 0.0002]}


def unit(quaternion: list[float]) -> list[float]:
    """The quaternion with norm 1."""
    return (np.array(quaternion) / np.linalg.norm(quaternion)).tolist()


def chain(spec: mujoco.MjSpec, tip: str) -> list[mujoco.MjsJoint]:
    """Joints between the base and the tip; those beside are held as `robot` holds them: at zero or the limit next to it."""
    joints, body = [], spec.body(tip)
    while body is not None and body.name != "world":
        joints = list(body.joints) + joints
        body = body.parent
    for joint in [joint for joint in spec.joints if all(joint.name != kept.name for kept in joints)]:
        assert joint.type == mujoco.mjtJoint.mjJNT_SLIDE, "only slides beside the chain can be held"
        body = joint.parent
        turned = np.zeros(3)
        mujoco.mju_rotVecQuat(turned, np.array(joint.axis), np.array(body.quat))
        body.pos = np.array(body.pos) + turned * np.clip(0.0, *joint.range)
        spec.delete(joint)
    return joints


def build(urdf: str, tip: str, rotor_inertia: list[float]) -> tuple[mujoco.MjModel, list[str]]:
    """The arm on its base with the part in its tip, and the names of its joints."""
    arm = mujoco.MjSpec.from_file(urdf)
    for equality in list(arm.equalities):
        arm.delete(equality)
    names = [joint.name for joint in chain(arm, tip)]
    for name, inertia in zip(names, rotor_inertia):
        arm.joint(name).armature = inertia
    part = arm.body(tip).add_body(name="the part", pos=GRASP["position"], quat=unit(GRASP["orientation"]))
    part.mass, part.ipos, part.fullinertia = PAYLOAD["mass"], PAYLOAD["centre"], PAYLOAD["inertia"]
    part.explicitinertial = True
    world = mujoco.MjSpec()
    world.compiler.fusestatic = False
    world.option.gravity = GRAVITY
    frame = world.worldbody.add_frame(pos=BASE["position"], quat=unit(BASE["orientation"]))
    world.attach(arm, frame=frame, prefix="arm/")
    return world.compile(), names


def record(model: mujoco.MjModel, position: np.ndarray, velocity: np.ndarray) -> dict:
    """What MuJoCo computes at one state."""
    data = mujoco.MjData(model)
    part, count = model.body("arm/the part").id, model.nv
    data.qpos[:] = position
    mujoco.mj_forward(model, data)
    gravity = data.qfrc_bias.copy()
    data.qvel[:] = velocity
    mujoco.mj_forward(model, data)
    mass, linear, angular = np.zeros((count, count)), np.zeros((3, count)), np.zeros((3, count))
    mujoco.mj_fullM(model, data, mass)
    place, to_body = data.xpos[part], data.xmat[part].reshape(3, 3).T
    mujoco.mj_jac(model, data, linear, angular, place, part)
    jacobian = np.vstack([linear, to_body @ angular])
    mujoco.mj_jacDot(model, data, linear, angular, place, part)
    # The turn of the body's axes adds nothing: it is about the angular velocity itself.
    rate = np.concatenate([linear @ velocity, to_body @ angular @ velocity])
    return {
        "position": position.tolist(),
        "velocity": velocity.tolist(),
        "part": [*place.tolist(), *data.xquat[part].tolist()],
        "jacobian": jacobian.tolist(),
        "velocity_product": rate.tolist(),
        "mass_matrix": mass.tolist(),
        "bias": (data.qfrc_bias - gravity).tolist(),
        "gravity": gravity.tolist(),
    }


def main() -> None:
    """Writes the record of the arm on the command line."""
    urdf, tip, file = sys.argv[1:]
    count = len(chain(mujoco.MjSpec.from_file(urdf), tip))
    rotor_inertia = [round(0.05 + 0.03 * index, 2) for index in range(count)]
    model, names = build(urdf, tip, rotor_inertia)
    random = np.random.default_rng(7)
    ranges = np.where(model.jnt_limited[:, None], model.jnt_range, [-3, 3])
    states = [(random.uniform(*ranges.T), random.uniform(-2, 2, model.nv)) for _ in range(CONFIGURATIONS)]
    content = {
        "mujoco": mujoco.__version__,
        "tip": tip,
        "joints": names,
        "field": GRAVITY,
        "base": BASE,
        "grasp": GRASP,
        "payload": PAYLOAD,
        "rotor_inertia": rotor_inertia,
        "states": [record(model, position, velocity) for position, velocity in states],
    }
    Path(file).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
