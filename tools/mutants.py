#!/usr/bin/env python3
"""mutants.py -- shows that the tests notice when the code is wrong.

    tools/mutants.sh [PATTERN]        tries every row of tests/mutants/*.json, or those whose name matches PATTERN
    tools/mutants.sh --check [ROOT]   builds nothing: each row fits its file, each table is in order
    tools/mutants.sh --compile BUILD  tries nothing: each row compiles without a warning, as this build of its tree would
    tools/mutants.sh --tidy           brings the rows to their tables and in order, after files have moved

    MUTANTS_COUNT    try so many; each commit takes others (default: all are tried)
    MUTANTS_TREE     a clone of this commit whose build/release has passed its tests, to break in place (default: a copy
                     is built and tested first)

Every row breaks one thing, a sign, a bound, a certificate, and says which tests must fail (mutant_table.py has what a row is).
Each is applied to a copy of the tree, what those tests need is built, and they are run. A mutant that survives, does not
apply or does not build is a failure.
"""
import contextlib
import fnmatch
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys

import mutant_compile
import mutant_table
from mutant_table import Wrong

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / "build/mutants"  # logs, the copy of the tree and its build
ONE, ALL = 100, 1200  # seconds for the tests of one mutant, and for all on the unbroken tree


class Tree:
    """The sources that are broken, and their build. The tests' own time limits are made for slow builds: ours are shorter."""

    def __init__(self, tree, build):
        self.tree, self.build, self.tests = tree, build, []

    def list_tests(self):
        """Asks ctest what tests there are."""
        listed = subprocess.run(["ctest", "--test-dir", self.build, "-N"], stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, universal_newlines=True, check=False).stdout
        self.tests = re.findall(r"(?m)^ *Test *#[0-9]*: *(\S+)", listed)

    def matching(self, regex):
        """The tests whose names match."""
        return [test for test in self.tests if re.search(regex, test)]

    def compile(self, regex):
        """Builds what these tests need: test-unit-basis-bases for unit/basis/bases."""
        tests = [test for test in self.matching(regex) if not test.startswith("tools/")]
        targets = {"product" if test.startswith(("cli/", "viewer/")) else "test-" + test.replace("/", "-") for test in tests}
        return not targets or logged("build.log", ["cmake", "--build", self.build, "--target", *sorted(targets)])

    def test(self, regex, seconds):
        """Runs these tests."""
        return logged("tests.log", ["timeout", "-k", "5", str(seconds), "ctest", "--test-dir", self.build, "-R", regex,
                                    "-j", str(len(os.sched_getaffinity(0))), "--output-on-failure"])


def logged(log, command):
    """Whether the command succeeds; what it says goes to build/mutants."""
    with open(WORK / log, "w") as out:
        return subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False).returncode == 0


def said(log):
    """What a command said."""
    return (WORK / log).read_text(errors="replace")


def copied():
    """A copy of the tree, configured. Files that were broken last time are newer than the copy says, for the build's sake."""
    tree, build, touched = WORK / "tree", WORK / "build", WORK / "touched"
    shutil.rmtree(tree, ignore_errors=True)
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            stdout=subprocess.PIPE, check=True).stdout
    for name in filter(None, os.fsdecode(listed).split("\0")):
        if (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, tree / name)
    for name in touched.read_text().splitlines() if touched.exists() else []:
        if (tree / name).exists():
            os.utime(tree / name)
    touched.write_text("")
    if not logged("configure.log", ["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                                    "-DCMAKE_C_FLAGS_RELEASE=-O1 -DNDEBUG"]):
        raise Wrong(said("configure.log"))
    return Tree(tree, build)


@contextlib.contextmanager
def broken(tree, row):
    """The tree with a row applied, for as long as it takes."""
    texts = mutant_table.broken_files(tree, row)
    with open(WORK / "touched", "a") as touched:
        touched.writelines(f"{change.file}\n" for change in row.changes)
    kept = {path: path.read_bytes() for path in texts}
    try:
        for path, text in texts.items():
            path.write_bytes(text.encode())
        yield
    finally:
        for path, content in kept.items():
            path.write_bytes(content)


def problems(root, rows):
    """What is wrong with the rows, in lines."""
    for row in rows:
        try:
            mutant_table.broken_files(root, row)
        except Wrong as error:
            yield str(error)


def check(root):
    """The check that builds nothing."""
    rows = mutant_table.load(root)
    found = list(problems(root, rows)) or [f"tests/mutants/{name}: not in order (tools/mutants.sh --tidy)"
                                           for name in mutant_table.untidy(root, rows)]
    print("\n".join(found or [f"{len(rows)} mutants, each fits its file"]))
    return 1 if found else 0


def check_compiled(build):
    """The check that runs the compiler's front end alone."""
    rows = mutant_table.load(build.resolve().parent.parent)
    found = mutant_compile.complaints(rows, build)
    print("\n".join(found or [f"{len(rows)} mutants, each compiles without a warning"]))
    return 1 if found else 0


def chosen(pattern, count):
    """The rows whose name matches; so many of them, in an order of each commit's own, so that all have a turn."""
    rows = [row for row in mutant_table.load(ROOT) if fnmatch.fnmatchcase(row.name, f"*{pattern}*")]
    if not rows:
        raise Wrong(f'mutants: no row matches "{pattern}"')
    if count > 0:
        salt = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              universal_newlines=True, check=False).stdout.strip()
        rows.sort(key=lambda row: hashlib.sha1((salt + row.name).encode()).hexdigest())
        del rows[count:]
    return rows


def verdict_of(tree, row):
    """What becomes of a mutant."""
    with broken(tree.tree, row):
        if not tree.compile(row.caught_by):
            print("\n".join([line for line in said("build.log").splitlines() if "error" in line][:3]))
            return "DOES NOT BUILD"
        return "SURVIVED" if tree.test(row.caught_by, ONE) else "caught"


def run(pattern):
    """Tries the mutants that match."""
    given = os.environ.get("MUTANTS_TREE")
    rows = chosen(pattern, int(os.environ.get("MUTANTS_COUNT") or 0))
    WORK.mkdir(parents=True, exist_ok=True)
    tree = Tree(pathlib.Path(given).resolve(), pathlib.Path(given).resolve() / "build/release") if given else copied()
    tree.list_tests()
    found = list(problems(tree.tree, rows))
    found += [f"{row.table}: {row.name}: no test matches {row.caught_by}" for row in rows if not tree.matching(row.caught_by)]
    if found:
        raise Wrong("\n".join(found))

    # Unbroken, all the tests named must pass, or catching a mutant would mean nothing.
    named = "|".join(dict.fromkeys(row.caught_by for row in rows))
    if not tree.compile(named):
        raise Wrong(said("build.log"))
    useless = []
    if not given and not tree.test(named, ALL):
        useless = re.findall(r"(?m)^\s*[0-9]+ - (\S+) ", said("tests.log").partition("tests FAILED:")[2])
        print("Failing in the unbroken tree, so that they can catch nothing:", *useless, sep="\n", flush=True)

    failed = 0
    for row in rows:
        what = row.what
        if any(re.search(row.caught_by, test) for test in useless):
            verdict, what = "UNKNOWN", "its tests fail on the unbroken tree"
        else:
            verdict = verdict_of(tree, row)
        failed += verdict != "caught"
        print(f"{row.name:<34} {verdict:<10} {what}", flush=True)
    print(f"{len(rows)} mutants tried, {failed} not caught")
    return 1 if failed else 0


def main(arguments):
    """The command line."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the tree is mended when time runs out
    try:
        if arguments[:1] == ["--check"] and len(arguments) <= 2:
            return check(pathlib.Path(arguments[1] if len(arguments) > 1 else ROOT))
        if arguments[:1] == ["--compile"] and len(arguments) == 2:
            return check_compiled(pathlib.Path(arguments[1]))
        if arguments == ["--tidy"]:
            mutant_table.write(ROOT, mutant_table.load(ROOT))
            return 0
        if len(arguments) > 1 or arguments[:1] == ["--help"] or any(argument.startswith("-") for argument in arguments):
            print(__doc__, file=sys.stderr)
            return 2
        return run("".join(arguments))
    except Wrong as error:
        print(error, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
