"""Fits: what they find, how well they say they know it, and what they refuse."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import precess

TRUTH = {"theta": 0.6, "l": 0.8}
GUESS = precess.Scenario("pendulum", start={"theta": 0.5}, parameters={"l": 1.0}, rtol=1e-8, atol=1e-8)
NOISE = 0.02


@pytest.fixture(scope="module")
def clean() -> precess.Trajectory:
    return precess.simulate("pendulum", start={"theta": 0.6}, parameters={"l": 0.8}, until=4, every=0.2)


def test_the_truth_lies_within_the_stated_uncertainty(clean: precess.Trajectory) -> None:
    seeds = 200
    inside = dict.fromkeys(TRUTH, 0)
    for seed in range(seeds):
        noisy = clean.theta + np.random.default_rng(seed).normal(0, NOISE, len(clean))
        found = precess.fit(GUESS, {"t": clean.t, "theta": noisy}, free=list(TRUTH))
        for name, wanted in TRUTH.items():
            low, high = found.intervals[name]
            inside[name] += low < wanted < high
    # 95 % are meant; the binomial scatter of 200 is 1.5 %.
    for share in inside.values():
        assert 0.90 <= share / seeds <= 0.995


def test_every_kind_of_table_gives_the_same_fit(clean: precess.Trajectory, tmp_path: Path) -> None:
    noisy = clean.theta + np.random.default_rng(0).normal(0, NOISE, len(clean))
    table = pd.DataFrame({"theta": noisy}, index=pd.Index(clean.t, name="t"))
    dataset = clean.to_xarray()[["theta"]]
    dataset["theta"] = ("t", noisy)
    plain, french = tmp_path / "plain.csv", tmp_path / "french.csv"
    rows = [f"{t!r},{x!r}" for t, x in zip(clean.t.tolist(), noisy.tolist(), strict=True)]
    plain.write_text("\n".join(["t [s],theta [rad]", *rows]), encoding="utf-8")
    french.write_text(
        "\n".join(["t;theta", *(row.replace(",", ";").replace(".", ",") for row in rows)]), encoding="utf-8"
    )
    first = precess.fit(GUESS, {"t": clean.t, "theta": noisy}, free=["theta", "l"])
    for data in (table, table.reset_index(), dataset, plain, str(french)):
        assert precess.fit(GUESS, data, free=["theta", "l"]).values == first.values


def test_a_fit_tells_all_it_knows(clean: precess.Trajectory) -> None:
    noisy = clean.theta + np.random.default_rng(3).normal(0, NOISE, len(clean))
    found = precess.fit(
        GUESS, {"t": clean.t, "theta": noisy}, free=["theta", "l"], uncertainties={"theta": NOISE}
    )
    assert found.freedom == 19
    assert 5 < found.chi2 < 40
    assert found.correlation.shape == (2, 2)
    np.testing.assert_allclose(np.diag(found.correlation), 1, rtol=1e-12)
    assert found.units["l"] == "m"
    assert found.scenario.parameters["l"] == found.values["l"]
    assert found.simulate().theta[0] == found.values["theta"]
    (axes,) = found.plot().axes
    assert len(axes.lines) == 2
    assert "l = 0.79" in repr(found)
    assert "0.79" in found._repr_html_()
    assert any("degrees of freedom" in line for line in found.summary)


def test_observables_of_different_size_are_fitted_together() -> None:
    made = precess.simulate("double_pendulum", parameters={"l1": 1.3}, until=2, every=0.05)
    rng = np.random.default_rng(5)
    data = {
        "t": made.t,
        "x2": made["x2"] + rng.normal(0, 0.01, len(made)),
        "theta1": made["theta1"] + rng.normal(0, 0.2, len(made)),
    }
    found = precess.fit("double_pendulum", data, free=["l1", "theta1"], parameters={"l1": 1.2})
    assert abs(found.values["l1"] - 1.3) < 4 * found.errors["l1"] < 0.05
    assert found.scatter["x2"] == pytest.approx(0.01, rel=0.4)
    assert found.scatter["theta1"] == pytest.approx(0.2, rel=0.4)


REFUSED: list[tuple[dict[str, Any], type[Exception], str]] = [
    ({"free": ["lenght"]}, precess.InputError, "no start or numeric parameter of pendulum 'lenght'"),
    ({"free": ["m"]}, precess.InputError, "the data do not determine m"),
    ({"free": []}, precess.InputError, "needs something free"),
    ({"columns": "thet"}, precess.InputError, "no measured column 'thet'"),
    ({"uncertainties": {"theta": 0.0}}, precess.InputError, "an uncertainty is above zero, not 0"),
    ({"uncertainties": {"phi": 0.1}}, precess.InputError, "no measured column 'phi'"),
    (
        {"data": {"t": [0.0, 1.0, 1.0], "theta": [1.0, 2.0, 3.0]}},
        precess.InputError,
        "time 3 of the data, 1 s, is there twice",
    ),
    (
        {"data": {"t": [0.0, 1.0, 0.5], "theta": [1.0, 2.0, 3.0]}},
        precess.InputError,
        "comes after a later one",
    ),
    (
        {"data": {"t": [0.0, 1.0, 2.0], "theta": [1.0, np.nan, 3.0]}},
        precess.InputError,
        "theta has no value at t = 1 s",
    ),
    (
        {"data": {"t": [0.0, 1.0], "theta": [1.0, 2.0, 3.0]}},
        precess.InputError,
        "theta has 3 values for 2 times",
    ),
    ({"data": {"t": [0.0], "theta": [1.0]}}, precess.InputError, "1 measured numbers are too few for 1"),
    ({"data": {"theta": [1.0]}}, precess.InputError, "the data have no times"),
    ({"data": {"t": [0.0, 1.0]}}, precess.InputError, "a measured column beside the times"),
    ({"data": {"t": [0.0, 1.0], "theta": ["a", "b"]}}, TypeError, "theta: an array of numbers"),
    (
        {"data": {"t": [0.0, 1.0], "theta": [[1.0], [2.0]]}},
        precess.InputError,
        "theta: an array of one dimension",
    ),
    ({"data": 3}, TypeError, "not int"),
]


@pytest.mark.parametrize(("change", "kind", "sentence"), REFUSED)
def test_what_makes_no_sense_is_refused(
    clean: precess.Trajectory, change: dict[str, Any], kind: type[Exception], sentence: str
) -> None:
    arguments: dict[str, Any] = {"data": {"t": clean.t, "theta": clean.theta}, "free": ["l"]} | change
    with pytest.raises(kind, match=sentence):
        precess.fit(GUESS, **arguments)


def test_a_file_with_a_gap_says_where(tmp_path: Path) -> None:
    file = tmp_path / "gap.csv"
    file.write_text("t,theta\n0,1\n1,\n", encoding="utf-8")
    with pytest.raises(precess.InputError, match=r"gap.csv: row 3: theta is no number \(''\)"):
        precess.fit(GUESS, file, free="l")
    file.write_text("t,theta\n0,1,2\n", encoding="utf-8")
    with pytest.raises(precess.InputError, match="row 2 has 3 fields for 2 names"):
        precess.fit(GUESS, file, free="l")


def test_bad_guesses_are_told() -> None:
    wild = precess.Scenario("magnetic_pendulum", start={"x": 1e308, "x_dot": 1e308}, method="rk4", dt=0.5)
    with pytest.raises(precess.RunError, match="from the first guesses no motion gets to the end"):
        precess.fit(wild, {"t": [0.0, 1.0, 2.0], "x": [0.0, 0.0, 0.0]}, free="x")
