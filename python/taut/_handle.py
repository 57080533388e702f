"""Objects of C that Python owns, and views of their memory."""
from __future__ import annotations

import ctypes
import operator
import os
import sys
from ctypes import byref, c_char_p, c_double, c_size_t, c_uint32, c_void_p
from functools import lru_cache
from typing import Any, Callable, Container, Iterator

import numpy as np
import numpy.typing as npt

from . import _library as c
from .errors import InputError, raise_for

Array = npt.NDArray[np.float64]
library = c.library


class Handle:
    """A pointer that is freed when nothing needs it any more: neither an object nor a view of its memory."""

    __slots__ = ("pointer", "_free", "__weakref__")

    def __init__(self, pointer: int, free: Callable[[int], None]) -> None:
        self.pointer, self._free = pointer, free

    def __del__(self, _is_over: Callable[[], bool] = sys.is_finalizing) -> None:
        if not _is_over():  # then the system takes it all; views may still be read
            self._free(self.pointer)


def made(function: Any, free: Callable[[int], None], *arguments: Any) -> Handle:
    """The object that function(*arguments, &object, &error) makes."""
    error, pointer = c.ErrorStruct(), c_void_p()
    status = function(*arguments, byref(pointer), byref(error))
    if status != c.OK:
        raise_for(status, error)
    assert pointer.value is not None
    return Handle(pointer.value, free)


def address_of(array: npt.NDArray[Any]) -> int:
    """Where the numbers of an array lie: array.ctypes.data in a quarter of its time."""
    address: int = array.__array_interface__["data"][0]
    return address


@lru_cache(maxsize=256)
def _array_type(kind: Any, count: int) -> Any:
    return kind * count


def view(owner: object, address: int, shape: tuple[int, ...], kind: Any = c_double) -> npt.NDArray[Any]:
    """Numbers that C holds, read-only and without a copy; `owner` lives as long as the view."""
    count = 1
    for length in shape:
        count *= length
    memory = _array_type(kind, count).from_address(address)
    memory.owner = owner
    # of memory that cannot be written: nobody can make the array writable again
    return np.frombuffer(memoryview(memory).toreadonly(), dtype=np.uint32 if kind is c_uint32 else np.float64).reshape(shape)


def _refuse_others(values: Any, array: npt.NDArray[Any]) -> None:
    """What numpy would make numbers of in silence: texts, dates, complex and masked ones, and None, of which it makes NaN."""
    if array.dtype.kind not in "biufO":
        raise TypeError(f"an array of {array.dtype}")
    if array.dtype.kind == "O" and any(one is None or isinstance(one, (str, bytes, complex, np.complexfloating)) for one in array.flat):
        raise TypeError("None is no number" if array.ndim == 0 else "an array of objects with None, texts or complex numbers")
    if is_masked(values):
        raise TypeError("numbers that are masked")


def is_masked(values: Any) -> bool:
    """Whether it is an array some of whose numbers do not count."""
    return isinstance(values, np.ma.MaskedArray) and bool(np.any(values.mask))


def numbers(values: Any, what: str) -> Array:
    """values as doubles side by side; what names them where they are none."""
    try:
        array = np.asarray(values)
        if array.dtype != np.float64 or array is not values:
            _refuse_others(values, array)
        return side_by_side(array).reshape(array.shape)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{what}: found {type(values).__name__}, expected numbers ({error})", "", "type") from None


def side_by_side(array: npt.NDArray[Any]) -> Array:
    """The numbers of an array in the order, and at addresses, as C has them; a copy where they are not."""
    array = np.ascontiguousarray(array, dtype=np.float64)
    return array if array.flags.aligned else array.copy()


def real(value: Any, what: str) -> float:
    """value as one number."""
    try:
        if isinstance(value, (str, bytes, bytearray)):
            raise TypeError
        if isinstance(value, (np.ndarray, np.generic)):
            _refuse_others(value, np.asarray(value))
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{what} is {value!r}; expected a number", "", "type") from None


def whole(value: Any, what: str) -> int:
    """value as an int of C; ctypes would cut a larger one."""
    try:
        number = operator.index(value)
    except TypeError:
        raise InputError(f"{what} is {value!r}; expected a whole number", "", "type") from None
    if not -2**31 <= number < 2**31:
        raise InputError(f"{what} is {value!r}; expected less than 2^31", "", "type")
    return number


def truth(value: Any, what: str) -> bool:
    """value as True or False, which 1 and 0 are too."""
    if value.__class__ is bool or (isinstance(value, (int, np.bool_)) and value in (0, 1)):
        return bool(value)
    raise InputError(f"{what} is {value!r}; expected True or False", "", "type")


def is_one_of(value: Any, words: Container[str]) -> bool:
    """Whether value is one of these words; an array, which compares by its items, is none."""
    return isinstance(value, str) and value in words


def items_of(values: Any, what: str) -> Iterator[Any]:
    """The items of values, one after the other; what says what they should be."""
    try:
        return iter(values)
    except TypeError:
        raise InputError(f"found {type(values).__name__}, expected a list of {what}", "", "type") from None


def thread_count(threads: Any) -> int:
    """As C takes it: 0 where nothing was said."""
    if threads is None:
        return 0
    count = whole(threads, "threads")
    if not 1 <= count <= 256:
        raise InputError(f"threads is {threads}; expected 1 to 256", "", "argument", threads)
    return count


def bytes_of(text: Any) -> bytes:
    """A document as UTF-8."""
    if isinstance(text, (bytes, bytearray)):
        return bytes(text)
    if not isinstance(text, str):
        raise InputError(f"found {type(text).__name__}, expected a text", "", "type")
    try:
        return text.encode()
    except UnicodeEncodeError as error:
        raise InputError(f"a text with a character that UTF-8 does not have, at {error.start}", "", "text") from None


def path_of(path: Any) -> str:
    """A path as a text, of which there may be a file."""
    try:
        text = os.fsdecode(path)
    except TypeError:
        raise InputError(f"found {type(path).__name__}, expected a path", "", "type") from None
    encoded(text)
    return text


def text_of(function: Any, *arguments: Any) -> bytes:
    """The text that function(*arguments, &text, &length, [&error]) writes; freed here."""
    error, pointer, length = c.ErrorStruct(), c_void_p(), c_size_t()
    extra = [byref(error)] if len(function.argtypes) == len(arguments) + 3 else []
    status = function(*arguments, byref(pointer), byref(length), *extra)
    if status != c.OK:
        raise_for(status, error if extra else None)
    try:
        return ctypes.string_at(pointer, length.value)
    finally:
        library.taut_text_free(pointer)


class Referable:
    """What weak references may be to: keys of a WeakKeyDictionary, as objects are hashable."""

    __slots__ = ("__weakref__",)


def expect(value: Any, *kinds: type) -> None:
    """Refuses what is none of these."""
    if not isinstance(value, kinds):
        names = " or ".join(kind.__name__.lower() for kind in kinds)
        raise InputError(f"found {type(value).__name__}, expected a {names}", "", "type")


def encoded(text: str | None) -> c_char_p | bytes | None:
    """A text for C; one with a NUL inside would be cut there, and is refused."""
    if text is None:
        return None
    if not isinstance(text, str):
        raise InputError(f"found {type(text).__name__}, expected a text", "", "type")
    if "\0" in text:
        raise InputError("a text with a NUL in it", "", "text")
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError as error:
        raise InputError(f"a text with a character that UTF-8 does not have, at {error.start}", "", "text") from None
