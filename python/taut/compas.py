"""COMPAS: NURBS curves and surfaces to and from `compas.geometry`, and a plug-in of its `NurbsSurface.from_fill`. Imported only where COMPAS
is; the surfaces themselves are made by whatever backend it has (compas_occ, Rhino).

    from_compas(curve or surface)   by points, weights, distinct knots, multiplicities and degrees
    to_compas(surface)              by NurbsSurface.from_parameters: the same numbers
    between(construct, curves)      a surface from four NurbsCurves in any order, with its certificate

A package whose name begins with "compas" makes `NurbsSurface.from_fill` Taut's by `__all_plugins__ = ["taut.compas"]`.
"""
from __future__ import annotations

from typing import Any, Sequence, Union

import numpy as np
from compas.geometry import NurbsSurface
from compas.plugins import plugin

from . import hosts
from .bases import bspline
from .errors import InputError
from .geometry import Curve, Surface
from .model import Certificate


def _flat(knots: Sequence[float], times: Sequence[int]) -> list[float]:
    return [float(one) for one in np.repeat(np.asarray(knots, dtype=np.float64), times)]


def from_compas(shape: Any, name: str = "") -> Union[Curve, Surface]:
    """A NurbsCurve or a NurbsSurface, clamped; periodic ones are an InputError."""
    weights = np.asarray(shape.weights, dtype=np.float64)
    factors = None if np.all(weights == weights.flat[0]) else weights
    if hasattr(shape, "knots_u"):
        if shape.is_periodic_u or shape.is_periodic_v:
            raise InputError("the surface is periodic: cut it open", "/knots", "knots")
        points = [[list(point) for point in row] for row in shape.points]
        return Surface(bspline(shape.degree_u, knots=_flat(shape.knots_u, shape.mults_u)),
                       bspline(shape.degree_v, knots=_flat(shape.knots_v, shape.mults_v)), points, factors, name)
    return hosts.curve(shape.degree, _flat(shape.knots, shape.multiplicities), [list(point) for point in shape.points], factors, name)


def _parameters(surface: Surface) -> tuple[Any, ...]:
    shape = hosts.spline(surface)
    weights = np.ones(shape.points.shape[:2]) if shape.weights is None else shape.weights
    return (shape.points.tolist(), weights.tolist(), *shape.knots, *shape.multiplicities, *shape.degrees)


def to_compas(surface: Surface) -> Any:
    """As a NurbsSurface of COMPAS's backend; exact where the bases are polynomial, else within 1e-9 of the size."""
    return NurbsSurface.from_parameters(*_parameters(surface))


def between(construct: str, curves: Sequence[Any], **members: Any) -> tuple[Any, Certificate | None]:
    """The NurbsSurface of "dirichlet", "plateau", "harmonic" or "asymptotic", and its certificate."""
    edges: list[Any] = [from_compas(one) for one in curves]
    model = hosts.between(construct, edges, **members)
    return to_compas(model.surfaces[0]), model.certificate


@plugin(category="factories", requires=["taut"])  # type: ignore[misc]
def nurbssurface_from_fill(cls: Any, curve1: Any, curve2: Any, curve3: Any = None, curve4: Any = None, style: str = "stretch") -> Any:
    """`NurbsSurface.from_fill` between four curves: "stretch" is the surface of least Dirichlet energy, "curved" that of least area."""
    constructs = {"stretch": "dirichlet", "curved": "plateau"}
    if style not in constructs:
        raise InputError(f"the style is {style!r}; expected 'stretch' or 'curved'", "/style", "value")
    edges: list[Any] = [from_compas(one) for one in (curve1, curve2, curve3, curve4) if one is not None]
    return cls.from_parameters(*_parameters(hosts.between(constructs[style], edges).surfaces[0]))


__all__ = ["between", "from_compas", "nurbssurface_from_fill", "to_compas"]
