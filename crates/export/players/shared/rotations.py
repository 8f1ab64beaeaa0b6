"""Rotations: unit quaternions (w x y z), rotation matrices and rotation vectors (rad)."""

import numpy as np


def matrix(quaternion: np.ndarray) -> np.ndarray:
    """Rotation matrix of a unit quaternion."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def vector(rotation: np.ndarray) -> np.ndarray:
    """Rotation vector of a rotation matrix: axis times angle, at most pi."""
    skew = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])
    sine, cosine = np.linalg.norm(skew) / 2, (np.trace(rotation) - 1) / 2
    if sine > 1e-6:
        return np.arctan2(sine, cosine) * skew / (2 * sine)
    if cosine > 0:
        return skew / 2
    # Half a turn: the axis is that of the largest column of (R + 1) / 2.
    columns = (rotation + np.eye(3)) / 2
    axis = columns[:, np.argmax(np.diag(columns))]
    return np.pi * axis / np.linalg.norm(axis)


def of_vector(turn: np.ndarray) -> np.ndarray:
    """Rotation matrix of a rotation vector."""
    angle = np.linalg.norm(turn)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = turn / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def quaternion(rotation: np.ndarray, near: np.ndarray | None = None) -> np.ndarray:
    """Unit quaternion of a rotation matrix: of both the one that is nearer to another one, else the one whose scalar is not
    negative."""
    turn = vector(rotation)
    angle = np.linalg.norm(turn)
    # sin(a / 2) / a, which tends to one half.
    share = 0.5 if angle < 1e-9 else np.sin(angle / 2) / angle
    found = np.array([np.cos(angle / 2), *(share * turn)])
    return -found if near is not None and found @ near < 0 else found
