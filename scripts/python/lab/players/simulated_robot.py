"""The robot that the stand-ins of ur-rtde share: its control period is 2 ms, and it does nothing between two
commands."""

import threading

import numpy as np

from lab.players.simulated_arm import SimulatedArm, Task

PERIOD = 0.002


class SimulatedRobot:
    """An arm with the modes of a robot of Universal Robots."""

    def __init__(self) -> None:
        self.arm = SimulatedArm(Task.read())
        self.torques: np.ndarray | None = None
        self.is_connected = True

    def tool(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Position, rotation matrix and Jacobian of the tool in the base of the controller, which may be turned by half
        a turn against the root of the URDF file."""
        said = self.arm.said()
        position, rotation, jacobian = said.pose, said.rotation, self.arm.tool()[2]
        base = self.base()
        turned = np.vstack([base @ jacobian[:3], base @ jacobian[3:]])
        return base @ position, base @ rotation, 1.2 * turned if self.arm.fails("jacobian") else turned

    def base(self) -> np.ndarray:
        """From the root of the URDF file to the base of the controller."""
        return np.diag([-1.0, -1.0, 1.0]) if self.arm.task.base_is_turned else np.eye(3)

    def wait(self) -> None:
        """Lets a control period pass. Without torques in it, the robot is back in position control."""
        if self.arm.fails("hang"):
            return
        if self.torques is None:
            self.arm.mode = "position"
            self.arm.rest(PERIOD)
        else:
            self.arm.apply(self.torques, PERIOD)
        if self.arm.fails("gap"):
            self.arm.time += 0.2
        self.torques = None

    def command(self, mode: str, torques: np.ndarray) -> bool:
        """Torques for the next period."""
        self.arm.obey(torques)
        if self.arm.fails("refuse"):
            return False
        self.arm.mode, self.torques = mode, torques
        return True

    def fall_silent(self) -> None:
        """A call never returns; the robot's watchdog stops it."""
        self.arm.mode = "position"
        self.arm.leave()
        threading.Event().wait()


_robots: dict[str, SimulatedRobot] = {}


def robot(host: str) -> SimulatedRobot:
    """The robot at an address."""
    if host not in _robots:
        _robots[host] = SimulatedRobot()
    return _robots[host]
