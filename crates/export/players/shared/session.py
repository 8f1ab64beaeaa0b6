"""How a plan is played, on every robot: check, go to the start, test the frames, follow the reference, rest, stop."""

import argparse
import dataclasses
import pathlib
import signal
import sys
from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

import rotations
from kinematics import Pose
from exported_plan import ExportedPlan, InputError, ToolState, load
from guards import Guards, Limits, Measurement, Stopped
from journal import FORMAT, Journal

# Straight ways to the start have at most these speeds (m/s, rad/s) and lengths (m, rad).
APPROACH_SPEED, APPROACH_TURNING = 0.02, 0.1
LONGEST_APPROACH, LARGEST_APPROACH_TURN = 0.15, 0.5
# The pose that the robot says and the one that follows from its joints may differ by this much (m, rad): arms are calibrated.
SAME_POSITION, SAME_ANGLE = 0.005, 0.02
# Largest force (N) at rest: more is a wrong payload, or something touches.
LARGEST_REST_FORCE = 30.0
# The test of the frames: way along (m) and about (rad) each axis, time there and rest (s), smallest part of the way that must
# be seen, and smallest cosine between the way and what is seen.
TEST_WAY, TEST_TURN, TEST_TIME, TEST_REST = 0.01, 0.05, 0.8, 0.3
SEEN, ALIGNED = 0.25, 0.8
# Rest after the end of the reference (s).
SETTLING_TIME = 1.0
# The whole session may take this many times as long as planned.
SLACK = 1.5

DONE, MISSED, WRONG_INPUT, FAILED, INTERRUPTED = 0, 1, 2, 3, 130


class Robot(Protocol):
    """What a player needs of a robot. Whatever goes wrong raises Stopped."""

    def read(self) -> Measurement:
        """Waits for the next control period and measures."""

    def begin(self, hold: ToolState) -> None:
        """Enters the mode in which the tool is compliant, with this reference."""

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference for this control period."""

    def end(self) -> None:
        """Stops and leaves the mode. Called once, whatever happened."""


@dataclasses.dataclass(frozen=True)
class Settings:
    """What the user chose: height of a dry run (m; 0 is none), whether frames are tested, guards."""

    dry_run: float
    self_test: bool
    limits: Limits


class Session:
    """One execution of a plan."""

    def __init__(self, plan: ExportedPlan, robot: Robot, settings: Settings, journal: Journal) -> None:
        self.plan, self.robot, self.settings, self.journal = plan, robot, settings, journal
        # A dry run is shifted as a whole, away from the goal.
        self.shift = settings.dry_run * plan.way_out() if settings.dry_run else np.zeros(3)

    def execute(self) -> bool:
        """Plays the plan; returns whether the part is where it should be, as far as the robot can tell."""
        try:
            measured = self.robot.read()
            self.check_ready(measured)
            self.robot.begin(ToolState.at_rest(measured.tool.pose))
            # Changing the mode takes its time.
            measured = self.robot.read()
            self.guards = Guards(self.plan, self.settings.limits, measured, self.longest(measured))
            self.go_to_start(measured)
            if self.settings.self_test:
                self.test_frames()
            self.drive("playing", self.reference, self.plan.duration)
            measured = self.drive("resting", lambda _: self.reference(self.plan.duration), SETTLING_TIME)
        finally:
            # A second Ctrl-C must not disturb the stop.
            for number in (signal.SIGINT, signal.SIGTERM):
                signal.signal(number, signal.SIG_IGN)
            self.robot.end()
            self.journal.say("the robot was left at rest")
        return self.judge(measured)

    def check_ready(self, measured: Measurement) -> None:
        """The robot is at rest near the start, and its frames are those of the plan."""
        force = float(np.linalg.norm(measured.force))
        if force > LARGEST_REST_FORCE:
            raise InputError(f"the robot feels {force:.0f} N before it moves: set payload and sensor, and see that nothing touches")
        if self.plan.arm is not None:
            distance, angle = measured.tool.pose.errors(self.plan.arm.forward(measured.positions))
            if distance > SAME_POSITION or angle > SAME_ANGLE:
                raise InputError(
                    f"the tool is {1e3 * distance:.1f} mm and {angle:.3f} rad from where the URDF file has it with these joint "
                    "positions: tool point (TCP, end effector) or base of the robot are not those of the scene"
                )
        distance, angle = measured.tool.pose.errors(self.reference(0.0).pose)
        if distance > LONGEST_APPROACH or angle > LARGEST_APPROACH_TURN:
            raise InputError(
                f"the tool is {1e3 * distance:.0f} mm and {angle:.2f} rad from the start: move it there first{self.advice()}"
            )

    def advice(self) -> str:
        """Joint positions of the start."""
        if self.plan.arm is None:
            return ""
        joints = zip(self.plan.arm.names, self.plan.arm.start)
        return ", for example to " + ", ".join(f"{name} {position:.4f}" for name, position in joints)

    def go_to_start(self, measured: Measurement) -> None:
        """Slowly and straight from where the tool is."""
        begin, end = measured.tool.pose, self.reference(0.0).pose
        distance, angle = begin.errors(end)
        duration = max(distance / APPROACH_SPEED, angle / APPROACH_TURNING, TEST_REST)
        self.drive("going to the start", straight(begin, end, duration), duration + TEST_REST)

    def test_frames(self) -> None:
        """Moves a little along and about each axis of the base and compares with what the robot says."""
        home = self.reference(0.0).pose
        for index, name in enumerate(("along x", "along y", "along z", "about x", "about y", "about z")):
            way = np.zeros(6)
            way[index] = TEST_TURN if index >= 3 else TEST_WAY
            there = Pose(home.position + way[:3], rotations.of_vector(way[3:]) @ home.rotation)
            before = self.drive("resting", lambda _: ToolState.at_rest(home), TEST_REST).tool.pose
            phase = f"testing the frames: {name}"
            after = self.drive(phase, straight(home, there, TEST_TIME), TEST_TIME + TEST_REST).tool.pose
            self.drive("going back", straight(there, home, TEST_TIME), TEST_TIME)
            compare(name, way, before, after)

    def reference(self, time: float) -> ToolState:
        """The plan's reference, shifted in a dry run."""
        state = self.plan.reference(time)
        return dataclasses.replace(state, pose=Pose(state.pose.position + self.shift, state.pose.rotation))

    def drive(self, phase: str, motion: Callable[[float], ToolState], duration: float) -> Measurement:
        """Follows a motion for a time (s) under guard; returns the last measurement."""
        measured = self.robot.read()
        begin = measured.time
        self.journal.start(phase, begin)
        while True:
            reference = motion(measured.time - begin)
            self.journal.add(measured, reference)
            self.guards.check(measured, reference)
            self.robot.track(reference, measured)
            if measured.time - begin >= duration:
                return measured
            measured = self.robot.read()

    def longest(self, measured: Measurement) -> float:
        """Longest time of a session (s)."""
        distance, angle = measured.tool.pose.errors(self.reference(0.0).pose)
        approach = max(distance / APPROACH_SPEED, angle / APPROACH_TURNING) + 2 * TEST_REST
        test = 6 * (2 * TEST_TIME + 2 * TEST_REST)
        return SLACK * (approach + test + self.plan.duration + SETTLING_TIME)

    def judge(self, measured: Measurement) -> bool:
        """A part at its goal says how it sits in the gripper: the robot believes it beside the goal by the grasp error. An
        error that was not planned for means that the part is not at its goal."""
        if self.settings.dry_run:
            distance, _ = measured.tool.pose.errors(self.reference(self.plan.duration).pose)
            self.journal.say(f"dry run: the tool ends {1e3 * distance:.1f} mm from its reference")
            return True
        document = self.plan.document
        grasp_error = self.plan.goal.inverse() @ self.plan.part(measured.tool.pose)
        offset, turn = grasp_error.position, rotations.vector(grasp_error.rotation)
        in_words = ", ".join(f"{1e3 * number:.1f}" for number in offset)
        size, tolerance = float(np.linalg.norm(offset)), document["position_tolerance_m"] or 0.003
        if size > document["delta_m"] + tolerance:
            self.journal.say(
                f"the part is not at its goal: it would sit ({in_words}) mm beside where the robot believes it, more than the "
                f"{1e3 * document['delta_m']:.1f} mm that the plan tolerates"
            )
            return False
        self.journal.say(
            f"if the part is at its goal, it sits ({in_words}) mm and {np.linalg.norm(turn):.3f} rad beside where the robot "
            "believes it"
        )
        return True


def straight(begin: Pose, end: Pose, duration: float) -> Callable[[float], ToolState]:
    """From one pose to another at constant speed, then at rest."""
    way, turn = end.position - begin.position, rotations.vector(end.rotation @ begin.rotation.T)

    def state(time: float) -> ToolState:
        if time >= duration:
            return ToolState.at_rest(end)
        share = time / duration
        pose = Pose(begin.position + share * way, rotations.of_vector(share * turn) @ begin.rotation)
        return ToolState(pose, way / duration, turn / duration)

    return state


def compare(name: str, way: np.ndarray, before: Pose, after: Pose) -> None:
    """Refuses to go on where the tool did not do what it was told. Joint friction may keep some of the way."""
    seen = np.concatenate([after.position - before.position, rotations.vector(after.rotation @ before.rotation.T)])
    part = slice(3, 6) if way[3:].any() else slice(0, 3)
    wanted, seen = way[part], seen[part]
    length = float(np.linalg.norm(seen))
    share = float(seen @ wanted) / float(wanted @ wanted)
    if share < SEEN or float(seen @ wanted) < ALIGNED * length * float(np.linalg.norm(wanted)):
        unit, scale = ("rad", 1.0) if way[3:].any() else ("mm", 1e3)
        numbers = ", ".join(f"{scale * number:.3g}" for number in seen)
        raise Stopped(
            f"told to move {scale * np.linalg.norm(wanted):g} {unit} {name} of its base, the tool moved ({numbers}) {unit}: the "
            "base of the robot is not that of the scene, or its joints stick"
        )


def add_flags(parser: argparse.ArgumentParser) -> None:
    """Flags of all players."""
    add = parser.add_argument
    add("--dry-run", type=float, default=0.0, metavar="M", help="play this far (m) from the goal, in free air")
    add("--stiffness-factor", type=float, default=1.0, metavar="F", help="stiffness of the robot over that of the plan")
    add("--damping-factor", type=float, default=1.0, metavar="F", help="factor on damping")
    add("--skip-self-test", action="store_true", help="do not move along each axis first to test the frames")
    add("--force-limit", type=float, metavar="N", help="stop beyond this force [default: that of plan.json]")
    add("--torque-limit", type=float, metavar="NM", help="stop beyond this torque [default: that of plan.json]")
    add("--distance-limit", type=float, metavar="M", help="stop this far from the reference [default: that of plan.json]")
    add("--log", type=pathlib.Path, default=pathlib.Path("executed.csv"), metavar="FILE", help="[default: %(default)s]")


def settings(arguments: argparse.Namespace, plan: ExportedPlan) -> Settings:
    """What the flags say."""
    limits = Limits.of(plan)
    for name, flag in (("force", "force_limit"), ("torque", "torque_limit"), ("distance", "distance_limit")):
        given = getattr(arguments, flag)
        if given is not None:
            require_positive(arguments, flag)
            setattr(limits, name, given)
    if not 0 <= arguments.dry_run < np.inf:
        raise InputError(f"--dry-run {arguments.dry_run:g} is negative or no number")
    return Settings(arguments.dry_run, not arguments.skip_self_test, limits)


def header(arguments: argparse.Namespace, plan: ExportedPlan) -> dict[str, Any]:
    """What a log says of its session: the plan, its frames, the dry run (m), and the gains as they are set."""
    document, impedance = plan.document, dict(plan.document["impedance"])
    for kind, factor in (("stiffness", arguments.stiffness_factor), ("damping", arguments.damping_factor)):
        for name in (f"translational_{kind}", f"rotational_{kind}"):
            impedance[name] = (factor * np.array(impedance[name])).tolist()
    names = ("scene", "start", "problem", "delta_m", "base", "grasp", "goal")
    copied = {name: document[name] for name in names}
    return {"format": FORMAT, **copied, "dry_run_m": arguments.dry_run, "impedance": impedance}


def require_positive(arguments: argparse.Namespace, *names: str) -> None:
    """Refuses flags that are not above zero."""
    for name in names:
        value = getattr(arguments, name)
        if not 0 < value < np.inf:
            raise InputError(f"--{name.replace('_', '-')} {value:g} is not above zero")


def main(
    parser: argparse.ArgumentParser,
    connect: Callable[[argparse.Namespace, ExportedPlan], Robot],
    failures: tuple[type[Exception], ...] = (),
) -> int:
    """Plays the plan of this folder on the robot that `connect` makes, whose package may raise these failures beside the usual
    ones; returns the exit code."""
    add_flags(parser)
    arguments = parser.parse_args()

    def play() -> bool:
        plan = load(pathlib.Path(__file__).resolve().parent)
        chosen = settings(arguments, plan)
        robot = connect(arguments, plan)
        journal = Journal(plan, arguments.log, header(arguments, plan))
        return keeping(journal, Session(plan, robot, chosen, journal).execute)

    return exit_code(play, failures)


def keeping(journal: Journal, run: Callable[[], bool]) -> bool:
    """Runs something and writes the log whatever happens, with what went wrong."""
    try:
        return run()
    except BaseException as error:
        journal.header["stopped"] = reason(error)
        raise
    finally:
        journal.write()


def exit_code(run: Callable[[], bool], failures: tuple[type[Exception], ...] = ()) -> int:
    """Runs a program that returns whether it did what it should, and says what goes wrong; returns the exit code."""
    signal.signal(signal.SIGTERM, interrupt)
    try:
        return DONE if run() else MISSED
    except KeyboardInterrupt as error:
        print(reason(error), file=sys.stderr)
        return INTERRUPTED
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return WRONG_INPUT
    except Stopped as error:
        print(f"stopped: {reason(error)}", file=sys.stderr)
        return MISSED
    except (OSError, RuntimeError, *failures) as error:
        # The robot was stopped as far as it still listens.
        print(f"error: {error}", file=sys.stderr)
        return FAILED


def reason(error: BaseException) -> str:
    """Why a session ended early, in words."""
    if isinstance(error, KeyboardInterrupt):
        return "interrupted"
    # What went wrong while stopping hides nothing of what went wrong before.
    before = error.__context__ if isinstance(error, Stopped) else None
    return f"{before}; {error}" if isinstance(before, Stopped) else str(error)


def interrupt(*_: object) -> None:
    """A request to terminate ends a session as Ctrl-C does."""
    raise KeyboardInterrupt
