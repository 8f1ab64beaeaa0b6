"""Stand-in for the module of this name in ur-rtde: what the player uses, with the same signatures."""

import rotations
from lab.players import simulated_robot


class RTDEReceiveInterface:
    """Measurements of the simulated robot."""

    def __init__(
        self,
        hostname: str,
        frequency: float = -1.0,
        variables: list[str] = [],
        verbose: bool = False,
        use_upper_range_registers: bool = False,
        rt_priority: int = 0,
    ) -> None:
        self.robot = simulated_robot.robot(hostname)
        self.arm = self.robot.arm

    def getTimestamp(self) -> float:
        return self.arm.said().time

    def getActualQ(self) -> list[float]:
        return self.arm.said().positions.tolist()

    def getActualQd(self) -> list[float]:
        return self.arm.said().speeds.tolist()

    def getActualTCPPose(self) -> list[float]:
        position, rotation, _ = self.robot.tool()
        return [*position.tolist(), *rotations.vector(rotation).tolist()]

    def getActualTCPForce(self) -> list[float]:
        return self.arm.said().wrench.tolist()

    def isConnected(self) -> bool:
        return self.robot.is_connected and not self.arm.fails("disconnect")

    def getSafetyStatusBits(self) -> int:
        return 1 | self.arm.fails("protective") << 2 | self.arm.fails("safeguard") << 4

    def disconnect(self) -> None:
        self.robot.is_connected = False
