"""A run as a moving picture in a notebook: what it holds, that it updates in place, what it refuses."""

import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import precess
from precess._places import places

PAGE = Path(precess.__file__).parent / "_scene.js"


def column(shown: Any, number: int) -> Any:
    numbers = np.frombuffer(shown.run["numbers"], dtype="<f8").reshape(-1, shown.run["samples"])
    assert len(numbers) == len(shown.run["columns"])
    return numbers[number]


def test_the_page_is_given_the_run() -> None:
    shown = precess.scene("pendulum", start={"theta": 0.5}, parameters={"l": 2}, until=6, every=0.05)
    run = precess.simulate("pendulum", start={"theta": 0.5}, parameters={"l": 2}, until=6, every=0.05)
    assert shown.trajectory.hash() == run.hash()
    assert column(shown, 1).tobytes() == run.theta.tobytes()
    (bob,) = shown.run["scene"]["bodies"]
    np.testing.assert_array_equal(column(shown, bob[0]), 2 * np.sin(run.theta))
    assert shown.run["scene"]["rods"] == [(-1, 0)]
    assert [graph["y_label"] for graph in shown.run["graphs"]] == ["theta [rad]", "theta_dot [rad/s]"]
    # What a notebook sends to its page when the widget is shown: the page's own code goes with it.
    state = shown.get_state()
    assert "export default { render }" in state["_esm"]
    assert ".precess" in state["_css"]


def test_rods_keep_their_lengths_and_axes_stay_on_the_sphere() -> None:
    for name, far in (("double_pendulum", 1.0), ("n_pendulum", 1.0), ("spherical_pendulum", 1.0)):
        there = places(precess.simulate(name, until=2))
        assert there is not None
        for a, b in there.rods:
            start = there.bodies[a] if a >= 0 else tuple(np.zeros_like(x) for x in there.bodies[b])
            length = np.sqrt(sum((x - y) ** 2 for x, y in zip(start, there.bodies[b], strict=True)))
            np.testing.assert_allclose(length, far, rtol=0, atol=1e-12)
    for name in ("gyroscope", "rolling_body", "free_body"):
        there = places(precess.simulate(name, until=0.1))
        assert there is not None
        np.testing.assert_allclose(sum(x * x for x in there.bodies[0]), 1, rtol=0, atol=1e-9)


def test_every_system_can_be_shown() -> None:
    for system in precess.systems.values():
        shown = precess.scene(system, until=precess.Scenario(system).every)
        count = len(shown.run["columns"])
        assert shown.run["graphs"], system.id
        for graph in shown.run["graphs"]:
            assert max([graph["x"], *graph["y"]]) < count
        for body in (shown.run["scene"] or {"bodies": []})["bodies"]:
            assert max(body) < count


def test_it_updates_in_place() -> None:
    shown = precess.scene("pendulum", until=6, every=0.1, sliders={"l": (0.2, 2), "theta": (-3, 3)})
    assert [slider["unit"] for slider in shown.sliders] == ["m", "rad"]
    heard: list[str] = []
    shown.observe(lambda change: heard.append(change["name"]), names=["run", "sliders"])
    shown.update(parameters={"l": 0.5}, until=8)
    assert shown.scenario.parameters["l"] == 0.5
    assert shown.trajectory.t[-1] == 8
    assert shown.sliders[0]["value"] == 0.5
    assert heard == ["run", "sliders"]
    # A person moves a slider: the page sets the wish.
    shown.wish = {"theta": 2.0}
    assert shown.trajectory.theta[0] == 2
    assert shown.scenario.parameters["l"] == 0.5
    assert column(shown, 1)[0] == 2
    # One that cannot be is a sentence on the page, and the picture stays.
    shown.wish = {"l": -1.0}
    assert "l: must be above 0" in shown.problem
    assert shown.scenario.parameters["l"] == 0.5
    shown.wish = {"l": 1.5}
    assert shown.problem == ""
    assert shown.scenario.parameters["l"] == 1.5
    with pytest.raises(precess.InputError, match="l: must be above 0"):
        shown.update(parameters={"l": -1})


def test_a_long_run_is_thinned() -> None:
    run = precess.simulate("harmonic_oscillator", until=1000, every=0.02)
    shown = precess.scene(run)
    assert 4000 < shown.run["samples"] <= 5001
    assert shown.speed > 50
    assert shown.trajectory is run


@pytest.mark.parametrize(
    ("sliders", "kind", "sentence"),
    [
        ({"lenght": (0, 1)}, precess.InputError, "no start or numeric parameter of pendulum 'lenght'"),
        ({"l": (2, 1)}, precess.InputError, "sliders l: 2 is not below 1"),
        ({"l": (0, np.inf)}, precess.InputError, "sliders l: 0 is not below inf"),
        ({"l": 3}, TypeError, "sliders l: a lowest and a highest number are needed"),
        (["l"], TypeError, "sliders is a dictionary"),
    ],
)
def test_sliders_that_make_no_sense_are_refused(sliders: Any, kind: type[Exception], sentence: str) -> None:
    with pytest.raises(kind, match=sentence):
        precess.scene("pendulum", until=1, sliders=sliders)


def test_a_keyword_that_is_none_is_refused() -> None:
    with pytest.raises(TypeError, match="no keyword argument of scene 'slider': did you mean 'sliders'"):
        precess.scene("pendulum", slider={})  # type: ignore[call-arg]


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js")
def test_the_page_can_be_read() -> None:
    subprocess.run(["node", "--check", "--input-type=module"], input=PAGE.read_bytes(), check=True)  # noqa: S607
