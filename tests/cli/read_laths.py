"""read_laths.py MODEL.json FILE.dxf FILE.svg -- reads drawings of laths to cut, and compares them with the model: outlines closed and as long as the
laths are cut, slots where they are to be, names, everything on its sheet; the SVG the same in millimetres. Prints a count a layer.
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


def near(a, b, size):
    return abs(a - b) <= 1e-9 * size


model = json.load(open(sys.argv[1]))
details = model["details"]
drawing = ezdxf.readfile(sys.argv[2])
found = drawing.audit()
require(not found.errors and not found.fixes, f"ezdxf finds {found.errors} {found.fixes}")
require(drawing.dxfversion == "AC1009", drawing.dxfversion)
space = drawing.modelspace()
lines = {}
for entity in space.query("POLYLINE"):
    lines.setdefault(entity.dxf.layer, []).append((entity.is_closed, [tuple(v.dxf.location)[:2] for v in entity.vertices]))
texts = Counter(entity.dxf.text for entity in space.query("TEXT"))

laths = {lath["name"]: lath for lath in details["laths"]}
pieces = details["pieces"]
sheet = details["sheets"][0]["size"]
step = sheet[0] + 0.1 * max(sheet)
require(len(lines["SHEET"]) == len(details["sheets"]), "sheets")
require(len(lines["CUT"]) == len(pieces), "outlines")
long = Counter()
for piece, (closed, points) in zip(pieces, lines["CUT"]):
    shift = (piece["sheet"] - 1) * step
    require(closed and len(points) == len(piece["outline"]), f"{piece['name']} is not closed")
    for p, q in zip(points, piece["outline"]):
        require(near(p[0], q[0] + shift, sheet[0]) and near(p[1], q[1], sheet[0]), f"{piece['name']} {p} {q}")
        require(0 <= q[0] <= sheet[0] and 0 <= q[1] <= sheet[1], f"{piece['name']} leaves the sheet")
    if len(points) == 4:
        around = sum(math.dist(points[k], points[k - 1]) for k in range(4))
        long[piece["lath"]] += around / 2 - laths[piece["lath"]]["width"]
    require(texts[piece["name"]] >= 2, f"{piece['name']} has no name at both ends")
for name, length in long.items():
    require(near(length, laths[name]["cut_length"], length), f"{name} is {length} long, and cut {laths[name]['cut_length']}")
slots = [(piece, slot) for piece in pieces for slot in piece["slots"]]
for piece, slot in slots:  # no letter, 0.7 as broad as high, nearer to a slot than a fifth of its height
    for text in piece["texts"]:
        c, s, high = math.cos(text["angle"]), math.sin(text["angle"]), text["height"]
        spots = [[(p[0] - text["at"][0]) * w[0] + (p[1] - text["at"][1]) * w[1] for p in slot["outline"]] for w in ((c, s), (-s, c))]
        apart = [max(min(spot), -max(spot), 0) - half for spot, half in zip(spots, (0.35 * high * len(text["text"]), 0.5 * high))]
        require(max(apart) >= 0.2 * high, f"{text['text']} is on the slot {slot['node']} of {piece['name']}: {max(apart) / high:.3f}")
require(len(slots) == len(lines.get("SLOT", [])), "slots")
before = Counter()
for piece, (closed, points) in zip(pieces, lines["CUT"]):
    if len(points) != 4:
        continue
    low = [min(p[d] for p in piece["outline"]) for d in range(2)]
    for slot in piece["slots"]:
        told = next(s for s in laths[piece["lath"]]["slots"] if s["node"] == slot["node"])
        x = [p[0] - low[0] + before[piece["lath"]] for p in slot["outline"]]
        y = [p[1] - low[1] for p in slot["outline"]]
        width = laths[piece["lath"]]["width"]
        require(near(sum(x) / 4, told["at"], sheet[0]), f"{slot['node']} is at {sum(x) / 4}, not {told['at']}")
        require(near(max(x) - min(x), told["width"], sheet[0]), f"{slot['node']} is not as wide")
        require(near(max(y) - min(y), told["depth"], sheet[0]), f"{slot['node']} is not as deep")
        require(near(max(y) if told["from"] == "n" else width - min(y), width, sheet[0]), f"{slot['node']} from the wrong side")
    before[piece["lath"]] += max(p[0] for p in piece["outline"]) - low[0]

root = tree.parse(sys.argv[3]).getroot()
scale = {"mm": 1, "cm": 10, "m": 1000, "in": 25.4, "ft": 304.8}[model.get("unit", "mm")]
wide = step * (len(details["sheets"]) - 1) + sheet[0]
require(near(float(root.get("width").removesuffix("mm")), wide * scale, wide * scale), "width of the SVG")
require(root.get("viewBox").split()[2] == root.get("width").removesuffix("mm"), "the SVG is not 1:1")
name = "{http://www.w3.org/2000/svg}"
for group in root.findall(f"{name}g"):
    layer = group.get("id")
    paths = group.findall(f"{name}path")
    require(len(paths) == len(lines.get(layer, [])), f"{layer}: {len(paths)} paths in the SVG")
    for path, (closed, points) in zip(paths, lines.get(layer, [])):
        words = path.get("d").replace("M", "").replace("L", "").replace("Z", "").split()
        for k, p in enumerate(points):
            require(near(float(words[2 * k]), p[0] * scale, wide * scale), f"{layer}: {words[2 * k]} is not {p[0]}")
            require(near(float(words[2 * k + 1]), (sheet[1] - p[1]) * scale, wide * scale), f"{layer}: {words[2 * k + 1]} is not {p[1]}")
require(len(list(root.iter(f"{name}text"))) == sum(texts.values()), "texts of the SVG")
for layer in sorted(lines):
    print(layer, len(lines[layer]))
print("TEXT", sum(texts.values()))
