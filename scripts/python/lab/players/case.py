"""What a test of a player is."""

import dataclasses
import pathlib
from collections.abc import Callable


@dataclasses.dataclass(frozen=True)
class Case:
    """A plan that is played, what goes wrong, and what is expected: the exit code, words on standard error, whether the
    part ends at its goal. `arm` is what the plan was recorded for, if it is not the usual one of the target, `limit` is
    the largest size of a file that the player may write (bytes), `spoil` changes the folder before."""

    name: str
    target: str
    plan: str
    code: int = 0
    says: str = ""
    inserts: bool = False
    flags: tuple[str, ...] = ("--skip-self-test",)
    simulation: dict = dataclasses.field(default_factory=dict)
    environment: dict = dataclasses.field(default_factory=dict)
    arm: str = ""
    interrupted_at: str = ""
    signal: str = "SIGINT"
    has_packages: bool = True
    has_receiver: bool = True
    hears: bool = True
    limit: int | None = None
    spoil: Callable[[pathlib.Path], None] | None = None
    log: str = "executed.csv"

    @property
    def folder(self) -> str:
        """A name of a folder."""
        return self.name.replace(" ", "-")


def fault(kind: str, at: float = 2.0) -> dict:
    """A fault that comes at a time of the robot (s)."""
    return {"fault": {"kind": kind, "time": at}}
