"""read_dxf_in.py write FOLDER | check DRAWING.dxf MODEL.json -- drawings of every release by ezdxf, with all kinds of curves and
blocks in blocks; and whether the curves that taut reads lie on ezdxf's entities, end where these end and are as long."""
import json
import math
import sys

import ezdxf
from ezdxf.math import Vec3

RELEASES = ["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"]


def draw(release):
    drawing = ezdxf.new(release)
    if release != "R12":
        drawing.units = ezdxf.units.M
    space = drawing.modelspace()
    inner = drawing.blocks.new("inner", base_point=(1, 0, 0))
    inner.add_line((1, 0, 0), (2, 1, 1))
    inner.add_arc((0, 1, 0), 2, 300, 20, dxfattribs={"layer": "bow"})
    cable = drawing.blocks.new("cable", base_point=(1, 1, 0))
    cable.add_line((1, 1, 0), (3, 1, 0))
    cable.add_blockref("inner", (5, 2, 1), dxfattribs={"rotation": 30, "layer": "in"})
    space.add_line((0, 0, 0), (1, 2, 3), dxfattribs={"layer": "mast"})
    space.add_line((0, 0, 0), (4, 0, 0), dxfattribs={"layer": "mast"})
    space.add_arc((1, 2, 3), 2, 30, 150, dxfattribs={"layer": "bow"})
    space.add_arc((1, 2, 3), 2.5, 200, 100, dxfattribs={"layer": "bow", "extrusion": (0.3, -0.2, -1)})
    space.add_circle((1, 2, 3), 2, dxfattribs={"layer": "ring", "extrusion": (0, 1, 0.001)})
    space.add_polyline3d([(0, 0, 0), (1, 0, 1), (2, 2, 2), (2, 2, 2), (0, 5, 1)], dxfattribs={"layer": "edge"})
    space.add_polyline2d([(0, 0, 0.3), (1, 0, -2), (2, 2, 0), (0, 1, 0.1)], format="xyb", close=True,
                         dxfattribs={"layer": "flat", "extrusion": (0, -1, 0.4), "elevation": (0, 0, 7)})
    space.add_blockref("cable", (10, 0, 0), dxfattribs={"layer": "edge", "xscale": 2, "yscale": 2, "zscale": 2, "rotation": 75})
    space.add_text("mast 1")
    if release != "R12":
        space.add_ellipse((0, 1, 0), (3, 1, 0.5), 0.4, 0.3, 4, dxfattribs={"layer": "oval", "extrusion": (-0.5, 0, 3)})
        space.add_lwpolyline([(0, 0, 0.5), (4, 0, -1.5), (4, 4, 0), (0, 4, 0)], format="xyb", close=True,
                             dxfattribs={"layer": "Kante S\u00fcd", "elevation": 2})
        space.add_open_spline([(0, 0, 0), (1, 1, 0), (2, 0, 1), (3, 1, 2), (4, 4, 4)], degree=3, dxfattribs={"layer": "free"})
        space.add_rational_spline([(0, 0, 0), (1, 1, 0), (2, 0, 1), (3, 1, 2), (4, 4, 4)], [1, 2, 1, 2, 1], degree=3,
                                  dxfattribs={"layer": "free"})
    return drawing


def point(curve, t):
    """De Boor's algorithm on homogeneous points."""
    basis = curve["t"]
    p, knots, points = basis["degree"], basis["knots"], curve["points"]
    weights = curve.get("weights") or [1] * len(points)
    span = max(i for i in range(p, len(points)) if knots[i] <= t or i == p)
    d = [[weights[j] * x for x in points[j]] + [weights[j]] for j in range(span - p, span + 1)]
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            k = span - p + j
            a = (t - knots[k]) / (knots[k + p - r + 1] - knots[k])
            d[j] = [(1 - a) * x + a * y for x, y in zip(d[j - 1], d[j])]
    return Vec3([x / d[p][3] for x in d[p][:3]])


def simple(entity):
    """Lines, arcs and ellipses that an entity is made of."""
    if entity.dxftype() in ("LWPOLYLINE", "POLYLINE", "INSERT"):
        return [part for child in entity.virtual_entities() for part in simple(child)]
    return [entity]


def apart(entity, x):
    """How far a point is from an entity."""
    kind, dxf = entity.dxftype(), entity.dxf
    if kind == "LINE":
        way = dxf.end - dxf.start
        t = min(1, max(0, (x - dxf.start).dot(way) / (way.dot(way) or 1)))
        return (x - (dxf.start + way * t)).magnitude
    if kind in ("ARC", "CIRCLE"):
        ocs = entity.ocs()
        local = ocs.from_wcs(x) - dxf.center
        if kind == "ARC":
            sweep = (dxf.end_angle - dxf.start_angle) % 360
            if (math.degrees(math.atan2(local.y, local.x)) - dxf.start_angle + 1e-7) % 360 > sweep + 2e-7:
                return math.inf
        return math.hypot(math.hypot(local.x, local.y) - dxf.radius, local.z)
    if kind == "ELLIPSE":
        way, a = x - dxf.center, dxf.major_axis
        b = dxf.extrusion.normalize().cross(a) * dxf.ratio
        u, v = way.dot(a) / a.dot(a), way.dot(b) / b.dot(b)
        return max(abs(math.hypot(u, v) - 1), abs(way.dot(dxf.extrusion.normalize())))
    raise ValueError(kind)


def length(entity):
    kind, dxf = entity.dxftype(), entity.dxf
    if kind == "LINE":
        return (dxf.end - dxf.start).magnitude
    if kind == "CIRCLE":
        return 2 * math.pi * dxf.radius
    return math.radians((dxf.end_angle - dxf.start_angle) % 360) * dxf.radius


def check(path, model_path):
    drawing, model = ezdxf.readfile(path), json.load(open(model_path, encoding="utf-8"))
    entities = []
    for entity in drawing.modelspace():
        entities += simple(entity) if entity.dxftype() == "INSERT" else [entity]
    entities = [e for e in entities if e.dxftype() != "TEXT"]
    curves = model["curves"]
    assert len(entities) == len(curves), (path, len(entities), len(curves))
    assert len({c["name"] for c in curves}) == len(curves), "names"
    worst = 0
    for entity, curve in zip(entities, curves):
        knots = curve["t"]["knots"]
        places = [knots[0] + (knots[-1] - knots[0]) * k / 200 for k in range(201)]
        points = [point(curve, t) for t in places]
        if entity.dxftype() == "SPLINE":
            assert list(entity.knots) == knots and [list(p) for p in entity.control_points] == curve["points"], curve["name"]
            assert list(entity.weights) == (curve.get("weights") or []), curve["name"]
            continue
        parts = simple(entity)
        worst = max(worst, max(min(apart(part, x) for part in parts) for x in points))
        if all(part.dxftype() != "ELLIPSE" for part in parts):
            wanted = sum(length(part) for part in parts)
            knot_length = (knots[-1] - knots[0]) * (2 if "/" in curve["name"] else 1)  # the scale of its block
            assert abs(knot_length / wanted - 1) < 1e-12, (curve["name"], knot_length, wanted)
    assert worst < 1e-11, worst
    names = [c["name"] for c in curves]
    for name in ("mast.1", "mast.2", "ring", "cable/edge", "inner/in", "inner/bow"):
        assert name in names, (name, names)
    if "R12" not in path:
        assert "Kante S\u00fcd" in names and "free.2" in names, names
    assert model.get("unit", "mm") == ("mm" if "R12" in path else "m")
    print(path, len(curves), worst)


if sys.argv[1] == "write":
    for release in RELEASES:
        draw(release).saveas(f"{sys.argv[2]}/{release}.dxf")
else:
    check(*sys.argv[2:])
