"""Joint positions for a pose of the part."""

import mujoco
import numpy as np

from lab.errors import InputError
from lab.mujoco.rotations import rotation_vector

# Distance (m) and angle (rad) at which a pose is reached.
TOLERANCE = 1e-9
# Largest number of steps. Poses nearby take less than ten.
STEPS = 200
# Makes errors of position comparable to those of orientation (m).
CHARACTERISTIC_LENGTH = 0.5
# Damping when the pose is reached: bounds steps where the arm is singular.
LEAST_DAMPING = 1e-12


def configuration_at(model: mujoco.MjModel, pose: np.ndarray, near: np.ndarray) -> np.ndarray:
    """Joint positions (rad) with the site `grasp` at a pose, on the branch of `near`: damped Newton steps from there,
    the damping half of the squared error (Sugihara, 2011). A redundant arm takes the shortest steps."""
    data, site = mujoco.MjData(model), model.site("grasp").id
    data.qpos[:] = near
    (linear, angular), quaternion = np.zeros((2, 3, model.nv)), np.zeros(4)
    for _ in range(STEPS):
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mju_mat2Quat(quaternion, data.site_xmat[site])
        rotation = data.site_xmat[site].reshape(3, 3)
        shift, turn = pose[:3] - data.site_xpos[site], rotation_vector(quaternion, pose[3:])
        if np.linalg.norm(shift) < TOLERANCE and np.linalg.norm(turn) < TOLERANCE:
            check_limits(model, data.qpos)
            return data.qpos.copy()
        mujoco.mj_jacSite(model, data, linear, angular, site)
        jacobian = np.vstack([linear / CHARACTERISTIC_LENGTH, rotation.T @ angular])
        error = np.concatenate([shift / CHARACTERISTIC_LENGTH, turn])
        damping = 0.5 * error @ error + LEAST_DAMPING
        data.qpos += jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + damping * np.eye(6), error)
    raise InputError(
        f"the arm does not reach ({', '.join(f'{number:.3f}' for number in pose[:3])}) m: it stays "
        f"{np.linalg.norm(shift):.1e} m and {np.linalg.norm(turn):.1e} rad away; change base or "
        "configuration of [robot]"
    )


def check_limits(model: mujoco.MjModel, configuration: np.ndarray) -> None:
    """Refuses joint positions beyond limits."""
    low, high = model.jnt_range.T
    beyond = model.jnt_limited.astype(bool) & ((configuration < low) | (configuration > high))
    if beyond.any():
        joint = int(np.argmax(beyond))
        raise InputError(
            f"the arm reaches a pose only with {model.joint(joint).name} at {configuration[joint]:.3f}, beyond its "
            f"range of {low[joint]:.3f} to {high[joint]:.3f}; change base or configuration of [robot]"
        )
