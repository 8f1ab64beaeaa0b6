"""Plan the motion of a scene file and keep the plan.

python solve.py scenes/corner.toml --out out/corner
"""

import argparse
from pathlib import Path

import assembly_plan
from assembly_plan import events


def main() -> None:
    """Plan, show progress and print the reference."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="folder of the plan")
    arguments = parser.parse_args()
    plan = assembly_plan.Scene.load(arguments.scene).solve(out=arguments.out, progress=show)
    print(plan.status)
    print("time (s)  position (m)")
    for time, state in zip(plan.time, plan.reference, strict=True):
        print(f"{time:8.2f}  {state[0]:.4f} {state[1]:.4f} {state[2]:.4f}")


def show(event: events.Event) -> None:
    """Print the end of every homotopy step."""
    match event:
        case events.HomotopyStep(number=number, record=record):
            print(f"homotopy step {number}: {record['status']}, {record['iterations']} iterations")


if __name__ == "__main__":
    main()
