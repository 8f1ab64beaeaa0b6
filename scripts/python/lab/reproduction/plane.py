"""The paper's example in the plane: smoothed distance, gradient and approximate normal of a point and a rectangle.

`min alpha` subject to `G rho <= h + alpha 1`: with the point given, the conditions of Eq. KKTsystem are one scalar
equation, `sum_i tau / (h_i + alpha - g_i rho) = 1`.
"""

import dataclasses

import numpy as np

NORMALS = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
HALF_WIDTH, HALF_HEIGHT = 1.0, 0.5
OFFSETS = np.array([HALF_WIDTH, HALF_WIDTH, HALF_HEIGHT, HALF_HEIGHT])
# Halvings of an interval that is as long as all distances together: to rounding.
HALVINGS = 60


@dataclasses.dataclass
class Field:
    """Smoothed distance, its gradient and the approximate normal at many points; vectors in the last axis."""

    distance: np.ndarray
    gradient: np.ndarray
    normal: np.ndarray


def exact(points: np.ndarray) -> np.ndarray:
    """Distance without smoothing."""
    return (points @ NORMALS.T - OFFSETS).max(axis=-1)


def smoothed(points: np.ndarray, tau: float) -> Field:
    """Everything for one tau. The duals sum to one, so alpha lies between the exact distance plus tau and plus n_g
    tau."""
    excess = points @ NORMALS.T - OFFSETS
    low = excess.max(axis=-1) + tau
    high = low + (len(OFFSETS) - 1) * tau
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        is_low = (tau / (middle[..., None] - excess)).sum(axis=-1) > 1
        low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
    duals = tau / (high[..., None] - excess)
    weights = duals**2 / (duals**2).sum(axis=-1, keepdims=True)
    return Field(high, weights @ NORMALS, duals @ NORMALS)


def euclidean(points: np.ndarray) -> np.ndarray:
    """Signed Euclidean distance."""
    beside = np.abs(points) - (HALF_WIDTH, HALF_HEIGHT)
    return np.hypot(*np.maximum(beside, 0).T).T + np.minimum(beside.max(axis=-1), 0)


def scaling(points: np.ndarray) -> np.ndarray:
    """The growth distance of earlier work: by how much more than one the rectangle must be scaled."""
    return (np.abs(points) / (HALF_WIDTH, HALF_HEIGHT)).max(axis=-1) - 1
