"""Models: surfaces, curves, what was decided, and the certificate."""
from __future__ import annotations

import ctypes
import json
import os
from copy import deepcopy
from ctypes import POINTER, byref, c_size_t, c_void_p, cast
from typing import Any, Iterator, Mapping, NamedTuple, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _library as c
from ._handle import Array, Handle, Referable, bytes_of, encoded, expect, is_one_of, items_of, library, made, numbers, path_of, real, text_of, thread_count, truth, view, whole
from ._watch import Progress, Watch
from .errors import CheckFailed, InputError, raise_for
from .geometry import Curve, Surface

_HOLDS = {0: False, 1: True, 2: None}


class Claim(NamedTuple):
    """One claim of a certificate.

    claim     its name, such as "stationary"
    kind      "exact", "bound" (both are proofs) or "check"
    residual  what was found
    limit     what it was held against
    holds     True, False, or None where it is undecided
    where     the place of the largest residual, or why it is undecided, or ""
    """

    claim: str
    kind: str
    residual: float
    limit: float
    holds: bool | None
    where: str


class Certificate(Referable):
    """What was proved of a model: immutable, compares by value. `certificate["stationary"]` is the claim of that name.

    construct  the construction, such as "plateau"
    claims     Claims; iterating goes through them
    holds      False if a claim is false, None if one is undecided (`least` does not count), else True
    """

    __slots__ = ("construct", "claims", "_figures", "holds")
    construct: str
    claims: tuple[Claim, ...]
    _figures: dict[str, Any]
    holds: bool | None

    def __init__(self, construct: str, claims: Sequence[Claim], figures: Mapping[str, Any], holds: bool | None) -> None:
        for name, value in (("construct", construct), ("claims", tuple(claims)), ("_figures", deepcopy(dict(figures))),
                            ("holds", holds)):
            object.__setattr__(self, name, value)

    @property
    def figures(self) -> dict[str, Any]:
        """Numbers such as the area, by name: a copy."""
        return deepcopy(self._figures)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a certificate is immutable: {name}")

    def __getitem__(self, claim: str) -> Claim:
        """The claim of that name."""
        for one in self.claims:
            if is_one_of(claim, (one.claim,)):
                return one
        raise KeyError(claim)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __contains__(self, claim: object) -> bool:
        """Whether there is such a claim, or one of that name."""
        return claim in self.claims if isinstance(claim, Claim) else is_one_of(claim, [one.claim for one in self.claims])

    def _key(self) -> tuple[Any, ...]:
        return (self.construct, repr(self.claims), json.dumps(self._figures, sort_keys=True), self.holds)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Certificate) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[Any, ...]:
        return Certificate, (self.construct, self.claims, self.figures, self.holds)

    def __repr__(self) -> str:
        words = {True: "holds", False: "does not hold", None: "is undecided"}
        return f"<taut.Certificate of {self.construct}: {words[self.holds]}; " + ", ".join(
            f"{one.claim} {words[one.holds]} ({one.kind})" for one in self.claims) + ">"

    def _repr_html_(self) -> str:
        from .notebook import certificate_table
        return certificate_table(self)


def record_of(pointer: int | None) -> Any:
    """A record of C as Python's dicts, lists and numbers."""
    return None if not pointer else json.loads(text_of(library.taut_record_write, pointer))


def certificate_of(pointer: int) -> Certificate:
    """A certificate of C."""
    claims = []
    for i in range(library.taut_certificate_claim_count(pointer)):
        one = cast(library.taut_certificate_claim(pointer, i), POINTER(c.ClaimStruct)).contents
        claims.append(Claim(one.claim.decode(), library.taut_claim_kind_name(one.kind).decode(), one.residual, one.limit,
                            _HOLDS[one.holds], one.where.decode("utf-8", "replace")))
    return Certificate(library.taut_certificate_construct(pointer).decode(), claims,
                       record_of(library.taut_certificate_figures(pointer)) or {}, _HOLDS[library.taut_certificate_holds(pointer)])


class _Items(Sequence[Any]):
    """Surfaces or curves of a model, by number; compared by value, with each other and with tuples."""

    def __init__(self, items: Sequence[Any]) -> None:
        self._items = tuple(items)

    def __getitem__(self, i: Any) -> Any:
        return self._items[i]

    def __len__(self) -> int:
        return len(self._items)

    def __eq__(self, other: object) -> bool:
        items = other._items if isinstance(other, _Items) else other
        if not isinstance(items, tuple):
            return NotImplemented
        return self._items == items

    def __hash__(self) -> int:
        return hash(self._items)

    def __repr__(self) -> str:
        return repr(list(self._items))


class Model:
    """Surfaces and curves with a certificate; immutable. `model["name"]` is a surface or curve by its name.

    Compares by value, hashes, pickles (as its document, bit for bit) and copies.
    """

    __slots__ = ("_handle", "_pointer", "_surfaces", "_curves", "_certificate", "_text", "__weakref__")

    def __init__(self, surfaces: Sequence[Surface] = (), curves: Sequence[Curve] = (), unit: str = "mm") -> None:
        """A model of your own surfaces and curves, without a certificate."""
        pointer = c_void_p()
        status = library.taut_model_new(byref(pointer))
        if status != c.OK:
            raise_for(status)
        handle = Handle(pointer.value or 0, library.taut_model_free)
        if library.taut_model_set_unit(handle.pointer, encoded(unit)) != c.OK:
            raise InputError(f"unit is {unit!r}; expected mm, m, cm, in or ft", "/unit", "value")
        for objects, kind, copy, add, free in (
                (surfaces, Surface, library.taut_surface_copy, library.taut_model_add_surface, library.taut_surface_free),
                (curves, Curve, library.taut_curve_copy, library.taut_model_add_curve, library.taut_curve_free)):
            for one in items_of(objects, f"{kind.__name__.lower()}s"):
                expect(one, kind)
                status = copy(one._pointer, byref(pointer))
                if status == c.OK:
                    status = add(handle.pointer, pointer)
                    if status != c.OK:
                        free(pointer)
                if status != c.OK:
                    raise_for(status)
        self._take(handle)

    def _take(self, handle: Handle) -> None:
        self._handle, self._pointer = handle, handle.pointer
        self._surfaces: _Items | None = None
        self._curves: _Items | None = None
        self._certificate: Certificate | None = None
        self._text: bytes | None = None

    @classmethod
    def _of(cls, handle: Handle) -> Model:
        model = object.__new__(cls)
        model._take(handle)
        return model

    @classmethod
    def from_json(cls, text: str | bytes) -> Model:
        """The model that a document holds.

        Errors: InputError with the place in the text as `where`."""
        data = bytes_of(text)
        return cls._of(made(library.taut_model_read_text, library.taut_model_free, data, len(data), b"<model>"))

    @property
    def surfaces(self) -> Sequence[Surface]:
        """In the order of the document."""
        if self._surfaces is None:
            self._surfaces = _Items([Surface._borrowed(library.taut_model_surface(self._pointer, i), self._handle)
                                     for i in range(library.taut_model_surface_count(self._pointer))])
        return self._surfaces

    @property
    def curves(self) -> Sequence[Curve]:
        """In the order of the document."""
        if self._curves is None:
            self._curves = _Items([Curve._borrowed(library.taut_model_curve(self._pointer, i), self._handle)
                                   for i in range(library.taut_model_curve_count(self._pointer))])
        return self._curves

    def __getitem__(self, name: str) -> Union[Surface, Curve]:
        every: list[Union[Surface, Curve]] = [*self.surfaces, *self.curves]
        found = [one for one in every if is_one_of(name, (one.name,))]
        if len(found) == 1:
            return found[0]
        raise KeyError(f"{name!r} is the name of {len(found)} surfaces and curves" if found else
                       f"{name!r}; there are {', '.join(repr(one.name) for one in every) or 'none'}")

    def piece(self, name: str) -> dict[str, Any]:
        """A piece of a pattern of cloth: what `details` tell of it, and under "flat" its Surface, "cut" the Curve to cut along, and
        "lines" those to sew along: "right", "end", "left" and "start". KeyError where there is no such piece."""
        pieces = [one for one in self.details.get("pieces", ()) if "edges" in one]
        for told in pieces:
            if is_one_of(name, (told["name"],)):
                flat = [one for one in self.surfaces if one.name == name][-1]  # the flat pieces are behind what is cut
                lines = {one.name: one for one in self.curves}
                return {**told, "flat": flat, "cut": lines[f"{name}.cut"],
                        "lines": {edge: lines[f"{name}.{edge}"] for edge in told["edges"]}}
        raise KeyError(f"{name!r}; there are {', '.join(repr(one['name']) for one in pieces) or 'no pieces'}")

    def __contains__(self, name: object) -> bool:
        """Whether a surface or curve has that name."""
        return is_one_of(name, [*(one.name for one in self.surfaces), *(one.name for one in self.curves)])

    __iter__ = None  # of its surfaces or its curves

    @property
    def unit(self) -> str:
        """"mm", "m", "cm", "in" or "ft"."""
        return str(library.taut_model_unit(self._pointer).decode())

    @property
    def details(self) -> dict[str, Any]:
        """What the construction decided, in its own words."""
        return record_of(library.taut_model_details(self._pointer)) or {}

    @property
    def certificate(self) -> Certificate | Any:  # so that who made a model need not ask whether it is None
        """What was proved of it; None where nothing was: of a model of your own, or split, or from a CAD file."""
        if self._certificate is None:
            pointer = library.taut_model_certificate(self._pointer)
            self._certificate = certificate_of(pointer) if pointer else None
        return self._certificate

    def to_json(self) -> str:
        """The document, byte for byte what the program writes."""
        return self._bytes().decode()

    def to_dict(self) -> dict[str, Any]:
        """The document's object."""
        document: dict[str, Any] = json.loads(self._bytes(), parse_int=lambda text: -0.0 if text == "-0" else int(text))
        return document

    def _bytes(self) -> bytes:
        if self._text is None:
            self._text = text_of(library.taut_model_write_text, self._pointer, b"json", None)
        return self._text

    def write(self, path: str | os.PathLike[str], tolerance: float = 0.0, threads: int | None = None, progress: Progress | None = None,
              strict: bool = False, **options: Any) -> None:
        """To a file whose ending says the format: .json, .step, .iges, .obj, .stl, .ply, .glb, .3mf, .vtu, .dxf, .csv,
        .svg, .pdf, .png, .html.

        tolerance   0: the format's own (1e-3 of the size for meshes)
        progress    as of taut.make
        strict      a model of which a claim does not hold is not written: CheckFailed
        options     divide, thickness (of meshes), coefficients, lagrange (of VTU), surface (name), colour ("plain", "mean",
                    "gaussian", "isothermality", "gap", "warp", "weft", "strain"), no_net (False: the net of pipes too),
                    view (azimuth, elevation in degrees), title, isolines, reflections, combs, reactions, side_by_side, column, width;
                    of flat pieces in .pdf: tiles ("a4" or "a3": 1:1 on sheets of paper), reduction (20: 1:20, on one page)

        Errors: FileError where the file cannot be written; InputError for an ending, an option or a name of a surface that is not there;
        NoSolution for what the format cannot hold. No file is left behind then, and one that was there stays.
        """
        error, chosen = c.ErrorStruct(), write_options(tolerance, threads, options)
        strictly(strict, self)
        with Watch(progress).begun("write") as watch:
            chosen.monitor = watch.monitor
            status = library.taut_model_write(self._pointer, encoded(path_of(path)), byref(chosen), byref(error))
        if status != c.OK:
            raise_for(status, error)

    def to_text(self, format: str, tolerance: float = 0.0, threads: int | None = None, progress: Progress | None = None,
                strict: bool = False, **options: Any) -> bytes:
        """The bytes that `write` would put into a file of this ending, such as "svg".

        Errors: as of `write`; InputError, `not-a-file`, of formats that are written to files alone."""
        if not isinstance(format, str):
            raise InputError(f"format is {format!r}; expected an ending such as 'svg'", "", "type")
        chosen = write_options(tolerance, threads, options)
        strictly(strict, self)
        with Watch(progress).begun("write") as watch:
            chosen.monitor = watch.monitor
            return text_of(library.taut_model_write_text, self._pointer, encoded(format), byref(chosen))

    def mesh(self, tolerance: float = 0.0, divide: int = 0, surface: str | None = None, threads: int | None = None,
             thickness: float = 0.0, progress: Progress | None = None, strict: bool = False) -> Mesh:
        """Vertices, normals and faces of all surfaces, or of the one named; closed where the surfaces are.

        tolerance   largest chord error over the size of the model; 0: 1e-3
        divide      cells for each knot span, in place of a tolerance
        thickness   of sheets, which are closed then, in the model's unit; 0: none
        progress    as of taut.make
        strict      of a model of which a claim does not hold there is none: CheckFailed

        Errors: InputError: a number below 0, no surface of that name, or too many vertices; NoSolution: a thickness that folds a surface over.
        """
        chosen = {"tolerance": real(tolerance, "tolerance"), "divide": whole(divide, "divide"), "thickness": real(thickness, "thickness")}
        for name, value in chosen.items():
            if not 0 <= value < float("inf"):
                raise InputError(f"{name} is {value!r}; expected 0 or more", "", "argument", value)
        if surface is not None and not is_one_of(surface, [one.name for one in self.surfaces]):
            there = ", ".join(repr(one.name) for one in self.surfaces) or "none"
            raise InputError(f"no surface is called {surface!r}; there are {there}", "", "surface")
        strictly(strict, self)
        options = c.MeshOptions(threads=thread_count(threads), surface=encoded(surface), **chosen)
        with Watch(progress) as watch:
            options.monitor = watch.monitor
            return Mesh(made(library.taut_mesh_new, library.taut_mesh_free, self._pointer, byref(options)))

    def plot(self, ax: Any = None, net: bool = False, tolerance: float = 0.0) -> Any:
        """All surfaces and curves drawn by matplotlib, into `ax` (of projection "3d") or new axes, which come back.

        Errors: ImportError where matplotlib is missing (Debian: python3-matplotlib)."""
        from .plotting import plot_model
        return plot_model(self, ax, net, tolerance)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and (self._pointer == other._pointer or self._bytes() == other._bytes())

    def __hash__(self) -> int:
        return hash(self._bytes())

    def __reduce__(self) -> tuple[Any, ...]:
        return Model.from_json, (self._bytes(),)

    def __copy__(self) -> Model:
        return self

    def __deepcopy__(self, memo: object) -> Model:
        return self

    def __repr__(self) -> str:
        every: list[Union[Surface, Curve]] = [*self.surfaces, *self.curves]
        names = ", ".join(repr(one.name) for one in every) or "nothing"
        certificate = self.certificate
        return f"<taut.Model of {names}{'' if certificate is None else '; ' + repr(certificate)[1:-1]}>"

    def _repr_html_(self) -> str:
        from .notebook import model_page
        return model_page(self)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a notebook shows: the page, the picture for where pages are not shown, and a line of text."""
        from .notebook import model_bundle
        return model_bundle(self, include, exclude)


def strictly(strict: bool, *parts: Union[Model, Surface, Curve]) -> None:
    """Raises CheckFailed where that was asked for and a claim does not hold of a model that is given, or that a surface or curve is of."""
    for one in parts if truth(strict, "strict") else ():
        if not isinstance(one, Model) and one._owner._free is not library.taut_model_free:
            continue  # of no model
        model = one if isinstance(one, Model) else Model._of(one._owner)
        if model.certificate is not None and model.certificate.holds is False:
            raise failed(model, model.certificate)


def failed(model: Model, certificate: Certificate) -> CheckFailed:
    """What says which claims of a certificate do not hold."""
    names = ", ".join(one.claim for one in certificate.claims if one.holds is False)
    failure = CheckFailed(f"{certificate.construct}: a claim does not hold: {names}", "", "claim")
    failure.model = model
    return failure


class Mesh(Referable):
    """Triangles and quads; all arrays are read-only and without a copy. Immutable; compares by value, hashes, pickles and copies.

    vertices    (n, 3)          normals   (n, 3)        parameters   (n, 2): u, v
    triangles   (m, 3) uint32   quads     (k, 4) uint32
    faces       the triangles
    welded      (n,) uint32: the first vertex in the same place
    """

    __slots__ = ("vertices", "normals", "parameters", "quads", "triangles", "welded")
    vertices: Array
    normals: Array
    parameters: Array
    quads: npt.NDArray[np.uint32]
    triangles: npt.NDArray[np.uint32]
    welded: npt.NDArray[np.uint32]

    def __init__(self, handle: Handle) -> None:
        p, n, k = handle.pointer, library.taut_mesh_vertex_count(handle.pointer), library.taut_mesh_quad_count(handle.pointer)
        self._take(view(handle, library.taut_mesh_positions(p), (n, 3)), view(handle, library.taut_mesh_normals(p), (n, 3)),
                   view(handle, library.taut_mesh_parameters(p), (n, 2)), view(handle, library.taut_mesh_quads(p), (k, 4), ctypes.c_uint32),
                   view(handle, library.taut_mesh_triangles(p), (2 * k, 3), ctypes.c_uint32),
                   view(handle, library.taut_mesh_welded(p), (n,), ctypes.c_uint32))

    def _take(self, *arrays: npt.NDArray[Any]) -> None:
        for name, array in zip(Mesh.__slots__, arrays):
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @classmethod
    def _of(cls, *arrays: npt.NDArray[Any]) -> Mesh:
        mesh = object.__new__(cls)
        mesh._take(*arrays)
        return mesh

    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """The triangles."""
        return self.triangles

    @property
    def _arrays(self) -> tuple[npt.NDArray[Any], ...]:
        return tuple(getattr(self, name) for name in Mesh.__slots__)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a mesh is immutable: {name}")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mesh) and all(a.shape == b.shape and a.tobytes() == b.tobytes() for a, b in zip(self._arrays, other._arrays))

    def __hash__(self) -> int:
        return hash(tuple(array.tobytes() for array in self._arrays))

    def __reduce__(self) -> tuple[Any, ...]:
        return Mesh._of, self._arrays

    def __copy__(self) -> Mesh:
        return self

    def __deepcopy__(self, memo: object) -> Mesh:
        return self

    def __repr__(self) -> str:
        return f"<taut.Mesh: {len(self.vertices)} vertices, {len(self.triangles)} triangles>"


_PAPERS = ("", "a4", "a3")
_COLOURS = ("plain", "mean", "gaussian", "isothermality", "gap", "warp", "weft", "strain")


def write_options(tolerance: float, threads: int | None, options: Mapping[str, Any]) -> c.WriteOptions:
    """C's struct of what a person says."""
    chosen = c.WriteOptions(tolerance=real(tolerance, "tolerance"), threads=thread_count(threads), formats=c.DRAW_FORMATS)
    for name, value in options.items():
        if name == "colour":
            if not is_one_of(value, _COLOURS):
                raise InputError(f"colour is {value!r}; expected one of {', '.join(_COLOURS)}", "", "name")
            chosen.colour = _COLOURS.index(value)
        elif name == "view":
            angles = numbers(value, "view")
            if angles.shape != (2,):
                raise InputError(f"view is {value!r}; expected two numbers, azimuth and elevation", "", "size")
            chosen.has_view, (chosen.view[0], chosen.view[1]) = 1, angles.tolist()
        elif name in ("surface", "title"):
            setattr(chosen, name, encoded(value))
        elif name in ("divide", "isolines", "reflections", "width"):
            setattr(chosen, name, whole(value, name))
        elif name in ("thickness", "reduction"):
            setattr(chosen, name, real(value, name))
        elif name == "tiles":
            if not is_one_of(value, _PAPERS):
                raise InputError(f"tiles is {value!r}; expected one of {', '.join(_PAPERS[1:])}", "", "name")
            chosen.tiles = _PAPERS.index(value)
        elif name == "no_net":
            chosen.no_net = 1 if truth(value, name) else -1
        elif name in ("combs", "reactions", "side_by_side", "column", "short_knots", "coefficients", "lagrange"):
            setattr(chosen, name, int(truth(value, name)))
        else:
            raise TypeError(f"there is no option {name!r}")
    return chosen


__all__ = ["Certificate", "Claim", "Mesh", "Model"]
