"""read_lagrange.py MODEL.json LAGRANGE.vtu BEZIER.vtu -- the same B-spline surface as Lagrange cells and as Bezier cells, read by VTK and by
meshio, where it is installed: the points are those of the surface, by de Boor's recursion on the document's numbers; arrays are those
of the other file, bit for bit.
"""

import json
import sys

from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

LAGRANGE = 70
NAMES = ("H", "K", "E_minus_G", "F", "isothermality")


def require(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def spans(basis):
    return [(a, b) for a, b in zip(basis["knots"], basis["knots"][1:]) if a < b]


def functions(basis, span, t):
    """All functions at t, as the polynomials of one span continue them."""
    p, knots = basis["degree"], basis["knots"]
    values = [float((knots[i], knots[i + 1]) == span) for i in range(len(knots) - 1)]
    for d in range(1, p + 1):
        part = lambda i, x: x / (knots[i + d] - knots[i]) if knots[i + d] > knots[i] else 0.0
        values = [part(i, t - knots[i]) * values[i] + part(i + 1, knots[i + d + 1] - t) * values[i + 1] for i in range(len(values) - 1)]
    return values


def surface_at(surface, cell, count, r, s):
    """The point at (r, s) of a cell, counted along v first, of `count` cells a span in each direction."""
    across = count[1] * len(spans(surface["v"]))
    sums = []
    for basis, k, n, x in ((surface["u"], cell // across, count[0], r), (surface["v"], cell % across, count[1], s)):
        a, b = spans(basis)[k // n]
        sums.append(functions(basis, (a, b), a + (b - a) * (k % n + x) / n))
    return [sum(bu * bv * surface["points"][i][j][d] for i, bu in enumerate(sums[0]) for j, bv in enumerate(sums[1])) for d in range(3)]


def off(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


surface = json.load(open(sys.argv[1]))["surfaces"][0]
grid, bezier = read(sys.argv[2]), read(sys.argv[3])
p, q = surface["u"]["degree"], surface["v"]["degree"]
n = grid.GetNumberOfCells()
count = [-(-4 // len(spans(surface[d]))) for d in "uv"] # as few cells a span as make four
require(p != q and n == count[0] * count[1] * len(spans(surface["u"])) * len(spans(surface["v"])), f"{n} cells")
size = max(abs(x) for row in surface["points"] for point in row for x in point)
worst = between = 0.0
for i in range(n):
    cell = grid.GetCell(i)
    require(grid.GetCellType(i) == LAGRANGE and cell.GetNumberOfPoints() == (p + 1) * (q + 1), f"cell {i} is of type {grid.GetCellType(i)}")
    for k in range(cell.GetNumberOfPoints()):
        r, s = cell.GetParametricCoords()[3 * k:3 * k + 2]
        node = cell.GetPointId(k)
        worst = max(worst, off(grid.GetPoint(node), surface_at(surface, i, count, r, s)))
        same = bezier.GetCell(i).GetPointId(k)
        for name in NAMES:
            a, b = grid.GetPointData().GetArray(name).GetTuple1(node), bezier.GetPointData().GetArray(name).GetTuple1(same)
            require(a == b, f"{name} of point {k} of cell {i} is {a}, and {b} in the other file")
    for r, s in ((0.31, 0.47), (0.77, 0.12)): # by VTK's own shape functions
        point, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
        cell.EvaluateLocation(mutable(0), [r, s, 0], point, weights)
        between = max(between, off(point, surface_at(surface, i, count, r, s)))
print("points", worst / size, "between", between / size)
require(worst < 1e-15 * size, f"a point is off by {worst}")
require(between < 4e-15 * size, f"what VTK draws is off by {between}") # the sizes of its shape functions add up to 2.5

# Points that neighbours share are the same doubles: what is merged by them is one sheet.
nodes = {grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())}
along = [count[d] * len(spans(surface["uv"[d]])) * (p, q)[d] + 1 for d in (0, 1)]
require(len(nodes) == along[0] * along[1], f"{len(nodes)} points, expected {along[0]} x {along[1]}")

try:
    import meshio
except ImportError:
    sys.exit(0)
mesh = meshio.read(sys.argv[2])
require([(block.type, block.data.shape) for block in mesh.cells] == [("VTK_LAGRANGE_QUADRILATERAL", (n, (p + 1) * (q + 1)))], f"meshio: {mesh}")
for i in range(n):
    ids = [grid.GetCell(i).GetPointId(k) for k in range((p + 1) * (q + 1))]
    require(list(mesh.cells[0].data[i]) == ids, f"meshio: cell {i}")
for i in range(grid.GetNumberOfPoints()):
    require(tuple(mesh.points[i]) == grid.GetPoint(i), f"meshio: point {i}")
    require(all(mesh.point_data[name][i] == grid.GetPointData().GetArray(name).GetTuple1(i) for name in NAMES), f"meshio: fields at {i}")
