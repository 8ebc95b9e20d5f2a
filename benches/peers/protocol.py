"""What the Python peers share: arguments, starting points, line of JSON, file of positions."""

import argparse
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Exercise 7 of P, program 7.5.
SPRING, FRICTION, DEPTH, DT = 4.0, 0.2, 0.1, 0.0001
MAGNETS = ((0.5, 0.0), (-0.25, 0.433), (-0.25, -0.433))


def parser(description: str) -> argparse.ArgumentParser:
    """Return a parser of `N STEPS [FILE]`."""
    result = argparse.ArgumentParser(description=description)
    result.add_argument("n", metavar="N", type=_at_least(2), help="N x N starts")
    result.add_argument("steps", metavar="STEPS", type=_at_least(0), help="steps of dt = 1e-4")
    result.add_argument("file", metavar="FILE", type=Path, nargs="?", help="final positions")
    return result


def starts(n: int) -> tuple[Array, Array]:
    """Return x and y of n x n points over [-2, 2]^2 with both ends; y is the outer loop."""
    axis = -2.0 + 4.0 * np.arange(n) / (n - 1)
    return np.tile(axis, n), np.repeat(axis, n)


def report(
    given: argparse.Namespace, peer: str, seconds: float, x: Array, y: Array, **more: object
) -> None:
    """Write the final positions to the file, if one is given, then print the line of JSON."""
    if given.file is not None:
        given.file.write_bytes(np.stack((x, y), axis=1).astype("<f8").tobytes())
    line = {"peer": peer, "seconds": round(seconds, 9), "points": x.size, "steps": given.steps}
    print(json.dumps(line | more))


def _at_least(least: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        value = int(text)
        if value < least:
            raise argparse.ArgumentTypeError(f"{value} is less than {least}")
        return value

    return number
