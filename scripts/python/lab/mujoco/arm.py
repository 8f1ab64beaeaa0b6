"""One motion played by an arm: joint torques of the impedance controller, with gravity and joint friction."""

import collections

import mujoco
import numpy as np

from lab.errors import InputError
from lab.mujoco.control import GraspError, State, impedance_wrench
from lab.mujoco.inverse_kinematics import configuration_at
from lab.mujoco.plans import Plan
from lab.mujoco.robots import Robot
from lab.mujoco.rollout import Player
from lab.mujoco.rotations import quaternion_of, rotation_matrix
from lab.mujoco.world import clearance

# The reference is followed from goal to start in steps of this time (s).
FOLLOWING_STEP = 0.05


class ArmPlayer(Player):
    """Plays motions with the whole arm: torques `J' wrench + bias` of the believed pose, which joint angles and the
    grasp give, are computed every control period and held. The part sits in the gripper with its grasp error, of which
    the controller never learns."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int) -> None:
        super().__init__(model, plan, window)
        self.grasp = model.site("grasp").id
        self.part = model.body("body").id
        self.torque_limits = torque_limits(model)
        self.period, self.delay = timing(plan.robot, model.opt.timestep)

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        self.release(start_configuration(self.model, self.plan.robot, samples), grasp_error)

    def release(self, configuration: np.ndarray, grasp_error: GraspError) -> None:
        """Puts the arm at rest at joint positions (rad) with a grasp error."""
        model, data = self.model, self.data
        self.misplace(grasp_error)
        mujoco.mj_resetData(model, data)
        data.qpos[:] = configuration
        mujoco.mj_forward(model, data)
        # What holds the arm until the first torque arrives.
        self.pending = collections.deque([data.qfrc_bias.copy()] * self.delay)

    def misplace(self, grasp_error: GraspError) -> None:
        """Moves the part in the gripper."""
        place = misplaced(self.plan.robot, grasp_error)
        self.model.body_pos[self.part], self.model.body_quat[self.part] = place[:3], place[3:]

    def advance(self, step: int, reference: State) -> None:
        model, data = self.model, self.data
        mujoco.mj_step1(model, data)
        if step % self.period == 0:
            self.torque = self.control(reference)
        self.pending.append(self.torque)
        data.qfrc_applied[:] = self.pending.popleft()
        mujoco.mj_step2(model, data)

    def control(self, reference: State) -> np.ndarray:
        """Torques (Nm) of the impedance controller that also carry the arm."""
        data, quaternion = self.data, np.zeros(4)
        linear, angular = np.zeros((2, 3, self.model.nv))
        mujoco.mj_jacSite(self.model, data, linear, angular, self.grasp)
        mujoco.mju_mat2Quat(quaternion, data.site_xmat[self.grasp])
        angular = data.site_xmat[self.grasp].reshape(3, 3).T @ angular
        pose = [*data.site_xpos[self.grasp].tolist(), *quaternion.tolist()]
        velocity = [*(linear @ data.qvel).tolist(), *(angular @ data.qvel).tolist()]
        wrench = impedance_wrench(self.plan.impedance, reference, pose, velocity, [0.0, 0.0, 0.0])
        torque = linear.T @ wrench[:3] + angular.T @ wrench[3:] + data.qfrc_bias
        return np.clip(torque, *self.torque_limits)

    def state(self) -> State:
        data, part = self.data, self.part
        linear, angular = np.zeros((2, 3, self.model.nv))
        mujoco.mj_kinematics(self.model, data)
        mujoco.mj_comPos(self.model, data)
        mujoco.mj_jacBody(self.model, data, linear, angular, part)
        angular = data.xmat[part].reshape(3, 3).T @ angular
        return np.concatenate([data.xpos[part], data.xquat[part], linear @ data.qvel, angular @ data.qvel]).tolist()

    def goal_clearance(self) -> float:
        configuration = configuration_at(self.model, self.plan.goal, self.plan.robot.configuration)
        self.release(configuration, GraspError(np.zeros(3), np.zeros(3)))
        return clearance(self.model, self.data)


def start_configuration(model: mujoco.MjModel, robot: Robot, samples: list[State]) -> np.ndarray:
    """Joint positions at the first sample, on the branch of the robot's configuration: the reference is followed
    backwards from its end."""
    stride = max(1, round(FOLLOWING_STEP / model.opt.timestep))
    configuration = robot.configuration
    for sample in [*samples[:0:-stride], samples[0]]:
        configuration = configuration_at(model, np.array(sample[:7]), configuration)
    return configuration


def misplaced(robot: Robot, grasp_error: GraspError) -> np.ndarray:
    """Pose of the part in the tip (7 numbers) with a grasp error: shifted by the offset and turned, it is the believed
    one."""
    quaternion = np.zeros(4)
    mujoco.mju_mulQuat(quaternion, robot.grasp[3:], quaternion_of(-grasp_error.turn))
    return np.concatenate([robot.grasp[:3] - rotation_matrix(quaternion) @ grasp_error.offset, quaternion])


def timing(robot: Robot, time_step: float) -> tuple[int, int]:
    """Control period and delay in time steps."""
    period = round(robot.control_period / time_step)
    if abs(period * time_step - robot.control_period) > 1e-9:
        raise InputError(
            f"--time-step {time_step:g}: the control period of {robot.control_period:g} s is no multiple of it"
        )
    return period, round(robot.delay / time_step)


def torque_limits(model: mujoco.MjModel) -> np.ndarray:
    """Lowest and highest torque (Nm) of every joint (2 x joints)."""
    return np.where(model.jnt_actfrclimited, model.jnt_actfrcrange.T, [[-np.inf], [np.inf]])
