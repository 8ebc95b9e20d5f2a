"""The cone for 1000 s by `precess.simulate` and by SciPy's DOP853 at equal error, and what an import costs.

Ratios first: the machine may be busy. `make bench-python` runs it.
"""

import subprocess
import sys
import time

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

import precess

UNTIL = 1000.0
IMPORT = """
import time
import numpy
begin = time.perf_counter()
import precess
print(time.perf_counter() - begin)
"""


def ours(scenario: precess.Scenario) -> tuple[float, float]:
    """Give seconds and the error of the energy."""
    begin = time.perf_counter()
    run = scenario.simulate()
    seconds = time.perf_counter() - begin
    return seconds, next(d.relative for d in run.drifts if d.name == "energy") or 0.0


def theirs(scenario: precess.Scenario, tolerance: float, until: float) -> tuple[float, float]:
    """The same by SciPy, with the equations as plain Python with common subexpressions (what a careful user writes)."""
    symbols = [sp.Symbol(name, real=True) for name in scenario.start]
    known = {sp.Symbol(name, real=True): value for name, value in scenario.parameters.items()}
    rates = [expression.subs(known) for expression in precess.to_sympy(scenario).values()]
    function = sp.lambdify([symbols], rates, "math", cse=True)
    times = np.arange(0, until + 0.5)
    begin = time.perf_counter()
    found = solve_ivp(
        lambda _, y: function(y), (0, until), list(scenario.start.values()), "DOP853", times, rtol=tolerance, atol=tolerance
    )
    seconds = time.perf_counter() - begin
    # The energy of their states, by our observables.
    first, last = (
        precess.simulate(scenario, start=dict(zip(scenario.start, y, strict=True)), until=0)["energy"][0]
        for y in (found.y[:, 0], found.y[:, -1])
    )
    return seconds, abs(last / first - 1)


def main() -> None:
    """Measure and print."""
    scenario = precess.Scenario.load("cone.toml").replace(until=UNTIL, every=1.0)
    for tolerance in (1e-9, 1e-12):
        runs = [ours(scenario.replace(rtol=tolerance, atol=tolerance)) for _ in range(3)]
        here = min(seconds for seconds, _ in runs)
        # SciPy needs minutes for all of it: a tenth is enough, since the cone nods on and on.
        there, error = theirs(scenario, tolerance, UNTIL / 10)
        print(f"tolerance {tolerance:g}: SciPy's DOP853 takes {10 * there / here:.0f} times as long")
        print(f"    precess  {here:.3f} s, energy {runs[0][1]:.1e} after {UNTIL:g} s")
        print(f"    SciPy    {10 * there:.1f} s (ten times a tenth), energy {error:.1e} after {UNTIL / 10:g} s")
    times = [
        float(subprocess.run([sys.executable, "-c", IMPORT], check=True, capture_output=True, text=True).stdout)
        for _ in range(10)
    ]
    print(f"import precess: {1e3 * min(times):.0f} ms beyond NumPy's")


if __name__ == "__main__":
    main()
