"""read_cloth_freecad.py, by freecadcmd, with MODEL and DRAWING in the environment -- cloth to cut as FreeCAD's reader of DXF has it: layers,
closed outlines with their areas, the lines to sew along as long as the flat edges, the roll, names. Prints "CLOTH True" or what is wrong.
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


details = json.load(open(os.environ["MODEL"]))["details"]
document = FreeCAD.newDocument("cloth")
settings = "User parameter:BaseApp/Preferences/Mod/Draft"
FreeCAD.ParamGet(settings).SetBool("dxfUseLegacyImporter", False)
FreeCAD.ParamGet(settings).SetBool("groupLayers", True)
FreeCAD.ParamGet(settings).SetBool("dxftext", True)
Import.readDXF(os.environ["DRAWING"], document.Name, True, settings)
layers = {o.Label: [Part.Wire(edges) for edges in Part.sortEdges(o.Shape.Edges)] for o in document.Objects if hasattr(o, "Shape")}
texts = Counter(text for o in document.Objects if o.TypeId == "App::Annotation" for text in o.LabelText)
pieces, roll = details["pieces"], details["roll"]
require(set(layers) == {"CUT", "SEW", "MARK", "ROLL"}, f"layers {sorted(layers)}")
for layer, count in (("CUT", len(pieces)), ("SEW", len(pieces)), ("ROLL", 1)):
    wires = layers.get(layer, [])
    require(len(wires) == count and all(wire.isClosed() for wire in wires), f"{layer}: {len(wires)} lines, {[w.isClosed() for w in wires]}")
near = lambda found, expected, share: abs(found - expected) <= share * expected
areas = sorted(Part.Face(wire).Area for wire in layers.get("CUT", []))
require(all(near(a, b, 1e-4) for a, b in zip(areas, sorted(p["cut_area"] for p in pieces))), f"areas {areas}")
lengths = sorted(wire.Length for wire in layers.get("SEW", []))
told = sorted(sum(edge["flat_length"] for edge in p["edges"].values()) for p in pieces)
require(all(near(a, b, 1e-5) for a, b in zip(lengths, told)), f"lengths {lengths}, not {told}")
box = layers["ROLL"][0].BoundBox if "ROLL" in layers else None
require(box is not None and near(box.XLength, roll["length"], 1e-9) and near(box.YLength, roll["width"], 1e-9), f"roll {box}")
for piece in pieces:
    require(texts[piece["name"]] == 1, f"{piece['name']} has no name")
for seam in details["seams"]:
    require(all(texts[f"{seam['name']}: {name}"] == 1 for name in seam["pieces"]), f"{seam['name']} has no names")
    require(texts["1"] >= 2, "marks have no numbers")
print("")
print("CLOTH", not wrong, *wrong)
