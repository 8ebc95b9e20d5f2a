"""What others do with a result: tables, datasets, pictures, notebooks; and what an import costs them."""

import doctest
import importlib
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.mathtext import MathTextParser

import precess
from precess._plot import _label

mpl.use("Agg")

IMPORTED = """
import sys, numpy
before = set(sys.modules)
import precess
brought = {name.split(".")[0] for name in set(sys.modules) - before} - set(sys.stdlib_module_names)
print(sorted(brought))
"""


@pytest.fixture(scope="module")
def swing() -> precess.Trajectory:
    return precess.simulate("pendulum", start={"theta": 1}, until=5, every=0.05, events=["theta = 0"])


def test_an_import_brings_numpy_alone() -> None:
    done = subprocess.run([sys.executable, "-c", IMPORTED], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "['precess']"


def test_a_table_of_pandas(swing: precess.Trajectory) -> None:
    frame = swing.to_pandas()
    assert frame.index.name == "t"
    assert frame.shape == (101, len(swing.columns) - 1)
    assert frame["theta"].to_numpy().tobytes() == swing.theta.tobytes()
    assert frame.attrs["units"]["theta_dot"] == "rad/s"
    assert frame.attrs["result_hash"] == swing.hash()


def test_a_dataset_of_xarray(swing: precess.Trajectory) -> None:
    data = swing.to_xarray()
    assert dict(data.sizes) == {"t": 101}
    assert data["energy"].attrs["units"] == "J"
    assert data["energy"].attrs["kind"] == "invariant"
    assert data["t"].attrs["units"] == "s"
    again = precess.Scenario.parse(data.attrs["scenario"]).simulate()
    assert again.hash() == data.attrs["result_hash"]


def test_pictures(swing: precess.Trajectory) -> None:
    import matplotlib.pyplot as plt

    assert len(swing.plot().axes) == 3
    (axes,) = swing.plot("theta_dot", x="theta").axes
    np.testing.assert_array_equal(np.asarray(axes.lines[0].get_xdata()), swing.theta)
    top = precess.simulate("gyroscope", until=0.2)
    assert top.plot(kind="axis").axes[0].name == "3d"
    assert len(top.plot(kind="invariants").axes[0].lines) == len(top.drifts)
    tippe = precess.simulate("tippe_top_rolling", until=0.1)
    assert tippe.plot(kind="contact").axes[0].get_aspect() == 1
    plt.close("all")
    with pytest.raises(precess.InputError, match="pendulum has no contact point"):
        swing.plot(kind="contact")
    with pytest.raises(precess.InputError, match="did you mean 'axis'"):
        swing.plot(kind="axes")
    with pytest.raises(KeyError, match="no column of pendulum"):
        swing.plot("psi")


def test_matplotlib_understands_every_label() -> None:
    parser = MathTextParser("path")
    for system in precess.systems:
        run = precess.simulate(system, until=0)
        for column in run.columns:
            parser.parse(_label(run, column.name))


def test_a_notebook_shows_cards_and_runs(swing: precess.Trajectory) -> None:
    shown = swing._repr_html_()
    assert "drift of energy" in shown
    assert shown.count("<tr>") == shown.count("</tr>") > 8
    assert "events" in shown
    card = precess.systems.pendulum._repr_html_()
    assert "theta" in card
    assert repr(swing).startswith("<precess.Trajectory pendulum: 101 samples")


def test_every_card_is_a_text() -> None:
    for system in precess.systems.values():
        text = system.__doc__ or ""
        for quantity in system.coordinates + system.parameters + system.observables:
            assert quantity.name in text
            assert quantity.meaning in text
        assert system.source in text
        assert system.equations
    assert "constant where b = b2 = dry = 0" in (precess.systems.pendulum.__doc__ or "")
    for method in precess.methods.values():
        assert method.source in (method.__doc__ or "")


def test_examples_in_the_texts_are_right() -> None:
    for module in ("precess", "precess._simulate", "precess._sympy"):
        outcome = doctest.testmod(importlib.import_module(module))
        assert outcome.failed == 0
        assert outcome.attempted > 1


def test_a_dataset_survives_a_netcdf_file(swing: precess.Trajectory, tmp_path: Path) -> None:
    import xarray as xr

    swing.to_xarray().to_netcdf(tmp_path / "swing.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "swing.nc", engine="scipy") as again:
        assert again["theta"].to_numpy().tobytes() == swing.theta.tobytes()
        assert again.attrs["scenario_hash"] == swing.scenario_hash
