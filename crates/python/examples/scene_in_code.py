"""Build a scene from numbers and plan it, without a file."""

from typing import Any

import assembly_plan

OFFSETS = (0.005, 0.01, 0.02)


def main() -> None:
    """Plan a push for several offset magnitudes."""
    scene = assembly_plan.Scene.from_dict(content([0.1, 0.08, 0.06]))
    print(f"{scene}, starts {list(scene.starts)}")
    for offset in OFFSETS:
        plan = scene.solve(delta=offset)
        error = max(scenario["position_error_m"] for scenario in plan.result["scenarios"])
        print(f"offsets of {1e3 * offset:g} mm: {plan.status}, ends within {1e3 * error:.3f} mm")


def content(edges: list[float]) -> dict[str, Any]:
    """Keys of a scene: a box with these edge lengths (m) is pushed against a wall."""
    contact = 0.5 * edges[0]
    wall = {"name": "wall", "box": [0.1, 0.6, 0.4], "position": [-0.05, 0.0, 0.0]}
    return {
        "title": "box pushed against a wall",
        "body": {"part": [{"name": "box", "box": edges}]},
        "environment": {"part": [wall]},
        "start": [{"name": "1", "position": [contact + 0.05, 0.0, 0.0], "orientation": [1, 0, 0, 0]}],
        "goal": {"position": [contact + 0.001, 0.0, 0.0], "orientation": [1, 0, 0, 0]},
        "impedance": {"translational_stiffness": 50.0, "rotational_stiffness": 5.0},
        "robustness": {"offset_magnitude": 0.01, "offset_directions": [[1, 0, 0], [-1, 0, 0]]},
    }


if __name__ == "__main__":
    main()
