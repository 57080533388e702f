"""COMPAS: NURBS curves and surfaces to and from `compas.geometry`, and a plug-in of its `NurbsSurface.from_fill`. Imported only where COMPAS
is; the surfaces themselves are made by whatever backend it has (compas_occ, Rhino).

    from_compas(curve or surface)   by points, weights, distinct knots, multiplicities and degrees
    to_compas(surface)              by NurbsSurface.from_parameters: the same numbers
    between(construct, curves)      a surface from four NurbsCurves in any order, with its certificate

A package whose name begins with "compas" makes `NurbsSurface.from_fill` Taut's, before that of any backend, by
`__all_plugins__ = ["taut.compas"]`.
"""
from __future__ import annotations

from typing import Any, Sequence, Union

import numpy as np
from compas.geometry import NurbsSurface
from compas.plugins import plugin

from . import hosts
from .bases import bezier, bspline
from .errors import InputError
from .geometry import Curve, Surface
from .model import Certificate


_PLACES = np.array([0, 0.37, 0.81, 1])  # where two surfaces are compared, along u and along v
_SAME = 1e-6                            # and what they may differ by, over their size


def _flat(knots: Sequence[float], times: Sequence[int]) -> list[float]:
    return [float(one) for one in np.repeat(np.asarray(knots, dtype=np.float64), times)]


def _padded(knots: list[float], count: int, degree: int) -> list[float] | None:
    """All knots of so many points; Rhino's backend leaves out the outermost two. None where they are those of other points."""
    if len(knots) == count + degree - 1:
        knots = [knots[0], *knots, knots[-1]]
    return knots if len(knots) == count + degree + 1 else None


def _distance(shape: Any, surface: Surface) -> float:
    """How far theirs is from ours at the same parameters, over the size."""
    (u0, u1), (v0, v1) = ((float(basis.breaks[0]), float(basis.breaks[-1])) for basis in (surface.u, surface.v))
    u, v = u0 + (u1 - u0) * _PLACES, v0 + (v1 - v0) * _PLACES
    theirs = np.array([[list(shape.point_at(float(s), float(t))) for t in v] for s in u])
    return float(np.abs(theirs - surface.grid(u, v)[0]).max() / max(float(np.ptp(surface.points, axis=(0, 1)).max()), 1e-300))


def _surface(shape: Any, name: str) -> Surface:
    """Rows of points run along u with compas_occ and along v with compas_rhino: which it is, the counts say, else the points that the
    surface itself gives."""
    if shape.is_periodic_u or shape.is_periodic_v:
        raise InputError("the surface is periodic: cut it open", "/knots", "knots")
    net = np.array([[list(point) for point in row] for row in shape.points], dtype=np.float64)
    weights = np.asarray(shape.weights, dtype=np.float64)
    found = []
    for turned in (True, False):
        points, factors = (net.swapaxes(0, 1), weights.T) if turned else (net, weights)
        u = _padded(_flat(shape.knots_u, shape.mults_u), points.shape[0], shape.degree_u)
        v = _padded(_flat(shape.knots_v, shape.mults_v), points.shape[1], shape.degree_v)
        if u is not None and v is not None:
            found.append(Surface(bspline(shape.degree_u, knots=u), bspline(shape.degree_v, knots=v), points,
                                 None if np.all(factors == factors.flat[0]) else factors, name))
    if not found:
        raise InputError(f"the knots are not those of {net.shape[0]} x {net.shape[1]} points", "/knots", "size")
    return found[0] if len(found) == 1 else min(found, key=lambda surface: _distance(shape, surface))


def from_compas(shape: Any, name: str = "") -> Union[Curve, Surface]:
    """A NurbsCurve or a NurbsSurface of any backend, clamped; periodic ones are an InputError."""
    if hasattr(shape, "knots_u"):
        return _surface(shape, name)
    return hosts.curve(shape.degree, _flat(shape.knots, shape.multiplicities), [list(point) for point in shape.points], shape.weights, name)


def _made(cls: Any, surface: Surface) -> Any:
    """Theirs, with the rows that the backend takes: what it makes of them is looked at."""
    shape = hosts.spline(surface)
    weights = np.ones(shape.points.shape[:2]) if shape.weights is None else shape.weights
    failed: Exception | None = None
    for turned in (True, False):
        points, factors = (shape.points.swapaxes(0, 1), weights.T) if turned else (shape.points, weights)
        try:
            theirs = cls.from_parameters(points.tolist(), factors.tolist(), *shape.knots, *shape.multiplicities, *shape.degrees)
            if _distance(theirs, surface) < _SAME:
                return theirs
        except Exception as error:
            failed = error
    raise InputError("the backend of COMPAS makes another surface of these numbers", "", "value") from failed


def to_compas(surface: Surface) -> Any:
    """As a NurbsSurface of COMPAS's backend; exact where the bases are polynomial, else within 1e-9 of the size."""
    return _made(NurbsSurface, surface)


def between(construct: str, curves: Sequence[Any], **members: Any) -> tuple[Any, Certificate | None]:
    """The NurbsSurface of "dirichlet", "plateau", "harmonic" or "asymptotic", and its certificate."""
    edges: list[Any] = [from_compas(one) for one in curves]
    model = hosts.between(construct, edges, **members)
    return to_compas(model.surfaces[0]), model.certificate


def _ring(edges: list[Any]) -> list[Any]:
    """Two curves with the two lines between their ends, the shorter pair."""
    if len(edges) != 2:
        return edges
    (a, b), (c, d) = ((edge.points[0], edge.points[-1]) for edge in edges)
    if np.linalg.norm(a - c) + np.linalg.norm(b - d) > np.linalg.norm(a - d) + np.linalg.norm(b - c):
        c, d = d, c
    return [edges[0], Curve(bezier(1), [b, d]), edges[1], Curve(bezier(1), [c, a])]


@plugin(category="factories", requires=["taut"], tryfirst=True)  # type: ignore[misc]
def nurbssurface_from_fill(cls: Any, curve1: Any, curve2: Any, curve3: Any = None, curve4: Any = None, style: str = "stretch") -> Any:
    """`NurbsSurface.from_fill` between four curves, or two and the lines between their ends: "stretch" is the surface of least Dirichlet
    energy, "curved" that of least area."""
    constructs = {"stretch": "dirichlet", "curved": "plateau"}
    if style not in constructs:
        raise InputError(f"the style is {style!r}; expected 'stretch' or 'curved'", "/style", "value")
    edges: list[Any] = [from_compas(one) for one in (curve1, curve2, curve3, curve4) if one is not None]
    return _made(cls, hosts.between(constructs[style], _ring(edges)).surfaces[0])


__all__ = ["between", "from_compas", "nurbssurface_from_fill", "to_compas"]
