#!/usr/bin/env python3
"""bench_table.py -- the tables of README.md and docs/performance.md, from what the benches measured.

    tools/bench_table.py                   writes every table anew from docs/bench/*.json
    tools/bench_table.py --check           fails where a table is another than its JSON makes
    tools/bench_table.py --record NAME     keeps standard input, the output of bench-NAME --json,
                                           as docs/bench/NAME.json with the commit it was built from

A table stands between <!-- bench NAME --> and <!-- end --> lines.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ("README.md", "docs/performance.md")
MARKS = re.compile(r"(<!-- bench ([a-z-]+) -->\n).*?(<!-- end -->)", re.S)


def load(name):
    return json.loads((ROOT / "docs" / "bench" / f"{name}.json").read_text())


def digits(x, count=3):
    """x with that many digits that count, never as a power of ten where that is longer."""
    if x is None:
        return "-"
    if 1e-2 <= abs(x) < 1:
        return f"{x:.2g}"
    if 1 <= abs(x) < 1e5:
        return f"{x:.{max(0, count - len(str(int(abs(x)))))}f}"
    return f"{x:.1g}".replace("e-0", "e-")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def origin(bench):
    return f"{bench['processor']}, one thread, commit {bench['commit']}"


def dirichlet():
    """The solve, size by size."""
    bench = load("dirichlet")
    head = ["n x n points", "Taut, ms", "LAPACK, fast diagonalisation, ms", "times as fast", "CHOLMOD, assembled, ms", "times as fast"]
    rows = [[str(r["n"]), digits(r["taut_ms"]), digits(r["lapack_ms"]), digits(r["over_lapack"], 2),
             digits(r["cholmod_ms"]), digits(r["over_cholmod"], 2)] for r in bench["rows"]]
    rate = (f"{origin(bench)}, {bench['kernel']} kernels, OpenBLAS as {bench['blas']};\nmultiply-add peak "
            f"{bench['fma_rate'] / 1e9:.0f} GFLOP/s, its dgemm at 1000^3 {bench['dgemm_rate'] / 1e9:.0f}.\n\n")
    return rate + table(head, rows)


def accuracy():
    """What the solve leaves, and what memory it takes."""
    bench = load("dirichlet")
    head = ["n x n points", "residual", "after one refinement", "memory, times the data"]
    return table(head, [[str(r["n"]), digits(r["residual"]), digits(r["residual_refined"]), digits(r["memory"], 2)] for r in bench["rows"]])


def making():
    """The construction, all of it."""
    bench = load("dirichlet")
    head = ["n x n points", "the solve, ms", "`taut_dirichlet_make`, ms"]
    return table(head, [[str(r["n"]), digits(r["taut_ms"]), digits(r["make_ms"])] for r in bench["rows"]])


def evaluate():
    """The grid, beside each peer."""
    bench = load("evaluate")
    taut = bench["rows"][0]
    head = ["", "position, Mpt/s", "Taut's grid is as fast, times", "derivatives, Mpt/s", "times"]
    best_first = [taut] + sorted(bench["rows"][1:], key=lambda r: -r["position"])
    rows = [[r["name"][0].upper() + r["name"][1:], *sum(([digits(r[what]), "" if r is taut else f"{taut[what] / r[what]:.1f}"]
                                                         for what in ("position", "second")), [])] for r in best_first]
    rows.append(["Writing the result alone, past the caches", digits(bench["store_rate"] / 24e6), "",
                 digits(bench["store_rate"] / 144e6), ""])
    return (f"{origin(bench)}; stores {bench['store_rate'] / 1e9:.1f} GB/s, multiply-add peak "
            f"{bench['fma_rate'] / 1e9:.0f} GFLOP/s.\n\n") + table(head, rows)


def summary():
    """A few ratios for the README."""
    solve, grid, whole = load("dirichlet"), load("evaluate"), load("make")
    by = {r["n"]: r for r in solve["rows"]}
    taut, sisl = grid["rows"][0], next(r for r in grid["rows"] if "s1506" in r["name"])
    rows = [[f"{r['name']}, from file to file, with its proof", r["peer"], digits(r["peer_ms"] / r["whole_ms"], 2)]
            for r in whole["rows"] if "peer" in r]
    rows += [[f"Dirichlet, {n} x {n} points, from knots to surface", "LAPACK, fast diagonalisation",
              digits(by[n]["over_lapack"], 2)] for n in (100, 400, 1600)]
    rows += [
        ["rational bicubic surface on a grid, position", "SISL s1506",
         digits(taut["position"] / sisl["position"], 2)],
        ["the same with first and second derivatives", "SISL s1506",
         digits(taut["second"] / sisl["second"], 2)]]
    made = origin(whole)
    said = f"{made}." if made == origin(solve) else f"From file to file: {made};\nthe others: {origin(solve)}."
    return (f"{said}\n\n"
            + table(["", "beside", "times as fast"], rows))


def processes():
    """Whole processes beside their peers."""
    bench = load("make")
    head = ["document", "`taut make`, ms", "beside", "ms", "times as fast"]
    rows = [[r["name"], digits(r["whole_ms"]), r["peer"], digits(r["peer_ms"]), digits(r["peer_ms"] / r["whole_ms"], 2)]
            for r in bench["rows"] if "peer" in r]
    return origin(bench) + ", CPU time.\n\n" + table(head, rows)


def shares():
    """Whole processes of all constructions, and where their time goes."""
    head = ["document", "`taut make`, ms", "read", "made", "proved", "written"]
    return table(head, [[r["name"], digits(r["whole_ms"]), *(f"{100 * r[part]:.0f} %" for part in ("read", "made", "proved", "written"))]
                        for r in load("make")["rows"]])


TABLES = {"dirichlet": dirichlet, "processes": processes, "shares": shares, "accuracy": accuracy, "making": making, "evaluate": evaluate, "summary": summary}


def record(name):
    bench = json.load(sys.stdin)
    described = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, check=True,
                               capture_output=True, text=True).stdout.strip()
    bench = {"commit": described, **bench}
    target = ROOT / "docs" / "bench" / f"{name}.json"
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(bench, indent=1) + "\n")


def main():
    if sys.argv[1:2] == ["--record"] and len(sys.argv) == 3:
        record(sys.argv[2])
        return 0
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    bad = 0
    for page in PAGES:
        path = ROOT / page
        old = path.read_text()
        new = MARKS.sub(lambda m: m[1] + "\n" + TABLES[m[2]]() + "\n" + m[3], old)
        if new != old and sys.argv[1:]:
            print(f"{page}: a table is another than docs/bench makes; run tools/bench_table.py", file=sys.stderr)
            bad = 1
        elif new != old:
            path.write_text(new)
        if not MARKS.search(old):
            print(f"{page}: has no table", file=sys.stderr)
            bad = 1
    return bad


sys.exit(main())
