"""Stand-in for the module of this name in ur-rtde: what the player uses, with the same signatures."""

import os


class DashboardClient:
    """The version of the simulated robot."""

    def __init__(self, hostname: str, port: int = 29999, verbose: bool = False) -> None:
        pass

    def connect(self, timeout_ms: int = 2000) -> None:
        pass

    def polyscopeVersion(self) -> str:
        return os.environ.get("POLYSCOPE", "URSoftware 5.26.0.1234567 (Jun 01 2026)")

    def disconnect(self) -> None:
        pass
