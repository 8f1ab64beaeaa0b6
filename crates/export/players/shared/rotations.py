"""Rotations: unit quaternions (w x y z), rotation matrices and rotation vectors (rad). A control period has many of them, and
arithmetic of so few numbers is faster without arrays."""

import math

import numpy as np


def cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Cross product of two vectors."""
    (a, b, c), (x, y, z) = first.tolist(), second.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def matrix(quaternion: np.ndarray) -> np.ndarray:
    """Rotation matrix of a unit quaternion."""
    w, x, y, z = quaternion.tolist()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def vector(rotation: np.ndarray) -> np.ndarray:
    """Rotation vector of a rotation matrix: axis times angle, at most pi."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation.tolist()
    skew = np.array([zy - yz, xz - zx, yx - xy])
    sine, cosine = math.sqrt(skew @ skew) / 2, (xx + yy + zz - 1) / 2
    if sine > 1e-6:
        return np.arctan2(sine, cosine) * skew / (2 * sine)
    if cosine > 0:
        return skew / 2
    # Half a turn: the axis is that of the largest column of (R + 1) / 2.
    columns = (rotation + np.eye(3)) / 2
    axis = columns[:, np.argmax(np.diag(columns))]
    return np.pi * axis / np.linalg.norm(axis)


def sine(rotation: np.ndarray) -> np.ndarray:
    """The axis of a rotation times the sine of its angle: 2 eta eps of its quaternion."""
    return np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]) / 2


def of_vector(turn: np.ndarray) -> np.ndarray:
    """Rotation matrix of a rotation vector."""
    angle = math.sqrt(turn @ turn)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = (turn / angle).tolist()
    # Unlike those of `math`, these take infinity.
    sine, cosine = float(np.sin(angle)), float(np.cos(angle))
    share = 1 - cosine
    return np.array(
        [
            [cosine + share * x * x, share * x * y - sine * z, share * x * z + sine * y],
            [share * x * y + sine * z, cosine + share * y * y, share * y * z - sine * x],
            [share * x * z - sine * y, share * y * z + sine * x, cosine + share * z * z],
        ]
    )


def quaternion(rotation: np.ndarray, near: np.ndarray | None = None) -> np.ndarray:
    """Unit quaternion of a rotation matrix: of both the one that is nearer to another one, else the one whose scalar is not
    negative."""
    turn = vector(rotation)
    angle = math.sqrt(turn @ turn)
    # sin(a / 2) / a, which tends to one half.
    share = 0.5 if angle < 1e-9 else np.sin(angle / 2) / angle
    found = np.array([np.cos(angle / 2), *(share * turn)])
    return -found if near is not None and found @ near < 0 else found
