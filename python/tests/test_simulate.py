"""Runs: what they give, and that others may go on meanwhile."""

import _thread
import pickle
import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import precess

finite = st.floats(allow_nan=False, allow_infinity=False)


def test_an_oscillator_is_its_closed_form() -> None:
    run = precess.simulate(
        "harmonic_oscillator",
        start={"x": 1, "x_dot": 0.5},
        parameters={"omega": 2},
        until=3,
        every=0.5,
        rtol=1e-13,
        atol=1e-13,
    )
    assert run.t.tolist() == [0, 0.5, 1, 1.5, 2, 2.5, 3]
    np.testing.assert_allclose(run["x"], np.cos(2 * run.t) + 0.25 * np.sin(2 * run.t), rtol=0, atol=1e-12)
    np.testing.assert_array_equal(run.state, np.column_stack([run.x, run.x_dot]))
    assert run.scenario.parameters["omega"] == 2
    assert run.drifts[0].name == "energy"
    assert 0 < (run.drifts[0].relative or 0) < 1e-12


def test_a_trajectory_is_read_only_and_tells_its_columns() -> None:
    run = precess.simulate("pendulum", until=1, every=0.25)
    assert [(c.name, c.unit, c.kind) for c in run.columns[:4]] == [
        ("t", "s", "time"),
        ("theta", "rad", "state"),
        ("theta_dot", "rad/s", "state"),
        ("energy", "J", "invariant"),
    ]
    assert len(run) == 5
    assert run.numbers.shape == (5, len(run.columns))
    with pytest.raises(ValueError, match="read-only"):
        run["theta"][0] = 1


def test_events_are_found_and_may_end_a_run() -> None:
    down = {"when": "theta = 0", "name": "down", "direction": "falling", "stop": True}
    run = precess.simulate(
        "pendulum", start={"theta": 0.001}, until=10, every=1, events=["theta_dot = -1e-9", down]
    )
    assert run.stopped_by == "down"
    assert run.events[-1].name == "down"
    # A quarter of the period of small swings.
    quarter = np.pi / 2 * np.sqrt(run.scenario.parameters["l"] / run.scenario.parameters["g"])
    assert run.events[-1].t == pytest.approx(quarter, rel=1e-6)
    assert abs(run.events[-1].state["theta"]) < 1e-12


def test_values_are_written_as_on_the_command_line() -> None:
    text = precess.Scenario("pendulum", start={"theta": "30 deg"}, parameters={"l": "1/2"}, until="1 min")
    numbers = precess.Scenario(
        "pendulum", start={"theta": text.start["theta"]}, parameters={"l": np.float64(0.5)}, until=60
    )
    assert text == numbers
    assert text.start["theta"] == pytest.approx(np.pi / 6, rel=1e-15)
    bodies = precess.Scenario("n_body", parameters={"masses": np.array([45, 1, 0.01])})
    assert bodies == precess.Scenario("n_body", parameters={"masses": "[45; 1; 0.01]"})
    assert bodies.parameters["masses"] == [45, 1, 0.01]


@settings(max_examples=50, deadline=None)
@given(finite, finite)
def test_a_scenario_survives_its_file_and_a_pickle(theta: float, theta_dot: float) -> None:
    scenario = precess.Scenario("pendulum", start={"theta": theta, "theta_dot": theta_dot})
    for copy in (precess.Scenario.parse(scenario.toml), pickle.loads(pickle.dumps(scenario))):
        assert copy == scenario
        assert np.array(list(copy.start.values())).tobytes() == np.array([theta, theta_dot]).tobytes()


def test_another_method_keeps_what_it_understands() -> None:
    first = precess.Scenario("pendulum", method="rk4", dt=0.01, until=5)
    second = first.replace(method="dop853", start={"theta": 0.5})
    assert second.step == {"rtol": 1e-10, "atol": 1e-10}
    assert (second.until, second.start["theta"]) == (5, 0.5)
    assert precess.simulate(first, method="dop853", start={"theta": 0.5}).hash() == second.simulate().hash()


def test_scenarios_that_come_with_the_program_run() -> None:
    run = precess.simulate("cone.toml", until=0.1)
    assert run.scenario.system.id == "gyroscope"
    assert "cone.toml" in precess.scenarios


def test_a_run_that_fails_keeps_its_samples() -> None:
    with pytest.raises(precess.RunError, match="no longer finite") as caught:
        precess.simulate(
            "magnetic_pendulum", start={"x": 1e308, "x_dot": 1e308}, method="rk4", dt=0.5, until=10
        )
    assert caught.value.trajectory.t[0] == 0
    assert caught.value.trajectory.t[-1] < 10


def test_ctrl_c_ends_a_run_that_goes_on_without_the_gil() -> None:
    # The other thread gets the GIL only because the run has let go of it.
    interrupter = threading.Thread(target=_thread.interrupt_main)

    def begun(_: float) -> None:
        if interrupter.ident is None:
            interrupter.start()

    with pytest.raises(KeyboardInterrupt):
        precess.simulate("pendulum", until=1e9, every=1e9, progress=begun)
    interrupter.join()


def test_progress_is_told_and_its_mistakes_come_back() -> None:
    def fails(t: float) -> None:
        raise LookupError(f"at {t > 0}")

    with pytest.raises(LookupError, match="at True"):
        precess.simulate("pendulum", until=1e9, every=1e9, progress=fails)
    with pytest.raises(LookupError, match="at True"):
        precess.ensemble("pendulum", {"theta": np.linspace(0, 1, 100_000)}, until=1e3, progress=fails)
