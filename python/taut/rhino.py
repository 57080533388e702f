"""Curves and surfaces of RhinoCommon, for scripts in Rhino 8 and Grasshopper, whose Python this is imported in.

    curve_of(curve)          any Rhino curve as a taut.Curve
    to_rhino(surface)        a taut.Surface as Rhino.Geometry.NurbsSurface: the same points, weights and knots
    unit_of(document)        "mm", "cm", "m", "in" or "ft" of a Rhino document

Rhino leaves out the first and the last knot, and keeps points with their weights apart when asked to.
"""
from __future__ import annotations

from typing import Any

import numpy as np

from . import hosts
from .errors import InputError
from .geometry import Curve, Surface


def curve_of(curve: Any, name: str = "") -> Curve:
    """The NURBS form of a Rhino curve, exact for lines, arcs and NURBS; one that is closed has no ends to meet at."""
    spline = curve.ToNurbsCurve()
    if spline is None or spline.IsPeriodic or spline.IsClosed:
        raise InputError("the curve is closed, or has no NURBS form: cut it open", "/boundary", "knots")
    places, weights = [], []
    for i in range(spline.Points.Count):
        point = spline.Points[i]
        places.append([point.Location.X, point.Location.Y, point.Location.Z])
        weights.append(point.Weight)
    return hosts.curve(spline.Degree, [spline.Knots[i] for i in range(spline.Knots.Count)], places,
                       weights if spline.IsRational else None, name)


def to_rhino(surface: Surface) -> Any:
    """Exact where the bases are polynomial, else within 1e-9 of the size."""
    import Rhino
    shape = hosts.spline(surface)
    nu, nv = shape.points.shape[:2]
    result = Rhino.Geometry.NurbsSurface.Create(3, shape.weights is not None, shape.degrees[0] + 1, shape.degrees[1] + 1, nu, nv)
    for knots, distinct, times in zip((result.KnotsU, result.KnotsV), shape.knots, shape.multiplicities):
        for i, knot in enumerate(np.repeat(distinct, times)[1:-1].tolist()):
            knots[i] = knot
    for i in range(nu):
        for j in range(nv):
            place = Rhino.Geometry.Point3d(*shape.points[i, j].tolist())
            if shape.weights is None:
                result.Points.SetPoint(i, j, place)
            else:
                result.Points.SetPoint(i, j, place, float(shape.weights[i, j]))
    return result


_UNITS = {"Millimeters": "mm", "Centimeters": "cm", "Meters": "m", "Inches": "in", "Feet": "ft"}


def unit_of(document: Any) -> str:
    """The unit of a document's model space; millimetres where there is no document."""
    name = "Millimeters" if document is None else str(document.ModelUnitSystem)
    if name not in _UNITS:
        raise InputError(f"the document's unit is {name}; expected one of {', '.join(_UNITS)}", "/unit", "value")
    return _UNITS[name]


__all__ = ["curve_of", "to_rhino", "unit_of"]
