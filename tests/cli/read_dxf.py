"""read_dxf.py MODEL.json FILE.dxf -- reads a drawing with ezdxf, and compares it with the model, number by number.

Curves on polynomial and rational bases: the same points, knots and weights, bit for bit; others: their lengths. Panels: each side
and each diagonal as long as in space, none over another. Prints what there is: "UNIT n", "KIND LAYER count".
"""

import json
import math
import sys
from collections import Counter

import ezdxf


def require(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


def name_of(entity):
    return next((tag.value for tag in entity.get_xdata("TAUT") if tag.code == 1000), "") if entity.has_xdata("TAUT") else ""


def knots_of(basis):
    if basis["type"] == "bspline":
        return basis["knots"]
    lo, hi = basis.get("range", [0, 1])
    return [lo] * (basis["degree"] + 1) + [hi] * (basis["degree"] + 1)


def check_curve(entity, curve):
    basis, points, name = curve["t"], [tuple(p) for p in curve["points"]], curve.get("name")
    if basis["type"] not in ("bezier", "bspline"):
        require(entity.dxftype() == "SPLINE" and len(entity.control_points) > len(points), f"{name}: {entity.dxftype()}")
        require(math.dist(entity.control_points[0], points[0]) < 1e-9 * (1 + math.dist(points[0], points[-1])), f"{name}: where it begins")
    elif entity.dxftype() == "LINE":
        require([tuple(entity.dxf.start), tuple(entity.dxf.end)] == points, f"{name}: a line")
    elif entity.dxftype() == "POLYLINE":
        require(basis["degree"] == 1 and [tuple(v.dxf.location) for v in entity.vertices] == points, f"{name}: a polyline")
    else:
        require(entity.dxf.degree == basis["degree"] and list(entity.knots) == knots_of(basis), f"{name}: knots")
        require([tuple(p) for p in entity.control_points] == points, f"{name}: points")
        require(list(entity.weights) == curve.get("weights", []), f"{name}: weights")


def check_curves(model, entities):
    require(len(entities) == len(model["curves"]), f"{len(entities)} entities, {len(model['curves'])} curves")
    for entity, curve in zip(entities, model["curves"]):
        wanted = curve.get("name", "")
        require(wanted.startswith("odd") or name_of(entity) == wanted, f"{name_of(entity)}, not {wanted}")
        check_curve(entity, curve)


def check_panels(model, entities):
    outlines = [e for e in entities if e.dxftype() == "LWPOLYLINE"]
    boxes = []
    cells = [(s, i, j) for s in model["surfaces"] for i in range(len(s["points"]) - 1) for j in range(len(s["points"][0]) - 1)]
    require(len(outlines) == len(cells), f"{len(outlines)} outlines, {len(cells)} panels")
    worst = 0
    for outline, (surface, i, j) in zip(outlines, cells):
        net = surface["points"]
        corners = [net[i][j], net[i + 1][j], net[i + 1][j + 1], net[i][j + 1]]
        flat = [(p[0], p[1]) for p in outline.get_points()]
        require(outline.closed and name_of(outline) == f"{surface['name']} {i + 1},{j + 1}", f"{name_of(outline)}")
        for a in range(4):
            for b in range(a):
                d = math.dist(corners[a], corners[b])
                worst = max(worst, abs(math.dist(flat[a], flat[b]) / d - 1))
        xs, ys = [p[0] for p in flat], [p[1] for p in flat]
        boxes.append((min(xs), max(xs), min(ys), max(ys)))
    require(worst < 2e-14, f"a length is off by {worst} of it") # 7e-15 seen: sums of coordinates as large as the whole sheet
    boxes.sort()
    for k, a in enumerate(boxes):
        for b in boxes[k + 1:]:
            require(b[0] > a[1] or b[2] > a[3] or b[3] < a[2], "panels lie on each other")


model = json.load(open(sys.argv[1]))
drawing = ezdxf.readfile(sys.argv[2])
found = drawing.audit()
require(not found.errors and not found.fixes, f"ezdxf finds {found.errors} {found.fixes}")
entities = list(drawing.modelspace())
print("UNIT", drawing.header["$INSUNITS"], drawing.header["$ACADVER"])
for (kind, layer), count in sorted(Counter((e.dxftype(), e.dxf.layer) for e in entities).items()):
    print(kind, layer, count)
require(all(e.dxf.layer in drawing.layers for e in entities), "a layer is not in the table")
if model.get("curves"):
    check_curves(model, entities)
else:
    check_panels(model, entities)
