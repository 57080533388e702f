"""Measures, joints, and operations that keep the points of a surface."""
from __future__ import annotations

import json
from ctypes import byref, c_double, c_void_p, create_string_buffer
from typing import Any, Sequence, Union

from . import _library as c
from ._handle import Handle, encoded, expect, is_one_of, library, made, real, text_of, thread_count, whole
from ._watch import Progress, Watch
from .errors import InputError, raise_for
from .geometry import Curve, Surface
from .model import Model, strictly

_EDGES = ("u0", "u1", "v0", "v1")


def _record(fill: Any) -> Any:
    """What fill(record) puts into a record."""
    pointer = library.taut_record_new()
    if not pointer:
        raise MemoryError("taut: memory ran out")
    try:
        fill(pointer)
        if library.taut_record_status(pointer) != c.OK:
            raise_for(library.taut_record_status(pointer))
        return json.loads(text_of(library.taut_record_write, pointer))
    finally:
        library.taut_record_free(pointer)


def _measured(one: Surface | Curve, options: c.MeasureOptions) -> dict[str, Any]:
    is_surface = isinstance(one, Surface)
    function = library.taut_measure_surface if is_surface else library.taut_measure_curve
    record = library.taut_measure_surface_record if is_surface else library.taut_measure_curve_record
    room = create_string_buffer(c.sizes["taut_surface_measure" if is_surface else "taut_curve_measure"])
    error = c.ErrorStruct()
    status = function(one._pointer, byref(options), room, byref(error))
    if status != c.OK:
        raise_for(status, error)
    return dict(_record(lambda pointer: record(one._pointer, room, pointer)))


def measure(what: Union[Model, Surface, Curve], grid: int = 101, threads: int | None = None,
            progress: Progress | None = None, strict: bool = False) -> dict[str, Any]:
    """Areas, energies, curvatures, lengths: as `taut measure --json` says them.

    A model gives {"surfaces": [...], "curves": [...]}; a surface or curve its own object. Extremes are over grid x grid
    parameters; integrals are good to 1e-10 relative, or come with their error. threads and progress as of make; strict: CheckFailed where
    a claim does not hold of the model, or of that which the surface or curve is of.

    Errors: InputError, `type`: another object.
    """
    expect(what, Model, Surface, Curve)
    options = c.MeasureOptions(grid=whole(grid, "grid"), threads=thread_count(threads))
    strictly(strict, what)
    with Watch(progress) as watch:
        options.monitor = watch.monitor
        if isinstance(what, Model):
            return {"surfaces": [_measured(one, options) for one in what.surfaces],
                    "curves": [_measured(one, options) for one in what.curves]}
        return _measured(what, options)


def join(a: Surface, edge_a: str, b: Surface, edge_b: str, threads: int | None = None, progress: Progress | None = None,
         strict: bool = False) -> dict[str, Any]:
    """How two surfaces meet along an edge each ("u0", "u1", "v0", "v1"): max_gap, angles, c_order, g_order, kind.

    One thread works; progress is called, the part done unknown; strict as of measure, of both surfaces.

    Errors: InputError: another edge (`name`) or object (`type`)."""
    expect(a, Surface)
    expect(b, Surface)
    for edge in (edge_a, edge_b):
        if not is_one_of(edge, _EDGES):
            raise InputError(f"the edge is {edge!r}; expected one of {', '.join(_EDGES)}", "", "name")
    strictly(strict, a, b)
    room, error = create_string_buffer(c.sizes["taut_join"]), c.ErrorStruct()
    with _Told("join", threads, progress) as told:
        options = c.JoinOptions(monitor=told.monitor)
        status = library.taut_join_measure_with(a._pointer, _EDGES.index(edge_a), b._pointer, _EDGES.index(edge_b), byref(options), room,
                                                byref(error))
    if status != c.OK:
        raise_for(status, error)
    return dict(_record(lambda pointer: library.taut_join_record(room, pointer)))


class _Told(Watch):
    """Around a call of C that works with one thread: progress is called before it and after it, and where C tells of it."""

    def __init__(self, what: str, threads: int | None, progress: Progress | None) -> None:
        thread_count(threads)
        super().__init__(progress)
        self._what = what

    def __enter__(self) -> Watch:
        self.begun(self._what)
        return super().__enter__()

    def __exit__(self, *raised: Any) -> None:
        super().__exit__(*raised)
        if raised[0] is None:
            self.tell(1.0, self._what)


def _changed(function: Any, model: Model, arguments: Sequence[Any], told: _Told, strict: bool) -> Model:
    expect(model, Model)
    strictly(strict, model)
    with told:
        return Model._of(made(function, library.taut_model_free, model._pointer, *arguments))


def split(model: Model, u: float | None = None, v: float | None = None, name: str | None = None, threads: int | None = None,
          progress: Progress | None = None, strict: bool = False) -> Model:
    """Every surface, or the one named, cut at u or at v: the same points, without details and certificate.

    One thread works; progress is called before and after; strict: CheckFailed where a claim of the model does not hold.

    Errors: InputError: neither or both of u and v (`conflict`), no surface of that name; NoSolution, `parameter`: not inside a range."""
    if (u is None) == (v is None):
        raise InputError("split: give u or v, one of them", "", "conflict")
    at = real(u, "u") if v is None else real(v, "v")
    return _changed(library.taut_model_split, model, (encoded(name), int(u is None), at), _Told("split", threads, progress), strict)


def refine(model: Model, along: str = "uv", name: str | None = None, threads: int | None = None, progress: Progress | None = None,
           strict: bool = False) -> Model:
    """Every span halved along "u", "v" or "uv": the same points on a finer net. threads, progress, strict as of split.

    Errors: InputError: another direction, no surface of that name, or a net that would be too large."""
    if not is_one_of(along, ("u", "v", "uv")):
        raise InputError(f"along is {along!r}; expected 'u', 'v' or 'uv'", "", "value")
    return _changed(library.taut_model_refine, model, (encoded(name), int("u" in along), int("v" in along)),
                    _Told("refine", threads, progress), strict)


def pieces(model: Model, name: str | None = None, threads: int | None = None, progress: Progress | None = None,
           strict: bool = False) -> Model:
    """Every span on its own, on Bezier bases. threads, progress, strict as of split.

    Errors: InputError, `no-such-object`: no surface of that name."""
    return _changed(library.taut_model_pieces, model, (encoded(name),), _Told("pieces", threads, progress), strict)


def to_unit(model: Model, unit: str, threads: int | None = None, progress: Progress | None = None, strict: bool = False) -> Model:
    """The same model in "mm", "cm", "m", "in" or "ft". threads, progress, strict as of split.

    Errors: InputError: no such unit (`argument`), or no text (`type`)."""
    if not isinstance(unit, str):
        raise InputError(f"unit is {unit!r}; expected one of mm, cm, m, in, ft", "", "type")
    return _changed(library.taut_model_to_unit, model, (encoded(unit),), _Told("to_unit", threads, progress), strict)


def to_nurbs(model: Model, tolerance: float = 1e-6, threads: int | None = None, progress: Progress | None = None,
             strict: bool = False) -> tuple[Model, float]:
    """Every surface and curve as NURBS within tolerance times its size, and the distance that is proved, a length. threads, progress,
    strict as of split.

    Errors: InputError, `tolerance`: not above 0, or less than rounding leaves; the message says how much that is."""
    expect(model, Model)
    strictly(strict, model)
    bound, error, pointer, limit = c_double(), c.ErrorStruct(), c_void_p(), real(tolerance, "tolerance")
    with _Told("to_nurbs", threads, progress):
        status = library.taut_model_to_nurbs(model._pointer, limit, byref(pointer), byref(bound), byref(error))
    if status != c.OK:
        raise_for(status, error)
    return Model._of(Handle(pointer.value or 0, library.taut_model_free)), bound.value


__all__ = ["join", "measure", "pieces", "refine", "split", "to_nurbs", "to_unit"]
