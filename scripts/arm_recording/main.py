"""Records of arms in MuJoCo: `main.py dynamics URDF TIP FILE` or `main.py motions ARMS FOLDER`."""

import sys

import dynamics
import motions


def main() -> None:
    """Writes what the command line asks for."""
    name, *arguments = sys.argv[1:]
    {"dynamics": dynamics.write, "motions": motions.write}[name](*arguments)


if __name__ == "__main__":
    main()
