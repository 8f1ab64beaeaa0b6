"""Plan a scene for several offset magnitudes, and draw how often each plan succeeds at each of them.

    python sweep.py scenes/corner.toml --deltas 0.005 0.01 0.02 --figure success.png

Needs matplotlib.
"""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import assembly_plan
import matplotlib.pyplot as plt
import numpy as np


def main() -> None:
    """Plan, play and draw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--deltas", type=float, nargs="+", default=[0.005, 0.01, 0.02], help="offset magnitudes (m)")
    parser.add_argument("--random", type=int, default=20, help="random offsets per magnitude")
    parser.add_argument("--friction", type=float, default=0.1)
    parser.add_argument("--figure", type=Path, default=Path("success.png"))
    arguments = parser.parse_args()
    scene = assembly_plan.Scene.load(arguments.scene)
    rates = success_matrix(scene, arguments.deltas, arguments.random, arguments.friction)
    draw(rates, arguments.deltas, f"{scene.title}, friction {arguments.friction:g}", arguments.figure)


def success_matrix(
    scene: assembly_plan.Scene, deltas: list[float], count: int, friction: float
) -> assembly_plan.FloatArray:
    """Return success rates: a row for each planned magnitude, a column for each played one."""
    rates = np.zeros((len(deltas), len(deltas)))
    for row, delta in enumerate(deltas):
        plan = scene.solve(delta=delta)
        played = scene.simulate(plan, random=count, magnitude=deltas, friction=[friction]).successes
        of_plan = played["motion"] == "plan"
        for column, magnitude in enumerate(deltas):
            rates[row, column] = played["rate"][of_plan & (played["magnitude_m"] == magnitude)].item()
        print(f"planned for {1e3 * delta:g} mm: {plan.status}; success rates {rates[row]}")
    return rates


def draw(rates: assembly_plan.FloatArray, deltas: list[float], title: str, file: Path) -> None:
    """Draw the matrix with its numbers."""
    figure, axes = plt.subplots(layout="constrained")
    image = axes.imshow(100 * rates, vmin=0, vmax=100, cmap="viridis", origin="lower")
    for (row, column), rate in np.ndenumerate(rates):
        axes.text(column, row, f"{100 * rate:.0f}", ha="center", va="center", color="black" if rate > 0.5 else "white")
    labels = [f"{1e3 * delta:g}" for delta in deltas]
    axes.set_xticks(range(len(deltas)), labels)
    axes.set_yticks(range(len(deltas)), labels)
    axes.set(xlabel="injected offset (mm)", ylabel="planned offset (mm)", title=title)
    figure.colorbar(image, label="success (%)")
    figure.savefig(file, dpi=150)
    print(f"{file} written")


if __name__ == "__main__":
    main()
