"""The tutorials run as they stand, with short settings, and say what is true."""

import json
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest

TUTORIALS = Path(__file__).parents[2] / "docs" / "tutorials"


def run(name: str, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """Run the cells of a notebook one after another in this process: a kernel would take its time to start."""
    import matplotlib.pyplot as plt

    mpl.use("Agg")
    monkeypatch.setenv("PRECESS_SHORT", "1")
    book = json.loads((TUTORIALS / f"{name}.ipynb").read_text(encoding="utf-8"))
    names: dict[str, Any] = {}
    for cell in book["cells"]:
        assert not cell.get("outputs"), "a notebook is kept without its outputs"
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{name}.ipynb", "exec"), names)  # noqa: S102
    plt.close("all")
    return names


def test_every_tutorial_has_a_test() -> None:
    text = Path(__file__).read_text(encoding="utf-8")
    assert all(f'run("{file.stem}"' in text for file in TUTORIALS.glob("*.ipynb"))


def test_the_cone_nods_in_equal_times(monkeypatch: pytest.MonkeyPatch) -> None:
    names = run("cone-gyroscope", monkeypatch)
    assert len(names["minima"]) > 2
    np.testing.assert_allclose(np.diff(names["minima"]), names["period"], rtol=1e-6)
    assert all(drift.relative < 1e-9 for drift in names["run"].drifts)


def test_every_magnet_wins_somewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    names = run("magnet-basins", monkeypatch)
    shares = np.bincount(names["winner"][~names["undecided"]]) / (~names["undecided"]).sum()
    assert len(shares) == 3
    assert shares.min() > 0.2
    assert names["undecided"].mean() < 0.3
    assert names["changed"].mean() < 0.05


def test_the_table_carries_the_top(monkeypatch: pytest.MonkeyPatch) -> None:
    names = run("tippe-top", monkeypatch)
    assert (names["run"]["normal"] > 0).all()
    assert all(drift.relative < 1e-8 for drift in names["run"].drifts)


def test_methods_have_their_orders(monkeypatch: pytest.MonkeyPatch) -> None:
    names = run("testing-an-integrator", monkeypatch)
    for name, slope in names["slopes"].items():
        assert slope == pytest.approx(names["precess"].methods[name].order, abs=0.25)


def test_the_film_is_understood(monkeypatch: pytest.MonkeyPatch) -> None:
    names = run("fitting-a-pendulum", monkeypatch)
    found = names["found"]
    for name, wanted in names["truth"].items():
        assert abs(found.values[name] - wanted) < 4 * found.errors[name]
    assert np.degrees(found.scatter["theta"]) == pytest.approx(1, abs=0.3)


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_gives_the_same_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    assert run("sweep-on-dask", monkeypatch)["same"]
