"""The same motion in MuJoCo and in another simulator."""

import pathlib

import numpy as np

import plans
from plans import InputError, rotation_vector
from results import Tolerance


def read(path: pathlib.Path) -> np.ndarray:
    """Rows of time and state, at least two, in a file with the columns of `reference.csv`."""
    try:
        motion = plans.read_reference(path)
    except (OSError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"--compare {path}: no motion with the columns of reference.csv: {error}") from error
    return np.column_stack([motion.times, motion.states])


def report(ours: np.ndarray, other: np.ndarray, tolerance: Tolerance) -> bool:
    """Prints how far apart two motions are, at the times of `other` that both have, and whether they end together."""
    shared = other[(ours[0, 0] <= other[:, 0]) & (other[:, 0] <= ours[-1, 0] + 1e-9)]
    if not len(shared):
        raise InputError("the motions have no time in common")
    positions = np.column_stack([np.interp(shared[:, 0], ours[:, 0], ours[:, column]) for column in range(1, 4)])
    distances = np.linalg.norm(positions - shared[:, 1:4], axis=1)
    # Steps are so short that the nearest orientation will do.
    nearest = np.abs(ours[:, :1] - shared[:, 0]).argmin(axis=0)
    turns = [rotation_vector(ours[row, 4:8], state) for row, state in zip(nearest, shared[:, 4:8])]
    angles = np.linalg.norm(turns, axis=1)
    for name, index in (("furthest apart", distances.argmax()), ("at the end", -1)):
        print(
            f"{name}, at {shared[index, 0]:.3f} s: {1e3 * distances[index]:.3f} mm and {angles[index]:.4f} rad "
            f"from {1e3 * shared[index, 1]:.2f} {1e3 * shared[index, 2]:.2f} {1e3 * shared[index, 3]:.2f} mm"
        )
    return bool(distances[-1] <= tolerance.position and angles[-1] <= tolerance.angle)
