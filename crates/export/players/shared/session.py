"""How a plan is played, on every robot: check, go to the start, test the frames, follow the reference, rest, stop."""

import argparse
import dataclasses
import pathlib
from collections.abc import Callable, Iterable
from typing import Protocol

import numpy as np

import rotations
from exported_plan import ExportedPlan, ToolState, load
from failures import InputError, Stopped
from guards import SAME_ANGLE, SAME_POSITION, Guards, Limits, Measurement, require_command
from interruption import Interruption, Watchdog
from journal import Journal, say
from kinematics import Pose
from motions import PEAK, straight
from settings import Settings, add_flags, header, settings

# Straight paths to the start have at most these speeds (m/s, rad/s) and lengths (m, rad).
APPROACH_SPEED, APPROACH_TURNING = 0.02, 0.1
LONGEST_APPROACH, LARGEST_APPROACH_TURN = 0.15, 0.5
# Before it is moved, the robot is measured for this time (s). Its tool then moves by no more than this (m), and feels no more than
# this (N): more is a wrong payload, or something touches.
REST_TIME, REST_MOTION, LARGEST_REST_FORCE = 0.2, 0.001, 30.0
# A tool that is held compliantly for this time (s) stays where it is (m, rad), or its payload is not what the robot carries.
HOLDING_TIME, LARGEST_SAG, LARGEST_TILT = 0.5, 0.002, 0.01
# The test of the frames: way along (m) and about (rad) each axis, time there and rest (s), smallest part of the way that must
# be seen, and smallest cosine between the way and what is seen.
TEST_WAY, TEST_TURN, TEST_TIME, TEST_REST = 0.01, 0.05, 0.8, 0.3
SEEN, ALIGNED = 0.25, 0.8
# Where nothing is known of the shapes of its links, no point of the arm may be this far (m) from where it is at the start: the arm
# would stand otherwise than planned.
FARTHEST_ARM = 0.3
# Rest after the end of the reference (s).
SETTLING_TIME = 1.0
# The whole session may take this many times as long as planned.
SLACK = 1.5

DONE, MISSED, WRONG_INPUT, FAILED, INTERRUPTED = 0, 1, 2, 3, 130


class Robot(Protocol):
    """What a player needs of a robot. Whatever goes wrong raises Stopped. Nothing moves it before `begin`."""

    def read(self) -> Measurement:
        """Waits for the next control period and measures."""

    def begin(self, hold: ToolState) -> None:
        """Enters the mode in which the tool is compliant, with this reference."""

    def track(self, reference: ToolState, measured: Measurement) -> None:
        """The reference for this control period."""

    def end(self) -> Iterable[None] | None:
        """Stops and leaves the mode, perhaps in steps. Called once if `begin` was, whatever happened."""

    def close(self) -> None:
        """Ends the connection. Called once, whatever happened."""


class Session:
    """One execution of a plan."""

    def __init__(
        self,
        plan: ExportedPlan,
        robot: Robot,
        chosen: Settings,
        journal: Journal,
        interruption: Interruption,
        watchdog: Watchdog,
    ) -> None:
        self.plan, self.robot, self.settings, self.journal = plan, robot, chosen, journal
        self.interruption, self.watchdog = interruption, watchdog
        self.is_begun = False
        # A dry run is shifted as a whole, away from the goal.
        self.shift = chosen.dry_run * plan.way_out() if chosen.dry_run else np.zeros(3)

    def execute(self) -> bool:
        """Plays the plan; returns whether the part is where it should be, as far as the robot can tell."""
        self.interruption.defer()
        try:
            measured = self.play()
        except BaseException as error:
            for problem in self.leave():
                error.add_note(f"while the robot was stopped: {problem}")
            raise
        for problem in self.leave():
            raise problem
        return self.judge(measured)

    def play(self) -> Measurement:
        """All that the robot does; returns the last measurement."""
        at_rest = self.rest()
        self.check_ready(at_rest)
        self.check_path(at_rest)
        self.check_arm(at_rest)
        self.is_begun = True
        self.robot.begin(ToolState.at_rest(at_rest.tool.pose))
        # Changing the mode takes its time.
        begun = dataclasses.replace(at_rest, time=self.read().time)
        self.guards = Guards(self.plan, begun, self.longest(at_rest))
        self.hold(at_rest.tool.pose)
        self.go_to_start(at_rest)
        if self.settings.self_test:
            self.test_frames()
        self.drive("playing", self.reference, self.plan.duration, self.settings.playing)
        return self.drive("resting", lambda _: self.reference(self.plan.duration), SETTLING_TIME, self.settings.playing)

    def leave(self) -> list[Exception]:
        """Stops the robot if it was begun with, and ends the connection; returns what goes wrong with that."""
        problems = []
        for step in (self.robot.end, self.robot.close) if self.is_begun else (self.robot.close,):
            self.watchdog.go_on()
            try:
                for _ in step() or ():
                    self.watchdog.go_on()
            except Exception as error:
                problems.append(error)
        if not problems:
            say("the robot was left at rest" if self.is_begun else "nothing was sent to the robot")
        return problems

    def read(self) -> Measurement:
        """The next measurement, of which nothing is missing."""
        self.watchdog.go_on()
        self.interruption.check()
        measured = self.robot.read()
        measured.require_whole(self.plan.arm)
        return measured

    def rest(self) -> Measurement:
        """The robot before it is moved: the newest measurement, with the mean of force and torque."""
        measured = [self.read()]
        while measured[-1].time < measured[0].time + REST_TIME:
            measured.append(self.read())
            if not measured[-1].time > measured[-2].time:
                raise Stopped("the time of the robot does not go on")
        first, last = measured[0], measured[-1]
        moved, _ = last.tool.pose.errors(first.tool.pose)
        if not moved <= REST_MOTION:
            raise InputError(f"the robot moves: by {1e3 * moved:.1f} mm within {REST_TIME:g} s; wait until it rests")
        force, torque = (np.mean([getattr(each, name) for each in measured], axis=0) for name in ("force", "torque"))
        return dataclasses.replace(last, force=force, torque=torque)

    def check_ready(self, measured: Measurement) -> None:
        """The robot is near the start, and its frames are those of the plan."""
        force = float(np.linalg.norm(measured.force))
        if not force <= LARGEST_REST_FORCE:
            raise InputError(f"the robot feels {force:.0f} N before it moves: set payload and sensor, and see that nothing touches")
        if self.plan.arm is not None:
            distance, angle = measured.tool.pose.errors(self.plan.arm.forward(measured.positions))
            if not (distance <= SAME_POSITION and angle <= SAME_ANGLE):
                raise InputError(
                    f"the tool is {1e3 * distance:.1f} mm and {angle:.3f} rad from where the URDF file has it with these joint "
                    "positions: tool point (TCP, end effector) or base of the robot are not those of the scene"
                )
        distance, angle = measured.tool.pose.errors(self.reference(0.0).pose)
        if not (distance <= LONGEST_APPROACH and angle <= LARGEST_APPROACH_TURN):
            raise InputError(
                f"the tool is {1e3 * distance:.0f} mm and {angle:.2f} rad from the start: move it there first{self.advice()}"
            )

    def check_path(self, measured: Measurement) -> None:
        """The path to the start, and the test of the frames there, are in free air: as far around the start as plan.json says."""
        free, radius = self.plan.free_around_start(self.settings.dry_run), self.plan.document["free"]["radius_m"]
        distance, angle = measured.tool.pose.errors(self.reference(0.0).pose)
        if not (self.settings.path_is_free or distance + radius * angle <= free):
            raise InputError(
                f"the tool is {1e3 * distance:.0f} mm and {angle:.2f} rad from the start, and only within {1e3 * free:.0f} mm of it "
                "the part is known to touch nothing: move it closer, or look at the path and say --path-is-free" + self.advice()
            )
        if self.settings.self_test and not TEST_WAY + radius * TEST_TURN <= free:
            raise InputError(
                f"the test of the frames needs {1e3 * (TEST_WAY + radius * TEST_TURN):.0f} mm around the start, and only "
                f"{1e3 * free:.0f} mm are known to be free: use --dry-run, or --skip-self-test"
            )

    def check_arm(self, measured: Measurement) -> None:
        """Links and gripper touch nothing on the path to the start and in the test of the frames, as far as plan.json knows them.
        A joint moves no point further than its change times its reach, which grows by as much as other joints move the point."""
        if self.plan.arm is None:
            return
        start = self.plan.arm_start(self.settings.dry_run)
        changes = np.abs(measured.positions - np.array(start["configuration"]))
        turned, is_known = float(changes.sum()), start["clearance_m"] is not None
        moved = float(changes @ np.array(start["reach_m"])) / (1 - turned) if turned < 1 else np.inf
        free = start["clearance_m"] if is_known else FARTHEST_ARM
        if not (self.settings.path_is_free or moved <= free):
            joint = int(np.argmax(changes))
            raise InputError(
                f"joint `{self.plan.arm.names[joint]}` is {changes[joint]:.2f} from where it is at the start, and on the path there a "
                f"point of the arm may move by {1e3 * min(moved, 9.999):.0f} mm, while links and gripper "
                + ("are known to touch nothing" if is_known else "of unknown shape may move")
                + f" within {1e3 * free:.0f} mm: move the joints closer, or look at the path and say --path-is-free{self.advice()}"
            )
        if self.settings.self_test and not start["test_is_free"]:
            raise InputError(
                "a link or the gripper may touch something in the test of the frames: use --dry-run, or --skip-self-test"
            )

    def advice(self) -> str:
        """Joint positions of the start."""
        if self.plan.arm is None:
            return ""
        joints = zip(self.plan.arm.names, self.plan.arm_start(self.settings.dry_run)["configuration"])
        return ", for example to " + ", ".join(f"{name} {position:.4f}" for name, position in joints)

    def hold(self, pose: Pose) -> None:
        """The compliant tool stays where it is."""
        measured = self.drive("holding", lambda _: ToolState.at_rest(pose), HOLDING_TIME, self.settings.approach)
        distance, angle = measured.tool.pose.errors(pose)
        if not (distance <= LARGEST_SAG and angle <= LARGEST_TILT):
            raise Stopped(
                f"held compliantly, the tool moved by {1e3 * distance:.1f} mm and {angle:.3f} rad: the payload that is set is not "
                "what the robot carries, or the force sensor is not zero"
            )

    def go_to_start(self, measured: Measurement) -> None:
        """Slowly and straight from where the tool is."""
        begin, end = measured.tool.pose, self.reference(0.0).pose
        duration = self.approach_time(measured)
        self.drive("going to the start", straight(begin, end, duration), duration + TEST_REST, self.settings.approach)

    def approach_time(self, measured: Measurement) -> float:
        """Time to the start (s)."""
        distance, angle = measured.tool.pose.errors(self.reference(0.0).pose)
        return max(PEAK * distance / APPROACH_SPEED, PEAK * angle / APPROACH_TURNING, TEST_REST)

    def test_frames(self) -> None:
        """Moves a little along and about each axis of the base and compares with what the robot says."""
        home, limits = self.reference(0.0).pose, self.settings.approach
        for index, name in enumerate(("along x", "along y", "along z", "about x", "about y", "about z")):
            way = np.zeros(6)
            way[index] = TEST_TURN if index >= 3 else TEST_WAY
            there = Pose(home.position + way[:3], rotations.of_vector(way[3:]) @ home.rotation)
            before = self.drive("resting before a test", lambda _: ToolState.at_rest(home), TEST_REST, limits).tool.pose
            phase = f"testing the frames: {name}"
            after = self.drive(phase, straight(home, there, TEST_TIME), TEST_TIME + TEST_REST, limits).tool.pose
            self.drive("going back", straight(there, home, TEST_TIME), TEST_TIME, limits)
            compare(name, way, before, after)

    def reference(self, time: float) -> ToolState:
        """The plan's reference, shifted in a dry run."""
        state = self.plan.reference(time)
        return dataclasses.replace(state, pose=Pose(state.pose.position + self.shift, state.pose.rotation))

    def drive(self, phase: str, motion: Callable[[float], ToolState], duration: float, limits: Limits) -> Measurement:
        """Follows a motion for a time (s) under guard; returns the last measurement."""
        in_free_air = self.settings.dry_run > 0 or limits is self.settings.approach
        measured = self.read()
        begin = measured.time
        self.journal.start(phase, begin)
        while True:
            reference = motion(measured.time - begin)
            self.journal.add(measured, reference)
            self.guards.check(measured, reference, limits, in_free_air)
            require_command("reference", [*reference.pose.position, *reference.velocity, *reference.angular_velocity])
            self.robot.track(reference, measured)
            if measured.time - begin >= duration:
                return measured
            measured = self.read()

    def longest(self, measured: Measurement) -> float:
        """Longest time of a session (s)."""
        approach = HOLDING_TIME + self.approach_time(measured) + 2 * TEST_REST
        test = 6 * (2 * TEST_TIME + 2 * TEST_REST)
        return SLACK * (approach + test + self.plan.duration + SETTLING_TIME)

    def judge(self, measured: Measurement) -> bool:
        """A part at its goal says how it sits in the gripper: the robot believes it beside the goal by the grasp error. An
        error that was not planned for means that the part is not at its goal."""
        if self.settings.dry_run:
            return self.judge_dry_run(measured)
        document = self.plan.document
        grasp_error = self.plan.goal.inverse() @ self.plan.part(measured.tool.pose)
        offset, turn = grasp_error.position, rotations.vector(grasp_error.rotation)
        in_words = ", ".join(f"{1e3 * number:.2f}" for number in offset)
        size, tolerance = float(np.linalg.norm(offset)), document["position_tolerance_m"] or 0.003
        angle, largest_angle = float(np.linalg.norm(turn)), document["turn_rad"] + document["angle_tolerance_rad"]
        if not (size <= document["delta_m"] + tolerance and angle <= largest_angle):
            say(
                f"the part is not at its goal: it would sit ({in_words}) mm and {angle:.3f} rad beside where the robot believes it, "
                f"more than the {1e3 * document['delta_m']:.2f} mm and {document['turn_rad']:.3f} rad of the plan"
            )
            return False
        say(f"if the part is at its goal, it sits ({in_words}) mm and {angle:.3f} rad beside where the robot believes it")
        return True

    def judge_dry_run(self, measured: Measurement) -> bool:
        """In free air, nothing but joint friction keeps the tool from the end of its reference."""
        distance, angle = measured.tool.pose.errors(self.reference(self.plan.duration).pose)
        limits = self.settings.approach
        is_there = distance <= limits.distance and angle <= limits.angle
        say(
            f"dry run: the tool ends {1e3 * distance:.1f} mm and {angle:.3f} rad from its reference"
            + ("" if is_there else f", more than {1e3 * limits.distance:.1f} mm or {limits.angle:.3f} rad: something holds it")
        )
        return is_there


def compare(name: str, way: np.ndarray, before: Pose, after: Pose) -> None:
    """Refuses to go on where the tool did not do what it was told. Joint friction may keep some of the way."""
    seen = np.concatenate([after.position - before.position, rotations.vector(after.rotation @ before.rotation.T)])
    part = slice(3, 6) if way[3:].any() else slice(0, 3)
    wanted, seen = way[part], seen[part]
    length = float(np.linalg.norm(seen))
    share = float(seen @ wanted) / float(wanted @ wanted)
    is_aligned = float(seen @ wanted) >= ALIGNED * length * float(np.linalg.norm(wanted))
    if not (share >= SEEN and is_aligned):
        unit, scale = ("rad", 1.0) if way[3:].any() else ("mm", 1e3)
        numbers = ", ".join(f"{scale * number:.3g}" for number in seen)
        is_stuck = length < SEEN * float(np.linalg.norm(wanted))
        cause = (
            "its joints stick, or its controller is softer than the plan: try a larger --stiffness-factor"
            if is_stuck
            else "the base of the robot is not that of the scene"
        )
        raise Stopped(f"told to move {scale * np.linalg.norm(wanted):g} {unit} {name} of its base, the tool moved ({numbers}) {unit}: {cause}")


def main(parser: argparse.ArgumentParser, connect: Callable[[argparse.Namespace, ExportedPlan, Settings], Robot]) -> int:
    """Plays the plan of this folder on the robot that `connect` makes; returns the exit code."""
    add_flags(parser)
    arguments = parser.parse_args()

    def play(interruption: Interruption) -> bool:
        plan = load(pathlib.Path(__file__).resolve().parent)
        chosen = settings(arguments, plan)
        for line in plan.warnings():
            say(f"warning: {line}")
        journal = Journal(plan, arguments.log, header(arguments, plan))

        def give_up(why: str) -> int:
            journal.close(why)
            say(f"stopped: {why}")
            return MISSED

        def run() -> bool:
            watchdog = Watchdog(give_up)
            try:
                robot = connect(arguments, plan, chosen)
                return Session(plan, robot, chosen, journal, interruption, watchdog).execute()
            finally:
                watchdog.rest()

        return keeping(journal, run)

    return exit_code(play)


def keeping(journal: Journal, run: Callable[[], bool]) -> bool:
    """Runs something and ends the log whatever happens, with what went wrong."""
    stopped = None
    try:
        return run()
    except BaseException as error:
        stopped = reason(error)
        raise
    finally:
        journal.close(stopped)


def exit_code(run: Callable[[Interruption], bool]) -> int:
    """Runs a program that returns whether it did what it should, and says what goes wrong; returns the exit code."""
    try:
        return DONE if run(Interruption()) else MISSED
    except KeyboardInterrupt as error:
        say(reason(error))
        return INTERRUPTED
    except InputError as error:
        say(f"error: {reason(error)}")
        return WRONG_INPUT
    except Stopped as error:
        say(f"stopped: {reason(error)}")
        return MISSED
    except Exception as error:
        # The robot was stopped as far as it still listens.
        say(f"error: {reason(error)}")
        return FAILED


def reason(error: BaseException) -> str:
    """Why a session ended early, in words, with what went wrong while it was ended."""
    is_ours = isinstance(error, KeyboardInterrupt | InputError | Stopped | OSError | RuntimeError)
    words = str(error) if is_ours else f"{type(error).__name__}: {error}"
    return "; ".join([words or "interrupted", *getattr(error, "__notes__", ())])
