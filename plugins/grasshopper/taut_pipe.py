#! python3
# r: taut
"""A pipe between two straight ones, in a Python 3 script component of Rhino 8.

Inputs   one, other   lines: the axes; the two ends that are nearest are joined
         radius       list, one number, or two that differ
         joint        item, text: "g1" (if empty) or "g2"
Outputs  surface, certificate, model   as of taut_between.py
"""
import Rhino

try:
    import taut
except ImportError as error:
    raise ImportError(f"{error}: install a wheel of taut with the Python of Rhino, as docs/plugins/grasshopper.md says") from None
from taut import hosts, rhino


def ends(line):
    """(2, 3): of a Line, or of a line-like curve."""
    if not hasattr(line, "From") and not hasattr(line, "PointAtStart"):
        raise taut.InputError(f"an axis is {type(line).__name__}; expected lines", "/ends", "type")
    if hasattr(line, "IsLinear") and not line.IsLinear():
        raise taut.InputError("an axis is bent; expected lines", "/ends", "type")
    pair = (line.From, line.To) if hasattr(line, "From") else (line.PointAtStart, line.PointAtEnd)
    return [[point.X, point.Y, point.Z] for point in pair]


def pipe(one, other, radius, joint=None):
    """What the component gives."""
    try:
        sizes = [float(size) for size in (radius if hasattr(radius, "__iter__") and not isinstance(radius, str) else [radius])]  # .NET's lists, too
    except (TypeError, ValueError):
        raise RuntimeError("the radius is no number: give one, or two that differ") from None
    try:
        axes = ends(one), ends(other)
        if len(sizes) not in (1, 2):
            raise taut.InputError(f"found {len(sizes)} radii; expected one, or two that differ", "/radius", "size", len(sizes), 2)
        made = hosts.blend(*axes, sizes, unit=rhino.unit_of(Rhino.RhinoDoc.ActiveDoc), joint=str(joint or "g1"))
    except taut.Error as error:
        raise RuntimeError(hosts.told(error)) from None
    return rhino.to_rhino(made["blend"]), hosts.claims(made.certificate), made.to_json()


if globals().get("one") is not None and globals().get("other") is not None:  # Grasshopper gives None for what is not connected
    surface, certificate, model = pipe(one, other, globals().get("radius"), globals().get("joint"))  # noqa: F821
