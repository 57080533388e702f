"""What the functions of the constructions do: keywords to a document, or straight to C where that is quicker.

Arrays of float64 on bases that are there, plain numbers and words go into the struct of C that the document would be read into: tens of
microseconds less. Whatever else is said goes by a document, and so does what C then refuses, because the document says where.
"""
from __future__ import annotations

from ctypes import Structure, byref
from typing import Any, Callable, Mapping, NamedTuple, Sequence

import numpy as np

from . import _library as c
from ._handle import Array, address_of, encoded, is_masked, is_one_of, library, numbers, side_by_side
from ._watch import Progress
from .bases import Basis
from .errors import InputError
from .geometry import Surface
from .making import make, make_direct
from .model import Model


def take_words(said: dict[str, Any], members: Mapping[str, Any], words: Sequence[str]) -> None:
    """Adds members whose names are no names in Python, or are old ones: `**{"lambda": 0.5}`."""
    for key, value in members.items():
        if key not in words:
            raise TypeError(f"there is no member {key!r}")
        said[key] = value


def made_of(construct: str, members: Mapping[str, Any], known: Any, tolerance: float | None = None, threads: int | None = None,
            progress: Progress | None = None, strict: bool = False, exact: bool = False) -> Model:
    """The model of a construction; members that are None are not said."""
    said = {key: value for key, value in members.items() if value is not None}
    if known is not None:
        said["points"] = _masked(said.get("points"), known)
    fill = _DIRECT.get(construct)
    if fill is not None and exact is False and is_one_of(said.get("unit", "mm"), ("mm",)):
        try:
            call = fill(said)
            return make_direct(byref(call.problem), call.make, call.certify, call.is_brief, tolerance, threads, progress, strict)
        except (_ByDocument, InputError):
            pass  # which number is wrong, the document says
    model: Model = make({"construct": construct, **said}, tolerance, threads, progress, strict, exact)
    return model


def _masked(points: Any, known: Any) -> Any:
    net = np.array(numbers(points, "points"))
    mask = _truths(known)
    if net.ndim != 3 or mask.shape != net.shape[:2]:
        raise InputError(f"known has the shape {mask.shape}; expected {net.shape[:2]}, as points", "/known", "size")
    if not np.isfinite(net[mask]).all():
        raise InputError("a known point is not finite", "/points", "value")
    net[~mask] = np.nan
    return net


def _truths(known: Any) -> Any:
    """An array of truth values, or of 1 and 0."""
    try:
        mask = np.asarray(known)
    except ValueError:  # rows that are not equally long
        mask = np.empty(0, dtype=object)
    if mask.dtype.kind not in "biuf" or is_masked(known) or not np.isin(mask, (0, 1)).all():
        raise InputError(f"known: found {type(known).__name__}, expected an array of truth values", "/known", "type")
    return mask.astype(bool)


# --- Structs of C ----------------------------------------------------------------------------------------------------


class _ByDocument(Exception):
    """Something is said that only a document can say, or refuse."""


class _Call(NamedTuple):
    """A problem, what makes and what proves it, whether it is made in some milliseconds, so that Ctrl-C may wait, and what C looks at."""

    problem: Structure
    make: Any
    certify: Any
    is_brief: bool
    kept: tuple[Any, ...] = ()


_BRIEF = 400  # points of a net that one solve finds
_BRIEF_FILM = 25  # that a film of least area takes tens of milliseconds for: of 36 up to 90, of 64 up to 500
_BRIEF_SEGMENTS = 8
_NUMBERS = frozenset((float, int, np.float64))
_EDGES = ("u0", "u1", "v0", "v1")


def _allow(said: Mapping[str, Any], members: frozenset[str]) -> None:
    if not said.keys() <= members:
        raise _ByDocument


def _number(value: Any, above: float = -1e300, below: float = 1e300) -> float:
    if type(value) not in _NUMBERS or not above < value < below:
        raise _ByDocument
    return float(value)


def _whole(value: Any, least: int, most: int) -> int:
    if type(value) is not int or not least <= value <= most:
        raise _ByDocument
    return value


def _word(said: Mapping[str, Any], key: str, words: tuple[str, ...]) -> int:
    value = said.get(key, words[0])
    if type(value) is not str or value not in words:
        raise _ByDocument
    return words.index(value)


def _flag(said: Mapping[str, Any], key: str, otherwise: bool = False) -> bool:
    value = said.get(key, otherwise)
    if type(value) is not bool:
        raise _ByDocument
    return value


def _row(values: Any, count: int) -> tuple[float, ...]:
    """So many numbers."""
    if type(values) is np.ndarray and values.dtype == np.float64:
        values = values.tolist()
    if not isinstance(values, (list, tuple)) or len(values) != count:
        raise _ByDocument
    return tuple(map(_number, values))


def _name(said: Mapping[str, Any]) -> Any:
    name = said.get("name")
    if name is None:
        return None
    if type(name) is not str or not 0 < len(name) < 100 or not name.isascii() or not name.isprintable():
        raise _ByDocument
    return encoded(name)


def _bases(said: Mapping[str, Any]) -> tuple[Basis, Basis]:
    u, v = said.get("u"), said.get("v")
    if not isinstance(u, Basis) or not isinstance(v, Basis):
        raise _ByDocument
    return u, v


def _beziers(said: Mapping[str, Any]) -> tuple[Basis, Basis]:
    u, v = _bases(said)
    if u.type != "bezier" or v.type != "bezier":
        raise _ByDocument
    return u, v


def _net(said: Mapping[str, Any], u: Basis, v: Basis) -> tuple[Array, Any]:
    """Points and which are known: those without a NaN."""
    net = said.get("points")
    if type(net) is not np.ndarray or net.dtype != np.float64 or net.shape != (u.count, v.count, 3):
        raise _ByDocument
    net = side_by_side(net)
    if np.logical_or.reduce(np.isinf(net), axis=None):
        raise _ByDocument
    return net, np.logical_and.reduce(net == net, axis=-1).view(np.uint8)


def _points(values: Any, count: int) -> Array:
    """A row of points, none of them to be found."""
    if type(values) is not np.ndarray or values.dtype != np.float64 or values.shape != (count, 3) or not np.isfinite(values).all():
        raise _ByDocument
    return side_by_side(values)


def _surface(said: Mapping[str, Any], key: str = "surface") -> Surface:
    surface = said.get(key)
    if not isinstance(surface, Surface):
        raise _ByDocument
    return surface


_DIRICHLET = frozenset(("unit", "points", "u", "v", "aspect", "regular", "name"))
_PLATEAU = frozenset(("unit", "points", "u", "v", "regular", "name", "method", "tolerance", "max_iterations", "least"))


def _solved_net(said: Mapping[str, Any]) -> tuple[c.DirichletProblem, int, tuple[Any, ...]]:
    """The net of a Dirichlet problem, its points, and what C looks at."""
    u, v = _bases(said)
    if "ce-bezier" in (u.type, v.type):
        raise _ByDocument
    net, known = _net(said, u, v)
    aspect = said.get("aspect", 0.0)
    is_auto = type(aspect) is str and aspect == "auto"
    number = _number(aspect, 0.0) if "aspect" in said and not is_auto else 0.0
    return c.DirichletProblem(_name(said), u._pointer, v._pointer, address_of(net), address_of(known), None, number, int(is_auto),
                              int(_flag(said, "regular"))), known.size, (net, known, u, v)


def _dirichlet(said: Mapping[str, Any]) -> _Call:
    _allow(said, _DIRICHLET)
    problem, size, kept = _solved_net(said)
    return _Call(problem, library.taut_dirichlet_make, library.taut_dirichlet_certify, size <= _BRIEF, kept)


def _plateau(said: Mapping[str, Any]) -> _Call:
    _allow(said, _PLATEAU)
    net, size, kept = _solved_net(said)
    problem = c.PlateauProblem(net=net, method=_word(said, "method", ("full", "normal")), without_least=int(not _flag(said, "least", True)))
    if "tolerance" in said:
        problem.tolerance = _number(said["tolerance"], 0.0, 1.0)
    if "max_iterations" in said:
        problem.max_iterations = _whole(said["max_iterations"], 1, 2**31 - 1)
    return _Call(problem, library.taut_plateau_make, library.taut_plateau_certify, size <= _BRIEF_FILM, (kept, net))


_ROWS = frozenset(("unit", "points", "u", "v", "name", "even", "allow_ill_conditioned"))
_DERIVATIVE = frozenset(("unit", "from", "edge", "cross_derivative", "u", "v", "name", "even", "allow_ill_conditioned"))
_EVEN = ("refuse", "corner", "project", "raise")


def _harmonic(said: Mapping[str, Any]) -> _Call:
    u, v = _beziers(said)
    even, allows = _word(said, "even", _EVEN), int(_flag(said, "allow_ill_conditioned"))
    problem = c.HarmonicProblem(name=_name(said), u=u._pointer, v=v._pointer)
    if said.get("from") == "derivative":
        _allow(said, _DERIVATIVE)
        if even not in (0, 3):
            raise _ByDocument
        edge, cross = _points(said.get("edge"), v.count), _points(said.get("cross_derivative"), v.count)
        problem.given, problem.derivative = 1, c.HarmonicDerivative(edge=address_of(edge), cross=address_of(cross), allow_ill_conditioned=allows)
        setattr(problem.derivative, "raise", int(even == 3))
        kept: tuple[Any, ...] = (edge, cross)
    else:
        _allow(said, _ROWS)
        kept = _net(said, u, v)
        problem.rows = c.HarmonicRows(address_of(kept[0]), address_of(kept[1]), None, even, allows)
    return _Call(problem, library.taut_harmonic_make, library.taut_harmonic_certify, u.count * v.count <= _BRIEF, (*kept, u, v))


_BIHARMONIC_ROWS = frozenset(("unit", "points", "u", "v", "name"))
_BIHARMONIC_NEIGHBOUR = frozenset(("unit", "surface", "edge", "width", "contact", "allow_ill_conditioned"))


def _biharmonic(said: Mapping[str, Any]) -> _Call:
    problem = c.BiharmonicProblem()
    if "surface" in said:
        _allow(said, _BIHARMONIC_NEIGHBOUR)
        surface = _surface(said)
        problem.given = 1
        problem.neighbour = c.BiharmonicNeighbour(surface._pointer, _edge(said), _width(said), 1 + _word(said, "contact", ("c1", "c2")),
                                                  int(_flag(said, "allow_ill_conditioned")))
        size, kept = surface.points.size, (surface,)
    else:
        _allow(said, _BIHARMONIC_ROWS)
        u, v = _beziers(said)
        net, known = _net(said, u, v)
        problem.rows = c.BiharmonicRows(_name(said), u._pointer, v._pointer, address_of(net), address_of(known))
        size, kept = net.size, (net, known, u, v)  # type: ignore[assignment]
    return _Call(problem, library.taut_biharmonic_make, library.taut_biharmonic_certify, size <= 3 * _BRIEF, kept)


def _edge(said: Mapping[str, Any]) -> int:
    if "edge" not in said:
        raise _ByDocument
    return _word(said, "edge", _EDGES)


def _width(said: Mapping[str, Any]) -> float:
    return _number(said["width"], 0.0) if "width" in said else 0.0


_EXTENSION = frozenset(("unit", "surface", "edge", "width", "contact", "c", "alpha", "beta", "neighbour"))


def _harmonic_extension(said: Mapping[str, Any]) -> _Call:
    _allow(said, _EXTENSION)
    surface, width = _surface(said), _width(said)
    problem = c.ExtensionProblem(surface=surface._pointer, edge=_edge(said))
    kept = [surface]
    if _word(said, "contact", ("c1", "g1")) == 1:
        if "neighbour" in said:
            raise _ByDocument
        problem.given = 1
        problem.g1 = c.ExtensionG1(width, *(_number(said.get(key, otherwise)) for key, otherwise in (("c", 1.0), ("alpha", 0.0), ("beta", 0.0))))
    elif not said.keys().isdisjoint(("c", "alpha", "beta")):
        raise _ByDocument
    elif "neighbour" in said:
        if width > 0:
            raise _ByDocument
        kept.append(_surface(said, "neighbour"))
        problem.given, problem.merge = 2, c.ExtensionMerge(kept[1]._pointer)
    else:
        problem.c1.width = width
    return _Call(problem, library.taut_harmonic_extension_make, library.taut_harmonic_extension_certify, surface.points.size <= 3 * _BRIEF, tuple(kept))


_BONNET = frozenset(("unit", "sign", "alpha", "beta", "lambda", "mesh", "segments", "theta", "normalize", "start"))


def _bonnet(said: Mapping[str, Any]) -> _Call:
    _allow(said, _BONNET)
    if "sign" not in said:
        raise _ByDocument
    bend = _number(said.get("lambda"))
    segments = said.get("segments", (0, 0))
    if type(segments) not in (list, tuple) or len(segments) != 2:
        raise _ByDocument
    counts = tuple(_whole(count, 1, 1000) for count in segments) if "segments" in said else (0, 0)
    start = _row(said["start"], 2) if "start" in said else (0.0, 0.0)
    problem = c.BonnetProblem((bend, bend), 0, -1 if _word(said, "sign", ("+", "-")) else 1, _number(said.get("alpha")), _number(said.get("beta")),
                              _word(said, "mesh", ("bezier", "bspline")), counts, _number(said.get("theta", 0.0)), int(_flag(said, "normalize")), start)
    return _Call(problem, library.taut_bonnet_make, library.taut_bonnet_certify, max(counts) <= _BRIEF_SEGMENTS)


_PIPE = frozenset(("unit", "radius", "radii", "surface", "polygon", "from", "to", "axes", "shape", "domain", "joint", "frame", "pipe_lengths",
                   "bend_radius", "caps"))
_END, _SHAPE = frozenset(("point", "direction", "handle")), {"alpha", "beta", "gamma"}


def _pipe_end(end: Any) -> c.PipeEnd:
    if type(end) is not dict or not end.keys() <= _END or "point" not in end:
        raise _ByDocument
    direction = _row(end.get("direction"), 3)
    if not any(direction):
        raise _ByDocument
    return c.PipeEnd(_row(end["point"], 3), direction, _number(end["handle"], 0.0) if "handle" in end else 0.0)


def _pipe_axis(said: Mapping[str, Any], axis: c.PipeAxis) -> None:
    """One of `polygon`, `from` with `to`, and `axes`."""
    if ("polygon" in said) + ("from" in said or "to" in said) + ("axes" in said) != 1:
        raise _ByDocument
    if "polygon" in said:
        rows = said["polygon"]
        if not (isinstance(rows, (list, tuple)) or (type(rows) is np.ndarray and rows.ndim == 2)) or len(rows) != 4:
            raise _ByDocument
        for i, row in enumerate(rows):
            axis.polygon[i] = _row(row, 3)
        return
    axis.kind = 2 if "axes" in said else 1
    ends = said["axes"] if "axes" in said else (said.get("from"), said.get("to"))
    if type(ends) not in (list, tuple) or len(ends) != 2:
        raise _ByDocument
    axis.ends[0], axis.ends[1] = map(_pipe_end, ends)


def _pipe_section(said: Mapping[str, Any], section: c.PipeSection) -> None:
    """`radius`, or two `radii`."""
    if ("radius" in said) + ("radii" in said) != 1 or ("surface" in said and "radius" in said):
        raise _ByDocument
    if "radius" in said:
        section.radius = _number(said["radius"], 0.0)
    else:
        section.kind = 2 + _word(said, "surface", ("canal", "naive-sweep"))
        section.radii[0], section.radii[1] = (_number(radius, 0.0) for radius in _row(said["radii"], 2))


def _pipe_shape(said: Mapping[str, Any], shape: c.PipeShape, is_g2: bool) -> None:
    """`shape` and `domain`."""
    given, shape.kind = said.get("shape", "auto"), 1
    if type(given) is dict and given.keys() == {"auto"}:
        shape.kind += _word(given, "auto", ("bending", "curvature"))
    elif type(given) is dict and given.keys() == _SHAPE and not is_g2:
        shape.kind, shape.alpha, shape.beta, shape.gamma = 0, *(_number(given[key]) for key in ("alpha", "beta", "gamma"))
    elif not is_one_of(given, ("auto",)):
        raise _ByDocument
    shape.extended = _word(said, "domain", ("strict", "extended"))


def _pipe(said: Mapping[str, Any]) -> _Call:
    _allow(said, _PIPE)
    problem = c.PipeProblem(joint=_word(said, "joint", ("g1", "g2")), frame=_word(said, "frame", ("rotation-minimizing", "frenet")),
                            caps=int(_flag(said, "caps")))
    _pipe_axis(said, problem.axis)
    _pipe_section(said, problem.section)
    _pipe_shape(said, problem.shape, problem.joint == 1)
    if "pipe_lengths" in said:
        lengths = said["pipe_lengths"]
        if type(lengths) not in (list, tuple) or len(lengths) != 2:
            raise _ByDocument
        problem.lengths[0], problem.lengths[1] = (0.0 if length is None else _number(length, 0.0) for length in lengths)
    if "bend_radius" in said:
        problem.bend_radius = _number(said["bend_radius"], 0.0)
    return _Call(problem, library.taut_pipe_make, library.taut_pipe_certify, False)


_DIRECT: dict[str, Callable[[Mapping[str, Any]], _Call]] = {
    "biharmonic": _biharmonic, "bonnet": _bonnet, "dirichlet": _dirichlet, "harmonic": _harmonic, "harmonic-extension": _harmonic_extension,
    "pipe": _pipe, "plateau": _plateau,
}
