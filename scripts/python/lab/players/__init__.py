"""Tests of the players of exported plans: stand-ins of the makers' packages move a simulated arm.

What the stand-ins are made of is independent of the players: MuJoCo's kinematics, and a controller and an impedance law
of their own. Modules that players share are found by their names, as in an exported folder.
"""

import sys

from lab.paths import PLAYERS

sys.path.append(str(PLAYERS / "shared"))
