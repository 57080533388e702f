"""How a number of a surface changes with the points that it was made from."""
from __future__ import annotations

from ctypes import byref
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._handle import Array, library
from .errors import InputError, raise_for
from .making import Document, Progress, Watch, _problems
from .model import Model

_FIGURES = {"area": 0, "dirichlet_energy": 1}
_POINTS = 2


def _request(of: Any, shape: tuple[int, ...]) -> tuple[c.GradientRequest, Array | None]:
    """What is derived; the array must live as long as the request."""
    if isinstance(of, str):
        if of not in _FIGURES:
            raise InputError(f"of is {of!r}; expected 'area', 'dirichlet_energy' or an array of the points' shape", "", "name")
        return c.GradientRequest(of=_FIGURES[of]), None
    factors = np.ascontiguousarray(of, dtype=np.float64)
    if factors.shape != shape:
        raise InputError(f"of has the shape {factors.shape}; expected {shape}, as the points of the surface", "", "size")
    return c.GradientRequest(of=_POINTS, factors=factors.ctypes.data), factors


def gradient(problem: Document, model: Model, of: Union[str, npt.ArrayLike] = "area", progress: Progress | None = None) -> Array:
    """dF/dk for all coordinates of the known points k at once: (nu, nv, 3), 0 at points that were found.

    problem    the document that the model was made from, as taut.make takes it
    model      taut.make(problem)
    of         F: "area", "dirichlet_energy", or dF/dP by the control points P of model.surfaces[0], (nu, nv, 3): any number
               that you can derive by them (a loss, in learning)
    progress   as of taut.make

    By the adjoint: one solve, however many points are known. dirichlet; harmonic and biharmonic from rows; plateau with
    method "normal", with "full" the area alone. Others are an InputError, reason "no-gradient". With rows of even degree that
    are refused where they disagree there is none either. Source: docs/gradient.md.
    """
    problems = _problems(problem)
    if library.taut_problem_list_count(problems.pointer) != 1:
        raise InputError("a gradient is of one problem", "", "argument")
    if not isinstance(model, Model) or not model.surfaces:
        raise InputError("a gradient is of a model with a surface", "", "argument")
    request, factors = _request(of, model.surfaces[0].points.shape)
    result, error = np.zeros(model.surfaces[0].points.shape), c.ErrorStruct()
    with Watch(progress) as watch:
        request.monitor = watch.monitor
        status = library.taut_gradient(library.taut_problem_list_at(problems.pointer, 0), model._pointer, byref(request),
                                       result.ctypes.data, byref(error))
    del factors
    if status != c.OK:
        raise_for(status, error)
    return result


__all__ = ["gradient"]
