"""program.py -- what the Python parts of the command line tests share: TAUT is the program, SOURCE the source tree."""

import json
import os
import subprocess
import sys

SOURCE = os.environ["SOURCE"]
failures = 0


def complain(what):
    global failures
    failures += 1
    print("FAILED:", what, file=sys.stderr)


def run(*words):
    """Exit code, what was printed, what was said on standard error."""
    done = subprocess.run([os.environ["TAUT"], *words], capture_output=True)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def save(path, document):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)


def example(name):
    return load(os.path.join(SOURCE, "examples", name + ".json"))


def finish():
    sys.exit(failures != 0)
