"""Scenes that are the shipped peg1 with another number of steps, scenarios or pairs."""

import copy
import math
import pathlib
import tomllib

# The scene's own numbers, which a series keeps but for the one that it changes.
STEPS, SCENARIOS, PAIRS = 100, 3, 6


def load(file: pathlib.Path) -> dict:
    """A scene, which is solved with the default homotopy."""
    return tomllib.loads(file.read_text())


def with_steps(scene: dict, steps: int) -> dict:
    """The same duration in another number of steps. Weights of velocities count in every step: they are scaled so that
    a motion costs the same."""
    changed = copy.deepcopy(scene)
    horizon = changed["horizon"]
    scale = horizon["steps"] / steps
    horizon["steps"] = steps
    horizon["time_step"] *= scale
    for weights in changed["cost"].values():
        weights |= {key: weight * scale for key, weight in weights.items() if key.endswith("_velocity")}
    return changed


def with_scenarios(scene: dict, scenarios: int) -> dict:
    """Offsets of the scene's magnitude to all sides of the hole, evenly around it."""
    changed = copy.deepcopy(scene)
    angles = [math.pi / 2 + 2 * math.pi * index / scenarios for index in range(scenarios)]
    changed["robustness"]["offset_directions"] = [[math.cos(angle), math.sin(angle), 0.0] for angle in angles]
    return changed


def with_pairs(scene: dict, pairs: int) -> dict:
    """Every wall cut into equal pieces side by side or, for up to as many pairs as walls, only some that may be
    touched."""
    changed = copy.deepcopy(scene)
    walls = changed["environment"]["part"]
    if pairs <= len(walls):
        shaft = changed["body"]["part"][0]["name"]
        touched = walls[:: len(walls) // pairs]
        changed["contact"] = {"pairs": [[shaft, wall["name"]] for wall in touched]}
    else:
        count = pairs // len(walls)
        changed["environment"]["part"] = [piece for wall in walls for piece in pieces(wall, count)]
    return changed


def pieces(wall: dict, count: int) -> list[dict]:
    """A wall of eight corners, four below and four above them, cut across its long side."""
    corners = wall["vertices"]

    def at(share: float) -> list[list[float]]:
        """Corners of the cut, from the inner to the outer side, below and above."""
        ends = [(corners[near], corners[far]) for near, far in ((0, 3), (1, 2), (4, 7), (5, 6))]
        return [[p + share * (q - p) for p, q in zip(near, far)] for near, far in ends]

    return [
        {"name": f"{wall['name']}.{index}", "vertices": at(index / count) + at((index + 1) / count)}
        for index in range(count)
    ]
