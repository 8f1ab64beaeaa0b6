"""The part on a stiff spring at a flange that goes where it is told, in MuJoCo: what a robot holds that is commanded by
position."""

import mujoco
import numpy as np

from lab.mujoco import world
from lab.mujoco.control import GraspError
from lab.mujoco.plans import FreeBody, PositionRobot
from lab.mujoco.position_robot import PositionPlayer
from lab.mujoco.rotations import rotation_matrix
from lab.players import simulated_arm

FRICTION = 0.1
# Bandwidth (Hz) and delay (s) of the robot.
BANDWIDTH, DELAY = 20.0, 0.004
# Distance (m) of contacts from the part's origin.
LEVER = 0.05
NO_GAINS = (0.0, 0.0)


class CommandedPart(PositionPlayer):
    """The flange moves by commands from outside."""

    def sample(self, reference: np.ndarray) -> None:
        """No law of its own."""

    def tool(self) -> tuple[np.ndarray, np.ndarray]:
        """Position and rotation matrix of the believed part."""
        position, rotation = self.flange
        return position, rotation @ rotation_matrix(self.turned)

    def go_to(self, position: np.ndarray, quaternion: np.ndarray) -> None:
        """The believed part is commanded to a pose, which the flange follows."""
        self.command = self.believed(np.concatenate([position, quaternion]))

    def carry(self, position: np.ndarray, quaternion: np.ndarray, velocity: np.ndarray, spin: np.ndarray) -> None:
        """The flange is there for a time step: the believed part has this pose and twist."""
        self.flange, self.speed = self.believed(np.concatenate([position, quaternion])), [velocity, spin]
        self.pull()
        mujoco.mj_step(self.model, self.data)


def commanded_part(
    scene: dict, document: dict, start: np.ndarray, grasp_error: GraspError, time_step: float, cutoff: float
) -> CommandedPart:
    """The part at rest where the robot believes it at `start` (position, quaternion, in the world); the sensor filters
    at `cutoff` (Hz)."""
    law = document["admittance"]
    stiffness = law["contact_stiffness_n_m"]
    robot = PositionRobot(law["period_s"], DELAY, BANDWIDTH, cutoff, NO_GAINS, NO_GAINS, NO_GAINS, stiffness, LEVER)
    plan = simulated_arm.world(scene, document, None, FreeBody(1.0, np.zeros(3), 1e-2 * np.eye(3)))
    part = CommandedPart(world.build(plan, world.Contact(FRICTION, time_step)), plan, 1, robot)
    part.begin([[*start.tolist(), *[0.0] * 6]], grasp_error)
    return part
