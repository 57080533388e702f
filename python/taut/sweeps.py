"""Many problems: on the threads of this machine, or wherever an executor or a Dask client runs."""
from __future__ import annotations

import concurrent.futures
import json
import os
import re
from typing import Any, Iterable, Iterator

from .errors import CheckFailed, Error, FileError, InputError, NoSolution, NotConverged
from .making import Document, make, plain, with_version
from .model import Model

_EXIT = {InputError: 3, NoSolution: 4, NotConverged: 1, CheckFailed: 1, FileError: 5}
_AHEAD = 4  # problems handed out for each worker before the first result is waited for


def _one(text: str) -> bytes:
    """A model as its document in one line, or an error as one; runs anywhere."""
    try:
        return re.sub(rb"\n *", b" ", make(text)._bytes().strip())  # no text in JSON holds an end of line
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


def _done(out: str) -> list[bytes]:
    """The whole lines that a file of results has; a last one that is broken is cut off."""
    if not os.path.exists(out):
        return []
    with open(out, "r+b") as file:
        text = file.read()
        whole = text.rfind(b"\n") + 1
        lines = text[:whole].splitlines()
        while lines and not _is_json(lines[-1]):
            whole -= len(lines.pop()) + 1
        file.truncate(whole)
    return lines


def _is_json(line: bytes) -> bool:
    try:
        return isinstance(json.loads(line), dict)
    except ValueError:
        return False


def map(problems: Iterable[Document], client: Any = None, threads: int | None = None,
        out: str | os.PathLike[str] | None = None) -> Iterator[tuple[int, Model | Error]]:
    """Pairs (index, model or error) as they end; an error is a result, it stops nothing.

    problems   documents, one after the other; an iterator is read no faster than results come
    client     a Dask `distributed.Client` or a `concurrent.futures` executor; None: threads of this process
    threads    how many here; None: as many as processors
    out        a JSON Lines file, a line for each problem in order; what it holds already is not made again
    """
    workers = _workers(client) if client is not None else threads or os.cpu_count() or 1
    finished = [] if out is None else _done(os.fspath(out))
    own = None if client is not None else concurrent.futures.ThreadPoolExecutor(workers)
    executor: Any = own if client is None else client.get_executor(pure=False) if hasattr(client, "get_executor") else client
    file = None if out is None else open(out, "ab")
    waiting: dict[Any, int] = {}
    lines: dict[int, bytes] = {}
    written = len(finished)
    try:
        texts = enumerate(problems)
        for index, line in enumerate(finished):
            next(texts, None)
            yield index, _result(line)
        ended = False
        while waiting or not ended:
            while not ended and len(waiting) < _AHEAD * workers:
                index, document = next(texts, (-1, None))
                if document is None:
                    ended = True
                    break
                try:
                    waiting[executor.submit(_one, _text(document))] = index
                except Error as error:  # what no document can hold
                    done: concurrent.futures.Future[bytes] = concurrent.futures.Future()
                    done.set_result(_line_of(error))
                    waiting[done] = index
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
        if own is not None:
            own.shutdown(wait=True, cancel_futures=True)
        if file is not None:
            file.close()


def _text(document: Document) -> str:
    """A document as a text that travels."""
    if isinstance(document, (str, os.PathLike)):
        text = os.fspath(document)
        return text if text.lstrip()[:1] in ("{", "[") else os.path.abspath(text)
    return json.dumps(with_version(plain(document)))


__all__ = ["map"]
