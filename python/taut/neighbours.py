"""To and from the curves and surfaces of other packages; each is imported only where it is used.

    scipy      BSpline and NdBSpline: to_scipy, from_scipy
    geomdl     BSpline and NURBS curves and surfaces: from_geomdl, to_geomdl
    meshio     the mesh of a model: to_meshio, for the formats that it writes
"""
from __future__ import annotations

from typing import Any, Union

import numpy as np

from ._handle import expect
from .bases import bspline
from .errors import InputError
from .geometry import Curve, Surface
from .model import Model


def _nurbs(what: Union[Curve, Surface], tolerance: float) -> Any:
    """what on bspline bases; exact where its bases are polynomial."""
    expect(what, Curve, Surface)
    from .measuring import to_nurbs
    model = Model([what]) if isinstance(what, Surface) else Model(curves=[what])
    nurbs = to_nurbs(model, tolerance)[0]
    return (nurbs.surfaces if isinstance(what, Surface) else nurbs.curves)[0]


def _expect_members(value: Any, kind: str, *names: str) -> None:
    """Refuses what is none of another package's objects."""
    if not all(hasattr(value, name) for name in names):
        raise InputError(f"found {type(value).__name__}, expected a {kind}", "", "type", expected=kind)


def to_scipy(what: Union[Curve, Surface], tolerance: float = 1e-9) -> Any:
    """A curve as scipy.interpolate.BSpline, a surface as NdBSpline (scipy 1.12 or later), whose values are points.

    Errors: InputError of a rational one: weights have no place there. ImportError where scipy is missing, or too old for surfaces."""
    from scipy import interpolate
    expect(what, Curve, Surface)
    if what.weights is not None:
        raise InputError("scipy's splines have no weights", "/weights", "value")
    spline = _nurbs(what, tolerance)
    if not isinstance(what, Curve) and not hasattr(interpolate, "NdBSpline"):
        raise ImportError("surfaces need scipy 1.12 or later: its NdBSpline")
    if isinstance(what, Curve):
        return interpolate.BSpline(np.array(spline.t.knots), np.array(spline.points), spline.t.degree)
    return interpolate.NdBSpline((np.array(spline.u.knots), np.array(spline.v.knots)), np.array(spline.points),
                                 (spline.u.degree, spline.v.degree))


def from_scipy(spline: Any, name: str = "") -> Union[Curve, Surface]:
    """The curve of a BSpline, the surface of an NdBSpline, whose values are points in space and whose knots are clamped.

    Errors: InputError: points that are not in space, knots that are not clamped, or another object (`type`)."""
    _expect_members(spline, "scipy.interpolate.BSpline or NdBSpline", "t", "c", "k")
    if isinstance(spline.t, tuple):
        points = np.asarray(spline.c)
        degrees = np.broadcast_to(np.asarray(spline.k), (2,))
        return Surface(bspline(int(degrees[0]), knots=spline.t[0]), bspline(int(degrees[1]), knots=spline.t[1]), points, name=name)
    return Curve(bspline(int(spline.k), knots=spline.t), np.asarray(spline.c)[:len(spline.t) - spline.k - 1], name=name)


def from_geomdl(shape: Any, name: str = "") -> Union[Curve, Surface]:
    """The curve or surface of geomdl's BSpline and NURBS classes.

    Errors: InputError: as of Curve and Surface, or another object (`type`)."""
    _expect_members(shape, "curve or surface of geomdl", "ctrlpts", *(("degree", "knotvector") if hasattr(shape, "degree") else (
        "degree_u", "degree_v", "knotvector_u", "knotvector_v", "ctrlpts_size_u", "ctrlpts_size_v")))
    weights = np.asarray(shape.weights, dtype=float) if getattr(shape, "rational", False) else None
    points = np.asarray(shape.ctrlpts, dtype=float)
    if points.shape[-1] == 2:
        points = np.hstack([points, np.zeros((len(points), 1))])
    if hasattr(shape, "degree_u"):
        size = (shape.ctrlpts_size_u, shape.ctrlpts_size_v)
        return Surface(bspline(shape.degree_u, knots=shape.knotvector_u), bspline(shape.degree_v, knots=shape.knotvector_v),
                       points.reshape(*size, 3), None if weights is None else weights.reshape(size), name or shape.name)
    return Curve(bspline(shape.degree, knots=shape.knotvector), points, weights, name or shape.name)


def to_geomdl(what: Union[Curve, Surface], tolerance: float = 1e-9) -> Any:
    """As geomdl's NURBS.Curve or NURBS.Surface.

    Errors: ImportError where geomdl is missing."""
    from geomdl import NURBS
    spline = _nurbs(what, tolerance)
    weights = np.ones(spline.points.shape[:-1]) if spline.weights is None else spline.weights
    homogeneous = np.concatenate([spline.points * weights[..., None], weights[..., None]], axis=-1)
    if isinstance(what, Curve):
        curve = NURBS.Curve(normalize_kv=False)
        curve.degree, curve.ctrlptsw, curve.knotvector = spline.t.degree, homogeneous.tolist(), spline.t.knots.tolist()
        return curve
    surface = NURBS.Surface(normalize_kv=False)
    surface.degree_u, surface.degree_v = spline.u.degree, spline.v.degree
    surface.ctrlpts_size_u, surface.ctrlpts_size_v = spline.points.shape[:2]
    surface.ctrlptsw = homogeneous.reshape(-1, 4).tolist()
    surface.knotvector_u, surface.knotvector_v = spline.u.knots.tolist(), spline.v.knots.tolist()
    return surface


def to_meshio(model: Model, tolerance: float = 0.0, divide: int = 0) -> Any:
    """The mesh of a model as meshio.Mesh: triangles, with the arrays `normals` and `parameters` (u, v) at the points.

    tolerance, divide    as of Model.mesh

    meshio reads VTU files that `Model.write` made with lagrange=True, with curved cells; without it cells are Bezier patches, which
    VTK, ParaView and pyvista read.

    Errors: ImportError where meshio is missing (Debian: python3-meshio); else as of Model.mesh."""
    import meshio
    expect(model, Model)
    mesh = model.mesh(tolerance, divide)
    return meshio.Mesh(np.array(mesh.vertices), [("triangle", np.array(mesh.triangles, dtype=np.int64))],
                       point_data={"normals": np.array(mesh.normals), "parameters": np.array(mesh.parameters)})


__all__ = ["from_geomdl", "from_scipy", "to_geomdl", "to_meshio", "to_scipy"]
