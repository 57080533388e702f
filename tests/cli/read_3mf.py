"""read_3mf.py FILE... -- reads 3MF files with Python's zipfile and XML parser, by the rules of the 3MF Core Specification.

Prints a line a file, "FILE unit UNIT", and one an object: "FILE object NAME type TYPE triangles N volume V area A colours C...".
Refused: a part that is not there or does not match its CRC, a relation or a type of content that is missing, ids that are not
unique or not there, corners twice or out of range, vertices that nothing uses or two at one place, and in an object of type
"model" a side that is not there once each way, or a volume that is not above 0.
"""

import math
import sys
import zipfile
from xml.etree import ElementTree

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
UNITS = ("micron", "millimeter", "centimeter", "inch", "foot", "meter")


def require(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


def read_archive(path):
    with zipfile.ZipFile(path) as archive:
        require(archive.testzip() is None, f"{path}: a CRC")
        names = archive.namelist()
        require(names[0] == "[Content_Types].xml" and len(set(names)) == len(names), f"{path}: {names}")
        require(all(i.date_time == (1980, 1, 1, 0, 0, 0) for i in archive.infolist()), f"{path}: has a time")
        types = ElementTree.fromstring(archive.read("[Content_Types].xml"))
        kinds = {t.get("Extension"): t.get("ContentType") for t in types}
        require(kinds["model"] == "application/vnd.ms-package.3dmanufacturing-3dmodel+xml", f"{path}: {kinds}")
        relation = ElementTree.fromstring(archive.read("_rels/.rels"))[0]
        require(relation.get("Type") == "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel", f"{path}: a relation")
        return ElementTree.fromstring(archive.read(relation.get("Target").lstrip("/")))


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def measure(points, triangles):
    """Volume about the first point, and area."""
    volume = area = 0
    for triangle in triangles:
        a, b, c = (points[i] for i in triangle)
        n = cross(difference(b, a), difference(c, a))
        area += math.hypot(*n) / 2
        volume += sum(x * y for x, y in zip(difference(a, points[0]), n)) / 6
    return volume, area


def check_object(path, element):
    points = [tuple(float(v.get(c)) for c in "xyz") for v in element.iter(CORE + "vertex")]
    triangles = [tuple(int(t.get(k)) for k in ("v1", "v2", "v3")) for t in element.iter(CORE + "triangle")]
    require(len(set(points)) == len(points), f"{path}: two vertices at one place")
    require(all(len(set(t)) == 3 for t in triangles), f"{path}: a corner twice")
    require({i for t in triangles for i in t} == set(range(len(points))), f"{path}: vertices and corners differ")
    volume, area = measure(points, triangles)
    sides = [(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)]
    closed = len(set(sides)) == len(sides) and set(sides) == {(b, a) for a, b in sides}
    require(closed == (element.get("type") == "model"), f"{path}: {element.get('name')} is {element.get('type')}, closed {closed}")
    require(not closed or volume > 0, f"{path}: {element.get('name')} has a volume of {volume}")
    return len(triangles), volume, area


def check_file(path):
    root = read_archive(path)
    require(root.tag == CORE + "model" and root.get("unit") in UNITS, f"{path}: {root.tag} {root.get('unit')}")
    print(path, "unit", root.get("unit"))
    resources, build = root.find(CORE + "resources"), root.find(CORE + "build")
    materials, objects = resources.find(CORE + "basematerials"), resources.findall(CORE + "object")
    ids = [r.get("id") for r in resources]
    require(len(set(ids)) == len(ids), f"{path}: ids {ids}")
    require([i.get("objectid") for i in build] == [o.get("id") for o in objects], f"{path}: what is built")
    colours = [b.get("displaycolor") for b in materials]
    for element in objects:
        count, volume, area = check_object(path, element)
        used = sorted({int(t.get("p1")) for t in element.iter(CORE + "triangle")})
        require({t.get("pid") for t in element.iter(CORE + "triangle")} == {materials.get("id")}, f"{path}: materials")
        print(path, "object", element.get("name"), "type", element.get("type"), "triangles", count, "volume", repr(volume), "area",
              repr(area), "colours", *(f"{materials[i].get('name')}={colours[i]}" for i in used))


for file in sys.argv[1:]:
    check_file(file)
