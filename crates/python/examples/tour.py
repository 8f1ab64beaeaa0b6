"""Use everything that the package has, once.

    python tour.py scenes/corner.toml out/tour

Writes its files into the folder; needs matplotlib. `--logs` are those of a player of an export: the scene's robot is
fitted to them.
"""

import argparse
import copy
import pickle
from pathlib import Path

import assembly_plan
import numpy as np
from assembly_plan import Plan, Reference, Scene, events


def main() -> None:
    """Go through all sections of docs/reference/python.md."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--logs", type=Path, nargs="*", default=[])
    arguments = parser.parse_args()
    out: Path = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    print(f"assembly_plan {assembly_plan.__version__}")

    scene = Scene.load(arguments.scene)
    look(scene)
    plan = solved(scene, out)
    geometry(scene, plan)
    played(scene, plan, out)
    robust = refined(scene, plan)
    written(scene, robust, out)
    if arguments.logs:
        print(scene.calibrate(arguments.logs)["entries"])


def look(scene: Scene) -> None:
    """Print what a scene is."""
    print(f"{scene.title}: starts {', '.join(scene.starts)}, goal {scene.goal}, steps of {scene.time_step} s")
    print(f"offsets of up to {scene.offset_magnitude} m, damping {np.diag(scene.impedance.translational_damping)}")
    for part in [*scene.body, *scene.environment]:
        print(f"  {part.name}: {len(part.vertices)} vertices")
    report = scene.check(start=next(iter(scene.starts)))
    print(f"  {report['pairs']} pairs")
    smaller = scene.replace(robustness__offset_magnitude=0.5 * scene.offset_magnitude)
    assert smaller != scene and Scene.from_dict(scene.to_dict()) == scene
    assert copy.copy(scene) == scene and pickle.loads(pickle.dumps(smaller)) == smaller


def solved(scene: Scene, out: Path) -> Plan:
    """Solve, with progress, and once more from a guess."""

    def show(event: events.Event) -> None:
        if isinstance(event, events.HomotopyStep):
            print(f"homotopy step {event.number}: {event.record['status']}")

    plan = scene.solve(progress=show, jobs=2, out=out / "plan")
    print(f"{plan.status}; {len(plan.stages)} homotopy steps, offsets {1e3 * plan.offsets} mm, turns {plan.turns}")
    print(f"multipliers of {len(plan.constraints['multiplier'])} constraints; reference {plan.reference.shape}")
    print(f"states {plan.states.shape}, wrenches {plan.wrenches.shape}, forces {plan.forces.shape} of {plan.pairs}")
    assert Plan.load(out / "plan") == plan and plan.distances.shape == plan.forces.shape
    print(f"the cost changes by {plan.sensitivities()['offset 1 x']:.3f} per metre of the first offset")
    guessed = scene.solve(guess=plan, homotopy={"homotopy": {"iterations": 1, "coarse_iterations": 0}})
    print(f"from a guess: {guessed.result['iterations']} iterations")
    return plan


def geometry(scene: Scene, plan: Plan) -> None:
    """Distances, normals, derivatives, and the arm if there is one."""
    for pair in scene.distances(scene.goal):
        print(f"{pair['body']} and {pair['environment']}: {1e3 * pair['exact_distance_m']:.2f} mm at the goal")
    contacts = scene.contacts(plan.states[0, :, :7], derivatives=2, points=True)
    print(f"{contacts.distance.shape}, {contacts.normal.shape}, {contacts.point.shape}, {contacts.values.shape}")
    assert contacts.jacobian is not None and contacts.hessian is not None
    arm = scene.arm
    if arm is not None:
        at = arm.inverse_kinematics(scene.goal, near=arm.configuration)
        print(f"limits {arm.position_limits}, {arm.speed_limits}, {arm.torque_limits}")
        print(f"{arm.joints} at {at}: {arm.pose(at)}, {arm.jacobian(at).shape}, {arm.mass_matrix(at).shape}")
        print(f"apparent inertia {arm.apparent_inertia(at)}, positions {arm.course(plan).positions.shape}")


def played(scene: Scene, plan: Plan, out: Path) -> None:
    """Play the plan, and a reference of our own."""
    simulation = scene.simulate(plan, random=10, friction=[0.0, 0.1], rotation_error=0.01)
    simulation.save(out / "simulation")
    push = simulation.rate("straight push")
    print(f"plan {simulation.rate():.0%}, push {push:.0%}, {len(simulation.successes['friction'])} groups")
    assert len(simulation.rollouts["success"]) > 0
    own = Reference.of(plan)
    lower = own.states[:, :7].copy()
    lower[:, 2] -= 0.001
    reference = Reference(lower, own.time_step, start=own.start, delta=own.delta)
    rollouts = scene.rollouts(reference, friction=0.1)
    print(f"{rollouts.success}, ends {1e3 * rollouts.position_errors} mm and {rollouts.orientation_errors} rad off")
    print(f"{rollouts.max_forces} N, {1e3 * rollouts.max_penetrations} mm, {rollouts.torques.shape}")
    print(f"{rollouts.contact_points.shape} at offsets {1e3 * rollouts.offsets} mm")
    better, report = scene.refine(reference, friction=0.1, time_limit=20.0)
    print(f"refined from {report['rate_before']:.0%} to {report['rate_after']:.0%}: {better.states.shape}")


def refined(scene: Scene, plan: Plan) -> Plan:
    """Plan robustly, and again for a start that was measured."""
    robust = scene.solve_robust(friction=[0.0, 0.1], from_=plan, time_limit=60.0)
    print(f"{robust.status}, done: {robust.done}, planned: {plan.planned}")
    start = robust.reference[0, :7] + [0.002, 0.001, 0.0, 0.0, 0.0, 0.0, 0.0]
    moved = robust.replan(start=start, offset_magnitude=0.9 * scene.offset_magnitude, time_limit=60.0)
    print(f"replanned: {moved.status}, {moved.result['iterations']} iterations")
    tolerated = scene.tolerance(robust, quantities=["friction"], map=None, cases=64)
    print(f"tolerates friction up to {tolerated['boundaries'][0]['value']}")
    return robust


def written(scene: Scene, plan: Plan, out: Path) -> None:
    """Write what robots, engines and people read."""
    plan.save(out / "robust")
    print(f"exported {plan.export('csv', out / 'robot', rate=250, anyway=True)}")
    (out / "plan.xml").write_text(plan.mjcf(anyway=True))
    plan.report(out / "report.html")
    plan.figure("forces").save(out / "forces.svg")
    plan.animate(out / "moving.svg", scenario=1)
    plan.plot()[0].figure.savefig(out / "positions.png")
    (out / "resolved.toml").write_text(plan.resolved)
    peg = assembly_plan.generate("round", out / "peg.toml", diameter=0.01, facets=6, force=True)
    cells = assembly_plan.batch(out / "peg.toml", out / "batch", deltas=[0.001])
    print(f"{peg.title}: {[cell['cell']['delta_m'] for cell in cells]}")


if __name__ == "__main__":
    main()
