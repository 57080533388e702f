"""The add-on in Blender without a window, beside the program. Blender keeps points in single precision: the program is given what
Blender has; the model that the object keeps has all digits, what is drawn has seven."""
import os

import numpy as np
import pytest
from test_freecad import problem, ring

SHIFT = [0.5, -0.25, 1]
EDGES = [(np.array(points) / 100).tolist() for points in ring()]


@pytest.fixture(scope="module")
def stored():
    return {}


@pytest.fixture
def result(run_in, stored):
    if not stored:
        stored.update(run_in("blender", "in_blender.py", "blender", edges=EDGES, shift=SHIFT))
    return stored


def same(found, construct, make, tmp_path):
    """The model that an object keeps is the program's between the object's curves."""
    import taut
    theirs = make(problem(construct, found["edges"], tmp_path, "m"))
    ours = taut.Model.from_json(found["model"])
    size = np.abs(theirs.surfaces[0].points).max()
    assert np.abs(theirs.surfaces[0].points - ours.surfaces[0].points).max() <= 1e-12 * size
    assert ours.unit == "m" and found["certificate"].startswith(f"{construct}: holds")
    return ours


@pytest.mark.parametrize("construct", ["dirichlet", "plateau", "harmonic"])
def test_meshes(result, make, tmp_path, construct):
    found = result[construct]
    model = same(found, construct, make, tmp_path)
    mesh = model.mesh(divide=12)
    assert found["faces"] == len(mesh.quads) and found["smooth"]
    assert np.abs(np.array(found["vertices"]) - mesh.vertices).max() < 1e-6
    assert np.abs(np.array(found["normals"]) - mesh.normals).max() < 1e-3
    colours, mean = np.array(found["colours"]), np.array(found["curvature"])
    assert np.all(colours[mean > 0, 0] == 1) and np.all(colours[mean < 0, 2] == 1) and np.all(colours[:, 3] == 1)
    places = [0, 40, 80, len(mesh.vertices) - 1]
    s = model.surfaces[0]
    for i in places:
        _, u, v, uu, uv, vv = s(*mesh.parameters[i], derivatives=2)
        first = np.array([[u @ u, u @ v], [u @ v, v @ v]])
        n = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
        mean = np.trace(np.linalg.solve(first, [[uu @ n, uv @ n], [uv @ n, vv @ n]])) / 2
        assert found["curvature"][i] == pytest.approx(mean, rel=1e-5, abs=1e-6)


def test_it_is_made_again(result, make, tmp_path):
    moved = same(result["moved"], "dirichlet", make, tmp_path)
    dragged = same(result["dragged"], "dirichlet", make, tmp_path)
    step = dragged.surfaces[0].points[0, 0] - moved.surfaces[0].points[0, 0]
    assert np.abs(step - [0.25, 0, 0.5]).max() < 1e-6
    assert np.abs(dragged.surfaces[0].points[-1, -1] - moved.surfaces[0].points[-1, -1]).max() == 0


def test_nurbs(result, make, tmp_path):
    found = result["nurbs"]
    model = same(found, "dirichlet", make, tmp_path)
    assert found["splines"] == 1 and found["count"] == [4, 4] and found["order"] == [4, 4]
    points = np.array(found["points"]).reshape(4, 4, 4)
    net = model.surfaces[0].points
    turned = [np.swapaxes(net, 0, 1) if swap else net for swap in (0, 1)]
    nearest = min(np.abs(points[..., :3] - one[::a, ::b]).max() for one in turned for a in (1, -1) for b in (1, -1))
    assert nearest < 1e-6 and np.all(points[..., 3] == 1)


def test_refusals(result):
    assert "What to change" in result["broken"] and result["kept"]
    assert "take Mesh" in result["degree"] and "Select four curves" in result["three"] and "cyclic" in result["cyclic"]
    assert "edge2: its scale is 0" in result["flat"] and "point: the curve has no two points" in result["point"]
    says, off, kinds = result["put back"]
    assert "take Mesh" in says and off < 1e-6 and kinds == ["ALIGNED"]
    says, left = result["many"]
    assert "lower Cells or Refine" in says and left == 0


def test_parameters_are_its_own(result):
    assert result["stays"] == ["Sail", [0, 0, 2], ["Cloth"], "dirichlet", True] and result["active"]


def test_a_claim_that_is_false(result):
    state, says, told = result["false"]
    assert told == [[["WARNING"], "The certificate does not hold: the panel says which claim"]]
    assert state == ["FINISHED"] and says.startswith("dirichlet: does not hold")


def test_deleted_curve(result):
    left, says, fewer = result["deleted"]
    assert left == 3 and "was deleted" in says and fewer == 2


def test_undo(result):
    before, between, after = result["undo"]
    assert between == before + 1 and after == before


def test_window(run_in):
    """In the real window: a corner follows the mouse, a click keeps it, undo puts it back. TAUT_PICTURES says where the picture goes."""
    pictures = os.environ.get("TAUT_PICTURES")
    found = run_in("blender-window", "window_blender.py", "blender", edges=EDGES, picture=pictures and f"{pictures}/blender.png")
    assert found["drag"] == ["RUNNING_MODAL"] and found["live"] != found["before"] and found["kept"] == found["live"]
    assert found["certificate"].startswith("dirichlet: holds") and found["undone"] == found["before"]
    assert found["drawn"] == pytest.approx(found["kept"], abs=1e-6)
