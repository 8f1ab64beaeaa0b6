"""The command ``assembly-plan``, also as ``python -m assembly_plan``."""

import sys

from assembly_plan._planner import run_command


def main() -> int:
    """Run the command line; its exit code."""
    # A batch solves each of its cells in a process of its own, which is started like this.
    first = ["-P", "-m", "assembly_plan"]
    return run_command(sys.executable, first, ["assembly-plan", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
