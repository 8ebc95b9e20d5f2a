"""Ensembles: grids, rows, parameters."""

import numpy as np
import pytest

import precess


def test_a_grid_has_an_axis_for_each_name() -> None:
    x, y = np.linspace(-1, 1, 5), np.linspace(-2, 2, 3)
    ends = precess.ensemble("magnetic_pendulum", {"x": x, "y": y}, until=1, every=0.5, method="rk4", dt=0.01)
    assert ends["x"].shape == (5, 3)
    alone = precess.simulate(
        "magnetic_pendulum", start={"x": x[1], "y": y[2]}, until=1, every=0.5, method="rk4", dt=0.01
    )
    assert ends.numbers[1, 2, 0].tobytes() == alone.state[-1].tobytes()


def test_every_sample_may_be_kept() -> None:
    ends = precess.ensemble("pendulum", {"theta": [0.1, 0.2]}, until=1, every=0.25, keep="samples")
    assert ends["theta"].shape == (2, 5)
    alone = precess.simulate("pendulum", start={"theta": 0.2}, until=1, every=0.25)
    assert ends.hash(1) == alone.hash()
    assert ends.t.tolist() == alone.t.tolist()


def test_parameters_may_be_swept_with_starts() -> None:
    lengths, angles = [0.5, 1.0, 0.5], [0.1, 0.2, 0.3]
    ends = precess.ensemble("pendulum", {"l": lengths, "theta": angles}, product=False, until=1)
    for k, (length, angle) in enumerate(zip(lengths, angles, strict=True)):
        alone = precess.simulate("pendulum", parameters={"l": length}, start={"theta": angle}, until=1)
        assert ends["theta"][k] == alone["theta"][-1]
    grid = precess.ensemble("pendulum", {"l": [0.5, 1.0]}, start={"theta": 0.2}, until=1)
    assert grid["theta"][1] == ends["theta"][1]


def test_the_number_of_threads_changes_no_bit() -> None:
    over = {"theta": np.linspace(-3, 3, 101)}
    one, two = (precess.ensemble("pendulum", over, until=2, threads=n).numbers for n in (1, 2))
    assert one.tobytes() == two.tobytes()


def test_a_member_that_fails_says_why() -> None:
    ends = precess.ensemble(
        "magnetic_pendulum",
        {"x": [1.0, 1.7e308], "x_dot": [0.0, 1.7e308]},
        method="rk4",
        dt=0.5,
        until=1,
        product=False,
    )
    assert list(ends.failures) == [1]
    assert "no longer finite" in ends.failures[1]
    assert np.isnan(ends["x"][1])
    assert np.isfinite(ends["x"][0])


def test_a_dataset_has_starts_along_its_dimensions() -> None:
    data = precess.ensemble("pendulum", {"theta": [0.1, 0.2], "l": [1.0, 2.0, 3.0]}, until=1).to_xarray()
    assert data["theta"].dims == ("start_theta", "l")
    assert data["theta"].attrs["units"] == "rad"
    assert data["l"].values.tolist() == [1, 2, 3]
    assert float(data["t"]) == 1
    samples = precess.ensemble(
        "pendulum", {"theta": [0.1, 0.2]}, until=1, every=0.5, keep="samples", product=False
    ).to_xarray()
    assert samples["theta_dot"].dims == ("member", "t")
    assert samples["start_theta"].values.tolist() == [0.1, 0.2]


@pytest.mark.parametrize(
    ("over", "sentence"),
    [
        ({}, "needs something to go over"),
        ({"thet": [1.0]}, "did you mean 'theta'"),
        ({"theta": []}, "the array is empty"),
        ({"theta": [[1.0]]}, "one dimension"),
        ({"theta": [1.0, np.nan]}, "nan is not a finite number"),
        ({"l": [1.0, -1.0]}, "l: must be above 0"),
    ],
)
def test_what_makes_no_sense_is_refused(over: dict[str, list[float]], sentence: str) -> None:
    with pytest.raises(precess.InputError, match=sentence):
        precess.ensemble("pendulum", over, until=1)
    with pytest.raises(precess.InputError, match="differ in length"):
        precess.ensemble("pendulum", {"theta": [1.0, 2.0], "l": [1.0]}, product=False)
    with pytest.raises(TypeError, match="an array of numbers"):
        precess.ensemble("pendulum", {"theta": ["a"]})
    with pytest.raises(precess.InputError, match="did you mean 'samples'"):
        precess.ensemble("pendulum", {"theta": [1.0]}, keep="sample")
    with pytest.raises(precess.InputError, match="at least one"):
        precess.ensemble("pendulum", {"theta": [1.0]}, threads=0)


def test_a_sweep_over_many_parameters_ends_where_it_is_ended() -> None:
    def end(done: float) -> None:
        if done > 20:
            raise LookupError("enough")

    lengths = np.linspace(0.5, 1.5, 200)
    with pytest.raises(LookupError, match="enough"):
        precess.ensemble("pendulum", {"l": lengths}, until=1e3, threads=2, progress=end)
    many = precess.ensemble("pendulum", {"l": lengths}, until=1, threads=2)
    one = precess.ensemble("pendulum", {"l": lengths}, until=1, threads=1)
    assert many.numbers.tobytes() == one.numbers.tobytes()
    assert (
        many["theta"][7] == precess.simulate("pendulum", parameters={"l": lengths[7]}, until=1)["theta"][-1]
    )
