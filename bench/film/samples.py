#!/usr/bin/env python3
"""samples.py TAUT -- Surface Evolver's sample files and the documents beside this program, as whole processes.

Prints a table: what each area is off by, and processor seconds, the middle one of five runs in turn. A document is made
as it is, and on the fewest points that are as near as Evolver. Areas are held against closed forms, or where there is
none (catbody, quad) against the document on finer spaces. Evolver runs each file's own commands, then Newton's steps on
finer elements, those of tests/cli/test_evolver_samples.sh.
"""

import json
import math
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile

RUNS = 5
FOLDER = "/usr/share/doc/evolver/examples"
FINER = "hessian\nlagrange 4\nhessian; hessian; hessian\n"
DROP, BALL, Z = (3 / (2 * math.pi)) ** (1 / 3), (3 / (4 * math.pi)) ** (1 / 3), 0.55
# Name, Evolver's commands, area of what is around the film there, pieces of the document, area, points that suffice
SAMPLES = (
    ("cat", "gogo4\n", 0, 1, 2 * math.pi * (Z + math.sinh(2 * Z) / 2), (14, 7)),
    ("catbody", "gogo\n" + FINER, 0, 1, None, (12, 8)),
    ("quad", "gogo\nlagrange 6\nhessian; hessian; hessian\n", 0, 1, None, (14, 14)),
    ("mound", "gogo\n" + FINER, 9, 4, 2 * math.pi * DROP**2, (6, 6)),
    ("cube", "gogo2\n", 0, 8, 4 * math.pi * BALL**2, (9, 9)),
)


def spaces(document, u, v):
    for patch in document.get("patches", [document]):
        patch["u"]["count"], patch["v"]["count"] = u, v
    return document


def run(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Taut:
    def __init__(self, taut, document, copies, folder):
        self.path, self.copies = os.path.join(folder, "model.json"), copies
        self.document = os.path.join(folder, "%d.json" % id(self))
        self.command = [taut, "make", self.document, "--quiet", "-o", self.path]
        with open(self.document, "w", encoding="utf-8") as file:
            json.dump(document, file)

    def measure(self):
        _, seconds = run(self.command)
        with open(self.path, encoding="utf-8") as file:
            certificate = json.load(file)["certificate"]
        assert not [claim for claim in certificate["claims"] if claim["holds"] is False], self.command
        return certificate["figures"]["area"] * self.copies, seconds


class Evolver:
    def __init__(self, name, commands, around, folder):
        path, self.around = os.path.join(folder, name + ".commands"), around
        self.command = ["evolver", "-x", "-f" + path, os.path.join(FOLDER, name + ".fe")]
        with open(path, "w", encoding="utf-8") as file:
            file.write('quiet\n%sprintf "\\nAREA %%.15g\\n", total_area\nq\nq\n' % commands)

    def measure(self):
        said, seconds = run(self.command)
        return float(re.findall(r"^AREA (\S+)", said, re.M)[-1]) - self.around, seconds


def main():
    taut = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/taut")
    here = os.path.join(os.path.dirname(os.path.abspath(__file__)), "samples")
    print("| sample | by | off by | seconds |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, commands, around, copies, area, few in SAMPLES:
            with open(os.path.join(here, name + ".json"), encoding="utf-8") as file:
                document = json.load(file)
            first = document.get("patches", [document])[0]
            whole = first["u"]["count"], first["v"]["count"]
            if area is None:
                finer = spaces(json.loads(json.dumps(document)), whole[0] + 8, whole[1] + 8)
                area, _ = Taut(taut, finer, copies, folder).measure()
            sides = [("Evolver", Evolver(name, commands, around, folder))]
            for points in dict.fromkeys((few, whole)):
                made = Taut(taut, spaces(document, *points), copies, folder)
                sides.append(("taut, %d x %d points" % points, made))
            found = [[] for _ in sides]
            for _ in range(RUNS):
                for runs, (_, side) in zip(found, sides):
                    runs.append(side.measure())
            for runs, (who, _) in zip(found, sides):
                off, seconds = runs[0][0] / area - 1, statistics.median(seconds for _, seconds in runs)
                print("| `%s` | %s | %.0e | %.2f |" % (name, who, abs(off), seconds), flush=True)


if __name__ == "__main__":
    main()
