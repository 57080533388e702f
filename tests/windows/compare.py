#!/usr/bin/env python3
"""compare.py NATIVE PROGRAM... -- what `taut` for Windows does against what the native one does.

PROGRAM is the command that runs it, such as `wine64 taut.exe`. Every example is made by both: models, certificates, meshes and pages must be the same bytes, what is said
the same words but for times, exit statuses the same. Then names that are not ASCII, what is wrong, and pipes.
No shell is needed.
"""
import itertools
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

os.environ["SOURCE_DATE_EPOCH"] = "0"  # the date in STEP files
source = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# what is run in other folders is named in full
native, *program = ([w if os.path.isabs(w) or not os.path.exists(w) else os.path.abspath(w)] for w in sys.argv[1:])
program = [word for words in program for word in words]
failures = []


def fail(what):
    failures.append(what)
    print("FAILED", what, flush=True)


def run(command, folder, words, given=None):
    """(exit status, standard output, what was said without the times)"""
    done = subprocess.run(command + words, cwd=folder, input=given, capture_output=True, timeout=170)
    said = re.sub(rb"(?m)^  time .*$", b"", done.stderr)
    said = re.sub(rb"(?m)^ +the proof took over ten times the making\n", b"", said)  # how fast a machine is, as the next
    said = re.sub(rb"taut: `taut \w+` has worked for .*\n", b"", said)
    return done.returncode, done.stdout, said


def contents(folder):
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), "rb") as file:
            found[name] = re.sub(rb'"seconds[a-z_]*": *[-+.0-9e]+', b"", file.read())
    return found


def first_difference(one, other):
    for a, b in itertools.zip_longest(one.splitlines(), other.splitlines()):
        if a != b:
            return f"{a!r:.300} and here {b!r:.300}"
    return "ends of lines alone"


def same(what, words, given=None, put=()):
    """Both run in folders of their own and must do and leave the same."""
    results = []
    for command in (native, program):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in put:
                with open(os.path.join(folder, name), "wb") as file:
                    file.write(text)
            results.append(run(command, folder, words, given) + (contents(folder),))
    one, other = results
    if one[0] != other[0]:
        fail(f"{what}: exit status: {one[0]} and here {other[0]}")
    for k, part in ((1, "standard output"), (2, "what is said")):
        if one[k] != other[k]:
            fail(f"{what}: {part}: " + first_difference(one[k], other[k]))
    if one[3] != other[3]:
        differ = [n for n in sorted(set(one[3]) | set(other[3])) if one[3].get(n) != other[3].get(n)]
        fail(f"{what}: files differ: {differ}")
    return one


def example(name):
    with open(os.path.join(source, "examples", name), "rb") as file:
        text = file.read()
    folder = os.path.join(source, "examples")
    beside = [(n, open(os.path.join(folder, n), "rb").read()) for n in os.listdir(folder)
              if n != name and n.encode() in text and os.path.isfile(os.path.join(folder, n))]
    outputs = ["-o", "m.json", "-o", "m.glb", "-o", "m.svg"]
    return same(name, ["make", name, *outputs], put=[(name, text), *beside])[0]


def examples():
    names = sorted(n for n in os.listdir(os.path.join(source, "examples")) if n.endswith(".json"))
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        statuses = list(pool.map(example, names))
    print(f"{len(names)} examples, {statuses.count(0)} of them made")
    if len(names) < 50 or statuses.count(0) < 50:
        fail("hardly an example was made")


def others():
    tent = open(os.path.join(source, "examples", "dirichlet-tent.json"), "rb").read()
    same("the formats", ["make", "a.json", "--quiet", *sum((["-o", "m." + e] for e in
         ("obj", "ply", "stl", "step", "vtu", "html")), [])], put=[("a.json", tent)])
    same("standard streams", ["make", "-", "-o", "-"], given=tent)
    same("names that are not ASCII", ["make", "fläche-面.json", "-o", "ö-面.json"], put=[("fläche-面.json", tent)])
    same("a file is replaced", ["make", "a.json", "-o", "m.json"], put=[("a.json", tent), ("m.json", b"old")])
    same("a folder that is not there", ["make", "a.json", "-o", "none/m.json"], put=[("a.json", tent)])
    same("no file", ["make", "none.json"])
    same("an ending", ["make", "a.json", "-o", "m.xyz"], put=[("a.json", tent)])
    same("two to one place", ["make", "a.json", "-o", "m.json", "-o", "./m.json"], put=[("a.json", tent)])
    same("not JSON", ["make", "a.json", "-o", "m.json"], put=[("a.json", b'{"taut": 1,\n  oops')])
    same("a member", ["make", "a.json"], put=[("a.json", tent.replace(b'"construct"', b'"konstruct"'))])
    same("a number", ["make", "a.json", "--tolerance", "1e-400"], put=[("a.json", tent)])
    same("a folder read", ["make", "."])
    same("help", ["--help"])
    same("help of make", ["make", "--help"])
    same("no command", ["mkae"])
    same("example", ["example", "pipe-run"])
    same("reproduce", ["reproduce"])


def refusals():
    """What is not there on Windows says so, in one line, leaves nothing, and ends with 5."""
    tent = open(os.path.join(source, "examples", "dirichlet-tent.json"), "rb").read()
    step = b"ISO-10303-21;\nEND-ISO-10303-21;\n"
    harmonic = next(n for n in sorted(os.listdir(os.path.join(source, "examples"))) if n.startswith("harmonic"))
    exact = open(os.path.join(source, "examples", harmonic), "rb").read()
    for words, put in ((["make", "a.json", "-o", "m.json", "-o", "m.pdf"], tent), (["make", "a.json", "-o", "m.png"], tent),
                       (["make", "a.json", "-o", "m.igs"], tent), (["convert", "a.step", "-o", "m.json"], step),
                       (["make", "a.json", "--exact", "-o", "m.json"], exact)):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, words[1]), "wb") as file:
                file.write(put)
            status, out, said = run(program, folder, words)
            left = os.listdir(folder)
            if status != 5 or b"Windows" not in said or said.count(b"\n") != 1 or left != [words[1]]:
                fail(f"{words}: {status}, {said!r}, {left}")


def closed_pipe():
    """Whoever reads may stop: one message, status 5."""
    tent = open(os.path.join(source, "examples", "dirichlet-tent.json"), "rb").read()
    with tempfile.TemporaryDirectory() as folder:
        read, write = os.pipe()
        os.close(read)
        done = subprocess.run(program + ["make", "-"], cwd=folder, input=tent, stdout=write, stderr=subprocess.PIPE, timeout=170)
        os.close(write)
        if done.returncode != 5 or b"cannot write standard input or output" not in done.stderr:
            fail(f"a closed pipe: {done.returncode}, {done.stderr!r}")


examples()
others()
refusals()
closed_pipe()
print(f"{len(failures)} failures")
sys.exit(1 if failures else 0)
