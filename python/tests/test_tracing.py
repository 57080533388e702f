"""Curves followed step by step."""
import json

import numpy as np
import pytest

import taut

U = taut.bezier(1, range=(-1, 1))
SADDLE = taut.Surface(U, U, [[[-1, -1, 1.1], [-1, 1, -1.1]], [[1, -1, -1.1], [1, 1, 1.1]]])


def test_follow_is_a_line_of_curvature():
    lengths = []
    for way in ((1, 1), (-1, -1)):
        found = taut.follow(SADDLE, "principal", (0.3, 0.2), way, family="max")
        assert found["ended"] == "edge" and found["length"] == found["s"][-1]
        x, y = found["at"].T  # asinh 1.1x - asinh 1.1y stays
        kept = np.arcsinh(1.1 * x) - np.arcsinh(1.1 * y)
        assert np.abs(kept - kept[0]).max() < 1e-11
        assert np.abs(found["tau_g"]).max() < 1e-13
        assert np.abs(found["points"][:, 2] - 1.1 * x * y).max() < 1e-14
        assert found["tangents"].shape == found["normals"].shape == found["points"].shape
        lengths.append(found["length"])
    assert abs(sum(lengths) - 3.37424383734586) < 2e-12


def test_follow_stops():
    seen = []
    found = taut.follow(SADDLE, "geodesic", (0, 0), (1, 0.5), sink=lambda step: seen.append(step["s"]) or len(seen) == 3)
    assert found["ended"] == "sink" and len(found["s"]) == 3 and list(found["s"]) == seen
    assert taut.follow(SADDLE, "geodesic", (0, 0), (1, 0.5), max_length=0.25)["length"] == pytest.approx(0.25, abs=1e-15)

    def fails(step):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        taut.follow(SADDLE, "asymptotic", (0, 0), (1, 0), sink=fails)


@pytest.mark.parametrize("arguments, reason", [
    (("wavy", (0, 0), (1, 0)), "net"), (("principal", (0, 0), (0, 0)), "direction"), (("principal", (3, 0), (1, 0)), "outside"),
    (("principal", (0, 0, 0), (1, 0)), "value")])
def test_follow_refuses(arguments, reason):
    with pytest.raises(taut.InputError) as error:
        taut.follow(SADDLE, *arguments)
    assert error.value.reason == reason


def test_follow_refuses_families():
    with pytest.raises(taut.InputError):
        taut.follow(SADDLE, "asymptotic", (0, 0), (1, 0), family="max")
    with pytest.raises(taut.InputError):
        taut.follow(SADDLE, "asymptotic", (0, 0), (1, 0), max_length=-1)


def test_of_models_and_surfaces(examples, tmp_path):
    """A net on a model or a surface at hand is that of its file, bit for bit."""
    model = taut.make(examples["plateau-saddle"])
    model.write(tmp_path / "saddle.json")
    expected = taut.trace(trace="isoparametric", of=tmp_path / "saddle.json")
    assert taut.trace(trace="isoparametric", of=model) == expected
    assert taut.make([{"construct": "trace", "trace": "isoparametric", "of": model.surfaces[0]}])[0].surfaces[0] == expected.surfaces[0]
    assert taut.Model.from_json(json.dumps(model.to_dict())) == model
    assert taut.certify(expected, {"construct": "trace", "trace": "isoparametric", "of": model}).holds
