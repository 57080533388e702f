#!/usr/bin/env python3
"""claims_table.py -- what the claims of all examples come to: the second table of docs/certificate.md.

    tools/claims_table.py TAUT            prints the table
    tools/claims_table.py TAUT --write    puts it into docs/certificate.md, between its two marks
    tools/claims_table.py TAUT --check    fails where a claim is missing there, its kind is another, or no row says what it is

TAUT is the program, such as build/release/bin/taut. For each construction and claim: its kind, how many examples carry it, the
largest residual among those that hold, and how far it stays below its limit at least (limit over residual; for claims
that must be above a limit, residual over limit), and how many mutants break what it is judged by (tools/claim_mutants.py).
Residuals of rounding differ from machine to machine.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys

import claim_mutants

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/certificate.md"
BEGIN, END = "<!-- claims: made by tools/claims_table.py -->", "<!-- end of claims -->"
ABOVE = ("regular", "stable", "positive-weights", "graph", "no-fold")  # claims that hold above their limit


def claims_of(taut):
    """(construction, claim) -> [(example, claim)]; and the examples that do not hold."""
    found = collections.defaultdict(list)
    for line in subprocess.run([taut, "example"], stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout.splitlines():
        if not line.strip():
            continue
        name = line.split()[0]
        problem = subprocess.run([taut, "example", name], stdout=subprocess.PIPE, check=True).stdout
        made = subprocess.run([taut, "make", "-", "--quiet"], input=problem, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              check=False).stdout
        if not made:
            continue
        models = json.loads(made)
        for model in models if isinstance(models, list) else [models]:
            certificate = model["certificate"]
            for claim in certificate["claims"]:
                found[certificate["construct"], claim["claim"]].append((name, claim))
    return found


def row_of(construct, name, entries, mutants):
    """One row of the table."""
    holding = [(e, c) for e, c in entries if c["holds"] is True]
    kinds = sorted({c["kind"] for _, c in entries})
    open_ = sum(c["holds"] is None for _, c in entries)
    false = [e for e, c in entries if c["holds"] is False]
    if name in ABOVE:
        worst = min(holding, key=lambda x: x[1]["residual"], default=None)
        room = worst and worst[1]["residual"] / worst[1]["limit"] if worst and worst[1]["limit"] else None
    else:
        worst = max(holding, key=lambda x: x[1]["residual"], default=None)
        rooms = [c["limit"] / c["residual"] for _, c in holding if c["residual"] > 0]
        room = min(rooms, default=None)
    count = f"{len(entries)}" + (f", {open_} undecided" if open_ else "") + (f", {len(false)} false by design" if false else "")
    residual = f"{worst[1]['residual']:.1e} (`{worst[0]}`)" if worst and worst[1]["residual"] else "0" if worst else ""
    return f"| {construct} | `{name}` | {', '.join(kinds)} | {count} | {residual} | {'%.2g' % room if room else ''} | {mutants} |"


def table(found):
    """The whole table."""
    lines = ["| construction | claim | kind | examples | largest residual | room | mutants |", "|---|---|---|---|---|---|---|"]
    mutants, _ = claim_mutants.counts(claim_mutants.ROOT, found)
    return "\n".join(lines + [row_of(c, n, entries, len(mutants[c, n])) for (c, n), entries in sorted(found.items())])


def explained(text):
    """The pairs (construction, claim) that the table of what claims say has rows of."""
    pairs, constructs = set(), []
    for cells in (line.split("|") for line in text.splitlines() if line.startswith("| ")):
        constructs = re.findall("`([^`]+)`", cells[1]) or (constructs if not cells[1].strip() else [])
        pairs |= {(c, n) for c in constructs for n in re.findall("`([^`]+)`", cells[2])}
    return pairs


def main(arguments):
    """The command line."""
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    found = claims_of(arguments[0])
    made = table(found)
    if arguments[1:] == []:
        print(made)
        return 0
    page = PAGE.read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    old, _, after = rest.partition(END)
    if arguments[1] == "--write":
        PAGE.write_text(f"{before}{BEGIN}\n\n{made}\n\n{END}{after}", encoding="utf-8")
        return 0
    missing = [f"{c} {n}: not in docs/certificate.md as {kind}" for (c, n), entries in found.items()
               for kind in {e[1]["kind"] for e in entries}
               if not any(line.startswith(f"| {c} | `{n}` |") and kind in line.split("|")[3] for line in old.splitlines())]
    told = explained(before.partition("## All claims")[2].partition("\n## ")[0])
    missing += [f"{c} {n}: docs/certificate.md does not say what it says" for c, n in found if n != "identity" and (c, n) not in told]
    print("\n".join(missing or [f"{len(found)} claims, each as docs/certificate.md has it"]))
    return 1 if missing else 0


sys.exit(main(sys.argv[1:]))
