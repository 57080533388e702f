#! python3
# r: taut
"""A surface between four curves, in a Python 3 script component of Rhino 8.

Inputs   curves     list: four curves whose ends meet, in any order
         construct  item, text: "dirichlet" (if empty), "plateau", "harmonic", "asymptotic"
         degree     list, two integers: at least these along u and v; dirichlet and plateau only
Outputs  surface    Rhino.Geometry.NurbsSurface
         certificate  list of texts
         model      text: the whole model as JSON
"""
import Rhino

try:
    import taut
except ImportError as error:
    raise ImportError(f"{error}: install a wheel of taut with the Python of Rhino, as docs/plugins/grasshopper.md says") from None
from taut import hosts, rhino


def between(curves, construct=None, degree=None):
    """What the component gives; an error is Grasshopper's, with what to change."""
    construct = str(construct or "dirichlet").strip().lower()
    try:
        degrees = [int(one) for one in degree] if degree else []
    except (TypeError, ValueError):
        raise RuntimeError("degree: expected a list of two whole numbers, along u and v") from None
    members = {"degree": degrees} if degrees and construct in ("dirichlet", "plateau") else {}
    for i, one in enumerate(curves or []):
        if not hasattr(one, "ToNurbsCurve"):
            raise RuntimeError(f"item {i} of curves is {'missing (null)' if one is None else type(one).__name__}: four curves are expected")
    try:
        edges = [rhino.curve_of(one, f"edge{i + 1}") for i, one in enumerate(curves or [])]
        made = hosts.between(construct, edges, unit=rhino.unit_of(Rhino.RhinoDoc.ActiveDoc), **members)
    except taut.Error as error:
        raise RuntimeError(hosts.told(error)) from None
    return rhino.to_rhino(made.surfaces[0]), hosts.claims(made.certificate), made.to_json()


if globals().get("curves") is not None:  # Grasshopper gives None for what is not connected
    surface, certificate, model = between(curves, globals().get("construct"), globals().get("degree"))  # noqa: F821
