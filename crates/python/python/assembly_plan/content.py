"""What a scene contains."""

from __future__ import annotations

import copy
import json
import os
import tempfile
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from assembly_plan import _planner
from assembly_plan._arrays import FloatArray, fixed
from assembly_plan._meshes import with_files
from assembly_plan._values import StrPath, json_of
from assembly_plan.arm import Arm
from assembly_plan.errors import SceneError


@dataclass(frozen=True, eq=False)
class Part:
    """A convex part: the points x with ``normals @ x <= offsets``. The arrays are read-only.

    - `name`: unique among the parts of the body or the environment.
    - `vertices`: corners (m), shape (V, 3), in the frame of the body, or of the world for the environment.
    - `normals`: unit normals of the facets that point outwards, shape (F, 3), in the same frame.
    - `offsets`: distances of the facets from the origin of this frame (m), shape (F,).
    """

    name: str
    vertices: FloatArray
    normals: FloatArray
    offsets: FloatArray

    def __repr__(self) -> str:
        return f"<Part {self.name!r}: {len(self.vertices)} corners, {len(self.offsets)} facets>"


@dataclass(frozen=True, eq=False)
class Impedance:
    """Gains of a Cartesian impedance controller. The arrays are read-only.

    - `translational_stiffness` (N/m), `rotational_stiffness` (Nm/rad).
    - `translational_damping` (Ns/m, world frame), `rotational_damping` (Nms/rad, body frame): shape (3, 3).
    """

    translational_stiffness: float
    rotational_stiffness: float
    translational_damping: FloatArray
    rotational_damping: FloatArray


class SceneContent:
    """The content of a `Scene`, which never changes; arrays are read-only."""

    def __init__(self, native: _planner.Scene) -> None:
        """Not to be called; `Scene.load` and `Scene.from_dict` make scenes."""
        self._native = native
        content = json.loads(native.content())
        self._title: str = content["title"]
        self._starts = {start["name"]: fixed(start["pose"]) for start in content["starts"]}
        self._goal = fixed(content["goal"])
        self._offset_magnitude: float = content["offset_magnitude"]
        self._time_step: float = content["time_step"]
        self._impedance = Impedance(**{key: _gain(value) for key, value in content["impedance"].items()})
        self._body, self._environment = _parts(content["body"]), _parts(content["environment"])

    @classmethod
    def load(cls, file: StrPath) -> Self:
        """Read a scene file (TOML) and the files it names."""
        return cls(_planner.Scene.load(file))

    @classmethod
    def from_dict(cls, content: Mapping[str, Any], base: StrPath = ".") -> Self:
        """Make a scene of a dictionary with the keys of a scene file; arrays and tuples may stand for lists.

        Names of files in it are relative to the folder `base`. Instead of a file, the ``mesh`` of a part may be a
        dictionary: ``vertices`` of shape (V, 3), in the ``unit`` of the part or in metres, and ``faces``, the corners
        of triangles counted from 0, of shape (F, 3). Messages show the lines of the scene file that would have the same
        content, and call it ``scene``.
        """
        if not isinstance(content, Mapping):
            raise SceneError(f"a {type(content).__name__} is no dictionary with the keys of a file")
        with tempfile.TemporaryDirectory() as folder:
            text = json_of(with_files(content, Path(folder)))
            try:
                return cls(_planner.Scene.from_json(text, Path(base) / "scene"))
            except SceneError as error:
                raise SceneError(str(error).replace(f"{folder}{os.sep}", "")) from None

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

    def replace(self, **changes: Any) -> Self:
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
        return type(self).from_dict(content)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).from_dict, (self.to_dict(),)

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == other.to_dict() if isinstance(other, SceneContent) else NotImplemented

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
    def time_step(self) -> float:
        """Time between two knots of a plan (s)."""
        return self._time_step

    @property
    def impedance(self) -> Impedance:
        """Gains of the controller."""
        return self._impedance

    @property
    def arm(self) -> Arm | None:
        """The arm that holds the body, if the scene has one."""
        native = self._native.arm()
        return None if native is None else Arm(native)

    @property
    def body(self) -> list[Part]:
        """Convex parts of the moved body."""
        return list(self._body)

    @property
    def environment(self) -> list[Part]:
        """Convex parts of what does not move."""
        return list(self._environment)


def _gain(value: Any) -> Any:
    return fixed(value) if isinstance(value, list) else value


def _parts(parts: list[dict[str, Any]]) -> list[Part]:
    return [
        Part(part["name"], fixed(part["vertices"]), fixed(part["normals"]), fixed(part["offsets"])) for part in parts
    ]
