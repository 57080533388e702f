"""edit_iges.py IN OUT TYPE NTH CHANGE...: one entity of an IGES file changed, all lines counted again.

A change is INDEX=VALUE (a parameter, 0 the type), type=T (in both sections), or cut=N (the first N parameters only).
"""
import sys


def main(source, target, kind, nth, *changes):
    lines = [line for line in open(source, encoding="latin-1").read().split("\n") if line]
    sections = {letter: [line for line in lines if line[72] == letter] for letter in "SGDP"}
    entities = []
    for first, second in zip(sections["D"][::2], sections["D"][1::2]):
        start, count = int(first[8:16]), int(second[24:32])
        text = "".join(line[:64] for line in sections["P"][start - 1 : start - 1 + count])
        entities.append([first, second, text.rstrip().rstrip(";").split(",")])
    chosen = [entity for entity in entities if int(entity[0][:8]) == int(kind)][int(nth)]
    for change in changes:
        what, value = change.split("=")
        if what == "type":
            chosen[0], chosen[1], chosen[2][0] = f"{value:>8}" + chosen[0][8:], f"{value:>8}" + chosen[1][8:], value
        elif what == "cut":
            del chosen[2][int(value) :]
        else:
            chosen[2][int(what)] = value
    directory, parameters = [], []
    for number, (first, second, values) in enumerate(entities):
        rows, row = [], ""
        for k, value in enumerate(values):
            piece = value.strip() + (";" if k == len(values) - 1 else ",")
            if len(row) + len(piece) > 64:
                rows.append(row)
                row = ""
            row += piece
        rows.append(row)
        start = len(parameters) + 1
        parameters += [f"{r:<64} {2 * number + 1:7d}P{start + k:7d}" for k, r in enumerate(rows)]
        directory.append(f"{first[:8]}{start:8d}{first[16:72]}D{2 * number + 1:7d}")
        directory.append(f"{second[:24]}{len(rows):8d}{second[32:72]}D{2 * number + 2:7d}")
    counts = f"S{len(sections['S']):7d}G{len(sections['G']):7d}D{len(directory):7d}P{len(parameters):7d}"
    end = f"{counts:<72}T{1:7d}"
    open(target, "w", encoding="latin-1").write("\n".join([*sections["S"], *sections["G"], *directory, *parameters, end]) + "\n")


main(*sys.argv[1:])
