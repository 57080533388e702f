"""read_vtu.py TUBE.vtu QUASI.vtu -- reads both with VTK: kinds of cells, points on the surface, fields.

The tube of tests/cli/test_mesh_files.sh has radius 1 and height 2: points at distance 1 from the axis, |H| = 1/2, K = 0."""

import math
import sys

from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

BEZIER, QUAD, POLY_LINE = 77, 9, 4
failures = 0


def complain(what):
    global failures
    failures += 1
    print("FAILED:", what)


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def cells(grid, part):
    of = grid.GetCellData().GetArray("part")
    return [i for i in range(grid.GetNumberOfCells()) if of.GetTuple1(i) == part]


def values_at(grid, cell, r, s, name):
    """A point of a cell and a field there, by VTK's own shape functions."""
    point, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
    cell.EvaluateLocation(mutable(0), [r, s, 0], point, weights)
    array = grid.GetPointData().GetArray(name)
    value = sum(w * array.GetTuple1(cell.GetPointId(i)) for i, w in enumerate(weights))
    return point, value


tube = read(sys.argv[1])
names = {tube.GetPointData().GetArrayName(i) for i in range(tube.GetPointData().GetNumberOfArrays())}
if not {"H", "K", "E_minus_G", "F", "isothermality", "RationalWeights"} <= names:
    complain(f"fields {names}")
surface = tube.GetCellData().GetArray("surface")
exact = [i for i in cells(tube, 0) if surface.GetTuple1(i) == 0]
if not exact or any(tube.GetCellType(i) != BEZIER for i in exact):
    complain("the tube is not all Bezier cells")
if any(tube.GetCellType(i) != QUAD for i in cells(tube, 0) if surface.GetTuple1(i) == 1):
    complain("the c- and h- surface is not all quads")
if any(tube.GetCellType(i) != POLY_LINE for i in cells(tube, 1)) or not cells(tube, 1):
    complain("the nets are not lines")
for i in exact:
    cell = tube.GetCell(i)
    for r, s in ((0, 0), (0.37, 0.61), (1, 0.2), (0.9, 1)):
        point, mean = values_at(tube, cell, r, s, "H")
        if abs(math.hypot(point[0], point[1]) - 1) > 1e-14:
            complain(f"cell {i}: a point {math.hypot(point[0], point[1]) - 1} off the tube")
        if abs(abs(mean) - 0.5) > 1e-9:
            complain(f"cell {i}: H is {mean}")
        if abs(values_at(tube, cell, r, s, "K")[1]) > 1e-9:
            complain(f"cell {i}: K is not 0")
quasi = read(sys.argv[2])
if any(math.isnan(quasi.GetPointData().GetArray("H").GetTuple1(p))
       for i in cells(quasi, 0) for p in [quasi.GetCell(i).GetPointId(0)]):
    complain("H is missing on the c- and h- surface")
sys.exit(failures > 0)
