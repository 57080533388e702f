"""Runs in pvpython: the reader as ParaView's own proxy, on a model, a problem, what is changed in it, and nonsense."""
import io
import json
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

given = json.loads(os.environ["TAUT_TEST"])
simple.LoadPlugin(given["reader"], remote=False, ns=globals())


def state(proxy):
    proxy.UpdatePipeline()
    grid = servermanager.Fetch(proxy)
    fields = grid.GetFieldData()
    found = {"cells": [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())], "points": vtk_to_numpy(grid.GetPoints().GetData()).tolist() if grid.GetPoints() else []}
    found["kind"] = str(vtk_to_numpy(grid.GetPoints().GetData()).dtype) if grid.GetPoints() else ""
    found["arrays"] = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
    found["fields"] = {}
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetAbstractArray(i)
        if str(array.GetName()).startswith("taut") or array.GetName() == "area":
            found["fields"][array.GetName()] = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
    if 77 in found["cells"]:
        cell, place, weights, sub = grid.GetCell(found["cells"].index(77)), [0.0] * 3, [0.0] * 400, 0
        from vtkmodules.vtkCommonCore import reference
        cell.EvaluateLocation(reference(0), [0.25, 0.5, 0.0], place, weights)
        found["place"] = place
    return found


result = {}
reader = Taut(FileName=given["model"])
result["model"] = state(reader)
result["problem"] = state(Taut(FileName=given["problem"]))
live = Taut(FileName=given["live"])
result["live"] = state(live)
with open(given["problem"], encoding="utf-8") as file:
    changed = json.load(file)
changed["points"][0][1][2] += 0.5
with open(given["live"], "w", encoding="utf-8") as file:
    json.dump(changed, file)
live.InvokeCommand("Read again")
result["changed"] = state(live)
result["bad"] = state(Taut(FileName=given["bad"]))["cells"]
result["not json"] = state(Taut(FileName=given["not_json"]))["cells"]
told = Taut(FileName=given["told"])
result["told"] = state(told)["fields"]
told.InvokeCommand("Prove again")
said, sys.stderr = sys.stderr, io.StringIO()
result["proved again"] = state(told)["fields"]
said, sys.stderr = sys.stderr.getvalue(), said
result["said"] = said
result["no claims"] = state(Taut(FileName=given["no_claims"]))["fields"]
result["odd"] = {}
for name in ("five", "null", "deep"):
    path = os.path.join(given["folder"], name + ".json")
    with open(path, "w", encoding="utf-8") as file:
        file.write({"five": "5", "null": "null", "deep": "[" * 100000}[name])
    result["odd"][name] = state(Taut(FileName=path))["cells"]
result["extension"] = type(simple.OpenDataFile(given["model"])).__name__
print("RESULT " + json.dumps(result), flush=True)
os._exit(0)
