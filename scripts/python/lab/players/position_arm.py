"""An arm in MuJoCo that is commanded joint positions: its joints go there with a delay and the lag of a servo, however
hard it is pushed. The part is on a stiff spring at the flange."""

import collections
import json
import math
import tomllib

import numpy as np

import rotations
from lab.mujoco.control import GraspError
from lab.mujoco.position_robot import CRITICAL_BANDWIDTH
from lab.mujoco.rotations import rotation_matrix
from lab.paths import SCENES
from lab.players.commanded_part import BANDWIDTH, DELAY, commanded_part
from lab.players.simulated_arm import TIME_STEP, SimulatedArm, Task

# The sensor passes on what it feels (Hz): the controller filters.
UNFILTERED = 1e6


class PositionArm(SimulatedArm):
    """Of the arm itself, only the kinematics is used."""

    def __init__(self, task: Task) -> None:
        super().__init__(task)
        document = json.loads((task.plan / "plan.json").read_text())
        scene = tomllib.loads((SCENES / f"{document['scene']}.toml").read_text())
        grasp_error = GraspError(np.array(task.offset), np.array(task.turn))
        truth = task.truth
        self.rate = 2 * math.pi * (truth.bandwidth or BANDWIDTH) / CRITICAL_BANDWIDTH
        self.coming = collections.deque([self.data.qpos.copy()] * round((truth.delay or DELAY) / TIME_STEP))
        self.passed_on = np.zeros(6)
        self.part = commanded_part(scene, document, self.believed()[0], grasp_error, TIME_STEP, UNFILTERED)

    def believed(self) -> tuple[np.ndarray, np.ndarray]:
        """Pose (position, quaternion) and twist of the part in the world, where the robot believes it."""
        position, rotation, jacobian = self.tool()
        robot = self.player.plan.robot
        base, grasp = rotation_matrix(robot.base[3:]), rotation @ robot.grasp[:3]
        velocity, spin = np.split(jacobian @ self.data.qvel, 2)
        part = base @ rotation @ rotation_matrix(robot.grasp[3:])
        pose = np.concatenate([robot.base[:3] + base @ (position + grasp), rotations.quaternion(part)])
        return pose, np.concatenate([base @ (velocity + rotations.cross(spin, grasp)), base @ spin])

    def tool_at(self, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The tool at other joint positions."""
        own = self.data.qpos.copy()
        self.data.qpos[:] = positions
        tool = self.tool()
        self.data.qpos[:] = own
        return tool

    def move(self, command: np.ndarray, seconds: float) -> None:
        """The joints go on to commanded positions (rad)."""
        data = self.data
        for _ in range(round(seconds / TIME_STEP)):
            self.coming.append(command)
            ahead = self.coming.popleft() - data.qpos
            data.qvel[:] += TIME_STEP * (self.rate**2 * ahead - 2 * self.rate * data.qvel)
            data.qpos[:] += TIME_STEP * data.qvel
            pose, twist = self.believed()
            self.part.carry(pose[:3], pose[3:], twist[:3], twist[3:])
        self.passed_on = self.of_spring()
        self.time += seconds

    def contact_wrench(self) -> np.ndarray:
        """What the spring has passed on at the end of the last motion."""
        return self.passed_on

    def of_spring(self) -> np.ndarray:
        """Force and torque of the spring, about the tool point."""
        robot = self.player.plan.robot
        base = rotation_matrix(robot.base[3:])
        force, torque = (base.T @ part for part in self.part.wrench)
        lever = self.tool()[1] @ robot.grasp[:3]
        return np.concatenate([force, torque + rotations.cross(lever, force)])

    def state(self) -> np.ndarray:
        return np.array(self.part.state())
