"""The MuJoCo model of a scene in which an arm holds the part."""

import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np

from lab.errors import InputError
from lab.mujoco import world
from lab.mujoco.plans import Plan
from lab.mujoco.robots import Robot

GRAVITY = [0.0, 0.0, -9.81]

# Before the names of links and joints, so that none of them is that of a part.
PREFIX = "arm/"

# Dry friction of joints: the defaults of MuJoCo let a joint creep by millimetres at the tip while it should stick.
FRICTION_SOLIMP = [0.9999, 0.9999, 0.001, 0.5, 2.0]

MOVING = (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE)


def build(plan: Plan, contact: world.Contact) -> mujoco.MjModel:
    """The arm on its base with gravity, and every pair of parts able to touch; links touch nothing. The part has no
    mass. It is the body `body` in the tip: at the site `grasp`, until `model.body_pos` and `body_quat` say
    otherwise."""
    robot = plan.robot
    try:
        arm = read_arm(robot, contact.time_step)
        spec = mujoco.MjSpec()
        world.set_options(spec.option, contact)
        spec.option.gravity = GRAVITY
        # The link that holds the part must stay, even if it is fixed to another.
        spec.compiler.fusestatic = False
        base = spec.worldbody.add_frame(pos=robot.base[:3], quat=robot.base[3:])
        spec.attach(arm, frame=base, prefix=PREFIX)
        tip = spec.body(PREFIX + robot.tip)
        tip.add_site(name="grasp", pos=robot.grasp[:3], quat=robot.grasp[3:])
        body = tip.add_body(name="body", pos=robot.grasp[:3], quat=robot.grasp[3:], explicitinertial=True)
        world.add_parts(spec, body, plan, contact.friction)
        model = spec.compile()
    except ValueError as error:
        raise InputError(f"{robot.urdf}: MuJoCo refuses the arm: {error}") from error
    world.check_parts(model, plan)
    return model


def read_arm(robot: Robot, time_step: float) -> mujoco.MjSpec:
    """The links and joints of the URDF file without shapes, with the robot's rotor inertia and joint friction."""
    arm = mujoco.MjSpec.from_string(without_shapes(robot))
    if arm.body(robot.tip) is None:
        raise InputError(f"{robot.urdf}: there is no link `{robot.tip}`, which [robot] tip names")
    chain = hold_others(arm, robot.tip)
    if len(chain) != len(robot.configuration):
        names = ", ".join(joint.name for joint in chain)
        raise InputError(
            f"{robot.urdf}: {len(chain)} joints move `{robot.tip}` ({names}), but [robot] configuration has "
            f"{len(robot.configuration)} numbers"
        )
    for joint, inertia, friction in zip(chain, robot.rotor_inertia, robot.joint_friction):
        joint.armature, joint.frictionloss, joint.damping[0] = inertia, friction, 0.0
        joint.solref_friction, joint.solimp_friction = [2 * time_step, 1.0], FRICTION_SOLIMP
    return arm


def without_shapes(robot: Robot) -> str:
    """The text of the URDF file without visual and collision shapes, whose meshes may be missing."""
    try:
        root = ElementTree.parse(robot.urdf).getroot()
    except ElementTree.ParseError as error:
        raise InputError(f"{robot.urdf}: no XML: {error}") from error
    except OSError as error:
        raise InputError(f"{robot.urdf} cannot be read: {error}") from error
    if root.tag != "robot":
        raise InputError(f"{robot.urdf}: no URDF file: its root is <{root.tag}>, not <robot>")
    for link in root.iter("link"):
        for shape in [child for child in link if child.tag in ("visual", "collision")]:
            link.remove(shape)
    return ElementTree.tostring(root, encoding="unicode")


def hold_others(arm: mujoco.MjSpec, tip: str) -> list[mujoco.MjsJoint]:
    """Fixes the joints that do not move the tip at zero, or at the limit next to it; returns the others, base to tip.
    Joints that follow others are free of them."""
    for equality in list(arm.equalities):
        arm.delete(equality)
    chain, body = [], arm.body(tip)
    while body is not None:
        chain = list(body.joints) + chain
        body = body.parent
    names = {joint.name for joint in chain}
    for joint in [joint for joint in arm.joints if joint.name not in names]:
        hold(joint)
        arm.delete(joint)
    for joint in chain:
        if joint.type not in MOVING:
            raise InputError(f"joint `{joint.name}` of the arm is neither revolute, continuous nor prismatic")
    return chain


def hold(joint: mujoco.MjsJoint) -> None:
    """Moves a joint's link to where the joint holds it."""
    position = np.clip(0.0, *joint.range) if joint.limited else 0.0
    body, axis = joint.parent, np.array(joint.axis)
    quaternion, shift, turn = np.array(body.quat), np.zeros(3), np.zeros(4)
    if joint.type == mujoco.mjtJoint.mjJNT_SLIDE:
        mujoco.mju_rotVecQuat(shift, position * axis, quaternion)
        body.pos = np.array(body.pos) + shift
    else:
        mujoco.mju_axisAngle2Quat(turn, axis, position)
        turned = np.zeros(4)
        mujoco.mju_mulQuat(turned, quaternion, turn)
        body.quat = turned
