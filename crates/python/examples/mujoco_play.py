"""Play a plan in MuJoCo: the body, pulled by the impedance controller, with every planned offset in the gripper.

    python mujoco_play.py scenes/corner.toml out/corner

Needs mujoco. `--view` opens a window for the first offset.
"""

import argparse
import time
import tomllib
from pathlib import Path

import assembly_plan
import mujoco
import mujoco.viewer
import numpy as np
from assembly_plan import FloatArray

TIME_STEP = 0.001
# The reference is held at its end before the outcome is measured (s).
SETTLING_TIME = 1.0
# Contacts that give way by hundredths of a millimetre; MuJoCo's own let parts sink in deeper than many clearances.
SOLREF, SOLIMP = [0.004, 1.0], [0.95, 0.99, 0.0001, 0.5, 2.0]


def main() -> None:
    """Play all offsets and tell how far from the goal each ends."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("plan", type=Path, help="folder of the plan")
    parser.add_argument("--friction", type=float, default=0.0)
    parser.add_argument("--view", action="store_true")
    arguments = parser.parse_args()
    scene, plan = assembly_plan.Scene.load(arguments.scene), assembly_plan.Plan.load(arguments.plan)
    player = Player(scene, plan, arguments.friction)
    if arguments.view:
        player.view(plan.offsets[0])
        return
    for offset in plan.offsets:
        error = player.play(offset)
        print(f"offset {1e3 * offset} mm: ends {1e3 * error:.2f} mm from the goal")


def model_of(scene: assembly_plan.Scene, mass: float, inertia: FloatArray, friction: float) -> mujoco.MjModel:
    """Return a free body and a fixed environment, of the scene's convex parts."""
    spec = mujoco.MjSpec()
    spec.option.timestep = TIME_STEP
    spec.option.gravity = [0.0, 0.0, 0.0]
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    body = spec.worldbody.add_body(name="body", explicitinertial=True, mass=mass, ipos=[0.0, 0.0, 0.0])
    body.fullinertia = [*np.diag(inertia), inertia[0, 1], inertia[0, 2], inertia[1, 2]]
    body.add_freejoint()
    for parent, parts in ((body, scene.body), (spec.worldbody, scene.environment)):
        for part in parts:
            name = f"{parent.name}/{part.name}"
            spec.add_mesh(
                name=name, uservert=part.vertices.flatten(), inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
            )
            parent.add_geom(name=name, type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, contype=0, conaffinity=0)
    for part in scene.body:
        for other in scene.environment:
            names = {"geomname1": f"body/{part.name}", "geomname2": f"world/{other.name}"}
            pair = spec.add_pair(**names, solref=SOLREF, solimp=SOLIMP, condim=3 if friction > 0 else 1)
            pair.friction[:2] = friction
    return spec.compile()


class Player:
    """A plan in MuJoCo, tracked by the impedance controller of its scene."""

    def __init__(self, scene: assembly_plan.Scene, plan: assembly_plan.Plan, friction: float) -> None:
        """Build the model."""
        resolved = tomllib.loads(plan.resolved)
        body, impedance = resolved["body"], resolved["impedance"]
        inertia = np.array(body["inertia"], dtype=float)
        self.model = model_of(scene, body["mass"], inertia if inertia.ndim == 2 else np.diag(inertia), friction)
        self.data = mujoco.MjData(self.model)
        self.stiffness = impedance["translational_stiffness"], impedance["rotational_stiffness"]
        self.damping = matrix(impedance["translational_damping"]), matrix(impedance["rotational_damping"])
        self.plan, self.goal = plan, scene.goal

    def play(self, offset: FloatArray) -> float:
        """Play the plan with an offset (m, body frame); the final distance from the goal (m)."""
        self.begin(offset)
        while self.data.time < self.plan.time[-1] + SETTLING_TIME:
            self.advance(offset)
        return float(np.linalg.norm(self.data.qpos[:3] - self.goal[:3]))

    def view(self, offset: FloatArray) -> None:
        """Play the plan again and again in a window, in real time."""
        with mujoco.viewer.launch_passive(self.model, self.data) as viewer:
            while viewer.is_running():
                self.begin(offset)
                begin = time.monotonic()
                while viewer.is_running() and self.data.time < self.plan.time[-1] + SETTLING_TIME:
                    self.advance(offset)
                    viewer.sync()
                    time.sleep(max(0.0, begin + self.data.time - time.monotonic()))

    def begin(self, offset: FloatArray) -> None:
        """Put the body where it is when the robot believes it at the start."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:] = self.plan.reference[0, :7]
        self.data.qpos[:3] -= rotated(self.data.qpos[3:], offset)

    def advance(self, offset: FloatArray) -> None:
        """Apply the controller's wrench for one time step."""
        position, orientation = self.data.qpos[:3] + rotated(self.data.qpos[3:], offset), self.data.qpos[3:]
        reference = self.at(self.data.time)
        conjugate, turn = np.empty(4), np.empty(4)
        mujoco.mju_negQuat(conjugate, orientation)
        mujoco.mju_mulQuat(turn, conjugate, reference[3:7])
        lag = reference[7:] - self.data.qvel
        self.data.qfrc_applied[:3] = self.stiffness[0] * (reference[:3] - position) + self.damping[0] @ lag[:3]
        self.data.qfrc_applied[3:] = 2 * self.stiffness[1] * turn[0] * turn[1:] + self.damping[1] @ lag[3:]
        mujoco.mj_step(self.model, self.data)

    def at(self, seconds: float) -> FloatArray:
        """Return the reference between two knots, where it is interpolated; after the end it rests."""
        step, rest = divmod(seconds / self.plan.time_step, 1.0)
        last = len(self.plan.time) - 1
        if step >= last:
            return np.concatenate([self.plan.reference[-1, :7], np.zeros(6)])
        before, after = self.plan.reference[int(step)], self.plan.reference[int(step) + 1]
        state = (1 - rest) * before + rest * after
        state[3:7] /= np.linalg.norm(state[3:7])
        return np.asarray(state)


def matrix(damping: float | list[float] | list[list[float]]) -> FloatArray:
    """Return a damping as a matrix: a scene may give a number, one per axis or a matrix."""
    values = np.array(damping, dtype=float)
    return values if values.ndim == 2 else np.diag(np.broadcast_to(values, 3))


def rotated(orientation: FloatArray, vector: FloatArray) -> FloatArray:
    """Rotate a vector from the body's frame to the world's."""
    result = np.empty(3)
    mujoco.mju_rotVecQuat(result, vector, orientation)
    return result


if __name__ == "__main__":
    main()
