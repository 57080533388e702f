"""From a problem to a model with its certificate."""
from __future__ import annotations

import json
import math
import os
import re
from ctypes import byref, c_void_p
from typing import Any, Mapping, Sequence, Union, overload

import numpy as np

from . import _library as c
from ._handle import Handle, bytes_of, encoded, expect, is_masked, library, made, path_of, real, thread_count, truth
from ._watch import Progress, Watch
from .bases import Basis
from .errors import InputError, raise_for
from .geometry import Curve, Surface
from .model import Certificate, Model, certificate_of, failed

Document = Union[Mapping[str, Any], Sequence[Any], str, "os.PathLike[str]"]

# --- Documents -------------------------------------------------------------------------------------------------------


_OF = re.compile(r"(/\d+)?/of")  # what a net or a pattern is of: a model, or here its one surface


def plain(value: Any, where: str = "") -> Any:
    """value with JSON's types alone: arrays become lists (rows with a NaN become null), bases, curves, surfaces, models objects."""
    if value is None or isinstance(value, (str, bool, int)):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            raise InputError(f"{where or 'the document'}: found {value}, expected a finite number", where, "value", value)
        return value
    if isinstance(value, np.ndarray):
        return _plain_array(value, where)
    if isinstance(value, (Basis, Curve, Surface)):
        return Model([value]).to_dict() if _OF.fullmatch(where) and isinstance(value, Surface) else value.to_dict()
    if isinstance(value, Model):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {str(key): plain(one, f"{where}/{key}") for key, one in value.items()}
    if isinstance(value, np.generic):
        return plain(value.item(), where)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Sequence):
        items = [plain(one, f"{where}/{i}") if not _is_unknown(one) else None for i, one in enumerate(value)]
        return items
    raise InputError(f"{where or 'the document'}: found {type(value).__name__}, expected what JSON holds", where, "type")


def text_of_document(document: Any) -> str:
    """A document as JSON, with the version of the format. What C's encoder takes as it is, and arrays in it that hold numbers alone, need not
    be gone through here; all else is, which is where points to be found become null and errors find their place."""
    if isinstance(document, dict):
        try:
            return json.dumps(with_version(document), default=_encoded, allow_nan=False)
        except (TypeError, ValueError):
            pass
    return json.dumps(with_version(plain(document)))


def _encoded(value: Any) -> Any:
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiu":
        return _plain_array(value, "")
    if isinstance(value, (Basis, Curve)):
        return value.to_dict()
    raise TypeError


def _is_unknown(value: Any) -> bool:
    """A point [x, y, z] with a NaN: one to be found."""
    return isinstance(value, (list, tuple)) and len(value) == 3 and any(isinstance(x, float) and math.isnan(x) for x in value)


def _plain_array(array: Any, where: str) -> Any:
    if array.dtype == object:
        return plain(array.tolist(), where)
    if array.dtype.kind not in "fiub":
        raise InputError(f"{where}: found an array of {array.dtype}, expected numbers", where, "type")
    if is_masked(array):  # what is masked is not known
        array = array.astype(np.float64).filled(np.nan)
    if array.dtype.kind != "f":
        return array.tolist()
    array = np.asarray(array, dtype=np.float64)
    finite = np.isfinite(array)
    if finite.all():
        return array.tolist()
    if array.ndim > 1 and array.shape[-1] == 3 and not np.isinf(array).any():
        unknown = ~finite.all(axis=-1)
        points = np.empty(array.shape[:-1], dtype=object)
        flat, rows = points.reshape(-1), array.reshape(-1, 3).tolist()
        for i, row in enumerate(rows):
            flat[i] = None if unknown.reshape(-1)[i] else row
        return points.tolist()
    if not np.isinf(array).any() and array.ndim > 1:  # points to be found, of another size than points are
        raise InputError(f"{where}: found an array of shape {array.shape} with NaN, expected (..., 3), a point to be found each",
                         where, "size")
    place = "".join(f"/{i}" for i in np.argwhere(np.isinf(array) if np.isinf(array).any() else ~finite)[0])
    raise InputError(f"{where}{place}: found a number that is not finite", where + place, "value")


# --- Calls that take long --------------------------------------------------------------------------------------------


def _made(problem: Any, options: c.MakeOptions | None, proof: c.CertifyOptions | None, make: Any, certify: Any) -> Model:
    error, pointer = c.ErrorStruct(), c_void_p()
    at, to = byref(pointer), byref(error)
    status = make(problem, None if options is None else byref(options), at, to)
    if status != c.OK:
        raise_for(status, error)
    handle = Handle(pointer.value or 0, library.taut_model_free)
    status = certify(pointer, problem, None if proof is None else byref(proof), at, to)
    if status != c.OK:
        raise_for(status, error)
    library.taut_model_set_certificate(handle.pointer, pointer)
    return Model._of(handle)


def _strict(model: Model, strict: bool, certificate: Certificate | None = None) -> Model:
    """The model, unless a claim of its certificate, or of the one given, does not hold; which is not looked at before it is asked for."""
    certificate = (certificate or model.certificate) if truth(strict, "strict") else None
    if certificate is not None and certificate.holds is False:
        raise failed(model, certificate)
    return model


def _options(tolerance: float | None, threads: int | None, exact: bool) -> tuple[c.MakeOptions, c.CertifyOptions]:
    limit, count, is_exact = 0.0 if tolerance is None else real(tolerance, "tolerance"), thread_count(threads), int(truth(exact, "exact"))
    if tolerance is not None and not 0 < limit < math.inf:
        raise InputError(f"tolerance is {tolerance!r}; expected a number above 0", "", "argument", limit)
    return c.MakeOptions(tolerance=limit, threads=count, exact=is_exact), c.CertifyOptions(tolerance=limit, threads=count, exact=is_exact)


def _is_text(document: str) -> bool:
    return document.lstrip()[:1] in ("{", "[")


def _problems(document: Document) -> Handle:
    """The problems of a document, which is a list of C's."""
    if isinstance(document, os.PathLike) or (isinstance(document, str) and not _is_text(document)):
        return made(library.taut_problem_list_read, library.taut_problem_list_free, encoded(os.fspath(document)))
    try:
        data = bytes_of(document if isinstance(document, (str, bytes, bytearray)) else text_of_document(document))
    except RecursionError:
        raise InputError("a document that contains itself, or that is nested too deep", "", "nesting") from None
    return made(library.taut_problem_list_read_text, library.taut_problem_list_free, data, len(data), b"<document>")


def with_version(document: Any) -> Any:
    """A document that need not say the version of the format."""
    if isinstance(document, list):
        return [with_version(one) for one in document]
    return {"taut": 1, **document} if isinstance(document, dict) else document


@overload
def make(document: Mapping[str, Any], tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None,
         strict: bool = False, exact: bool = False) -> Model: ...
@overload
def make(document: str | os.PathLike[str], tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None,
         strict: bool = False, exact: bool = False) -> Any: ...
@overload
def make(document: Sequence[Any], tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None,
         strict: bool = False, exact: bool = False) -> list[Model]: ...
def make(document: Document, tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None,
         strict: bool = False, exact: bool = False) -> Any:
    """The model of a problem, proved: document is a dict (arrays, bases, curves, surfaces and models may be in it), a JSON text, or a
    path. A list of problems gives a list of models.

    tolerance   largest distance from the exact surface over its size, where a construction approximates; None: 1e-6
    threads     how many, 1 to 256; None: 1; the result is the same
    progress    called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict      a claim that does not hold raises CheckFailed, whose `model` is the model
    exact       in rational arithmetic (harmonic and harmonic-extension)

    Raises InputError (the document), NoSolution, NotConverged, FileError (of a path), KeyboardInterrupt: docs/errors.md has the words of
    `reason`. What a document may say: docs/format.md.
    """
    problems = _problems(document)
    options, proof = _options(tolerance, threads, exact)
    truth(strict, "strict")
    models = []
    with Watch(progress) as watch:
        options.monitor = proof.monitor = watch.monitor
        for i in range(library.taut_problem_list_count(problems.pointer)):
            models.append(_made(library.taut_problem_list_at(problems.pointer, i), options, proof, library.taut_make,
                                library.taut_certify))
    for model in models:
        _strict(model, strict)
    return models if library.taut_problem_list_is_list(problems.pointer) else models[0]


def read(path: str | os.PathLike[str], threads: int | None = None, progress: Progress | None = None, strict: bool = False) -> Model:
    """A model from a file: .json, .step, .iges, and what else `taut convert` reads (docs/formats.md). What it holds is not proved by
    that: `certify` does. One thread reads; progress is called, the part done unknown; strict: CheckFailed where the certificate in
    the file says that a claim does not hold. Raises FileError, InputError."""
    thread_count(threads)
    with Watch(progress).begun("read") as watch:
        options = c.ReadOptions(monitor=watch.monitor)
        model = Model._of(made(library.taut_model_read_with, library.taut_model_free, encoded(path_of(path)), byref(options)))
    watch.tell(1.0, "read")
    return _strict(model, strict)


def certify(model: Model, problem: Document | None = None, tolerance: float | None = None, threads: int | None = None,
            exact: bool = False, progress: Progress | None = None, strict: bool = False) -> Certificate:
    """Proves a model again from its numbers alone, against its problem where that is given, and apart from what made it. Arguments as
    of make; with strict CheckFailed.model is the model. What the claims say: docs/certificate.md.

    Errors: InputError where the model or the problem is wrong, or where there are several problems; else as of make.
    """
    options = _options(tolerance, threads, exact)[1]
    truth(strict, "strict")
    expect(model, Model)
    problems = None if problem is None else _problems(problem)
    if problems is not None and library.taut_problem_list_count(problems.pointer) != 1:
        raise InputError("a model is certified against one problem", "", "argument")
    one = None if problems is None else library.taut_problem_list_at(problems.pointer, 0)
    with Watch(progress) as watch:
        options.monitor = watch.monitor
        handle = made(library.taut_certify, library.taut_certificate_free, model._pointer, one, byref(options))
    certificate = certificate_of(handle.pointer)
    _strict(model, strict, certificate)
    return certificate


def make_direct(problem: Any, make: Any, certify: Any, is_brief: bool, tolerance: float | None, threads: int | None,
                progress: Progress | None, strict: bool) -> Model:
    """The model of a struct of C, without a document between; is_brief: Ctrl-C may wait until it is made."""
    if is_brief and progress is None and tolerance is None and threads is None:
        return _strict(_made(problem, None, None, make, certify), strict)
    options, proof = _options(tolerance, threads, False)
    with Watch(progress) as watch:
        options.monitor = proof.monitor = watch.monitor
        model = _made(problem, options, proof, make, certify)
    return _strict(model, strict)


__all__ = ["certify", "make", "read"]
