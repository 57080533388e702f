"""The notebooks run from top to bottom; what a notebook shows; plots. By Jupyter's own client where it is installed, else cell by cell."""
import base64
import importlib.util
import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import taut
from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))
RUN = """
import ast, json, sys
names, shown = {}, 0
for cell in json.load(open(sys.argv[1], encoding="utf-8"))["cells"]:
    if cell["cell_type"] == "code":
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, sys.argv[1], "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), sys.argv[1], "eval"), names)
            text = value._repr_html_() if hasattr(value, "_repr_html_") else repr(value)
            assert text
            shown += 1
print(shown)
"""


def environment():
    """This package, whatever else is installed."""
    return {**os.environ, "PYTHONPATH": str(pathlib.Path(taut.__file__).parents[1])}


def test_there_are_three():
    assert [path.stem for path in NOTEBOOKS] == ["areas", "sweep", "tent"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4 and len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in notebook["cells"] if cell["cell_type"] == "code")
    done = subprocess.run([sys.executable, "-c", RUN, path.name], cwd=path.parent, capture_output=True, text=True, env=environment(), check=False)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.split()[-1]) > 0


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_by_jupyter(path):
    nbclient = pytest.importorskip("nbclient", reason="needs python3-nbclient")
    nbformat = pytest.importorskip("nbformat", reason="needs python3-nbformat")
    if importlib.util.find_spec("ipykernel") is None:
        pytest.skip("needs python3-ipykernel")
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(path.parent)}}).execute(env=environment())
    shown = [output["data"] for cell in notebook["cells"] for output in cell.get("outputs", ()) if "<iframe" in "".join(output.get("data", {}).get("text/html", ""))]
    for data in shown:  # a model: the page, and a picture for where pages are not shown
        assert base64.b64decode("".join(data["image/png"]))[1:4] == b"PNG" and "taut.Model" in data["text/plain"]
    assert shown or path.stem != "tent"


def test_plot(examples):
    matplotlib = pytest.importorskip("matplotlib", reason="needs python3-matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot
    model = taut.make(examples["dirichlet-tent"])
    surface = model.surfaces[0]
    ax = surface.plot(net=True, color="tab:blue")
    assert len(ax.lines) == sum(surface.points.shape[:2])
    low, high = np.array(taut.measure(surface)["bounding_box"])
    limits = np.array([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    assert (limits[:, 0] <= low + 1e-9).all() and (limits[:, 1] >= high - 1e-9).all()
    assert model.plot(ax) is ax
    ax.figure.canvas.draw()
    curve = taut.Curve(taut.bezier(2), [[0, 0, 0], [1, 1, 0], [2, 0, 1]])
    ax = curve.plot(color="k")
    assert np.allclose(np.array(ax.lines[0].get_data_3d()).T[[0, -1]], curve.points[[0, -1]])
    pyplot.close("all")


def test_plot_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="python3-matplotlib"):
        taut.Surface(taut.bezier(1), taut.bezier(1), np.zeros((2, 2, 3))).plot()
