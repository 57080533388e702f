"""Function bases: what a curve or a surface is a combination of, along one parameter."""
from __future__ import annotations

import ctypes
from ctypes import byref, c_double, c_void_p
from typing import Any, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._handle import Array, Handle, Referable, encoded, library, made, numbers, real, view, whole
from .errors import InputError, raise_for

_MEMBERS = {"bezier": ("degree",), "bspline": ("degree", "knots"), "c-bezier": ("alpha",), "h-bezier": ("beta",),
            "c-bspline": ("alpha", "segments"), "h-bspline": ("beta", "segments"), "ce-bezier": ("alpha", "beta", "gamma")}
_KNOWN = {"type", "degree", "count", "knots", "alpha", "beta", "gamma", "segments", "range"}


class Basis(Referable):
    """`count` functions over a range [lo, hi] that is cut into spans; immutable.

    Made by `bezier`, `bspline`, `c_bezier`, ... or from a document's object: `Basis({"type": "bezier", "degree": 3})`.
    Compares by value: type, knots, range, bit for bit.
    """

    __slots__ = ("_pointer", "_owner", "_document")

    def __init__(self, document: Mapping[str, Any], functions: int = 0) -> None:
        """document: as in docs/format.md; functions: how many there must be, which tells short knots from full ones."""
        if not isinstance(document, Mapping):
            raise InputError(f"found {type(document).__name__}, expected a basis or the dict of one", "", "type")
        unknown = sorted(set(document) - _KNOWN, key=str)
        if unknown:
            raise InputError(f"a basis has no member {unknown[0]!r}", f"/{unknown[0]}", "unknown-member")
        spec = c.BasisSpec()
        try:
            spec.type = encoded(document.get("type", ""))
            for name in ("degree", "count", "segments"):
                if name in document:
                    setattr(spec, name, _whole(document[name], name))
            for name in ("alpha", "beta", "gamma"):
                setattr(spec, name, real(document.get(name, 0), name))
            if document.get("range") is not None:
                ends = numbers(document["range"], "range")
                if ends.shape != (2,):
                    raise InputError(f"range is {document['range']!r}; expected two numbers", "/range", "size")
                spec.has_range, (spec.range[0], spec.range[1]) = 1, ends.tolist()
            knots = numbers(document.get("knots", ()), "knots")
            if knots.ndim != 1:
                raise InputError(f"knots have the shape {knots.shape}; expected a list of numbers", "/knots", "size")
        except InputError:
            raise
        except (TypeError, ValueError) as error:
            raise InputError(f"a basis: {error}", "", "type") from None
        spec.knot_count, spec.knots = knots.size, knots.ctypes.data if knots.size else None
        self._owner: Any = made(library.taut_basis_new, library.taut_basis_free, byref(spec), whole(functions, "functions"))
        self._pointer: int = self._owner.pointer
        self._document: dict[str, Any] | None = None

    @classmethod
    def _borrowed(cls, pointer: int, owner: object) -> Basis:
        basis = object.__new__(cls)
        basis._pointer, basis._owner, basis._document = pointer, owner, None
        return basis

    def to_dict(self) -> dict[str, Any]:
        """The document's object, in full form."""
        return dict(self._full())

    def _full(self) -> dict[str, Any]:
        if self._document is None:
            spec = c.BasisSpec()
            library.taut_basis_spec_of(self._pointer, byref(spec))
            kind = spec.type.decode()
            document: dict[str, Any] = {"type": kind}
            for name in _MEMBERS[kind]:
                document[name] = self.knots.tolist() if name == "knots" else getattr(spec, name)
            if spec.has_range:
                document["range"] = [spec.range[0], spec.range[1]]
            self._document = document
        return self._document

    @property
    def type(self) -> str:
        """Such as "bspline"."""
        return str(self._full()["type"])

    @property
    def count(self) -> int:
        """How many functions, which is how many control points along it."""
        return int(library.taut_basis_count(self._pointer))

    @property
    def degree(self) -> int | None:
        """Polynomial degree on each span; None where the functions are no polynomials."""
        degree = int(library.taut_basis_degree(self._pointer))
        return None if degree < 0 else degree

    @property
    def breaks(self) -> Array:
        """The ends of the spans, increasing."""
        return view(self._owner, library.taut_basis_breaks(self._pointer), (library.taut_basis_span_count(self._pointer) + 1,))

    @property
    def range(self) -> tuple[float, float]:
        """(lo, hi): the parameters."""
        breaks = self.breaks
        return float(breaks[0]), float(breaks[-1])

    @property
    def knots(self) -> Array:
        """All knots of a bspline; of other bases the breaks."""
        spec = c.BasisSpec()
        library.taut_basis_spec_of(self._pointer, byref(spec))
        return view(self._owner, spec.knots, (spec.knot_count,)) if spec.knot_count > 0 else self.breaks

    def __call__(self, t: npt.ArrayLike, derivatives: int = 0) -> Array:
        """The functions at t: shape t.shape + (count,), with derivatives (0 to 3) first: (derivatives + 1,) + that.

        Errors: InputError, `argument`: a t outside the range, or another number of derivatives."""
        parameters, derivatives = numbers(t, "t"), whole(derivatives, "derivatives")
        count, local = self.count, int(library.taut_basis_local(self._pointer))
        if not 0 <= derivatives <= 3:
            raise InputError(f"derivatives is {derivatives}; expected 0 to 3", "", "argument", derivatives)
        values = np.zeros((derivatives + 1, parameters.size, count))
        buffer: Any = (c_double * ((derivatives + 1) * local))()
        for i, one in enumerate(parameters.ravel().tolist()):
            span = library.taut_basis_span(self._pointer, one)
            status = library.taut_basis_eval(self._pointer, span, one, derivatives, buffer)
            if status != c.OK:
                raise InputError(f"t is {one!r}; expected {self.range[0]!r} to {self.range[1]!r}", "", "argument", one)
            first = library.taut_basis_first(self._pointer, span)
            values[:, i, first:first + local] = np.frombuffer(buffer, dtype=np.float64).reshape(derivatives + 1, local)
        values = values.reshape((derivatives + 1,) + parameters.shape + (count,))
        return values if derivatives > 0 else values.reshape(values.shape[1:])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Basis) and (self._pointer == other._pointer or repr(self.to_dict()) == repr(other.to_dict()))

    def __hash__(self) -> int:
        return hash(repr(self.to_dict()))

    def __repr__(self) -> str:
        document = self.to_dict()
        members = ", ".join(f"{name}={value!r}" for name, value in document.items() if name != "type")
        return f"taut.{document['type'].replace('-', '_')}({members})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Basis, (self.to_dict(), self.count)

    def __copy__(self) -> Basis:
        return self

    def __deepcopy__(self, memo: object) -> Basis:
        return self


BasisLike = Union[Basis, Mapping[str, Any]]


def basis_of(value: BasisLike, functions: int = 0) -> Basis:
    """A basis, from one or from its document."""
    return value if isinstance(value, Basis) else Basis(value, functions)


def _whole(value: Any, name: str) -> int:
    number = real(value, name)
    if not -2**31 <= number < 2**31 or number != int(number):
        raise ValueError(f"{name} is {value!r}; expected a whole number")
    return int(number)


def _spec(kind: str, range: Sequence[float] | None, **members: Any) -> Basis:
    return Basis({"type": kind, **members, **({} if range is None else {"range": range})})


def bezier(degree: int, range: Sequence[float] | None = None) -> Basis:
    """Bernstein polynomials: degree + 1 functions on [0, 1], or on `range` = (lo, hi).

    Errors: InputError: a degree other than 1 to 128, or a range that does not increase."""
    return _spec("bezier", range, degree=degree)


def bspline(degree: int, knots: npt.ArrayLike | None = None, count: int | None = None) -> Basis:
    """B-splines on clamped `knots`, or `count` of them on uniform knots over [0, 1].

    Errors: InputError: a degree other than 1 to 128, knots that decrease, are not clamped or too few, or neither or both of knots and count."""
    if (knots is None) == (count is None):
        raise InputError("bspline: give knots or count, one of them", "", "conflict")
    if knots is None:
        return _spec("bspline", None, degree=degree, count=count)
    return _spec("bspline", None, degree=degree, knots=knots)


def c_bezier(alpha: float, range: Sequence[float] | None = None) -> Basis:
    """4 functions over {1, t, sin t, cos t} on [0, alpha], 0 < alpha <= pi.

    Errors: InputError: another alpha, or a range that does not increase."""
    return _spec("c-bezier", range, alpha=alpha)


def h_bezier(beta: float, range: Sequence[float] | None = None) -> Basis:
    """4 functions over {1, t, sinh t, cosh t} on [0, beta].

    Errors: InputError: beta not above 0 or too large, or a range that does not increase."""
    return _spec("h-bezier", range, beta=beta)


def c_bspline(alpha: float, segments: int, range: Sequence[float] | None = None) -> Basis:
    """segments + 3 functions, C^2, over {1, t, sin t, cos t} on segments of length alpha < pi.

    Errors: InputError: another alpha, no segment, or a range that does not increase."""
    return _spec("c-bspline", range, alpha=alpha, segments=segments)


def h_bspline(beta: float, segments: int, range: Sequence[float] | None = None) -> Basis:
    """segments + 3 functions, C^2, over {1, t, sinh t, cosh t} on segments of length beta.

    Errors: InputError: beta not above 0 or too large, no segment, or a range that does not increase."""
    return _spec("h-bspline", range, beta=beta, segments=segments)


def ce_bezier(alpha: float, beta: float, gamma: float) -> Basis:
    """4 quartic polynomials with three shape numbers on [0, 1]; for curves.

    Errors: InputError: a number that is not finite."""
    return _spec("ce-bezier", None, alpha=alpha, beta=beta, gamma=gamma)


__all__ = ["Basis", "BasisLike", "bezier", "bspline", "c_bezier", "h_bezier", "c_bspline", "h_bspline", "ce_bezier"]
