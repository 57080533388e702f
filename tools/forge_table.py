#!/usr/bin/env python3
"""forge_table.py FOLDER -- adds up what forge_night.sh left there, and prints docs/bench/forgeries.md.

Of each construction the totals, of each kind of forgery the verdicts; the seeds and commits that they are of.
"""
import collections
import pathlib
import re
import sys

SUMMARY = re.compile(
    r"seed (\d+), (\d+) (forgeries|problems): (\d+) false holds; (\d+) claims judged, (\d+) without a judge; "
    r"(\d+) could not be built; (\d+) figures compared; slowest ([\d.]+) s"
)
ROW = re.compile(r"\| ([a-z-]+) \| ([^|]+) \| (alone|with the problem) \| (\d+) \| (\d+) \| (\d+) \| (\d+) \|")


def ranges(numbers):
    """1, 2, 3, 7 as 1 to 3, 7."""
    parts, numbers = [], sorted(numbers)
    while numbers:
        first = last = numbers.pop(0)
        while numbers and numbers[0] == last + 1:
            last = numbers.pop(0)
        parts.append(str(first) if first == last else f"{first} to {last}")
    return ", ".join(parts)


def read(folder):
    totals = collections.defaultdict(lambda: [0] * 7)
    verdicts = collections.defaultdict(lambda: [0] * 4)
    seeds = collections.defaultdict(set)
    commits = collections.defaultdict(set)
    for path in sorted(pathlib.Path(folder).glob("*.txt")):
        mode, construct, _ = path.name.split(".", 2)
        text = path.read_text()
        summary = SUMMARY.search(text)
        if summary is None:
            sys.exit(f"forge_table: {path} has no summary")
        numbers = [int(summary[k]) for k in (2, 4, 5, 6, 7, 8)]
        total = totals[mode, construct]
        for k, number in enumerate(numbers):
            total[k] += number
        total[6] = max(total[6], float(summary[9]))
        commit = re.search(r"^commit (\S+)$", text, re.M)
        seeds[mode, construct].add(int(summary[1]))
        commits[commit[1] if commit else "unknown"].add(int(summary[1]))
        for row in ROW.finditer(text):
            for k in range(4):
                verdicts[row[1], row[2].strip(), row[3]][k] += int(row[4 + k])
    return totals, verdicts, seeds, commits


def main():
    totals, verdicts, seeds, commits = read(sys.argv[1])
    print("# Forgeries\n")
    print("Written by `tools/forge_night.sh`, which adds to it: every seed is a fixed number of forgeries and problems of each")
    print("construction, and a seed, a construction and a number name one of them (`build/release/tests/forge --seed S --construct C")
    print("--only I`). What is forged and how it is judged: [trust.md](../trust.md#forgeries).\n")
    for commit, of in sorted(commits.items(), key=lambda item: min(item[1])):
        print(f"- seeds {ranges(of)}: commit `{commit}`")
    print("\n| construction | what | how many | seeds | false `holds` | claims judged | without a judge | could not be built "
          "| figures compared | slowest |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for mode, word in (("forge", "forgeries"), ("made", "problems")):
        whole = [0] * 6
        for (of, construct), total in sorted(totals.items()):
            if of == mode:
                whole = [a + b for a, b in zip(whole, total)]
                done, lies, judged, unjudged, impossible, figures, slowest = total
                print(f"| `{construct}` | {word} | {done:,} | {ranges(seeds[mode, construct])} | {lies} | {judged:,} | {unjudged:,} "
                      f"| {impossible:,} | {figures:,} | {slowest:.1f} s |")
        print(f"| all | {word} | {whole[0]:,} | | {whole[1]} | {whole[2]:,} | {whole[3]:,} | {whole[4]:,} | {whole[5]:,} | |")
    print("\nVerdicts of whole certificates. *Refused*: the certificate says that the model is none of the construction.\n")
    print("| construction | what was done | certified | holds | false | null | refused |")
    print("|---|---|---|---|---|---|---|")
    for (construct, what, how), v in sorted(verdicts.items()):
        print(f"| {construct} | {what} | {how} | {v[0]:,} | {v[1]:,} | {v[2]:,} | {v[3]:,} |")


main()
