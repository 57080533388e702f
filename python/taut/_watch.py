"""Progress and Ctrl-C of calls that take long."""
from __future__ import annotations

import importlib
import signal
import sys
import threading
from typing import Any, Callable

from . import _library as c
from .errors import InputError

Progress = Callable[[float, str], object]

# What `signal` makes enumerations around, which cost as much as a small construction.
_signal: Any = importlib.import_module("_signal" if "_signal" in sys.builtin_module_names else "signal")
_SIGINT = int(signal.SIGINT)


class Watch:
    """Progress and Ctrl-C for a call of C. While it is entered SIGINT is noted (in the main thread) and stops the call; the
    handler that was there is called afterwards."""

    def __init__(self, progress: Progress | None = None) -> None:
        if progress is not None and not callable(progress):
            raise InputError(f"progress is {progress!r}; expected a function", "", "type")
        self._progress = progress
        self._raised: BaseException | None = None
        self._signals: list[Any] = []
        self._previous: Any = None
        self.monitor = c.MonitorStruct()

    def __enter__(self) -> Watch:
        if threading.current_thread() is threading.main_thread():
            self._previous = _signal.getsignal(_SIGINT)
            if callable(self._previous):
                _signal.signal(_SIGINT, self._noted)
        if callable(self._previous) or self._progress is not None:
            self.monitor.progress = c.PROGRESS(self._told)
        return self

    def _noted(self, number: int, frame: Any) -> None:
        self._signals.append((number, frame))

    def _told(self, _: Any, done: float, what: bytes) -> int:
        if self._progress is not None and self._raised is None and not self._signals:
            try:
                self._progress(done, what.decode("utf-8", "replace"))
            except BaseException as error:  # carried over C, and raised again behind it
                self._raised = error
        return int(bool(self._signals) or self._raised is not None)

    def begun(self, what: str) -> Watch:
        """Itself, told of the begin of work which C may not tell of, before any of it is done."""
        self.tell(0.0, what)
        return self

    def tell(self, done: float, what: str) -> None:
        """Of a call that C does not tell of: what progress raises is raised here."""
        if self._progress is not None:
            self._progress(done, what)

    def __exit__(self, *_: Any) -> None:
        if callable(self._previous):
            _signal.signal(_SIGINT, self._previous)
        for number, frame in self._signals[:1]:
            self._previous(number, frame)
        if self._raised is not None:
            raise self._raised


__all__ = ["Progress", "Watch"]
