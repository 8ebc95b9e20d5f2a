"""The same bits as every other face: the golden hashes."""

from pathlib import Path

import pytest

import precess

GOLDEN = Path(__file__).parents[2] / "golden"


def lines(file: str) -> list[list[str]]:
    text = (GOLDEN / file).read_text(encoding="utf-8")
    return [line.split() for line in text.splitlines() if not line.startswith("#")]


@pytest.mark.parametrize("file", ["short.txt", "hashes.txt"])
def test_every_golden_run_has_its_hash(file: str) -> None:
    differ = []
    golden = lines(file)
    for system, method, step, until, every, wanted in golden:
        tolerance = precess.methods[method].adaptive
        settings = {"rtol": float(step), "atol": float(step)} if tolerance else {"dt": float(step)}
        run = precess.simulate(system, method=method, until=float(until), every=float(every), **settings)  # type: ignore[arg-type]
        if run.hash() != wanted:
            differ.append(f"{system} {method}")
    assert not differ
    assert {line[0] for line in golden} == set(precess.systems)
    assert {line[1] for line in golden} == set(precess.methods)


@pytest.mark.parametrize(
    ("system", "name"), [("magnetic_pendulum", "x"), ("pendulum", "theta"), ("gyroscope", "theta")]
)
def test_a_member_of_an_ensemble_has_the_golden_hash(system: str, name: str) -> None:
    system_lines = [line for line in lines("short.txt") if line[0] == system and line[1] in ("rk4", "dop853")]
    assert len(system_lines) == 2
    for _, method, step, until, every, wanted in system_lines:
        settings = {"rtol": step, "atol": step} if precess.methods[method].adaptive else {"dt": step}
        scenario = precess.Scenario(system, method=method, until=until, every=every, **settings)  # type: ignore[arg-type]
        start = scenario.start[name]
        neighbours = [start * (1 + 1e-3 * k) for k in range(-9, 10)]
        members = precess.ensemble(scenario, {name: neighbours}, keep="samples", threads=2)
        assert members.hash(9) == wanted
        assert members.hash(8) != wanted


def test_a_saved_scenario_has_the_same_bits() -> None:
    for system in precess.systems:
        scenario = precess.Scenario(system, until=precess.systems[system].defaults["dt"] * 100)
        assert precess.Scenario.parse(scenario.toml).simulate().hash() == scenario.simulate().hash(), system
