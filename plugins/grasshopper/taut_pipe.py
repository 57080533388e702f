#! python3
# r: taut
"""A pipe between two straight ones, in a Python 3 script component of Rhino 8.

Inputs   one, other   lines: the axes; the two ends that are nearest are joined
         radius       list, one number, or two that differ
         joint        item, text: "g1" (if empty) or "g2"
Outputs  surface, certificate, model   as of taut_between.py
"""
import Rhino

import taut
from taut import hosts, rhino


def ends(line):
    """(2, 3): of a Line, or of a line-like curve."""
    pair = (line.From, line.To) if hasattr(line, "From") else (line.PointAtStart, line.PointAtEnd)
    return [[point.X, point.Y, point.Z] for point in pair]


def pipe(one, other, radius, joint=None):
    """What the component gives."""
    sizes = [float(size) for size in (radius if isinstance(radius, (list, tuple)) else [radius])]
    try:
        made = hosts.blend(ends(one), ends(other), sizes, unit=rhino.unit_of(Rhino.RhinoDoc.ActiveDoc), joint=str(joint or "g1"))
    except taut.Error as error:
        raise RuntimeError(hosts.told(error)) from None
    return rhino.to_rhino(made["blend"]), hosts.claims(made.certificate), made.to_json()


if "one" in globals() and "other" in globals():
    surface, certificate, model = pipe(one, other, radius, globals().get("joint"))  # noqa: F821
