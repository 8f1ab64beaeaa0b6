"""Print distances of all pairs along the straight path from start to goal, with their contact normals.

python distances.py scenes/corner.toml
"""

import argparse
from pathlib import Path

import assembly_plan
import numpy as np

POSES = 5


def main() -> None:
    """Interpolate poses and print the closest pair of each."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    arguments = parser.parse_args()
    scene = assembly_plan.Scene.load(arguments.scene)
    start = next(iter(scene.starts.values()))
    for share in np.linspace(0.0, 1.0, POSES):
        pairs = scene.distances((1.0 - share) * start + share * scene.goal)
        closest = min(pairs, key=lambda pair: pair["exact_distance_m"])
        # The first three numbers of the normal are the gradient of the smoothed distance by the position.
        normal = np.array(closest["normal"][:3])
        print(
            f"{100 * share:3.0f} %: {closest['body']}/{closest['environment']} "
            f"{1e3 * closest['exact_distance_m']:.2f} mm (smoothed {1e3 * closest['smoothed_distance_m']:.2f} mm), "
            f"normal {normal.round(3)}"
        )


if __name__ == "__main__":
    main()
