"""What goes wrong, as exceptions with data.

    Error
      InputError        a document or an argument is not what it should be (a ValueError too)
      NoSolution        what is asked for does not exist
      NotConverged      an iteration stopped short of its tolerance
      CheckFailed       a claim does not hold, and `strict=True` was given: `.model` is there
      FileError         a file could not be read or written (an OSError too)

Memory that runs out is MemoryError; Ctrl-C is KeyboardInterrupt.
"""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from . import _library as c
from ._reasons import REMEDIES

if TYPE_CHECKING:
    from .model import Model


def _number(value: float) -> float | None:
    return None if math.isnan(value) else value


class Error(Exception):
    """A message in one sentence, and what it is made of.

    where      a JSON pointer such as "/points/1/2", or file:line:column, or ""
    reason     a word such as "range"; docs/errors.md has them all
    found      the number that failed, or None (of a NaN too)
    expected   what should have been there: a number it had to stay within, or words, or None
    """

    def __init__(self, message: str, where: str = "", reason: str = "", found: float | None = None,
                 expected: float | str | None = None) -> None:
        super().__init__(message)
        self.message, self.where, self.reason, self.expected = message, where, reason, expected
        self.found = None if found is None else _number(found)

    @property
    def remedy(self) -> str:
        """What to change, as `taut help REASON` says it; "" where the word is none of the library's."""
        return REMEDIES.get(self.reason, "")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.where, self.reason, self.found, self.expected), self.__dict__


class InputError(Error, ValueError):
    """A document or an argument is not what it should be."""


class NoSolution(Error):
    """Well formed, but what is asked for does not exist."""


class NotConverged(Error):
    """An iteration stopped short of its tolerance."""


class FileError(Error, OSError):
    """A file could not be read or written."""

    def __str__(self) -> str:
        return self.message


class CheckFailed(Error):
    """A claim does not hold; `.model` is the model, its certificate says which."""

    model: Model | None = None


_KINDS: dict[int, type[Error]] = {c.BAD_ARGUMENT: InputError, c.BAD_INPUT: InputError, c.NO_SOLUTION: NoSolution,
                                  c.NOT_CONVERGED: NotConverged, c.CHECK_FAILED: CheckFailed, c.IO: FileError}


def raise_for(status: int, error: c.ErrorStruct | None = None) -> None:
    """Raises what a status other than OK means."""
    if status == c.NO_MEMORY:
        raise MemoryError("taut: memory ran out")
    if error is None or not error.message:
        raise _KINDS.get(status, Error)(c.library.taut_status_text(status).decode())
    if status == c.INTERRUPTED:
        raise KeyboardInterrupt
    expected: float | str | None = error.expected.decode("utf-8", "replace") or _number(error.limit)
    raise _KINDS.get(status, Error)(error.message.decode("utf-8", "replace"), error.where.decode("utf-8", "replace"),
                                    error.reason.decode(), _number(error.found), expected)
