"""read_laths_freecad.py, by freecadcmd, with MODEL and DRAWING in the environment -- laths to cut as FreeCAD's reader of DXF has them: layers, closed
outlines with the areas of the model's, slots as many and as large, sheets, a name at both ends. Prints "LATHS True" or what is wrong.
"""

import json
import os
from collections import Counter

import FreeCAD
import Import
import Part

wrong = []


def require(holds, text):
    if not holds:
        wrong.append(text)


def near(found, expected, share):
    return len(found) == len(expected) and all(abs(a - b) <= share * abs(b) for a, b in zip(sorted(found), sorted(expected)))


def area_of(outline):
    return abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(outline, outline[1:] + outline[:1]))) / 2


details = json.load(open(os.environ["MODEL"]))["details"]
document = FreeCAD.newDocument("laths")
settings = "User parameter:BaseApp/Preferences/Mod/Draft"
FreeCAD.ParamGet(settings).SetBool("dxfUseLegacyImporter", False)
FreeCAD.ParamGet(settings).SetBool("groupLayers", True)
FreeCAD.ParamGet(settings).SetBool("dxftext", True)
Import.readDXF(os.environ["DRAWING"], document.Name, True, settings)
layers = {o.Label: [Part.Wire(edges) for edges in Part.sortEdges(o.Shape.Edges)] for o in document.Objects if hasattr(o, "Shape")}
texts = Counter(text for o in document.Objects if o.TypeId == "App::Annotation" for text in o.LabelText)
pieces, sheets = details["pieces"], details["sheets"]
slots = [slot["outline"] for piece in pieces for slot in piece["slots"]]
require(set(layers) == {"CUT", "SLOT", "ENGRAVE", "SHEET"}, f"layers {sorted(layers)}")
expected = {"CUT": [piece["outline"] for piece in pieces], "SLOT": slots}
expected["SHEET"] = [[[0, 0], [s["size"][0], 0], s["size"], [0, s["size"][1]]] for s in sheets]
for layer, outlines in expected.items():
    wires = layers.get(layer, [])
    require(len(wires) == len(outlines) and all(wire.isClosed() for wire in wires), f"{layer}: {len(wires)} of {len(outlines)}, or open")
    if not wrong:
        found = [Part.Face(wire).Area for wire in wires]
        require(near(found, [area_of(outline) for outline in outlines], 1e-6), f"{layer}: areas {found}")
for piece in pieces:
    require(texts[piece["name"]] >= 2, f"{piece['name']} has no name at both ends")
print("")
print("LATHS", not wrong, *wrong)
