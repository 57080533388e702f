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


def area(points):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1])) / 2


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
    require(edges * (1 - 1e-5) <= around <= edges * (1 + 1e-12), f"{piece['name']} is {around} around, and its edges are {edges}")
    require(abs(area(points) - piece["flat_area"]) <= 1e-4 * piece["flat_area"], f"{piece['name']} has {area(points)}")
    require(texts[piece["name"]] == 1, f"{piece['name']} has no name")
    low = [min(p[d] for p in points) for d in range(2)]
    high = [max(p[d] for p in points) for d in range(2)]
    require(low[0] >= -1e-9 and low[1] >= -1e-9 and high[0] <= roll["length"] + 1e-9 and high[1] <= roll["width"] + 1e-9, f"{piece['name']} leaves the roll")
    require(all(abs(high[d] - low[d] - piece["extent"][d]) <= 2e-5 * roll["length"] for d in range(2)), f"extent of {piece['name']}")
    require(all(any(low[d] >= box[1][d] or high[d] <= box[0][d] for d in range(2)) for box in boxes), "two pieces on one place")
    boxes.append((low, high))
for seam in details["seams"]:
    for one, other in (seam["pieces"], seam["pieces"][::-1]):
        require(texts[f"{seam['name']}: {other}"] >= 1, f"{one} does not say who is beyond {seam['name']}")
svg = tree.parse(sys.argv[3]).getroot()
scale = {"mm": 1, "cm": 10, "m": 1000, "in": 25.4, "ft": 304.8}[model.get("unit", "mm")]
require(abs(float(svg.get("width")[:-2]) - scale * roll["length"]) < 1e-6 * scale, "width of the SVG")
groups = {g.get("id"): g for g in svg if g.get("id")}
require(len(groups["CUT"]) == len(lines["CUT"]), "outlines of the SVG")
first = [float(x) for x in groups["CUT"][0].get("d")[1:].split(" L")[0].split()]
where = lines["CUT"][0][1][0]
require(math.dist(first, (scale * where[0], scale * (roll["width"] - where[1]))) < 1e-6 * scale, "a place of the SVG")
print({layer: len(of) for layer, of in lines.items()}, sum(texts.values()))
