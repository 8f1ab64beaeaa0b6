"""Make the plan of a scene robust and print its success rates.

python refine.py scenes/corner.toml --friction 0 0.1
"""

import argparse
from pathlib import Path

import assembly_plan


def main() -> None:
    """Refine, and print the rates of every friction."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--friction", type=float, nargs="+", default=[0.0, 0.1])
    parser.add_argument("--target-rate", type=float, default=0.95)
    arguments = parser.parse_args()
    scene = assembly_plan.Scene.load(arguments.scene)
    plan = scene.solve_robust(friction=arguments.friction, target_rate=arguments.target_rate)
    report = plan.result["robust"]
    print(f"{plan.status}, in {report['wall_s']:.1f} s")
    print(f"before refinement {100 * report['rate_before']:.1f} %, after it {100 * report['rate_after']:.1f} %")
    for friction in arguments.friction:
        groups = [group for group in report["after"] if group["friction"] == friction]
        successes, rollouts = (sum(group[key] for group in groups) for key in ("successes", "rollouts"))
        force = max(group["max_force_n"] for group in groups)
        print(f"friction {friction:g}: {successes} of {rollouts}, at most {force:.1f} N")


if __name__ == "__main__":
    main()
