"""Scenes: read, checked, solved, played."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any

from numpy.typing import ArrayLike

from assembly_plan import _values
from assembly_plan._arrays import read, table
from assembly_plan._renamed import renamed
from assembly_plan._types import (
    CalibrationOptions,
    PlayOptions,
    RobustOptions,
    RolloutOptions,
    SolveOptions,
    ToleranceOptions,
)
from assembly_plan._values import Homotopy, StrPath
from assembly_plan.contacts import Contacts
from assembly_plan.content import SceneContent
from assembly_plan.errors import SceneError
from assembly_plan.events import Progress, _listener
from assembly_plan.plan import Plan
from assembly_plan.reference import Reference
from assembly_plan.rollouts import Rollouts
from assembly_plan.simulation import Simulation


class Scene(SceneContent):
    """What is to be assembled: parts, start and goal poses, the robot's controller, the size of the grasp error.

    A scene is valid: `Scene.load` and `Scene.from_dict` check everything and raise `SceneError`. A pose has 7 numbers:
    position (m, world frame) and unit quaternion ``w x y z``.

    All methods have the names and defaults of the command line for what can be chosen:

    - `start`: name of the start pose, or the number that is its name; by default the scene's first.
    - `delta`: offset magnitude (m); by default the scene's.
    - `homotopy`: homotopy file, or a dictionary with the keys of one; by default the scene's own, else the built-in
      one.
    - `linear_solver`: ``stage``, ``mumps``, or ``ma27``, ``ma57``, ``ma97`` where the HSL library is installed; by
      default the homotopy's.
    - `position_tolerance` (m), `angle_tolerance` (rad): what counts as reaching the goal; by default the scene's.
    - `jobs`: threads, by default one per processor; they change nothing but the time it takes.
    - `progress`: a function that hears of `assembly_plan.events`.
    """

    def check(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        tau: float | None = None,
    ) -> dict[str, Any]:
        """Explain the scene without solving it, as the command ``check --json`` does.

        Returns parts, meshes and their convex parts, clearances, penetrations, size of the problem, warnings; keys name
        their units. `tau` smooths the distances, by default as the homotopy begins.
        """
        chosen = _values.choices(start=start, delta=delta, homotopy=homotopy)
        explanation: dict[str, Any] = json.loads(self._native.check(chosen, _values.optional(tau, "tau")))
        return explanation

    def distances(
        self,
        pose: ArrayLike,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        tau: float | None = None,
    ) -> list[dict[str, Any]]:
        """Report every pair's distances with the body at a pose, as the command ``check --pose --json`` does.

        `pose` has shape (7,); its quaternion is scaled to unit norm. An entry has ``body``, ``environment``,
        ``smoothed_distance_m``, ``exact_distance_m`` (negative where the parts penetrate) and ``normal``, the contact
        normal with 7 numbers.
        """
        chosen = _values.choices(start=start, delta=delta, homotopy=homotopy)
        values = _values.vector(pose, 7, "pose")
        pairs: list[dict[str, Any]] = json.loads(self._native.distances(chosen, values, _values.optional(tau, "tau")))
        return pairs

    def contacts(
        self,
        poses: ArrayLike,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        tau: float | None = None,
        derivatives: int = 0,
        points: bool = False,
    ) -> Contacts:
        """Distances and contact normals of every pair at many poses, with exact derivatives.

        `poses` has shape (K, 7), with quaternions of any norm. `derivatives` is their order, 0 to 2. With `points`,
        contact points are included. `tau` smooths the distances, by default as the homotopy begins.
        """
        if _values.whole(derivatives, "derivatives") > 2:
            raise SceneError(f"derivatives = {derivatives}: must be 0, 1 or 2")
        chosen = _values.choices(start=start, delta=delta, homotopy=homotopy)
        rows = table(poses, 7, "poses")
        data = self._native.contacts(chosen, rows.tobytes(), _values.optional(tau, "tau"), derivatives, bool(points))
        return Contacts(data, len(rows))

    def solve(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        linear_solver: str | None = None,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        guess: Plan | Reference | None = None,
        jobs: int | None = None,
        out: StrPath | None = None,
        resume: bool = False,
        progress: Progress | None = None,
    ) -> Plan:
        """Plan one motion that brings the body to its goal with every planned offset.

        `guess` is a plan or a reference: the homotopy starts from the motions that it leads to instead of from rest.
        Its first smoothing forgets most of a guess; ``homotopy={"homotopy": {"iterations": 1, "tau": ...}}`` with
        the smoothing of the guess keeps it.

        With `out`, the plan is written into this folder, and Ctrl-C leaves unfinished work beside it, with which
        ``resume=True`` resumes it. A plan that does not reach the goal is no error: see `Plan.status`.
        """
        chosen = _values.choices(
            start=start,
            delta=delta,
            homotopy=homotopy,
            linear_solver=linear_solver,
            position_tolerance=position_tolerance,
            angle_tolerance=angle_tolerance,
        )
        given = Reference.of(guess) if isinstance(guess, Plan) else guess
        options: SolveOptions = {
            "out": out,
            "resume": resume,
            "jobs": _values.threads(jobs),
            "guess": None if given is None else given._options(self),
        }
        return Plan(self._native.solve(chosen, options, None, _listener(progress)))

    @renamed(turn="rotation_error", wanted_rate="target_rate", patience="stall_limit")
    def solve_robust(
        self,
        *,
        start: str | int | None = None,
        delta: float | None = None,
        homotopy: Homotopy | None = None,
        linear_solver: str | None = None,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        target_rate: float = 0.99,
        time_limit: float = 300.0,
        stall_limit: int = 150,
        friction: float | Iterable[float] | None = None,
        rotation_error: float | None = None,
        from_: Plan | StrPath | None = None,
        jobs: int | None = None,
        out: StrPath | None = None,
        resume: bool = False,
        progress: Progress | None = None,
    ) -> Plan:
        """Plan one motion, and refine it until it succeeds with hard contacts at offsets that were not planned for.

        As the command ``solve --robust``:

        - `target_rate`: success rate to reach at each friction, from 0 to 1.
        - `time_limit`: end with the best plan so far after this time (s), everything included.
        - `stall_limit`: evaluate a plan again after this many perturbations in a row without improvement; 0 only
          evaluates it.
        - `friction`: Coulomb friction coefficients; by default the scene's.
        - `rotation_error`: the part may also be rotated in the gripper by up to this angle, about any axis (rad); by
          default the scene's.
        - `from_`: before anything is solved, try this plan, or that of a folder, moved to the start and the goal of the
          scene.

        `out` and `resume` are those of `solve`.
        """
        chosen = _values.choices(
            start=start,
            delta=delta,
            homotopy=homotopy,
            linear_solver=linear_solver,
            position_tolerance=position_tolerance,
            angle_tolerance=angle_tolerance,
            rotation_error=rotation_error,
        )
        options: SolveOptions = {"out": out, "resume": resume, "jobs": _values.threads(jobs), "guess": None}
        robust = _robust(target_rate, time_limit, stall_limit, friction)
        earlier = from_._native if isinstance(from_, Plan) else from_
        return Plan(self._native.solve(chosen, options, (robust, earlier), _listener(progress)))

    @renamed(turn="rotation_error")
    def simulate(
        self,
        plan: Plan | Reference,
        *,
        random: int | None = None,
        hull: bool = False,
        disc: bool = False,
        ball: bool = False,
        seed: int = 1,
        grid: int | None = None,
        offsets: ArrayLike | None = None,
        rotation_error: float = 0.0,
        magnitude: float | Iterable[float] = (),
        friction: float | Iterable[float] = (0.0,),
        stages: bool = False,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        settling_time: float = 1.0,
        time_step: float = 0.001,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> Simulation:
        """Play a plan or a reference of your own, and a straight push, with hard contacts and injected offsets.

        By default the planned offsets are played. As the command ``simulate``:

        - `random`: play this many random offsets of those that the scene covers, or with `hull` in the hull of the
          planned ones, with `disc` in the disc across the insertion, with `ball` in the ball; half of those of a disc
          or a ball lie on its rim. `seed` is that of random numbers.
        - `grid`: play a grid in the hull of the planned offsets, with this number of intervals along each of its edges.
        - `offsets`: play these (m, body frame), shape (K, 3).
        - `rotation_error`: also rotate the part in the gripper at random, by up to this angle about any axis (rad).
        - `magnitude`: magnitudes (m) to which the planned offsets are scaled; by default that of the plan.
        - `friction`: Coulomb friction coefficients.
        - `stages`: also play the reference of every homotopy step.
        - `settling_time`: how long the end of the reference is held before a rollout is judged (s).
        - `time_step`: time step of the simulation (s).
        """
        options: PlayOptions = {
            "random": None if random is None else _values.whole(random, "random"),
            "hull": hull,
            "disc": disc,
            "ball": ball,
            "seed": _values.whole(seed, "seed", 2**64 - 1),
            "grid": None if grid is None else _values.whole(grid, "grid"),
            "offsets": None if offsets is None else _values.vectors(offsets, "offsets"),
            "rotation_error": _values.number(rotation_error, "rotation_error"),
            "magnitude": _values.several(magnitude, "magnitude"),
            "friction": _values.several(friction, "friction"),
            "settling_time": _values.number(settling_time, "settling_time"),
            "time_step": _values.number(time_step, "time_step"),
            "stages": stages,
            "position_tolerance": _values.optional(position_tolerance, "position_tolerance"),
            "angle_tolerance": _values.optional(angle_tolerance, "angle_tolerance"),
            "jobs": _values.threads(jobs),
        }
        if isinstance(plan, Reference):
            return Simulation(self._native.simulate_reference(plan._options(self), options, _listener(progress)))
        return Simulation(self._native.simulate(plan._native, options, _listener(progress)))

    def rollouts(
        self,
        plan: Plan | Reference,
        *,
        offsets: ArrayLike | None = None,
        rotations: ArrayLike | None = None,
        friction: float = 0.0,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        settling_time: float = 1.0,
        time_step: float = 0.001,
    ) -> Rollouts:
        """Play a plan or a reference of your own with hard contact and keep whole trajectories, forces and contacts.

        - `offsets`: of the part in the gripper (m, body frame), shape (S, 3); by default the planned ones.
        - `rotations`: of the part in the gripper (rotation vectors, rad), shape (S, 3); by default none.

        The others are those of `simulate`.
        """
        reference = plan if isinstance(plan, Reference) else Reference.of(plan)
        options: RolloutOptions = {
            "grasps": _values.grasps(offsets, rotations),
            "friction": _values.number(friction, "friction"),
            "settling_time": _values.number(settling_time, "settling_time"),
            "time_step": _values.number(time_step, "time_step"),
            "position_tolerance": _values.optional(position_tolerance, "position_tolerance"),
            "angle_tolerance": _values.optional(angle_tolerance, "angle_tolerance"),
        }
        return Rollouts(self._native.rollouts(reference._options(self), options))

    def refine(
        self,
        plan: Plan | Reference,
        *,
        target_rate: float = 0.99,
        time_limit: float = 300.0,
        stall_limit: int = 150,
        friction: float | Iterable[float] | None = None,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> tuple[Reference, dict[str, Any]]:
        """Refine a reference of your own by rollouts with hard contact, without solving anything.

        Returns the refined reference and a report, which has the keys of ``robust`` in `Plan.result`. The arguments are
        those of `solve_robust`.
        """
        reference = plan if isinstance(plan, Reference) else Reference.of(plan)
        robust = _robust(target_rate, time_limit, stall_limit, friction)
        options, listener = reference._options(self), _listener(progress)
        states, report = self._native.refine(options, robust, _values.threads(jobs), listener)
        refined = Reference(read(states, -1, 13), options["time_step"], start=reference.start, delta=reference.delta)
        return refined, json.loads(report)

    def calibrate(
        self,
        logs: StrPath | Iterable[StrPath],
        *,
        per_joint: bool = False,
        out: StrPath | None = None,
        force: bool = False,
        jobs: int | None = None,
    ) -> dict[str, Any]:
        """Fit the robot of the scene to logs of players, as the command ``calibrate --json`` does.

        ``entries`` of the result are the tables and keys that the scene should have. With `out`, a copy of the scene's
        file with them is written, in the place of an older one with `force`. `per_joint` fits inertia and friction of
        each joint.
        """
        several = [logs] if isinstance(logs, str | os.PathLike) else list(logs)
        options: CalibrationOptions = {
            "logs": several,
            "out": out,
            "force": force,
            "per_joint": per_joint,
            "jobs": _values.threads(jobs),
        }
        fitted: dict[str, Any] = json.loads(self._native.calibrate(options))
        return fitted

    def tolerance(
        self,
        plan: Plan,
        *,
        quantities: Iterable[str] = (),
        need: tuple[str, float] | None = None,
        by: str = "clearance",
        map: tuple[str, str] | None = None,
        rows: Iterable[float] = (),
        target_rate: float = 0.99,
        friction: float | Iterable[float] | None = None,
        cases: int = 2000,
        seed: int = 1,
        position_tolerance: float | None = None,
        angle_tolerance: float | None = None,
        jobs: int | None = None,
        progress: Progress | None = None,
    ) -> dict[str, Any]:
        """Measure which errors a plan tolerates: the content of ``tolerance.json``.

        As the command ``tolerance`` with a plan, but without a map unless it is asked for:

        - `quantities`: ``offset``, ``rotation``, ``hole``, ``friction``, ``clearance``, ``chamfer``; by default all but
          the last.
        - `need`: the smallest clearance, or with `by` the smallest ``chamfer`` at the mouth of the hole, at which this
          is tolerated, such as ``("offset", 0.002)``, in SI units.
        - `map`: the first quantity at several values of the second, such as ``("offset", "clearance")``; `rows` are
          these values, by default some around the scene's.
        - `target_rate`: success rate that the rollouts must reach.
        - `friction`: Coulomb friction coefficients, which the rollouts have in turn; by default the scene's.
        - `cases`: largest number of random errors that are compared; `seed` is theirs.
        """
        options: ToleranceOptions = {
            "quantities": list(quantities),
            "need": need,
            "by": by,
            "map": map,
            "rows": _values.several(rows, "rows"),
            "target_rate": _values.number(target_rate, "target_rate"),
            "friction": None if friction is None else _values.several(friction, "friction"),
            "cases": _values.whole(cases, "cases"),
            "seed": _values.whole(seed, "seed", 2**64 - 1),
            "position_tolerance": _values.optional(position_tolerance, "position_tolerance"),
            "angle_tolerance": _values.optional(angle_tolerance, "angle_tolerance"),
            "jobs": _values.threads(jobs),
        }
        measured: dict[str, Any] = json.loads(self._native.tolerance(plan._native, options, _listener(progress)))
        return measured

    def __repr__(self) -> str:
        return f"<Scene {self.title!r}: {len(self._body)} and {len(self._environment)} parts>"


def _robust(
    target_rate: float,
    time_limit: float,
    stall_limit: int,
    friction: float | Iterable[float] | None,
) -> RobustOptions:
    return {
        "target_rate": _values.number(target_rate, "target_rate"),
        "time_limit": _values.number(time_limit, "time_limit"),
        "stall_limit": _values.whole(stall_limit, "stall_limit", 2**32 - 1),
        "friction": None if friction is None else _values.several(friction, "friction"),
    }
