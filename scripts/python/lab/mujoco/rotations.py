"""Rotations as unit quaternions (w, x, y, z), matrices and vectors."""

import mujoco
import numpy as np


def rotation_matrix(quaternion: np.ndarray) -> np.ndarray:
    """Rotation matrix of a unit quaternion (w, x, y, z)."""
    # Plain numbers: those of numpy take several times longer.
    w, x, y, z = np.asarray(quaternion).tolist()
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )


def slerp(before: np.ndarray, after: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Spherical interpolation of unit quaternions (n x 4), the short way round."""
    cosine = np.sum(before * after, axis=1)
    after = np.where(cosine[:, None] < 0, -after, after)
    angle = np.arccos(np.clip(np.abs(cosine), 0.0, 1.0))
    sine = np.sin(angle)
    # For small angles the weights tend to those of linear interpolation.
    small = sine < 1e-9
    divisor = np.where(small, 1.0, sine)
    first = np.where(small, 1 - share, np.sin((1 - share) * angle) / divisor)
    second = np.where(small, share, np.sin(share * angle) / divisor)
    mixed = first[:, None] * before + second[:, None] * after
    return mixed / np.linalg.norm(mixed, axis=1, keepdims=True)


def rotation_vector(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Rotation from one unit quaternion to another, in the frame of either (they share its axis): axis x angle."""
    w, vector = start[0] * end[0] + start[1:] @ end[1:], start[0] * end[1:] - end[0] * start[1:]
    vector = vector - np.cross(start[1:], end[1:])
    if w < 0:
        w, vector = -w, -vector
    norm = np.linalg.norm(vector)
    return np.zeros(3) if norm < 1e-12 else 2 * np.arctan2(norm, w) * vector / norm


def quaternion_of(turn: np.ndarray) -> np.ndarray:
    """The quaternion of a rotation vector (rad)."""
    quaternion, angle = np.array([1.0, 0.0, 0.0, 0.0]), np.linalg.norm(turn)
    if angle:
        mujoco.mju_axisAngle2Quat(quaternion, turn / angle, angle)
    return quaternion


def product(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The product of two quaternions w x y z."""
    result = np.zeros(4)
    mujoco.mju_mulQuat(result, one, other)
    return result
