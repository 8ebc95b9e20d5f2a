"""Bad input: an exception of the right type, one sentence, the nearest right thing."""

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
