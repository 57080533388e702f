"""The plug-in of COMPAS against a stand-in of what it uses: the package is on no machine of ours."""
import importlib
import sys
import types

import numpy as np
import pytest
from test_hosts import ring

import taut
from taut import hosts


class NurbsSurface:
    @classmethod
    def from_parameters(cls, points, weights, knots_u, knots_v, mults_u, mults_v, degree_u, degree_v, is_periodic_u=False, is_periodic_v=False):
        one = cls()
        one.__dict__.update(points=points, weights=weights, knots_u=knots_u, knots_v=knots_v, mults_u=mults_u, mults_v=mults_v,
                            degree_u=degree_u, degree_v=degree_v, is_periodic_u=is_periodic_u, is_periodic_v=is_periodic_v)
        return one


def plugin(category=None, requires=None):
    assert category == "factories" and requires == ["taut"]
    return lambda function: function


@pytest.fixture
def plug(monkeypatch):
    for name, members in (("compas", {}), ("compas.geometry", {"NurbsSurface": NurbsSurface}), ("compas.plugins", {"plugin": plugin})):
        module = types.ModuleType(name)
        module.__dict__.update(members)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.delitem(sys.modules, "taut.compas", raising=False)
    yield importlib.import_module("taut.compas")
    sys.modules.pop("taut.compas", None)


def curves():
    return [types.SimpleNamespace(degree=3, knots=[0.0, 1.0], multiplicities=[4, 4], points=one.points.tolist(), weights=[1.0] * 4) for one in ring()]


def test_there_and_back(plug):
    random = np.random.default_rng(3)
    surface = taut.Surface(taut.bspline(2, knots=[0, 0, 0, .5, 1, 1, 1]), taut.bspline(1, count=3), random.standard_normal((4, 3, 3)),
                           random.uniform(1, 2, (4, 3)))
    theirs = plug.to_compas(surface)
    assert (theirs.knots_u, theirs.mults_u, theirs.degree_u, theirs.degree_v) == ([0, .5, 1], [3, 1, 3], 2, 1)
    assert plug.from_compas(theirs) == surface
    assert plug.from_compas(curves()[0]).points.tolist() == ring()[0].points.tolist()


def test_fill(plug):
    for style, construct in (("stretch", "dirichlet"), ("curved", "plateau")):
        made = plug.nurbssurface_from_fill(NurbsSurface, *curves(), style=style)
        assert isinstance(made, NurbsSurface) and np.abs(np.array(made.points) - hosts.between(construct, ring()).surfaces[0].points).max() <= 1e-12
    surface, certificate = plug.between("harmonic", curves())
    assert certificate.holds and isinstance(surface, NurbsSurface)


def test_refusals(plug):
    with pytest.raises(taut.InputError, match="found 3 edges"):
        plug.nurbssurface_from_fill(NurbsSurface, *curves()[:3])
    with pytest.raises(taut.InputError, match="style"):
        plug.nurbssurface_from_fill(NurbsSurface, *curves(), style="coons")
    periodic = plug.to_compas(hosts.between("dirichlet", ring()).surfaces[0])
    periodic.is_periodic_u = True
    with pytest.raises(taut.InputError, match="periodic"):
        plug.from_compas(periodic)
