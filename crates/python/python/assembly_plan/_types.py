"""Dictionaries that go to and come from the native module."""

from __future__ import annotations

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
    guess: ReferenceOptions | None


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
    by: str
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


class ReferenceOptions(TypedDict):
    """A reference of the user, and which problem of the scene it is for."""

    states: bytes
    poses: bool
    time_step: float
    start: str | None
    delta: float | None
    rotation_error: float | None


class RolloutOptions(TypedDict):
    """How rollouts are played in full."""

    grasps: list[tuple[list[float], list[float]]] | None
    friction: float
    settling_time: float
    time_step: float
    position_tolerance: float | None
    angle_tolerance: float | None


class RolloutData(TypedDict):
    """Rollouts in full: bytes of numbers, whose shapes follow from the motion."""

    motion: MotionData
    grasps: bytes
    success: list[bool]
    measures: bytes
    points: bytes


class CalibrationOptions(TypedDict):
    """What is fitted to which logs."""

    logs: list[str | os.PathLike[str]]
    out: str | os.PathLike[str] | None
    force: bool
    per_joint: bool
    jobs: int | None


class ContactData(TypedDict):
    """Contact information: bytes of numbers, empty for derivatives that were not asked for."""

    pairs: list[str]
    components: int
    values: bytes
    jacobians: bytes
    hessians: bytes


class CourseData(TypedDict):
    """Joints along a motion: bytes of numbers."""

    positions: bytes
    torques: bytes
