"""Sec. clamp: the clamps, played by a UR10e in force mode in MuJoCo."""

from collections.abc import Callable, Iterable

from lab import notebook
from lab.reproduction import force_plays, force_scenes, paper, studies
from lab.reproduction.force_plays import DIRECTIONS, FRICTION, LAST, MORE_FRICTION, Play, Played
from lab.reproduction.page import Page

STUDIES = tuple(force_scenes.study(clamp) for clamp in force_scenes.CLAMPS)
# Half a step between two offsets (m): they are compared in floating point.
HALF_STEP = 5e-4

Plays = dict[Play, Played]


def run(jobs: int, is_quick: bool) -> None:
    """Plans and plays what is missing."""
    for clamp in force_scenes.CLAMPS:
        studies.run(force_scenes.study(clamp), jobs, is_quick, force_scenes.write(clamp))
    force_plays.run(jobs, is_quick)


def share(plays: Iterable[Played]) -> str:
    """Successes of how many."""
    successes = [played.success for played in plays]
    return f"{sum(successes)} of {len(successes)}" if successes else "-"


def rate(plays: Iterable[Played]) -> str:
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
    """Whether the plan models exactly the injected magnitude; without any offset there is nothing to model."""
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
        ["", "start", "delta-hat mm", "offset mm", "", "friction", "ends off, mm", "rad", "presses with, N"],
        (
            [
                play.clamp,
                play.start,
                f"{1e3 * play.delta:g}",
                f"{1e3 * play.magnitude:g}",
                play.direction,
                f"{play.friction:g}",
                f"{1e3 * played.position_error:.2f}",
                f"{played.angle_error:.3f}",
                f"{played.force:.0f}",
            ]
            for play, played in sorted(missed.items(), key=lambda item: repr(item[0]))
        ),
    )


def counts(plays: Plays) -> str:
    """How many plans of each clamp were played."""
    plans = {(play.clamp, play.start, play.delta) for play in plays if play.iteration == LAST}
    return ", ".join(f"{sum(plan[0] == clamp for plan in plans)} of `{clamp}`" for clamp in force_scenes.CLAMPS)


def render(page: Page) -> str:
    """Writes the page; the result in a sentence."""
    plays = force_plays.read()
    last = {
        friction: {
            play: played for play, played in plays.items() if play.iteration == LAST and play.friction == friction
        }
        for friction in (FRICTION, MORE_FRICTION)
    }
    gains = force_scenes.FORCE_MODE
    page.text(
        notebook.date(),
        f"""The plans are those of [clamps.md](clamps.md) for a robot in force mode
        ([position-robots.md](../../guide/position-robots.md#force-mode)): the scenes with the stiffness of the paper's
        robot, {force_scenes.STIFFNESS["translational_stiffness"]:g} N/m and
        {force_scenes.STIFFNESS["rotational_stiffness"]:g} Nm/rad, a force mode of 1/{1 / gains["translational_gain"]:g}
        m/s per N and 1/{1 / gains["rotational_gain"]:g} rad/s per Nm, a contact stiffness of
        {force_scenes.CONTACT_STIFFNESS:g} N/m, and 1 kg with {force_scenes.INERTIA:g} kg m^2 beyond the sensor. The
        paper names no gains of force mode; with these, the time constant of damping and stiffness is that of its plans,
        0.2 s. The first sigma is 15 times that of clamps.md, like the stiffness. Plain `solve`, eight homotopy
        iterations, of which the last six have the paper's tau.""",
        f"""A UR10e plays them in MuJoCo: its kinematics, joints that follow their commands with the lag of a servo
        ({1e3 * 0.004:g} ms of delay, 20 Hz), a force mode that moves the tool by its gain for each newton between the
        commanded wrench and the measured one, within the speeds of `[robot.command]`, and the part on a spring of the
        contact stiffness. The commanded wrench is that of the impedance law. Injected are offsets of 0 to 5 mm of the
        part in the gripper along ({", ".join(f"{x:g}" for x in DIRECTIONS["in distribution"])}), which is planned, and
        along ({", ".join(f"{x:g}" for x in DIRECTIONS["out of distribution"])}), which lies outside of the hull of the
        planned ones. A success ends within 3 mm and 0.1 rad of the goal, one second after the end of the motion.
        `scripts/lab reproduce force-mode` plans, plays and writes this page. Played are the plans {counts(plays)}, of
        30 each.""",
    )
    page.heading("Injected and modelled offset")
    for friction, shown in last.items():
        if shown:
            page.text(f"All six iterations, friction {friction:g}, successes by injected offset and delta-hat:")
            matrix(page, shown, "injected", lambda play: f"{1e3 * play.delta:g} mm")
    page.text("On the diagonal, and in the lower right triangle, where delta-hat is at least 1 mm more:")
    for friction, shown in last.items():
        if shown:
            page.table([f"friction {friction:g}", "diagonal", "lower right triangle"], lines(shown))
    page.text(f"The paper, with a real UR10e and 10 motions for each combination: {paper.FORCE_MODE}.")
    for shown in last.values():
        failures(page, shown)
    page.heading("Homotopy iterations")
    largest = max(force_scenes.DELTAS)
    by_iteration = {
        play: played for play, played in plays.items() if play.delta == largest and play.friction == FRICTION
    }
    starts = {(play.clamp, play.start) for play in by_iteration if play.iteration < LAST}
    by_iteration = {play: played for play, played in by_iteration.items() if (play.clamp, play.start) in starts}
    page.text(
        f"""Plans for {1e3 * largest:g} mm after each of the paper's six iterations, friction {FRICTION:g}, successes by
        injected offset and iteration. The paper gives this figure not as numbers: {paper.ITERATIONS}."""
    )
    matrix(page, by_iteration, "injected", lambda play: play.iteration)
    triangle = of(last[FRICTION], is_in_triangle)
    diagonal = of(last[FRICTION], lambda play: is_on_diagonal(play) and play.magnitude > HALF_STEP)
    return f"{rate(triangle)} with delta-hat at least 1 mm more than the offset; {rate(diagonal)} with the same"
