"""Scenes: read, checked, solved, played."""

from __future__ import annotations

import copy
import json
import os
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from assembly_plan import _planner
from assembly_plan._renamed import renamed
from assembly_plan._types import ChoiceOptions, PlayOptions, RobustOptions, SolveOptions, ToleranceOptions
from assembly_plan.errors import SceneError
from assembly_plan.events import Progress, _listener
from assembly_plan.plan import FloatArray, Plan
from assembly_plan.simulation import Simulation

StrPath: TypeAlias = str | os.PathLike[str]
"""The name of a file or folder."""

Homotopy: TypeAlias = StrPath | Mapping[str, Any]
"""A homotopy file, or a dictionary with its keys."""


@dataclass(frozen=True, eq=False)
class Part:
    """A convex part: the points x with ``normals @ x <= offsets``."""

    name: str
    """Name, unique among the parts of the body or the environment."""
    vertices: FloatArray
    """Corners (m), shape (V, 3), in the frame of the body, or of the world for the environment."""
    normals: FloatArray
    """Unit normals of the facets that point outwards, shape (F, 3), in the same frame."""
    offsets: FloatArray
    """Distances of the facets from the origin of this frame (m), shape (F,)."""

    def __repr__(self) -> str:
        return f"<Part {self.name!r}: {len(self.vertices)} corners, {len(self.offsets)} facets>"


class Scene:
    """What is to be assembled: parts, start and goal poses, the robot's controller, the size of the grasp error.

    A scene is valid: `Scene.load` and `Scene.from_dict` check everything and raise `SceneError`. A pose has 7 numbers:
    position (m, world frame) and unit quaternion ``w x y z``.

    All methods have the names and defaults of the command line for what can be chosen:

    - `start`: name of the start pose, or the number that is its name; by default the scene's first.
    - `delta`: offset magnitude (m); by default the scene's.
    - `homotopy`: homotopy file, or a dictionary with the keys of one; by default the scene's own, else the built-in
      one.
    - `linear_solver`: ``stage``, ``mumps``, or ``ma27``, ``ma57``, ``ma97`` where the HSL library is installed; by
      default the homotopy's.
    - `position_tolerance` (m), `angle_tolerance` (rad): what counts as reaching the goal; by default the scene's.
    - `jobs`: threads, by default one per processor; they change nothing but the time it takes.
    - `progress`: a function that hears of `assembly_plan.events`.
    """

    def __init__(self, native: _planner.Scene) -> None:
        """Not to be called; `Scene.load` and `Scene.from_dict` make scenes."""
        self._native = native
        content = json.loads(native.content())
        self._title: str = content["title"]
        self._starts = {start["name"]: _fixed(start["pose"]) for start in content["starts"]}
        self._goal = _fixed(content["goal"])
        self._offset_magnitude: float = content["offset_magnitude"]
        self._body, self._environment = _parts(content["body"]), _parts(content["environment"])

    @classmethod
    def load(cls, file: StrPath) -> Scene:
        """Read a scene file (TOML) and the files it names."""
        return cls(_planner.Scene.load(file))

    @classmethod
    def from_dict(cls, content: Mapping[str, Any], base: StrPath = ".") -> Scene:
        """Make a scene of a dictionary with the keys of a scene file; arrays and tuples may stand for lists.

        Names of files in it are relative to the folder `base`. Messages show the lines of the scene file that would
        have the same content, and call it ``scene``.
        """
        return cls(_planner.Scene.from_json(_json(content), Path(base) / "scene"))

    def to_dict(self) -> dict[str, Any]:
        """The scene with all defaults as a dictionary with the keys of a scene file, which `Scene.from_dict` takes.

        Meshes are convex parts in it, so that it depends on no other file but a robot's model.
        """
        content: dict[str, Any] = tomllib.loads(self._native.resolved())
        content["start"] = [
            {"name": name, "position": pose[:3].tolist(), "orientation": pose[3:].tolist()}
            for name, pose in self._starts.items()
        ]
        return content

    def replace(self, **changes: Any) -> Scene:
        """The scene with other values of some keys, such as ``scene.replace(robustness__offset_magnitude=0.01)``.

        Two underscores stand for the dot of a key in a table. A value replaces the whole key; None removes it.
        """
        content = copy.deepcopy(self.to_dict())
        for path, value in changes.items():
            *tables, key = path.split("__")
            table = content
            for name in tables:
                table = table.setdefault(name, {})
                if not isinstance(table, dict):
                    raise SceneError(f"{'.'.join(tables)}: `{name}` is no table of a scene")
            if value is None:
                table.pop(key, None)
            else:
                table[key] = value
        return Scene.from_dict(content)

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene.from_dict, (self.to_dict(),)

    def __copy__(self) -> Scene:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Scene:
        return self

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == other.to_dict() if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._native.resolved())

    @property
    def title(self) -> str:
        """Title, by default the file's name."""
        return self._title

    @property
    def starts(self) -> dict[str, FloatArray]:
        """Start poses, shape (7,), by their names; the first is the default."""
        return dict(self._starts)

    @property
    def goal(self) -> FloatArray:
        """Goal pose, shape (7,)."""
        return self._goal

    @property
    def offset_magnitude(self) -> float:
        """The scene's offset magnitude (m)."""
        return self._offset_magnitude

    @property
    def body(self) -> list[Part]:
        """Convex parts of the moved body."""
        return list(self._body)

    @property
    def environment(self) -> list[Part]:
        """Convex parts of what does not move."""
        return list(self._environment)

    def check(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        tau: float | None = None,
    ) -> dict[str, Any]:
        """Explain the scene without solving it, as the command ``check --json`` does.

        Returns parts, meshes and their convex parts, clearances, penetrations, size of the problem, warnings; keys name
        their units. `tau` smooths the distances, by default as the homotopy begins.
        """
        choices = _choices(start=start, delta=delta, homotopy=homotopy)
        explanation: dict[str, Any] = json.loads(self._native.check(choices, tau))
        return explanation

    def distances(
        self,
        pose: ArrayLike,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        tau: float | None = None,
    ) -> list[dict[str, Any]]:
        """Report every pair's distances with the body at a pose, as the command ``check --pose --json`` does.

        `pose` has shape (7,); its quaternion is scaled to unit norm. An entry has ``body``, ``environment``,
        ``smoothed_distance_m``, ``exact_distance_m`` (negative where the parts penetrate) and ``normal``, the contact
        normal with 7 numbers.
        """
        choices = _choices(start=start, delta=delta, homotopy=homotopy)
        values = _vector(pose, 7, "pose")
        pairs: list[dict[str, Any]] = json.loads(self._native.distances(choices, values, tau))
        return pairs

    def solve(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        linear_solver: str | None = None,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        jobs: int | None = None,
        out: StrPath | None = None,
        resume: bool = False,
        progress: Progress | None = None,
    ) -> Plan:
        """Plan one motion that brings the body to its goal with every planned offset.

        With `out`, the plan is written into this folder, and Ctrl-C leaves unfinished work beside it, with which
        ``resume=True`` resumes it. A plan that does not reach the goal is no error: see `Plan.status`.
        """
        choices = _choices(
            start=start,
            delta=delta,
            homotopy=homotopy,
            linear_solver=linear_solver,
            position_tolerance=position_tolerance,
            angle_tolerance=angle_tolerance,
        )
        options: SolveOptions = {"out": out, "resume": resume, "jobs": jobs}
        return Plan(self._native.solve(choices, options, None, _listener(progress)))

    @renamed(turn="rotation_error", wanted_rate="target_rate", patience="stall_limit")
    def solve_robust(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        linear_solver: str | None = None,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        target_rate: float = 0.99,
        time_limit: float = 300.0,
        stall_limit: int = 150,
        friction: float | Iterable[float] | None = None,
        rotation_error: float | None = None,
        jobs: int | None = None,
        out: StrPath | None = None,
        resume: bool = False,
        progress: Progress | None = None,
    ) -> Plan:
        """Plan one motion, and refine it until it succeeds with hard contacts at offsets that were not planned for.

        As the command ``solve --robust``:

        - `target_rate`: success rate to reach at each friction, from 0 to 1.
        - `time_limit`: end with the best plan so far after this time (s), everything included.
        - `stall_limit`: evaluate a plan again after this many perturbations in a row without improvement; 0 only
          evaluates it.
        - `friction`: Coulomb friction coefficients; by default the scene's.
        - `rotation_error`: the part may also be rotated in the gripper by up to this angle, about any axis (rad); by
          default the scene's.

        `out` and `resume` are those of `solve`.
        """
        choices = _choices(
            start=start,
            delta=delta,
            homotopy=homotopy,
            linear_solver=linear_solver,
            position_tolerance=position_tolerance,
            angle_tolerance=angle_tolerance,
            rotation_error=rotation_error,
        )
        options: SolveOptions = {"out": out, "resume": resume, "jobs": jobs}
        robust: RobustOptions = {
            "target_rate": target_rate,
            "time_limit": time_limit,
            "stall_limit": stall_limit,
            "friction": None if friction is None else _several(friction),
        }
        return Plan(self._native.solve(choices, options, robust, _listener(progress)))

    @renamed(turn="rotation_error")
    def simulate(
        self,
        plan: Plan,
        *,
        random: int | None = None,
        hull: bool = False,
        disc: bool = False,
        ball: bool = False,
        seed: int = 1,
        grid: int | None = None,
        offsets: ArrayLike | None = None,
        rotation_error: float = 0.0,
        magnitude: float | Iterable[float] = (),
        friction: float | Iterable[float] = (0.0,),
        stages: bool = False,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        settling_time: float = 1.0,
        time_step: float = 0.001,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> Simulation:
        """Play a plan, and a straight push, with hard contacts and injected offsets.

        By default the planned offsets are played. As the command ``simulate``:

        - `random`: play this many random offsets of those that the scene covers, or with `hull` in the hull of the
          planned ones, with `disc` in the disc across the insertion, with `ball` in the ball; half of those of a disc
          or a ball lie on its rim. `seed` is that of random numbers.
        - `grid`: play a grid in the hull of the planned offsets, with this number of intervals along each of its edges.
        - `offsets`: play these (m, body frame), shape (K, 3).
        - `rotation_error`: also rotate the part in the gripper at random, by up to this angle about any axis (rad).
        - `magnitude`: magnitudes (m) to which the planned offsets are scaled; by default that of the plan.
        - `friction`: Coulomb friction coefficients.
        - `stages`: also play the reference of every homotopy step.
        - `settling_time`: how long the end of the reference is held before a rollout is judged (s).
        - `time_step`: time step of the simulation (s).
        """
        options: PlayOptions = {
            "random": random,
            "hull": hull,
            "disc": disc,
            "ball": ball,
            "seed": seed,
            "grid": grid,
            "offsets": None if offsets is None else _offsets(offsets),
            "rotation_error": rotation_error,
            "magnitude": _several(magnitude),
            "friction": _several(friction),
            "settling_time": settling_time,
            "time_step": time_step,
            "stages": stages,
            "position_tolerance": position_tolerance,
            "angle_tolerance": angle_tolerance,
            "jobs": jobs,
        }
        return Simulation(self._native.simulate(plan._native, options, _listener(progress)))

    def tolerance(
        self,
        plan: Plan,
        *,
        quantities: Iterable[str] = (),
        need: tuple[str, float] | None = None,
        map: tuple[str, str] | None = None,
        rows: Iterable[float] = (),
        target_rate: float = 0.99,
        friction: float | Iterable[float] | None = None,
        cases: int = 2000,
        seed: int = 1,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> dict[str, Any]:
        """Measure which errors a plan tolerates: the content of ``tolerance.json``.

        As the command ``tolerance`` with a plan, but without a map unless it is asked for:

        - `quantities`: ``offset``, ``rotation``, ``hole``, ``friction``, ``clearance``; by default all.
        - `need`: the smallest clearance at which this is tolerated, such as ``("offset", 0.002)``, in SI units.
        - `map`: the first quantity at several values of the second, such as ``("offset", "clearance")``; `rows` are
          these values, by default some around the scene's.
        - `target_rate`: share of the rollouts that has to succeed.
        - `friction`: Coulomb friction coefficients, which the rollouts have in turn; by default the scene's.
        - `cases`: largest number of random errors that are compared; `seed` is theirs.
        """
        options: ToleranceOptions = {
            "quantities": list(quantities),
            "need": need,
            "map": map,
            "rows": _several(rows),
            "target_rate": target_rate,
            "friction": None if friction is None else _several(friction),
            "cases": cases,
            "seed": seed,
            "position_tolerance": position_tolerance,
            "angle_tolerance": angle_tolerance,
            "jobs": jobs,
        }
        measured: dict[str, Any] = json.loads(self._native.tolerance(plan._native, options, _listener(progress)))
        return measured

    def __repr__(self) -> str:
        return f"<Scene {self.title!r}: {len(self._body)} and {len(self._environment)} parts>"


def _choices(
    *,
    start: str | int | None,
    delta: float | None,
    homotopy: Homotopy | None,
    linear_solver: str | None = None,
    position_tolerance: float | None = None,
    angle_tolerance: float | None = None,
    rotation_error: float | None = None,
) -> ChoiceOptions:
    """What is chosen of a scene, as the native module takes it."""
    file, content = (homotopy, None) if isinstance(homotopy, str | os.PathLike) else (None, homotopy)
    return {
        "start": None if start is None else str(start),
        "delta": delta,
        "rotation_error": rotation_error,
        "homotopy": file,
        "homotopy_json": None if content is None else _json(content),
        "linear_solver": linear_solver,
        "position_tolerance": position_tolerance,
        "angle_tolerance": angle_tolerance,
    }


def _several(values: float | Iterable[float]) -> list[float]:
    """A list of numbers, also of one that stands alone."""
    listed: Iterable[Any] = values if isinstance(values, Iterable) else [values]
    return [float(value) for value in listed]


def _parts(parts: list[dict[str, Any]]) -> list[Part]:
    return [
        Part(part["name"], _fixed(part["vertices"]), _fixed(part["normals"]), _fixed(part["offsets"])) for part in parts
    ]


def _fixed(values: ArrayLike) -> FloatArray:
    """An array that cannot be changed."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


def _vector(values: ArrayLike, count: int, name: str) -> list[float]:
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (count,):
        raise SceneError(f"{name}: has shape {array.shape}, must have shape ({count},)")
    return [float(value) for value in array]


def _offsets(values: ArrayLike) -> list[list[float]]:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3 or len(array) == 0 or not np.isfinite(array).all():
        raise SceneError(f"offsets: has shape {array.shape}, must be finite numbers of shape (K, 3), K at least 1")
    return [[float(value) for value in row] for row in array]


def _json(content: Any) -> str:
    """The JSON text of a dictionary with the keys of a TOML file."""
    if not isinstance(content, Mapping):
        raise SceneError(f"a {type(content).__name__} is no dictionary with the keys of a file")
    return json.dumps(_plain(content, ""))


def _plain(value: Any, path: str) -> Any:
    """A value as a file has it; `path` names its key in messages."""
    match value:
        case bool() | str():
            return value
        case Mapping():
            return {_key(key, path): _plain(entry, f"{path}.{key}".lstrip(".")) for key, entry in value.items()}
        case os.PathLike():
            return os.fspath(value)
        case np.ndarray() | np.generic():
            return _plain(value.tolist(), path)
        case int() | float():
            if value != value or value in (float("inf"), float("-inf")):
                raise SceneError(f"{path}: {value} must be a finite number")
            return value
        case Sequence():
            return [_plain(entry, f"{path}[{index}]") for index, entry in enumerate(value)]
        case None:
            raise SceneError(f"{path}: None is no value; leave the key out")
        case _:
            kind = type(value).__name__
            raise SceneError(f"{path}: a {kind} is no value of a file; use numbers, text, lists or dictionaries")


def _key(key: Any, path: str) -> str:
    if not isinstance(key, str):
        raise SceneError(f"{path or 'the dictionary'}: the key {key!r} is no text")
    return key
