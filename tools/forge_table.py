#!/usr/bin/env python3
"""forge_table.py FOLDER -- adds what forge_night.sh left in FOLDER to docs/bench/forgeries.json, and writes docs/bench/forgeries.md of it.

Kept are the totals of each construction, the verdicts of each kind of forgery, and under which commit each seed was done: a seed is
counted once. With --done it prints what has been counted, a line `MODE CONSTRUCT SEED` each. To begin anew, delete the JSON.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent / "docs" / "bench"
KEPT = ROOT / "forgeries.json"
PAGE = ROOT / "forgeries.md"
SUMMARY = re.compile(
    r"seed (\d+), (\d+) (forgeries|problems): (\d+) false holds; (\d+) claims judged, (\d+) without a judge; "
    r"(\d+) could not be built; (\d+) figures compared; slowest ([\d.]+) s"
)
ROW = re.compile(r"\| ([a-z-]+) \| ([^|]+) \| (alone|with the problem) \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|")
COUNTS = ("done", "false", "judged", "unjudged", "unbuilt", "figures")


def ranges(numbers):
    """1, 2, 3, 7 as 1 to 3, 7."""
    parts, numbers = [], sorted(numbers)
    while numbers:
        first = last = numbers.pop(0)
        while numbers and numbers[0] == last + 1:
            last = numbers.pop(0)
        parts.append(str(first) if first == last else f"{first} to {last}")
    return ", ".join(parts)


def load():
    if KEPT.exists():
        return json.loads(KEPT.read_text())
    return {"seeds": {}, "totals": {}, "verdicts": {}}


def add(kept, path):
    """Adds the results of one seed, construction and mode, unless they are in already."""
    mode, construct, _ = path.name.split(".", 2)
    text = path.read_text()
    summary = SUMMARY.search(text)
    if summary is None:
        sys.exit(f"forge_table: {path} has no summary")
    key = f"{mode} {construct}"
    seeds = kept["seeds"].setdefault(key, {})
    if summary[1] in seeds:
        return
    commit = re.search(r"^commit (\S+)$", text, re.M)
    seeds[summary[1]] = commit[1] if commit else "unknown"
    total = kept["totals"].setdefault(key, dict.fromkeys(COUNTS, 0) | {"slowest": 0.0})
    for k, name in zip((2, 4, 5, 6, 7, 8), COUNTS):
        total[name] += int(summary[k])
    total["slowest"] = max(total["slowest"], float(summary[9]))
    for row in ROW.finditer(text):
        verdicts = kept["verdicts"].setdefault(f"{row[1]} | {row[2].strip()} | {row[3]}", [0, 0, 0, 0])
        for k in range(4):
            verdicts[k] += int(row[4 + k])


def save(kept):
    lines = []
    for part in ("seeds", "totals", "verdicts"):
        rows = [f"    {json.dumps(key)}: {json.dumps(kept[part][key])}" for key in sorted(kept[part])]
        lines.append(f'  "{part}": {{\n' + ",\n".join(rows) + "\n  }")
    KEPT.write_text("{\n" + ",\n".join(lines) + "\n}\n")


def page(kept):
    commits = {}
    for seeds in kept["seeds"].values():
        for seed, commit in seeds.items():
            commits.setdefault(commit, set()).add(int(seed))
    lines = ["# Forgeries", "",
             "Written by `tools/forge_night.sh`, which adds to it: every seed is a fixed number of forgeries and problems of each",
             "construction, and a seed, a construction and a number name one of them (`build/release/tests/forge --seed S --construct C",
             "--only I`). What is forged and how it is judged: [trust.md](../trust.md#forgeries). A seed is counted once, with the commit that",
             "it was done with.", ""]
    lines += [f"- commit `{commit}`: seeds {ranges(of)}" for commit, of in sorted(commits.items(), key=lambda item: min(item[1]))]
    lines += ["", "| construction | what | how many | seeds | false `holds` | claims judged | without a judge | could not be built "
              "| figures compared | slowest |", "|---|---|---|---|---|---|---|---|---|---|"]
    for mode, word in (("forge", "forgeries"), ("made", "problems")):
        whole = dict.fromkeys(COUNTS, 0)
        for key in sorted(kept["totals"]):
            of, construct = key.split(" ")
            if of != mode:
                continue
            total = kept["totals"][key]
            for name in COUNTS:
                whole[name] += total[name]
            counts = " | ".join(f"{total[name]:,}" for name in COUNTS[1:])
            seeds = ranges(int(seed) for seed in kept["seeds"][key])
            lines.append(f"| `{construct}` | {word} | {total['done']:,} | {seeds} | {counts} | {total['slowest']:.1f} s |")
        counts = " | ".join(f"{whole[name]:,}" for name in COUNTS[1:])
        lines.append(f"| all | {word} | {whole['done']:,} | | {counts} | |")
    lines += ["", "Verdicts of whole certificates. *Refused*: the certificate says that the model is none of the construction.", "",
              "| construction | what was done | certified | holds | false | null | refused |", "|---|---|---|---|---|---|---|"]
    lines += [f"| {key} | " + " | ".join(f"{v:,}" for v in kept["verdicts"][key]) + " |" for key in sorted(kept["verdicts"])]
    PAGE.write_text("\n".join(lines) + "\n")


def main():
    kept = load()
    if sys.argv[1] == "--done":
        for key, seeds in kept["seeds"].items():
            for seed in seeds:
                print(key, seed)
        return
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.txt")):
        add(kept, path)
    save(kept)
    page(kept)


main()
