"""Surfaces drawn tight across their boundaries, each with a certificate.

    import taut
    model = taut.dirichlet(points, u=taut.bspline(3, count=8), v=taut.bspline(3, count=8))   # NaN: to be found
    model.certificate["stationary"].holds, model.surfaces[0](0.5, 0.5), model.write("lid.step")

Constructions are functions (`taut.dirichlet`, `taut.plateau`, ...); `taut.make` takes the documents of the program. Lengths are
in the model's unit, angles in radians. All objects are immutable, compare by value and pickle; arrays are numpy's, float64.
"""
from ._library import VERSION as __version__
from .bases import Basis, bezier, bspline, c_bezier, c_bspline, ce_bezier, h_bezier, h_bspline
from .constructions import *
from .constructions import __all__ as _constructions
from .errors import CheckFailed, Error, FileError, InputError, NoSolution, NotConverged
from .geometry import Curve, Surface
from .gradients import FilmGradient, film_gradient, gradient
from .making import certify, make, read
from .measuring import join, measure, pieces, refine, split, to_nurbs, to_unit
from .model import Certificate, Claim, Mesh, Model
from .sweeps import map as map
from .tracing import follow

# Not map: `from taut import *` would hide Python's own.
__all__ = ["Basis", "Certificate", "CheckFailed", "Claim", "Curve", "Error", "FileError", "FilmGradient", "InputError", "Mesh", "Model", "NoSolution",
           "NotConverged", "Surface", "bezier", "bspline", "c_bezier", "c_bspline", "ce_bezier", "certify", "film_gradient", "follow", "gradient", "h_bezier", "h_bspline",
           "join", "make", "measure", "pieces", "read", "refine", "split", "to_nurbs", "to_unit", *_constructions]
