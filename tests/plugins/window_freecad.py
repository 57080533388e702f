"""Runs in FreeCAD's window: the command on a selection, undo, redo; then leaves the window as it is for a picture. Prints RESULT."""
import json
import os
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtCore, QtWidgets

given = json.loads(os.environ["TAUT_TEST"])
V = FreeCAD.Vector


def run():
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Start").SetBool("ShowOnStartup", False)
    FreeCADGui.activateWorkbench("TautWorkbench")
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)
    window = FreeCADGui.getMainWindow()
    window.resize(1280, 800)
    window.move(0, 0)
    document = FreeCAD.newDocument("Tent")
    document.UndoMode = 1
    for i, points in enumerate(given["edges"]):
        curve = Part.BezierCurve()
        curve.setPoles([V(*p) for p in points])
        source = document.addObject("Part::Feature", f"Edge{i}")
        source.Shape = curve.toShape()
        source.ViewObject.LineWidth = 4
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    for i in range(4):
        FreeCADGui.Selection.addSelection("Tent", f"Edge{i}", "Edge1")
    FreeCADGui.runCommand("Taut_LeastArea")
    made = [one for one in document.Objects if hasattr(one, "Construction")]
    result = {"made": len(made), "holds": made[0].Holds, "area": made[0].Shape.Area, "undo": document.UndoNames[:1]}
    document.undo()
    result["after undo"] = len([one for one in document.Objects if hasattr(one, "Construction")])
    document.redo()
    document.recompute()
    made = [one for one in document.Objects if hasattr(one, "Construction")]
    result["after redo"] = len(made)
    FreeCADGui.Selection.clearSelection()
    for i in range(4):
        FreeCADGui.Selection.addSelection("Tent", f"Edge{i}")  # as in the tree
    FreeCADGui.runCommand("Taut_Dirichlet")
    result["of whole objects"] = len([one for one in document.Objects if hasattr(one, "Construction")])
    document.undo()
    made[0].ViewObject.ShapeColor = (0.95, 0.65, 0.35)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(made[0])
    for dock in window.findChildren(QtWidgets.QDockWidget):
        if dock.objectName() in ("Report view", "Combo View"):
            dock.show()
    FreeCADGui.activeDocument().activeView().viewIsometric()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.updateGui()
    return result


def begin():
    try:
        os.write(1, f"RESULT {json.dumps(run())}\n".encode())  # FreeCAD shows what is printed
        QtCore.QTimer.singleShot(2500, picture)
    except BaseException:
        traceback.print_exc()
        os._exit(1)


def picture():
    if given.get("picture"):
        screen = QtWidgets.QApplication.primaryScreen()
        screen.grabWindow(0).save(given["picture"])
    os._exit(0)


QtCore.QTimer.singleShot(1500, begin)
