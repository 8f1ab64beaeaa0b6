"""Cases beside faults: plans that are played to their end, and what stops a player."""

import math
import random

from lab.players.case import Case, fault
from lab.players.faulty_cases import DRY_RUN, PLAYERS, TORQUES, dry_run_plan

# Of robots, the one behind sockets is `loopback`.
TARGETS = ("ur-rtde", "loopback", "franka", "ros2", "ros2-control", "urscript")
# Two offsets (m) of each plan that it covers.
OFFSETS = {
    "corner": ((0.019, 0.0, 0.0), (0.008, 0.0, 0.01)),
    "clamp1": ((0.003, -0.003, 0.0), (0.0, 0.0035, 0.0)),
    "peg1": ((0.0, 0.0, 0.0), (0.008, -0.008, 0.0)),
}
# Largest turn of the part (rad) in a good run, as those plans cover it.
LARGEST_TURN = 0.01


def insertions() -> list[Case]:
    """Every plan with every player, each with a grasp error that was planned for and one between them."""
    return [
        Case(
            f"{target} {plan} {number}",
            target,
            plan,
            inserts=True,
            simulation={"offset": offset, "turn": (0.0, 0.005, 0.0)},
        )
        for target in TARGETS
        for plan in OFFSETS
        for number, offset in enumerate(OFFSETS[plan], 1)
        # Behind sockets, a robot takes longer than its own time.
        if (target != "loopback" or (plan, number) == ("clamp1", 1)) and has_plan(target, plan)
    ]


def has_plan(target: str, plan: str) -> bool:
    """Whether a plan was recorded for the robots of a target."""
    return target != "ros2-control" or plan == "corner"


def good_runs(count: int) -> list[Case]:
    """Motions without a fault: players and plans in turn, offsets between two of a plan, turns about any axis."""
    generator = random.Random(1)
    kinds = [(target, plan) for target in TARGETS if target != "loopback" for plan in OFFSETS if has_plan(target, plan)]
    cases = []
    for number in range(count):
        target, plan = kinds[number % len(kinds)]
        share = generator.random()
        offset = [share * one + (1 - share) * other for one, other in zip(*OFFSETS[plan])]
        axis = [generator.gauss(0, 1) for _ in range(3)]
        size = generator.uniform(0, LARGEST_TURN) / math.hypot(*axis)
        turn = [size * component for component in axis]
        simulation = {"offset": offset, "turn": turn}
        cases.append(Case(f"good run {number + 1}: {target} {plan}", target, plan, inserts=True, simulation=simulation))
    return cases


def guards() -> list[Case]:
    """What stops a player beside faults, and what must not."""
    cases = []
    for target in PLAYERS:

        def add(name: str, *rest: object, plan: str = "corner", target: str = target, **more: object) -> None:
            cases.append(Case(f"{target} {name}", target, plan, *rest, **more))

        flags = ("--dry-run", DRY_RUN, "--path-is-free")
        add("self-test and dry run", 0, "dry run: the tool ends", plan=dry_run_plan(target), flags=flags)
        add("interrupt", 130, "interrupted", interrupted_at="testing the frames", flags=())
        add("without packages", 3, "pip install numpy", has_packages=False)
        add("wrong factor", 2, "--stiffness-factor", flags=("--stiffness-factor", "-1"))
        if target in TORQUES:
            add("soft", 1, "the tool moved", flags=("--stiffness-factor", "0.001"))
        beside = {"offset": OFFSETS["corner"][0]}
        flags = ("--skip-self-test", "--distance-limit", "0.001")
        add("distance", 1, "from its reference", flags=flags, simulation=beside)
        add("displaced", 0, "", inserts=True, simulation={"displaced": 0.005})
    for name in ("force", "hang", "disconnect", "protective"):
        cases.append(Case(f"loopback {name}", "loopback", "corner", 1, "stopped: ", simulation=fault(name)))
    cases += [
        Case(
            "loopback interrupt",
            "loopback",
            "corner",
            130,
            "interrupted",
            interrupted_at="testing the frames",
            flags=(),
        ),
        Case("loopback force mode", "loopback", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde turned base", "ur-rtde", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("ur-rtde force mode", "ur-rtde", "corner", inserts=True, flags=("--skip-self-test", "--mode", "force")),
        Case("ur-rtde older", "ur-rtde", "corner", inserts=True, environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"}),
        Case(
            "ur-rtde older torque",
            "ur-rtde",
            "corner",
            2,
            "takes no joint torques",
            flags=("--mode", "torque"),
            environment={"POLYSCOPE": "URSoftware 5.12.6 (2022)"},
        ),
        Case(
            "ros2 motion-update",
            "ros2",
            "corner",
            inserts=True,
            flags=("--skip-self-test", "--message", "motion-update"),
        ),
        Case("ros2-control less damping", "ros2-control", "corner", 2, "oscillates", flags=("--damping-factor", "0.5")),
        *(
            Case(
                f"urscript force mode corner {number}",
                "urscript",
                "corner",
                arm="force",
                inserts=True,
                simulation={"offset": offset},
            )
            for number, offset in enumerate(OFFSETS["corner"], 1)
        ),
        Case(
            "ur-rtde damping of force mode",
            "ur-rtde",
            "corner",
            2,
            "has a damping of its own",
            arm="force",
            flags=("--damping-factor", "0.5"),
        ),
        Case(
            "urscript force mode dry run",
            "urscript",
            "corner",
            0,
            "the plan is played",
            arm="force",
            flags=("--skip-self-test", "--dry-run", DRY_RUN, "--path-is-free"),
        ),
        Case("urscript without receiver", "urscript", "corner", inserts=True, has_receiver=False),
        Case("urscript turned base", "urscript", "corner", inserts=True, simulation={"base_is_turned": True}),
        Case("urscript force", "urscript", "corner", 1, "beyond the limit", simulation=fault("force")),
        Case("urscript too far", "urscript", "corner", 1, "move the robot to the start", simulation={"displaced": 0.6}),
    ]
    return cases + corrections()


def corrections() -> list[Case]:
    """A robot that is commanded by position and takes corrections over UDP."""
    # On a busy machine, datagrams come late.
    calm = ("--longest-silence", "5")
    flags = ("--skip-self-test", *calm)
    cases = [
        Case(
            f"correction corner {number}",
            "correction",
            "corner",
            inserts=True,
            flags=flags,
            simulation={"offset": offset},
        )
        for number, offset in enumerate(OFFSETS["corner"], 1)
    ]
    displaced = {"displaced": 0.005}
    cases.append(Case("correction self-test", "correction", "corner", inserts=True, flags=calm, simulation=displaced))
    for kind, says in (
        ("force", "N at the tool, beyond"),
        ("nan", "is not as README.md has it"),
        ("cut", "is not as README.md has it"),
        ("repeated", "came after"),
        ("silent", "the robot has sent nothing"),
        ("clock", "the law was chosen for"),
    ):
        cases.append(Case(f"correction {kind}", "correction", "corner", 1, says, flags=flags, simulation=fault(kind)))
    return cases
