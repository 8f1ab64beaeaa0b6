"""Stand-in for the module of this name in ur-rtde: what the player uses, with the same signatures. Force mode is an arm
that follows the wrench with its own dynamics, which is not how these robots do it: only calls and guards are tested
with it."""

import datetime

import numpy as np

from lab.players import simulated_robot


class RTDEControlInterface:
    """Commands to the simulated robot."""

    def __init__(
        self, hostname: str, frequency: float = -1.0, flags: int = 1, ur_cap_port: int = 50002, rt_priority: int = 0
    ) -> None:
        self.robot = simulated_robot.robot(hostname)
        self.arm = self.robot.arm
        self.is_running = True

    def initPeriod(self) -> datetime.timedelta:
        return datetime.timedelta(seconds=self.arm.time)

    def waitPeriod(self, arg0: datetime.timedelta) -> None:
        self.robot.wait()

    def getJacobian(self, pos: list[float] = [], tcp: list[float] = []) -> list[float]:
        return self.robot.tool()[2].flatten(order="F").tolist()

    def directTorque(
        self,
        torque: list[float],
        viscous_scale: list[float] = [0.9, 0.9, 0.8, 0.9, 0.9, 0.9],
        coulomb_scale: list[float] = [0.8, 0.8, 0.7, 0.8, 0.8, 0.8],
    ) -> bool:
        is_accepted = self.robot.command("torque", np.array(torque))
        if self.arm.fails("stuck"):
            self.robot.fall_silent()
        return is_accepted

    def forceMode(self, arg0: list[float], arg1: list[int], arg2: list[float], arg3: int, arg4: list[float]) -> bool:
        position, _, jacobian = self.robot.tool()
        self.arm.obey(np.array([*arg0, *arg2]))
        assert np.allclose(arg0[:3], position, atol=1e-3) and arg1 == [1] * 6 and arg3 == 2
        return self.robot.command("force", jacobian.T @ np.array(arg2))

    def forceModeStop(self) -> bool:
        self.arm.mode, self.robot.torques = "position", None
        return True

    def forceModeSetDamping(self, arg0: float) -> bool:
        return True

    def forceModeSetGainScaling(self, arg0: float) -> bool:
        return True

    def zeroFtSensor(self) -> bool:
        return True

    def setWatchdog(self, min_frequency: float = 10.0) -> bool:
        return not self.arm.fails("no watchdog")

    def kickWatchdog(self) -> bool:
        return True

    def stopJ(self, a: float = 2.0, asynchronous: bool = False) -> None:
        self.arm.mode, self.robot.torques = "position", None

    def stopScript(self) -> None:
        self.is_running = False

    def isConnected(self) -> bool:
        return self.robot.is_connected

    def isProgramRunning(self) -> bool:
        return self.is_running

    def disconnect(self) -> None:
        self.arm.leave()
