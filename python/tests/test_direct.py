"""Functions of constructions that go straight to C give what the document gives: the same bytes, or the same error."""
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import taut
from taut import _direct, making

SETTINGS = settings(max_examples=60, deadline=None)
NUMBER = st.floats(-3, 3).map(lambda x: round(x, 3))
POSITIVE = st.floats(0.05, 3)
FLAG = st.booleans()
NAME = st.sampled_from(["roof", "a b", "x" * 99, "x" * 100, "x" * 300, "", "häuser", "line\n"])
SEED = st.integers(0, 2**32 - 1)


def optional(**members):
    """Each of these, or not."""
    return st.fixed_dictionaries({}, optional=members)


def outcome(call):
    """The bytes of the model, or what the error is made of."""
    try:
        return call().to_json()
    except taut.Error as error:
        return type(error), error.reason, error.where, error.message, error.found, error.expected


def compare(construct, members):
    """As a function and as a document."""
    function = getattr(taut, construct.replace("-", "_"))
    arguments = {{"lambda": "lambda_", "from": "from_"}.get(key, key): value for key, value in members.items()}
    assert outcome(lambda: function(**arguments)) == outcome(lambda: taut.make({"construct": construct, **members}))


def net_of(seed, u, v, open_to):
    """Random points; those inside, or the rows between the first and the last, are to be found."""
    points = np.random.default_rng(seed).standard_normal((u.count, v.count, 3))
    if open_to == "inside":
        points[1:-1, 1:-1] = np.nan
    elif open_to == "rows":
        points[1:-1] = np.nan
    elif open_to == "one number":
        points[1:-1, 1:-1, 0] = np.nan
    elif open_to == "infinite":
        points[0, 0] = np.inf
    return points


BASES = st.sampled_from([taut.bezier(1), taut.bezier(2), taut.bezier(3), taut.bezier(3, range=(0, 2)), taut.bezier(4), taut.bspline(2, count=5), taut.bspline(3, count=6),
                         taut.c_bezier(1.5), taut.h_bezier(1.0), taut.ce_bezier(1.0, 1.0, 1.0)])
OPEN = st.sampled_from(["inside", "inside", "inside", "rows", "one number", "infinite", "nothing"])


@SETTINGS
@given(SEED, BASES, BASES, OPEN, optional(aspect=st.one_of(POSITIVE, st.sampled_from(["auto", 0, -1, 2, True, "x"])), regular=FLAG, name=NAME, unit=st.sampled_from(["mm", "m"])))
def test_dirichlet(seed, u, v, open_to, members):
    compare("dirichlet", {"u": u, "v": v, "points": net_of(seed, u, v, open_to), **members})


@SETTINGS
@given(SEED, BASES, BASES, OPEN, st.sampled_from(["normal", "full", "other"]),
       optional(regular=FLAG, least=FLAG, tolerance=st.sampled_from([1e-8, 1e-6, 0, 1, 2, "small"]), max_iterations=st.sampled_from([50, 500, 1, 0, 1.5, True]), name=NAME))
def test_plateau(seed, u, v, open_to, method, members):
    points = net_of(seed, u, v, open_to)
    points += 3 * np.stack([*np.meshgrid(np.arange(u.count), np.arange(v.count), indexing="ij"), np.zeros((u.count, v.count))], axis=-1)
    compare("plateau", {"u": u, "v": v, "points": points, "method": method, **members})


EVEN = st.sampled_from(["refuse", "corner", "project", "raise", "none"])


@SETTINGS
@given(SEED, BASES, BASES, OPEN, optional(even=EVEN, allow_ill_conditioned=FLAG, name=NAME, fit=FLAG))
def test_harmonic_rows(seed, u, v, open_to, members):
    compare("harmonic", {"u": u, "v": v, "points": net_of(seed, u, v, "rows" if open_to == "inside" else open_to), **members})


@SETTINGS
@given(SEED, BASES, BASES, optional(even=EVEN, allow_ill_conditioned=FLAG, name=NAME, points=st.just(np.zeros((2, 2, 3)))), st.sampled_from([0, 0, 0, 1]))
def test_harmonic_derivative(seed, u, v, members, more):
    edge, cross = np.random.default_rng(seed).standard_normal((2, v.count + more, 3))
    compare("harmonic", {"from": "derivative", "u": u, "v": v, "edge": edge, "cross_derivative": cross, **members})


@SETTINGS
@given(SEED, BASES, BASES, OPEN, optional(name=NAME, edge=st.just("u0"), width=POSITIVE))
def test_biharmonic_rows(seed, u, v, open_to, members):
    compare("biharmonic", {"u": u, "v": v, "points": net_of(seed, u, v, open_to), **members})


EDGE = st.sampled_from(["u0", "u1", "v0", "v1", "w"])
WIDTH = st.one_of(POSITIVE, st.sampled_from([0, -1, "wide", True]))


def given_surface(seed, construct, degree, kind):
    """One that is as the construction wants it, one that is not, or a dict."""
    u = taut.bezier(degree)
    points = np.random.default_rng(seed).standard_normal((degree + 1, degree + 1, 3))
    if kind == "other":
        return taut.Surface(u, u, points, name="p")
    points[1:-1] = np.nan
    if construct == "biharmonic":
        points[1:-1, [0, -1]] = np.random.default_rng(seed).standard_normal((degree - 1, 2, 3))
    surface = getattr(taut, construct)(points, u=u, v=u).surfaces[0]
    return surface.to_dict() if kind == "dict" else surface


KIND = st.sampled_from(["as it is", "as it is", "as it is", "other", "dict"])


@SETTINGS
@given(SEED, KIND, EDGE, optional(width=WIDTH, contact=st.sampled_from(["c1", "c2", "g1"]), allow_ill_conditioned=FLAG, name=NAME))
def test_biharmonic_neighbour(seed, kind, edge, members):
    compare("biharmonic", {"surface": given_surface(seed, "biharmonic", 3, kind), "edge": edge, **members})


@SETTINGS
@given(SEED, KIND, EDGE, optional(width=WIDTH, contact=st.sampled_from(["c1", "g1", "g1", "c2"]), c=NUMBER, alpha=NUMBER, beta=NUMBER), FLAG)
def test_harmonic_extension(seed, kind, edge, members, merges):
    surface = given_surface(seed, "harmonic", 3, kind)
    if merges:
        try:
            members["neighbour"] = taut.harmonic_extension(surface=surface, edge="u1").surfaces[-1]
        except taut.Error:
            members["neighbour"] = surface
    compare("harmonic-extension", {"surface": surface, "edge": edge, **members})


@SETTINGS
@given(st.fixed_dictionaries({}, optional={"sign": st.sampled_from(["+", "-", "+", "x"]), "alpha": st.one_of(POSITIVE, st.just("1")), "beta": POSITIVE,
                                           "lambda": st.one_of(st.floats(-0.9, 1.2), st.just([0.1, 0.2]), st.just(np.float64(0.5)), st.just(0)), "theta": NUMBER,
                                           "mesh": st.sampled_from(["bezier", "bspline", "nurbs"]), "normalize": FLAG, "frames": st.sampled_from([2, 0]),
                                           "segments": st.sampled_from([[1, 1], [2, 3], (1, 2), [0, 1], [1], [1.5, 2], np.array([2, 1])]),
                                           "start": st.sampled_from([[0, 0], (0.5, -0.3), [1], np.array([0.1, 0.2]), ["0", 0]])}))
def test_bonnet(members):
    if {"sign", "alpha", "beta"} <= set(members):
        compare("bonnet", members)


POINT = st.lists(st.integers(-4, 4), min_size=3, max_size=3)
END = st.fixed_dictionaries({"point": st.one_of(POINT, POINT.map(lambda p: np.array(p, float)))}, optional={"direction": POINT, "handle": POSITIVE})
WAY = optional(**{"polygon": st.one_of(st.just([[5, 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]]), st.just(np.array([[5., 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]])), st.lists(POINT, min_size=3, max_size=4)),
                  "from": END, "to": END, "axes": st.lists(END, min_size=2, max_size=2)})


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(["polygon", "ends", "axes", "any"]), WAY, END, END,
       st.sampled_from([{"radius": 0.2}, {"radius": 0.2}, {"radius": 0}, {"radii": [0.2, 0.3]}, {"radii": [0.2, 0.3], "surface": "naive-sweep"}, {"radius": 1, "surface": "canal"}, {}]),
       optional(shape=st.sampled_from([{"alpha": 1, "beta": 1, "gamma": 1}, {"alpha": 1, "beta": 2, "gamma": 1.5}, {"alpha": 1, "gamma": 1}, {"auto": "curvature"}, {"auto": "x"}, "auto", 3]),
                joint=st.sampled_from(["g1", "g2"]), frame=st.sampled_from(["rotation-minimizing", "frenet", "x"]), domain=st.sampled_from(["strict", "extended"]), caps=FLAG,
                pipe_lengths=st.sampled_from([[1, 2], [None, 1], [0, 1], [1]]), bend_radius=st.sampled_from([0.1, "1.5D", -1])))
def test_pipe(kind, way, one, other, section, members):
    if kind == "polygon":
        way = {"polygon": [[5, 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]]}
    elif kind == "ends":
        way = {"from": {"point": [0, 0, 0], "direction": [0, 0, 1]}, "to": {**one, "direction": other.get("direction", [1, 0, 0])}}
    elif kind == "axes":
        way = {"axes": [one, other]}
    compare("pipe", {**way, **section, "shape": {"alpha": 1, "beta": 1, "gamma": 1}, **members})


STRAIGHT = {
    "dirichlet": lambda: taut.dirichlet(net_of(1, U, U, "inside"), u=U, v=U, aspect=2.0, regular=True, name="roof"),
    "plateau": lambda: taut.plateau(net_of(1, U, U, "inside"), u=U, v=U, method="normal", least=False, tolerance=1e-6, max_iterations=100),
    "harmonic": lambda: taut.harmonic(net_of(1, U, U, "rows"), u=U, v=U, name="roof"),
    "harmonic, derivative": lambda: taut.harmonic(from_="derivative", u=U, v=U, edge=np.eye(4, 3), cross_derivative=np.ones((4, 3))),
    "biharmonic": lambda: taut.biharmonic(net_of(1, U, U, "inside"), u=U, v=U),
    "biharmonic, neighbour": lambda: taut.biharmonic(surface=given_surface(1, "biharmonic", 3, ""), edge="u1", contact="c2", width=0.5),
    "harmonic-extension": lambda: taut.harmonic_extension(surface=given_surface(1, "harmonic", 3, ""), edge="u1", contact="g1", c=2.0),
    "bonnet": lambda: taut.bonnet(sign="-", alpha=1.0, beta=1.5, lambda_=0.5, segments=[2, 1], mesh="bspline", start=[0.1, 0.2]),
    "pipe": lambda: taut.pipe(radius=0.2, polygon=[[5, 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]], shape={"alpha": 1, "beta": 1, "gamma": 1}, caps=True),
}
U = taut.bezier(3)


@pytest.mark.parametrize("name", STRAIGHT)
def test_no_document_between(name, monkeypatch):
    """What the struct of C can say is not written as a document, which takes longer."""
    def no_document(*_):
        raise AssertionError("a document was written")
    monkeypatch.setattr(_direct, "make", no_document)
    assert STRAIGHT[name]().certificate.holds is not False


JSON = st.recursive(st.one_of(st.none(), FLAG, st.integers(-2**70, 2**70), st.floats(), st.text(), st.just(np.float64(0.1)), st.just(np.int64(3)), st.just(np.bool_(True)), st.just(U),
                              st.just(np.arange(6.0).reshape(2, 3)), st.just(np.array([[0.1, np.nan, 2], [3, 4, 5]])), st.just(np.ma.masked_less(np.arange(6).reshape(2, 3), 3)),
                              st.just(np.array([1, np.inf])), st.just([1, np.nan, 2.5]), st.just(np.array(["a"])), st.just({1: 2})),
                    lambda inner: st.one_of(st.lists(inner, max_size=4), st.lists(inner, max_size=3).map(tuple), st.dictionaries(st.text(max_size=4), inner, max_size=4)), max_leaves=12)


@settings(max_examples=300, deadline=None)
@given(st.one_of(st.dictionaries(st.text(max_size=4), JSON, max_size=5), st.lists(JSON, max_size=4), st.lists(JSON, max_size=3).map(tuple)))
def test_text_of_a_document(document):
    """The quick way to a document's text gives the text of the way that goes through all of it."""
    def text(call):
        try:
            return call()
        except taut.InputError as error:
            return error.reason, error.where, error.message
    assert text(lambda: making.text_of_document(document)) == text(lambda: json.dumps(making.with_version(making.plain(document))))
