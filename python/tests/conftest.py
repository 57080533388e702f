"""Where the library, the program and the examples are."""
import json
import os
import pathlib
import sys

import numpy
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("TAUT_BUILD", ROOT / "build/release"))
if "TAUT_WHEEL" not in os.environ:  # else the package that is installed
    os.environ.setdefault("TAUT_LIBRARY", str(BUILD / "libtaut.so.0"))
    sys.path.insert(0, str(ROOT / "python"))


@pytest.fixture(scope="session")
def program():
    """The path of the program."""
    return str(BUILD / "bin/taut")


@pytest.fixture(scope="session")
def examples():
    """The paths of the examples, by name."""
    return {path.stem: path for path in sorted((ROOT / "examples").glob("*.json"))}


@pytest.fixture
def net():
    """The boundary of a 5 x 6 net, NaN inside."""
    random = numpy.random.default_rng(5)
    x, y = numpy.meshgrid(numpy.linspace(0, 1, 5), numpy.linspace(0, 2, 6), indexing="ij")
    points = numpy.stack([x, y, random.standard_normal(x.shape)], axis=-1)
    points[1:-1, 1:-1] = numpy.nan
    return points


def names(kind=""):
    """The examples' names."""
    return sorted(path.stem for path in (ROOT / "examples").glob(kind + "*.json"))


def document(path):
    """A file's JSON."""
    return json.loads(pathlib.Path(path).read_text())
