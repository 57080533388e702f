"""Many problems: on the threads of this machine, or wherever an executor or a Dask client runs."""
from __future__ import annotations

import concurrent.futures
import hashlib
import json
import os
import re
import threading
from typing import Any, BinaryIO, Iterable, Iterator, Mapping, Sequence

from ._handle import whole
from .errors import CheckFailed, Error, FileError, InputError, NoSolution, NotConverged
from .making import Document, make, plain, with_version
from .model import Model

_EXIT = {InputError: 3, NoSolution: 4, NotConverged: 1, CheckFailed: 1, FileError: 5}
_AHEAD = 4  # problems handed out for each worker before the first result is waited for


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


def _workers(client: Any) -> int:
    """How many tasks run at once: of a Dask client on all its machines, as far as an executor tells."""
    if hasattr(client, "nthreads"):
        return sum(client.nthreads().values()) or 1
    return int(getattr(client, "_max_workers", None) or os.cpu_count() or 1)


def _line_of(error: Error) -> bytes:
    return json.dumps({"error": {"exit": _EXIT.get(type(error), 6), "reason": error.reason, "where": error.where,
                                 "message": error.message, "found": error.found, "expected": error.expected}}).encode()


def _result(line: bytes) -> Model | Error:
    """What a line of results holds."""
    error = json.loads(line).get("error")
    if error is None:
        return Model.from_json(line)
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
    client     a Dask `distributed.Client` or a `concurrent.futures` executor; None: threads of this process
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


_END = object()


def _map(problems: Iterable[Document], client: Any, threads: int | None, out: str | None) -> Iterator[tuple[int, Model | Error]]:
    workers = _workers(client) if client is not None else threads or os.cpu_count() or 1
    file = None if out is None else _locked(out)
    own: concurrent.futures.ThreadPoolExecutor | None = None
    sums: _Sums | None = None
    stop = threading.Event()
    waiting: dict[Any, int] = {}
    lines: dict[int, bytes] = {}
    try:
        finished = [] if file is None or out is None else _done(file, out)
        sums = None if out is None else _Sums(out, len(finished))
        own = None if client is not None else concurrent.futures.ThreadPoolExecutor(workers)
        executor: Any = own if client is None else client.get_executor(pure=False) if hasattr(client, "get_executor") else client
        written = len(finished)
        texts = enumerate(problems)
        ended = False
        for line in finished:
            index, document = next(texts, (-1, _END))
            if document is _END:
                ended = True
                break
            if sums is not None:
                sums.check(index, _text_or_error(document)[0])
            yield index, _result(line)
        while waiting or not ended:
            while not ended and len(waiting) < _AHEAD * workers:
                index, document = next(texts, (-1, _END))
                if document is _END:
                    ended = True
                    break
                text, error = _text_or_error(document)
                if sums is not None:
                    sums.add(index, text)
                if error is not None:  # what no document can hold
                    done: concurrent.futures.Future[bytes] = concurrent.futures.Future()
                    done.set_result(_line_of(error))
                    waiting[done] = index
                else:
                    waiting[executor.submit(_one, text, stop) if own is not None else executor.submit(_one, text)] = index
            if not waiting:
                break
            for future in concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED).done:
                index = waiting.pop(future)
                line = future.result()
                if file is not None:
                    lines[index] = line
                    while written in lines:
                        file.write(lines.pop(written) + b"\n")
                        written += 1
                    file.flush()
                yield index, _result(line)
    finally:
        stop.set()
        if own is not None:
            own.shutdown(wait=True, cancel_futures=True)
        if sums is not None:
            sums.close()
        if file is not None:
            file.close()


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
