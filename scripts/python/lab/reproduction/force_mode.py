"""Sec. clamp: the clamps, played by a UR10e in force mode in MuJoCo."""

from collections.abc import Callable, Collection

from lab import notebook
from lab.reproduction import force_plays, force_rollouts, force_scenes, paper, studies
from lab.reproduction.force_plays import DIRECTIONS, FRICTION, LAST, Play, Played
from lab.reproduction.page import Page

STUDIES = tuple(force_scenes.study(clamp) for clamp in force_scenes.CLAMPS)
# Half a step between two offsets (m): they are compared in floating point.
HALF_STEP = 5e-4

Plays = dict[Play, Played]

# Of the motions that were looked at, those of clamp1 without an offset.
EXPLANATION = """All but one of these end on top of the wall, 25 mm above the goal: the gap, 0.5 mm wider than the
wall, has passed the wall before the clamp sinks in. Of `clamp1` without an offset, the gap is open for 31 to 35 ms
(start 3, 2 and 3 mm) and 36 ms (start 1, 5 mm), at 14 to 17 mm/s; the lag of the robot is 19 ms. Where it is open for
50 ms or more (start 2) or one end of the clamp is 0.02 rad lower (start 1, 1 to 4 mm), the clamp sinks in. So a larger
delta-hat is not always safer: plans with a longer way across the wall cross it faster, at 12 mm/s for 1 mm and 17 mm/s
for 5 mm (start 2), and the one for 5 mm from start 1 is another optimum, which comes from the other side of the wall,
flat on it. Plans from other starts cross it in other ways, so rates differ from start to start."""
DIFFERENCES = """What differs from the paper: it is a simulation, and the same motion always ends alike; the motion
without an offset counts once for each plan. Clamps 2 and 3 are our own. Friction, gains and lag of the paper's robot
and its two offsets are not known. The homotopy begins with four times the paper's smoothing: with the paper's own, some
plans of `clamp1` for 4 mm and all for 5 mm miss the goal ([clamps.md](clamps.md))."""


def run(jobs: int, is_quick: bool) -> None:
    """Plans and plays what is missing."""
    for clamp in force_scenes.CLAMPS:
        studies.run(force_scenes.study(clamp), jobs, is_quick, force_scenes.write(clamp))
    force_rollouts.run(jobs, is_quick)
    force_plays.run(jobs, is_quick)


def share(plays: Collection[Played]) -> str:
    """Successes of how many."""
    successes = [played.success for played in plays]
    return f"{sum(successes)} of {len(successes)}" if successes else "-"


def rate(plays: Collection[Played]) -> str:
    """The same with percent."""
    successes = [played.success for played in plays]
    return f"{share(plays)}, {100 * sum(successes) / len(successes):.1f} %" if successes else "-"


def of(plays: Plays, is_wanted: Callable[[Play], bool]) -> list[Played]:
    """Some of the motions."""
    return [played for play, played in plays.items() if is_wanted(play)]


def grouped(plays: Plays, key: Callable[[Play], object]) -> dict[object, Plays]:
    """The motions by something that they have in common."""
    groups: dict[object, Plays] = {}
    for play, played in plays.items():
        groups.setdefault(key(play), {})[play] = played
    return groups


def margin(play: Play) -> float:
    """By how much the plan models larger offsets than the injected one (m)."""
    return play.delta - play.magnitude


def is_on_diagonal(play: Play) -> bool:
    """Whether the plan models exactly the injected magnitude."""
    return abs(margin(play)) < HALF_STEP


def is_in_triangle(play: Play) -> bool:
    """Whether the plan models at least 1 mm more than what is injected."""
    return margin(play) > HALF_STEP


def matrix(page: Page, plays: Plays, head: str, column: Callable[[Play], object]) -> None:
    """Successes by injected magnitude and something else."""
    cells = grouped(plays, lambda play: (play.magnitude, column(play)))
    columns = sorted({column(play) for play in plays})
    page.table(
        [head, *columns],
        (
            [f"{1e3 * magnitude:g} mm", *(share(cells.get((magnitude, wanted), {}).values()) for wanted in columns)]
            for magnitude in force_scenes.DELTAS
        ),
    )


def lines(plays: Plays) -> list[list[object]]:
    """Rates on the diagonal and below it, by clamp and by direction."""
    groups = {"all": plays} | grouped(plays, lambda play: play.clamp)
    groups |= grouped({play: plays[play] for play in plays if play.magnitude}, lambda play: play.direction)
    return [[name, rate(of(group, is_on_diagonal)), rate(of(group, is_in_triangle))] for name, group in groups.items()]


def failures(page: Page, plays: Plays) -> None:
    """Every motion of the triangle that misses the goal."""
    missed = {play: played for play, played in plays.items() if is_in_triangle(play) and not played.success}
    if not missed:
        return
    page.text("Motions of the triangle that miss the goal:")
    page.table(
        ["", "start", "delta-hat mm", "offset mm", "", "ends off, mm", "rad", "presses with, N"],
        (
            [
                play.clamp,
                play.start,
                f"{1e3 * play.delta:g}",
                f"{1e3 * play.magnitude:g}",
                play.direction,
                f"{1e3 * played.position_error:.2f}",
                f"{played.angle_error:.3f}",
                f"{played.force:.0f}",
            ]
            for play, played in sorted(missed.items(), key=lambda item: repr(item[0]))
        ),
    )
    page.text(EXPLANATION)


def counts(plays: Plays) -> str:
    """How many plans of each clamp were played."""
    plans = {(play.clamp, play.start, play.delta) for play in plays if play.iteration == LAST}
    return ", ".join(f"{sum(plan[0] == clamp for plan in plans)} plans of `{clamp}`" for clamp in force_scenes.CLAMPS)


def own_rollouts(page: Page) -> None:
    """The same in the program's own rollouts, with other frictions and beside a straight push."""
    page.heading("In the program's own rollouts")
    page.text(
        """The same plans and offsets in the rollouts of `simulate`, with a force mode as plans assume it and without an
        arm, and an unplanned straight push in the same time, with the same gains:"""
    )
    groups = {
        (friction, motion): group
        for motion, plays in force_rollouts.read().items()
        for friction, group in grouped(plays, lambda play: play.friction).items()
    }
    page.table(
        ["friction", "", "diagonal", "lower right triangle"],
        (
            [f"{friction:g}", motion, rate(of(group, is_on_diagonal)), rate(of(group, is_in_triangle))]
            for (friction, motion), group in sorted(groups.items())
        ),
    )


def largest_error() -> float:
    """Of all plans in the planner's model (mm)."""
    return max(cell.error_mm for _, cell in force_plays.finished())


def introduction(page: Page, plays: Plays) -> None:
    """What was planned and played."""
    gains, stiffness = force_scenes.FORCE_MODE, force_scenes.STIFFNESS
    inside, outside = (", ".join(f"{x:g}" for x in direction) for direction in DIRECTIONS.values())
    page.text(
        notebook.date(),
        f"""The plans are those of [clamps.md](clamps.md) for a robot in force mode
        ([position-robots.md](../../guide/position-robots.md#force-mode)): the scenes with the stiffness that the paper
        commands, {stiffness["translational_stiffness"]:g} N/m and {stiffness["rotational_stiffness"]:g} Nm/rad, a force
        mode of 1/{1 / gains["translational_gain"]:g} m/s per N and 1/{1 / gains["rotational_gain"]:g} rad/s per Nm, a
        contact stiffness of {force_scenes.CONTACT_STIFFNESS:g} N/m, and 1 kg with {force_scenes.INERTIA:g} kg m^2
        beyond the sensor. The paper names no gains of force mode; with these, damping and stiffness have the time
        constant of its plans, 0.2 s. Sigma is 15 times that of clamps.md, like the stiffness. Plain `solve`, eight
        homotopy iterations, of which the last six have the paper's tau.""",
        f"""A UR10e plays them in MuJoCo at a contact friction of {FRICTION:g}: its kinematics, joints that follow their
        commands with the lag of a servo (4 ms of delay, 20 Hz), a force mode that moves the tool by its gain for each
        newton between the commanded wrench, that of the impedance law, and the measured one, and the part on a spring
        of the contact stiffness. Injected are offsets of 0 to 5 mm of the part in the gripper along ({inside}), which
        is planned, and along ({outside}), outside of the hull of the planned ones. A success ends within 3 mm and 0.1
        rad of the goal, one second after the end of the motion. `scripts/lab reproduce force-mode` plans, plays and
        writes this page, for five starts of each clamp. Played so far: {counts(plays)}; tables say of how many
        motions. In the planner's model, all plans end within {largest_error():.2f} mm of the goal.""",
        DIFFERENCES,
    )


def iterations(page: Page, plays: Plays) -> None:
    """Success after each homotopy iteration, of the plans whose iterations were played."""
    page.heading("Homotopy iterations")
    largest = max(force_scenes.DELTAS)
    plans = {(play.clamp, play.start) for play in plays if play.iteration < LAST}
    shown = {
        play: played for play, played in plays.items() if play.delta == largest and (play.clamp, play.start) in plans
    }
    names = ", ".join(f"`{clamp}` from start {start}" for clamp, start in sorted(plans))
    page.text(
        f"""Plans for {1e3 * largest:g} mm after each of the paper's six iterations ({names}), successes by injected
        offset and iteration. The paper shows this in a figure without numbers: {paper.ITERATIONS}."""
    )
    matrix(page, shown, "injected", lambda play: play.iteration)


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    plays = force_plays.read()
    last = {play: played for play, played in plays.items() if play.iteration == LAST}
    introduction(page, plays)
    page.heading("Injected and modelled offset")
    page.text("All six iterations, successes by injected offset and delta-hat:")
    matrix(page, last, "injected", lambda play: f"{1e3 * play.delta:g} mm")
    page.text("On the diagonal, and in the lower right triangle, where delta-hat is at least 1 mm more:")
    page.table(["", "diagonal", "lower right triangle"], lines(last))
    page.text(f"The paper, with a real UR10e and 10 motions for each combination: {paper.FORCE_MODE}.")
    failures(page, last)
    iterations(page, plays)
    own_rollouts(page)
    return (
        f"{rate(of(last, is_in_triangle))} with a delta-hat at least 1 mm larger than the offset, "
        f"{rate(of(last, is_on_diagonal))} with the same"
    )
