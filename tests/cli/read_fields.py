"""read_fields.py DIVIDE VALUES.vtu COEFFICIENTS.vtu -- the fields of one Bezier surface in DIVIDE x DIVIDE cells, against differences of
what VTK itself makes of the cells.

In VALUES each array has at point (i, j) of a cell the field at (i / p, j / q) of it, and isothermality lies in [0, 1]; in
COEFFICIENTS what VTK draws is the field, and arrays may leave its range.
"""

import math
import sys

from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

NAMES = ("H", "K", "E_minus_G", "F", "isothermality")
STEP = 1e-3
divide = int(sys.argv[1])


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def require(holds, what):
    if not holds:
        sys.exit(f"FAILED: {what}")


def located(cell, r, s):
    point, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
    cell.EvaluateLocation(mutable(0), [r, s, 0], point, weights)
    return point, weights


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def fields(cell, r, s):
    """All fields at (r, s), by differences of second order and one step of Richardson's; u and v run DIVIDE times as slowly."""
    def differences(h):
        at = {(i, j): located(cell, r + i * h, s + j * h)[0] for i in (-1, 0, 1) for j in (-1, 0, 1)}
        combine = lambda terms, scale: [sum(c * at[k][d] for k, c in terms) * scale for d in range(3)]
        return (combine([((1, 0), 1), ((-1, 0), -1)], divide / 2 / h), combine([((0, 1), 1), ((0, -1), -1)], divide / 2 / h),
                combine([((1, 0), 1), ((0, 0), -2), ((-1, 0), 1)], (divide / h) ** 2),
                combine([((1, 1), 1), ((1, -1), -1), ((-1, 1), -1), ((-1, -1), 1)], (divide / h) ** 2 / 4),
                combine([((0, 1), 1), ((0, 0), -2), ((0, -1), 1)], (divide / h) ** 2))
    coarse, fine = differences(2 * STEP), differences(STEP)
    xu, xv, xuu, xuv, xvv = ([(4 * f - c) / 3 for f, c in zip(a, b)] for a, b in zip(fine, coarse))
    n = (xu[1] * xv[2] - xu[2] * xv[1], xu[2] * xv[0] - xu[0] * xv[2], xu[0] * xv[1] - xu[1] * xv[0])
    w = math.hypot(*n)
    e, f, g = dot(xu, xu), dot(xu, xv), dot(xv, xv)
    l, m, k = (dot(x, n) / w for x in (xuu, xuv, xvv))
    return ((e * k - 2 * f * m + g * l) / 2 / w ** 2, (l * k - m * m) / w ** 2, e - g, f, math.hypot(e - g, 2 * f) / (e + g))


def surface_cells(grid):
    part = grid.GetCellData().GetArray("part")
    return [i for i in range(grid.GetNumberOfCells()) if part.GetTuple1(i) == 0]


def ranges(grid, cells):
    points = {grid.GetCell(i).GetPointId(k) for i in cells for k in range(grid.GetCell(i).GetNumberOfPoints())}
    return {name: (min(v), max(v)) for name in NAMES for v in [[grid.GetPointData().GetArray(name).GetTuple1(p) for p in points]]}


values, coefficients = read(sys.argv[2]), read(sys.argv[3])
cells = surface_cells(values)
require(len(cells) == divide ** 2, f"{len(cells)} cells")
lo, hi = ranges(values, cells)["isothermality"]
require(0 <= lo and hi <= 1, f"isothermality from {lo} to {hi}")
worst = drawn = 0
for i in cells:
    cell = values.GetCell(i)
    p, q, _ = (int(x) for x in values.GetCellData().GetArray("HigherOrderDegrees").GetTuple(i))
    for k in range(cell.GetNumberOfPoints()):
        r, s, _ = (cell.GetParametricCoords()[3 * k + d] for d in range(3))
        wanted = fields(cell, r, s)
        for name, x in zip(NAMES, wanted):
            found = values.GetPointData().GetArray(name).GetTuple1(cell.GetPointId(k))
            worst = max(worst, abs(found - x) / (1 + abs(x)))
    exact = coefficients.GetCell(i)
    for r, s in ((0.31, 0.47), (0.77, 0.12)):
        weights = located(exact, r, s)[1]
        for name, x in zip(NAMES, fields(cell, r, s)):
            array = coefficients.GetPointData().GetArray(name)
            found = sum(w * array.GetTuple1(exact.GetPointId(k)) for k, w in enumerate(weights))
            drawn = max(drawn, abs(found - x) / (1 + abs(x)))
print("values", worst, "drawn by coefficients", drawn, "isothermality", lo, hi, ranges(coefficients, cells)["isothermality"])
require(worst < 1e-8, f"a value is off by {worst}")
# 3e-9 and 4e-3 seen
require(drawn < 0.01, f"what coefficients draw is off by {drawn}")
