"""What is installed from the wheel stands alone: nothing of the sources, of the build or of the system's library has a part in it."""
import os
import pathlib
import subprocess
import sys
import zipfile

import pytest
from conftest import ROOT

import taut

pytestmark = pytest.mark.skipif("TAUT_WHEEL" not in os.environ, reason="of the wheel: tools/python.sh wheel")
HERE = pathlib.Path(taut.__file__).resolve().parent
ALONE = """
import pathlib, sys
import taut
here = pathlib.Path(taut.__file__).resolve().parent
model = taut.make(sys.argv[1])
assert model.certificate.holds
for ending in ("step", "png", "pdf", "svg", "html", "obj"):
    model.write(f"roof.{ending}")
again = taut.read("roof.step")  # by taut-cad, which the wheel carries
assert abs(again.surfaces[0].points - model.surfaces[0].points).max() < 1e-12
loaded = {line.split()[-1] for line in open("/proc/self/maps") if "taut" in line.split()[-1]} if sys.platform == "linux" else {taut._library.library._name}
print(*sorted(loaded), sep="\\n")
"""


def wheel():
    """The path of the wheel that the package was installed from."""
    (path,) = pathlib.Path(HERE.parents[1]).glob("*.whl")
    return path


def test_is_what_was_installed():
    assert ROOT / "python" not in HERE.parents and pathlib.Path(taut._library.library._name).parent == HERE / "lib"


def test_alone(tmp_path):
    """In an empty folder, with no variable that says where anything is: all that is loaded is the wheel's."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("TAUT_", "PYTHONPATH"))}
    done = subprocess.run([sys.executable, "-c", ALONE, str(ROOT / "examples/dirichlet-tent.json")], cwd=tmp_path, capture_output=True, text=True,
                          env={**environment, "PYTHONPATH": str(HERE.parent)}, check=False)
    assert done.returncode == 0, done.stderr
    loaded = done.stdout.split()
    assert loaded and all(pathlib.Path(path).is_relative_to(HERE / "lib") for path in loaded), loaded


def test_is_of_any_python_and_needs_numpy_alone():
    with zipfile.ZipFile(wheel()) as files:
        names = files.namelist()
        text = {name.rsplit("/", 1)[1]: files.read(name).decode() for name in names if name.endswith((".dist-info/METADATA", ".dist-info/WHEEL", ".dist-info/RECORD"))}
        modules = {name for name in names if name.startswith("taut/") and name.endswith((".py", "py.typed"))}
        for name in modules:
            assert files.read(name) == (ROOT / "python" / name).read_bytes(), name
    assert f"Tag: {'-'.join(wheel().stem.split('-')[2:])}" in text["WHEEL"] and "\nTag: py3-none-" in text["WHEEL"]
    needed = [line for line in text["METADATA"].splitlines() if line.startswith("Requires-Dist:") and "extra ==" not in line]
    assert len(needed) == 1 and "numpy" in needed[0] and "Requires-Python: >=3.9" in text["METADATA"]
    assert modules == {str(path.relative_to(ROOT / "python")) for path in (ROOT / "python/taut").glob("*.py")} | {"taut/py.typed"}
    assert all(name in text["RECORD"] for name in names)
