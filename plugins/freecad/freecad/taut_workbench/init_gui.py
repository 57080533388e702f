"""The workbench in FreeCAD's window: commands on what is selected, each one step of undo."""
import os

import FreeCAD
import FreeCADGui

ICONS = os.path.join(os.path.dirname(__file__), "icons")


class ViewProvider:
    """The icon in the tree."""

    def __init__(self, view, icon):
        self.icon = icon
        view.Proxy = self

    def getIcon(self):
        return os.path.join(ICONS, self.icon + ".svg")

    def dumps(self):
        return self.icon

    def loads(self, state):
        self.icon = state or "taut"

    __getstate__, __setstate__ = dumps, loads


class Command:
    """Makes a feature of the selection."""

    def __init__(self, proxy, member, kinds, count, icon, text, tip, **values):
        self.proxy, self.member, self.kinds, self.count, self.icon, self.text, self.tip = proxy, member, kinds, count, icon, text, tip
        self.values = values

    def GetResources(self):
        return {"Pixmap": os.path.join(ICONS, self.icon + ".svg"), "MenuText": self.text, "ToolTip": self.tip}

    def selected(self):
        """(object, [names]) of what fits, as links want it."""
        from . import features
        found = []
        for one in FreeCADGui.Selection.getSelectionEx()[:self.count + 1]:
            names = one.SubElementNames or (features.whole(one.Object.Shape, self.kinds) if hasattr(one.Object, "Shape") else [])
            found.append((one.Object, [name for name in names if name.startswith(self.kinds)]))
        return [(source, names) for source, names in found if names]

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and sum(len(names) for _, names in self.selected()) == self.count

    def Activated(self):
        from . import features
        document, selected = FreeCAD.ActiveDocument, self.selected()
        document.openTransaction(self.text)
        try:
            obj = features.add(document, getattr(features, self.proxy), self.text.split()[0], **{self.member: selected}, **self.values)
            ViewProvider(obj.ViewObject, self.icon)
            document.recompute()
        except BaseException:
            document.abortTransaction()
            raise
        document.commitTransaction()


EDGES = "between four selected edges, which close a ring; it follows them when they move"
COMMANDS = {
    "Taut_Dirichlet": Command("Between", "Edges", ("Edge",), 4, "dirichlet", "Dirichlet surface", f"The surface of least Dirichlet energy {EDGES}",
                              Construction="Dirichlet"),
    "Taut_LeastArea": Command("Between", "Edges", ("Edge",), 4, "least", "Least area", f"The surface of least area {EDGES}", Construction="Least area"),
    "Taut_Harmonic": Command("Between", "Edges", ("Edge",), 4, "harmonic", "Harmonic surface", f"The harmonic surface through the first of and its "
                             f"opposite edge, {EDGES}", Construction="Harmonic"),
    "Taut_Asymptotic": Command("Between", "Edges", ("Edge",), 4, "asymptotic", "Asymptotic patch", f"The patch whose edges are asymptotic curves, {EDGES}",
                               Construction="Asymptotic"),
    "Taut_Blend": Command("Blend", "Ends", ("Face", "Edge"), 2, "pipe", "Pipe blend", "A pipe between two selected cylinders or straight edges"),
    "Taut_Join": Command("Join", "Faces", ("Face",), 2, "join", "Join report", "How two selected faces meet: gap, angles, order of contact"),
}


class TautWorkbench(FreeCADGui.Workbench):
    """Surfaces with proofs."""

    MenuText = "Taut"
    ToolTip = "Surfaces drawn tight across their boundaries, each with a certificate"
    Icon = os.path.join(ICONS, "taut.svg")

    def Initialize(self):
        for name, command in COMMANDS.items():
            FreeCADGui.addCommand(name, command)
        self.appendToolbar("Taut", list(COMMANDS))
        self.appendMenu("Taut", list(COMMANDS))

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(TautWorkbench())
