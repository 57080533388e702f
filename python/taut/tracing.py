"""Curves of a net, followed step by step."""
from __future__ import annotations

import math
from ctypes import byref, c_double
from typing import Any, Callable, Optional, Sequence

import numpy as np

from . import _library as c
from ._handle import expect, is_one_of, library, numbers, real, thread_count
from ._watch import Progress, Watch
from .errors import InputError, raise_for
from .geometry import Surface
from .model import strictly

_FAMILIES = {"asymptotic": ("+", "-"), "principal": ("max", "min"), "geodesic": ("G",), "isoparametric": ("u", "v")}
_NAMES = ("s", "at", "points", "tangents", "normals", "k_n", "k_g", "tau_g")


def _pair(value: Sequence[float], name: str) -> list[float]:
    pair = numbers(value, name)
    if pair.shape != (2,):
        raise InputError(f"{name} is {value!r}; expected two numbers", "", "value")
    return [float(pair[0]), float(pair[1])]


def _told(step: Any) -> tuple[Any, ...]:
    return (step.s, tuple(step.at), tuple(step.point), tuple(step.tangent), tuple(step.normal), step.k_n, step.k_g, step.tau_g)


def follow(surface: Surface, net: str, at: Sequence[float], way: Sequence[float], *, family: Optional[str] = None,
           max_length: Optional[float] = None, sink: Optional[Callable[[dict[str, Any]], object]] = None, threads: Optional[int] = None,
           progress: Optional[Progress] = None, strict: bool = False) -> dict[str, Any]:
    """The curve of a net through a place, one way, at the steps that it is followed by.

    surface     a Surface
    net         "asymptotic", "principal", "geodesic" or "isoparametric"
    at          the place (u, v)
    way         the direction (du, dv): a geodesic's own; of other nets whichever of both ways is nearer to it
    family      "+" or "-", "max" or "min", "u" or "v"; the first if not given
    max_length  20 sizes if not given
    sink        called with {"s", "at", ...} of the seed and of each step; what is true ends the curve there
    threads     how many; one works: a step after the other
    progress    called as progress(part of max_length, or NaN where none is given, "follow") at each step; what it raises stops the work
    strict      CheckFailed where a claim does not hold of the model that the surface is of

    Gives arrays s, at, points, tangents, normals, k_n, k_g, tau_g, a row a step; "ended", "edge" or another word; and "length".

    Errors: InputError: another net, family or place; NoSolution where the net has no direction at the place. Source: docs/trace.md.
    """
    expect(surface, Surface)
    if not is_one_of(net, _FAMILIES):
        raise InputError(f"net is {net!r}; expected one of {', '.join(_FAMILIES)}", "", "net")
    families = _FAMILIES[net]
    if family is not None and not is_one_of(family, families):
        raise InputError(f"family is {family!r}; expected one of {', '.join(families)}", "", "family")
    if sink is not None and not callable(sink):
        raise InputError(f"sink is {sink!r}; expected a function", "", "type")
    thread_count(threads)
    watch = Watch(progress)
    strictly(strict, surface)
    number = 1 + families.index(family) if family is not None else 1
    rows: list[tuple[Any, ...]] = []
    failed: list[BaseException] = []

    def take(_: Any, pointer: Any) -> int:
        rows.append(_told(pointer.contents))
        try:
            watch.tell(min(1.0, rows[-1][0] / most) if most > 0 else math.nan, "follow")
            return int(bool(sink is not None and sink(dict(zip(_NAMES, rows[-1])))))
        except BaseException as error:  # it cannot pass through C
            failed.append(error)
            return 1

    most = 0.0 if max_length is None else real(max_length, "max_length")
    if max_length is not None and not (most > 0 and math.isfinite(most)):
        raise InputError(f"max_length is {max_length!r}; expected a positive number", "", "value")
    end, error = c.TraceEnd(), c.ErrorStruct()
    start, direction = (c_double * 2)(*_pair(at, "at")), (c_double * 2)(*_pair(way, "way"))
    status = library.taut_trace_follow(surface._pointer, list(_FAMILIES).index(net), number, start, direction, most, c.TRACE_SINK(take),
                                       None, byref(end), byref(error))
    if failed:
        raise failed[0]
    if status != c.OK:
        raise_for(status, error)
    followed: dict[str, Any] = {name: np.array([row[k] for row in rows]) for k, name in enumerate(_NAMES)}
    followed["ended"], followed["length"] = end.word.decode(), end.length
    return followed
