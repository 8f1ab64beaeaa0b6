"""The native part of `assembly_plan`; use the classes of the package instead."""

import os
from collections.abc import Callable
from typing import TypedDict, final

class ChoiceOptions(TypedDict):
    start: str | None
    delta: float | None
    turn: float | None
    homotopy: str | os.PathLike[str] | None
    homotopy_json: str | None
    linear_solver: str | None
    position_tolerance: float | None
    angle_tolerance: float | None

class SolveOptions(TypedDict):
    out: str | os.PathLike[str] | None
    resume: bool
    jobs: int | None

class RobustOptions(TypedDict):
    wanted_rate: float
    time_limit: float
    patience: int
    friction: list[float] | None

class PlayOptions(TypedDict):
    random: int | None
    ball: bool
    seed: int
    grid: int | None
    offsets: list[list[float]] | None
    turn: float
    magnitude: list[float]
    friction: list[float]
    settling_time: float
    time_step: float
    stages: bool
    position_tolerance: float | None
    angle_tolerance: float | None
    jobs: int | None

class MotionData(TypedDict):
    time_step: float
    steps: int
    scenarios: int
    pairs: list[str]
    reference: bytes
    states: bytes
    wrenches: bytes
    distances: bytes
    forces: bytes

@final
class Scene:
    @staticmethod
    def load(file: str | os.PathLike[str]) -> Scene: ...
    @staticmethod
    def from_json(json: str, file: str | os.PathLike[str]) -> Scene: ...
    def content(self) -> str: ...
    def check(self, choices: ChoiceOptions, tau: float | None) -> str: ...
    def distances(self, choices: ChoiceOptions, pose: list[float], tau: float | None) -> str: ...
    def solve(
        self,
        choices: ChoiceOptions,
        options: SolveOptions,
        robust: RobustOptions | None,
        progress: Callable[[str, str], None] | None,
    ) -> Plan: ...
    def simulate(self, plan: Plan, options: PlayOptions, progress: Callable[[str, str], None] | None) -> Simulation: ...

@final
class Plan:
    @staticmethod
    def load(folder: str | os.PathLike[str]) -> Plan: ...
    def save(self, folder: str | os.PathLike[str]) -> None: ...
    def result(self) -> str: ...
    def resolved(self) -> str: ...
    def motion(self) -> MotionData: ...
    def stages(self) -> list[MotionData]: ...

@final
class Simulation:
    def rollouts(self) -> str: ...
    def successes(self) -> str: ...
    def table(self) -> str: ...
    def save(self, folder: str | os.PathLike[str]) -> None: ...

def run_command(interpreter: str, first: list[str], arguments: list[str]) -> int: ...
