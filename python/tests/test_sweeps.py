"""Many problems: in order on disk, restartable, failures as results."""
import concurrent.futures
import json

import numpy as np
import pytest

import taut


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
