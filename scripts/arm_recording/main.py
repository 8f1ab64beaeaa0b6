"""Records of arms in MuJoCo: `main.py dynamics URDF TIP FILE` or `main.py motions ARMS FOLDER`."""

import sys

import dynamics
import motions

{"dynamics": dynamics.write, "motions": motions.write}[sys.argv[1]](*sys.argv[2:])
