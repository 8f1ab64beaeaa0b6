"""Kinematics and dynamics of an arm in MuJoCo at random configurations, as JSON."""

import json
from pathlib import Path

import mujoco
import numpy as np

from lab.recording.model import BASE, GRASP, GRAVITY, PAYLOAD, build, joint_count

CONFIGURATIONS = 6


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


def write(urdf: str, tip: str, file: Path) -> None:
    """Writes the record of an arm."""
    rotor_inertia = [round(0.05 + 0.03 * index, 2) for index in range(joint_count(urdf, tip))]
    spec, names = build(urdf, tip, rotor_inertia)
    model = spec.compile()
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
    file.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
