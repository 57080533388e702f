"""Every argument of every function takes what it should, or is refused by an error of this package with its reason: none of numpy's or
ctypes', no warning, and nothing converted in silence."""
import collections
import datetime
import decimal
import fractions
import pathlib
import warnings

import numpy as np
import pytest

import taut
from taut import gismo, hosts, neighbours

U, V = taut.bspline(2, count=5), taut.bspline(3, count=6)
NET = np.random.default_rng(1).standard_normal((5, 6, 3))
OPEN = NET.copy()
OPEN[1:-1, 1:-1] = np.nan
ROWS = NET[:4, :4].copy()
ROWS[1:-1, 1:-1] = np.nan
PROBLEM = {"construct": "dirichlet", "u": U, "v": V, "points": OPEN}
MODEL = taut.make(PROBLEM)
SURFACE = MODEL.surfaces[0]
CURVE = taut.Curve(taut.bezier(2), NET[0, :3])
ENDS = [{"point": [0, 0, 0], "direction": [1, 0, 0]}, {"point": [3, 1, 0], "direction": [1, 0, 0]}]

WRONG = {
    "none": None, "truth": True, "zero": 0, "minus": -1, "part": 1.5, "nan": float("nan"), "inf": float("inf"), "huge": 10**400, "wide": 2**64,
    "text": "x", "no text": "", "nul": "a\0b", "surrogate": "\ud800", "bytes": b"x", "list": [], "tuple": (), "dict": {}, "number for a key": {1: 2},
    "mixed keys": {1: 2, "x": 3}, "set": {1, 2}, "object": object(), "complex": 1 + 2j, "numpy's complex": np.complex128(1 + 2j),
    "numpy's nan": np.float64("nan"), "single": np.float32(0.5), "byte": np.int8(1), "long double": np.longdouble(1), "time": np.datetime64("2020"),
    "duration": np.timedelta64(1, "s"), "masked": np.ma.masked, "masked array": np.ma.array([1.0, 2.0], mask=[1, 0]), "of none": np.array(0.5),
    "of one": np.array([0.5]), "of two": np.array([0.2, 0.3]), "of objects": np.array([None, 1], dtype=object), "of texts": np.array(["u0", "v"]),
    "empty": np.empty(0), "empty net": np.empty((0, 0, 3)), "ragged": [[1], [1, 2]], "nested": [[[[[1.0]]]]], "record": np.zeros(2, dtype=[("a", "f8")]),
    "truths": np.array([True, False]), "decimal": decimal.Decimal("0.5"), "fraction": fractions.Fraction(1, 2), "date": datetime.date(2020, 1, 1),
    "path": pathlib.Path("/nonexistent/x"), "range": range(3), "class": taut.Surface, "basis": U, "surface": SURFACE, "model": MODEL, "curve": CURVE,
    "memory": memoryview(b"abcdefgh"), "deque": collections.deque([1, 2]), "dots": ..., "big": np.array([1e300, -1e300]),
}

CALLS = {
    "bezier": (taut.bezier, {"degree": 3, "range": (0, 1)}),
    "bspline": (taut.bspline, {"degree": 1, "knots": [0, 0, 1, 1]}),
    "bspline of so many": (taut.bspline, {"degree": 2, "count": 5}),
    "c_bezier": (taut.c_bezier, {"alpha": 1.0, "range": (0, 1)}),
    "h_bspline": (taut.h_bspline, {"beta": 1.0, "segments": 3, "range": (0, 3)}),
    "ce_bezier": (taut.ce_bezier, {"alpha": 1.0, "beta": 1.0, "gamma": 1.0}),
    "Basis": (taut.Basis, {"document": {"type": "bezier", "degree": 2}, "functions": 0}),
    "functions": (U, {"t": 0.5, "derivatives": 0}),
    "Surface": (taut.Surface, {"u": U, "v": V, "points": NET, "weights": np.ones((5, 6)), "name": "n"}),
    "Curve": (taut.Curve, {"t": taut.bezier(2), "points": NET[0, :3], "weights": np.ones(3), "name": "n"}),
    "Model": (taut.Model, {"surfaces": [SURFACE], "curves": [CURVE], "unit": "m"}),
    "surface": (SURFACE, {"u": 0.5, "v": 0.5, "derivatives": 0}),
    "curve": (CURVE, {"t": 0.5, "derivatives": 0}),
    "grid": (SURFACE.grid, {"u": [0.5], "v": [0.5], "derivatives": 0, "out": np.empty((1, 1, 3)), "threads": 1}),
    "normals": (SURFACE.normals, {"u": 0.5, "v": 0.5}),
    "reversed": (SURFACE.reversed, {"direction": "u"}),
    "elevated": (SURFACE.elevated, {"direction": "u", "times": 1}),
    "inserted": (SURFACE.inserted, {"direction": "u", "knot": 0.4, "times": 1}),
    "transformed": (SURFACE.transformed, {"matrix": np.eye(3, 4)}),
    "curve inserted": (CURVE.inserted, {"knot": 0.4, "times": 1}),
    "mesh": (MODEL.mesh, {"tolerance": 0.1, "divide": 0, "surface": None, "threads": 1, "thickness": 0.0, "progress": None, "strict": False}),
    "to_text": (MODEL.to_text, {"format": "obj", "tolerance": 0.1, "threads": 1, "divide": 2, "thickness": 0.0, "surface": None, "title": "x",
                                "colour": "plain", "view": (1, 2), "no_net": False, "width": 100, "isolines": 3, "combs": True, "reduction": 1.0,
                                "tiles": ""}),
    "from_json": (taut.Model.from_json, {"text": "{}"}),
    "make": (taut.make, {"document": PROBLEM, "tolerance": 1e-6, "threads": 1, "progress": None, "strict": False, "exact": False}),
    "certify": (taut.certify, {"model": MODEL, "problem": PROBLEM, "tolerance": 1e-6, "threads": 1, "exact": False, "progress": None, "strict": False}),
    "read": (taut.read, {"path": "/nonexistent/x", "threads": 1, "progress": None}),
    "measure": (taut.measure, {"what": CURVE, "grid": 5, "threads": 1, "progress": None, "strict": False}),
    "join": (taut.join, {"a": SURFACE, "edge_a": "u0", "b": SURFACE, "edge_b": "u0", "strict": False}),
    "split": (taut.split, {"model": MODEL, "u": 0.5, "v": None, "name": None, "threads": 1, "progress": None, "strict": False}),
    "refine": (taut.refine, {"model": MODEL, "along": "uv", "name": None}),
    "pieces": (taut.pieces, {"model": MODEL, "name": None}),
    "to_unit": (taut.to_unit, {"model": MODEL, "unit": "m"}),
    "to_nurbs": (taut.to_nurbs, {"model": MODEL, "tolerance": 1e-6}),
    "follow": (taut.follow, {"surface": SURFACE, "net": "isoparametric", "at": (0.5, 0.5), "way": (1, 0), "family": None, "max_length": 1.0, "threads": 1}),
    "gradient": (taut.gradient, {"problem": PROBLEM, "model": MODEL, "of": "area", "progress": None, "threads": 1, "strict": False}),
    "film_gradient": (taut.film_gradient, {"problem": PROBLEM, "model": MODEL, "of": "energy", "edge": "u0", "corner": "u0v0", "axis": "x"}),
    "map": (lambda **members: list(taut.map(**members)), {"problems": [], "client": None, "threads": 1, "out": None, "progress": None, "strict": False}),
    "dirichlet": (taut.dirichlet, {"points": OPEN, "u": U, "v": V, "known": np.isfinite(OPEN).all(axis=-1), "aspect": 1.0, "regular": False, "name": "x",
                                   "unit": "mm", "tolerance": None, "threads": 1, "progress": None, "strict": False}),
    "plateau": (taut.plateau, {"points": OPEN, "u": U, "v": V, "method": "normal", "tolerance": 1e-9, "max_iterations": 1, "least": False}),
    "harmonic": (taut.harmonic, {"points": ROWS, "u": taut.bezier(3), "v": taut.bezier(3), "even": "refuse", "allow_ill_conditioned": True}),
    "harmonic_extension": (taut.harmonic_extension, {"surface": SURFACE, "edge": "u0", "width": 1.0, "contact": "g1", "c": 1.0, "alpha": 0.0, "beta": 0.0}),
    "biharmonic": (taut.biharmonic, {"surface": SURFACE, "edge": "u0", "width": 1.0, "contact": "c1"}),
    "bonnet": (taut.bonnet, {"sign": "+", "alpha": 1.0, "beta": 1.0, "lambda_": 1.0, "segments": (1, 1), "theta": 0.0, "normalize": False,
                             "start": (0, 0), "mesh": "bezier"}),
    "pipe": (taut.pipe, {"radius": 0.1, "axes": ENDS, "shape": "auto", "domain": "strict", "joint": "g1", "frame": "frenet", "pipe_lengths": (1.0, 1.0),
                         "caps": False}),
    "pipe along a polygon": (taut.pipe, {"radii": (0.1, 0.2), "polygon": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 1, 0]]}),
    "between": (hosts.between, {"construct": "dirichlet", "edges": [CURVE] * 4, "unit": "mm"}),
    "blend": (hosts.blend, {"one": ENDS, "other": [[3, 1, 0], [4, 1, 0]], "radius": 0.1, "unit": "mm"}),
    "spline": (hosts.spline, {"what": SURFACE}),
    "curve of a spline": (hosts.curve, {"degree": 1, "knots": [0, 0, 1, 1], "points": NET[0, :2], "weights": None, "name": ""}),
    "from_scipy": (neighbours.from_scipy, {"spline": None}),
    "from_geomdl": (neighbours.from_geomdl, {"shape": None}),
    "G+Smo, written": (gismo.write, {"shapes": [SURFACE], "path": "/nonexistent/x", "tolerance": 1e-9}),
    "G+Smo, read": (gismo.read, {"path": "/nonexistent/x"}),
    "in a model": (lambda name: name in MODEL, {"name": "x"}),
    "in a certificate": (lambda claim: claim in MODEL.certificate, {"claim": "x"}),
    "equal": (lambda other: (MODEL == other, SURFACE == other, CURVE == other, U == other, MODEL.certificate == other), {"other": 1}),
}


@pytest.mark.parametrize("name", CALLS)
def test_any_argument(name, tmp_path, monkeypatch):
    """One argument after the other is each of the wrong things; the others are right."""
    monkeypatch.chdir(tmp_path)  # where "x" is a file that may be written
    call, right = CALLS[name]
    for argument in right:
        for kind, value in WRONG.items():
            if argument == "progress" and callable(value):
                continue  # it is called, and its errors are its own
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                try:
                    call(**{**right, argument: value})
                except taut.Error as error:
                    assert error.reason and error.message, (argument, kind, error)
                except Exception as error:
                    raise AssertionError(f"{argument}, {kind}: {error!r}") from error


CONVERTED = {
    "the real part of a complex number": lambda: CURVE.inserted(np.complex128(0.4 + 1j)),
    "the time of a duration": lambda: hosts.blend([[0, 0, 0], [1, 0, 0]], [[3, 1, 0], [4, 1, 0]], np.timedelta64(1, "s")),
    "an end that is no set's": lambda: taut.bezier(3, range={0, 1}),
    "one angle for two": lambda: MODEL.to_text("svg", view=30),
    "what a text is not": lambda: taut.make(PROBLEM, strict="no"),
    "what an option is not": lambda: MODEL.to_text("svg", combs="no"),
    "a number between": lambda: taut.make(PROBLEM, exact=0.5),
    "the low bits of a count": lambda: taut.Basis({"type": "bezier", "degree": 2}, 2**32 + 3),
    "texts of truths": lambda: taut.dirichlet(NET, u=U, v=V, known=np.full((5, 6), "no")),
    "numbers for truths": lambda: taut.dirichlet(NET, u=U, v=V, known=np.full((5, 6), 0.5)),
    "a descriptor for a path": lambda: gismo.write([SURFACE], 1),
    "a descriptor to read": lambda: gismo.read(0),
    "a mask that is passed over": lambda: hosts.curve(1, [0, 0, 1, 1], NET[0, :2], np.ma.array([1.0, 2.0], mask=[1, 0])),
}


@pytest.mark.parametrize("name", CONVERTED)
def test_nothing_is_converted(name):
    """Not even what Python or numpy would make a number or a file of."""
    with pytest.raises(taut.InputError):
        CONVERTED[name]()


def test_names_are_texts():
    """An array compares by its items; it is no name."""
    for names in (MODEL, MODEL.certificate):
        for name in (np.array(["dirichlet", "stationary"]), np.array([1.0, 2.0]), None, 0):
            with pytest.raises(KeyError):
                names[name]
            assert name not in names
    assert "dirichlet" in MODEL and "stationary" in MODEL.certificate and MODEL.certificate["stationary"] in MODEL.certificate


def test_addresses_of_numbers():
    """Numbers between the addresses that C has them at are copied, those that come back too."""
    points = np.zeros(OPEN.nbytes + 1, dtype=np.uint8)[1:].view(np.float64).reshape(OPEN.shape)
    points[...] = OPEN
    out = np.zeros(2 * 3 * 3 * 8 + 1, dtype=np.uint8)[1:].view(np.float64).reshape(2, 3, 3)
    assert not points.flags.aligned and not out.flags.aligned
    assert taut.dirichlet(points, u=U, v=V) == MODEL
    assert taut._handle.numbers(points, "points").flags.aligned and taut._handle.side_by_side(points).flags.aligned
    u, v = [0.1, 0.7], [0.0, 0.5, 1.0]
    assert SURFACE.grid(u, v, 0, out=out) is out and np.array_equal(out, SURFACE.grid(u, v, 0)[0])
