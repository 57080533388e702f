"""Parametric features: they keep what they are made from, and are made again when that moves. No window is needed.

A feature that cannot be made raises: FreeCAD marks it, and its message says what to change. Lengths are millimetres, FreeCAD's own.
"""
import FreeCAD
import Part
import numpy as np

import taut
from taut import hosts

CONSTRUCTS = {"Dirichlet": "dirichlet", "Least area": "plateau", "Harmonic": "harmonic", "Asymptotic": "asymptotic"}
LARGEST_DEGREE = 25  # of OpenCASCADE's splines


# --- Between FreeCAD and Taut ---------------------------------------------------------------------------------------------


def _vectors(points):
    return np.array([[p.x, p.y, p.z] for p in points])


def _flat(knots, counts):
    return [knot for knot, count in zip(knots, counts) for _ in range(count)]


def curve_of(edge, name="the edge"):
    """An edge, whatever its curve, as a spline over its own piece: exact (conics are rational) but for what OpenCASCADE approximates itself.
    Curve.toBSpline of the edge would approximate conics, and end at the seam of a closed spline."""
    if edge.Degenerated or max(abs(edge.FirstParameter), abs(edge.LastParameter)) > 1e99:
        raise taut.InputError(f"{name} is a point, or endless: take an edge between two ends", "/boundary", "type")
    nurbs = edge.toNurbs().Edges[0]
    spline, ends = nurbs.Curve.copy(), (nurbs.FirstParameter, nurbs.LastParameter)
    if ends != (spline.FirstParameter, spline.LastParameter) or spline.isPeriodic():
        spline.segment(*ends)
    spline = spline.toBSpline()
    if spline.isClosed():
        raise taut.InputError(f"{name} is closed, without ends to meet at: cut it open", "/boundary", "type")
    return hosts.curve(spline.Degree, _flat(spline.getKnots(), spline.getMultiplicities()), _vectors(spline.getPoles()),
                       spline.getWeights() if spline.isRational() else None, name)


def _is_trimmed(face):
    """Whether an edge leaves the box of parameters."""
    low, high, left, right = face.ParameterRange
    for edge in face.Edges:
        found = face.curveOnSurface(edge)
        if not found:
            return True
        curve, begin, end = found
        places = np.array([[p.x, p.y] for p in (curve.value(begin + (end - begin) * s / 8) for s in range(9))])
        for sides in ((0, low), (0, high), (1, left), (1, right)):
            if np.abs(places[:, sides[0]] - sides[1]).max() <= 1e-7 * (high - low if sides[0] == 0 else right - left):
                break
        else:
            return True
    return False


def surface_of(face, name=""):
    """A face as a NURBS surface; one that is trimmed is refused."""
    nurbs = face.toNurbs().Faces[0]
    if _is_trimmed(nurbs):
        raise taut.InputError(f"{name or 'the face'} is trimmed: take one that is bounded by four edges of its surface", "", "type")
    spline = nurbs.Surface
    spline.segment(*nurbs.ParameterRange)
    weights = np.array(spline.getWeights()) if spline.isURational() or spline.isVRational() else None
    return taut.Surface(taut.bspline(spline.UDegree, knots=_flat(spline.getUKnots(), spline.getUMultiplicities())),
                        taut.bspline(spline.VDegree, knots=_flat(spline.getVKnots(), spline.getVMultiplicities())),
                        [_vectors(row) for row in spline.getPoles()], weights, name)


def native(surface):
    """A taut.Surface as Part.BSplineSurface: the same poles, knots and weights."""
    shape = hosts.spline(surface)
    if max(shape.degrees) > LARGEST_DEGREE:
        raise taut.InputError(f"the surface has degree {max(shape.degrees)}; FreeCAD's have at most {LARGEST_DEGREE}: take edges of lower degree",
                              "/degree", "degree", max(shape.degrees), LARGEST_DEGREE)
    result = Part.BSplineSurface()
    poles = [[FreeCAD.Vector(*point) for point in row] for row in shape.points.tolist()]
    weights = np.ones(shape.points.shape[:2]) if shape.weights is None else shape.weights
    result.buildFromPolesMultsKnots(poles, *shape.multiplicities, *shape.knots, False, False, *shape.degrees, weights.tolist())
    return result


def _frame(obj):
    """Where the coordinates of an object stand in the document: its own placement is in its shape, that of a Part or a Body around it is not."""
    group = obj.getParentGeoFeatureGroup()
    return group.getGlobalPlacement() if group else FreeCAD.Placement()


def _parts(obj, links, kind=""):
    """(name, shape) of what the links of a feature name, as the feature sees it, of the kind "Edge" or "Face", or as it is."""
    found = []
    for source, names in links or []:
        move = _frame(obj).inverse() * _frame(source)
        for name in names if isinstance(names, (list, tuple)) else [names]:
            shape = source.getSubObject(name) if name else source.Shape
            if shape is None:
                raise taut.InputError(f"{source.Label} has no {name} any more: choose {name.rstrip('0123456789').lower()}s again", "", "value")
            if not move.isIdentity():
                shape.Placement = move * shape.Placement
            parts = {"Edge": shape.Edges, "Face": shape.Faces}.get(kind, [shape])
            found.extend((f"{source.Name}.{name}" if name else source.Name, part) for part in parts)
    return found


def whole(shape, kinds):
    """What is meant by an object that was selected as a whole: all its edges, its one cylinder, its one face."""
    names = [f"Face{i + 1}" for i, face in enumerate(shape.Faces) if kinds == ("Face",) or isinstance(face.Surface, Part.Cylinder)]
    return names if "Face" in kinds and len(names) == 1 else [f"Edge{i + 1}" for i in range(len(shape.Edges))] if "Edge" in kinds else []


def axis_of(part):
    """The ends of a straight edge, or of the axis of a cylinder, and its radius (0 of an edge)."""
    if part.ShapeType == "Face" and isinstance(part.Surface, Part.Cylinder):
        axis, centre = part.Surface.Axis, part.Surface.Center
        low, high = part.ParameterRange[2:]
        return _vectors([centre + axis * low, centre + axis * high]), part.Surface.Radius
    if part.ShapeType == "Edge" and isinstance(part.Curve, (Part.Line, Part.LineSegment)):
        return _vectors([vertex.Point for vertex in part.Vertexes]), 0.0
    raise taut.InputError("expected two cylinders or two straight edges", "/ends", "type")


_PROPERTIES = {"boundary": "Edges", "points": "Edges", "from": "Ends", "to": "Ends", "radii": "Radius"}  # of members that are called otherwise


def _said(obj, error):
    """What failed and what to change, after the name of the property it is about."""
    member = getattr(error, "where", "").split("/")[1:2]
    name = _PROPERTIES.get(member[0], member[0].capitalize()) if member else ""
    return f"{name}: {hosts.told(error)}" if name in obj.PropertiesList else hosts.told(error)


# --- Features ----------------------------------------------------------------------------------------------------------------


class Feature:
    """What all share: properties, the certificate, errors that say what to change."""

    properties = ()

    def __init__(self, obj):
        obj.Proxy = self
        self.onDocumentRestored(obj)

    def onDocumentRestored(self, obj):
        """Properties that are missing, also those that an older document lacks."""
        own = (("App::PropertyString", "Holds", "Certificate", "whether every claim holds"),
               ("App::PropertyStringList", "Claims", "Certificate", "what was proved, line by line"),
               ("App::PropertyString", "Model", "Certificate", "the whole model, as JSON"))
        for kind, name, group, text in self.properties + own:
            if name not in obj.PropertiesList:
                obj.addProperty(kind, name, group, text)
                if group == "Certificate":
                    obj.setEditorMode(name, 1 if name != "Model" else 3)
                self.preset(obj, name)

    def preset(self, obj, name):
        """The first value of a property."""

    def execute(self, obj):
        try:
            self.make(obj)
        except Exception as error:
            obj.Holds, obj.Claims, obj.Model = "not made", [_said(obj, error)], ""
            raise RuntimeError(_said(obj, error)) from None

    def tell(self, obj, holds, lines, document=""):
        """Into the properties and the report view."""
        obj.Holds, obj.Claims, obj.Model = {True: "holds", False: "does not hold", None: "undecided"}.get(holds, holds), lines, document
        put = FreeCAD.Console.PrintWarning if holds is False else FreeCAD.Console.PrintMessage
        put(f"{obj.Label}: " + "\n    ".join(lines) + "\n")

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads  # as FreeCAD before 0.21 calls them


class Between(Feature):
    """The surface of one construction between four edges."""

    properties = (("App::PropertyLinkSubListGlobal", "Edges", "Taut", "four edges that close a ring, in any order"),
                  ("App::PropertyEnumeration", "Construction", "Taut", "which surface"),
                  ("App::PropertyIntegerList", "Degree", "Taut", "at least these degrees along u and v; empty: those of the edges"),
                  ("App::PropertyIntegerList", "Refine", "Taut", "how often spans along u and v are halved; empty: not"))

    def preset(self, obj, name):
        if name == "Construction":
            obj.Construction = list(CONSTRUCTS)

    def make(self, obj):
        edges = [curve_of(edge, name) for name, edge in _parts(obj, obj.Edges, "Edge")]
        members = {}
        if obj.Construction in ("Dirichlet", "Least area"):
            members = {name: list(value) for name, value in (("degree", obj.Degree), ("refine", obj.Refine)) if any(value)}
        model = hosts.between(CONSTRUCTS[obj.Construction], edges, **members)
        obj.Shape = native(model.surfaces[0]).toShape()
        self.tell(obj, model.certificate.holds, hosts.claims(model.certificate), model.to_json())


class Blend(Feature):
    """A pipe between two cylinders, or between two straight edges."""

    properties = (("App::PropertyLinkSubListGlobal", "Ends", "Taut", "two cylinders or two straight edges"),
                  ("App::PropertyLength", "Radius", "Taut", "of the pipe; 0: that of the cylinders"),
                  ("App::PropertyEnumeration", "Joint", "Taut", "g1: equal tangent planes; g2: equal curvatures too"))

    def preset(self, obj, name):
        if name == "Joint":
            obj.Joint = ["g1", "g2"]

    def make(self, obj):
        parts = [part for _, part in _parts(obj, obj.Ends)]
        if len(parts) != 2:
            raise taut.InputError(f"found {len(parts)} ends; expected two cylinders or two straight edges", "/ends", "size", len(parts), 2)
        (one, first), (other, second) = map(axis_of, parts)
        radius = [obj.Radius.Value] if obj.Radius.Value > 0 else [first, second]
        if min(radius) <= 0:
            raise taut.InputError("straight edges have no radius: set Radius", "/radius", "range", min(radius), 0.0)
        model = hosts.blend(one, other, radius if len(radius) == 2 else radius[0], joint=obj.Joint)
        obj.Shape = native(model["blend"]).toShape()
        self.tell(obj, model.certificate.holds, hosts.claims(model.certificate), model.to_json())


class Join(Feature):
    """How two faces meet: gap, angles, order of contact, at equal parameters of their edges."""

    properties = (("App::PropertyLinkSubListGlobal", "Faces", "Taut", "two faces"),
                  ("App::PropertyString", "Along", "Taut", "the edges that are compared, those that are nearest"),
                  ("App::PropertyLength", "Gap", "Taut", "the largest gap between the edges"),
                  ("App::PropertyAngle", "Angle", "Taut", "the largest angle between the normals"),
                  ("App::PropertyInteger", "Contact", "Taut", "order of geometric contact; -1: a gap"))

    def make(self, obj):
        faces = _parts(obj, obj.Faces, "Face")
        if len(faces) != 2:
            raise taut.InputError(f"found {len(faces)} faces; expected two", "/faces", "size", len(faces), 2)
        one, other = (surface_of(face, name) for name, face in faces)
        edge, opposite, report = hosts.nearest(one, other)
        obj.Along, obj.Gap, obj.Contact = f"{edge} of the first, {opposite} of the second", report["max_gap"], report["g_order"]
        obj.Angle = float(np.degrees(report["max_normal_angle"] or 0.0))
        self.tell(obj, f"G{report['g_order']}" if report["g_order"] >= 0 else "a gap",
                  [f"{name}: {value}" for name, value in report.items()])


def add(document, proxy, name, **values):
    """A feature in the document; recompute makes it."""
    obj = document.addObject("App::FeaturePython" if proxy is Join else "Part::FeaturePython", name)
    proxy(obj)
    for member, value in values.items():
        setattr(obj, member, value)
    return obj
