"""The zips of `make plugins`, installed as their pages say, in hosts that see nothing of the build: no path, no library of ours."""
import json
import os
import pathlib
import shutil
import subprocess
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROBLEM = {"taut": 1, "construct": "dirichlet", "u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 2},
           "points": [[[-1, -1, 0], [-1, 0, 1], [-1, 1, 0]], [[0, -1, 1], None, [0, 1, 1]], [[1, -1, 0], [1, 0, 1], [1, 1, 0]]]}

# Edit > Preferences > Add-ons > Install..., and its check mark
BLENDER = """
import json, sys
import bpy
bpy.ops.preferences.addon_install(filepath=sys.argv[-1])
bpy.ops.preferences.addon_enable(module="taut_surfaces")
import taut_surfaces, taut
curves = []
for a, b in (((0, 0, 0), (1, 0, .5)), ((1, 0, .5), (1, 1, 0)), ((1, 1, 0), (0, 1, .5)), ((0, 1, .5), (0, 0, 0))):
    data = bpy.data.curves.new("edge", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(1)
    for point, place in zip(spline.points, (a, b)):
        point.co = (*place, 1)
    one = bpy.data.objects.new("edge", data)
    bpy.context.collection.objects.link(one)
    one.select_set(True)
    curves.append(one)
bpy.context.view_layer.objects.active = curves[0]
bpy.context.scene.taut.construct = "dirichlet"
bpy.ops.taut.between()
made = bpy.context.view_layer.objects.active
print("RESULT " + json.dumps({"says": made["taut_certificate"], "taut": taut.__file__, "add-on": taut_surfaces.__file__}), flush=True)
"""

# The folder of add-ons; what its manager reads of package.xml
FREECAD = """
import json, os
import FreeCAD, Part
from freecad.taut_workbench import features
import taut
mod = os.path.join(FreeCAD.getUserAppDataDir(), "Mod", "taut")
about = FreeCAD.Metadata(os.path.join(mod, "package.xml"))
corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 5), (10, 10, 0), (0, 10, 5))]
document = FreeCAD.newDocument()
links = []
for i in range(4):
    edge = document.addObject("Part::Feature", "Edge%d" % i)
    edge.Shape = Part.makeLine(corners[i], corners[(i + 1) % 4])
    links.append((edge, ["Edge1"]))
made = features.add(document, features.Between, "Made", Edges=links, Construction="Dirichlet")
document.recompute()
print("RESULT " + json.dumps({"says": made.Holds, "taut": taut.__file__, "add-on": features.__file__, "name": about.Name, "version": about.Version,
                              "workbenches": len(about.Content.get("workbench", []))}), flush=True)
os._exit(0)
"""

# Tools > Manage Plugins > Load New
PARAVIEW = """
import json, os
from paraview import servermanager, simple
simple.LoadPlugin(os.environ["FOLDER"] + "/taut_reader.py", remote=False, ns=globals())
reader = Taut(FileName=os.environ["PROBLEM"])
reader.UpdatePipeline()
says = servermanager.Fetch(reader).GetFieldData().GetAbstractArray("taut certificate").GetValue(0)
import taut
print("RESULT " + json.dumps({"says": says, "taut": taut.__file__}), flush=True)
"""


@pytest.fixture(scope="module")
def zips():
    done = subprocess.run([str(ROOT / "tools/plugins.sh"), "zip"], capture_output=True, text=True, cwd=ROOT, timeout=300)
    assert done.returncode == 0, done.stderr
    return ROOT / "build/plugins"


@pytest.fixture
def start(tmp_path):
    """start(words, **more): what a host prints as JSON, in a home of its own, without anything of the build."""

    def run(words, **more):
        if shutil.which(words[0]) is None:
            pytest.skip(f"there is no {words[0]} here: tools/deps.sh hosts")
        clean = {name: value for name, value in os.environ.items() if not name.startswith(("TAUT", "PYTHON", "LD_"))}
        done = subprocess.run(words, env={**clean, "HOME": str(tmp_path), "LIBGL_ALWAYS_SOFTWARE": "1", **more}, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, cwd=tmp_path, timeout=200)
        lines = [line for line in done.stdout.splitlines() if "RESULT " in line]
        assert lines, f"{words[0]} ended with {done.returncode}:\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}"
        return json.loads(lines[-1].split("RESULT ", 1)[1])

    return run


def test_blender(zips, start, tmp_path):
    script = tmp_path / "install.py"
    script.write_text(BLENDER)
    found = start(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", str(script), "--", str(zips / "taut-blender.zip")])
    assert found["says"].startswith("dirichlet: holds")
    for name in ("taut", "add-on"):
        assert found[name].startswith(str(tmp_path)) and "taut_surfaces" in found[name], found


def test_freecad(zips, start, tmp_path):
    folder = tmp_path / ".local/share/FreeCAD/Mod/taut"
    folder.mkdir(parents=True)
    zipfile.ZipFile(zips / "taut-freecad.zip").extractall(folder)
    script = tmp_path / "use.py"
    script.write_text(FREECAD)
    found = start(["freecadcmd", str(script)])
    assert found["says"] == "holds" and found["workbenches"] == 1 and "Taut" in found["name"]
    for name in ("taut", "add-on"):
        assert found[name].startswith(str(folder)), found


def test_paraview(zips, start, tmp_path):
    folder, problem, script = tmp_path / "taut-paraview", tmp_path / "problem.json", tmp_path / "use.py"
    zipfile.ZipFile(zips / "taut-paraview.zip").extractall(folder)
    problem.write_text(json.dumps(PROBLEM))
    script.write_text(PARAVIEW)
    found = start(["pvpython", "--force-offscreen-rendering", str(script)], FOLDER=str(folder), PROBLEM=str(problem), PYTHONPATH=str(folder / "compat"))
    assert found["says"] == "dirichlet: holds" and found["taut"].startswith(str(folder)), found


def test_grasshopper(zips):
    """What Rhino's script editor is given: the components, whose first line asks its package manager for taut."""
    with zipfile.ZipFile(zips / "taut-grasshopper.zip") as archive:
        names = set(archive.namelist())
        assert {"taut_between.py", "taut_pipe.py", "LICENSE"} <= names
        for name in ("taut_between.py", "taut_pipe.py"):
            assert "# r: taut" in archive.read(name).decode().splitlines()
