"""The reader in pvpython, beside the program."""
import json
import pathlib

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROBLEM = {"taut": 1, "construct": "dirichlet", "u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 2},
           "points": [[[-1, -1, 0], [-1, 0, 1], [-1, 1, 0]], [[0, -1, 1], None, [0, 1, 1]], [[1, -1, 0], [1, 0, 1], [1, 1, 0]]]}


@pytest.fixture
def files(tmp_path, make):
    (tmp_path / "given.json").write_text(json.dumps(PROBLEM))
    (tmp_path / "live.json").write_text(json.dumps(PROBLEM))
    (tmp_path / "bad.json").write_text(json.dumps({**PROBLEM, "u": {"type": "bezier", "degree": 0}}))
    (tmp_path / "not.json").write_text("no JSON")
    model = make(PROBLEM)
    model.write(tmp_path / "model.json")
    told = json.loads((tmp_path / "model.json").read_text())
    told["surfaces"][0]["points"][1][1][2] += 1  # what it says of itself is not true any more
    (tmp_path / "told.json").write_text(json.dumps(told))
    told["certificate"]["claims"] = []
    (tmp_path / "no_claims.json").write_text(json.dumps(told))
    return model, {"told": str(tmp_path / "told.json"), "no_claims": str(tmp_path / "no_claims.json"), "model": str(tmp_path / "model.json"), "problem": str(tmp_path / "given.json"), "live": str(tmp_path / "live.json"),
                   "bad": str(tmp_path / "bad.json"), "not_json": str(tmp_path / "not.json")}


def test_reader(run_in, make, files):
    model, paths = files
    found = run_in("pvpython", "in_paraview.py", "paraview", reader=str(ROOT / "plugins/paraview/taut_reader.py"), **paths)
    for name in ("model", "problem"):
        one = found[name]
        assert 77 in one["cells"], one["cells"]  # VTK_BEZIER_QUADRILATERAL
        points = np.array(one["points"])
        for point in model.surfaces[0].points.reshape(-1, 3):  # its control points, exactly
            assert np.abs(points - point).max(axis=1).min() <= 1e-12
        spot = model.surfaces[0](.25 / 4, .5 / 4)  # of the first of 4 x 4 cells
        assert np.abs(one["place"] - spot).max() <= 1e-12
        assert {"H", "K"} <= set(one["arrays"]), one["arrays"]
        assert one["fields"]["taut holds"] == ["holds"] and "stationary" in one["fields"]["taut claims"]
        assert one["fields"]["area"][0] == pytest.approx(model.certificate.figures["area"], rel=1e-12)
        assert one["fields"]["taut unit"] == ["mm"] and one["fields"]["taut certificate"][0] == "dirichlet: holds"
    changed = json.loads(json.dumps(PROBLEM))
    changed["points"][0][1][2] += 0.5
    points = np.array(found["changed"]["points"])
    for point in make(changed).surfaces[0].points.reshape(-1, 3):
        assert np.abs(points - point).max(axis=1).min() <= 1e-12
    assert found["bad"] == [] and found["not json"] == []
    assert found["told"]["taut holds"] == ["holds"] and found["proved again"]["taut holds"] == ["does not hold"]
    assert "told.json: the certificate does not hold" in found["said"]
    assert found["no claims"]["taut claims"] == [] and found["odd"] == {"five": [], "null": [], "deep": []}
