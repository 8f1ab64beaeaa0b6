"""A part in the gripper of an arm, in Drake: torques of the impedance controller, with gravity and joint friction."""

import collections
import xml.etree.ElementTree as ElementTree

import numpy as np
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.tree import (
    FixedOffsetFrame,
    Frame,
    JacobianWrtVariable,
    Joint,
    PdControllerGains,
    RigidBody,
    SpatialInertia,
)

from lab.drake.contact import Compliance
from lab.drake.player import DrakePlayer
from lab.mujoco import arm_world
from lab.mujoco.arm import misplaced, start_configuration, timing, torque_limits
from lab.mujoco.control import GraspError, State, impedance_wrench
from lab.mujoco.plans import Plan
from lab.mujoco.rotations import rotation_matrix
from lab.mujoco.world import Contact

# Name of the root link: that of the file may be `world`, which Drake takes for its own.
ROOT = "root of the arm"
# Damping (Nms/rad) of a joint that its dry friction holds: 0.5 Nm let it creep by 5e-7 rad/s.
STICKING = 1e6


class ArmPlayer(DrakePlayer):
    """Plays motions with the whole arm, by the law of the player in MuJoCo, which also solves inverse kinematics."""

    gravity = arm_world.GRAVITY

    def __init__(self, plan: Plan, contact: Contact, compliance: Compliance, window_time: float) -> None:
        self.model = arm_world.build(plan, contact)
        self.period, self.delay = timing(plan.robot, contact.time_step)
        super().__init__(plan, contact, compliance, window_time)
        plant = self.plant
        self.torque_limits = torque_limits(self.model)
        self.velocities = [joint.velocity_start() for joint in self.chain]
        self.torques = np.zeros(plant.num_velocities())
        self.port = plant.get_applied_generalized_force_input_port().FixValue(self.context, self.torques)
        desired = plant.get_desired_state_input_port(self.chain[0].model_instance())
        desired.FixValue(self.context, np.zeros(desired.size()))

    def add_body(self) -> RigidBody:
        plant, robot = self.plant, self.plan.robot
        (arm,) = Parser(plant).AddModelsFromString(prepared(arm_world.without_shapes(robot)), "urdf")
        root = plant.GetFrameByName(ROOT, arm)
        plant.WeldFrames(plant.world_frame(), root, transform(robot.base))
        names = [self.model.joint(index).name.removeprefix(arm_world.PREFIX) for index in range(self.model.njnt)]
        self.chain = [plant.GetJointByName(name, arm) for name in names]
        for joint, inertia, friction in zip(self.chain, robot.rotor_inertia, robot.joint_friction):
            self.add_rotor(joint, inertia, friction)
        moving = [plant.get_joint(index) for index in plant.GetJointIndices(arm)]
        self.others = [joint for joint in moving if joint.num_velocities() and joint not in self.chain]
        tip = plant.GetFrameByName(robot.tip, arm)
        self.believed = plant.AddFrame(FixedOffsetFrame("believed", tip, transform(robot.grasp)))
        self.real: Frame = plant.AddFrame(FixedOffsetFrame("real", tip, transform(robot.grasp)))
        body = plant.AddRigidBody("part", arm, SpatialInertia.Zero())
        plant.WeldFrames(self.real, body.body_frame())
        return body

    def add_rotor(self, joint: Joint, inertia: float, friction: float) -> None:
        """Rotor inertia and dry friction of a joint: a strong damper that slips at the friction, which the solver of
        contacts treats as it treats these."""
        actuator = self.plant.AddJointActuator(joint.name(), joint, friction if friction > 0 else np.inf)
        actuator.set_default_rotor_inertia(inertia)
        actuator.set_default_gear_ratio(1.0)
        if friction > 0:
            actuator.set_controller_gains(PdControllerGains(p=0.0, d=STICKING))

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        self.release(start_configuration(self.model, self.plan.robot, samples), grasp_error)

    def release(self, configuration: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the arm at rest at joint positions (rad) with a grasp error."""
        plant, context = self.plant, self.context
        self.real.SetPoseInParentFrame(context, transform(misplaced(self.plan.robot, grasp_error)))
        positions = np.zeros(plant.num_positions())
        for joint in self.others:
            limits = joint.position_lower_limits(), joint.position_upper_limits()
            positions[joint.position_start()] = np.clip(0.0, *limits).item()
            joint.Lock(context)
        positions[[joint.position_start() for joint in self.chain]] = configuration
        plant.SetPositions(context, positions)
        plant.SetVelocities(context, np.zeros(plant.num_velocities()))
        self.initialize()
        # What holds the arm until the first torque arrives.
        self.pending = collections.deque([self.bias()] * self.delay)

    def bias(self) -> np.ndarray:
        """Torques (Nm) that carry the arm as it moves."""
        plant, context = self.plant, self.context
        forces = plant.CalcBiasTerm(context) - plant.CalcGravityGeneralizedForces(context)
        return forces[self.velocities]

    def advance(self, step: int, reference: State) -> None:
        if step % self.period == 0:
            self.torque = self.control_torque(reference)
        self.pending.append(self.torque)
        self.torques[self.velocities] = self.pending.popleft()
        self.port.GetMutableData().set_value(self.torques)
        self.step()

    def control_torque(self, reference: State) -> np.ndarray:
        """Torques (Nm) of the impedance controller that also carry the arm."""
        plant, context, frame = self.plant, self.context, self.believed
        world = plant.world_frame()
        jacobian = plant.CalcJacobianSpatialVelocity(context, JacobianWrtVariable.kV, frame, np.zeros(3), world, world)[
            :, self.velocities
        ]
        pose = frame.CalcPoseInWorld(context)
        rotation = pose.rotation().matrix()
        turning = rotation.T @ jacobian[:3]
        speeds = plant.GetVelocities(context)[self.velocities]
        velocity = [*(jacobian[3:] @ speeds).tolist(), *(turning @ speeds).tolist()]
        wrench = impedance_wrench(self.plan.impedance, reference, listed(pose), velocity, [0.0, 0.0, 0.0])
        torque = jacobian[3:].T @ wrench[:3] + turning.T @ wrench[3:] + self.bias()
        return np.clip(torque, *self.torque_limits)

    def state(self) -> State:
        pose = self.plant.EvalBodyPoseInWorld(self.context, self.body)
        velocity = self.plant.EvalBodySpatialVelocityInWorld(self.context, self.body)
        turning = pose.rotation().matrix().T @ velocity.rotational()
        return [*listed(pose), *velocity.translational().tolist(), *turning.tolist()]


def transform(pose: np.ndarray) -> RigidTransform:
    """A pose of 7 numbers."""
    return RigidTransform(RotationMatrix(rotation_matrix(pose[3:])), pose[:3])


def listed(pose: RigidTransform) -> State:
    """A pose as 7 numbers."""
    return [*pose.translation().tolist(), *pose.rotation().ToQuaternion().wxyz().tolist()]


def prepared(urdf: str) -> str:
    """The text of a URDF file with a root of our name, and without what the robot of a scene states itself: friction,
    damping, gears and joints that follow others."""
    tree = ElementTree.fromstring(urdf)
    for transmission in tree.findall("transmission"):
        tree.remove(transmission)
    joints = tree.findall("joint")
    for joint in joints:
        for element in [child for child in joint if child.tag in ("dynamics", "mimic")]:
            joint.remove(element)
    children = {joint.find("child").get("link") for joint in joints}
    for link in tree.findall("link"):
        if link.get("name") not in children:
            rename(link, joints)
    return ElementTree.tostring(tree, encoding="unicode")


def rename(root: ElementTree.Element, joints: list[ElementTree.Element]) -> None:
    """Gives the root link our name, also in the joints that it carries."""
    for parent in (joint.find("parent") for joint in joints):
        if parent.get("link") == root.get("name"):
            parent.set("link", ROOT)
    root.set("name", ROOT)
