"""Runs in freecadcmd: makes each feature, moves what it hangs on, recomputes, asks for nonsense; prints what came of it."""
import json
import os
import traceback

import FreeCAD
import Part

from freecad.taut_workbench import features

given = json.loads(os.environ["TAUT_TEST"])
V = FreeCAD.Vector


def poles(obj):
    face = obj.Shape.Faces[0].Surface
    return {"poles": [[list(p) for p in row] for row in face.getPoles()], "weights": face.getWeights(),
            "knots": [face.getUKnots(), face.getVKnots()], "counts": [face.getUMultiplicities(), face.getVMultiplicities()],
            "degrees": [face.UDegree, face.VDegree], "rational": face.isURational() or face.isVRational(), "area": obj.Shape.Area,
            "valid": obj.Shape.isValid(), "holds": obj.Holds, "claims": obj.Claims, "state": obj.State}


def run():
    document = FreeCAD.newDocument("test")
    document.UndoMode = 1
    result = {}
    sources = []
    for i, points in enumerate(given["edges"]):
        curve = Part.BezierCurve()
        curve.setPoles([V(*p) for p in points])
        source = document.addObject("Part::Feature", f"Edge{i}")
        source.Shape = curve.toShape()
        sources.append(source)
    links = [(source, ["Edge1"]) for source in sources]
    for name in ("Dirichlet", "Least area", "Harmonic"):
        obj = features.add(document, features.Between, name.split()[0], Edges=links, Construction=name)
        document.recompute()
        result[name] = poles(obj)
    # no property hides what every object of FreeCAD has
    result["own"] = [obj.Document == document, set(features.taut.Model.from_json(obj.Model).certificate.figures) > set()]
    hidden = [name for name in dir(sources[0]) for one in (features.Between, features.Blend, features.Join)
              for _, member, *_ in one.properties + (("", "Holds"), ("", "Claims"), ("", "Model")) if member == name]
    result["hidden"] = hidden
    # all four edges move together: by placement, as a person drags them
    for source in sources:
        source.Placement = FreeCAD.Placement(V(*given["shift"]), FreeCAD.Rotation())
    document.recompute()
    result["moved"] = poles(document.getObject("Dirichlet"))
    # one moves alone: the ring is open
    sources[0].Placement = FreeCAD.Placement(V(0, 0, 50), FreeCAD.Rotation())
    document.recompute()
    broken = document.getObject("Dirichlet")
    result["broken"] = {"state": broken.State, "claims": broken.Claims, "holds": broken.Holds, "valid": broken.isValid()}
    sources[0].Placement = FreeCAD.Placement(V(*given["shift"]), FreeCAD.Rotation())
    document.recompute()
    result["mended"] = poles(broken)
    three = features.add(document, features.Between, "Three", Edges=links[:3])
    document.recompute()
    result["three"] = {"state": three.State, "claims": three.Claims}
    # arcs: exact, over their own piece; a closed spline's piece across its seam
    arc = Part.makeCircle(30, V(1, 2, 3), V(1, 1, 1), 20, 290)
    loop = Part.BSplineCurve()
    loop.interpolate([V(0, 0, 0), V(1, 1, 0), V(2, 0, 0), V(1, -1, 1)], PeriodicFlag=True)
    seam = Part.Edge(loop, loop.LastParameter - 1, loop.LastParameter + 1)
    piece = features.curve_of(seam)
    exact = features.curve_of(arc)
    low, high = exact.t.range
    places = [exact(low + (high - low) * s / 100) for s in range(101)]
    ends = [features._vectors([one.Point for one in edge.Vertexes]) for edge in (arc, seam)]
    result["arc"] = {"degree": exact.t.degree, "off": max(abs(V(*one).distanceToPoint(V(1, 2, 3)) - 30) for one in places),
                     "ends": max(abs(one(one.t.range[k]) - end[k]).max() for one, end in zip((exact, piece), ends) for k in (0, 1))}
    # an edge in a Part that has moved stands where it is seen
    part, inner = document.addObject("App::Part", "Part"), document.addObject("Part::Feature", "Inner")
    part.addObject(inner)
    part.Placement = FreeCAD.Placement(V(3, 4, 5), FreeCAD.Rotation(V(0, 0, 1), 90))
    inner.Shape, inner.Placement = sources[0].Shape, part.Placement.inverse() * sources[0].Placement
    within = features.add(document, features.Between, "Within", Edges=[(inner, ["Edge1"])] + links[1:], Construction="Dirichlet")
    document.recompute()
    result["in a part"] = poles(within)
    # what is not there any more, what has no ends
    ball = document.addObject("Part::Sphere", "Ball")
    for name, link in (("gone", (sources[0], ["Edge9"])), ("pole", (ball, ["Edge1"]))):
        wrong = features.add(document, features.Between, "Wrong", Edges=[link] + links[1:])
        document.recompute()
        result[name] = {"state": wrong.State, "claims": wrong.Claims}
    wire = document.addObject("Part::Feature", "Wire")
    wire.Shape = Part.makePolygon([V(*given["saddle"][i % 4]) for i in range(5)])
    flat = features.add(document, features.Between, "Flat", Edges=[(wire, ["Edge1", "Edge2", "Edge3", "Edge4"])], Degree=[0, 0])
    document.recompute()
    result["degree 0"] = flat.Holds
    result["whole"] = [features.whole(Part.makeCylinder(1, 2), ("Face", "Edge")), features.whole(wire.Shape, ("Edge",)),
                       features.whole(Part.makePlane(1, 1), ("Face",)), features.whole(Part.makeBox(1, 1, 1), ("Face",))]
    # a saddle's straight edges are asymptotic curves of it: as cubics
    straight = []
    for i in range(4):
        a, b = V(*given["saddle"][i]), V(*given["saddle"][(i + 1) % 4])
        curve = Part.BezierCurve()
        curve.setPoles([a + (b - a) * (s / 3) for s in range(4)])
        source = document.addObject("Part::Feature", f"Straight{i}")
        source.Shape = curve.toShape()
        straight.append((source, ["Edge1"]))
    obj = features.add(document, features.Between, "Asymptotic", Edges=straight, Construction="Asymptotic")
    document.recompute()
    result["Asymptotic"] = poles(obj)
    # pipes: between cylinders, then between lines
    one, other = document.addObject("Part::Cylinder", "One"), document.addObject("Part::Cylinder", "Other")
    for cylinder in (one, other):
        cylinder.Radius, cylinder.Height = 20, 100
    one.Placement = FreeCAD.Placement(V(-100, 0, 0), FreeCAD.Rotation(V(0, 0, 1), V(1, 0, 0)))
    other.Placement = FreeCAD.Placement(V(240, 160, 120), FreeCAD.Rotation(V(0, 0, 1), V(0, 1, 0)))
    document.recompute()
    pipe = features.add(document, features.Blend, "Pipe", Ends=[(one, ["Face1"]), (other, ["Face1"])])
    document.recompute()
    result["Pipe"] = poles(pipe)
    join = features.add(document, features.Join, "Join", Faces=[(document.getObject("Dirichlet"), ["Face1"]), (document.getObject("Least"), ["Face1"])])
    document.recompute()
    result["Join"] = {"gap": join.Gap.Value, "angle": join.Angle.Value, "contact": join.Contact, "along": join.Along, "claims": join.Claims,
                      "state": join.State}
    box = document.addObject("Part::Box", "Box")
    hole = document.addObject("Part::Cut", "Hole")
    hole.Base, hole.Tool = box, document.addObject("Part::Cylinder", "Drill")
    document.recompute()
    face = [f"Face{i + 1}" for i, one in enumerate(hole.Shape.Faces) if 96 < one.Area < 97.5 and isinstance(one.Surface, Part.Plane)][:1]
    trimmed = features.add(document, features.Join, "Trimmed", Faces=[(hole, face), (pipe, ["Face1"])])
    document.recompute()
    result["trimmed"] = {"state": trimmed.State, "claims": trimmed.Claims}
    lines = []
    for name, a, b in (("L1", V(-100, 0, 0), V(0, 0, 0)), ("L2", V(240, 260, 120), V(240, 160, 120))):
        source = document.addObject("Part::Feature", name)
        source.Shape = Part.makeLine(a, b)
        lines.append((source, ["Edge1"]))
    bare = features.add(document, features.Blend, "Bare", Ends=lines)
    document.recompute()
    result["no radius"] = {"state": bare.State, "claims": bare.Claims}
    bare.Radius = 20
    document.recompute()
    result["Lines"] = poles(bare)
    bare.Radius = 2000
    document.recompute()
    result["too thick"] = {"state": bare.State, "claims": bare.Claims}
    bare.Radius = 20
    document.recompute()
    # a certificate that does not hold
    true = features.hosts.between

    def false(*arguments, **named):
        model = json.loads(true(*arguments, **named).to_json())
        model["certificate"]["holds"] = model["certificate"]["claims"][0]["holds"] = False
        return features.taut.Model.from_json(json.dumps(model))

    features.hosts.between = false
    wrong = features.add(document, features.Between, "False", Edges=links)
    document.recompute()
    features.hosts.between = true
    result["false"] = [wrong.Holds, wrong.Claims[0], wrong.Shape.isNull()]
    document.removeObject(wrong.Name)
    # undo and redo
    document.openTransaction("one more")
    features.add(document, features.Between, "Again", Edges=links)
    document.recompute()
    document.commitTransaction()
    document.undo()
    result["undone"] = document.getObject("Again") is None
    document.redo()
    result["redone"] = document.getObject("Again") is not None
    # saved, read, and made again
    path = os.path.join(given["folder"], "saved.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path)
    document.getObject("Dirichlet").touch()
    document.recompute()
    result["read again"] = poles(document.getObject("Dirichlet"))
    return result


try:
    print("RESULT " + json.dumps(run()), flush=True)
except BaseException:
    traceback.print_exc()
    os._exit(1)
os._exit(0)
