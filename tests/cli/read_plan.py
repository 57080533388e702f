"""read_plan.py MODEL.json PLAN.pdf PLAN.svg -- reads a plan of flat pieces on sheets of paper, as its bytes have it, and puts the sheets together: every
place of the SVG's lines is on a sheet, in its colour, where the sheet's number says; crosses of neighbours lie on each other; rulers are 100 mm long.
The sheets' numbers come from pdftotext. Prints how many sheets there are.
"""

import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as tree
import zlib

MARGIN, FOOT, OVERLAP = 10, 18, 10
POINT = 25.4 / 72


def require(holds, text):
    if not holds:
        sys.exit(text)


def contents(path):
    """The drawing operations of each page."""
    data = open(path, "rb").read()
    for found in re.finditer(rb"stream\r?\n", data):
        end = data.find(b"endstream", found.end())
        try:
            text = zlib.decompress(data[found.end():end]) if end > 0 else b""
        except zlib.error:
            continue
        if b" RG" in text and b" cm" in text:
            yield text.decode("latin-1")


def strokes(text):
    """(colour, points in mm from the upper left corner) of a page."""
    stack, colour, points, out = [], "", [], []
    for word in text.split():
        if word == "RG":
            colour = tuple(round(255 * float(x)) for x in stack[-3:])
        elif word in ("m", "l"):
            at = [POINT * float(x) for x in stack[-2:]]
            points = [at] if word == "m" else points + [at]
        elif word == "S":
            out.append((colour, points))
        if re.fullmatch(r"-?[0-9.]+", word):
            stack.append(word)
        else:
            stack = []
    return out


def away(at, line):
    best = math.inf
    for a, b in zip(line, line[1:]):
        square = math.dist(a, b) ** 2
        x = min(max(((at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1])) / square, 0), 1) if square > 0 else 0
        best = min(best, math.dist(at, [a[0] + x * (b[0] - a[0]), a[1] + x * (b[1] - a[1])]))
    return best


pages = list(contents(sys.argv[2]))
texts = subprocess.run(["pdftotext", "-layout", sys.argv[2], "-"], capture_output=True, text=True, check=True).stdout.split("\f")
sizes = re.findall(r"Page +\d+ size: +([0-9.]+) x ([0-9.]+)", subprocess.run(["pdfinfo", "-l", "9999", sys.argv[2]], capture_output=True, text=True, check=True).stdout)
numbers = [re.search(r"(\d+)\.(\d+): row (\d+) of (\d+), column (\d+) of (\d+)", text) for text in texts[:len(pages)]]
sheets, crosses = {}, {}
for page, number, size in zip(pages, numbers, sizes):
    if number is None:
        continue
    row, column = int(number[1]) - 1, int(number[2]) - 1
    require((row + 1, column + 1) == (int(number[3]), int(number[5])), number[0])
    paper = [POINT * float(x) for x in size]
    require(sorted(round(x) for x in paper) == [210, 297], f"a sheet of {paper} mm")
    step = [paper[0] - 2 * MARGIN - OVERLAP, paper[1] - MARGIN - FOOT - OVERLAP]
    move = [column * step[0] - MARGIN, row * step[1] - MARGIN]
    drawn = [(colour, [[x + move[0], y + move[1]] for x, y in points]) for colour, points in strokes(page)]
    black = [points for colour, points in drawn if colour == (0, 0, 0)]
    require(any(abs(math.dist(*line) - 100) < 0.01 for line in black if len(line) == 2), f"no ruler on sheet {number[0]}")
    for a, b in ([line for line in black if len(line) == 2 and abs(math.dist(*line) - 8) < 0.01]):
        crosses.setdefault((round((a[0] + b[0]) / 2), round((a[1] + b[1]) / 2)), []).append(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2))
    sheets[row, column] = drawn
require(len(sheets) > 3, f"{len(sheets)} sheets")
shared = [of for of in crosses.values() if len(of) > 2]
require(len(shared) >= len(sheets) / 2, "crosses of neighbours are not in one place")
require(all(math.dist(of[0], other) < 0.01 for of in crosses.values() for other in of), "crosses of neighbours are apart")
svg = tree.parse(sys.argv[3]).getroot()
places = 0
for group in svg:
    colour = tuple(int(group.get("stroke")[k:k + 2], 16) for k in (1, 3, 5))
    if colour == (0, 0, 0):
        continue
    of = [points for drawn in sheets.values() for ink, points in drawn if ink == colour]
    for path in group.iter("{http://www.w3.org/2000/svg}path"):
        points = [[float(x) for x in pair.split()] for pair in path.get("d").strip(" Z")[1:].split(" L")]
        for a, b in zip(points[::7], points[1::7]):
            at = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]
            require(min(away(at, line) for line in of) < 0.02, f"{group.get('id')}: nothing at {at} mm on the sheets")
            places += 1
print(f"{len(sheets)} sheets, {places} places")
