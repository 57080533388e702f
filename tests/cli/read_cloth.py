"""read_cloth.py MODEL.json FILE.dxf FILE.svg -- reads drawings of cloth to cut, and compares them with the model: outlines closed, as long around as
the edges of the pieces, with their areas, apart from each other on the roll; names; the SVG the same in millimetres. Prints a count a layer.
"""

import json
import math
import sys
import xml.etree.ElementTree as tree
from collections import Counter

import ezdxf


def require(holds, text):
    if not holds:
        sys.exit(text)


def along(line, place):
    best, far, sum_ = 0, math.inf, 0
    for a, b in zip(line, line[1:]):
        length = math.dist(a, b)
        x = min(max(((place[0] - a[0]) * (b[0] - a[0]) + (place[1] - a[1]) * (b[1] - a[1])) / length**2, 0), 1)
        away = math.dist(place, [a[0] + x * (b[0] - a[0]), a[1] + x * (b[1] - a[1])])
        best, far = (sum_ + x * length, away) if away < far else (best, far)
        sum_ += length
    return best, far


def area(points):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1])) / 2


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def meet(one, other):
    """Do two closed polygons cross, or is the first place of one inside the other?"""
    for a, b in zip(one, one[1:] + one[:1]):
        for c, d in zip(other, other[1:] + other[:1]):
            if cross(a, b, c) * cross(a, b, d) < 0 and cross(c, d, a) * cross(c, d, b) < 0:
                return True
    inside = lambda p, line: sum((a[1] > p[1]) != (b[1] > p[1]) and a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > p[0]
                                 for a, b in zip(line, line[1:] + line[:1])) % 2
    return inside(one[0], other) or inside(other[0], one)


model = json.load(open(sys.argv[1]))
details = model["details"]
drawing = ezdxf.readfile(sys.argv[2])
found = drawing.audit()
require(not found.errors and not found.fixes, f"ezdxf finds {found.errors} {found.fixes}")
require(drawing.dxfversion == "AC1009", drawing.dxfversion)
require({layer.dxf.name for layer in drawing.layers} >= {"CUT", "SEW", "FOLD", "MARK", "TEXT", "ROLL"}, "layers")
space = drawing.modelspace()
lines = {}
for entity in space.query("POLYLINE"):
    lines.setdefault(entity.dxf.layer, []).append((entity.is_closed, [tuple(v.dxf.location)[:2] for v in entity.vertices]))
texts = Counter(entity.dxf.text for entity in space.query("TEXT"))
roll = details["roll"]
require(len(lines["ROLL"]) == 1 and len(lines["CUT"]) == len(details["pieces"]), "outlines")
boxes = []
for piece, (closed, points) in zip(details["pieces"], lines["CUT"]):
    around = sum(math.dist(points[k], points[k - 1]) for k in range(len(points)))
    edges = sum(edge["flat_length"] for edge in piece["edges"].values())
    require(closed, f"{piece['name']} is open")
    left = any("allowance" in edge for edge in piece["edges"].values())
    require(left or edges * (1 - 1e-5) <= around <= edges * (1 + 1e-12), f"{piece['name']} is {around} around, and its edges are {edges}")
    require(abs(area(points) - piece["cut_area"]) <= 1e-4 * piece["cut_area"], f"{piece['name']} has {area(points)}")
    require(texts[piece["name"]] == 1, f"{piece['name']} has no name")
    low = [min(p[d] for p in points) for d in range(2)]
    high = [max(p[d] for p in points) for d in range(2)]
    require(low[0] >= -1e-9 and low[1] >= -1e-9 and high[0] <= roll["length"] + 1e-9 and high[1] <= roll["width"] + 1e-9, f"{piece['name']} leaves the roll")
    require(all(abs(high[d] - low[d] - piece["extent"][d]) <= 2e-5 * roll["length"] for d in range(2)), f"extent of {piece['name']}")
    for box in boxes:
        is_apart = any(low[d] >= box[1][d] or high[d] <= box[0][d] for d in range(2))
        require(is_apart or not meet(points, box[2]), f"{piece['name']} and another one on one place")
    boxes.append((low, high, points))
for seam in details["seams"]:
    for one, other in (seam["pieces"], seam["pieces"][::-1]):
        require(texts[f"{seam['name']}: {other}"] >= 1, f"{one} does not say who is beyond {seam['name']}")
# lines to sew, from piece to piece, and what is left beyond them; marks of both sides of a seam at equal lengths along them
sewn = dict(zip([(p["name"], e) for p in details["pieces"] for e in ("right", "end", "left", "start")], [line for _, line in lines.get("SEW", [])]))
for (piece, edge), line in sewn.items():
    told = next(p for p in details["pieces"] if p["name"] == piece)["edges"][edge]
    long = sum(math.dist(*pair) for pair in zip(line, line[1:]))
    require(told["flat_length"] * (1 - 1e-5) <= long <= told["flat_length"] * (1 + 1e-12), f"{piece}.{edge} is {long} long")
    outline = lines["CUT"][[p["name"] for p in details["pieces"]].index(piece)][1]
    near = along(outline, line[len(line) // 2])[1]
    require(abs(near - told["allowance"]) < 1e-4, f"{piece}.{edge}: {near} is left, not {told['allowance']}")


slits = [line for _, line in lines["MARK"] if len(line) == 2]
for seam in details["seams"] if sewn else []:
    sides = []
    for piece in details["pieces"]:
        for edge in ("right", "left"):
            if piece["edges"][edge].get("seam") == seam["name"]:
                found = [along(sewn[piece["name"], edge], slit[0]) for slit in slits]
                sides.append(sorted(x for x, away in found if away < 1e-4))
    require(len(sides) == 2 and len(sides[0]) == len(sides[1]) == len(seam["marks"]), f"marks of {seam['name']}: {sides}")
    require(all(abs(a - b) < 1e-4 for a, b in zip(*sides)), f"marks of {seam['name']} do not meet: {sides}")
svg = tree.parse(sys.argv[3]).getroot()
scale = {"mm": 1, "cm": 10, "m": 1000, "in": 25.4, "ft": 304.8}[model.get("unit", "mm")]
require(abs(float(svg.get("width")[:-2]) - scale * roll["length"]) < 1e-6 * scale, "width of the SVG")
groups = {g.get("id"): g for g in svg if g.get("id")}
require(len(groups["CUT"]) == len(lines["CUT"]), "outlines of the SVG")
first = [float(x) for x in groups["CUT"][0].get("d")[1:].split(" L")[0].split()]
where = lines["CUT"][0][1][0]
require(math.dist(first, (scale * where[0], scale * (roll["width"] - where[1]))) < 1e-6 * scale, "a place of the SVG")
print({layer: len(of) for layer, of in lines.items()}, sum(texts.values()))
