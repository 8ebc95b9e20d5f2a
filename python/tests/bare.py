"""What the package does with NumPy and nothing else: run in an environment into which pip put the wheel alone."""

import importlib.metadata
import sys
from pathlib import Path

import numpy as np

BEFORE = set(sys.modules)

import precess  # noqa: E402


def refused(extra: str, wanted: object) -> bool:
    """Tell whether something that needs more says which extra brings it."""
    try:
        wanted()  # type: ignore[operator]
    except ImportError as error:
        return f"pip install 'precess[{extra}]'" in str(error)
    return False


def main() -> None:
    """Check."""
    installed = {dist.name.lower() for dist in importlib.metadata.distributions()}
    assert installed <= {"precess", "numpy", "pip", "setuptools"}, installed
    brought = {name.split(".")[0] for name in set(sys.modules) - BEFORE} - set(sys.stdlib_module_names)
    assert brought == {"precess"}, brought
    assert (Path(precess.__file__).parent / "py.typed").exists()
    run = precess.simulate("gyroscope", until=0.1)
    assert np.isfinite(run.state).all()
    assert len(run.hash()) == 64
    assert precess.ensemble("pendulum", {"theta": [0.1, 0.2]}, until=1)["theta"].shape == (2,)
    assert len(precess.basins("potential_well", {"x": (-2, 2, 5)}, parameters={"b": 0.2}).labels) == 5
    assert len(precess.lyapunov("lorenz", until=5)) == 3
    for extra, wanted in {
        "plot": run.plot,
        "xarray": run.to_xarray,
        "sympy": lambda: precess.to_sympy("pendulum"),
        "progress": lambda: precess.simulate("pendulum", until=1, progress=True),
        "dask": lambda: precess.ensemble("pendulum", {"theta": [0.1]}, until=1, store="store"),
        "notebook": lambda: precess.scene("pendulum", until=1),
    }.items():
        assert refused(extra, wanted), extra


if __name__ == "__main__":
    main()
