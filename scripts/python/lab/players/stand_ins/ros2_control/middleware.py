"""Stand-in for the topics of a robot with the admittance controller of ros2_controllers, which is loaded with the
parameters beside the player and active from the beginning."""

import argparse
import pathlib
from typing import Any

import numpy as np
from admittance_robot import OFFSETS
from inbox import Message

import rotations
from lab.players import admittance_controller
from lab.players.admittance_controller import AdmittanceController
from lab.players.position_arm import PositionArm
from lab.players.simulated_arm import Task
from lab.players.simulated_topics import SimulatedTopics

# At the end, the reference is this close (m, rad) to the tool, but for what the force that it feels holds: one of which
# nothing is heard for 0.1 s has moved since.
AT_REST = 0.003
# The reference moves the tool by no more than this (m, rad) in a period: what jumps hits.
LARGEST_STEP = 0.001
# By how much joints seem to be held from their references (rad).
HELD = 0.05


class Middleware(SimulatedTopics):
    """References go to the controller, and its offsets come back."""

    largest_gain = 5.0

    def __init__(self, arguments: argparse.Namespace, joints: list[str]) -> None:
        task = Task.read()
        rate, parameters = admittance_controller.read(pathlib.Path(__file__).resolve().parent / "controllers.yaml")
        assert parameters["joints"] == joints, parameters["joints"]
        if task.fault.kind in ("deaf", "clipped"):
            parameters["admittance.mass"] = [2 * mass for mass in parameters["admittance.mass"]]
        arm = PositionArm(task)
        self.rate, self.controller = rate, AdmittanceController(arm, parameters, 1 / rate)
        self.sent = self.controller.positions
        super().__init__(arguments, arm, 1 / rate, parameters, [OFFSETS])

    def step(self) -> None:
        self.controller.parameters = self.gains
        self.controller.update()

    def hear(self) -> None:
        super().hear()
        if self.arm.fails("other joints"):
            self.inbox.refuse("the controller moves the joints of another arm")
        elif not self.arm.fails("inactive"):
            offset = self.controller.offset + (HELD if self.arm.fails("held") else 0.0)
            self.inbox.put(OFFSETS, Message(offset, self.arm.time))

    def parameters(self, of: str, names: list[str]) -> dict[str, Any]:
        if of == "controller_manager":
            return {"update_rate": int(self.rate / 2 if self.arm.fails("slow") else self.rate)}
        found = super().parameters(of, names)
        return found | {name: "flange" for name in names if name.endswith("frame.id") and self.arm.fails("other link")}

    def set_parameters(self, of: str, values: dict[str, Any]) -> None:
        for name, value in values.items():
            admittance_controller.require(name, value)
        super().set_parameters(of, values)

    def publish_joints(self, positions: list[float], speeds: list[float]) -> None:
        wanted = np.array(positions)
        self.is_on, self.arm.mode = True, "admittance"
        self.arm.obey(np.concatenate([wanted, speeds]))
        step = self.arm.tool()[2] @ (wanted - self.sent)
        assert np.linalg.norm(step[:3]) <= LARGEST_STEP, f"the reference jumps by {step}"
        self.sent = wanted
        if not self.arm.fails("ignored"):
            self.controller.positions = wanted

    def is_left_at_rest(self) -> bool:
        position, rotation, _ = self.arm.tool()
        home, turned, _ = self.arm.tool_at(self.controller.positions)
        ways = np.concatenate([position - home, rotations.vector(rotation @ turned.T)])
        held = np.abs(self.arm.wrench() / self.controller.six("stiffness"))
        return bool((np.abs(ways) <= AT_REST + held).all())
