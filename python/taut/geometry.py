"""Curves and surfaces: immutable, evaluated on arrays of parameters of any shape."""
from __future__ import annotations

from ctypes import c_double
from typing import TYPE_CHECKING, Any, Callable

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._handle import Array, Handle, Referable, encoded, is_one_of, library, made, numbers, real, thread_count, view, whole
from ._watch import Progress
from .bases import Basis, BasisLike, basis_of
from .errors import InputError

if TYPE_CHECKING:
    from .model import Mesh

_three = c_double * 3
_SCALARS = frozenset((float, np.float64))  # what ctypes takes for a double as it is
_NONE = 0  # derivatives; another 0 than this one takes the longer way to the same point
_surface_eval = library.taut_surface_eval
_curve_eval = library.taut_curve_eval
_frombuffer: Callable[..., Array] = np.frombuffer


def _net(points: npt.ArrayLike, weights: npt.ArrayLike | None, dimensions: int) -> tuple[Array, Array | None]:
    """Points and weights as C wants them; shapes are checked here, numbers there."""
    net = numbers(points, "points")
    if net.ndim != dimensions + 1 or net.shape[-1] != 3:
        raise InputError(f"points have the shape {net.shape}; expected {'(nu, nv, 3)' if dimensions == 2 else '(n, 3)'}", "/points",
                         "size")
    factors = None if weights is None else numbers(weights, "weights")
    if factors is not None and factors.shape != net.shape[:-1]:
        raise InputError(f"weights have the shape {factors.shape}; expected {net.shape[:-1]}", "/weights", "size")
    return net, factors


def _order(derivatives: Any, highest: int) -> int:
    """How many derivatives, which are given."""
    order = whole(derivatives, "derivatives")
    if not 0 <= order <= highest:
        raise InputError(f"derivatives is {derivatives}; expected 0 to {highest}", "", "argument", derivatives)
    return order


def _outside(*parameters: tuple[str, Any, tuple[float, float]]) -> InputError:
    """Which parameter lies outside its range: (name, values, range) of each direction."""
    for name, values, (lo, hi) in parameters:
        array = np.asarray(values)
        wrong = np.flatnonzero(~((array >= lo) & (array <= hi)))
        if len(wrong) > 0:
            found = float(array.flat[wrong[0]])
            place = "" if array.ndim == 0 else f"[{', '.join(str(i) for i in np.unravel_index(wrong[0], array.shape))}]"
            return InputError(f"{name}{place} is {found!r}; expected {lo!r} to {hi!r}", "", "parameter", found)
    return InputError("a parameter is outside its range", "", "parameter")


def _check_out(out: Any, shapes: tuple[tuple[int, ...], ...]) -> None:
    """Refuses what numbers cannot be put into as they are."""
    if not isinstance(out, np.ndarray):
        raise InputError(f"out is a {type(out).__name__}; expected an array", "", "type")
    if out.dtype != np.float64:
        raise InputError(f"out is an array of {out.dtype}; expected float64", "", "type")
    if out.shape not in shapes:
        raise InputError(f"out has the shape {out.shape}; expected {' or '.join(map(str, shapes))}", "", "size")
    if not out.flags.writeable:
        raise InputError("out is read-only; expected an array that may be written", "", "argument")
    if not out.flags.c_contiguous:
        raise InputError("out is not in C order; expected np.ascontiguousarray(out)", "", "argument")


def _direction(direction: Any) -> int:
    if not is_one_of(direction, ("u", "v")):
        raise InputError(f"the direction is {direction!r}; expected 'u' or 'v'", "", "name")
    return int(direction == "v")


def _matrix(matrix: npt.ArrayLike) -> Array:
    rows = numbers(matrix, "matrix")
    if rows.shape != (3, 4):
        raise InputError(f"the matrix has the shape {rows.shape}; expected (3, 4)", "", "size")
    return rows


class _Geometry(Referable):
    """What curves and surfaces share."""

    __slots__ = ("_pointer", "_owner", "_points", "_weights")
    _pointer: int
    _owner: Any
    _points: Array | None
    _weights: Array | None

    def _is_same(self, other: Any) -> bool:
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and (self._pointer == other._pointer or self._is_same(other))  # type: ignore[attr-defined]

    def __copy__(self) -> Any:
        return self

    def __deepcopy__(self, memo: object) -> Any:
        return self


def _same_arrays(a: Array | None, b: Array | None) -> bool:
    return (a is None) == (b is None) and (a is None or b is None or (a.shape == b.shape and a.tobytes() == b.tobytes()))


class Curve(_Geometry):
    """x(t) = sum of weights, points and functions; `curve(t)` evaluates.

    t        its basis
    points   (n, 3): control points, Euclidean
    weights  (n,), positive, or None

    Errors: InputError where points, weights and functions are not as many, or a number is not finite or a weight not above 0.
    """

    __slots__ = ()

    def __init__(self, t: BasisLike, points: npt.ArrayLike, weights: npt.ArrayLike | None = None, name: str = "") -> None:
        net, factors = _net(points, weights, 1)
        basis = basis_of(t, len(net))
        if basis.count != len(net):
            raise InputError(f"found {len(net)} points; expected {basis.count}, as many as functions", "/points", "size", len(net), basis.count)
        self._owner = made(library.taut_curve_new, library.taut_curve_free, encoded(name), basis._pointer, net.ctypes.data,
                           None if factors is None else factors.ctypes.data)
        self._pointer, self._points, self._weights = self._owner.pointer, None, None

    @classmethod
    def _borrowed(cls, pointer: int, owner: object) -> Curve:
        curve = object.__new__(cls)
        curve._pointer, curve._owner, curve._points, curve._weights = pointer, owner, None, None
        return curve

    @property
    def name(self) -> str:
        """What it is called; "" if nothing."""
        return str(library.taut_curve_name(self._pointer).decode("utf-8", "surrogateescape"))

    @property
    def t(self) -> Basis:
        """Its basis."""
        return Basis._borrowed(library.taut_curve_t(self._pointer), self._owner)

    @property
    def points(self) -> Array:
        """(n, 3), read-only, without a copy."""
        if self._points is None:
            self._points = view(self._owner, library.taut_curve_points(self._pointer), (self.t.count, 3))
        return self._points

    @property
    def weights(self) -> Array | None:
        """(n,), read-only, or None."""
        address = library.taut_curve_weights(self._pointer)
        return view(self._owner, address, (self.t.count,)) if address else None

    def __call__(self, t: npt.ArrayLike, derivatives: int = 0) -> Array:
        """Points at t: t.shape + (3,). With derivatives 1 to 3: (derivatives + 1,) + that, positions first.

        Errors: InputError, `parameter`: a t outside the range of the basis."""
        if derivatives is _NONE and t.__class__ in _SCALARS:
            buffer = _three()
            if _curve_eval(self._pointer, t, 0, buffer) == 0:
                return _frombuffer(buffer)
        parameters, derivatives = numbers(t, "t"), _order(derivatives, 3)
        values = np.empty((parameters.size, derivatives + 1, 3))
        if parameters.size > 0 and library.taut_curve_eval_points(self._pointer, parameters.size, parameters.ctypes.data, derivatives, 1,
                                                                  values.ctypes.data) != c.OK:
            raise _outside(("t", parameters, self.t.range))
        if derivatives == 0:
            return values.reshape(parameters.shape + (3,))
        return np.ascontiguousarray(values.transpose(1, 0, 2)).reshape((derivatives + 1,) + parameters.shape + (3,))

    def _new(self, function: Any, *arguments: Any) -> Curve:
        handle = made(function, library.taut_curve_free, self._pointer, *arguments)
        return Curve._borrowed(handle.pointer, handle)

    def reversed(self) -> Curve:
        """The curve runs the other way."""
        return self._new(library.taut_curve_reverse)

    def elevated(self, times: int = 1) -> Curve:
        """The degree raised, the same curve.

        Errors: InputError: times below 0, or a degree above 128; NoSolution, `basis`: not a bezier or bspline."""
        return self._new(library.taut_curve_elevate, whole(times, "times"))

    def inserted(self, knot: float, times: int = 1) -> Curve:
        """A knot more, the same curve.

        Errors: InputError: more often than its degree; NoSolution: not inside the range (`parameter`), or not a bezier or bspline (`basis`)."""
        return self._new(library.taut_curve_insert, real(knot, "knot"), whole(times, "times"))

    def transformed(self, matrix: npt.ArrayLike) -> Curve:
        """A x + b for matrix = (A | b), shape (3, 4).

        Errors: InputError: another shape, or a number that is not finite or does not stay so."""
        return self._new(library.taut_curve_transform, _matrix(matrix).ctypes.data)

    def plot(self, ax: Any = None, count: int = 200, **options: Any) -> Any:
        """Drawn by matplotlib through `count` points, into `ax` or new axes, which come back; options are those of `Axes3D.plot`.

        Errors: ImportError where matplotlib is missing (Debian: python3-matplotlib)."""
        from .plotting import plot_curve
        return plot_curve(self, ax, count, **options)

    def to_dict(self) -> dict[str, Any]:
        """The document's object."""
        weights = self.weights
        return {"name": self.name, "t": self.t.to_dict(), "points": self.points.tolist(),
                **({} if weights is None else {"weights": weights.tolist()})}

    def _is_same(self, other: Any) -> bool:
        return bool(self.name == other.name and self.t == other.t and _same_arrays(self.points, other.points)
                    and _same_arrays(self.weights, other.weights))

    def __hash__(self) -> int:
        return hash((self.name, self.points.tobytes()))

    def __repr__(self) -> str:
        return f"<taut.Curve {self.name!r}: {self.t.count} points on {self.t.type}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Curve, (self.t, np.array(self.points), None if self.weights is None else np.array(self.weights), self.name)


class Surface(_Geometry):
    """x(u, v) = sum of weights, points and functions; `surface(u, v)` evaluates, `surface.grid` on a grid.

    u, v     its bases
    points   (nu, nv, 3): control points, Euclidean, u slowest
    weights  (nu, nv), positive, or None

    Errors: InputError where points, weights and functions are not as many, or a number is not finite or a weight not above 0.
    """

    __slots__ = ()

    def __init__(self, u: BasisLike, v: BasisLike, points: npt.ArrayLike, weights: npt.ArrayLike | None = None,
                 name: str = "") -> None:
        net, factors = _net(points, weights, 2)
        along_u, along_v = basis_of(u, net.shape[0]), basis_of(v, net.shape[1])
        if (along_u.count, along_v.count) != net.shape[:2]:
            raise InputError(f"points have the shape {net.shape}; expected ({along_u.count}, {along_v.count}, 3), as many as functions",
                             "/points", "size")
        self._owner = made(library.taut_surface_new, library.taut_surface_free, encoded(name), along_u._pointer, along_v._pointer,
                           net.ctypes.data, None if factors is None else factors.ctypes.data)
        self._pointer, self._points, self._weights = self._owner.pointer, None, None

    @classmethod
    def _borrowed(cls, pointer: int, owner: object) -> Surface:
        surface = object.__new__(cls)
        surface._pointer, surface._owner, surface._points, surface._weights = pointer, owner, None, None
        return surface

    @property
    def name(self) -> str:
        """What it is called; "" if nothing."""
        return str(library.taut_surface_name(self._pointer).decode("utf-8", "surrogateescape"))

    @property
    def u(self) -> Basis:
        """The basis along u, the first index of points."""
        return Basis._borrowed(library.taut_surface_u(self._pointer), self._owner)

    @property
    def v(self) -> Basis:
        """The basis along v, the second index of points."""
        return Basis._borrowed(library.taut_surface_v(self._pointer), self._owner)

    @property
    def points(self) -> Array:
        """(nu, nv, 3), read-only, without a copy; lives as long as it is used, also when the model is gone."""
        if self._points is None:
            self._points = view(self._owner, library.taut_surface_points(self._pointer), (self.u.count, self.v.count, 3))
        return self._points

    @property
    def weights(self) -> Array | None:
        """(nu, nv), read-only, or None."""
        address = library.taut_surface_weights(self._pointer)
        return view(self._owner, address, (self.u.count, self.v.count)) if address else None

    def __call__(self, u: npt.ArrayLike, v: npt.ArrayLike, derivatives: int = 0) -> Array:
        """Points at pairs (u, v), broadcast against each other: shape + (3,).

        derivatives 1 or 2: (3 or 6,) + that: S, S_u, S_v, S_uu, S_uv, S_vv. From the right at inner knots.

        Errors: InputError: a parameter outside the ranges of the bases (`parameter`), or shapes that do not go together (`size`).
        """
        if derivatives is _NONE and u.__class__ in _SCALARS and v.__class__ in _SCALARS:
            buffer = _three()
            if _surface_eval(self._pointer, u, v, 0, buffer) == 0:
                return _frombuffer(buffer)
        derivatives = _order(derivatives, 2)
        try:
            along_u, along_v = np.broadcast_arrays(numbers(u, "u"), numbers(v, "v"))
        except InputError:
            raise
        except ValueError:
            raise InputError(f"u has the shape {np.shape(u)}, v {np.shape(v)}: they do not go together; grid() takes all pairs", "", "size") from None
        one, other = np.ascontiguousarray(along_u), np.ascontiguousarray(along_v)
        vectors = (derivatives + 1) * (derivatives + 2) // 2
        values = np.empty((along_u.size, vectors, 3))
        if along_u.size > 0 and library.taut_surface_eval_points(self._pointer, along_u.size, one.ctypes.data, other.ctypes.data,
                                                                 derivatives, 1, values.ctypes.data) != c.OK:
            raise _outside(("u", along_u, self.u.range), ("v", along_v, self.v.range))
        if derivatives == 0:
            return values.reshape(along_u.shape + (3,))
        return np.ascontiguousarray(values.transpose(1, 0, 2)).reshape((vectors,) + along_u.shape + (3,))

    def grid(self, u: npt.ArrayLike, v: npt.ArrayLike, derivatives: int = 2, out: Array | None = None,
             threads: int | None = None) -> Array:
        """All pairs of parameters: (k, len(u), len(v), 3), k = 1, 3 or 6 for derivatives 0, 1 or 2: S, S_u, S_v, S_uu, S_uv, S_vv.

        out      an array to fill in place of a new one: float64, C order, of that shape; for derivatives 0 also without the 1
        threads  how many; the numbers are the same

        Errors: InputError: a parameter outside the ranges of the bases (`parameter`), or an `out` of another kind (`type`, `size`; read-only or
        not in C order: `argument`).
        """
        along_u, along_v, derivatives = numbers(u, "u"), numbers(v, "v"), _order(derivatives, 2)
        if along_u.ndim != 1 or along_v.ndim != 1:
            raise InputError("grid: u and v are not lists of numbers", "", "argument")
        vectors = (derivatives + 1) * (derivatives + 2) // 2
        shape = (vectors, len(along_u), len(along_v), 3)
        if out is not None:
            _check_out(out, (shape, shape[1:]) if derivatives == 0 else (shape,))
        is_direct = out is not None and derivatives == 0 and out.flags.aligned
        values = out if is_direct else np.empty((len(along_u), len(along_v), vectors, 3))
        assert values is not None
        if 0 not in shape:
            status = library.taut_surface_eval_grid(self._pointer, len(along_u), along_u.ctypes.data, len(along_v),
                                                    along_v.ctypes.data, derivatives, thread_count(threads) or 1, values.ctypes.data)
            if status == c.NO_MEMORY:
                raise MemoryError("taut: memory ran out")
            if status != c.OK:
                raise _outside(("u", along_u, self.u.range), ("v", along_v, self.v.range))
        if is_direct:
            return values
        result = values.transpose(2, 0, 1, 3)
        if out is not None:
            np.copyto(out, result[0] if out.ndim == 3 else result)
        return result if out is None else out

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Unit normals S_u x S_v at pairs (u, v): shape + (3,); NaN where it vanishes.

        Errors: InputError: as of surface(u, v)."""
        _, along_u, along_v = self(u, v, derivatives=1)
        normal = np.cross(along_u, along_v)
        length = np.linalg.norm(normal, axis=-1, keepdims=True)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(normal / length)

    def _new(self, function: Any, *arguments: Any) -> Surface:
        handle = made(function, library.taut_surface_free, self._pointer, *arguments)
        return Surface._borrowed(handle.pointer, handle)

    def transposed(self) -> Surface:
        """u and v change places."""
        return self._new(library.taut_surface_transpose)

    def reversed(self, direction: str) -> Surface:
        """"u" or "v" runs the other way.

        Errors: InputError, `name`: another direction."""
        return self._new(library.taut_surface_reverse, _direction(direction))

    def elevated(self, direction: str, times: int = 1) -> Surface:
        """The degree along "u" or "v" raised, the same surface.

        Errors: InputError: another direction, times below 0, or a degree above 128; NoSolution, `basis`: not a bezier or bspline."""
        return self._new(library.taut_surface_elevate, _direction(direction), whole(times, "times"))

    def inserted(self, direction: str, knot: float, times: int = 1) -> Surface:
        """A knot more along "u" or "v", the same surface.

        Errors: InputError: another direction, or more often than its degree; NoSolution: not inside the range (`parameter`), or not a bezier
        or bspline (`basis`)."""
        return self._new(library.taut_surface_insert, _direction(direction), real(knot, "knot"), whole(times, "times"))

    def transformed(self, matrix: npt.ArrayLike) -> Surface:
        """A x + b for matrix = (A | b), shape (3, 4).

        Errors: InputError: another shape, or a number that is not finite or does not stay so."""
        return self._new(library.taut_surface_transform, _matrix(matrix).ctypes.data)

    def mesh(self, tolerance: float = 0.0, divide: int = 0, threads: int | None = None, thickness: float = 0.0,
             progress: Progress | None = None, strict: bool = False) -> Mesh:
        """Vertices, normals and faces: as of `Model.mesh`, tolerance over the surface's size; strict about the model that it is of.

        Errors: as of `Model.mesh`."""
        from .model import Model, strictly
        strictly(strict, self)
        return Model([self]).mesh(tolerance, divide, None, threads, thickness, progress)

    def plot(self, ax: Any = None, net: bool = False, tolerance: float = 0.0, **options: Any) -> Any:
        """Drawn by matplotlib as a mesh, into `ax` (of projection "3d") or new axes, which come back.

        net         the control net too
        tolerance   of the mesh, over the size; 0: 1e-3
        options     of `Axes3D.plot_trisurf`: color, cmap, alpha ...

        Errors: ImportError where matplotlib is missing (Debian: python3-matplotlib).
        """
        from .plotting import plot_surface
        return plot_surface(self, ax, net, tolerance, **options)

    def to_dict(self) -> dict[str, Any]:
        """The document's object."""
        weights = self.weights
        return {"name": self.name, "u": self.u.to_dict(), "v": self.v.to_dict(), "points": self.points.tolist(),
                **({} if weights is None else {"weights": weights.tolist()})}

    def _is_same(self, other: Any) -> bool:
        return bool(self.name == other.name and self.u == other.u and self.v == other.v and _same_arrays(self.points, other.points)
                    and _same_arrays(self.weights, other.weights))

    def __hash__(self) -> int:
        return hash((self.name, self.points.tobytes()))

    def __repr__(self) -> str:
        return f"<taut.Surface {self.name!r}: {self.u.count} x {self.v.count} points on {self.u.type} x {self.v.type}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Surface, (self.u, self.v, np.array(self.points), None if self.weights is None else np.array(self.weights), self.name)


__all__ = ["Curve", "Surface"]
