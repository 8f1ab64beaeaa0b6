"""MuJoCo models of the arms in crates/robot/tests/arms. The base is turned, the part has mass and sits askew in the
gripper: tests compare with what MuJoCo makes of all of it."""

import mujoco
import numpy as np

from lab.mujoco.arm_world import PREFIX, hold_others

GRAVITY = [0.3, -0.2, -9.7]
BASE = {"position": [-0.5, 0.2, 0.1], "orientation": [0.9, 0.1, -0.3, 0.2]}
GRASP = {"position": [0.01, -0.02, 0.03], "orientation": [0.2, 0.9, 0.3, -0.1]}
PAYLOAD = {"mass": 1.3, "centre": [0.01, 0.02, -0.04], "inertia": [0.004, 0.005, 0.003, 0.0005, -0.0003, 0.0002]}


def unit(quaternion: list[float]) -> list[float]:
    """The quaternion with norm 1."""
    return (np.array(quaternion) / np.linalg.norm(quaternion)).tolist()


def build(urdf: str, tip: str, rotor_inertia: list[float]) -> tuple[mujoco.MjSpec, list[str]]:
    """The arm on its base with the part in its tip, and the names of its joints."""
    arm = mujoco.MjSpec.from_file(urdf)
    names = [joint.name for joint in hold_others(arm, tip)]
    for name, inertia in zip(names, rotor_inertia):
        arm.joint(name).armature = inertia
    part = arm.body(tip).add_body(name="the part", pos=GRASP["position"], quat=unit(GRASP["orientation"]))
    part.mass, part.ipos, part.fullinertia = PAYLOAD["mass"], PAYLOAD["centre"], PAYLOAD["inertia"]
    part.explicitinertial = True
    world = mujoco.MjSpec()
    world.compiler.fusestatic = False
    world.option.gravity = GRAVITY
    frame = world.worldbody.add_frame(pos=BASE["position"], quat=unit(BASE["orientation"]))
    world.attach(arm, frame=frame, prefix=PREFIX)
    return world, names


def joint_count(urdf: str, tip: str) -> int:
    """How many joints move the tip."""
    return len(hold_others(mujoco.MjSpec.from_file(urdf), tip))
