"""Plan a part from a mesh: write a clamp as an STL file, put it onto a wall, and keep the plan.

python mesh.py --out out/clamp
"""

import argparse
from pathlib import Path

import assembly_plan
import numpy as np
from assembly_plan import events

# The outline of a clamp (mm, y and z): two legs below a bridge, with a gap of 5.5 mm.
OUTLINE = [
    (-7.75, -12.5),
    (-2.75, -12.5),
    (-2.75, 12.5),
    (2.75, 12.5),
    (2.75, -12.5),
    (7.75, -12.5),
    (7.75, 17.5),
    (-7.75, 17.5),
]
# Its triangles, as indices into the outline, counter-clockwise seen from +x.
TRIANGLES = [(0, 1, 2), (0, 2, 7), (7, 2, 3), (7, 3, 6), (6, 3, 4), (6, 4, 5)]
LENGTH = 30.0


def main() -> None:
    """Write the mesh, plan and tell what came of it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("out/clamp"))
    arguments = parser.parse_args()
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    mesh = arguments.out.with_suffix(".stl")
    write_stl(mesh)
    scene = assembly_plan.Scene.from_dict(content(mesh))
    print(f"{scene}: the mesh became {', '.join(part.name for part in scene.body)}")
    plan = scene.solve(progress=show)
    print(plan)
    plan.save(arguments.out)
    print(f"written to {arguments.out}")


def write_stl(file: Path) -> None:
    """Write the clamp as a binary STL file in millimetres."""
    ends = [np.array([(x, y, z) for y, z in OUTLINE]) for x in (-LENGTH / 2, LENGTH / 2)]
    back, front = ends
    corners = [[front[a], front[b], front[c]] for a, b, c in TRIANGLES]
    corners += [[back[a], back[c], back[b]] for a, b, c in TRIANGLES]
    for index in range(len(OUTLINE)):
        following = (index + 1) % len(OUTLINE)
        corners.append([back[index], back[following], front[following]])
        corners.append([back[index], front[following], front[index]])
    triangles = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    triangles["corners"] = corners
    file.write_bytes(bytes(80) + np.uint32(len(corners)).tobytes() + triangles.tobytes())


def content(mesh: Path) -> dict[str, object]:
    """Return the scene, with the keys of a scene file."""
    return {
        "title": "clamp from a mesh",
        "body": {
            "mass": 1.0,
            "inertia": [0.1, 0.1, 0.1],
            "part": [{"name": "clamp", "mesh": mesh, "unit": "mm"}],
        },
        "environment": {"part": [{"name": "wall", "box": [0.09, 0.005, 0.08], "position": [0.0, 0.0, -0.04]}]},
        "start": [{"name": "1", "position": [0.0, 0.01, 0.0525], "orientation": [0.995, 0.0, 0.0, -0.1]}],
        "goal": {"position": [0.0, 0.0, -0.0123], "orientation": [1.0, 0.0, 0.0, 0.0]},
        "impedance": {"translational_stiffness": 100.0, "rotational_stiffness": 10.0},
        "robustness": {
            "offset_magnitude": 0.004,
            "offset_directions": [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]],
        },
    }


def show(event: events.Event) -> None:
    """Tell of the homotopy steps."""
    match event:
        case events.HomotopyStep(number=number, position_error_m=float(error)):
            print(f"homotopy step {number}: {1e3 * error:.2f} mm from the goal")


if __name__ == "__main__":
    main()
