"""Wrong input of every kind raises the right error, with its data, and leaks nothing; thousands of calls from a pool."""
import concurrent.futures
import json
import os
import pathlib
import pickle
import subprocess
import sys

import numpy as np
import pytest

import taut
from taut import gismo, hosts, neighbours

U, V = taut.bspline(2, count=5), taut.bspline(3, count=6)
NET = np.random.default_rng(5).standard_normal((5, 6, 3))
OPEN = NET.copy()
OPEN[1:-1, 1:-1] = np.nan
PROBLEM = {"construct": "dirichlet", "u": U, "v": V, "points": OPEN}
MODEL = taut.make(PROBLEM)
SURFACE = MODEL.surfaces[0]
CURVE = taut.Curve(taut.bezier(2), NET[0, :3])
BOUNDARY = NET[:4, :4].copy()
BOUNDARY[1:-1, 1:-1] = np.nan
RATIONAL = taut.Surface(U, V, NET, np.ones((5, 6)) + np.arange(6))


def changed(**members):
    """The problem with other members."""
    return {**PROBLEM, **members}


def itself():
    """A document that contains itself."""
    document = dict(PROBLEM)
    document["through"] = [document]
    return document


def file(text):
    """A path to a file of that text."""
    path = pathlib.Path(os.environ.get("TMPDIR", "/tmp")) / f"taut-wrong-{os.getpid()}.json"
    path.write_text(text, encoding="utf-8")
    return path


def gone(call):
    """call(path), the file removed afterwards."""
    path = file('{"taut": 1, "surfaces": [')
    try:
        call(path)
    finally:
        path.unlink()


INPUT, NONE = taut.InputError, taut.NoSolution
WRONG = {
    # documents
    "no member": (INPUT, "missing", lambda: taut.make({"construct": "dirichlet"})),
    "no construction": (INPUT, "name", lambda: taut.make({"construct": "drichlet"})),
    "unknown member": (INPUT, "unknown-member", lambda: taut.make(changed(colour=1))),
    "another version": (INPUT, "version", lambda: taut.make(changed(taut=2))),
    "no object": (INPUT, "type", lambda: taut.make(3)),
    "none": (INPUT, "type", lambda: taut.make(None)),
    "what JSON has not": (INPUT, "type", lambda: taut.make(changed(aspect=object()))),
    "infinite": (INPUT, "value", lambda: taut.make(changed(aspect=float("inf")))),
    "complex": (INPUT, "type", lambda: taut.make(changed(points=NET * 1j))),
    "texts": (INPUT, "type", lambda: taut.make(changed(points=NET.astype(str)))),
    "infinite point": (INPUT, "value", lambda: taut.make(changed(points=np.where(NET > 1, np.inf, NET)))),
    "points of two": (INPUT, "size", lambda: taut.make(changed(points=OPEN[..., :2]))),
    "too few rows": (INPUT, "size", lambda: taut.make(changed(points=OPEN[:4]))),
    "ragged": (INPUT, "size", lambda: taut.make(changed(points=[*OPEN.tolist()[:4], OPEN.tolist()[4][:2]]))),
    "cyclic": (INPUT, "nesting", lambda: taut.make(itself())),
    "deep": (INPUT, "depth", lambda: taut.make("[" * 100000)),
    "broken text": (INPUT, "syntax", lambda: taut.make('{"taut": 1')),
    "twice": (INPUT, "twice", lambda: taut.make('{"taut": 1, "taut": 1}')),
    "lone surrogate": (INPUT, "text", lambda: taut.make('{"taut": 1, "construct": "\ud800"}')),
    "nothing known": (NONE, "nothing-known", lambda: taut.make(changed(points=[[None] * 6] * 5))),
    "one of many": (NONE, "nothing-known", lambda: taut.make([PROBLEM, changed(points=[[None] * 6] * 5)])),
    "no file": (taut.FileError, "read", lambda: taut.make("/nonexistent/problem.json")),
    "iterations": (taut.NotConverged, "iterations", lambda: taut.plateau(OPEN * [1, 1, 9], u=U, v=V, max_iterations=1)),
    "mask": (INPUT, "size", lambda: taut.dirichlet(NET, u=U, v=V, known=np.ones((2, 2), bool))),
    "known and not finite": (INPUT, "value", lambda: taut.dirichlet(OPEN, u=U, v=V, known=np.ones((5, 6), bool))),
    "threads": (INPUT, "argument", lambda: taut.make(PROBLEM, threads=0)),
    "threads, a text": (INPUT, "type", lambda: taut.make(PROBLEM, threads="2")),
    "tolerance, a text": (INPUT, "type", lambda: taut.make(PROBLEM, tolerance="small")),
    "progress": (INPUT, "type", lambda: taut.make(PROBLEM, progress=1)),
    "rational arithmetic": (INPUT, "no-rationals", lambda: taut.make(PROBLEM, exact=True)),
    "a claim": (taut.CheckFailed, "claim", lambda: taut.certify(MODEL, changed(aspect=3), strict=True)),
    "tolerance, below 0": (INPUT, "argument", lambda: taut.dirichlet(OPEN, u=U, v=V, tolerance=-1)),
    "tolerance, NaN": (INPUT, "argument", lambda: taut.dirichlet(OPEN, u=U, v=V, tolerance=float("nan"))),
    "aspect, 0": (INPUT, "value", lambda: taut.dirichlet(OPEN, u=U, v=V, aspect=0)),
    "aspect, a truth": (INPUT, "type", lambda: taut.dirichlet(OPEN, u=U, v=V, aspect=True)),
    "aspect, too large": (INPUT, "value", lambda: taut.dirichlet(OPEN, u=U, v=V, aspect=10 ** 400)),
    "regular, a text": (INPUT, "type", lambda: taut.dirichlet(OPEN, u=U, v=V, regular="no")),
    "name, a number": (INPUT, "type", lambda: taut.dirichlet(OPEN, u=U, v=V, name=3)),
    "ragged, with a mask": (INPUT, "type", lambda: taut.dirichlet([[1], [1, 2]], u=U, v=V, known=np.ones((2, 2), bool))),
    "masked whole numbers": (INPUT, "size", lambda: taut.make(changed(weights=np.ma.masked_less(np.arange(30).reshape(5, 6), 3)))),
    "two problems": (INPUT, "argument", lambda: taut.certify(MODEL, [PROBLEM, PROBLEM])),
    "no path": (INPUT, "type", lambda: taut.read(3)),
    "no path to write": (INPUT, "type", lambda: MODEL.write(None)),
    "model of no text": (INPUT, "type", lambda: taut.Model.from_json(5)),
    "model of a surrogate": (INPUT, "text", lambda: taut.Model.from_json("\ud800")),
    # bases, curves, surfaces
    "no basis": (INPUT, "type", lambda: taut.Surface(3, V, NET)),
    "basis with a NUL": (INPUT, "text", lambda: taut.Basis({"type": "bezier\0x", "degree": 3})),
    "knots, texts": (INPUT, "type", lambda: taut.bspline(1, knots=["0", "0", "1", "1"])),
    "knots, complex": (INPUT, "type", lambda: taut.bspline(1, knots=np.array([0, 0, 1, 1]) + 0j)),
    "knots, a table": (INPUT, "size", lambda: taut.bspline(1, knots=[[0, 0], [1, 1]])),
    "angle, a text": (INPUT, "type", lambda: taut.c_bezier("1.0")),
    "range, a text": (INPUT, "type", lambda: taut.bezier(3, range="01")),
    "functions at a text": (INPUT, "type", lambda: U("a")),
    "functions outside": (INPUT, "argument", lambda: U(2.0)),
    "derivatives of functions": (INPUT, "argument", lambda: U(0.5, 10 ** 9)),
    "derivatives, a text": (INPUT, "type", lambda: U(0.5, "1")),
    "points, texts": (INPUT, "type", lambda: taut.Surface(U, V, NET.astype(str))),
    "points, texts as objects": (INPUT, "type", lambda: taut.Surface(U, V, NET.astype(str).astype(object))),
    "points, dates": (INPUT, "type", lambda: taut.Surface(U, V, NET.astype("M8[s]"))),
    "points, masked": (INPUT, "type", lambda: taut.Surface(U, V, np.ma.masked_greater(NET, 0))),
    "degree": (INPUT, "value", lambda: taut.bezier(-1)),
    "knots": (INPUT, "knots", lambda: taut.bspline(3, knots=[0.0] * 1000)),
    "angle": (INPUT, "value", lambda: taut.c_bezier(4.0)),
    "net of one dimension": (INPUT, "size", lambda: taut.Surface(U, V, NET[0])),
    "net of another size": (INPUT, "size", lambda: taut.Surface(V, U, NET)),
    "NaN in a net": (INPUT, "value", lambda: taut.Surface(U, V, OPEN)),
    "weights": (INPUT, "value", lambda: taut.Surface(U, V, NET, -np.ones((5, 6)))),
    "shape of weights": (INPUT, "size", lambda: taut.Surface(U, V, NET, np.ones(6))),
    "points of a curve": (INPUT, "size", lambda: taut.Curve(taut.bezier(2), NET[0])),
    "parameter": (INPUT, "parameter", lambda: SURFACE(0.5, [0.1, 1.5])),
    "NaN, a parameter": (INPUT, "parameter", lambda: SURFACE(float("nan"), 0)),
    "text of a number, a parameter": (INPUT, "type", lambda: SURFACE("0.5", 0)),
    "text, a parameter": (INPUT, "type", lambda: SURFACE("a", 0)),
    "shapes": (INPUT, "size", lambda: SURFACE(np.zeros(2), np.zeros(3))),
    "derivatives": (INPUT, "argument", lambda: SURFACE.grid([0], [0], 3)),
    "out": (INPUT, "size", lambda: SURFACE.grid([0.0], [0.0], 0, out=np.empty((2, 2, 3)))),
    "direction": (INPUT, "name", lambda: SURFACE.reversed("w")),
    "knot": (NONE, "parameter", lambda: SURFACE.inserted("u", 7.0)),
    "matrix": (INPUT, "size", lambda: SURFACE.transformed(np.eye(3))),
    # models
    "surfaces": (INPUT, "type", lambda: taut.Model(SURFACE)),
    "no surface": (INPUT, "type", lambda: taut.Model([CURVE])),
    "unit": (INPUT, "value", lambda: taut.Model([SURFACE], unit="yard")),
    "model's text": (INPUT, "syntax", lambda: taut.Model.from_json("{")),
    "broken file": (INPUT, "syntax", lambda: gone(taut.read)),
    "no such file": (taut.FileError, "read", lambda: taut.read("/nonexistent.step")),
    "place to write": (taut.FileError, "write", lambda: MODEL.write("/nonexistent/m.json")),
    "format": (INPUT, "", lambda: MODEL.to_text("doc")),
    "option": (TypeError, None, lambda: MODEL.to_text("obj", color="mean")),
    "colour": (INPUT, "name", lambda: MODEL.to_text("svg", colour="red")),
    "divide": (INPUT, "argument", lambda: MODEL.mesh(divide=-1)),
    "surface of a mesh": (INPUT, "surface", lambda: MODEL.mesh(surface="roof")),
    "thickness of a mesh": (NONE, "fold", lambda: MODEL.mesh(thickness=1e3)),
    "vertices of a mesh": (INPUT, "too-fine", lambda: SURFACE.mesh(divide=10 ** 6)),
    "raised too far": (INPUT, "degree", lambda: SURFACE.elevated("u", 1000)),
    "raised, no polynomial": (NONE, "basis", lambda: taut.Curve(taut.c_bezier(1.0), NET[:4, 0]).elevated()),
    "knot once too often": (INPUT, "argument", lambda: CURVE.inserted(0.5, 3)),
    "matrix too large": (INPUT, "value", lambda: CURVE.transformed(np.full((3, 4), 1e308))),
    "spline of another thing": (INPUT, "type", lambda: hosts.spline(3)),
    "mile": (INPUT, "argument", lambda: taut.to_unit(MODEL, "mile")),
    "no distance": (INPUT, "tolerance", lambda: taut.to_nurbs(MODEL, 0)),
    "refined along w": (INPUT, "value", lambda: taut.refine(MODEL, "w")),
    "pieces of another": (INPUT, "no-such-object", lambda: taut.pieces(MODEL, "roof")),
    "followed nowhere": (INPUT, "outside", lambda: taut.follow(SURFACE, "geodesic", (0.5, 5), (1, 0))),
    "followed by no net": (INPUT, "net", lambda: taut.follow(SURFACE, "spiral", (0.5, 0.5), (1, 0))),
    "no spline of scipy": (INPUT, "type", lambda: neighbours.from_scipy(3)),
    "nothing of geomdl": (INPUT, "type", lambda: neighbours.from_geomdl(3)),
    "uniform and given knots": (INPUT, "conflict", lambda: taut.bspline(3)),
    "no segment": (INPUT, "value", lambda: taut.h_bspline(1.0, 0)),
    "shape that is no number": (INPUT, "value", lambda: taut.ce_bezier(float("nan"), 0, 0)),
    "name": (KeyError, None, lambda: MODEL["roof"]),
    "cut": (taut.Error, "", lambda: taut.split(MODEL, u=7.0)),
    "cut twice": (INPUT, "conflict", lambda: taut.split(MODEL, 0.5, 0.5)),
    "edge": (INPUT, "name", lambda: taut.join(SURFACE, "u2", SURFACE, "u0")),
    "measured": (INPUT, "type", lambda: taut.measure(3)),
    "certified": (INPUT, "type", lambda: taut.certify(SURFACE)),
    "gradient": (INPUT, "name", lambda: taut.gradient(PROBLEM, MODEL, "volume")),
    "gradient of another": (INPUT, "other-model", lambda: taut.gradient(changed(points=OPEN + 1), MODEL)),
    "gradient of no film": (INPUT, "no-gradient", lambda: taut.film_gradient(PROBLEM, MODEL)),
    "net to follow": (INPUT, "net", lambda: taut.follow(SURFACE, "lines", (0.5, 0.5), (1, 0))),
    "one number to follow": (INPUT, "value", lambda: taut.follow(SURFACE, "geodesic", 3, (1, 0))),
    "what is told of steps": (INPUT, "type", lambda: taut.follow(SURFACE, "geodesic", (0.5, 0.5), (1, 0), sink=3)),
    "gradient of complex numbers": (INPUT, "type", lambda: taut.gradient(PROBLEM, MODEL, NET * 1j)),
    "gradient of masked numbers": (INPUT, "type", lambda: taut.gradient(PROBLEM, MODEL, np.ma.masked_greater(NET, 0))),
    "place to follow": (INPUT, "", lambda: taut.follow(SURFACE, "geodesic", (5, 5), (1, 0))),
    # sweeps, neighbours
    "no list": (INPUT, "type", lambda: taut.map(PROBLEM)),
    "a path for a list": (INPUT, "type", lambda: taut.map("designs.jsonl")),
    "no place for results": (INPUT, "type", lambda: taut.map([], out=3)),
    "XML of one": (INPUT, "type", lambda: gismo.write(SURFACE, "/nonexistent")),
    "no client": (INPUT, "type", lambda: taut.map([], client=3)),
    "no threads": (INPUT, "argument", lambda: taut.map([], threads=0)),
    "weights for scipy": (INPUT, "value", lambda: neighbours.to_scipy(RATIONAL)),
    "no XML": (INPUT, "", lambda: gone(gismo.read)),
    "edges that do not meet": (NONE, "gap", lambda: hosts.between("dirichlet", [CURVE, CURVE, CURVE, taut.Curve(taut.bezier(1), NET[3, :2])])),
}


@pytest.mark.parametrize("name", WRONG)
def test_right_error(name):
    kind, reason, call = WRONG[name]
    if name == "weights for scipy":
        pytest.importorskip("scipy", reason="needs python3-scipy")
    with pytest.raises(kind) as caught:
        call()
    if isinstance(caught.value, taut.Error):
        error = caught.value
        assert error.reason and (not reason or error.reason == reason), vars(error)
        assert error.message and str(error) == error.message and isinstance(error.where, str)
        again = pickle.loads(pickle.dumps(error))
        assert type(again) is type(error) and again.__dict__ == error.__dict__


LOOP = """
import ctypes, gc, os, resource, sys
sys.path[:0] = sys.argv[1:]
from test_wrong_input import WRONG

class Mallinfo2(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()]
libc = ctypes.CDLL(None)
if hasattr(libc, "mallinfo2"):
    libc.mallinfo2.restype = Mallinfo2

def used():
    gc.collect()
    info = libc.mallinfo2() if hasattr(libc, "mallinfo2") else Mallinfo2()
    return info.uordblks + info.hblkhd

def loop(call, times):
    for _ in range(times):
        try:
            call()
        except MemoryError:
            raise
        except Exception:
            pass
for _, _, call in WRONG.values():
    loop(call, 20)
pages = int(open("/proc/self/statm").read().split()[0])
resource.setrlimit(resource.RLIMIT_AS, (pages * os.sysconf("SC_PAGESIZE") + (6 << 20),) * 2)
for name, (_, _, call) in WRONG.items():
    grown = []
    while len(grown) < 10 and not (grown and grown[-1] < 50 * 32):  # what is kept for the next call is kept once
        before = used()
        loop(call, 50)
        grown.append(used() - before)
    if grown[-1] >= 50 * 32:
        print(name, grown)
print("done")
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs /proc")
def test_nothing_leaks():
    """All of it again and again, with 6 MB more than it had at first. The least that malloc gives is 32 bytes: who loses as much by each
    call is named."""
    environment = {**os.environ, "GLIBC_TUNABLES": "glibc.malloc.tcache_count=0", "PYTHONPATH": str(pathlib.Path(taut.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-c", LOOP, str(pathlib.Path(__file__).parent)], env=environment, check=False,
                          capture_output=True, text=True)
    assert done.stdout == "done\n", done.stderr


def test_thousands_from_a_pool():
    """Makes, evaluations, meshes, texts and errors from eight threads are what one thread gives."""
    parameters = np.linspace(0, 1, 7)
    text, grid, mesh = MODEL.to_json(), SURFACE.grid(parameters, parameters), MODEL.mesh(divide=2)

    def task(i):
        kind = i % 6
        if kind == 0:
            return taut.dirichlet(OPEN, u=U, v=V) == MODEL
        if kind == 1:
            return (SURFACE.grid(parameters, parameters) == grid).all()
        if kind == 2:
            return taut.Model.from_json(text).to_json() == text
        if kind == 3:
            return MODEL.mesh(divide=2) == mesh
        if kind == 4:
            return pickle.loads(pickle.dumps(MODEL.surfaces[0])) == SURFACE
        try:
            taut.make(changed(points=[[None] * 6] * 5))
        except taut.NoSolution as error:
            return error.reason == "nothing-known" and json.dumps(error.where) == '"/points"'
        return False
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        assert all(pool.map(task, range(3000)))
