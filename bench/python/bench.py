"""What the package costs over the library, and what sweeps gain by threads; peers beside it where they are installed.

    tools/python.sh bench [--films N]
"""
import argparse
import concurrent.futures
import os
import pathlib
import time
import timeit

import numpy as np

import taut


def best(function, number, repeat=7):
    """Microseconds of a processor, of the quickest of some runs: what else it does does not count."""
    return min(timeit.repeat(function, timer=time.process_time, number=number, repeat=repeat)) / number * 1e6


def quotient(slow, quick, number, repeat=15):
    """How many times slow takes what quick takes: the best of turns taken in turn, so that who else is on the machine matters little."""
    times = [[timeit.timeit(one, timer=time.process_time, number=number) for one in (slow, quick)] for _ in range(repeat)]
    return min(one for one, _ in times) / min(other for _, other in times)


def film(seed, n=12):
    """A problem of n x n points on a random boundary."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
    a, b, c = random.uniform(-0.3, 0.3, 3)
    points = np.stack([x, y, a * np.sin(3 * x) + b * x * y + c * np.cos(2 * y)], axis=-1)
    points[1:-1, 1:-1] = np.nan
    basis = {"type": "bspline", "degree": 3, "count": n}
    return {"construct": "plateau", "method": "normal", "least": False, "u": basis, "v": basis, "points": points}


def constructions():
    """Small problems, (name, function, document): each the function of a construction with what it takes, and the same as a document."""
    rows, open_net, u = np.random.default_rng(1).standard_normal((4, 4, 3)), np.array(film(0, 4)["points"]), taut.bezier(3)
    rows[1:-1] = np.nan
    surface = taut.harmonic(rows, u=u, v=u).surfaces[0]
    polygon = [[5, 0, 0], [5, 2, 0], [0, 6, 0], [0, 6, 3]]
    said = {
        "dirichlet": {"points": open_net, "u": u, "v": u},
        "plateau": {"points": open_net, "u": u, "v": u, "method": "normal", "least": False},
        "harmonic": {"points": rows, "u": u, "v": u},
        "harmonic-extension": {"surface": surface, "edge": "u1"},
        "biharmonic": {"points": open_net, "u": u, "v": u},
        "bonnet": {"sign": "+", "alpha": 1.0, "beta": 1.0, "lambda": 0.5},
        "pipe": {"radii": [0.5, 0.75], "polygon": polygon, "shape": {"alpha": 1, "beta": 1, "gamma": 1}},
    }
    for name, members in said.items():
        function = getattr(taut, name.replace("-", "_"))
        arguments = {"lambda_" if key == "lambda" else key: value for key, value in members.items()}
        yield name, lambda function=function, arguments=arguments: function(**arguments), {"construct": name, **members}


def over_c(function, document):
    """Microseconds of a construction by Python's function, and of the same calls of C with everything ready, in turn."""
    from ctypes import byref, c_void_p
    from taut import _library as c, making
    problems = making._problems(document)
    problem = c.library.taut_problem_list_at(problems.pointer, 0)
    model, certificate, error = c_void_p(), c_void_p(), c.ErrorStruct()

    def bare():
        c.library.taut_make(problem, None, byref(model), byref(error))
        c.library.taut_certify(model, problem, None, byref(certificate), byref(error))
        c.library.taut_model_set_certificate(model, certificate)
        c.library.taut_model_free(model)
    once = timeit.timeit(bare, timer=time.process_time, number=3) / 3
    number = max(1, min(300, int(0.02 / once)))
    turns = [[best(one, number, 1) for one in (function, bare)] for _ in range(25)]
    return min(one for one, _ in turns), min(other for _, other in turns)


def of_its_own(function, document):
    """Microseconds that Python's function takes beside C's, which are not called: where what they take varies by more than that."""
    from taut import _library as c
    name = document["construct"].replace("-", "_")
    real = {key: getattr(c.library, key) for key in (f"taut_{name}_make", f"taut_{name}_certify", "taut_model_set_certificate", "taut_model_free")}
    ready = function()
    try:
        for key in real:
            setattr(c.library, key, lambda *_: 0)
        cost = best(function, 300)
    finally:
        for key, value in real.items():
            setattr(c.library, key, value)
    assert ready == function()
    return cost


def by_geomdl(surface):
    """A grid of 50 x 50 points by geomdl, over ours."""
    try:
        from taut.neighbours import to_geomdl
        shape = to_geomdl(surface)
    except ImportError:
        return [("geomdl over ours, 50 x 50 points", float("nan"), "(geomdl is not installed)")]
    grid = np.linspace(0, 1, 50)
    pairs = [(u, v) for u in grid.tolist() for v in grid.tolist()]
    return [("geomdl over ours, 50 x 50 points", quotient(lambda: shape.evaluate_list(pairs), lambda: surface.grid(grid, grid, 0), 1), "times")]


def waited(pids):
    """Of each thread of processes: the seconds that it had a processor, and those that it waited for one that others had."""
    tasks = {}
    for pid in pids:
        for path in pathlib.Path(f"/proc/{pid}/task").glob("*/schedstat"):
            try:
                ran, waits, _ = path.read_text(encoding="ascii").split()
            except OSError:  # it has ended
                continue
            tasks[str(path)] = (int(ran) / 1e9, int(waits) / 1e9)
    return tasks


def pid_of(seconds):
    """That of a worker, which is kept busy so long that the others are asked too."""
    time.sleep(seconds)
    return os.getpid()


def sweep(documents, workers, pids=None, **how):
    """Seconds of a sweep, those that its workers were not kept waiting by other programs, and how many failed.

    What a worker waits for in the sweep itself, the interpreter's lock or the next problem, counts; and no fewer than all its processes,
    this one too, had a processor, over the number of workers: where there are as many processors, they wait for each other.
    """
    pids = pids or [os.getpid()]
    failed, tasks, before, here = 0, {}, waited(pids), time.process_time()
    begin = time.perf_counter()
    for count, (_, result) in enumerate(taut.map(documents, **how), 1):
        failed += isinstance(result, taut.Error)
        if count % max(1, len(documents) // 100) == 0:
            tasks.update(waited(pids))  # threads may be gone at the end
    seconds = time.perf_counter() - begin
    busiest = sorted((ran - before.get(task, (0, 0))[0], waits - before.get(task, (0, 0))[1]) for task, (ran, waits) in tasks.items())
    own = [seconds - waits for _, waits in busiest[-workers:]]
    busy = time.process_time() - here + (sum(ran for ran, _ in busiest) if pids != [os.getpid()] else 0)
    return seconds, max(*own, busy / workers) if own else seconds, failed


def by_dask(documents, alone):
    """The same on two worker processes of Dask."""
    try:
        from distributed import Client
    except ImportError:
        return [("the same by Dask", float("nan"), "(python3-distributed is not installed)")]
    with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        list(taut.map(documents[:4], client=client))  # the workers have started, and the library is there
        seconds, own, failed = sweep(documents, 2, list(client.run(os.getpid).values()), client=client)
    return [row_of(f"{len(documents)} films of 12 x 12, 2 workers of Dask", seconds, own, alone, 2, failed)]


def row_of(name, seconds, own, alone, workers, failed):
    """A row of the table; alone: what one thread takes by itself."""
    return name, seconds, f"s, {own:.2f} of its own, efficiency {alone / own / workers:.2f}, {failed} failed"


def sweeps(documents):
    """Sweeps on one worker and on two, of each kind."""
    rows, alone, name = [], None, f"{len(documents)} films of 12 x 12"
    for workers in (1, 2):
        seconds, own, failed = sweep(documents, workers, threads=workers)
        alone = alone or own
        rows.append(row_of(f"{name}, {workers} thread{'s' * (workers > 1)}", seconds, own, alone, workers, failed))
    with concurrent.futures.ProcessPoolExecutor(2) as executor:
        pids = set(executor.map(pid_of, [0.2] * 4))
        seconds, own, failed = sweep(documents, 2, list(pids), client=executor)
        rows.append(row_of(f"{name}, 2 processes", seconds, own, alone, 2, failed))
    return rows + by_dask(documents, alone)


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--films", type=int, default=1000, help="of a sweep; 0: none")
    films = parser.parse_args().films
    points = np.random.default_rng(1).standard_normal((12, 12, 3))
    surface = taut.Surface(taut.bspline(3, count=12), taut.bspline(3, count=12), points)
    few, million, out = np.linspace(0, 1, 5), np.linspace(0, 1, 1000), np.empty((1000, 1000, 3))
    rows = [("s(u, v), one point", best(lambda: surface(0.3, 0.4), 5000), "us"), ("s(u, v), five points", best(lambda: surface(few, few), 2000), "us"),
            ("a million points, out=", best(lambda: surface.grid(million, million, 0, out=out), 3) / 1000, "ms")]
    for name, function, document in constructions():
        with_python, bare = over_c(function, document)
        if bare < 500:
            rows.append((f"{name}, over C", with_python - bare, f"us of {with_python:.0f}"))
        else:
            rows.append((f"{name}, beside C's", of_its_own(function, document), f"us of {with_python:.0f}"))
    try:
        from scipy.interpolate import bisplev
        knots = np.array(surface.u.knots)
        spline = (knots, knots, np.ascontiguousarray(points[..., 0]).ravel(), 3, 3)
        rows.append(("scipy's bisplev, one coordinate", best(lambda: bisplev(million, million, spline), 3) / 1000, "ms"))
        rows.append(("that over our three coordinates", quotient(lambda: bisplev(million, million, spline),
                                                                 lambda: surface.grid(million, million, 0, out=out), 1), "times"))
    except ImportError:
        rows.append(("scipy's bisplev", float("nan"), "(python3-scipy is not installed)"))
    rows += by_geomdl(surface) + (sweeps([film(seed) for seed in range(films)]) if films > 0 else [])
    for name, value, unit in rows:
        print(f"{name:<40} {value:10.2f} {unit}")
    print(f"python {os.sys.version.split()[0]}, numpy {np.__version__}, taut {taut.__version__}")


if __name__ == "__main__":
    main()
