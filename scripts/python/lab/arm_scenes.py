"""Scenes for arms."""

import pathlib
import re
import tomllib

from lab import toml
from lab.errors import InputError

# Largest force of a contact (N).
LARGEST_FORCE = 60.0
# What the arm replaces in a scene: the inertia of a free body, and the gains, which are chosen for the arm.
REPLACED = re.compile(r"(mass|inertia|(translational|rotational)_(stiffness|damping))\s*=")


def robot_of(file: pathlib.Path) -> dict:
    """The [robot] table of a file, its URDF as an absolute path."""
    try:
        table = tomllib.loads(file.read_text())["robot"]
        return table | {"urdf": str((file.parent / table["urdf"]).resolve())}
    except (OSError, KeyError, ValueError) as error:
        raise InputError(f"{file}: no TOML file with a [robot] table that names its urdf: {error}") from error


def with_robot(scene: str, robot: dict) -> str:
    """The text of a scene for a robot instead of a free body, which may push with a limited force."""
    kept = [line for line in scene.splitlines() if not REPLACED.match(line)]
    return "\n".join(kept) + "\n" + toml.text({"limits": {"contact_force": LARGEST_FORCE}, "robot": robot})
