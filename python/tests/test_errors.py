"""Bad input: an exception of the right type, one sentence, the nearest right thing."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import precess

WRONG: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"system": "pendulun"}, precess.InputError, "no system 'pendulun': did you mean 'pendulum'?"),
    ({"start": {"teta": 1}}, precess.InputError, "no start of pendulum 'teta': did you mean 'theta'?"),
    ({"parameters": {"lenght": 1}}, precess.InputError, "no parameter of pendulum 'lenght'"),
    ({"method": "dop835"}, precess.InputError, "no method 'dop835': did you mean 'dop853'?"),
    ({"untill": 1}, TypeError, "no keyword argument of simulate 'untill': did you mean 'until'?"),
    ({"start": {"theta": np.nan}}, precess.InputError, "theta: NaN is not a finite number"),
    (
        {"start": {"theta": "30 kg"}},
        precess.InputError,
        "theta: a value in rad is needed here, not one in kg",
    ),
    (
        {"start": {"theta": None}},
        TypeError,
        "theta: a number, a text such as '30 deg' or a list is needed, not NoneType",
    ),
    ({"start": {"theta": True}}, TypeError, "not bool"),
    ({"start": {"theta": {"a": 1}}}, TypeError, "not dict"),
    ({"start": {"theta": [1, 2]}}, precess.InputError, "theta: a number is needed here"),
    ({"method": 3}, TypeError, "method: a text is needed, not int"),
    ({"events": 3}, TypeError, "events: crossings such as 'theta = 0' are needed, not int"),
    ({"events": [3]}, TypeError, "events: a text or a dictionary is needed, not int"),
    ({"events": [{"when": 3}]}, TypeError, "when of an event: a text is needed, not int"),
    ({"start": {"theta": 1j}}, TypeError, "not complex"),
    ({"start": {1: 2}}, TypeError, "a name is a text"),
    ({"start": [1, 2]}, TypeError, "start is a dictionary from names to values, not list"),
    ({"parameters": {"l": -1}}, precess.InputError, "l: must be above 0, not -1"),
    ({"until": np.inf}, precess.InputError, "until: inf is not a finite number"),
    ({"every": 0}, precess.InputError, "every must be above zero, not 0"),
    ({"dt": 0.1}, precess.InputError, "method 'dop853' chooses its own steps: give rtol and atol, not dt"),
    ({"options": {"alpha": 1}}, precess.InputError, "no setting 'alpha'"),
    ({"events": "theta = "}, precess.InputError, "is no value"),
    (
        {"events": [{"wen": "theta = 0"}]},
        precess.InputError,
        "no key of an event 'wen': did you mean 'when'?",
    ),
    ({"events": [{"name": "a"}]}, precess.InputError, "needs a crossing to watch"),
    (
        {"events": [{"when": "theta = 0", "direction": "raising"}]},
        precess.InputError,
        "did you mean 'rising'?",
    ),
]


@pytest.mark.parametrize(("wrong", "kind", "sentence"), WRONG)
def test_one_clear_sentence(wrong: dict[str, Any], kind: type[Exception], sentence: str) -> None:
    with pytest.raises(kind) as caught:
        precess.simulate(**({"system": "pendulum"} | wrong))
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


def test_input_errors_are_value_errors_and_names_are_looked_up() -> None:
    assert issubclass(precess.InputError, ValueError)
    assert issubclass(precess.RunError, RuntimeError)
    with pytest.raises(KeyError) as caught:
        precess.systems["gyroskope"]
    assert str(caught.value) == "no system 'gyroskope': did you mean 'gyroscope'?"
    with pytest.raises(AttributeError, match="did you mean 'rk4'"):
        precess.methods.rk5  # noqa: B018
    assert not hasattr(precess.systems, "nothing")
    run = precess.simulate("pendulum", until=1, every=0.5)
    with pytest.raises(KeyError, match="did you mean 'theta'"):
        run["thetaa"]
    with pytest.raises(AttributeError, match="no column of pendulum"):
        run.momentum  # noqa: B018


def test_a_system_is_not_a_number() -> None:
    with pytest.raises(TypeError, match="a system is given by its id, not by int"):
        precess.simulate(3)  # type: ignore[arg-type]


def test_a_scenario_file_says_where(tmp_path: Any) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text('precess = 1\n[system]\nid = "pendulum"\n[start]\nthetta = 1\n', encoding="utf-8")
    with pytest.raises(
        precess.InputError, match=r"wrong.toml: no start of pendulum 'thetta': did you mean 'theta'"
    ):
        precess.simulate(file)
    with pytest.raises(FileNotFoundError):
        precess.simulate("nowhere.toml")


@settings(max_examples=100, deadline=None)
@given(st.text(max_size=80))
def test_no_text_is_worse_than_a_sentence(text: str) -> None:
    try:
        precess.Scenario("pendulum", start={"theta": text})
    except precess.InputError as error:
        assert str(error).startswith("theta")  # noqa: PT017
    if text not in precess.systems:
        with pytest.raises(precess.InputError, match="no system"):
            precess.Scenario(text)


PENDULUM = precess.systems.pendulum
NONE: Any = [None]
HALF: Any = (0, 1, 2.5)
TWO = {"t": [0.0, 1.0, 2.0], "theta": [1.0, 2.0, 3.0]}
ASKED: list[tuple[Callable[[], object], type[Exception], str]] = [
    (
        lambda: PENDULUM.rhs(0, [[1, 2]]),
        precess.InputError,
        "y: an array of one dimension is needed, not of 2",
    ),
    (lambda: PENDULUM.rhs(0, [1j, 2]), TypeError, "y: an array of numbers is needed, not of complex128"),
    (lambda: PENDULUM.jacobian(0, ["a", "b"]), TypeError, "y: an array of numbers is needed, not of texts"),
    (lambda: precess.ensemble("pendulum", {"theta": NONE}), TypeError, "not of NoneType"),
    (lambda: precess.ensemble("pendulum", {"theta": [True]}), TypeError, "not of bool"),
    (
        lambda: precess.ensemble("pendulum", {"theta": [[1], [1, 2]]}),
        TypeError,
        "an array of numbers is needed",
    ),
    (lambda: precess.ensemble("pendulum", {"theta": [1.0]}, threads=-2), precess.InputError, "at least one"),
    (
        lambda: precess.ensemble("n_body", {"masses": [1.0]}),
        precess.InputError,
        "no start or numeric parameter",
    ),
    (
        lambda: precess.basins("duffing", {"x": HALF}),
        TypeError,
        "x, how many: a whole number is needed",
    ),
    (lambda: precess.basins("duffing", {"x": (np.nan, 1, 2)}), precess.InputError, "x cannot start at NaN"),
    (lambda: precess.portrait("duffing", {"x": 1}), TypeError, "window x: a lowest and a highest value"),  # type: ignore[dict-item]
    (lambda: precess.poincare("pendulum", 3), TypeError, "section: a text is needed, not int"),  # type: ignore[arg-type]
    (lambda: precess.sensitivity("pendulum", 3), TypeError, "along: a name or a list of names"),  # type: ignore[arg-type]
    (lambda: precess.fit("pendulum", TWO, free=3), TypeError, "free: a name or a list of names"),  # type: ignore[arg-type]
    (
        lambda: precess.fit("pendulum", TWO, free="l", uncertainties={"theta": "a"}),  # type: ignore[dict-item]
        TypeError,
        "uncertainty of theta: a number is needed, not 'a'",
    ),
    (lambda: precess.Scenario.parse(3), TypeError, "toml: a text is needed, not int"),  # type: ignore[arg-type]
    (
        lambda: precess.floquet("parametric_oscillator", {"h": (0, 1)}),  # type: ignore[dict-item]
        TypeError,
        "h: first value, last value and number of values are needed",
    ),
]


@pytest.mark.parametrize(("ask", "kind", "sentence"), ASKED)
def test_every_question_says_what_it_needs(
    ask: Callable[[], object], kind: type[Exception], sentence: str
) -> None:
    with pytest.raises(kind) as caught:
        ask()
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


numbers = st.floats(width=64) | st.integers(-(10**20), 10**20) | st.none() | st.text(max_size=3)


@settings(max_examples=100, deadline=None)
@given(st.lists(numbers, max_size=4), st.sampled_from(["theta", "l", "b"]))
def test_an_ensemble_takes_finite_numbers_and_refuses_the_rest(values: list[Any], name: str) -> None:
    def run() -> precess.Ensemble:
        return precess.ensemble("pendulum", {name: values}, until=0.01, method="rk4", dt=0.01)

    if not all(type(x) in (int, float) for x in values):
        with pytest.raises(TypeError, match="an array of numbers is needed"):
            run()
    elif (
        not values
        or not np.isfinite(np.array(values, dtype=float)).all()
        or (name == "l" and min(values) <= 0)
    ):
        with pytest.raises(precess.InputError):
            run()
    else:
        assert run()["theta"].shape == (len(values),)


@settings(max_examples=50, deadline=None)
@given(
    st.lists(st.floats(width=64), min_size=1, max_size=6),
    st.lists(st.floats(width=64), min_size=1, max_size=6),
)
def test_a_fit_of_anything_ends_in_a_fit_or_a_sentence(times: list[float], values: list[float]) -> None:
    # A time far away is a long run, which is not what is tried here.
    times = [t if not np.isfinite(t) or abs(t) < 5 else t % 5 for t in times]
    try:
        found = precess.fit("pendulum", {"t": times, "theta": values}, free=["theta"])
    except (precess.InputError, precess.RunError) as error:
        assert str(error).isprintable()  # noqa: PT017
    else:
        assert np.isfinite(found.values["theta"])


FUNCTIONS = [
    precess.basins, precess.bifurcation, precess.ensemble, precess.fit, precess.floquet, precess.frenet,
    precess.lyapunov, precess.lyapunov_sweep, precess.poincare, precess.portrait, precess.response, precess.scene,
    precess.sensitivity, precess.simulate,
]  # fmt: skip


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_function_knows_the_settings_and_tells_the_nearest(function: Callable[..., object]) -> None:
    where = re.escape(function.__name__)
    with pytest.raises(TypeError, match=f"no keyword argument of {where} 'rtoll': did you mean 'rtol'"):
        function("pendulum", rtoll=1e-3)
