"""Many problems: on the threads of this machine, or wherever an executor or a Dask client runs."""
from __future__ import annotations

import concurrent.futures
import hashlib
import json
import math
import os
import re
import threading
import time
from collections import deque
from typing import Any, BinaryIO, Iterable, Iterator, Mapping, Sequence

from ._handle import whole
from .errors import CheckFailed, Error, FileError, InputError, NoSolution, NotConverged
from .making import Document, make, plain, with_version
from .model import Model

_EXIT = {InputError: 3, NoSolution: 4, NotConverged: 1, CheckFailed: 1, FileError: 5}
_AHEAD = 4  # tasks handed out for each worker before the first result is waited for
_TASK = 1.0  # seconds that a task of a client should take: Dask spends some twenty milliseconds on each, however small it is
_SHARE, _MOST = 8, 256  # problems in a task: no more than this part of what a worker has done so far, so that all end together
_PATIENCE = 0.25  # seconds that the next problems are waited for before results are looked after
_ERROR = re.compile(rb'\s*\{\s*"error"')  # how a line begins that is no model


class _Stopped(Exception):
    """Nobody waits for this result any more."""


def _one(text: str, stop: threading.Event | None = None) -> bytes:
    """A model as its document in one line, or an error as one; runs anywhere. stop: of threads of this process."""
    def look(done: float, what: str) -> None:
        if stop is not None and stop.is_set():
            raise _Stopped
    try:
        model = make(text, progress=None if stop is None else look)
        return re.sub(rb"\n *", b" ", model._bytes().strip())  # no text in JSON holds an end of line
    except Error as error:
        return _line_of(error)
    except MemoryError:
        return _line_of(Error("memory ran out", "", "memory"))


def _some(texts: Sequence[str]) -> tuple[float, list[bytes]]:
    """The seconds taken, and the results of the first of these problems: all, unless they take far longer than a task should."""
    begin = time.monotonic()
    lines: list[bytes] = []
    while len(lines) < len(texts) and (not lines or time.monotonic() - begin < 2 * _TASK):
        lines.append(_one(texts[len(lines)]))
    return time.monotonic() - begin, lines


def _workers(client: Any) -> int:
    """How many tasks run at once: of a Dask client on all its machines, as far as an executor tells."""
    if hasattr(client, "nthreads"):
        return sum(client.nthreads().values()) or 1
    return int(getattr(client, "_max_workers", None) or os.cpu_count() or 1)


def _json(value: Any) -> str:
    """As the program writes it: the fewest digits from 15 on that are read as the number, null for what JSON has no number for."""
    if isinstance(value, (int, float)):
        texts = (format(value, f".{digits}g") for digits in (15, 16, 17))
        return next(text for text in texts if float(text) == value) if math.isfinite(value) else "null"
    return json.dumps(value, ensure_ascii=False)


def _line_of(error: Error) -> bytes:
    members = {"exit": _EXIT.get(type(error), 6), "reason": error.reason, "where": error.where, "message": error.message,
               "found": error.found, "expected": error.expected}
    text = ", ".join(f'"{name}": {_json(value)}' for name, value in members.items())
    return f'{{ "error": {{ {text} }} }}'.encode("utf-8", "replace")


def _result(line: bytes) -> Model | Error:
    """What a line of results holds."""
    if not _ERROR.match(line):
        return Model.from_json(line)
    error = json.loads(line)["error"]
    kind = {3: InputError, 2: InputError, 4: NoSolution, 1: NotConverged, 5: FileError}.get(error["exit"], Error)
    return kind(error["message"], error["where"], error["reason"], error["found"], error["expected"])


def _locked(path: str) -> BinaryIO:
    """A file of results, this sweep's alone until it is closed."""
    try:
        file = open(path, "a+b")
    except OSError as error:
        raise FileError(f"cannot write {path}: {error.strerror}", path, "file") from None
    try:
        import fcntl
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except ImportError:  # Windows: nothing keeps two sweeps apart
        pass
    except OSError:
        file.close()
        raise FileError(f"{path}: another sweep is writing it", path, "file") from None
    return file


def _done(file: BinaryIO, path: str) -> list[bytes]:
    """The whole lines that a file of results has; a last one that is broken is cut off. Any other file is left as it is."""
    file.seek(0)
    text = file.read()
    whole = text.rfind(b"\n") + 1
    lines, rest = text[:whole].splitlines(), text[whole:]
    wrong = next((i for i, line in enumerate(lines) if not _is_result(line)), None if rest[:1] in (b"", b"{") else len(lines))
    if wrong is not None:
        raise FileError(f"{path}: line {wrong + 1} is no result of a sweep; give another file, or remove it", f"{path}:{wrong + 1}", "file")
    file.truncate(whole)
    file.seek(whole)
    return lines


def _is_result(line: bytes) -> bool:
    try:
        value = json.loads(line)
    except ValueError:
        return False
    return isinstance(value, dict) and ("taut" in value or "error" in value)


class _Sums:
    """Which problem each line of results is of: a checksum a line, in a file beside it that ends in .sums."""

    def __init__(self, path: str, lines: int) -> None:
        self._file = open(path + ".sums", "a+b")
        self._file.seek(0)
        text = self._file.read().splitlines(keepends=True)
        self._known = [line.strip() for line in text[:lines] if line.endswith(b"\n")]
        self._file.truncate(sum(len(line) for line in text[:len(self._known)]))
        self._path = path

    def check(self, index: int, text: str) -> None:
        """The problem of a line that is there already; unknown where the file beside it is not (as `taut make --lines` leaves it)."""
        if index < len(self._known) and self._known[index] not in (b"-", _sum(text)):
            raise InputError(f"{self._path}: line {index + 1} is of another problem; give another file for this sweep, or remove it",
                             f"{self._path}:{index + 1}", "other-sweep")

    def add(self, index: int, text: str) -> None:
        """Written before its result: a line too many does no harm."""
        while len(self._known) < index:  # of results from elsewhere
            self._known.append(b"-")
            self._file.write(b"-\n")
        if len(self._known) == index:
            self._known.append(_sum(text))
            self._file.write(self._known[-1] + b"\n")
            self._file.flush()

    def close(self) -> None:
        """Ends the file."""
        self._file.close()


def _sum(text: str) -> bytes:
    data = text.encode("utf-8", "surrogatepass")
    if text.lstrip()[:1] not in ("{", "["):  # a path
        try:
            with open(text, "rb") as file:
                data = file.read()
        except OSError:
            pass
    return hashlib.sha256(data).hexdigest().encode()


def map(problems: Iterable[Document], client: Any = None, threads: int | None = None,
        out: str | os.PathLike[str] | None = None) -> Iterator[tuple[int, Model | Error]]:
    """Pairs (index, model or error) as they end; an error is a result, it stops nothing.

    problems   documents, one after the other; an iterator is read no faster than results come
    client     a Dask `distributed.Client` or a `concurrent.futures` executor, which get quick problems many in a task, of about a second;
               None: threads of this process
    threads    how many here; None: as many as processors
    out        a JSON Lines file, a line for each problem in order; what it holds already is not made again. Which problems these
               were is in a file of its name with .sums: others are an InputError, reason "other-sweep". A file that holds anything
               else, or that another sweep is writing, is a FileError, and stays as it is
    """
    if threads is not None and whole(threads, "threads") < 1:
        raise InputError(f"threads is {threads}; expected 1 or more", "", "argument", threads)
    if client is not None and not hasattr(client, "submit"):
        raise InputError(f"client is {client!r}; expected a Dask client or an executor of concurrent.futures", "", "type")
    if isinstance(problems, Mapping) or not hasattr(problems, "__iter__"):
        raise InputError(f"found {type(problems).__name__}, expected a list of documents", "", "type")
    return _map(problems, client, threads, None if out is None else os.fspath(out))


class _Tasks:
    """Problems handed out to threads of this process, one by one, or to a client, so many in a task that it takes its time."""

    def __init__(self, client: Any, threads: int | None) -> None:
        self._workers = _workers(client) if client is not None else threads or os.cpu_count() or 1
        self._own = None if client is not None else concurrent.futures.ThreadPoolExecutor(self._workers)
        self._executor: Any = self._own or (client.get_executor(pure=False) if hasattr(client, "get_executor") else client)
        self._stop = threading.Event()
        self._size, self._done = 1, 0  # problems in the next task; with results
        self._next: deque[tuple[int, str]] = deque()  # not handed out yet
        self._running: dict[Any, list[tuple[int, str]]] = {}

    def __len__(self) -> int:
        """How many problems wait for their results."""
        return len(self._next) + sum(len(task) for task in self._running.values())

    @property
    def full(self) -> bool:
        """Whether all workers have enough to do."""
        return len(self._running) >= _AHEAD * self._workers

    def add(self, index: int, text: str) -> None:
        """One more problem."""
        self._next.append((index, text))
        if len(self._next) >= self._size:
            self._submit()

    def _submit(self) -> None:
        task = [self._next.popleft() for _ in range(min(self._size, len(self._next)))]
        texts = [text for _, text in task]
        future = self._executor.submit(_one, texts[0], self._stop) if self._own is not None else self._executor.submit(_some, texts)
        self._running[future] = task

    def results(self, wait: bool) -> Iterator[tuple[int, bytes]]:
        """Those that have come; wait: for one at least."""
        while self._next and not self.full:  # what did not fill a task
            self._submit()
        done = concurrent.futures.wait(self._running, None if wait else 0, concurrent.futures.FIRST_COMPLETED).done
        for future in done:
            task = self._running.pop(future)
            if self._own is not None:
                yield task[0][0], future.result()
                continue
            seconds, lines = future.result()
            self._next.extendleft(reversed(task[len(lines):]))
            self._done += len(lines)
            in_time = int(_TASK * len(lines) / max(seconds, 1e-6))
            self._size = max(1, min(_MOST, in_time, self._done // (_SHARE * self._workers)))
            for (index, _), line in zip(task, lines):
                yield index, line

    def close(self) -> None:
        """Nobody waits any more."""
        self._stop.set()
        for future in self._running:
            future.cancel()
        if self._own is not None:
            self._own.shutdown(wait=True)


class _Lines:
    """The file of results, if any, in the order of the problems, and beside it which they are of."""

    def __init__(self, path: str | None) -> None:
        self._file = None if path is None else _locked(path)
        self._sums: _Sums | None = None
        self._early: dict[int, bytes] = {}  # of problems behind one that is still worked on
        try:
            self.finished = [] if self._file is None or path is None else _done(self._file, path)
            self._sums = None if path is None else _Sums(path, len(self.finished))
        except BaseException:
            self.close()
            raise
        self._written = len(self.finished)

    def check(self, index: int, text: str) -> None:
        """The problem of a line that is there already."""
        if self._sums is not None:
            self._sums.check(index, text)

    def begin(self, index: int, text: str) -> None:
        """A problem is handed out."""
        if self._sums is not None:
            self._sums.add(index, text)

    def add(self, index: int, line: bytes) -> None:
        """A result has come."""
        if self._file is None:
            return
        self._early[index] = line
        while self._written in self._early:
            self._file.write(self._early.pop(self._written) + b"\n")
            self._written += 1
        self._file.flush()

    def close(self) -> None:
        """Ends the files."""
        for file in (self._sums, self._file):
            if file is not None:
                file.close()


_END = object()


def _map(problems: Iterable[Document], client: Any, threads: int | None, out: str | None) -> Iterator[tuple[int, Model | Error]]:
    lines = _Lines(out)
    tasks: _Tasks | None = None
    try:
        texts = enumerate(problems)
        for line in lines.finished:
            index, document = next(texts, (-1, _END))
            if document is _END:
                return
            lines.check(index, _text_or_error(document)[0])
            yield index, _result(line)
        tasks = _Tasks(client, threads)
        ended = False
        while tasks or not ended:
            begin = time.monotonic()
            while not ended and not tasks.full and time.monotonic() - begin < _PATIENCE:
                index, document = next(texts, (-1, _END))
                if document is _END:
                    ended = True
                    break
                text, error = _text_or_error(document)
                lines.begin(index, text)
                if error is not None:  # what no document can hold
                    line = _line_of(error)
                    lines.add(index, line)
                    yield index, _result(line)
                else:
                    tasks.add(index, text)
            found: list[tuple[int, bytes]] = []
            for pair in tasks.results(wait=ended or tasks.full):
                lines.add(*pair)  # all of them, before anybody may break off
                found.append(pair)
            for index, line in found:
                yield index, _result(line)
    finally:
        if tasks is not None:
            tasks.close()
        lines.close()


def _text_or_error(document: Any) -> tuple[str, Error | None]:
    """A document as a text that travels; of one that is none its error, and a text that is its own."""
    try:
        return _text(document), None
    except Error as error:
        return repr(error.args), error


def _text(document: Any) -> str:
    """A document as a text that travels."""
    if isinstance(document, (str, os.PathLike)):
        text = os.fspath(document)
        return text if text.lstrip()[:1] in ("{", "[") else os.path.abspath(text)
    if not isinstance(document, (Mapping, Sequence)):
        raise InputError(f"found {type(document).__name__}, expected a document", "", "type")
    return json.dumps(with_version(plain(document)))


__all__ = ["map"]
