"""Events, interrupts, and what other threads do meanwhile."""

import dataclasses
import os
import re
import signal
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from assembly_plan import Plan, Scene, events
from conftest import PEG, ROOT


@pytest.fixture(scope="module")
def peg() -> Scene:
    return Scene.load(PEG)


def interrupted(work: Callable[[events.Progress], object]) -> list[events.Event]:
    """What is heard of work that Ctrl-C interrupts as soon as it tells of something."""
    heard: list[events.Event] = []
    has_begun = threading.Event()

    def listen(event: events.Event) -> None:
        heard.append(event)
        has_begun.set()

    def send() -> None:
        has_begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    # Where the tests run in the background, Ctrl-C is ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    sender = threading.Thread(target=send)
    sender.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work(listen)
    finally:
        has_begun.set()
        sender.join()
        signal.signal(signal.SIGINT, before)
    return heard


def test_every_event_has_a_class_with_its_fields() -> None:
    source = (ROOT / "crates/plan/src/event_record.rs").read_text()
    records = re.findall(r'"(\w+)",\s*json!\(\{(.*?)\}\)', source, re.DOTALL)
    assert len(records) == len(events._CLASSES) == 13
    for name, fields in records:
        declared = [field.name for field in dataclasses.fields(events._CLASSES[name])]  # type: ignore[arg-type]
        assert re.findall(r'"(\w+)":', fields) == declared, name


def test_events_tell_what_happens(scene: Scene) -> None:
    heard: list[events.Event] = []
    plan = scene.solve(progress=heard.append)
    finished = [event for event in heard if isinstance(event, events.HomotopyStep)]
    assert [event.number for event in finished] == list(range(1, len(plan.result["stages"]) + 1))
    assert [event.record for event in finished] == plan.result["stages"]
    iterations = [event for event in heard if isinstance(event, events.SolverIteration)]
    assert len(iterations) >= plan.result["iterations"]
    refined: list[events.Event] = []
    plan = scene.solve_robust(friction=[0.0], progress=refined.append)
    assert any(isinstance(event, events.Evaluated) for event in refined)
    last: list[events.Event] = []
    scene.simulate(plan, random=200, progress=last.append)
    assert last[-1] == events.Rollouts(done=400, count=400)


def test_an_exception_of_the_listener_ends_the_work(peg: Scene) -> None:
    heard: list[events.Event] = []

    def refuse(event: events.Event) -> None:
        heard.append(event)
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        peg.solve(progress=refuse)
    assert len(heard) == 1


def test_ctrl_c_ends_a_solve_and_leaves_no_plan(peg: Scene, tmp_path: Path) -> None:
    out = tmp_path / "plan"
    heard = interrupted(lambda progress: peg.solve(out=out, progress=progress))
    assert not any(isinstance(event, events.HomotopyStep) for event in heard)
    assert not out.exists()


def test_ctrl_c_ends_a_simulation(scene: Scene, plan: Plan) -> None:
    last = interrupted(lambda progress: scene.simulate(plan, random=100_000, progress=progress))[-1]
    assert isinstance(last, events.Rollouts) and last.done < last.count


def test_an_interrupted_solve_is_resumed(scene: Scene, plan: Plan, tmp_path: Path) -> None:
    out = tmp_path / "plan"

    def stop(event: events.Event) -> None:
        if isinstance(event, events.SolverIteration) and event.homotopy_step == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        scene.solve(out=out, progress=stop)
    assert not out.exists()
    heard: list[events.Event] = []
    resumed = scene.solve(out=out, resume=True, progress=heard.append)
    assert heard[0] == events.Resumed(done=2, most=heard[0].most, refining=False)  # type: ignore[union-attr]
    assert np.array_equal(resumed.reference, plan.reference)


def test_other_threads_go_on(scene: Scene) -> None:
    ticks = 0
    is_over = threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not is_over.wait(0.001):
            ticks += 1

    seen: list[int] = []
    thread = threading.Thread(target=tick)
    thread.start()
    scene.solve(jobs=1, progress=lambda event: seen.append(ticks))
    is_over.set()
    thread.join()
    assert seen[-1] > seen[0]


def test_plans_are_made_side_by_side(scene: Scene, plan: Plan) -> None:
    made: list[Plan] = []
    threads = [threading.Thread(target=lambda: made.append(scene.solve(jobs=1))) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(made) == 3
    assert all(np.array_equal(other.reference, plan.reference) for other in made)
