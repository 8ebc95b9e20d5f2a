"""Questions beyond a run: equations for others, exponents, sections, sensitivities."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import precess

# Larger systems are the same few equations again and again, which SymPy would print for minutes.
MOST = 50


def _tells_its_rates(name: str) -> bool:
    scenario = precess.Scenario(name)
    try:
        scenario.rhs(0, [scenario.start[n] for n in scenario.state])
    except precess.InputError:
        return False
    return len(scenario.state) <= MOST


SMOOTH = [name for name in precess.systems if _tells_its_rates(name)]


def test_scipy_integrates_the_same_motion() -> None:
    scenario = precess.Scenario("double_pendulum", until=3, every=1, rtol=1e-12, atol=1e-12)
    start = list(scenario.start.values())
    theirs = solve_ivp(scenario.rhs, (0, 3), start, method="DOP853", rtol=1e-12, atol=1e-12)
    ours = scenario.simulate()
    np.testing.assert_allclose(theirs.y[:, -1], ours.state[-1], rtol=0, atol=1e-8)
    stiff = solve_ivp(
        scenario.rhs, (0, 1), start, method="Radau", jac=scenario.jacobian, rtol=1e-9, atol=1e-9
    )
    np.testing.assert_allclose(stiff.y[:, -1], ours.state[1], rtol=0, atol=1e-5)


@pytest.mark.parametrize("name", SMOOTH)
def test_sympy_has_the_same_equations_and_derivatives(name: str) -> None:
    import sympy as sp

    scenario = precess.Scenario(name)
    rates = precess.to_sympy(scenario)
    values = {n: scenario.start[n] for n in scenario.state}
    # A point off the start, where nothing vanishes by accident.
    rng = np.random.default_rng(1)
    state = np.array(list(values.values())) + rng.uniform(0.01, 0.1, len(values))
    symbols = [sp.Symbol(n, real=True) for n in values]
    # Parameters stay symbols: a branch that is not taken may divide by what is zero.
    known = {s: v for s, v in _parameters(scenario).items() if s not in symbols} | {
        sp.Symbol("t", real=True): 0.3
    }
    function = sp.lambdify([symbols, list(known)], list(rates.values()), "numpy", cse=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.array(function(state, np.array(list(known.values()))), dtype=float)
    wanted = scenario.rhs(0.3, state)
    scale = np.abs(wanted).max() or 1.0
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12 * scale)
    # The Jacobian by dual numbers against complex steps of SymPy's function would need analyticity: differences do.
    h = 1e-6
    jacobian = scenario.jacobian(0.3, state)
    for k in range(len(state)):
        step = np.zeros(len(state))
        step[k] = h * max(1.0, abs(state[k]))
        difference = (scenario.rhs(0.3, state + step) - scenario.rhs(0.3, state - step)) / (2 * step[k])
        column = jacobian[:, k]
        np.testing.assert_allclose(column, difference, rtol=0, atol=1e-5 * max(1.0, np.abs(column).max()))


def _parameters(scenario: precess.Scenario) -> dict[object, float]:
    import sympy as sp

    found: dict[object, float] = {}
    fields = {p["name"]: p.get("fields") for p in scenario.system._card["parameters"]}
    for name, value in scenario.parameters.items():
        if isinstance(value, float):
            found[sp.Symbol(name, real=True)] = value
        elif isinstance(value, list):
            for k, item in enumerate(value):
                if isinstance(item, list):
                    for field, x in zip(fields[name] or [], item, strict=True):
                        found[sp.Symbol(f"{name}[{k}].{field}", real=True)] = x
                else:
                    found[sp.Symbol(f"{name}[{k}]", real=True)] = item
    return found


def test_a_system_has_its_equations_too() -> None:
    pendulum = precess.systems.pendulum
    assert pendulum.rhs(0, [0.5, 0.1]) == pytest.approx([0.1, -9.81 * np.sin(0.5)])
    np.testing.assert_allclose(
        pendulum.jacobian(0, [0.5, 0.1]), [[0, 1], [-9.81 * np.cos(0.5), 0]], rtol=1e-15
    )
    with pytest.raises(precess.InputError, match="a state of pendulum has 2 numbers, not 3"):
        pendulum.rhs(0, [1.0, 2.0, 3.0])
    with pytest.raises(precess.InputError, match="has events"):
        precess.systems.noria.rhs(0, [0.0] * 10)


def test_the_lorenz_spectrum_sums_to_the_divergence() -> None:
    found = precess.lyapunov("lorenz", until=50)
    assert found["exponent"].sum() == pytest.approx(-(10 + 1 + 8 / 3), rel=1e-6)
    assert found["exponent"][0] > found["error"][0]
    assert any("chaotic" in line for line in found.summary)
    assert found.to_xarray()["exponent"].attrs["units"] == "1/s"
    assert list(found.to_pandas().columns) == ["index", "exponent", "error"]
    assert len(found.plot().axes) == 1
    with pytest.raises(KeyError, match="did you mean 'exponent'"):
        found["exponents"]


def test_a_run_is_trusted_up_to_its_horizon() -> None:
    chaos = precess.trust("lorenz", until=60, every=0.5, rtol=1e-9, atol=1e-9)
    trusted = chaos["trusted"].astype(bool)
    horizon = trusted.argmin()
    assert 0 < horizon < len(chaos)
    assert not trusted[horizon:].any()
    assert (chaos["error"][:horizon] <= 1e-3).all()
    assert chaos["error"][horizon] > 1e-3
    assert precess.trust("pendulum", until=10, every=1)["trusted"].all()
    with pytest.raises(precess.InputError, match="above zero"):
        precess.trust("pendulum", within=-1)


def test_a_section_is_where_it_says() -> None:
    found = precess.poincare("pendulum", "theta = 0", direction="rising", until=20, start={"theta": 0.5})
    assert len(found) > 5
    np.testing.assert_allclose(found["theta"], 0, rtol=0, atol=1e-12)
    assert (found["theta_dot"] > 0).all()
    assert found.plot().axes[0].get_xlabel()
    with pytest.raises(precess.InputError, match="did you mean 'theta'"):
        precess.poincare("pendulum", "thetta = 0")
    with pytest.raises(TypeError, match="did you mean 'until'"):
        precess.poincare("pendulum", "theta = 0", untill=3)  # type: ignore[call-arg]


def test_a_transition_matrix_keeps_areas_without_friction() -> None:
    found = precess.sensitivity("pendulum", until=5, every=0.5, rtol=1e-12, atol=1e-12)
    assert found.transition.shape == (11, 2, 2)
    np.testing.assert_array_equal(found.transition[0], np.eye(2))
    np.testing.assert_allclose(np.linalg.det(found.transition), 1, rtol=0, atol=1e-9)
    run = precess.simulate("pendulum", until=5, every=0.5, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found["theta"], run["theta"], rtol=0, atol=1e-9)
    data = found.to_xarray()
    assert data["dtheta"].dims == ("t", "along")
    # With friction areas shrink as exp(-b t).
    damped = precess.sensitivity("pendulum", parameters={"b": 0.3}, times=[2.0], rtol=1e-12, atol=1e-12)
    assert np.linalg.det(damped.transition[0]) == pytest.approx(np.exp(-0.6), rel=1e-9)


def test_a_body_answers_to_a_mass() -> None:
    found = precess.sensitivity("n_body", ["masses[1]", "x0"], times=[1.0])
    heavier = np.array(precess.Scenario("n_body").parameters["masses"])
    h = 1e-5
    ends = []
    for sign in (1, -1):
        moved = heavier.copy()
        moved[1] += sign * h
        ends.append(
            precess.simulate("n_body", parameters={"masses": moved}, until=1, rtol=1e-13, atol=1e-13)["x0"][
                -1
            ]
        )
    assert found["x0", "masses[1]"][0] == pytest.approx((ends[0] - ends[1]) / (2 * h), rel=1e-5, abs=1e-9)


@pytest.mark.parametrize(
    ("along", "times", "sentence"),
    [
        (["lenght"], None, "no start or numeric parameter of pendulum 'lenght'"),
        (["l"], [1.0, 0.5], "times must not fall"),
        (["l"], [-1.0], "times must not fall, nor lie before zero"),
        (["l"], [[1.0]], "one dimension"),
    ],
)
def test_a_sensitivity_refuses_what_makes_no_sense(
    along: list[str], times: list[float] | None, sentence: str
) -> None:
    with pytest.raises(precess.InputError, match=sentence):
        precess.sensitivity("pendulum", along, times=times)
    with pytest.raises(precess.InputError, match="needs a motion without jumps"):
        precess.sensitivity("noria")
    with pytest.raises(precess.InputError, match="theta_dot is missing"):
        precess.sensitivity("pendulum", "theta", times=[1.0]).transition  # noqa: B018


def test_basins_are_what_their_proof_says() -> None:
    found = precess.basins(
        "magnetic_pendulum", {"x": (-1, 1, 9), "y": (-0.5, 0.5, 5)}, start={"x_dot": 0, "y_dot": 0}
    )
    assert found.labels.shape == (9, 5)
    assert len(found.attractors) == 3
    assert found.undecided < 0.05
    assert {a.kind for a in found.attractors} == {"fixed point"}
    # An attractor is in its own basin.
    for attractor in found.attractors:
        here = {name: (attractor.state[name], attractor.state[name], 1) for name in ("x", "y")}
        alone = precess.basins("magnetic_pendulum", here, start={"x_dot": 0, "y_dot": 0})
        end = alone.attractors[alone.labels[0, 0]].state
        assert [end["x"], end["y"]] == pytest.approx([attractor.state["x"], attractor.state["y"]], abs=1e-6)
    data = found.to_xarray()
    assert data["label"].dims == ("x", "y")
    assert found.plot().axes
    with pytest.raises(TypeError, match="x: first value, last value and number"):
        precess.basins("magnetic_pendulum", {"x": (1, 2)})  # type: ignore[dict-item]
    with pytest.raises(precess.InputError, match="did you mean 'x'"):
        precess.basins("magnetic_pendulum", {"xx": (0, 1, 2)})


def test_sweeps_and_portraits_answer() -> None:
    portrait = precess.portrait("duffing", {"x": (-2, 2), "x_dot": (-2, 2)}, parameters={"gamma": 0})
    assert portrait.plot().axes
    assert len(portrait) >= 1
    response = precess.response("driven_oscillator", {"frequency": (0.5, 2, 5)})
    assert len(response) == 5
    np.testing.assert_allclose(response["amplitude"], response["exact_amplitude"], rtol=1e-2)
    with pytest.raises(precess.InputError, match="a sweep goes over one parameter"):
        precess.response("driven_oscillator", {})
    with pytest.raises(TypeError, match="first value, last value and number"):
        precess.bifurcation("duffing", {"gamma": (1, 2)})  # type: ignore[dict-item]
