"""Curves and surfaces as the XML that G+Smo and splinepy read and write, bit for bit.

    <Geometry type="BSpline">, "Nurbs", "TensorBSpline2", "TensorNurbs2"; read also "TensorBSpline1", "TensorNurbs1", as splinepy has curves

Each has a basis of knot vectors, weights in the basis, and points by rows, the first direction running fastest. What else is in
such a file (boundaries, interfaces, materials) is passed over; trims and names have no place there.
"""
from __future__ import annotations

import base64
import binascii
import os
from collections.abc import Iterable
from typing import Union
from xml.etree import ElementTree as xml

import numpy as np
import numpy.typing as npt

from ._handle import items_of, path_of
from .bases import Basis, bspline
from .errors import FileError, InputError
from .geometry import Curve, Surface
from .neighbours import _nurbs

Shape = Union[Curve, Surface]
Path = Union[str, "os.PathLike[str]"]
Array = npt.NDArray[np.float64]

_TYPES = {"BSpline": 1, "Nurbs": 1, "TensorBSpline1": 1, "TensorNurbs1": 1, "TensorBSpline2": 2, "TensorNurbs2": 2}  # and their directions
_BINARY = {"b64float64": "<f8", "b64float32": "<f4"}


def _numbers(element: xml.Element, where: str) -> Array:
    """The numbers in an element, which are written as text or in base64."""
    form, text = element.get("format", "ASCII"), element.text or ""
    try:
        if form.lower() in _BINARY:
            return np.frombuffer(base64.b64decode("".join(text.split()), validate=True), _BINARY[form.lower()]).astype(np.float64)
        if form.lower() == "ascii":
            return np.array([float(word) for word in text.split()])
    except (ValueError, binascii.Error) as error:
        raise InputError(f"{where}: {error}, expected numbers", where, "type", expected="numbers") from None
    expected = "ASCII, B64Float64 or B64Float32"
    raise InputError(f"{where}: format is \"{form}\", expected {expected}", where, "value", expected=expected)


def _whole(element: xml.Element, name: str, where: str) -> int:
    """An attribute that counts."""
    text = element.get(name, "")
    if not (text.isascii() and text.isdigit()):
        raise InputError(f"{where}: {name} is \"{text}\", expected a whole number", where, "type", expected="a whole number")
    return int(text)


def _basis(element: xml.Element, where: str) -> Basis:
    """The basis on one knot vector."""
    return bspline(_whole(element, "degree", where), knots=_numbers(element, where))


def _points(geometry: xml.Element, counts: tuple[int, ...], where: str) -> Array:
    """The points, counts by 3; in the plane z = 0 where the file has two coordinates."""
    element, where = geometry.find("coefs"), where + "/coefs"
    if element is None:
        raise InputError(f"{where}: missing, expected the points", where, "missing", expected="the points")
    columns, numbers = _whole(element, "geoDim", where), _numbers(element, where)
    if columns not in (2, 3):
        raise InputError(f"{where}: geoDim is {columns}, expected 2 or 3", where, "value", columns, "2 or 3")
    _check_count(numbers, columns * int(np.prod(counts)), where)
    points = np.zeros((*counts, 3))
    points[..., :columns] = numbers.reshape(*counts[::-1], columns).swapaxes(0, len(counts) - 1)
    return points


def _weights(geometry: xml.Element, counts: tuple[int, ...], where: str) -> Array | None:
    """The weights, by counts; None where there are none."""
    element, where = geometry.find("Basis/weights"), where + "/weights"
    if element is None:
        return None
    numbers = _numbers(element, where)
    _check_count(numbers, int(np.prod(counts)), where)
    return numbers.reshape(counts[::-1]).T


def _check_count(numbers: Array, expected: int, where: str) -> None:
    if len(numbers) != expected:
        raise InputError(f"{where}: {len(numbers)} numbers, expected {expected}", where, "size", len(numbers), expected)


def _shape(geometry: xml.Element, where: str) -> Shape:
    """The curve or surface of one element."""
    kind, knots = geometry.get("type", ""), geometry.findall(".//KnotVector")
    if kind not in _TYPES:
        expected = ", ".join(_TYPES)
        raise InputError(f"{where}: type is \"{kind}\", expected one of {expected}", where, "value", expected=expected)
    if len(knots) != _TYPES[kind]:
        raise InputError(f"{where}: {len(knots)} knot vectors, expected {_TYPES[kind]}", where, "size", len(knots), _TYPES[kind])
    bases = [_basis(element, f"{where}/KnotVector/{i}") for i, element in enumerate(knots)]
    counts = tuple(basis.count for basis in bases)
    points, weights = _points(geometry, counts, where), _weights(geometry, counts, where)
    return Curve(bases[0], points, weights) if len(bases) == 1 else Surface(bases[0], bases[1], points, weights)


def read(path: Path) -> list[Shape]:
    """The curves and surfaces of a file, in its order, their knots clamped.

    Errors: FileError where it cannot be read; InputError where it is not XML, has other geometries, or numbers that are too few,
    too many or no numbers; `.where` is then "Geometry/0/coefs" and the like."""
    place = path_of(path)
    try:
        root = xml.parse(place).getroot()
    except OSError as error:
        raise FileError(f"{place}: {error.strerror}", place, "read") from None
    except (xml.ParseError, LookupError, ValueError) as error:
        raise InputError(f"{place}: {error}, expected XML", place, "syntax", expected="XML") from None
    return [_shape(geometry, f"Geometry/{i}") for i, geometry in enumerate(root.iter("Geometry"))]


def _text(numbers: Array) -> str:
    """Rows of numbers, each the shortest text that is read as itself."""
    return "\n".join(" ".join(repr(x) for x in row) for row in numbers.tolist())


def _fastest_first(net: Array, directions: int, columns: int) -> Array:
    """A net by rows, the first direction running fastest."""
    return net.swapaxes(0, directions - 1).reshape(-1, columns)


def _element(shape: Shape, index: int, tolerance: float) -> xml.Element:
    """The element of a curve or a surface."""
    spline = _nurbs(shape, tolerance)
    bases = (spline.t,) if isinstance(shape, Curve) else (spline.u, spline.v)
    tensor, two = ("Tensor", "2") if len(bases) == 2 else ("", "")
    family = "BSpline" if spline.weights is None else "Nurbs"
    geometry = xml.Element("Geometry", type=f"{tensor}{family}{two}", id=str(index))
    parent = xml.SubElement(geometry, "Basis", type=f"{tensor}{family}Basis{two}")
    if spline.weights is not None:
        rational, parent = parent, xml.SubElement(parent, "Basis", type=f"{tensor}BSplineBasis{two}")
        xml.SubElement(rational, "weights").text = _text(_fastest_first(spline.weights, len(bases), 1))
    for i, basis in enumerate(bases):
        one = xml.SubElement(parent, "Basis", type="BSplineBasis", index=str(i)) if two else parent
        xml.SubElement(one, "KnotVector", degree=str(basis.degree)).text = _text(basis.knots[None])
    xml.SubElement(geometry, "coefs", geoDim="3").text = _text(_fastest_first(spline.points, len(bases), 3))
    return geometry


def write(shapes: Iterable[Shape], path: Path, tolerance: float = 1e-9) -> None:
    """Writes curves and surfaces; within `tolerance` where a basis is not polynomial, else exactly.

    Errors: FileError where the file cannot be written."""
    place, root = path_of(path), xml.Element("xml")
    root.extend([_element(shape, i, tolerance) for i, shape in enumerate(items_of(shapes, "curves and surfaces"))])
    text = xml.tostring(root, encoding="unicode", xml_declaration=True)
    try:
        with open(place, "w", encoding="utf-8") as file:
            file.write(text.replace("encoding='us-ascii'", "encoding='UTF-8'") + "\n")
    except OSError as error:
        raise FileError(f"{place}: {error.strerror}", place, "write") from None


__all__ = ["read", "write"]
