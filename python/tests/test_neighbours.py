"""Other packages' curves and surfaces. What is not installed is stood for by the members that are used."""
import sys
import types

import numpy as np
import pytest

import taut
from taut import neighbours


def curve_of(seed):
    return taut.Curve(taut.bspline(3, knots=[0, 0, 0, 0, .4, 1, 1, 1, 1]), np.random.default_rng(seed).standard_normal((5, 3)), name="c")


def test_scipy_curve():
    interpolate = pytest.importorskip("scipy.interpolate", reason="needs python3-scipy")
    curve, t = curve_of(1), np.linspace(0, 1, 41)
    spline = neighbours.to_scipy(curve)
    assert isinstance(spline, interpolate.BSpline) and np.abs(spline(t) - curve(t)).max() < 1e-15
    assert neighbours.from_scipy(spline, "c") == curve
    with pytest.raises(taut.InputError):
        neighbours.to_scipy(taut.Curve(taut.bezier(1), np.eye(3)[:2], [1, 2]))


def test_scipy_surface():
    interpolate = pytest.importorskip("scipy.interpolate", reason="needs python3-scipy")
    if not hasattr(interpolate, "NdBSpline"):
        pytest.skip("needs scipy 1.12")
    surface = taut.Surface(taut.bspline(3, count=5), taut.bspline(2, count=4), np.random.default_rng(2).standard_normal((5, 4, 3)))
    spline = neighbours.to_scipy(surface)
    uv = np.random.default_rng(3).uniform(0, 1, (20, 2))
    assert np.abs(spline(uv) - surface(*uv.T)).max() < 1e-14
    assert neighbours.from_scipy(spline) == surface


def test_geomdl():
    """geomdl's objects by the members that its documentation names."""
    curve = curve_of(4)
    shape = types.SimpleNamespace(degree=3, knotvector=curve.t.knots.tolist(), ctrlpts=curve.points.tolist(), rational=False, name="c")
    assert neighbours.from_geomdl(shape) == curve
    points, weights = np.random.default_rng(5).standard_normal((3, 4, 3)), np.random.default_rng(6).uniform(1, 2, (3, 4))
    shape = types.SimpleNamespace(degree_u=2, degree_v=3, knotvector_u=[0] * 3 + [1] * 3, knotvector_v=[0] * 4 + [1] * 4,
                                  ctrlpts=points.reshape(-1, 3).tolist(), weights=weights.ravel().tolist(), rational=True, name="s",
                                  ctrlpts_size_u=3, ctrlpts_size_v=4)
    surface = neighbours.from_geomdl(shape)
    assert (surface.points == points).all() and (surface.weights == weights).all() and surface.name == "s"
    if pytest.importorskip("geomdl", reason="needs geomdl"):
        assert neighbours.from_geomdl(neighbours.to_geomdl(curve)) == curve


class StandIn:
    """What geomdl's NURBS classes document: the degree first, then at least one point more, lists of x w, y w, z w, w, then as many
    knots as points, degree and 1; points and weights are read apart."""
    rational, name = True, ""

    def __init__(self, normalize_kv=True):
        assert not normalize_kv

    def _taken(self, points, most):
        assert len(points) >= most and all(isinstance(point, list) and len(point) == 4 for point in points)
        self._points = [[float(x) for x in point] for point in points]

    ctrlpts = property(lambda self: [[x / point[3] for x in point[:3]] for point in self._points])
    weights = property(lambda self: [point[3] for point in self._points])


class StandInCurve(StandIn):
    ctrlptsw = property(None, lambda self, points: self._taken(points, self.degree + 1))

    def _set_knots(self, knots):
        assert len(knots) == len(self._points) + self.degree + 1 and sorted(knots) == knots
        self._knots = knots
    knotvector = property(lambda self: self._knots, _set_knots)


class StandInSurface(StandIn):
    def _set_points(self, points):
        assert len(points) == self.ctrlpts_size_u * self.ctrlpts_size_v
        self._taken(points, (self.degree_u + 1) * (self.degree_v + 1))
    ctrlptsw = property(None, _set_points)

    def _set_knots(self, key, knots, count):
        assert self._points and len(knots) == count and sorted(knots) == knots
        setattr(self, key, knots)
    knotvector_u = property(lambda self: self._u, lambda self, knots: self._set_knots("_u", knots, self.ctrlpts_size_u + self.degree_u + 1))
    knotvector_v = property(lambda self: self._v, lambda self, knots: self._set_knots("_v", knots, self.ctrlpts_size_v + self.degree_v + 1))


def test_to_geomdl(monkeypatch):
    """Into a stand-in of geomdl's classes, set in the order that they ask for, and back."""
    nurbs = types.SimpleNamespace(Curve=StandInCurve, Surface=StandInSurface)
    monkeypatch.setitem(sys.modules, "geomdl", types.SimpleNamespace(NURBS=nurbs))
    curve, random = curve_of(7), np.random.default_rng(8)
    back = neighbours.from_geomdl(neighbours.to_geomdl(curve), name="c")
    assert back.t == curve.t and (back.points == curve.points).all() and (back.weights == 1).all()
    points, weights = random.standard_normal((6, 5, 3)), random.uniform(1, 2, (6, 5))
    surface = taut.Surface(taut.bspline(3, count=6), taut.bspline(2, count=5), points, weights)
    back = neighbours.from_geomdl(neighbours.to_geomdl(surface))
    assert back.u == surface.u and back.v == surface.v and (back.weights == weights).all()
    assert np.abs(back.points - points).max() < 1e-15 * 8


def test_meshio(tmp_path):
    """A mesh through meshio's own writer and reader."""
    meshio = pytest.importorskip("meshio", reason="needs python3-meshio")
    points = np.random.default_rng(5).standard_normal((3, 4, 3))
    model = taut.Model([taut.Surface(taut.bezier(2), taut.bezier(3), points)])
    mesh = model.mesh(divide=5)
    neighbours.to_meshio(model, divide=5).write(tmp_path / "x.vtk")
    back = meshio.read(tmp_path / "x.vtk")
    assert np.array_equal(back.points, mesh.vertices) and np.array_equal(back.cells_dict["triangle"], mesh.triangles)
    assert np.array_equal(back.point_data["parameters"][:, :2], mesh.parameters)  # VTK pads pairs


def test_meshio_cells(tmp_path):
    """Lagrange cells of two surfaces of other degrees: points and fields are those of the surfaces at a grid in each cell."""
    meshio = pytest.importorskip("meshio", reason="needs python3-meshio")
    rng = np.random.default_rng(6)
    made = [taut.Surface(taut.bezier(2), taut.bezier(3), rng.standard_normal((3, 4, 3)), name="a"),
            taut.Surface(taut.bezier(4), taut.bezier(1), rng.standard_normal((5, 2, 3)), name="b")]
    taut.Model(made).write(tmp_path / "x.vtu", divide=3, lagrange=True)
    mesh, first = meshio.read(tmp_path / "x.vtu"), 0
    assert [block.data.shape for block in mesh.cells] == [(9, 12), (9, 10)]
    for index, (surface, block) in enumerate(zip(made, mesh.cells)):
        p, q = surface.u.degree, surface.v.degree
        assert block.type == "VTK_LAGRANGE_QUADRILATERAL" and np.all(mesh.cell_data["surface"][index] == index)
        assert np.all(mesh.cell_data["HigherOrderDegrees"][index] == (p, q, 1))
        u, v = (np.concatenate([(cell + np.arange(d + 1) / d) / 3 for cell in range(3)]) for d in (p, q))
        cells = surface.grid(u, v, derivatives=1).reshape(3, 3, p + 1, 3, q + 1, 3).transpose(0, 1, 3, 2, 4, 5).reshape(3, -1, 3)
        here = slice(first, first + cells.shape[1])
        first = here.stop
        assert np.abs(mesh.points[here] - cells[0]).max() < 1e-14
        e, f, g = ((cells[i] * cells[j]).sum(axis=-1) for i, j in ((1, 1), (1, 2), (2, 2)))
        assert np.abs(mesh.point_data["F"][here] - f).max() < 1e-13 * (e + g).max()
        assert np.abs(mesh.point_data["E_minus_G"][here] - (e - g)).max() < 1e-13 * (e + g).max()
        assert sorted(np.unique(block.data)) == list(range(here.start, here.stop))
    assert first == len(mesh.points)
