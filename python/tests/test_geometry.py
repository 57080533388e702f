"""Bases, curves and surfaces: views, evaluation, values."""
import copy
import gc
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import taut

BASES = [taut.bezier(3), taut.bezier(2, range=(-1, 4)), taut.bspline(3, count=7), taut.bspline(2, knots=[0, 0, 0, .3, .3, 1, 1, 1]),
         taut.c_bezier(1.5), taut.h_bezier(2.0), taut.c_bspline(1.0, 3), taut.h_bspline(0.5, 4)]


def bernstein(degree, t):
    """Bernstein polynomials by their definition."""
    from math import comb
    t = np.asarray(t)[..., None]
    i = np.arange(degree + 1)
    return np.array([comb(degree, k) for k in i]) * t**i * (1 - t)**(degree - i)


@pytest.mark.parametrize("basis", BASES, ids=repr)
def test_basis_is_a_value(basis):
    assert pickle.loads(pickle.dumps(basis)) == basis == taut.Basis(basis.to_dict()) == copy.deepcopy(basis)
    assert hash(taut.Basis(basis.to_dict())) == hash(basis)
    t = np.linspace(*basis.range, 33)
    assert basis(t).shape == (33, basis.count)
    assert np.abs(basis(t).sum(axis=-1) - 1).max() < 1e-13
    assert eval(repr(basis), {"taut": taut}) == basis


def test_basis_functions_are_bernsteins():
    t = np.linspace(0, 1, 11)
    assert np.abs(taut.bezier(4)(t) - bernstein(4, t)).max() < 1e-15


@pytest.mark.parametrize("make", [lambda: taut.bezier(0), lambda: taut.bezier(200), lambda: taut.bspline(3, knots=[0, 1, 0]),
                                  lambda: taut.bspline(3), lambda: taut.bspline(2, knots=[0, 1], count=3), lambda: taut.c_bezier(4.0),
                                  lambda: taut.Basis({"type": "bezier", "degree": 2.5}), lambda: taut.Basis({"type": "nurbs"}),
                                  lambda: taut.Basis({"type": "bezier", "degree": 3, "colour": 1}), lambda: taut.bezier(3, range=(1, 0)),
                                  lambda: taut.bspline(3, knots=[float("nan")] * 8), lambda: taut.bezier("three")])
def test_wrong_basis(make):
    with pytest.raises(taut.InputError) as caught:
        make()
    assert caught.value.reason and isinstance(caught.value, ValueError)


def surface_of(seed, weights=False):
    random = np.random.default_rng(seed)
    points = random.standard_normal((5, 4, 3))
    return taut.Surface(taut.bspline(3, count=5), taut.bezier(3), points, random.uniform(.5, 2, (5, 4)) if weights else None, "s"), points


@pytest.mark.parametrize("weights", [False, True])
def test_surface_is_a_value(weights):
    surface, points = surface_of(1, weights)
    same = pickle.loads(pickle.dumps(surface))
    assert same == surface and hash(same) == hash(surface) and same is not surface
    assert (surface.points == points).all() and surface.points is surface.points
    assert surface != surface_of(2, weights)[0]
    with pytest.raises(ValueError):
        surface.points[0, 0, 0] = 1
    points[0, 0, 0] += 1
    assert surface.points[0, 0, 0] != points[0, 0, 0]  # a copy was taken


def test_scalars_of_numpy_are_scalars():
    """In a loop over an array, say: the same bits as of Python's numbers."""
    surface = surface_of(3)[0]
    curve = taut.Curve(taut.bezier(3), surface.points[0])
    for u in np.linspace(0, 1, 5):
        assert surface(u, .25).tobytes() == surface(float(u), .25).tobytes() == surface(np.array([u]), .25).tobytes()
        assert surface(u, np.float32(.25)).shape == curve(u).shape == (3,) and curve(u).tobytes() == curve(float(u)).tobytes()
    for wrong in (np.float64("nan"), np.float64(1.5)):
        with pytest.raises(taut.InputError):
            surface(wrong, .5)


def test_views_survive_the_model():
    model = taut.make({"construct": "dirichlet", "u": taut.bezier(3), "v": taut.bezier(3),
                       "points": [[[i, j, i * j] if i in (0, 3) or j in (0, 3) else None for j in range(4)] for i in range(4)]})
    view, knots = model.surfaces[0].points, model.surfaces[0].u.breaks
    kept = view.copy()
    del model
    gc.collect()
    junk = [np.full(1000, 7.0) for _ in range(100)]
    assert (view == kept).all() and (knots == [0, 1]).all() and junk


@pytest.mark.parametrize("weights", [False, True])
def test_evaluation_is_the_definition(weights):
    surface, points = surface_of(3, weights)
    u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 5)
    nu, nv = surface.u(u), surface.v(v)
    w = np.ones((5, 4)) if surface.weights is None else surface.weights
    top = np.einsum("ai,bj,ij,ijk->abk", nu, nv, w, points)
    expected = top / np.einsum("ai,bj,ij->ab", nu, nv, w)[..., None]
    grid = surface.grid(u, v)
    assert grid.shape == (6, 7, 5, 3)
    assert np.abs(grid[0] - expected).max() < 1e-14
    pairs = surface(u[:, None], v[None, :], derivatives=2)
    assert pairs.shape == (6, 7, 5, 3)
    assert np.abs(pairs - grid).max() <= 1e-12 * np.abs(grid).max()
    assert surface(0.25, 0.5).shape == (3,) and surface([0.25], 0.5).shape == (1, 3) and surface([], []).shape == (0, 3)
    h = 1e-6
    for k, (du, dv) in ((1, (h, 0)), (2, (0, h))):
        slope = (surface(0.4 + du, 0.6 + dv) - surface(0.4 - du, 0.6 - dv)) / (2 * h)
        assert np.abs(slope - surface(0.4, 0.6, derivatives=1)[k]).max() < 1e-7


def test_grid_into_an_array():
    surface, _ = surface_of(4)
    u = np.linspace(0, 1, 9)
    for shape, derivatives in (((1, 9, 9, 3), 0), ((9, 9, 3), 0), ((3, 9, 9, 3), 1), ((6, 9, 9, 3), 2)):
        out = np.empty(shape)
        assert surface.grid(u, u, derivatives, out=out) is out
        assert (out.reshape(-1) == surface.grid(u, u, derivatives).reshape(-1)).all()
    for wrong in (np.empty((9, 9, 2)), np.empty((9, 9, 3), np.float32), np.empty((3, 9, 9)).T):
        with pytest.raises(taut.InputError):
            surface.grid(u, u, 0, out=wrong)


@pytest.mark.parametrize("call", [lambda s: s(2.0, 0.5), lambda s: s(float("nan"), 0.5), lambda s: s(.5, .5, derivatives=3),
                                  lambda s: s.grid([0, 2], [0]), lambda s: s.grid([[0]], [0]), lambda s: s(.5, .5, derivatives=-1),
                                  lambda s: s.grid([0], [0], 7)])
def test_wrong_parameters(call):
    with pytest.raises(taut.InputError):
        call(surface_of(5)[0])


def test_curve():
    points = np.random.default_rng(6).standard_normal((4, 3))
    curve = taut.Curve(taut.bezier(3), points, name="c")
    t = np.linspace(0, 1, 10).reshape(2, 5)
    assert np.abs(curve(t) - bernstein(3, t) @ points).max() < 1e-15
    assert curve(t, derivatives=3).shape == (4, 2, 5, 3) and curve(0.5).shape == (3,)
    assert pickle.loads(pickle.dumps(curve)) == curve and len({curve, pickle.loads(pickle.dumps(curve))}) == 1
    with pytest.raises(taut.InputError):
        curve(1.5)


@pytest.mark.parametrize("points, weights", [(np.zeros((4, 4)), None), (np.zeros((4, 4, 2)), None), (np.zeros((3, 4, 3)), None),
                                             (np.full((4, 4, 3), np.nan), None), (np.zeros((4, 4, 3)), np.zeros((4, 4))),
                                             (np.zeros((4, 4, 3)), np.ones((4, 3))), ("points", None)])
def test_wrong_nets(points, weights):
    with pytest.raises((taut.InputError, ValueError)):
        taut.Surface(taut.bezier(3), taut.bezier(3), points, weights)


@settings(max_examples=50, deadline=None)
@given(st.integers(1, 6), st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_operations_keep_the_points(p, q, seed):
    random = np.random.default_rng(seed)
    surface = taut.Surface(taut.bezier(p), taut.bezier(q), random.standard_normal((p + 1, q + 1, 3)))
    u, v = random.uniform(0, 1, 9), random.uniform(0, 1, 9)
    here = surface(u, v)
    assert np.abs(surface.elevated("u")(u, v) - here).max() < 1e-13
    assert np.abs(surface.inserted("v", 0.4)(u, v) - here).max() < 1e-13
    assert np.abs(surface.transposed()(v, u) - here).max() < 1e-13
    assert np.abs(surface.reversed("u")(1 - u, v) - here).max() < 1e-13
    moved = surface.transformed(np.hstack([2 * np.eye(3), [[1], [0], [0]]]))
    assert np.abs(moved(u, v) - (2 * here + [1, 0, 0])).max() < 1e-13


def read_only(array):
    """The array, which cannot be written any more."""
    array.flags.writeable = False
    return array


S, C = taut.Surface(taut.bezier(2), taut.bezier(2), np.ones((3, 3, 3))), taut.Curve(taut.bezier(2), np.ones((3, 3)))


@pytest.mark.parametrize("call,said,reason", [
    (lambda: S(2, 2), "u is 2.0; expected 0.0 to 1.0", "parameter"),
    (lambda: S(0.5, -3.0), "v is -3.0; expected 0.0 to 1.0", "parameter"),
    (lambda: S([[0, 0.5], [1, 1.5]], 0), "u[1, 1] is 1.5; expected 0.0 to 1.0", "parameter"),
    (lambda: S(float("nan"), 0.0), "u is nan", "parameter"),
    (lambda: S.grid([0, 1], [0, 1, 7]), "v[2] is 7.0", "parameter"),
    (lambda: C([0, 0.5, -1]), "t[2] is -1.0", "parameter"),
    (lambda: S("a", 0), "u: found str, expected numbers", "type"),
    (lambda: S(1j, 0), "u: found complex, expected numbers", "type"),
    (lambda: S(np.zeros(3), np.zeros(4)), "u has the shape (3,), v (4,)", "size"),
    (lambda: S(0.5, 0.5, 3), "derivatives is 3; expected 0 to 2", "argument"),
    (lambda: C(0.5, 1.5), "derivatives is 1.5; expected a whole number", "type"),
    (lambda: S.grid([0], [0], 0, out=[1]), "out is a list; expected an array", "type"),
    (lambda: S.grid([0], [0], 0, out=np.empty((1, 1, 3), np.float32)), "out is an array of float32; expected float64", "type"),
    (lambda: S.grid([0], [0], 1, out=np.empty((1, 1, 3))), "out has the shape (1, 1, 3); expected (3, 1, 1, 3)", "size"),
    (lambda: S.grid([0], [0], 0, out=read_only(np.empty((1, 1, 3)))), "out is read-only", "argument"),
    (lambda: S.grid([0, 1], [0], 0, out=np.empty((3, 2, 1)).T.reshape(2, 1, 3, order="A")[::-1]), "out is not in C order", "argument"),
    (lambda: S(None, 0.3), "u: found NoneType, expected numbers (None is no number)", "type"),
    (lambda: S(0.3, [0.1, None]), "v: found list, expected numbers", "type"),
    (lambda: S.grid([None], [0]), "u: found list", "type"),
    (lambda: C(None), "t: found NoneType", "type"),
    (lambda: S.u(None), "t: found NoneType", "type"),
    (lambda: S.transformed([[None] * 4] * 3), "matrix: found list", "type"),
    (lambda: taut.Surface(taut.bezier(1), taut.bezier(1), [[[0, 0, None]] * 2] * 2), "points: found list", "type"),
    (lambda: taut.bspline(1, knots=[0, 0, None, 1, 1]), "knots: found list", "type"),
    (lambda: taut.to_unit(taut.Model([S]), None), "unit is None; expected one of mm", "type"),
    (lambda: taut.Model([S]).to_text(None), "format is None; expected an ending", "type"),
    (lambda: taut.follow(S, "geodesic", (0.5, None), (1, 0)), "at: found tuple", "type"),
    (lambda: S.grid([0], [0], threads="x"), "threads is 'x'", "type"),
    (lambda: S.elevated("x"), "the direction is 'x'; expected 'u' or 'v'", "name"),
    (lambda: S.elevated("u", 2**32 + 1), "times is 4294967297", "type"),
    (lambda: S.inserted("u", "b"), "knot is 'b'", "type"),
    (lambda: S.transformed(np.ones((3, 3))), "the matrix has the shape (3, 3)", "size"),
    (lambda: S.mesh(tolerance=-1), "tolerance is -1.0; expected 0 or more", "argument"),
    (lambda: taut.Surface(taut.bezier(1), taut.bezier(1), "abc"), "points: found str", "type"),
    (lambda: taut.Surface(taut.bezier(1), taut.bezier(1), np.ones((2, 2, 3)), name=3), "found int, expected a text", "type"),
    (lambda: taut.Model(S), "found Surface, expected a list of surfaces", "type"),
    (lambda: taut.dirichlet(np.ones((3, 3, 3)), u=taut.bezier(2), v=taut.bezier(2), threads="x"), "threads is 'x'", "type"),
    (lambda: list(taut.map(3)), "found int, expected a list of documents", "type"),
    (lambda: list(taut.map([], client=3)), "client is 3", "type"),
])
def test_errors_say_what_is_wrong(call, said, reason):
    with pytest.raises(taut.InputError) as caught:
        call()
    assert str(caught.value).startswith(said) and caught.value.reason == reason


def test_curve_operations():
    curve = taut.Curve(taut.bspline(2, count=5), np.random.default_rng(4).standard_normal((5, 3)))
    t = np.linspace(0, 1, 33)
    assert np.allclose(curve.reversed()(1 - t), curve(t), rtol=0, atol=1e-14)
    assert curve.elevated(2).t.degree == 4 and np.allclose(curve.elevated(2)(t), curve(t), rtol=0, atol=1e-14)
    assert curve.inserted(0.4).t.count == 6 and np.allclose(curve.inserted(0.4)(t), curve(t), rtol=0, atol=1e-14)
    turned = curve.transformed([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]])
    assert np.allclose(turned(t), curve(t) @ [[0, 1, 0], [-1, 0, 0], [0, 0, 1]] + [5, 6, 7], rtol=0, atol=1e-14)


def test_mesh_of_a_surface():
    mesh, whole = S.mesh(divide=3), taut.Model([S]).mesh(divide=3)
    assert np.array_equal(mesh.vertices, whole.vertices) and len(mesh.triangles) == len(whole.triangles) > 0
