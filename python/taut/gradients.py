"""How a number of a surface changes with the points that it was made from."""
from __future__ import annotations

from ctypes import byref
from typing import Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._handle import Array, is_one_of, library, numbers, thread_count
from ._watch import Progress, Watch
from .errors import InputError, raise_for
from .making import Document, _problems
from .model import Model, strictly

_FIGURES = {"area": 0, "dirichlet_energy": 1}
_POINTS = 2


def _request(of: Any, shape: tuple[int, ...]) -> tuple[c.GradientRequest, Array | None]:
    """What is derived; the array must live as long as the request."""
    if isinstance(of, str):
        if of not in _FIGURES:
            raise InputError(f"of is {of!r}; expected 'area', 'dirichlet_energy' or an array of the points' shape", "", "name")
        return c.GradientRequest(of=_FIGURES[of]), None
    factors = numbers(of, "of")
    if factors.shape != shape:
        raise InputError(f"of has the shape {factors.shape}; expected {shape}, as the points of the surface", "", "size")
    return c.GradientRequest(of=_POINTS, factors=factors.ctypes.data), factors


def gradient(problem: Document, model: Model, of: Union[str, npt.ArrayLike] = "area", progress: Progress | None = None,
             threads: int | None = None, strict: bool = False) -> Array:
    """dF/dk for all coordinates of the known points k at once: (nu, nv, 3), 0 at points that were found.

    problem    the document that the model was made from, as taut.make takes it
    model      taut.make(problem)
    of         F: "area", "dirichlet_energy", or dF/dP by the control points P of model.surfaces[0], (nu, nv, 3): any number
               that you can derive by them (a loss, in learning)
    progress   as of taut.make
    threads    how many; one works: it is one solve
    strict     CheckFailed where a claim of the model does not hold

    By the adjoint: one solve, however many points are known. dirichlet; harmonic and biharmonic from rows; plateau with
    method "normal", with "full" the area alone. Others are an InputError, reason "no-gradient". With rows of even degree that
    are refused where they disagree there is none either. Source: docs/gradient.md.
    """
    problems = _problems(problem)
    if library.taut_problem_list_count(problems.pointer) != 1:
        raise InputError("a gradient is of one problem", "", "argument")
    if not isinstance(model, Model) or not model.surfaces:
        raise InputError("a gradient is of a model with a surface", "", "argument")
    thread_count(threads)
    strictly(strict, model)
    request, factors = _request(of, model.surfaces[0].points.shape)
    result, error = np.zeros(model.surfaces[0].points.shape), c.ErrorStruct()
    with Watch(progress).begun("gradient") as watch:
        request.monitor = watch.monitor
        status = library.taut_gradient(library.taut_problem_list_at(problems.pointer, 0), model._pointer, byref(request),
                                       result.ctypes.data, byref(error))
    del factors
    if status != c.OK:
        raise_for(status, error)
    return result


_FILM_FIGURES = {"energy": 0, "area": 1, "length": 2, "tension": 3, "reaction": 4}
_EDGES, _CORNERS, _AXES = ("u0", "u1", "v0", "v1"), ("u0v0", "u1v0", "u0v1", "u1v1"), ("x", "y", "z")


class FilmGradient(NamedTuple):
    """How a number of a film changes with what it was made from: of film_gradient."""

    corners: dict[str, Array]  #: (3,) of each corner "u0v0", ...: of those that are held where they are given, else 0
    cables: dict[str, float]  #: of each cable "u0", ...: by its force, length, sag or unstressed length, whichever is given
    stiffness: dict[str, float]  #: of each elastic cable
    points: Array  #: (nu, nv, 3): by each held point of the net alone, of a ring by moves that keep it closed; 0 elsewhere


def _index(name: str, names: tuple[str, ...], what: str) -> int:
    if not is_one_of(name, names):
        raise InputError(f"{what} is {name!r}; expected one of {', '.join(names)}", "", "name")
    return names.index(name)


def _cables(model: Model) -> list[Any]:
    details: Any = model.details
    return list(details.get("cables", ()))


def film_gradient(problem: Document, model: Model, of: str = "energy", edge: str = "u0", corner: str = "u0v0", axis: str = "x",
                  progress: Progress | None = None, threads: int | None = None, strict: bool = False) -> FilmGradient:
    """dF/d(corners, forces, ...) of a film, F a number of its certificate.

    problem    the document of one film that the model was made from, as taut.make takes it
    model      taut.make(problem)
    of         F: "energy", "area", "length" or "tension" of the cable `edge`, or "reaction" at the held `corner` along `axis`
    progress   as of taut.make
    threads    how many; one works
    strict     CheckFailed where a claim of the model does not hold

    By the adjoint: the energy needs no solve, all else one system, however much is given. A film of one patch, open or a ring,
    with the method "full" and no updates of a reference; others are an InputError, reason "no-gradient". Source: docs/gradient.md.
    """
    problems = _problems(problem)
    if library.taut_problem_list_count(problems.pointer) != 1:
        raise InputError("a gradient is of one problem", "", "argument")
    if not isinstance(model, Model) or not model.surfaces:
        raise InputError("a gradient is of a model with a surface", "", "argument")
    thread_count(threads)
    strictly(strict, model)
    points, error = np.zeros(model.surfaces[0].points.shape), c.ErrorStruct()
    slopes = c.FilmSlopes(points=points.ctypes.data)
    request = c.FilmGradientRequest(of=_index(of, tuple(_FILM_FIGURES), "of"), edge=_index(edge, _EDGES, "edge"),
                                    corner=_index(corner, _CORNERS, "corner"), axis=_index(axis, _AXES, "axis"))
    with Watch(progress).begun("gradient") as watch:
        request.monitor = watch.monitor
        status = library.taut_gradient_of_film(library.taut_problem_list_at(problems.pointer, 0), model._pointer, byref(request),
                                               byref(slopes), byref(error))
    if status != c.OK:
        raise_for(status, error)
    corners = np.array(slopes.corners).reshape(4, 3)
    cables = {cable["edge"]: cable for cable in _cables(model)}
    return FilmGradient({name: corners[i] for i, name in enumerate(_CORNERS)},
                        {name: slopes.laws[i] for i, name in enumerate(_EDGES) if name in cables},
                        {name: slopes.stiffness[i] for i, name in enumerate(_EDGES) if "unstressed" in cables.get(name, ())}, points)


__all__ = ["FilmGradient", "film_gradient", "gradient"]
