"""The workbench in freecadcmd, beside the program."""
import os
import pathlib
import shutil

import numpy as np
import pytest

CORNERS = np.array([[0, 0, 0], [200, 0, 100], [200, 300, 0], [0, 300, 100.0]])
BULGE = [[0, -50, 40], [30, 0, -20], [0, 40, 50], [-20, 0, 10]]
SADDLE = [[0, 0, 0], [90, 0, 0], [90, 90, 90], [0, 90, 0]]
SHIFT = [11, -7.5, 3.25]


def ring(shift=(0, 0, 0)):
    edges = []
    for i in range(4):
        a, b = CORNERS[i], CORNERS[(i + 1) % 4]
        edges.append((np.array([a, a + (b - a) / 3 + BULGE[i], b - (b - a) / 3 + BULGE[i], b]) + shift).tolist())
    return edges


@pytest.fixture(scope="module")
def stored():
    return {}


@pytest.fixture
def result(run_in, stored):
    if not stored:
        stored.update(run_in("freecadcmd", "in_freecad.py", "freecad", edges=ring(), shift=SHIFT, saddle=SADDLE))
    return stored


def same(found, surface, size):
    """A face of FreeCAD is the program's surface: poles, weights and knots."""
    assert found["valid"] and found["holds"] == "holds" and "Invalid" not in found["state"], found
    assert np.abs(np.array(found["poles"]) - surface.points).max() <= 1e-12 * size
    weights = np.ones(surface.points.shape[:2]) if surface.weights is None else surface.weights
    assert np.abs(np.array(found["weights"]) - weights).max() <= 1e-12
    for direction, basis in enumerate((surface.u, surface.v)):
        knots = np.repeat(found["knots"][direction], found["counts"][direction])
        expected = basis.knots if basis.type == "bspline" else np.repeat(basis.range, basis.degree + 1)
        assert np.abs(knots - expected).max() <= 1e-12 and found["degrees"][direction] == basis.degree


def problem(construct, edges, tmp_path, unit="mm"):
    import taut
    taut.Model(curves=[taut.Curve(taut.bezier(3), points) for points in edges], unit=unit).write(tmp_path / "edges.json")
    return {"construct": construct, "boundary": "edges.json", "unit": unit}


@pytest.mark.parametrize("name, construct", [("Dirichlet", "dirichlet"), ("Least area", "plateau"), ("Harmonic", "harmonic")])
def test_surfaces(result, make, tmp_path, name, construct):
    model = make(problem(construct, ring(), tmp_path))
    same(result[name], model.surfaces[0], 300)
    if "area" in model.certificate.figures:
        assert result[name]["area"] == pytest.approx(model.certificate.figures["area"], rel=1e-5)
    assert result[name]["claims"][0] == f"{construct}: holds"


def test_it_follows_its_edges(result, make, tmp_path):
    model = make(problem("dirichlet", ring(SHIFT), tmp_path))
    for name in ("moved", "mended", "read again", "in a part"):
        same(result[name], model.surfaces[0], 300)


def test_edges(result):
    arc = result["arc"]
    assert arc["degree"] == 2 and arc["off"] <= 1e-13 and arc["ends"] <= 1e-13
    assert result["degree 0"] == "holds"
    assert result["whole"] == [["Face1"], ["Edge1", "Edge2", "Edge3", "Edge4"], ["Face1"], []]


def test_asymptotic(result, make, tmp_path):
    corners = np.array(SADDLE, dtype=float)
    edges = [[corners[i] + (corners[(i + 1) % 4] - corners[i]) * (s / 3) for s in range(4)] for i in range(4)]
    same(result["Asymptotic"], make(problem("asymptotic", edges, tmp_path))["patch"], 90)


def test_pipes(result, make):
    model = make({"construct": "pipe", "radius": 20, "from": {"point": [0, 0, 0], "direction": [1, 0, 0]},
                  "to": {"point": [240, 160, 120], "direction": [0, 1, 0]}})
    same(result["Lines"], model["blend"], 300)
    # their axes are turned by FreeCAD, to rounding. Around a minimum that is sought by its values alone these are flat: the last bits of
    # the points move the handles by 6e-8 of themselves, and the area by 2.5e-9
    cylinders = result["Pipe"]
    assert cylinders["holds"] == "holds" and np.array(cylinders["poles"]).shape == model["blend"].points.shape
    assert cylinders["area"] == pytest.approx(result["Lines"]["area"], rel=5e-9)


def test_join(result, make, tmp_path):
    import taut
    from taut import hosts
    one, other = (make(problem(name, ring(SHIFT), tmp_path)).surfaces[0] for name in ("dirichlet", "plateau"))
    edge, opposite, report = hosts.nearest(one, other)
    join = result["Join"]
    assert report["max_gap"] == 0 and join["gap"] == 0 and join["along"] == f"{edge} of the first, {opposite} of the second"
    assert join["contact"] == report["g_order"] and np.radians(join["angle"]) == pytest.approx(report["max_normal_angle"], rel=1e-9)
    assert taut.join(one, edge, other, opposite) == report and join["claims"][0] == "max_gap: 0"


def test_names(result):
    assert result["own"] == [True, True] and result["hidden"] == []


def test_refusals(result):
    for name, words in (("broken", "What to change"), ("three", "Edges: found 3 edges; expected four"), ("no radius", "Radius: straight edges have no radius: set Radius"),
                        ("trimmed", "is trimmed"), ("too thick", "What to change"), ("gone", "Edge0 has no Edge9 any more"),
                        ("pole", "Ball.Edge1 is a point")):
        assert "Invalid" in result[name]["state"] and words in result[name]["claims"][0], result[name]
    assert result["broken"]["holds"] == "not made" and result["broken"]["valid"] is False


def test_a_claim_that_is_false(result):
    assert result["false"] == ["does not hold", "dirichlet: does not hold", False]


def test_undo(result):
    assert result["undone"] and result["redone"]


def test_window(run_in, tmp_path, make):
    """The command of the workbench on what is selected, in the real window; TAUT_PICTURES says where its picture goes."""
    root, mod = pathlib.Path(__file__).resolve().parents[2], tmp_path / ".local/share/FreeCAD/Mod/taut"
    shutil.copytree(root / "plugins/freecad", mod)
    (mod / "freecad/taut_workbench/vendor").symlink_to(root / "python")  # as in the zip: FreeCAD's window takes no PYTHONPATH
    pictures = os.environ.get("TAUT_PICTURES")
    edges = [(np.array(points) * [1, 1, 1.2]).tolist() for points in ring()]
    found = run_in("freecad", "window_freecad.py", "freecad", edges=edges, picture=pictures and f"{pictures}/freecad.png")
    model = make(problem("plateau", edges, tmp_path))
    assert found["made"] == 1 and found["holds"] == "holds" and found["undo"] == ["Least area"]
    assert found["area"] == pytest.approx(model.certificate.figures["area"], rel=1e-5)
    assert (found["after undo"], found["after redo"], found["of whole objects"]) == (0, 1, 2)
