"""MuJoCo models of arms."""

import mujoco
import numpy as np

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


def build(urdf: str, tip: str, rotor_inertia: list[float]) -> tuple[mujoco.MjSpec, list[str]]:
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
    return world, names
