"""Dictionaries that go to and come from the native module."""

import os
from typing import TypedDict


class ChoiceOptions(TypedDict):
    """What is chosen of a scene."""

    start: str | None
    delta: float | None
    rotation_error: float | None
    homotopy: str | os.PathLike[str] | None
    homotopy_json: str | None
    linear_solver: str | None
    position_tolerance: float | None
    angle_tolerance: float | None


class SolveOptions(TypedDict):
    """How a problem is solved."""

    out: str | os.PathLike[str] | None
    resume: bool
    jobs: int | None


class RobustOptions(TypedDict):
    """How a plan is made robust."""

    target_rate: float
    time_limit: float
    stall_limit: int
    friction: list[float] | None


class PlayOptions(TypedDict):
    """How a plan is played."""

    random: int | None
    hull: bool
    disc: bool
    ball: bool
    seed: int
    grid: int | None
    offsets: list[list[float]] | None
    rotation_error: float
    magnitude: list[float]
    friction: list[float]
    settling_time: float
    time_step: float
    stages: bool
    position_tolerance: float | None
    angle_tolerance: float | None
    jobs: int | None


class ToleranceOptions(TypedDict):
    """Which errors of a plan are measured."""

    quantities: list[str]
    need: tuple[str, float] | None
    map: tuple[str, str] | None
    rows: list[float]
    target_rate: float
    friction: list[float] | None
    cases: int
    seed: int
    position_tolerance: float | None
    angle_tolerance: float | None
    jobs: int | None


class MotionData(TypedDict):
    """A motion: bytes of numbers, whose shapes follow from steps, scenarios and pairs."""

    time_step: float
    steps: int
    scenarios: int
    pairs: list[str]
    reference: bytes
    states: bytes
    wrenches: bytes
    distances: bytes
    forces: bytes
