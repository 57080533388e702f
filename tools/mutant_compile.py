"""mutant_compile.py -- does each mutant compile without a warning? Where warnings are errors, one that does not is no mutant.

Without optimisation, else as a build's compile_commands.json says: a minute for all rows where trying them takes three quarters of
an hour. (The front end alone does not tell of constants that nothing uses any more.)
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import tempfile

import mutant_table


def commands_of(build, root):
    """How the build compiles each of its sources: path below root, list of arguments up to the source."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["directory"], entry["file"])
        if root in source.parents and source.is_file():
            arguments = shlex.split(entry["command"])
            del arguments[arguments.index("-o"):]
            commands.setdefault(str(source.relative_to(root)), (entry["directory"], arguments))
    return commands


def reader_of(header, commands, root):
    """A source that includes the header itself, the one that is named like it first."""
    line = f'#include "{header[len("src/"):]}"' if header.startswith("src/") else f'#include <{header[len("include/"):]}>'
    own = header[:-1] + "c"
    return next((source for source in sorted(commands, key=lambda name: (name != own, name))
                 if line in (root / source).read_text()), None)


def complaint(row, commands, root):
    """What the compiler says against a row, or None."""
    with tempfile.TemporaryDirectory() as folder:
        overlay = pathlib.Path(folder)
        texts = {str(path.relative_to(root)): text for path, text in mutant_table.broken_files(root, row).items()}
        for name, text in texts.items():
            (overlay / name).parent.mkdir(parents=True, exist_ok=True)
            (overlay / name).write_text(text)
        for name in texts:
            source = name if name in commands else reader_of(name, commands, root) if name.endswith(".h") else None
            if source is None:
                continue  # no C, or what this build leaves out
            directory, arguments = commands[source]
            path = overlay / source if source in texts else root / source
            said = subprocess.run([arguments[0], f"-I{overlay}/src", f"-I{overlay}/include", *arguments[1:], "-Werror",
                                   "-O0", "-Wno-frame-larger-than", "-S", "-o", os.devnull, f"-I{(root / source).parent}", str(path)], cwd=directory,
                                  stderr=subprocess.PIPE, universal_newlines=True, check=False)
            if said.returncode != 0:
                errors = [line for line in said.stderr.splitlines() if "error" in line] or [said.stderr]
                return f"{row.table}: {row.name}: does not compile: {errors[0].replace(folder + '/', '')}"
    return None


def complaints(rows, build):
    """What the compiler says against the rows of the tree that build is the build of, in lines."""
    build = build.resolve()
    root = build.parent.parent
    commands = commands_of(build, root)
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return [line for line in pool.map(lambda row: complaint(row, commands, root), rows) if line]
