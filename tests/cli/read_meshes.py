"""read_meshes.py CUBE BALL TUBE -- reads CUBE.stl, CUBE.ply, CUBE.obj ... with VTK: closed where the surfaces are, right side out.

The cube has side 1, the ball radius 1 and a pole at each end; the tube of radius 1 and height 2 is open, two circles long."""

import math
import sys

from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader

READERS = {"stl": vtkSTLReader, "ply": vtkPLYReader, "obj": vtkOBJReader}
failures = 0


def check(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def read(path):
    """The triangles, corners with the same coordinates made one."""
    reader, triangles, merged = READERS[path[-3:]](), vtkTriangleFilter(), vtkCleanPolyData()
    reader.SetFileName(path)
    merged.SetInputConnection(reader.GetOutputPort())
    merged.ToleranceIsAbsoluteOn()
    merged.SetAbsoluteTolerance(0)
    merged.ConvertPolysToLinesOff() # what is left of triangles at the poles
    triangles.SetInputConnection(merged.GetOutputPort())
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    return triangles


def open_length(mesh):
    """How long the edges are that are not shared by two triangles."""
    edges = vtkFeatureEdges()
    edges.SetInputConnection(mesh.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.Update()
    lines = edges.GetOutput()
    length = 0
    for i in range(lines.GetNumberOfCells()):
        points = lines.GetCell(i).GetPoints()
        length += math.dist(points.GetPoint(0), points.GetPoint(1))
    return length


def signed_volume(mesh):
    """By the divergence theorem about the middle: above 0 where all triangles look outwards."""
    data, volume = mesh.GetOutput(), 0
    middle = data.GetCenter()
    for i in range(data.GetNumberOfCells()):
        points = data.GetCell(i).GetPoints()
        a, b, c = ([x - m for x, m in zip(points.GetPoint(k), middle)] for k in range(3))
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return volume


def normals_behind(name):
    """How many corners of an OBJ file have their normal on the other side than their face."""
    rows = {"v": [], "vn": [], "f": []}
    with open(name) as file:
        for line in file:
            word, *rest = line.split() or [""]
            if word in rows:
                rows[word].append([int(c.split("/")[0]) - 1 if word == "f" else float(c) for c in rest])
    count = 0
    for face in rows["f"]:
        a, b, c, d = (rows["v"][i] for i in face)
        p, q = [x - y for x, y in zip(c, a)], [x - y for x, y in zip(d, b)]
        n = (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
        count += sum(sum(x * y for x, y in zip(n, rows["vn"][i])) < 0 for i in face)
    return count


cube, ball, tube = sys.argv[1:]
for name in (cube, ball, tube):
    check(normals_behind(f"{name}.obj") == 0, f"{name}.obj: {normals_behind(f'{name}.obj')} normals look inwards")
for ending in READERS:
    for name, volume, close in ((cube, 1, 1e-6), (ball, 4 * math.pi / 3, 0.05)):
        mesh = read(f"{name}.{ending}")
        check(open_length(mesh) == 0, f"{name}.{ending} is open along {open_length(mesh)}")
        found = signed_volume(mesh)
        check(abs(found - volume) < close, f"{name}.{ending} encloses {found}")
    length = open_length(read(f"{tube}.{ending}"))
    check(abs(length - 4 * math.pi) < 0.05, f"{tube}.{ending} is open along {length}")
    check(signed_volume(read(f"{tube}.{ending}")) > 0, f"{tube}.{ending} is inside out")
sys.exit(failures > 0)
