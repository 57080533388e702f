"""Many problems: on the threads of this machine, or wherever an executor or a Dask client runs."""
from __future__ import annotations

import concurrent.futures
import contextlib
import hashlib
import json
import math
import os
import re
import threading
import time
from collections import deque
from typing import Any, BinaryIO, Iterable, Iterator, Mapping, Sequence, Sized

from ._handle import items_of, path_of, truth, whole
from ._watch import Progress, Watch
from .errors import CheckFailed, Error, FileError, InputError, NoSolution, NotConverged
from .making import Document, make, text_of_document
from .model import Model, failed

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
        if isinstance(model, list):
            raise InputError(f"found an array of {len(model)}, expected an object", "", "type", expected="an object")
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
    return int(getattr(client, "_max_workers", None) or _processors())


def _processors() -> int:
    """How many this process may use: on a cluster often fewer than the machine has."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


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


@contextlib.contextmanager
def _writing(path: str) -> Iterator[None]:
    """Around what writes a file and those beside it: what fails there is an error of this package."""
    try:
        yield
    except FileError:
        raise
    except OSError as error:
        raise FileError(f"cannot write {path}: {error.strerror}", path, "file") from None


def _opened(path: str) -> BinaryIO:
    """A file, read from its begin and written at its end. A device or a pipe has no end to go on at."""
    if os.path.exists(path) and not os.path.isfile(path):
        raise FileError(f"cannot write {path}: it is no file that a sweep can go on with", path, "file")
    with _writing(path):
        file = open(path, "a+b")
        file.seek(0)
    return file


def _locked(path: str) -> BinaryIO:
    """A file of results, this sweep's alone until it is closed."""
    file = _opened(path)
    try:
        import fcntl
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except ImportError:  # Windows: nothing keeps two sweeps apart
        pass
    except OSError:
        file.close()
        raise FileError(f"{path}: another sweep is writing it", path, "file") from None
    return file


def _done(file: BinaryIO, path: str) -> int:
    """How many whole lines a file of results has; a last one that is broken is cut off. Any other file is left as it is."""
    count = size = 0
    for line in file:
        if not (_is_result(line) if line.endswith(b"\n") else line.startswith(b"{")):
            raise FileError(f"{path}: line {count + 1} is no result of a sweep; give another file, or remove it", f"{path}:{count + 1}", "file")
        if line.endswith(b"\n"):
            count, size = count + 1, size + len(line)
    file.truncate(size)
    file.seek(0)
    return count


def _is_result(line: bytes) -> bool:
    try:
        value = json.loads(line)
    except ValueError:
        return False
    return isinstance(value, dict) and ("taut" in value or "error" in value)


class _Sums:
    """Which problem each line of results is of: a checksum a line, in a file beside it that ends in .sums."""

    def __init__(self, path: str, lines: int) -> None:
        self._file = _opened(path + ".sums")
        self._count = size = 0
        for line in self._file:
            if self._count == lines or not line.endswith(b"\n"):
                break
            self._count, size = self._count + 1, size + len(line)
        self._file.truncate(size)
        self._file.seek(0)
        self._path = path

    def check(self, index: int, text: str) -> None:
        """The problem of a line that is there already, one after the other; unknown where the file beside it is not (as `taut make --lines`
        leaves it)."""
        if index < self._count and self._file.readline().strip() not in (b"-", _sum(text)):
            raise InputError(f"{self._path}: line {index + 1} is of another problem; give another file for this sweep, or remove it",
                             f"{self._path}:{index + 1}", "other-sweep")

    def add(self, index: int, total: bytes) -> None:
        """Written before its result: a line too many does no harm."""
        while self._count < index:  # of results from elsewhere
            self._file.write(b"-\n")
            self._count += 1
        if self._count == index:
            self._file.write(total + b"\n")
            self._count += 1
            self._file.flush()

    def close(self) -> None:
        """Ends the file."""
        self._file.close()


class _Early:
    """Results whose turn has not come, because one before them is still worked on: in a file beside the results that ends in .early, each
    with its number and the checksum of its problem, so that they neither fill the memory nor are lost with the process."""

    def __init__(self, path: str, finished: int | None) -> None:
        """finished: how many results are in their places; None: those here are of a file that is gone."""
        self._path = path + ".early"
        self._file: BinaryIO | None = None
        self._at: dict[int, tuple[int, int]] = {}  # where each result is, and how long
        self._sums: dict[int, bytes] = {}  # of those from before whose problem has not come yet
        if os.path.exists(self._path):
            self._file = _opened(self._path)
            size = self._read(finished)
            self._file.truncate(size if self._at else 0)

    def _read(self, finished: int | None) -> int:
        assert self._file is not None
        size = 0
        for line in self._file:
            number, _, rest = line.partition(b" ")
            total, _, result = rest.partition(b" ")
            if not line.endswith(b"\n"):
                break
            if not (number.isdigit() and _is_result(result)):
                raise FileError(f"{self._path} is no file of results that came early; remove it", self._path, "file")
            if finished is not None and int(number) >= finished:
                self._at[int(number)], self._sums[int(number)] = (size + len(line) - len(result), len(result) - 1), total
            size += len(line)
        return size

    def __contains__(self, index: int) -> bool:
        """Whether its result is here, and of this sweep."""
        return index in self._at and index not in self._sums

    def there(self, index: int, total: bytes) -> bytes | None:
        """The result that is here from before, if it is of this problem."""
        found = self._sums.pop(index, None)
        if found == total:
            return self._line(index)
        self._at.pop(index, None)
        return None

    def add(self, index: int, total: bytes, line: bytes) -> None:
        """A result before its turn."""
        if self._file is None:
            self._file = _opened(self._path)
        head = b"%d %s " % (index, total)
        self._at[index] = (self._file.seek(0, os.SEEK_END) + len(head), len(line))
        self._file.write(head + line + b"\n")
        self._file.flush()

    def _line(self, index: int) -> bytes:
        assert self._file is not None
        place, length = self._at[index]
        self._file.seek(place)
        return self._file.read(length)

    def take(self, index: int) -> bytes:
        """A result whose turn has come."""
        line = self._line(index)
        del self._at[index]
        return line

    def empty(self) -> None:
        """All that was here is among the results."""
        if not self._at and self._file is not None:
            self._file.truncate(0)

    def close(self) -> None:
        """Ends the file, which goes where nothing waits in it."""
        if self._file is not None:
            self._file.close()
            if not self._at:
                os.remove(self._path)


def _sum(text: str) -> bytes:
    data = text.encode("utf-8", "surrogatepass")
    if text.lstrip()[:1] not in ("{", "["):  # a path
        try:
            with open(text, "rb") as file:
                data = file.read()
        except (OSError, ValueError):  # a name that no file has
            pass
    return hashlib.sha256(data).hexdigest().encode()


def map(problems: Iterable[Document], client: Any = None, threads: int | None = None, out: str | os.PathLike[str] | None = None,
        progress: Progress | None = None, strict: bool = False) -> Iterator[tuple[int, Model | Error]]:
    """Pairs (index, model or error) as they end; an error is a result, it stops nothing.

    problems   documents, one after the other, as taut.make takes them, or an open file with one a line, blank ones passed over; an
               iterator is read no faster than results come
    client     a Dask `distributed.Client` or a `concurrent.futures` executor, which get quick problems many in a task, of about a second;
               None: threads of this process
    threads    how many here; None: as many as processors that this process may use
    out        a JSON Lines file, a line for each problem in order; what it holds already is not made again. Which problems these
               were is in a file of its name with .sums: others are an InputError, reason "other-sweep". Results that come before
               their turn wait in one with .early, also for the next start. A file that holds anything else, or that another sweep is
               writing, is a FileError, and stays as it is
    progress   called as progress(done, what) with each result, done the part of problems that are finished, NaN where they have no
               length; what it raises ends the sweep, and what is on disk stays
    strict     the result of a model of which a claim does not hold is CheckFailed, whose `model` is the model; its line is the same
    """
    if threads is not None and whole(threads, "threads") < 1:
        raise InputError(f"threads is {threads}; expected 1 or more", "", "argument", threads)
    if client is not None and not hasattr(client, "submit"):
        raise InputError(f"client is {client!r}; expected a Dask client or an executor of concurrent.futures", "", "type")
    if isinstance(problems, (str, bytes, bytearray, os.PathLike)):
        raise InputError(f"found {type(problems).__name__}, expected a list of documents; of a file of lines, open(path)", "", "type")
    if isinstance(problems, Mapping):
        raise InputError(f"found {type(problems).__name__}, expected a list of documents", "", "type")
    items_of(problems, "documents")  # refuses what has none
    Watch(progress)  # refuses what is no function
    results = _map(problems, client, threads, None if out is None else path_of(out))
    if truth(strict, "strict"):
        results = _strictly(results)
    return results if progress is None else _told(results, len(problems) if isinstance(problems, Sized) else 0, progress)


def _strictly(results: Iterator[tuple[int, Model | Error]]) -> Iterator[tuple[int, Model | Error]]:
    """The same, but CheckFailed for models of which a claim does not hold."""
    with contextlib.closing(results):  # type: ignore[type-var]
        for index, result in results:
            certificate = result.certificate if isinstance(result, Model) else None
            yield index, failed(result, certificate) if isinstance(result, Model) and certificate and certificate.holds is False else result


def _told(results: Iterator[tuple[int, Model | Error]], total: int, progress: Progress) -> Iterator[tuple[int, Model | Error]]:
    """The same, told of."""
    with contextlib.closing(results):  # type: ignore[type-var]
        for count, pair in enumerate(results, 1):
            progress(count / total if total > 0 else math.nan, "sweep")
            yield pair


class _Tasks:
    """Problems handed out to threads of this process, one by one, or to a client, so many in a task that it takes its time."""

    def __init__(self, client: Any, threads: int | None) -> None:
        self._workers = _workers(client) if client is not None else threads or _processors()
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
    """The file of results, if any, in the order of the problems, and beside it which they are of, and those that came too early."""

    def __init__(self, path: str | None) -> None:
        self._path = path or ""
        is_new = path is not None and not os.path.exists(path)
        self._file = None if path is None else _locked(path)
        self._sums: _Sums | None = None
        self._early: _Early | None = None
        self._totals: dict[int, bytes] = {}  # the checksums of the problems that are worked on
        try:
            self.finished = 0 if self._file is None or path is None else _done(self._file, path)
            if path is not None:
                self._sums = _Sums(path, self.finished)
                self._early = _Early(path, None if is_new else self.finished)
        except BaseException:
            self.close()
            raise
        self._written = self.finished

    def there(self, index: int, text: str) -> bytes:
        """The result that the next line holds already."""
        assert self._sums is not None and self._file is not None
        self._sums.check(index, text)
        return self._file.readline()

    def begin(self, index: int, text: str) -> bytes | None:
        """A problem is to be handed out, unless its result is there: it came early, and the sweep ended before its turn."""
        if self._sums is None or self._early is None:
            return None
        total = _sum(text)
        with _writing(self._path):
            self._sums.add(index, total)
            line = self._early.there(index, total)
            if line is None:
                self._totals[index] = total
            else:
                self._write()
        return line

    def add(self, index: int, line: bytes) -> None:
        """A result has come."""
        if self._file is None or self._early is None:
            return
        total = self._totals.pop(index)
        with _writing(self._path):
            if index > self._written:
                self._early.add(index, total, line)
                return
            self._file.write(line + b"\n")
            self._written += 1
            self._write()

    def _write(self) -> None:
        """Those whose turn has come."""
        assert self._file is not None and self._early is not None
        while self._written in self._early:
            self._file.write(self._early.take(self._written) + b"\n")
            self._written += 1
        self._file.flush()
        self._early.empty()

    def close(self) -> None:
        """Ends the files."""
        with _writing(self._path), contextlib.ExitStack() as stack:  # all of them, whatever fails
            for file in (self._file, self._early, self._sums):
                if file is not None:
                    stack.callback(file.close)


_END = object()


def _map(problems: Iterable[Document], client: Any, threads: int | None, out: str | None) -> Iterator[tuple[int, Model | Error]]:
    lines = _Lines(out)
    tasks: _Tasks | None = None
    try:
        texts = enumerate(one for one in problems if not _is_blank_line(one))
        for _ in range(lines.finished):
            index, document = next(texts, (-1, _END))
            if document is _END:
                return
            yield index, _result(lines.there(index, _text_or_error(document)[0]))
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
                line = lines.begin(index, text)
                if line is not None:
                    yield index, _result(line)
                elif error is not None:  # what no document can hold
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


def _is_blank_line(document: Any) -> bool:
    """Of a file: it is passed over, as the program does."""
    return isinstance(document, (str, bytes)) and document[-1:] in ("\n", b"\n") and not document.strip()


def _text_or_error(document: Any) -> tuple[str, Error | None]:
    """A document as a text that travels; of one that is none its error, and a text that is its own."""
    try:
        return _text(document), None
    except Error as error:
        return repr(error.args), error


def _text(document: Any) -> str:
    """A document as a text that travels."""
    if isinstance(document, (bytes, bytearray)):
        try:
            document = document.decode()
        except UnicodeDecodeError as error:
            raise InputError(f"a text that is not UTF-8, at {error.start}", "", "text") from None
    if isinstance(document, (str, os.PathLike)):
        text = os.fspath(document)
        return text if text.lstrip()[:1] in ("{", "[") else os.path.abspath(text)
    if not isinstance(document, (Mapping, Sequence)):
        raise InputError(f"found {type(document).__name__}, expected a document", "", "type")
    return text_of_document(document)


__all__ = ["map"]
