#!/usr/bin/env python3
"""mutants_generated.py -- breaks every limit, sign and term of the certificates, one after the other.

    tools/mutants_generated.py [--seconds N] [--seed S] [--files GLOB] [--out FILE.json]

Beside the mutants made by hand (mutants.py) these are made by rule, from the text of src/certify:

    sign       a + b becomes a - b, a - b becomes a + b, += becomes -= and the other way round
    term       a * b becomes a * 1000 b, a / b becomes 1000 a / b
    limit      a < b, <=, >, >= are held against 1000 b; of loops' ends nothing is changed
    extreme    fmax, fmin and their relatives that keep NaN become each other
    branch     a condition of an if is always true; always false
    statement  an assignment or a call is left out

All of them are in one build, each behind a switch that the environment sets, so that a mutant costs a run of the tests that
reach it and no compilation. What does not compile (a sign between pointers, say) is left out. A mutant that no test reaches
counts as surviving. --seconds stops the trial after so long: mutants come in an order that the seed (default: the commit)
decides, so that a part of them is a fair sample.
"""
import argparse
import collections
import concurrent.futures
import fnmatch
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / "build/mutants-generated"
Mutant = collections.namedtuple("Mutant", "number file line kind text")
# A place where text is put in: `begin` before offset `at`; several make up one mutant.
Place = collections.namedtuple("Place", "at text")

SKIP = re.compile(r"""/\*.*?\*/|//[^\n]*|^[ \t]*\#(?:\\\n|[^\n])*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'""", re.S | re.M)
OPERATOR = re.compile(r"(?<=[\w\])] )(\+=|-=|<=|>=|[-+*/<>])(?= )")
EXTREMES = {"fmax": "fmin", "fmin": "fmax", "taut_certify_max": "taut_certify_min", "taut_certify_min": "taut_certify_max"}
KEYWORDS = ("return", "break", "continue", "goto", "else", "case", "default", "if", "for", "while", "do", "switch", "static",
            "const", "typedef", "struct", "enum", "extern", "sizeof")
SWITCH = """
#ifndef TAUT_MUTANT_SWITCH
#define TAUT_MUTANT_SWITCH
extern int taut_mutant;
extern unsigned char taut_mutant_reached[];
static inline int taut_mutant_is(int k) { taut_mutant_reached[k] = 1; return taut_mutant == k; }
#define TAUT_M(k) taut_mutant_is(k)
#define TAUT_S(k) (taut_mutant_is(k) ? -1 : 1) /* whole, so that sums of whole numbers and of pointers stay what they are */
#define TAUT_E(k) (taut_mutant_is(k) ? 1000 : 1)
#endif
"""
RUNTIME = """
#include <stdio.h>
#include <stdlib.h>
int taut_mutant = -1;
unsigned char taut_mutant_reached[%d];
static void taut_mutant_tell(void)
{
    const char *path = getenv("TAUT_MUTANT_REACHED");
    FILE *file = path != NULL ? fopen(path, "ab") : NULL;
    if (file != NULL) {
        fwrite(taut_mutant_reached, 1, sizeof taut_mutant_reached, file);
        fclose(file);
    }
}
__attribute__((constructor)) static void taut_mutant_begin(void)
{
    const char *chosen = getenv("TAUT_MUTANT");
    taut_mutant = chosen != NULL ? atoi(chosen) : -1;
    atexit(taut_mutant_tell);
}
"""


def blanked(text):
    """text with comments, directives and strings as blanks of the same length."""
    return SKIP.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def closing(code, at):
    """The offset of the parenthesis that closes the one at `at`."""
    depth = 0
    for k in range(at, len(code)):
        depth += (code[k] == "(") - (code[k] == ")")
        if depth == 0:
            return k
    return -1


def in_loop_head(code):
    """Offsets that are inside the head of a for loop."""
    inside = set()
    for m in re.finditer(r"\b(for|while) \(", code):
        inside.update(range(m.end() - 1, closing(code, m.end() - 1) + 1))
    return inside


def operators(code):
    """Signs, terms and limits: (kind, places)."""
    loops = in_loop_head(code)
    for m in OPERATOR.finditer(code):
        at, sign = m.end() + 1, m.group()
        if m.start() in loops and sign in ("<", "<=", ">", ">="):
            continue
        if sign in ("+", "-", "+=", "-="):
            yield "sign", [Place(at, "TAUT_S(%d) * ")], m.start()
        elif sign == "/":
            yield "term", [Place(m.start(), "* TAUT_E(%d) ")], m.start()
        else:
            yield ("term" if sign == "*" else "limit"), [Place(at, "TAUT_E(%d) * ")], m.start()


def extremes(code):
    """fmax and its relatives."""
    for m in re.finditer(r"\b(%s)\(" % "|".join(EXTREMES), code):
        yield "extreme", [Place(m.start(), "(TAUT_M(%d) ? " + EXTREMES[m.group(1)] + " : "), Place(m.end() - 1, ")")], m.start()


def branches(code):
    """Conditions of ifs."""
    for m in re.finditer(r"\bif \(", code):
        end = closing(code, m.end() - 1)
        for value in "01":
            yield "branch", [Place(m.end(), f"TAUT_M(%d) ? {value} : ("), Place(end, ")")], m.start()


def statements(code):
    """Assignments and calls on lines of their own."""
    for m in re.finditer(r"(?<=[;{}])\s*\n\s*([A-Za-z_*(][^;{}]*;)", code):
        word = re.match(r"\w*", m.group(1)).group()
        if word in KEYWORDS or re.match(r"[A-Za-z_]\w*\s+\**[A-Za-z_]", m.group(1)):
            continue
        yield "statement", [Place(m.start(1), "if (!TAUT_M(%d)) { "), Place(m.end(1), " }")], m.start(1)


def candidates(name, text):
    """All that could be broken in a file: (kind, line, excerpt, places)."""
    code = blanked(text)
    first = code.find("{")  # declarations before the first body are no code, but a few limits, which constants() has
    lines = text.split("\n")
    for kind, places, at in [*operators(code), *extremes(code), *branches(code), *statements(code)]:
        line = text.count("\n", 0, at) + 1
        if at > first:
            yield kind, line, lines[line - 1].strip(), places


def instrumented(text, chosen):
    """text with the places of the chosen mutants {number: places}."""
    inserts = sorted(((place.at, -number if i else number, place.text.replace("%d", str(number)))
                      for number, places in chosen.items() for i, place in enumerate(places)), key=lambda x: (x[0], x[1]))
    pieces, last = [], 0
    for at, _, insert in inserts:
        pieces += [text[last:at], insert]
        last = at
    return "".join(pieces) + text[last:]


def compiles(command, path, text):
    """Lines with errors; [] if there are none."""
    path.write_text(text)
    said = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    lines = [int(m.group(1)) for m in re.finditer(r"(?m)^%s:(\d+):\d+: error" % re.escape(str(path)), said.stdout)]
    return lines if said.returncode else []


def prepared(tree, build, name, numbers):
    """Instruments a file with all mutants that compile; the mutants."""
    path = tree / name
    text = path.read_text()
    entry = next(e for e in json.loads((build / "compile_commands.json").read_text()) if e["file"] == str(path))
    words = shlex.split(entry["command"])
    command = [w for i, w in enumerate(words) if w != "-o" and words[i - 1] != "-o" and w != "-c"] + ["-fsyntax-only", "-w"]
    command += ["-include", str(tree / "src/core/mutant_switch.h")]
    found = {next(numbers): entry for entry in candidates(name, text)}
    alive = dict(found)
    while True:
        bad = set(compiles(command, path, instrumented(text, {n: e[3] for n, e in alive.items()})))
        if not bad:
            break
        worse = {n for n, e in alive.items() if e[1] in bad}
        if not worse:  # an error away from its place: without the statements, which hide declarations
            worse = {n for n, e in alive.items() if e[0] == "statement"} or set(alive)
        alive = {n: e for n, e in alive.items() if n not in worse}
        for n in sorted(worse):  # of a line with an error some mutants are fine
            if not compiles(command, path, instrumented(text, {n: found[n][3]})):
                alive[n] = found[n]
                if compiles(command, path, instrumented(text, {k: e[3] for k, e in alive.items()})):
                    del alive[n]
    path.write_text(instrumented(text, {n: e[3] for n, e in alive.items()}))
    return [Mutant(n, name, e[1], e[0], e[2]) for n, e in sorted(alive.items())]


def quietly(command, **more):
    """Runs a command; its output is nobody's."""
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False, **more).returncode


def build_tree(pattern):
    """The instrumented tree, built: its build folder and the mutants."""
    tree, build = WORK / "tree", WORK / "build"
    shutil.rmtree(tree, ignore_errors=True)
    subprocess.run(["git", "clone", "-q", "--shared", str(ROOT), str(tree)], check=True)
    configure = ["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                 f"-DCMAKE_C_FLAGS=-w -include {tree}/src/core/mutant_switch.h"]
    (tree / "src/core/mutant_switch.h").write_text(SWITCH)
    (tree / "src/core/mutant_switch.c").write_text(RUNTIME % 1)
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    numbers, mutants = iter(range(1 << 30)), []
    names = sorted(str(p.relative_to(tree)) for p in (tree / "src/certify").rglob("*.c"))
    for name in (n for n in names if fnmatch.fnmatchcase(n, pattern)):
        mutants += prepared(tree, build, name, numbers)
    (tree / "src/core/mutant_switch.c").write_text(RUNTIME % (next(numbers) + 1))
    said = subprocess.run(["cmake", "--build", build], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                          check=False)
    if said.returncode:
        sys.exit("\n".join(line for line in said.stdout.splitlines() if "error" in line)[:4000])
    return build, mutants


def run_test(build, test, seconds, **environment):
    """Whether a test passes."""
    return quietly(["timeout", "-k", "5", str(seconds), "ctest", "--test-dir", build, "-R", f"^{re.escape(test)}$"],
                   env={**os.environ, **environment}) == 0


def reach(build, mutants):
    """The tests of the unbroken tree: how long each takes, and which mutants it reaches."""
    listed = subprocess.run(["ctest", "--test-dir", build, "-N"], stdout=subprocess.PIPE, universal_newlines=True,
                            check=True).stdout
    seconds, reached = {}, collections.defaultdict(list)
    size = max(m.number for m in mutants) + 2

    def one(test):
        marks = WORK / ("reached-" + test.replace("/", "-"))
        marks.unlink(missing_ok=True)
        begin = time.monotonic()
        if not run_test(build, test, 600, TAUT_MUTANT_REACHED=str(marks)):
            print(f"{test} fails on the unbroken tree: it can catch nothing", flush=True)
            return test, None, b""
        taken = time.monotonic() - begin
        told, content = bytearray(size), marks.read_bytes() if marks.exists() else b""
        for at in range(0, len(content) - len(content) % size, size):
            part = content[at:at + size]
            told = bytearray(a | b for a, b in zip(told, part))
        return test, taken, told

    tests = [t for t in re.findall(r"(?m)^ *Test *#[0-9]*: *(\S+)", listed) if not t.startswith(("tools/", "viewer/"))]
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for test, taken, told in pool.map(one, tests):
            if taken is not None:
                seconds[test] = taken
                for m in mutants:
                    if m.number < len(told) and told[m.number]:
                        reached[m.number].append(test)
    return seconds, reached


def verdict_of(build, mutant, tests, seconds):
    """The test that catches a mutant, or None."""
    for test in sorted(tests, key=seconds.get):
        if not run_test(build, test, 10 + 10 * seconds[test], TAUT_MUTANT=str(mutant.number)):
            return test
    return None


def summary(results):
    """Counts by file: generated, caught."""
    table = collections.defaultdict(lambda: [0, 0])
    for mutant, test in results:
        table[mutant.file][0] += 1
        table[mutant.file][1] += test is not None
    return dict(sorted(table.items()))


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=0)
    parser.add_argument("--seed", default="")
    parser.add_argument("--files", default="*")
    parser.add_argument("--out", default="")
    options = parser.parse_args()
    head = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, stdout=subprocess.PIPE, universal_newlines=True,
                          check=True).stdout.strip()
    WORK.mkdir(parents=True, exist_ok=True)
    build, mutants = build_tree(options.files)
    print(f"{len(mutants)} mutants of {len({m.file for m in mutants})} files", flush=True)
    seconds, reached = reach(build, mutants)
    order = list(mutants)
    random.Random(options.seed or head).shuffle(order)
    begin, results = time.monotonic(), []

    def one(mutant):
        if 0 < options.seconds <= time.monotonic() - begin:
            return None
        return mutant, verdict_of(build, mutant, reached[mutant.number], seconds)

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for result in pool.map(one, order):
            if result is None:
                continue
            results.append(result)
            if result[1] is None:
                m = result[0]
                print(f"{m.file}:{m.line}: {m.kind:<9} {'survived' if reached[m.number] else 'not reached'}: {m.text}", flush=True)
    caught = sum(test is not None for _, test in results)
    print(f"{len(results)} of {len(mutants)} mutants tried, {caught} caught, {len(results) - caught} not")
    if options.out:
        report = {"commit": head, "seed": options.seed or head, "generated": len(mutants), "tried": len(results), "caught": caught,
                  "files": {f: {"tried": n, "caught": c} for f, (n, c) in summary(results).items()},
                  "survivors": [{"file": m.file, "line": m.line, "kind": m.kind, "text": m.text,
                                 "reached": bool(reached[m.number])} for m, test in results if test is None]}
        pathlib.Path(options.out).write_text(json.dumps(report, indent=1, ensure_ascii=False) + "\n")


main()
