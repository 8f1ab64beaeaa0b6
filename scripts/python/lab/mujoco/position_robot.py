"""A robot that is commanded by position, with an admittance law, in MuJoCo. The law is the one that the documentation
of the admittance controller of ros2_controllers states: deviations from the reference obey a mass, a damper and a
spring under the measured wrench, are integrated explicitly, and are added to the reference."""

import collections
import math

import mujoco
import numpy as np

from lab.mujoco.control import GraspError, State
from lab.mujoco.plans import Plan, PositionRobot
from lab.mujoco.rollout import FreePlayer
from lab.mujoco.rotations import quaternion_of, rotation_matrix

# A critically damped servo is 3 dB down at this frequency, in its natural frequency.
CRITICAL_BANDWIDTH = math.sqrt(math.sqrt(2) - 1)


class PositionPlayer(FreePlayer):
    """The part on a spring of the contact stiffness at the flange, which follows commanded poses however hard it is
    pushed."""

    def __init__(self, model: mujoco.MjModel, plan: Plan, window: int, robot: PositionRobot) -> None:
        super().__init__(model, plan, window)
        self.robot, self.time_step = robot, model.opt.timestep
        self.every = round(robot.period / self.time_step)
        self.rate = 2 * math.pi * robot.bandwidth / CRITICAL_BANDWIDTH
        self.share = -math.expm1(-2 * math.pi * robot.cutoff * self.time_step)
        stiffness = robot.contact_stiffness
        self.spring = (stiffness, stiffness * robot.lever**2)
        inertia = float(np.diag(plan.free_body.inertia).mean())
        self.damper = (2 * math.sqrt(stiffness * plan.free_body.mass), 2 * math.sqrt(self.spring[1] * inertia))

    def begin(self, samples: list[State], grasp_error: GraspError) -> None:
        """Also puts flange and law at rest where the robot believes the part."""
        super().begin(samples, grasp_error)
        self.turned = quaternion_of(grasp_error.turn)
        pose = self.believed(np.array(samples[0]))
        self.flange = (pose[0].copy(), pose[1].copy())
        self.speed = [np.zeros(3), np.zeros(3)]
        # Deviation of the law from the reference (m, rad), its rate, and the filtered wrench.
        self.deviation, self.rates = [np.zeros(3), np.zeros(3)], [np.zeros(3), np.zeros(3)]
        self.wrench = [np.zeros(3), np.zeros(3)]
        self.hold(pose)

    def hold(self, command: tuple[np.ndarray, ...] | np.ndarray) -> None:
        """A command that has been the only one for long."""
        self.command = command
        self.commands = collections.deque([command] * max(1, round(self.robot.delay / self.time_step)))

    def believed(self, reference: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Position of the believed part and rotation matrix of the part, at a reference."""
        return reference[:3], rotation_matrix(reference[3:7]) @ rotation_matrix(self.turned).T

    def advance(self, step: int, reference: State) -> None:
        """One time step: law, servo, spring."""
        if step % self.every == 0:
            self.sample(np.array(reference))
        self.commands.append(self.command)
        self.follow(*self.commands.popleft())
        self.pull()
        mujoco.mj_step(self.model, self.data)

    def sample(self, reference: np.ndarray) -> None:
        """One sample of the law, in the axes of the world."""
        robot, period = self.robot, self.robot.period
        for part in range(2):
            held = robot.damping[part] * self.rates[part] + robot.stiffness[part] * self.deviation[part]
            self.rates[part] = self.rates[part] + period * (self.wrench[part] - held) / robot.mass[part]
            self.deviation[part] = self.deviation[part] + period * self.rates[part]
        position, rotation = self.believed(reference)
        self.command = position + self.deviation[0], rotation_of(self.deviation[1]) @ rotation

    def follow(self, position: np.ndarray, rotation: np.ndarray) -> None:
        """The servo: critically damped, in small steps."""
        ahead = (position - self.flange[0], vector_of(rotation @ self.flange[1].T))
        for part in range(2):
            acceleration = self.rate**2 * ahead[part] - 2 * self.rate * self.speed[part]
            self.speed[part] = self.speed[part] + self.time_step * acceleration
        turn = rotation_of(self.time_step * self.speed[1])
        self.flange = self.flange[0] + self.time_step * self.speed[0], turn @ self.flange[1]

    def pull(self) -> None:
        """The spring pulls at the believed origin; the sensor measures what it passes on, about that point."""
        data = self.data
        rotation = rotation_matrix(data.qpos[3:7])
        lever = rotation @ np.array(self.control.offset)
        spin = rotation @ data.qvel[3:]
        stretch = self.flange[0] - data.qpos[:3] - lever
        velocity = data.qvel[:3] + cross(spin, lever)
        force = self.spring[0] * stretch + self.damper[0] * (self.speed[0] - velocity)
        twist = vector_of(self.flange[1] @ rotation.T)
        torque = self.spring[1] * twist + self.damper[1] * (self.speed[1] - spin)
        data.qfrc_applied[:3] = force
        data.qfrc_applied[3:] = rotation.T @ (torque + cross(lever, force))
        for part, value in enumerate((-force, -torque)):
            self.wrench[part] = self.wrench[part] + self.share * (value - self.wrench[part])


def rotation_of(vector: np.ndarray) -> np.ndarray:
    """The rotation matrix of a rotation vector (rad)."""
    return rotation_matrix(quaternion_of(vector))


def vector_of(rotation: np.ndarray) -> np.ndarray:
    """The rotation vector (rad) of a rotation matrix."""
    quaternion, vector = np.zeros(4), np.zeros(3)
    mujoco.mju_mat2Quat(quaternion, rotation.flatten())
    mujoco.mju_quat2Vel(vector, quaternion, 1.0)
    return vector


def cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """The cross product of two vectors, many times faster than that of NumPy."""
    product = np.zeros(3)
    mujoco.mju_cross(product, first, second)
    return product
