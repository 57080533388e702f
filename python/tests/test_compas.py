"""The plug-in of COMPAS against a stand-in of what it uses: the package is on no machine of ours."""
import importlib
import sys
import types

import numpy as np
import pytest
from test_hosts import ring

import taut
from taut import hosts


def functions(knots, mults, degree, t):
    """All B-splines at t, by their recursion."""
    flat = np.repeat(np.asarray(knots, float), mults)
    last = np.flatnonzero(flat[:-1] < flat[1:])[-1]
    span = min(np.searchsorted(flat, t, side="right") - 1, last)
    values = np.zeros(len(flat) - 1)
    values[span] = 1
    for d in range(1, degree + 1):
        values = np.array([sum(share / width * value for share, width, value in (
            (t - flat[i], flat[i + d] - flat[i], values[i]), (flat[i + d + 1] - t, flat[i + d + 1] - flat[i + 1], values[i + 1])) if width > 0)
            for i in range(len(values) - 1)])
    return values


class Backend:
    """What compas 2 documents, with the rows and knots of a backend: U_FIRST, points[i][j] is that of u_i and v_j; SHORT, multiplicities
    that it gives leave out the outermost knots."""
    @classmethod
    def from_parameters(cls, points, weights, knots_u, knots_v, mults_u, mults_v, degree_u, degree_v, is_periodic_u=False, is_periodic_v=False):
        one = cls()
        net = np.array(points, float), np.array(weights, float)
        one.net = net if cls.U_FIRST else tuple(array.swapaxes(0, 1) for array in net)
        if one.net[0].shape[:2] != (sum(mults_u) - degree_u - 1, sum(mults_v) - degree_v - 1):
            raise RuntimeError("Standard_ConstructionError")
        one.full, one.degrees = (mults_u, mults_v), (degree_u, degree_v)
        given = [[m - (cls.SHORT and k in (0, len(mults) - 1)) for k, m in enumerate(mults)] for mults in one.full]
        one.__dict__.update(points=points, weights=weights, knots_u=knots_u, knots_v=knots_v, mults_u=given[0], mults_v=given[1],
                            degree_u=degree_u, degree_v=degree_v, is_periodic_u=is_periodic_u, is_periodic_v=is_periodic_v)
        return one

    def point_at(self, u, v):
        by = [functions(knots, mults, degree, t) for knots, mults, degree, t in
              zip((self.knots_u, self.knots_v), self.full, self.degrees, (u, v))]
        mass = np.outer(*by) * self.net[1]
        return np.einsum("ij,ijk->k", mass, self.net[0]) / mass.sum()


class OCCNurbsSurface(Backend):
    U_FIRST, SHORT = False, False


class RhinoNurbsSurface(Backend):
    U_FIRST, SHORT = True, True


def plugin(category=None, requires=None, tryfirst=False):
    assert category == "factories" and requires == ["taut"] and tryfirst
    return lambda function: function


@pytest.fixture(params=[OCCNurbsSurface, RhinoNurbsSurface])
def backend(request):
    return request.param


@pytest.fixture
def plug(monkeypatch, backend):
    for name, members in (("compas", {}), ("compas.geometry", {"NurbsSurface": backend}), ("compas.plugins", {"plugin": plugin})):
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
    u, v = taut.bspline(2, knots=[0, 0, 0, .5, 1, 1, 1]), taut.bspline(1, count=3)
    surface = taut.Surface(u, v, random.standard_normal((4, 3, 3)), random.uniform(1, 2, (4, 3)))
    theirs = plug.to_compas(surface)
    assert (theirs.knots_u, list(theirs.full[0]), theirs.degree_u, theirs.degree_v) == ([0, .5, 1], [3, 1, 3], 2, 1)
    assert plug.from_compas(theirs) == surface
    assert plug.from_compas(curves()[0]).points.tolist() == ring()[0].points.tolist()


def test_rows_of_square_nets(plug):
    """As many points along u as along v, on equal bases and others: the counts do not say what a row is."""
    random = np.random.default_rng(4)
    for u, v in ((taut.bezier(3), taut.bezier(3)), (taut.bspline(2, count=4), taut.bspline(1, count=4)), (taut.bezier(2), taut.bspline(1, count=5))):
        surface = taut.Surface(u, v, random.standard_normal((u.count, v.count, 3)))
        theirs = plug.to_compas(surface)
        assert np.abs(np.array(theirs.point_at(0.2, 0.7)) - surface(0.2, 0.7)).max() < 1e-14
        back = plug.from_compas(theirs)
        assert (back.points == surface.points).all() and back.weights is None


def test_fill(plug, backend):
    for style, construct in (("stretch", "dirichlet"), ("curved", "plateau")):
        made = plug.nurbssurface_from_fill(backend, *curves(), style=style)
        assert isinstance(made, backend)
        assert np.abs(plug.from_compas(made).points - hosts.between(construct, ring()).surfaces[0].points).max() <= 1e-12
    surface, certificate = plug.between("harmonic", curves())
    assert certificate.holds and isinstance(surface, backend)


def test_fill_between_two(plug, backend):
    """Two arcs that face each other, whichever way they run: the edges that are not given are straight."""
    first, _, second, _ = curves()
    made = [plug.from_compas(plug.nurbssurface_from_fill(backend, first, types.SimpleNamespace(**{**vars(second), "points": points})))
            for points in (second.points, second.points[::-1])]
    for surface in made:
        ends = surface.points[[0, -1]], surface.points[:, [0, -1]].swapaxes(0, 1)
        straight = [edge for pair in ends for edge in pair if np.linalg.matrix_rank(edge - edge[0], tol=1e-12) == 1]
        assert len(straight) == 2
    assert abs(taut.measure(made[0])["area"] - taut.measure(made[1])["area"]) < 1e-9


def test_refusals(plug, backend, monkeypatch):
    with pytest.raises(taut.InputError, match="found 3 edges"):
        plug.nurbssurface_from_fill(backend, *curves()[:3])
    with pytest.raises(taut.InputError, match="style"):
        plug.nurbssurface_from_fill(backend, *curves(), style="coons")
    surface = hosts.between("dirichlet", ring()).surfaces[0]
    periodic = plug.to_compas(surface)
    periodic.is_periodic_u = True
    with pytest.raises(taut.InputError, match="periodic"):
        plug.from_compas(periodic)
    torn = plug.to_compas(surface)
    torn.mults_u = [7, 7]
    with pytest.raises(taut.InputError, match="4 x 4 points"):
        plug.from_compas(torn)
    monkeypatch.setattr(backend, "point_at", lambda self, u, v: (0, 0, 0))
    with pytest.raises(taut.InputError, match="another surface"):
        plug.to_compas(surface)
