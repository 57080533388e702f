"""What plug-ins of other programs share.

    between   a surface from four edges, in any order and direction
    blend     a pipe between two straight ones, which are given by their ends
    nearest   which edges of two surfaces meet, and how
    spline    a curve or a surface as CAD kernels take it: degrees, distinct knots with their multiplicities, points, weights
    curve     the way back, from a clamped spline
    claims    a certificate as lines to print
    told      an error as a message with what to change
"""
from __future__ import annotations

import os
import tempfile
from typing import Any, NamedTuple, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._handle import expect, is_one_of, items_of, numbers, whole
from ._watch import Progress
from .bases import bspline, bezier
from .errors import Error, InputError
from .geometry import Curve, Surface
from .making import make
from .measuring import join, to_nurbs
from .model import Certificate, Model

CONSTRUCTS = ("dirichlet", "plateau", "harmonic", "asymptotic")


def between(construct: str, edges: Sequence[Curve], unit: str = "mm", progress: Progress | None = None, threads: int | None = None,
            strict: bool = False, **members: Any) -> Model:
    """The model of "dirichlet", "plateau", "harmonic" or "asymptotic" between four curves whose ends meet, in any order and
    direction; the first becomes the edge v0. members are those of the construction's document, such as degree=[3, 3].

    Two straight edges that face each other leave nothing to find: both directions get degree 3 then, unless degree is given.

    Errors: InputError: not four edges, ends that do not meet, or what else `taut.make` finds in the problem."""
    if not is_one_of(construct, CONSTRUCTS):
        raise InputError(f"the surface is {construct!r}; expected one of {', '.join(CONSTRUCTS)}", "/construct", "value")
    edges = list(items_of(edges, "curves"))
    for edge in edges:
        expect(edge, Curve)
    if len(edges) != 4:
        raise InputError(f"found {len(edges)} edges; expected four that close a ring", "/boundary", "size", len(edges), 4)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "edges.json")
        model = Model(curves=[_bezier(edge) if construct in ("harmonic", "asymptotic") else edge for edge in edges], unit=unit)
        model.write(path)
        made: Model = make({"construct": construct, "unit": unit, "boundary": path, **members}, threads=threads, progress=progress,
                           strict=strict)
        return made


def _bezier(edge: Curve) -> Curve:
    """A spline of one span as what it is, over [0, 1]."""
    if edge.t.type == "bspline" and len(edge.t.breaks) == 2 and edge.t.degree is not None:
        weights = edge.weights
        if weights is not None and np.all(weights == weights[0]):
            weights = None
        return Curve(bezier(edge.t.degree), edge.points, weights, edge.name)
    return edge


def _line(ends: npt.ArrayLike, where: str) -> npt.NDArray[np.float64]:
    line = numbers(ends, where)
    if line.shape != (2, 3) or not np.isfinite(line).all() or not np.any(line[0] != line[1]):
        raise InputError(f"{where}: expected two ends that differ, of shape (2, 3)", where, "value")
    return line


def blend(one: npt.ArrayLike, other: npt.ArrayLike, radius: Union[float, Sequence[float]], unit: str = "mm",
          progress: Progress | None = None, threads: int | None = None, strict: bool = False, **members: Any) -> Model:
    """The pipe that joins two straight ones, (2, 3) each: the ends of their axes. The two ends that are nearest are joined.

    radius    one, or two that differ
    members   of the document of `pipe`, such as joint="g2"

    Errors: InputError: ends that do not differ; NoSolution of `taut.pipe`, such as a radius that is too large.
    """
    first, second = _line(one, "/from"), _line(other, "/to")
    distances = np.linalg.norm(first[:, None] - second[None], axis=-1)
    i, j = divmod(int(np.argmin(distances)), 2)
    size = numbers(radius, "radius").ravel()
    if size.size not in (1, 2):
        raise InputError(f"radius is {radius!r}; expected a number or two", "/radius", "size")
    round_pipe: dict[str, Any] = {"radius": float(size[0])} if size.size == 1 or size[0] == size[1] else {"radii": size.tolist()}
    made: Model = make({"construct": "pipe", "unit": unit, **round_pipe, **members,
                        "from": {"point": first[i], "direction": _unit(first[i] - first[1 - i])},
                        "to": {"point": second[j], "direction": _unit(second[1 - j] - second[j])},
                        }, threads=threads, progress=progress, strict=strict)
    return made


def _unit(vector: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return np.asarray(vector / np.linalg.norm(vector))


def nearest(a: Surface, b: Surface) -> tuple[str, str, dict[str, Any]]:
    """The edge of a and the edge of b with the least gap between them, and what `taut.join` says of the two.

    Errors: InputError, `type`: not surfaces."""
    names = ("u0", "u1", "v0", "v1")
    found = [(one, other, join(a, one, b, other)) for one in names for other in names]
    return min(found, key=lambda item: (float(item[2]["max_gap"]), float(item[2].get("max_normal_angle") or 0)))


class Spline(NamedTuple):
    """degrees, knots (distinct) and multiplicities: one list for each direction; points (..., 3) Euclidean; weights or None."""

    degrees: tuple[int, ...]
    knots: tuple[list[float], ...]
    multiplicities: tuple[list[int], ...]
    points: npt.NDArray[np.float64]
    weights: npt.NDArray[np.float64] | None


def spline(what: Union[Curve, Surface], tolerance: float = 1e-9) -> Spline:
    """Exact where the bases are polynomial; else (c- and h- bases) NURBS within tolerance times the size.

    Errors: InputError, `type`: neither a curve nor a surface."""
    expect(what, Curve, Surface)
    bases = [what.t] if isinstance(what, Curve) else [what.u, what.v]
    if any(one.type not in ("bezier", "bspline") for one in bases):
        nurbs = to_nurbs(Model(curves=[what]) if isinstance(what, Curve) else Model([what]), tolerance)[0]
        return spline(nurbs.curves[0] if isinstance(what, Curve) else nurbs.surfaces[0])
    knots, counts = [], []
    for one in bases:
        if one.type == "bezier":
            lists: Any = list(one.range), [int(one.degree or 0) + 1] * 2
        else:
            distinct, times = np.unique(np.asarray(one.knots), return_counts=True)
            lists = distinct.tolist(), times.tolist()
        knots.append(lists[0])
        counts.append(lists[1])
    return Spline(tuple(int(one.degree or 0) for one in bases), tuple(knots), tuple(counts), what.points, what.weights)


def curve(degree: int, knots: Sequence[float], points: npt.ArrayLike, weights: npt.ArrayLike | None = None, name: str = "") -> Curve:
    """A curve from all its knots, clamped; without the outermost two as well, as Rhino has them.

    Errors: InputError, `knots`: not clamped, or not as many as the points want."""
    flat, net, degree = numbers(knots, "knots").ravel(), numbers(points, "points"), whole(degree, "degree")
    if net.ndim != 2 or len(flat) < degree + 1 or degree < 1:
        raise InputError(f"found {len(flat)} knots and points of the shape {net.shape} for degree {degree}; expected the knots of (n, 3) points",
                         "/knots", "size")
    if len(flat) == len(net) + degree - 1:
        flat = np.concatenate([flat[:1], flat, flat[-1:]])
    ends = np.concatenate([flat[:degree + 1] - flat[0], flat[len(flat) - degree - 1:] - flat[-1]])
    if len(flat) != len(net) + degree + 1 or np.any(ends != 0):
        raise InputError("the curve has no ends to meet at: its knots are not clamped, or it is closed; cut it open", "/knots", "knots")
    factors = None if weights is None else numbers(weights, "weights")
    if factors is not None and factors.shape == net.shape[:1] and np.all(factors == factors[0]):
        factors = None
    return Curve(bspline(degree, knots=flat), net, factors, name)


def claims(certificate: Certificate | None) -> list[str]:
    """The verdict, then a line for each claim and each figure that is a number."""
    if certificate is None:
        return ["no certificate"]
    words = {True: "holds", False: "does not hold", None: "undecided"}
    return ([f"{certificate.construct}: {words[certificate.holds]}"]
            + [f"{one.claim}: {words[one.holds]} ({one.kind}), {one.residual:.3g}, limit {one.limit:.3g}{', ' if one.where else ''}{one.where}"
               for one in certificate.claims]
            + [f"{name}: {value:.10g}" for name, value in certificate.figures.items()
               if isinstance(value, (int, float)) and not isinstance(value, bool)])


_SAID = {"argument", "knots", "name", "size", "type", "value"}  # whose message says what was expected: the remedy has no more


def told(error: BaseException) -> str:
    """What failed, and what to change."""
    if isinstance(error, Error) and error.remedy and error.reason not in _SAID:
        return f"{error.message}. What to change: {error.remedy}"
    return str(error) or type(error).__name__


__all__ = ["CONSTRUCTS", "Spline", "between", "blend", "claims", "curve", "nearest", "spline", "told"]
