#!/usr/bin/env python3
"""errors.py TAUT EXAMPLES -- with --json what goes wrong is one line of JSON on standard error, for every command.

Each row: the words, the exit code, the reason, and what `where`, `found` and `expected` must be (... is anything).
"""
import json
import os
import subprocess
import sys
import tempfile

DOCUMENTS = {
    "broken.json": '{ "taut": 1,\n  "construct" }',
    "member.json": '{ "taut": 1, "construct": "dirichlet", "u": { "type": "bezier", "degre": 2 },'
                   ' "v": { "type": "bezier", "degree": 1 }, "points": [[null, null], [null, null]] }',
    "degree.json": '{ "taut": 1, "construct": "dirichlet", "u": { "type": "bezier", "degree": -3 },'
                   ' "v": { "type": "bezier", "degree": 1 }, "points": [[null, null], [null, null]] }',
    "nothing.json": '{ "taut": 1, "construct": "dirichlet", "u": { "type": "bezier", "degree": 1 },'
                    ' "v": { "type": "bezier", "degree": 1 }, "points": [[null, null], [null, null]] }',
    "shown.obj": "# a mesh\nv 0 0 0\n",
    "shown.PNG": "PNG",
    "noted.txt": "a note",
    "model.json": '{ "taut": 1, "curves": [ { "name": "c", "t": { "type": "bezier", "degree": 1 },'
                  ' "points": [[0, 0, 0], [1, 0, 0]] } ] }',
}

ROWS = [
    (["--json"], 2, "command", "", None, None),
    (["mke", "--json"], 2, "command", "", None, None),
    (["make", "--json"], 2, "operand", "", None, None),
    (["make", "--json", "--jason", "x.json"], 2, "option", "", None, None),
    (["make", "--json", "--threads", "0", "x.json"], 2, "value", "--threads 0", 0, "a whole number from 1 to 256"),
    (["make", "--json", "x.json", "-o", "x.what"], 2, "format", "x.what", None, None),
    (["make", "--json", "x.json", "-o", "a.json", "-o", "a.json"], 2, "option", "a.json", None, None),
    (["make", "--json", "absent.json"], 5, "read", "absent.json", None, None),
    (["make", "--json", "broken.json"], 3, "syntax", "broken.json:2:15", None, ...),
    (["make", "--json", "member.json"], 3, "unknown-member", "/u/degre", None, "\"degree\""),
    (["make", "--json", "degree.json"], 3, "value", "/u/degree", -3, "a whole number from 1 to 128"),
    (["make", "--json", "nothing.json"], 4, "nothing-known", "/points", 0, 1),
    (["make", "--json", "dirichlet-tent.json", "-o", "no/such/folder.json"], 5, "write", "no/such/folder.json", None, None),
    (["make", "--json", "dirichlet-tent.json", "--report", "no/such.json"], 5, "write", "no/such.json", None, None),
    (["make", "--json", "dirichlet-tent.json", "--exact"], 2, "no-rationals", "dirichlet-tent.json", None, None),
    (["certify", "--json", "broken.json"], 3, "syntax", "broken.json:2:15", None, ...),
    (["measure", "--json", "absent.json"], 5, "read", "absent.json", None, None),
    (["measure", "--json", "model.json", "--surface", "s"], 2, "name", "", None, None),
    (["join", "--json", "model.json", "u5", "model.json", "u0"], 2, "value", "", None, None),
    (["eval", "--json", "model.json", "--at", "x"], 2, "value", "--at x", None, "one number T"),
    (["eval", "--json", "model.json", "--at", "2"], 2, "range", "", 2, 1),
    (["split", "--json", "model.json", "--u", "x"], 2, "value", "--u x", None, "a number"),
    (["split", "--json", "absent.json", "--u", "1"], 5, "read", "absent.json", None, None),
    (["refine", "--json", "absent.json"], 5, "read", "absent.json", None, None),
    (["convert", "--json", "model.json"], 2, "option", "", None, None),
    (["convert", "--json", "model.json", "-o", "model.stl"], 4, "no-surface", ..., None, None),
    (["convert", "--json", "model.json", "-o", "no/such.json"], 5, "write", "no/such.json", None, None),
    (["view", "--json", "model.json", "-o", "model.obj"], 2, "format", "model.obj", None, None),
    (["view", "--json", "model.json", "-o", "no/such.html"], 5, "write", "no/such.html", None, None),
    (["panels", "--json", "model.json"], 2, "option", "", None, None),
    (["view", "--json", "absent.json", "-o", "x.html"], 5, "read", "absent.json", None, None),
    (["example", "--json", "nonesuch"], 2, "name", "", None, None),
    (["reproduce", "--json", "nonesuch"], 2, "name", "", None, None),
    (["schema", "--json", "nonesuch"], 2, "name", "", None, None),
]

MEMBERS = ["exit", "reason", "where", "message", "found", "expected"]


def check(taut, folder, row):
    words, code, reason, where, found, expected = row
    done = subprocess.run([taut, *words], cwd=folder, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)
    said = "taut %s: exit %d, %s" % (" ".join(words), done.returncode, done.stderr)
    lines = done.stderr.splitlines()
    if done.returncode != code or len(lines) != 1:
        return said
    error = json.loads(lines[0])["error"]
    wanted = {"exit": code, "reason": reason, "where": where, "found": found, "expected": expected}
    if list(error) != MEMBERS or not error["message"] or not error["reason"]:
        return said
    if any(value is not ... and error[name] != value for name, value in wanted.items()):
        return said
    # The sentence is the one that a person reads.
    plain = subprocess.run([taut, *[word for word in words if word != "--json"]], cwd=folder, capture_output=True,
                           text=True, timeout=60, stdin=subprocess.DEVNULL)
    if error["message"] not in plain.stderr and words != ["--json"]:
        return said + "    but without --json: " + plain.stderr
    return None


def check_report(taut, folder):
    """make --json: the model as without it, the report as JSON on standard error, nothing with --quiet."""
    plain = subprocess.run([taut, "make", "dirichlet-tent.json"], cwd=folder, capture_output=True, text=True, timeout=60)
    told = subprocess.run([taut, "make", "dirichlet-tent.json", "--json"], cwd=folder, capture_output=True, text=True,
                          timeout=60)
    quiet = subprocess.run([taut, "make", "dirichlet-tent.json", "--json", "--quiet"], cwd=folder, capture_output=True,
                           text=True, timeout=60)
    if told.returncode != 0 or told.stdout != plain.stdout or quiet.stderr != "":
        return "make --json: exit %d, %s" % (told.returncode, quiet.stderr)
    report = json.loads(told.stderr)
    if report["construct"] != "dirichlet" or report["certificate"]["holds"] is not True:
        return "make --json reports " + told.stderr
    with open(os.path.join(folder, "list.json"), "w", encoding="utf-8") as file:
        with open(os.path.join(folder, "dirichlet-tent.json"), encoding="utf-8") as one:
            file.write("[%s]" % one.read())
    told = subprocess.run([taut, "make", "list.json", "--json"], cwd=folder, capture_output=True, text=True, timeout=60)
    reports = json.loads(told.stderr)
    if len(reports) != 1 or reports[0]["construct"] != "dirichlet":
        return "make --json on a list reports " + told.stderr
    return None


def check_shown(taut, folder):
    """A mesh or a picture is no model: the message says what to give instead, and of other files it does not."""
    for name, is_shown in (("shown.obj", True), ("shown.PNG", True), ("broken.json", False), ("noted.txt", False)):
        for command in ("certify", "measure"):
            done = subprocess.run([taut, command, name], cwd=folder, capture_output=True, text=True, timeout=60)
            if done.returncode != 3 or ("give the .json" in done.stderr) != is_shown:
                return "%s %s: exit %d, %s" % (command, name, done.returncode, done.stderr)
    return None


def main():
    taut, examples = sys.argv[1], sys.argv[2]
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in DOCUMENTS.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        with open(os.path.join(examples, "dirichlet-tent.json"), "rb") as given:
            with open(os.path.join(folder, "dirichlet-tent.json"), "wb") as file:
                file.write(given.read())
        wrong = [check(taut, folder, row) for row in ROWS] + [check_report(taut, folder), check_shown(taut, folder)]
    wrong = [said for said in wrong if said is not None]
    for said in wrong:
        print("FAIL:", said)
    print("%d rows, %d wrong" % (len(ROWS), len(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
