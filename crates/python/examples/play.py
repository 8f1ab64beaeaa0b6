"""Play a plan with hard contact and injected offsets, beside an unplanned straight push.

python play.py scenes/corner.toml --friction 0 0.3
"""

import argparse
from pathlib import Path

import assembly_plan
import numpy as np


def main() -> None:
    """Plan, play and print every rollout, then the success rates."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--friction", type=float, nargs="+", default=[0.0, 0.3])
    arguments = parser.parse_args()
    scene = assembly_plan.Scene.load(arguments.scene)
    plan = scene.solve()
    # Offsets (m) along three directions of the body's frame, at half of the planned magnitude.
    offsets = 0.5 * scene.offset_magnitude * np.eye(3)
    played = scene.simulate(plan, offsets=offsets, friction=arguments.friction)
    columns = ("motion", "friction", "x_m", "y_m", "z_m", "position_error_m", "success")
    for motion, friction, x, y, z, error, success in zip(*map(played.rollouts.get, columns), strict=True):
        end = "success" if success else "failure"
        print(f"{motion}, friction {friction:g}, offset {x:g} {y:g} {z:g} m: {1e3 * error:.2f} mm, {end}")
    for name in ("plan", "straight push"):
        print(f"{name}: {100 * played.rate(name):.0f} %")


if __name__ == "__main__":
    main()
