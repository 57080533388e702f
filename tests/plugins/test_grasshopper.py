"""The components against a stand-in of RhinoCommon's types, beside the program; and their surfaces through a .3dm file by McNeel's own
code, npm's rhino3dm, where it can be fetched. Rhino itself runs on no Linux: it was not tried."""
import json
import os
import pathlib
import runpy
import shutil
import subprocess
import sys

import numpy as np
import pytest
import stand_in_rhino
from test_freecad import problem, ring

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def component(monkeypatch):
    """component(name, **inputs): the outputs of a script, as Grasshopper runs it."""

    def run(name, unit="Millimeters", **inputs):
        monkeypatch.setitem(sys.modules, "Rhino", stand_in_rhino.module(unit))
        return runpy.run_path(str(ROOT / f"plugins/grasshopper/{name}.py"), init_globals=inputs)

    return run


def curves(edges):
    return [stand_in_rhino.NurbsCurve(3, [0.0] * 3 + [1.0] * 3, points) for points in edges]


def same(found, surface, size):
    assert np.abs(np.array(found.Points.places) - surface.points).max() <= 1e-12 * size
    weights = np.ones(surface.points.shape[:2]) if surface.weights is None else surface.weights
    assert np.abs(np.array(found.Points.weights) - weights).max() <= 1e-12
    assert found.IsRational == (surface.weights is not None)
    for knots, order, basis in ((found.KnotsU, found.OrderU, surface.u), (found.KnotsV, found.OrderV, surface.v)):
        full = basis.knots if basis.type == "bspline" else np.repeat(basis.range, basis.degree + 1)
        assert list(knots) == full[1:-1].tolist() and order == basis.degree + 1


@pytest.mark.parametrize("construct", ["dirichlet", "plateau", "harmonic"])
def test_between(component, make, tmp_path, construct):
    out = component("taut_between", curves=curves(ring()), construct=construct)
    model = make(problem(construct, ring(), tmp_path))
    same(out["surface"], model.surfaces[0], 300)
    assert out["certificate"][0] == f"{construct}: holds"
    moved = component("taut_between", curves=curves(ring([1, 2, 3])), construct=construct)
    same(moved["surface"], make(problem(construct, ring([1, 2, 3]), tmp_path)).surfaces[0], 300)


def test_inputs(component):
    import taut
    out = component("taut_between", unit="Feet", curves=curves(ring()), degree=[5, 4])
    model = taut.Model.from_json(out["model"])
    assert model.unit == "ft" and (out["surface"].OrderU, out["surface"].OrderV) == (6, 5)
    assert "surface" not in component("taut_between")  # nothing is connected yet
    assert "surface" not in component("taut_between", curves=None, construct=None, degree=None)
    assert "surface" not in component("taut_pipe", one=None, other=None, radius=None, joint=None)


class NetList:
    """What .NET's lists can do: it is none of Python's."""

    def __init__(self, *items):
        self.items = items

    def __iter__(self):
        return iter(self.items)

    def __len__(self):
        return len(self.items)


def test_pipe(component, make):
    model = make({"construct": "pipe", "radius": 20, "from": {"point": [0, 0, 0], "direction": [1, 0, 0]},
                  "to": {"point": [240, 160, 120], "direction": [0, 1, 0]}})
    lines = stand_in_rhino.Line([-60, 0, 0], [0, 0, 0]), stand_in_rhino.Line([240, 260, 120], [240, 160, 120])
    out = component("taut_pipe", one=lines[0], other=lines[1], radius=20.0)
    same(out["surface"], model["blend"], 300)
    assert out["surface"].IsRational and out["certificate"][0] == "pipe: holds"
    listed = component("taut_pipe", one=lines[0], other=lines[1], radius=NetList(20.0), joint=None)
    assert listed["model"] == out["model"]
    edges = component("taut_between", curves=NetList(*curves(ring())), construct="Dirichlet", degree=NetList(5, 4))["surface"]
    assert (edges.OrderU, edges.OrderV) == (6, 5)


def test_refusals(component):
    with pytest.raises(RuntimeError, match="found 3 edges; expected four"):
        component("taut_between", curves=curves(ring()[:3]))
    with pytest.raises(RuntimeError, match="closed"):
        component("taut_between", curves=[stand_in_rhino.NurbsCurve(3, [0.0] * 3 + [1.0] * 3, ring()[0], closed=True)] * 4)
    with pytest.raises(RuntimeError, match="What to change"):
        component("taut_between", curves=curves([*ring()[:3], ring([0, 0, 9])[3]]))
    with pytest.raises(RuntimeError, match="unit is Parsecs"):
        component("taut_between", unit="Parsecs", curves=curves(ring()))
    line = stand_in_rhino.Line([0, 0, 0], [1, 0, 0])
    with pytest.raises(RuntimeError, match="What to change"):
        component("taut_pipe", one=line, other=stand_in_rhino.Line([9, 9, 0], [9, 12, 0]), radius=200.0)
    for radius, words in ((None, "is no number"), ("thick", "is no number"), (NetList(), "found 0 radii"), (NetList(1, 2, 3), "found 3 radii")):
        with pytest.raises(RuntimeError, match=words):
            component("taut_pipe", one=line, other=stand_in_rhino.Line([9, 9, 0], [9, 12, 0]), radius=radius)
    for inputs, words in (({"curves": [*curves(ring()[:3]), None]}, "item 3 of curves is missing"),
                          ({"curves": [1, 2, 3, 4]}, "item 0 of curves is int"),
                          ({"curves": curves(ring()), "degree": 3}, "two whole numbers"),
                          ({"curves": curves(ring()), "degree": ["a", 3]}, "two whole numbers")):
        with pytest.raises(RuntimeError, match=words):
            component("taut_between", **inputs)
    with pytest.raises(RuntimeError, match="an axis is int"):
        component("taut_pipe", one=line, other=3, radius=1)


@pytest.fixture(scope="session")
def rhino3dm():
    """A folder with npm's rhino3dm in it."""
    folder = ROOT / "build/plugins-npm"
    if not (folder / "node_modules/rhino3dm").exists():
        if shutil.which("npm") is None:
            pytest.skip("there is no npm here: tools/deps.sh check")
        folder.mkdir(parents=True, exist_ok=True)
        done = subprocess.run(["npm", "install", "--silent", "--no-save", "--prefix", str(folder), "rhino3dm@8.17.0"], capture_output=True, text=True)
        if done.returncode != 0:
            pytest.skip(f"npm has no rhino3dm here: {done.stderr[-200:]}")
    return folder


def test_through_3dm(component, rhino3dm):
    """What the component makes is the same after McNeel's code has written and read it."""
    lines = stand_in_rhino.Line([-60, 0, 0], [0, 0, 0]), stand_in_rhino.Line([240, 260, 120], [240, 160, 120])
    for surface in (component("taut_between", curves=curves(ring()))["surface"],
                    component("taut_pipe", one=lines[0], other=lines[1], radius=20.0)["surface"]):
        given = {"rational": surface.IsRational, "orders": [surface.OrderU, surface.OrderV], "knots": [list(surface.KnotsU), list(surface.KnotsV)],
                 "places": surface.Points.places, "weights": surface.Points.weights}
        done = subprocess.run(["node", str(pathlib.Path(__file__).with_name("through_3dm.mjs"))], input=json.dumps(given), cwd=rhino3dm,
                              capture_output=True, text=True, env=dict(os.environ))
        assert done.returncode == 0, done.stderr
        again = json.loads(done.stdout)
        assert again["valid"] and again["knots"] == given["knots"] and again["degrees"] == [surface.OrderU - 1, surface.OrderV - 1]
        assert np.abs(np.array(again["places"]) - given["places"]).max() <= 1e-12 * 300
        assert np.abs(np.array(again["weights"]) - given["weights"]).max() <= 1e-15
