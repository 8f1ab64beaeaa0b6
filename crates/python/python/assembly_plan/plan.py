"""Plans and their motions."""

from __future__ import annotations

import html
import json
import os
import shutil
import tempfile
import weakref
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from assembly_plan import _planner
from assembly_plan._arrays import FloatArray, fixed
from assembly_plan._replan import measured_again
from assembly_plan._values import number, whole
from assembly_plan.errors import SceneError
from assembly_plan.events import Progress
from assembly_plan.figure import Figure
from assembly_plan.motion import Motion


class Plan(Motion):
    """A plan: its motion, and what is known of it.

    `Scene.solve` and `Plan.load` return plans. One that does not reach the goal is a plan too: see `status` and `done`.
    Of a robust plan, the scenarios are rollouts with hard contacts.
    """

    def __init__(self, native: _planner.Plan) -> None:
        """Not to be called."""
        super().__init__(native.motion())
        self._native = native

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Plan:
        """Read the plan in a folder that `Plan.save` or the command ``solve`` has written.

        Raises `SceneError` where there is none, or where a file of it was changed.
        """
        return cls(_planner.Plan.load(folder))

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the plan's files into a folder, as the command ``solve --out`` does; all other commands read them.

        An older plan in it is replaced once the new one is whole. Raises `SceneError` where the folder holds a file
        that the plan would replace and that no earlier run has written.
        """
        self._native.save(folder)

    @property
    def result(self) -> dict[str, Any]:
        """Everything that is known of the plan besides its motions: the content of ``result.json``.

        Keys name their units. ``files`` is empty before the plan is saved.
        """
        result: dict[str, Any] = json.loads(self._native.result())
        return result

    @property
    def status(self) -> str:
        """What has become of the plan, in words."""
        return str(self.result["status"])

    @property
    def done(self) -> bool:
        """Whether it is a robust plan that has passed its rollouts (exit code 0 of ``solve --robust``)."""
        return bool(self.result["done"])

    @property
    def planned(self) -> bool:
        """Whether it is the plan of a solver that reaches the goal in its smoothed model (exit code 0 of ``solve``).

        ``result["tested"]`` says how it does in rollouts with hard contact.
        """
        return bool(self.result["planned"])

    @property
    def resolved(self) -> str:
        """Scene and settings after defaults and choices, as TOML: the content of ``resolved.toml``."""
        return self._native.resolved()

    def replan(
        self,
        *,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        offset_magnitude: float | None = None,
        time_limit: float = 300.0,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> Plan:
        """Plan robustly for a start, a goal or a grasp error that was measured again.

        `start` and `goal` are poses, shape (7,), and the environment moves with the goal; `offset_magnitude` is in
        metres. By default they are those of this plan, as are the rest of its scene, frictions and target rate. The
        reference is moved with the goal, led there from the new start, and evaluated in rollouts. It is refined if it
        fails, and the scene is solved if it fails in most of the first rollouts. After `time_limit` (s), apart from
        reading and checking the scene, the best plan so far is returned, and ``result["robust"]["after"]`` says how
        often it was played.
        """
        from assembly_plan.scene import Scene

        scene = Scene.from_dict(measured_again(self.resolved, start, goal, offset_magnitude))
        robust = self.result.get("robust")
        frictions = None if robust is None else list(dict.fromkeys(row["friction"] for row in robust["after"]))
        return scene.solve_robust(
            from_=self,
            friction=frictions,
            target_rate=0.99 if robust is None else robust["target_rate"],
            time_limit=time_limit,
            jobs=jobs,
            progress=progress,
        )

    @property
    def offsets(self) -> FloatArray:
        """Offset of the part in the gripper in every scenario (m, body frame), shape (S, 3)."""
        return self._grasps("offset_m")

    @property
    def turns(self) -> FloatArray:
        """Turn of the part in the gripper in every scenario (rotation vector, rad), shape (S, 3)."""
        return self._grasps("turn_rad")

    @property
    def stages(self) -> list[Motion]:
        """The motion after every homotopy step."""
        return [Motion(native) for native in self._native.stages()]

    @property
    def constraints(self) -> dict[str, NDArray[Any]]:
        """Every constraint and bound at the solver's optimum, one entry per constraint in every column.

        Text: ``kind``, ``unit``, ``axis`` and ``pair``, empty without one. Numbers: ``scenario`` (from 1, 0 for
        the reference), ``time_s``, ``value``, ``lower`` and ``upper`` (infinite without one), and ``multiplier``,
        positive at an upper bound that holds the cost up and negative at a lower one. A residual is how far ``value``
        is outside of its bounds. Multipliers are those of the solver's last barrier parameter mu, mu over the distance
        from a bound: derivatives of the cost with its barrier terms, not of the cost alone. ``pandas.DataFrame`` takes
        it.

        Raises `SceneError` for a plan that was loaded: its folder does not have the multipliers.
        """
        rows: list[dict[str, Any]] | None = json.loads(self._native.constraints())
        if rows is None:
            raise SceneError("constraints: only a plan that was solved in this process has them; solve again")
        infinite = {"lower": -np.inf, "upper": np.inf, "scenario": 0}
        columns: dict[str, NDArray[Any]] = {}
        for name in rows[0]:
            absent = infinite.get(name, "")
            columns[name] = np.array([absent if row[name] is None else row[name] for row in rows])
            columns[name].flags.writeable = False
        return columns

    def sensitivities(self) -> dict[str, float]:
        """Derivatives of the optimal cost by offsets, start and goal, to first order, per metre or radian.

        ``offset 1 x`` is component x of the first planned offset (m, body frame); ``start`` and ``goal`` have ``x``,
        ``y``, ``z`` (m, world frame) and ``rotation x``, ``rotation y``, ``rotation z`` (rad, body frame). The
        environment stays where it is. They are those of the solver's optimum at its last smoothing. Raises
        `SceneError` for a plan that was loaded: its folder does not have the multipliers.
        """
        found = self._native.sensitivities()
        if found is None:
            raise SceneError("sensitivities: only a plan that was solved in this process has them; solve again")
        return dict(found)

    def export(
        self, to: str, folder: str | os.PathLike[str], *, rate: float = 500.0, anyway: bool = False
    ) -> list[str]:
        """Write what a robot reads into a folder, as the command ``export`` does; returns the names of the files.

        `to` is a target of that command, such as ``csv`` or ``ur-rtde``; `rate` are samples per second (Hz). A plan
        that is not done, or succeeds too rarely in rollouts, is refused unless `anyway`.
        """
        with tempfile.TemporaryDirectory() as place:
            self._copy(Path(place) / "plan")
            return _planner.write_export(Path(place) / "plan", to, folder, number(rate, "rate"), bool(anyway))

    def mjcf(self, *, anyway: bool = False) -> str:
        """The model for MuJoCo that plays the plan, as the command ``export --to mjcf`` writes it.

        ``mujoco.MjModel.from_xml_string`` takes it; it names no other file. `anyway` is that of `export`.
        """
        with tempfile.TemporaryDirectory() as folder:
            self.export("mjcf", folder, anyway=anyway)
            return (Path(folder) / "plan.xml").read_text(encoding="utf-8")

    def figure(self, name: str = "keyframes-y") -> Figure:
        """Draw a figure for papers and slides, as the command ``report --figures`` does.

        - ``keyframes-x``, ``keyframes-y``, ``keyframes-z``: sections across an axis through the parts, at six moments.
        - ``forces``: contact force of every scenario over time.
        - ``convergence``: penetration and violation after every homotopy step.
        """
        with tempfile.TemporaryDirectory() as place:
            self._copy(Path(place) / "plan")
            drawn = {file.removesuffix(".svg"): svg for file, svg in _planner.figures(Path(place) / "plan")}
        if name not in drawn:
            raise SceneError(f"name = {name!r}: unknown; choose one of {', '.join(drawn)}")
        return Figure(name, drawn[name])

    def report(self, file: str | os.PathLike[str]) -> None:
        """Write the HTML page that shows the plan, as the command ``report`` does; it needs no other file."""
        with tempfile.TemporaryDirectory() as folder:
            self._copy(Path(folder) / "plan")
            _planner.write_page(Path(folder) / "plan", file)

    def animate(self, file: str | os.PathLike[str], *, scenario: int | None = None) -> None:
        """Write the moving plan as a picture for slides, as the command ``report --animation`` does.

        The extension of `file` is ``.svg`` or ``.gif``. All scenarios are shown, or only number `scenario`, from 1.
        """
        with tempfile.TemporaryDirectory() as folder:
            self._copy(Path(folder) / "plan")
            only = None if scenario is None else whole(scenario, "scenario")
            _planner.write_animation(Path(folder) / "plan", file, only)

    def _repr_html_(self) -> str:
        """The page of the plan, in a notebook."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "report.html"
            self.report(file)
            page = html.escape(file.read_text(encoding="utf-8"))
        return f'<iframe srcdoc="{page}" width="100%" height="720" style="border: 0"></iframe>'

    def plot(self, axes: Any = None) -> Any:
        """Plot positions of reference and body over time with Matplotlib, which has to be installed.

        Returns the axes: three, for x, y and z (mm). `axes` are three to draw into.
        """
        import matplotlib.pyplot

        if axes is None:
            _, axes = matplotlib.pyplot.subplots(3, sharex=True)
        for axis, name in enumerate("xyz"):
            axes[axis].plot(self.time, 1e3 * self.reference[:, axis], "k--", label="reference")
            for scenario, states in enumerate(self.states, start=1):
                axes[axis].plot(self.time, 1e3 * states[:, axis], label=f"scenario {scenario}")
            axes[axis].set_ylabel(f"{name} (mm)")
        axes[-1].set_xlabel("time (s)")
        axes[0].legend(loc="best")
        return axes

    def __reduce__(self) -> tuple[Any, ...]:
        with tempfile.TemporaryDirectory() as folder:
            self._copy(Path(folder) / "plan")
            root = Path(folder) / "plan"
            files = {str(file.relative_to(root)): file.read_bytes() for file in root.rglob("*") if file.is_file()}
        return _plan_of, (files,)

    def __copy__(self) -> Plan:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Plan:
        return self

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Plan):
            return NotImplemented
        return self.resolved == other.resolved and bool(np.array_equal(self.reference, other.reference))

    def __hash__(self) -> int:
        return hash((self.resolved, self.reference.tobytes()))

    def __repr__(self) -> str:
        return f"{super().__repr__()[:-1]}, {self.status}>"

    def _copy(self, folder: Path) -> None:
        """Write a copy, which is not where the plan is saved."""
        self._native.copy(folder)

    def _grasps(self, key: str) -> FloatArray:
        return fixed([scenario.get(key, [0.0] * 3) for scenario in self.result["scenarios"]])


def _plan_of(files: dict[str, bytes]) -> Plan:
    """The plan with these files, which stay in a folder of their own as long as it lives."""
    folder = Path(tempfile.mkdtemp(prefix="assembly-plan-"))
    for name, content in files.items():
        file = folder / "plan" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    plan = Plan.load(folder / "plan")
    weakref.finalize(plan, shutil.rmtree, folder, ignore_errors=True)
    return plan
