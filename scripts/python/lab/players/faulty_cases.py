"""Faults, and how every player ends with them: the rows of a table in the documentation."""

import dataclasses
import math
import pathlib

from lab.players import spoiling
from lab.players.case import Case, fault

PLAYERS = ("ur-rtde", "franka", "ros2", "ros2-control")
# The script in joint torques, and in force mode.
SCRIPTS = ("urscript", "urscript-force")
WITH_SCRIPT = (*PLAYERS, *SCRIPTS)
# Players behind topics, of a robot that is commanded by position, and of robots that are commanded torques.
TOPICS, POSITIONS = ("ros2", "ros2-control"), ("ros2-control",)
TORQUES = ("ur-rtde", "franka", "ros2", "urscript")
# A plan with heights in free air for both arms: outside of the corner, they are close to their full reach. One of the
# heights (m), which is also free in front of the corner for the arm that stands closer.
DRY_RUN_PLAN, DRY_RUN = "clamp1", "0.05"
BEGIN, END = "<!-- faults -->\n", "<!-- end of faults -->\n"


@dataclasses.dataclass(frozen=True)
class Fault:
    """A fault in words, how a player ends, what it says, which players it can happen to, and how it is made."""

    words: str
    code: int
    says: str
    players: tuple[str, ...]
    making: dict


def told(
    words: str, kind: str, at: float, code: int, says: str, players: tuple[str, ...] = PLAYERS, **more: object
) -> Fault:
    """A fault of the simulated robot."""
    return Fault(words, code, says, players, {"simulation": fault(kind, at), **more})


def faults() -> list[Fault]:
    """All of them."""
    found = []
    names = {
        "positions": "joint positions",
        "speeds": "joint speeds",
        "pose": "pose of the tool",
        "wrench": "force and torque",
        "time": "time",
    }
    for signal, called in names.items():
        # A middleware has a clock of its own. The other values and phases are those of no_numbers.py.
        players = tuple(each for each in PLAYERS if each not in TOPICS) if signal == "time" else WITH_SCRIPT
        found.append(told(f"{called}: infinity from the beginning", f"inf {signal}", 0.0, 1, "number", players))
        found.append(told(f"{called}: NaN while playing", f"nan {signal}", 2.0, 1, "number", players))
    found += [
        told("pose of the tool that stands still", "frozen pose", 2.0, 1, "from where its joints have it"),
        told("joint positions that stand still", "frozen positions", 2.0, 1, "from where its joints have it"),
        told("time that stands still", "hang", 2.0, 1, "stopped: ", ("franka", *TOPICS)),
        told("time that runs backwards", "time back", 2.0, 1, "backwards"),
        told("a gap of 0.2 s", "gap", 2.0, 1, "stopped: "),
        told("pose of the flange instead of the tool", "flange", 0.0, 2, "tool point", WITH_SCRIPT),
        told("pose of the flange from some time on", "flange", 2.0, 1, "stopped: ", WITH_SCRIPT),
        told("tool turned by half a turn", "half turn", 0.0, 2, "tool point", WITH_SCRIPT),
        told("pose in the world instead of the base", "world", 0.0, 2, "tool point", WITH_SCRIPT),
        told("a force that nothing explains", "force", 2.0, 1, "force of", WITH_SCRIPT),
        # A robot that is commanded by position does not yield to it.
        told("a push that no sensor feels", "push", 2.0, 1, "stopped: ", TORQUES),
        told("a load of 20 N that is not set as payload", "payload", 0.0, 1, "payload", WITH_SCRIPT),
        # Where there is room for a path on which the obstacle is pressed hard enough to be felt.
        told(
            "obstacle on the path to the start",
            "obstacle",
            0.8,
            1,
            "stopped: ",
            WITH_SCRIPT,
            plan=DRY_RUN_PLAN,
            simulation_more={"displaced": 0.018},
            flags=("--skip-self-test", "--path-is-free"),
        ),
        told("obstacle in the test of the frames", "obstacle", 1.4, 1, "stopped: ", WITH_SCRIPT, flags=()),
        told(
            "obstacle in a dry run",
            "obstacle",
            2.0,
            1,
            "",
            WITH_SCRIPT,
            plan=DRY_RUN_PLAN,
            flags=("--skip-self-test", "--dry-run", DRY_RUN, "--path-is-free"),
        ),
        told("connection lost while playing", "disconnect", 2.0, 1, "stopped: ", ("franka", *TOPICS)),
        told("protective stop of the robot", "protective", 2.0, 1, "stopped by itself", ("ur-rtde", "franka")),
        told("safeguard stop of the robot", "safeguard", 2.0, 1, "safeguard", ("ur-rtde",)),
        told("robot that refuses commands", "refuse", 2.0, 1, "does not take commands", ("ur-rtde",)),
        told("robot that takes no watchdog", "no watchdog", 0.0, 1, "watchdog", ("ur-rtde",)),
        told("command that never returns", "stuck", 2.0, 1, "does not return", ("ur-rtde",)),
        told("Jacobian of another tool", "jacobian", 0.0, 2, "Jacobian", ("ur-rtde",)),
        told("joint states without velocities", "no speeds", 0.0, 1, "velocities", TOPICS),
        told("joint states that end", "no joints", 2.0, 1, "joint states is", TOPICS),
        told("wrench that ends", "no wrench", 2.0, 1, "wrench is", TOPICS),
        told("messages in another frame", "frame name", 0.0, 2, "--frame", TOPICS),
        told("messages that are sent twice", "doubled", 2.0, 1, "old", TOPICS),
        told("messages in the wrong order", "reordered", 2.0, 1, "backwards", TOPICS),
        told("messages that come 0.3 s late", "late", 2.0, 1, "stopped: ", TOPICS),
        told("old messages that are sent again, or clocks that differ", "old", 0.0, 2, "clock", TOPICS),
        told("no controller that hears", "nobody", 0.0, 2, "no controller hears", TOPICS),
        told("controller that ignores the gains", "deaf", 0.0, 2, "does not take the gains", TOPICS),
        told("controller that clips the gains", "clipped", 0.0, 2, "does not take the gains", TOPICS),
        told("controller with fixed gains", "read-only", 0.0, 2, "does not take the gains", TOPICS),
        told("controller that is not active any more", "inactive", 2.0, 1, "offsets of the controller", POSITIONS),
        told("controller that ignores the references", "ignored", 2.0, 1, "from its reference", POSITIONS),
        told("controller of other joints", "other joints", 0.0, 1, "of another arm", POSITIONS),
        told("law at another link", "other link", 0.0, 2, "acts at", POSITIONS),
        told("law that holds the tool beside its reference", "held", 0.0, 2, "zero the sensor", POSITIONS),
        told("controller manager that is too slow", "slow", 0.0, 2, "times per second", POSITIONS),
    ]

    def made(words: str, code: int, says: str, players: tuple[str, ...] = PLAYERS, **making: object) -> None:
        found.append(Fault(words, code, says, players, making))

    made("start too far away", 2, "move", WITH_SCRIPT, simulation={"displaced": 0.6})
    made("path to the start of which nobody knows", 2, "path", WITH_SCRIPT, simulation={"displaced": 0.08})
    # The tool is at the start, and the last joint is not.
    made(
        "arm that stands otherwise than planned",
        2,
        "path",
        tuple(each for each in WITH_SCRIPT if each != "franka"),
        simulation={"displaced": (0.0, 0.0, 0.0, 0.0, 0.0, -2 * math.pi)},
    )
    made(
        "link that may touch something on the path to the start",
        2,
        "path",
        WITH_SCRIPT,
        plan=DRY_RUN_PLAN,
        simulation={"displaced": 0.018},
        spoil=spoiling.narrow,
    )
    made(
        "link that may touch something in the test of the frames",
        2,
        "test",
        WITH_SCRIPT,
        flags=(),
        spoil=spoiling.narrow,
    )
    # Without gains that are raised: damping times delay over the inertia of such a rotor is too much.
    late = {"rotor_inertia": 0.05, "joint_friction": 0.3, "delay": 0.008}
    made("torques that come too late: the robot swings", 1, "swings", TORQUES, simulation={"truth": late}, flags=())
    made("joints that stick", 1, "stopped: ", TORQUES, simulation={"truth": {"joint_friction": 12.0}}, flags=())
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT"):
        made(f"signal {name}", 130, name, interrupted_at="playing", signal=name)
    made("SIGHUP of a terminal that is gone", 130, "", interrupted_at="playing", signal="SIGHUP", hears=False)
    made("SIGKILL (the log stays)", -9, "", interrupted_at="playing", signal="SIGKILL")
    made("full disk", 1, "the log cannot be written any more", limit=60_000)
    made("log that exists", 2, "exists", spoil=spoiling.existing_log)
    made("log in a folder that cannot be", 2, "cannot be written", log="plan.json/executed.csv")
    made("stiffness times 50", 2, "stiffness", WITH_SCRIPT, flags=("--stiffness-factor", "50"))
    made("force guard of 1e9 N", 2, "--force-limit", flags=("--force-limit", "1e9"))
    made("distance guard that is no number", 2, "--distance-limit", flags=("--distance-limit", "nan"))
    made("dry run of 1 mm", 2, "not in free air", WITH_SCRIPT, flags=("--dry-run", "0.001"))
    made("plan.json: edited gain", 2, "was changed", spoil=spoiling.edited(spoiling.stiffer))
    made("plan.json: NaN, sealed again", 2, "not a number", spoil=spoiling.edited(spoiling.no_number, sealed=True))
    made("plan.json: another format", 2, "export again", spoil=spoiling.edited(spoiling.older, sealed=True))
    made("trajectory of another plan", 2, "another export", spoil=spoiling.foreign("clamp1-six"))
    made("trajectory cut", 2, "was changed", spoil=spoiling.rows(lambda lines: lines[:50], sealed=False))
    made("trajectory backwards, sealed again", 2, "times do not increase", spoil=spoiling.rows(spoiling.backwards))
    made("trajectory that jumps, sealed again", 2, "jumps", spoil=spoiling.rows(spoiling.moved))
    made("quaternions that change sign, sealed again", 2, "sign", spoil=spoiling.rows(spoiling.flipped))
    made("quaternions of norm 1.1, sealed again", 2, "unit norm", spoil=spoiling.rows(spoiling.longer))
    made("seal missing", 2, "not a whole folder", spoil=spoiling.lost("SHA256SUMS"))
    made("player with a guard taken out", 2, "was changed", spoil=spoiling.changed_player)
    made("the same, and its line of the seal", 2, "was changed", spoil=spoiling.unsealed_player)
    made("foreign module beside the player", 2, "of another export", spoil=spoiling.foreign_module)
    return found


def dry_run_plan(player: str) -> str:
    """One with heights in free air for the arm of a player."""
    return "corner" if player not in TORQUES else DRY_RUN_PLAN


def faulty() -> list[Case]:
    """A case of every fault with every player that it can happen to."""
    return [case_of(each, player) for each in faults() for player in each.players]


def case_of(fault_: Fault, player: str) -> Case:
    """A fault with a player. The script has one code for all that is not done, and words of its own for numbers."""
    making = dict(fault_.making)
    more = making.pop("simulation_more", {})
    if more:
        making["simulation"] = {**making["simulation"], **more}
    words = fault_.words.replace("/", " ").replace(":", "").replace(",", "")
    is_script = player in SCRIPTS
    says = "stopped: " if is_script and fault_.says in ("number", "force of", "tool point") else fault_.says
    # Where the law acts on the measured force itself, the load exceeds a guard before the hold is over.
    says = "stopped: " if says == "payload" and player not in TORQUES else says
    plan = making.pop("plan", "corner")
    if plan == DRY_RUN_PLAN:
        plan = dry_run_plan(player)
    arm = {"arm": "force"} if player == "urscript-force" else {}
    target = "urscript" if is_script else player
    return Case(f"{player} {words}", target, plan, code_of(fault_, player), says, **arm, **making)


def code_of(fault_: Fault, player: str) -> int:
    """How a player ends."""
    return min(fault_.code, 1) if player in SCRIPTS else fault_.code


def write_table(page: pathlib.Path) -> None:
    """Writes the table of all faults into a page."""
    header = f"| fault | {' | '.join(f'`{player}`' for player in WITH_SCRIPT)} |\n|---|{'---|' * len(WITH_SCRIPT)}\n"
    rows = []
    for each in faults():
        codes = [str(code_of(each, player)) if player in each.players else "-" for player in WITH_SCRIPT]
        rows.append(f"| {each.words} | {' | '.join(codes)} |\n")
    before, rest = page.read_text().split(BEGIN)
    page.write_text(before + BEGIN + header + "".join(rows) + END + rest.split(END)[1])
