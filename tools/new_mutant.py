#!/usr/bin/env python3
"""new_mutant.py NAME CAUGHT-BY WHAT -- keeps the uncommitted change of src/ as a row of tests/mutants and undoes it.

The change must compile without a warning: what a compiler notices needs no test. The row takes the statements that changed,
and as many beside them as make them stand once in their file; look whether it can be shorter.
"""
import pathlib
import subprocess
import sys

import mutant_table
from mutant_table import Wrong

ROOT = pathlib.Path(__file__).resolve().parent.parent


def git(*arguments):
    """What git says."""
    return subprocess.run(["git", *arguments], cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout.decode()


def main(arguments):
    """The command line."""
    files = [name for name in git("diff", "--name-only", "-z", "--relative", "--", "src").split("\0") if name]
    if len(arguments) != 3 or not files:
        print("usage: break something in src/, then new_mutant.py NAME CAUGHT-BY WHAT", file=sys.stderr)
        return 2
    name, caught_by, what = arguments
    try:
        changes = []
        for file in files:
            if not (ROOT / file).is_file():
                raise Wrong(f"{file} is gone: a row changes text")
            before, after = git("show", f":./{file}"), (ROOT / file).read_bytes().decode()
            made = mutant_table.changes_of(file, before, after)
            if mutant_table.tokens(mutant_table.applied(file, before, made)) != mutant_table.tokens(after):
                raise Wrong(f"{file}: this change is beyond a row")
            changes += made
        if not changes:
            raise Wrong("nothing but blanks changed")
        table = "tests/mutants/" + mutant_table.table_of(changes[0].file)
        entry = mutant_table.entry_of(mutant_table.Row(name, what, changes, caught_by, table))
        rows = mutant_table.load(ROOT)
        if any(row.name == name for row in rows):
            raise Wrong(f"there is a mutant {name}")
        mutant_table.write(ROOT, rows + [mutant_table.row_of(entry, table)])
    except Wrong as wrong:
        print(f"new_mutant: {wrong}", file=sys.stderr)
        return 1
    git("checkout", "-q", "--", *files)
    print(table)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
