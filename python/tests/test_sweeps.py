"""Many problems: in order on disk, restartable, failures as results."""
import concurrent.futures
import itertools
import json
import os
import pathlib
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import taut
from conftest import ROOT
from taut.making import plain, with_version


def problems(count):
    for seed in range(count):
        random = np.random.default_rng(seed)
        points = random.standard_normal((4, 4, 3))
        points[1:-1, 1:-1] = np.nan
        if seed % 7 == 3:
            yield {"construct": "dirichlet", "u": taut.bezier(3), "v": taut.bezier(3), "points": [[None] * 4] * 4}
        elif seed % 11 == 5:
            yield {"construct": "dirichlet", "points": object()}
        else:
            yield {"construct": "dirichlet", "u": taut.bezier(3), "v": taut.bezier(3), "points": points}


def check(results, count):
    assert sorted(results) == list(range(count))
    for index, document in enumerate(problems(count)):
        if index % 7 == 3:
            assert isinstance(results[index], taut.NoSolution) and results[index].reason == "nothing-known"
        elif index % 11 == 5:
            assert isinstance(results[index], taut.InputError) and results[index].where == "/points"
        else:
            assert results[index] == taut.make(document)


@pytest.mark.parametrize("client", ["none", "threads", "processes"])
def test_map(client):
    if client == "none":
        check(dict(taut.map(problems(40), threads=3)), 40)
    else:
        kind = concurrent.futures.ThreadPoolExecutor if client == "threads" else concurrent.futures.ProcessPoolExecutor
        with kind(2) as executor:
            check(dict(taut.map(problems(40), client=executor)), 40)


def test_map_by_dask():
    distributed = pytest.importorskip("distributed", reason="needs python3-distributed")
    with distributed.Client(n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None) as client:
        check(dict(taut.map(problems(20), client=client)), 20)


def film(seed, n=12):
    """A problem of n x n points on a boundary of its own."""
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
    a, b, c = np.random.default_rng(seed).uniform(-0.3, 0.3, 3)
    points = np.stack([x, y, a * np.sin(3 * x) + b * x * y + c * np.cos(2 * y)], axis=-1)
    points[1:-1, 1:-1] = np.nan
    basis = taut.bspline(3, count=n)
    return {"construct": "plateau", "method": "normal", "least": False, "u": basis, "v": basis, "points": points}


def test_a_thousand_films():
    """Of 12 x 12 points, by two threads: none is lost or fails (some claims are undecided by their rounding), and each is what it is by itself."""
    seen = set()
    for index, model in taut.map((film(seed) for seed in range(1000)), threads=2):
        assert isinstance(model, taut.Model) and model.certificate.holds is not False, (index, model)
        if index % 97 == 0:
            assert model == taut.make(film(index))
        seen.add(index)
    assert seen == set(range(1000))


def test_the_same_bytes_wherever_a_task_ran(tmp_path):
    """Two hundred films by one thread, two, two processes and two workers of Dask."""
    def lines(name, **how):
        assert len(list(taut.map((film(seed, 7) for seed in range(200)), out=tmp_path / name, **how))) == 200
        return (tmp_path / name).read_bytes()
    alone = lines("alone", threads=1)
    assert lines("threads", threads=2) == alone
    with concurrent.futures.ProcessPoolExecutor(2) as executor:
        assert lines("processes", client=executor) == alone
    distributed = pytest.importorskip("distributed", reason="needs python3-distributed")
    with distributed.Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        assert lines("dask", client=client) == alone


def test_as_many_at_once_as_there_are_workers():
    """On a cluster, not as many as this machine has processors."""
    class Executor(concurrent.futures.ThreadPoolExecutor):
        count, enough = 0, threading.Event()

        def submit(self, function, /, *arguments):
            self.count += 1
            if self.count > 64:
                self.enough.set()
            return super().submit(lambda: (self.enough.wait(60), function(*arguments))[1])
    with Executor(64) as executor:  # none ends before more were handed out than this machine's processors make of it
        for index, _ in taut.map(problems(300), client=executor):
            if executor.enough.is_set() and index > 2:
                break
    assert executor.enough.is_set() and executor.count < 300


class Counting(concurrent.futures.ThreadPoolExecutor):
    """An executor that counts its tasks."""
    count = 0

    def submit(self, function, /, *arguments):
        self.count += 1
        return super().submit(function, *arguments)


def test_quick_problems_share_a_task():
    """To a client, whose tasks cost more than they do; and it is not read further ahead for that than half of what is done."""
    texts = [json.dumps({"taut": 1, "number": i}) for i in range(600)]
    alone = dict(taut.map(texts, threads=2))
    done, furthest = 0, 0

    def counted():
        nonlocal furthest
        for index, text in enumerate(texts):
            furthest = max(furthest, index - max(16, done * 3 // 2))
            yield text
    with Counting(2) as executor:
        for index, error in taut.map(counted(), client=executor):
            done += 1
            assert type(error) is type(alone[index]) and error.__dict__ == alone[index].__dict__
    assert done == 600 and executor.count < 200 and furthest <= 16


def test_slow_problems_do_not_share(monkeypatch):
    """What a task has no time for is handed out again; nothing is lost or made twice."""
    made = []

    def slow(text, stop=None):
        made.append(int(text[1:-1]))
        time.sleep(0.002 if made[-1] < 100 else 0.03)
        return b'{"error": {"exit": 3, "reason": "", "where": "", "message": "%d", "found": null, "expected": null}}' % made[-1]
    monkeypatch.setattr(taut.sweeps, "_one", slow)
    monkeypatch.setattr(taut.sweeps, "_TASK", 0.05)
    with Counting(1) as executor:
        results = dict(taut.map((f"[{i}]" for i in range(140)), client=executor))
    assert sorted(made) == list(range(140)) and all(results[i].message == str(i) for i in made)
    assert 40 // 4 < executor.count < 140


def test_results_do_not_wait_for_a_slow_iterator():
    """Whose problems come one by one, though as many as workers take could be handed out."""
    read = []

    def slow():
        for document in itertools.cycle(problems(3)):
            read.append(time.sleep(0.02))
            yield document
    next(taut.map(slow(), threads=100))
    assert len(read) < 400


SWEEP = """
import sys, taut
sys.path.insert(0, sys.argv[2])
from test_sweeps import problems
for index, _ in taut.map(problems(120), out=sys.argv[1], threads=2):
    pass
"""


def test_killed(tmp_path):
    """By the system, not at a good moment; started again it makes what is missing."""
    out, whole = tmp_path / "r.jsonl", tmp_path / "whole.jsonl"
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(taut.__file__).parents[1])}
    with subprocess.Popen([sys.executable, "-c", SWEEP, str(out), str(pathlib.Path(__file__).parent)], env=environment) as process:
        while process.poll() is None and (not out.exists() or out.stat().st_size < 20000):
            time.sleep(0.002)
        process.kill()
    left = out.read_bytes()
    assert 0 < left.count(b"\n")
    check(dict(taut.map(problems(120), out=out)), 120)
    check(dict(taut.map(problems(120), out=whole)), 120)
    assert out.read_bytes() == whole.read_bytes() and out.read_bytes().startswith(left[:left.rindex(b"\n") + 1])


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
def test_slurm_array(tmp_path, program):
    """The example's script, its tasks one after the other."""
    designs = [{"taut": 1, **problem, "points": [[None if np.isnan(p).any() else p.tolist() for p in row] for row in problem["points"]],
                "u": {"type": "bezier", "degree": 3}, "v": {"type": "bezier", "degree": 3}} for problem in problems(3)]
    designs += designs[:2]
    (tmp_path / "designs.jsonl").write_text("".join(json.dumps(one) + "\n" for one in designs))
    for part in range(2):
        environment = {**os.environ, "TAUT": program, "SLURM_ARRAY_TASK_ID": str(part), "SLURM_ARRAY_TASK_COUNT": "2"}
        for _ in range(2):  # submitted again it finds all done
            subprocess.run(["sh", str(ROOT / "examples/cluster/sweep.sbatch")], cwd=tmp_path, env=environment, check=True, capture_output=True)
    found = {2 * k + part: taut.Model.from_json(line) for part in range(2)
             for k, line in enumerate((tmp_path / f"results-{part}.jsonl").read_text().splitlines())}
    assert [found[i] for i in range(5)] == [taut.make(one) for one in designs]


def test_restart(tmp_path):
    out = tmp_path / "r.jsonl"
    check(dict(taut.map(problems(30), out=out)), 30)
    whole = out.read_bytes()
    lines = whole.splitlines()
    assert len(lines) == 30 and all(isinstance(json.loads(line), dict) for line in lines)
    asked = []

    def counted():
        for index, document in enumerate(problems(30)):
            asked.append(index)
            yield document
    for cut in (len(whole) // 2, len(whole) - 1, 5, 0):
        out.write_bytes(whole[:cut])
        check(dict(taut.map(counted(), out=out, threads=2)), 30)
        assert out.read_bytes() == whole
    out.write_bytes(whole)
    assert len(dict(taut.map(problems(30), out=out))) == 30 and out.read_bytes() == whole


def test_other_problems(tmp_path):
    """A file of results is of its problems: of others nothing is given back, and nothing is changed."""
    out = tmp_path / "r.jsonl"
    first, other = list(problems(3)), list(problems(5))[3:]
    whole = [taut.make(one) for one in first]
    assert [model for _, model in sorted(taut.map(first, out=out), key=lambda pair: pair[0])] == whole
    text = out.read_bytes()
    with pytest.raises(taut.InputError) as caught:
        list(taut.map(other, out=out))
    assert caught.value.reason == "other-sweep" and out.read_bytes() == text
    assert [model for _, model in taut.map(first[:2], out=out)] == whole[:2] and out.read_bytes() == text
    assert [model for _, model in sorted(taut.map(first + other, out=out), key=lambda pair: pair[0])][:3] == whole
    out.with_suffix(".jsonl.sums").unlink()  # as the program leaves it
    assert len(list(taut.map(first + other, out=out))) == 5
    out.write_bytes(text)  # three lines from elsewhere, and two more of a sweep's own, again and again
    out.with_suffix(".jsonl.sums").unlink()
    for _ in range(3):
        assert len(list(taut.map(first + other, out=out))) == 5


def test_lines_are_the_programs(tmp_path, program):
    """Byte for byte, models and errors."""
    good = (ROOT / "examples/dirichlet-bicubic.json").read_text()
    wrong = [{"construct": "nope"}, {"construct": "bonnet", "sign": "+", "alpha": 1, "beta": 2, "lambda": 1.1},
             {"construct": "dirichlet", "name": "Dächer \u2028 \"x\"", "points": [[None] * 2] * 2, "u": {"type": "bezier", "degree": 1},
              "v": {"type": "bezier", "degree": 1}}, {"construct": "dirichlet", "u": {"type": "bezier", "degree": 1e9}}]
    designs = [json.dumps(json.loads(good)), *(json.dumps({"taut": 1, **one}, ensure_ascii=False) for one in wrong)]
    (tmp_path / "in.jsonl").write_text("\n".join(designs) + "\n", encoding="utf-8")
    done = subprocess.run([program, "make", "--quiet", "--lines", "in.jsonl", "-o", "program.jsonl"], cwd=tmp_path, check=False)
    assert done.returncode == 1 and all(isinstance(one, taut.Error) for i, one in taut.map(designs, out=tmp_path / "python.jsonl") if i > 0)
    assert (tmp_path / "python.jsonl").read_bytes() == (tmp_path / "program.jsonl").read_bytes()


def test_lines_are_json(tmp_path):
    """Also of numbers that JSON does not have; and the errors come back from them as they were, but for such a number."""
    out = tmp_path / "r.jsonl"
    wrong = [{**next(problems(1)), "aspect": aspect} for aspect in (float("inf"), float("nan"), -1.0)]
    found = dict(taut.map(wrong, out=out))
    for line in out.read_text().splitlines():
        json.loads(line, parse_constant=pytest.fail)
    again = dict(taut.map(wrong, out=out))
    assert [error.reason for error in found.values()] == ["value"] * 3 and again[2].found == -1.0 and again[0].found is None
    assert all(again[i].message == found[i].message and again[i].where == "/aspect" for i in range(3))


@pytest.mark.parametrize("text", [b"my thesis\nchapter 1\n", b"my thesis", b'{"a": 1}\n', b"[1]\n"])
def test_no_file_of_results(tmp_path, text):
    out = tmp_path / "notes.txt"
    out.write_bytes(text)
    with pytest.raises(taut.FileError):
        list(taut.map(problems(2), out=out))
    assert out.read_bytes() == text


def test_two_sweeps_at_once(tmp_path):
    out = tmp_path / "r.jsonl"
    running = taut.map(problems(4), out=out)
    next(running)
    with pytest.raises(taut.FileError):
        list(taut.map(problems(4), out=out))
    list(running)
    assert len(list(taut.map(problems(4), out=out))) == 4


def test_what_is_no_problem_is_a_result(tmp_path, program):
    """A list of problems too, with the words of the program; the sweep goes on. Bytes are texts."""
    good = json.dumps(with_version(plain(next(problems(1)))))
    (tmp_path / "list.json").write_text(f"[{good}, {good}]")
    found = dict(taut.map([None, good, f"[{good}, {good}]", [json.loads(good)] * 2, tmp_path / "list.json", b"\xff", good.encode()], threads=2))
    assert [getattr(found[i], "reason", "") for i in range(7)] == ["type", "", "type", "type", "type", "text", ""] and found[1] == found[6]
    (tmp_path / "in.jsonl").write_text(f"\n[{good}, {good}]\n  \n{good}\n\n")
    subprocess.run([program, "make", "--quiet", "--lines", "in.jsonl", "-o", "program.jsonl"], cwd=tmp_path, check=False)
    with open(tmp_path / "in.jsonl", encoding="utf-8") as lines:
        assert len(list(taut.map(lines, out=tmp_path / "python.jsonl"))) == 2
    assert (tmp_path / "python.jsonl").read_bytes() == (tmp_path / "program.jsonl").read_bytes()


EARLY = """
import os, signal, sys, time, taut
from taut import sweeps
one = sweeps._one
def slow(text, stop=None):
    if text == sys.argv[2]:
        time.sleep(600)
    return one(text, stop)
sweeps._one = slow
for count, _ in enumerate(taut.map(sys.argv[2:], out=sys.argv[1], threads=2), 1):
    if count == 12:
        os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_what_came_early_is_kept(tmp_path, monkeypatch):
    """The first problem takes long; killed, what is behind it is not made again, unless it is of another problem now."""
    texts = [json.dumps(with_version(plain(one))) for i, one in enumerate(problems(20)) if i % 11 != 5]
    out, early, whole = tmp_path / "r.jsonl", tmp_path / "r.jsonl.early", tmp_path / "whole.jsonl"
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(taut.__file__).parents[1])}
    killed = subprocess.run([sys.executable, "-c", EARLY, str(out), *texts], env=environment, check=False)
    there = {int(line.split()[0]) for line in early.read_bytes().splitlines()}
    assert killed.returncode < 0 and out.read_bytes() == b"" and len(there) >= 12 and 4 in there and 0 not in there
    with early.open("ab") as file:
        file.write(b"17 in the middle of a li")
    texts[4], made, one = texts[4].replace('"dirichlet"', '"nothing"'), [], taut.sweeps._one

    def counted(text, stop=None):
        made.append(text)
        return one(text, stop)
    list(taut.map(texts, out=whole, threads=1))
    monkeypatch.setattr(taut.sweeps, "_one", counted)
    found = dict(taut.map(texts, out=out, threads=2))
    assert sorted(made) == sorted(text for i, text in enumerate(texts) if i == 4 or i not in there) and sorted(found) == list(range(len(texts)))
    assert out.read_bytes() == whole.read_bytes() and not early.exists()
    assert found[1] == taut.make(texts[1]) and found[4].reason == "name"
    early.write_bytes(b"0 " + b"0" * 64 + b" " + out.read_bytes().splitlines(keepends=True)[0])  # of a file of results that is gone: not wanted
    out.unlink()
    made.clear()
    list(taut.map(texts, out=out))
    assert sorted(made) == sorted(texts) and out.read_bytes() == whole.read_bytes() and not early.exists()
    early.write_bytes(b"my thesis\n")
    with pytest.raises(taut.FileError):
        list(taut.map(texts, out=out))
    assert early.read_bytes() == b"my thesis\n" and out.read_bytes() == whole.read_bytes()


def test_wrong_places(tmp_path):
    for wrong in (tmp_path, tmp_path / "no" / "r.jsonl"):
        with pytest.raises(taut.FileError):
            list(taut.map(problems(1), out=wrong))
    with pytest.raises(taut.InputError):
        taut.map(problems(1), threads=0)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_no_files(tmp_path):
    """A device, a pipe and a folder hold no results to go on with; none of them is read to its end, which a device may not have."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for place in ("/dev/full", "/dev/null", pipe, tmp_path):
        with pytest.raises(taut.FileError) as caught:
            list(taut.map(problems(2), out=place))
        assert caught.value.reason == "file" and caught.value.where == str(place)


FULL = """
import resource, sys
import taut
import test_sweeps
resource.setrlimit(resource.RLIMIT_FSIZE, (6000, 6000))
try:
    list(taut.map(test_sweeps.problems(12), threads=1, out=sys.argv[1]))
except taut.FileError as error:
    print(error.reason, error.where)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs limits of files")
def test_no_room(tmp_path):
    """Where the results find no room the sweep ends with an error of this package, and goes on from there."""
    out = tmp_path / "out.jsonl"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(pathlib.Path(__file__).parent), str(pathlib.Path(taut.__file__).parents[1])])}
    done = subprocess.run([sys.executable, "-c", FULL, str(out)], env=environment, check=False, capture_output=True, text=True)
    assert done.stdout == f"file {out}\n", done.stderr
    assert 0 < out.read_bytes().count(b"\n") < 12
    check(dict(taut.map(problems(12), out=out)), 12)
    assert out.read_bytes().count(b"\n") == 12


def test_interrupt(tmp_path):
    """Ctrl-C ends a sweep of problems that take long, at once."""
    script = tmp_path / "sweep.py"
    script.write_text("""
import os, signal, sys, threading, numpy as np, taut
n = 100
x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
points = np.stack([x, y, 0.5 * np.sin(7 * x) * np.cos(5 * y)], axis=-1)
points[1:-1, 1:-1] = np.nan
b = taut.bspline(3, count=n)
threading.Timer(2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    list(taut.map([{"construct": "plateau", "u": b, "v": b, "points": points}] * 8, threads=2))
    print("made all")
except KeyboardInterrupt:
    print("stopped")
""")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, str(script)], env=environment, capture_output=True, text=True, timeout=300)
    assert done.stdout.strip() == "stopped", done.stderr


def test_iterator_is_not_read_ahead():
    read = []

    def endless():
        for index, document in enumerate(problems(10**6)):
            read.append(index)
            yield document
    for index, _ in taut.map(endless(), threads=2):
        if index >= 5:
            break
    assert len(read) < 100
