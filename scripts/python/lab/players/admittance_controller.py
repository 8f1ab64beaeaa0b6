"""The admittance controller of ros2_controllers, as its documentation and parameters state it, on a simulated arm."""

import pathlib
from typing import Any

import numpy as np
import yaml

import rotations
from lab.players.position_arm import PositionArm

# Its parameters: kinds of their values, and ranges where there are some. Those without a default must be given.
TEXT, TEXTS, TRUTH, TRUTHS, NUMBER, NUMBERS = "text", "texts", "truth", "truths", "number", "numbers"
ANY = (-np.inf, np.inf)
PARAMETERS: dict[str, tuple[str, int, tuple[float, float]]] = {
    "joints": (TEXTS, 0, ANY),
    "command_joints": (TEXTS, 0, ANY),
    "command_interfaces": (TEXTS, 0, ANY),
    "state_interfaces": (TEXTS, 0, ANY),
    "chainable_command_interfaces": (TEXTS, 0, ANY),
    "kinematics.plugin_name": (TEXT, 0, ANY),
    "kinematics.plugin_package": (TEXT, 0, ANY),
    "kinematics.base": (TEXT, 0, ANY),
    "kinematics.tip": (TEXT, 0, ANY),
    "kinematics.alpha": (NUMBER, 0, ANY),
    "ft_sensor.name": (TEXT, 0, ANY),
    "ft_sensor.frame.id": (TEXT, 0, ANY),
    "ft_sensor.filter_coefficient": (NUMBER, 0, ANY),
    "control.frame.id": (TEXT, 0, ANY),
    "fixed_world_frame.frame.id": (TEXT, 0, ANY),
    "gravity_compensation.frame.id": (TEXT, 0, ANY),
    "gravity_compensation.CoG.pos": (NUMBERS, 3, ANY),
    "gravity_compensation.CoG.force": (NUMBER, 0, ANY),
    "admittance.selected_axes": (TRUTHS, 6, ANY),
    "admittance.mass": (NUMBERS, 6, (1e-4, 1e6)),
    "admittance.damping_ratio": (NUMBERS, 6, ANY),
    "admittance.stiffness": (NUMBERS, 6, (0.0, 1e8)),
    "admittance.joint_damping": (NUMBER, 0, (0.0, np.inf)),
    "enable_parameter_update_without_reactivation": (TRUTH, 0, ANY),
}
DEFAULTS: dict[str, Any] = {
    "command_joints": [],
    "kinematics.alpha": 0.01,
    "ft_sensor.filter_coefficient": 0.05,
    "gravity_compensation.CoG.force": 0.0,
    "admittance.joint_damping": 5.0,
    "enable_parameter_update_without_reactivation": True,
}
KINDS = {TEXT: str, TRUTH: bool, NUMBER: float, TEXTS: str, TRUTHS: bool, NUMBERS: float}
LISTS = (TEXTS, TRUTHS, NUMBERS)


def read(file: pathlib.Path) -> tuple[float, dict[str, Any]]:
    """Updates per second of the controller manager, and the parameters of the controller, as ROS 2 takes them."""
    document = yaml.safe_load(file.read_text())
    manager = document["controller_manager"]["ros__parameters"]
    own = flat(document["admittance_controller"]["ros__parameters"])
    kind = manager["admittance_controller"]["type"]
    assert kind == "admittance_controller/AdmittanceController" and isinstance(manager["update_rate"], int)
    for name, value in own.items():
        require(name, value)
    missing = set(PARAMETERS) - set(own) - set(DEFAULTS)
    assert not missing, f"{file}: {sorted(missing)} have no default"
    return float(manager["update_rate"]), DEFAULTS | own


def flat(tree: dict[str, Any], before: str = "") -> dict[str, Any]:
    """Parameters by their whole names."""
    found = {}
    for name, value in tree.items():
        found |= flat(value, f"{before}{name}.") if isinstance(value, dict) else {before + name: value}
    return found


def require(name: str, value: Any) -> None:
    """A parameter that exists, of its kind, size and range. An integer is no number with a point."""
    kind, size, (low, high) = PARAMETERS[name]
    values = value if kind in LISTS else [value]
    assert isinstance(values, list) and all(type(each) is KINDS[kind] for each in values), f"{name} = {value!r}"
    assert not size or len(values) == size, f"{name} has {len(values)} values, not {size}"
    assert kind not in (NUMBER, NUMBERS) or all(low <= each <= high for each in values), f"{name} = {value}"


class AdmittanceController:
    """Adds to the references of the joints what its law makes of the wrench at the sensor's frame."""

    def __init__(self, arm: PositionArm, parameters: dict[str, Any], period: float) -> None:
        self.arm, self.parameters, self.period = arm, parameters, period
        robot = arm.player.plan.robot
        # This one computes its law at the tool, along the axes of the base.
        assert parameters["ft_sensor.frame.id"] == parameters["kinematics.tip"] == robot.tip
        assert parameters["control.frame.id"] == parameters["kinematics.base"]
        self.positions, self.speeds = arm.data.qpos.copy(), np.zeros(arm.model.nv)
        self.offset, self.offset_speed = np.zeros(arm.model.nv), np.zeros(arm.model.nv)
        self.filtered = np.zeros(6)

    def six(self, name: str) -> np.ndarray:
        """Values along x, y, z and about them."""
        return np.array(self.parameters[f"admittance.{name}"], dtype=float)

    def update(self) -> None:
        """One period: the offset of the tool obeys mass, damper and spring, and is integrated in the joints."""
        position, rotation, jacobian = self.arm.tool()
        home, turned, _ = self.arm.tool_at(self.positions)
        share = self.parameters["ft_sensor.filter_coefficient"]
        self.filtered = share * self.arm.wrench() + (1 - share) * self.filtered
        deviation = np.concatenate([position - home, rotations.vector(rotation @ turned.T)])
        mass, stiffness = self.six("mass"), self.six("stiffness")
        damping = 2 * self.six("damping_ratio") * np.sqrt(mass * stiffness)
        load = self.six("selected_axes") * self.filtered
        acceleration = (load - damping * (jacobian @ self.offset_speed) - stiffness * deviation) / mass
        joints = jacobian.shape[1]
        inverse = np.linalg.solve(
            jacobian.T @ jacobian + self.parameters["kinematics.alpha"] * np.eye(joints), jacobian.T
        )
        slowed = inverse @ acceleration - self.parameters["admittance.joint_damping"] * self.offset_speed
        self.offset_speed = self.offset_speed + self.period * slowed
        self.offset = self.offset + self.period * self.offset_speed
        self.arm.move(self.positions + self.offset, self.period)
