"""Plans robotic assembly motions that tolerate position errors of the grasp.

A robot holds a part and must put it onto or into another one, but the part sits some millimetres off in the gripper.
This package plans one reference motion that, tracked by a Cartesian impedance controller, brings the part to its goal
for every modelled offset:

    import assembly_plan

    scene = assembly_plan.Scene.load("scenes/corner.toml")
    plan = scene.solve()
    print(plan.status, plan.reference.shape)
    print(scene.simulate(plan, random=20, friction=[0.0, 0.1]))
    plan.save("out/corner")

`Scene` is a scene file after all checks, `Plan` what a solve makes of it, `Simulation` rollouts of a plan with hard
contacts, `Reference` a motion of your own; `new`, `generate` and `batch` write and solve scene files. `events` has what
a `progress` callback hears. Everything is in SI units; quaternions are ``(w, x, y, z)``.
Long work leaves the interpreter to other threads, and Ctrl-C ends it.
"""

from importlib.metadata import version

from assembly_plan import events
from assembly_plan._arrays import FloatArray
from assembly_plan.arm import Arm, JointCourse
from assembly_plan.commands import batch, generate, new
from assembly_plan.contacts import Contacts
from assembly_plan.content import Impedance, Part
from assembly_plan.errors import NoPlanError, PlannerError, SceneError, SceneWarning
from assembly_plan.figure import Figure
from assembly_plan.motion import Motion
from assembly_plan.plan import Plan
from assembly_plan.reference import Reference
from assembly_plan.rollouts import Rollouts
from assembly_plan.scene import Scene
from assembly_plan.simulation import Simulation

__version__ = version("assembly-plan")
"""The version of the package, which is that of the program."""

__all__ = [
    "Arm",
    "Contacts",
    "Figure",
    "FloatArray",
    "Impedance",
    "JointCourse",
    "Motion",
    "NoPlanError",
    "Part",
    "Plan",
    "PlannerError",
    "Reference",
    "Rollouts",
    "Scene",
    "SceneError",
    "SceneWarning",
    "Simulation",
    "__version__",
    "batch",
    "events",
    "generate",
    "new",
]
