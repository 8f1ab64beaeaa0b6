"""Every value that a robot says, as what is no number, in every phase of a session: without a simulation, for the whole
table."""

import contextlib
import dataclasses
import io
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np

from exported_plan import ExportedPlan, ToolState
from failures import Stopped
from guards import Limits, Measurement
from session import Session
from settings import Settings

PERIOD = 0.05
BEFORE = ""
PHASES = (BEFORE, "holding", "going to the start", "playing")
VALUES = (np.nan, np.inf, -np.inf)


def within(values: np.ndarray, value: float) -> np.ndarray:
    """The last of some values is another one."""
    changed = values.copy()
    changed.flat[-1] = value
    return changed


def of_tool(name: str) -> Callable[[Measurement, float], Measurement]:
    """Changes a part of the state of the tool."""

    def change(said: Measurement, value: float) -> Measurement:
        state = said.tool
        owner = state.pose if name in ("position", "rotation") else state
        changed = dataclasses.replace(owner, **{name: within(getattr(owner, name), value)})
        return dataclasses.replace(said, tool=changed if owner is state else dataclasses.replace(state, pose=changed))

    return change


def of_robot(name: str) -> Callable[[Measurement, float], Measurement]:
    """Changes another signal."""
    return lambda said, value: dataclasses.replace(said, **{name: within(getattr(said, name), value)})


SIGNALS = {
    "time": lambda said, value: dataclasses.replace(said, time=value),
    **{name: of_robot(name) for name in ("positions", "speeds", "force", "torque")},
    **{name: of_tool(name) for name in ("position", "rotation", "velocity", "angular_velocity")},
}


class Still:
    """A robot that stands at the start, and says something else from a phase on."""

    def __init__(
        self, plan: ExportedPlan, journal: SimpleNamespace, phase: str, spoil: Callable[[Measurement], Measurement]
    ) -> None:
        self.arm, self.journal, self.phase, self.spoil = plan.arm, journal, phase, spoil
        self.time, self.is_spoiled, self.sent_since = 0.0, False, 0

    def read(self) -> Measurement:
        self.time += PERIOD
        joints, nothing = len(self.arm.names), np.zeros(3)
        tool = ToolState.at_rest(self.arm.forward(self.arm.start))
        said = Measurement(self.time, self.arm.start, np.zeros(joints), tool, nothing, nothing)
        self.is_spoiled = self.is_spoiled or self.journal.phase == self.phase
        return self.spoil(said) if self.is_spoiled else said

    def begin(self, hold: ToolState) -> None:
        self.sent_since += self.is_spoiled

    def track(self, reference: ToolState, measured: Measurement) -> None:
        self.sent_since += self.is_spoiled

    def end(self) -> None: ...

    def close(self) -> None: ...


def problem(plan: ExportedPlan, signal: str, value: float, phase: str) -> str:
    """Plays a session in which a signal becomes no number; returns what is wrong with its end, or nothing."""
    journal = SimpleNamespace(phase=BEFORE, add=lambda measured, reference: None)
    journal.start = lambda phase, time: setattr(journal, "phase", phase)
    robot = Still(plan, journal, phase, lambda said: SIGNALS[signal](said, value))
    limits = Limits.of(plan.document["guards"]["insertion"])
    heedless = SimpleNamespace(defer=lambda: None, check=lambda: None, go_on=lambda: None)
    session = Session(plan, robot, Settings(0.0, False, False, limits, limits), journal, heedless, heedless)
    try:
        with contextlib.redirect_stderr(io.StringIO()):
            session.execute()
    except Stopped as error:
        is_right = "number" in str(error) and not robot.sent_since
        return "" if is_right else f"{signal} {value} {phase}: {error}, {robot.sent_since} commands"
    return f"{signal} {value} {phase}: not stopped"


def all_problems(plan: ExportedPlan) -> str:
    """Of the whole table."""
    found = [problem(plan, signal, value, phase) for signal in SIGNALS for value in VALUES for phase in PHASES]
    return "; ".join(filter(None, found))
