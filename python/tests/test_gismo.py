"""G+Smo's XML: a file written by hand against its closed form, round trips bit for bit, and what goes wrong."""
import base64

import numpy as np
import pytest

import taut
from taut import gismo

hypothesis = pytest.importorskip("hypothesis", reason="needs python3-hypothesis")
strategies = hypothesis.strategies

# A quarter of a ring between the radii 1 and 3: u runs outward, v around, so that u's pairs come first.
RING = """<?xml version="1.0" encoding="UTF-8"?>
<xml>
 <MultiPatch parDim="2" id="1"><patches type="id_range">0 0</patches></MultiPatch>
 <Geometry type="TensorNurbs2" id="0">
  <Basis type="TensorNurbsBasis2">
   <Basis type="TensorBSplineBasis2">
    <Basis type="BSplineBasis" index="0"><KnotVector degree="1">0 0 1 1 </KnotVector></Basis>
    <Basis type="BSplineBasis" index="1"><KnotVector degree="2">0 0 0 1 1 1 </KnotVector></Basis>
   </Basis>
   <weights>1 1 0.70710678118654757 0.70710678118654757 1 1</weights>
  </Basis>
  <coefs geoDim="2">1 0
3 0
1 1
3 3
0 1
0 3</coefs>
 </Geometry>
</xml>
"""


def file_of(folder, text):
    path = folder / "file.xml"
    path.write_text(text)
    return path


def test_ring(tmp_path):
    surface, = gismo.read(file_of(tmp_path, RING))
    u, v = np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 9))
    points = surface(u, v)  # 4.4e-16 from the circles
    assert np.abs(np.hypot(points[..., 0], points[..., 1]) - (1 + 2 * u)).max() < 1e-15 and not points[..., 2].any()
    assert (points[0, :, 1] == 0).all() and (points[-1, :, 0] == 0).all()  # from the x axis to the y axis


@hypothesis.settings(max_examples=60, deadline=None, suppress_health_check=list(hypothesis.HealthCheck))
@hypothesis.given(p=strategies.integers(1, 4), q=strategies.integers(1, 4), more=strategies.integers(0, 3),
                  rational=strategies.booleans(), seed=strategies.integers(0, 2**32 - 1))
def test_round_trip(tmp_path, p, q, more, rational, seed):
    random = np.random.default_rng(seed)
    u, v = taut.bspline(p, knots=[-1 / 3] * (p + 1) + sorted(random.uniform(0, 1, more)) + [1.1] * (p + 1)), taut.bspline(q, count=q + 1)
    size = (u.count, v.count)
    points, weights = random.standard_normal((*size, 3)), random.uniform(1, 2, size) if rational else None
    shapes = [taut.Surface(u, v, points, weights), taut.Curve(u, points[:, 0], weights[:, 0] if rational else None)]
    gismo.write(shapes, tmp_path / "out.xml")
    assert gismo.read(tmp_path / "out.xml") == shapes


def test_elements(tmp_path):
    """The order in the file, seen without the reader."""
    points = np.arange(18.).reshape(2, 3, 3)
    gismo.write([taut.Surface(taut.bspline(1, count=2), taut.bspline(2, count=3), points)], tmp_path / "out.xml")
    text = (tmp_path / "out.xml").read_text()
    assert 'type="TensorBSpline2"' in text and '<KnotVector degree="1">0.0 0.0 1.0 1.0</KnotVector>' in text
    assert '<coefs geoDim="3">0.0 1.0 2.0\n9.0 10.0 11.0\n3.0 4.0 5.0\n' in text


@pytest.mark.parametrize("old, new, where, reason", [
    ('"TensorNurbs2"', '"TensorNurbs3"', "Geometry/0", "value"),
    ('degree="1"', 'degree="one"', "Geometry/0/KnotVector/0", "type"),
    ('geoDim="2"', 'geoDim="4"', "Geometry/0/coefs", "value"),
    ("0 3</coefs>", "0</coefs>", "Geometry/0/coefs", "size"),
    ("0 3</coefs>", "0 x</coefs>", "Geometry/0/coefs", "type"),
    ("<weights>1 ", "<weights>", "Geometry/0/weights", "size"),
    ("<weights>", '<weights format="B64Int64">', "Geometry/0/weights", "value"),
    ("<weights>", '<weights format="B64Float64">', "Geometry/0/weights", "type"),
    ("<weights>1 1 0.70710678118654757 0.70710678118654757 1 1<", '<weights format="B64Float64">AAAA<', "Geometry/0/weights", "type"),
])
def test_wrong(tmp_path, old, new, where, reason):
    with pytest.raises(taut.InputError) as error:
        gismo.read(file_of(tmp_path, RING.replace(old, new)))
    assert (error.value.where, error.value.reason) == (where, reason)


def test_as_splinepy_writes(tmp_path):
    """Base64, curves as tensors of one direction, boundary conditions beside: as splinepy's exporter has them."""
    def binary(numbers, kind):
        return base64.b64encode(np.array(numbers, kind).tobytes()).decode()
    text = f"""<xml><!--generated--><MultiPatch id="0" parDim="1"><patches type="id_range">100 101</patches></MultiPatch>
<boundaryConditions id="1" multipatch="2"><bc type="Dirichlet" unknown="0">0 3</bc></boundaryConditions>
<Geometry id="100" type="TensorNurbs1"><Basis type="TensorNurbsBasis1"><Basis type="TensorBSplineBasis1"><Basis index="0" type="BSplineBasis">
<KnotVector degree="2" format="B64Float64">{binary([0, 0, 0, 1, 1, 1], "<f8")}</KnotVector></Basis></Basis>
<weights format="B64Float32">{binary([1, 0.5, 1], "<f4")}</weights></Basis>
<coefs format="B64Float64" geoDim="2">{binary([1, 0, 1, 1, 0, 1 / 3], "<f8")}</coefs></Geometry>
<Geometry id="101" type="TensorBSpline1"><Basis type="TensorBSplineBasis1"><Basis index="0" type="BSplineBasis">
<KnotVector degree="1" format="ASCII">0.0 0.0 1.0 1.0</KnotVector></Basis></Basis>
<coefs format="ASCII" geoDim="2">1.0 2.0
3.0 4.0</coefs></Geometry></xml>"""
    arc, line = gismo.read(file_of(tmp_path, text))
    assert arc == taut.Curve(taut.bspline(2, count=3), [[1, 0, 0], [1, 1, 0], [0, 1 / 3, 0]], [1, 0.5, 1])
    assert line == taut.Curve(taut.bspline(1, count=2), [[1, 2, 0], [3, 4, 0]])


def test_wrong_values(tmp_path):
    """What the bases and nets themselves refuse."""
    for old, new in (("0 0 1 1 <", "0 0 1 nan <"), ("1 1 0.7", "1 -1 0.7"), ("3 3", "3 inf")):
        with pytest.raises(taut.InputError):
            gismo.read(file_of(tmp_path, RING.replace(old, new)))


def test_wrong_files(tmp_path):
    with pytest.raises(taut.InputError) as error:
        gismo.read(file_of(tmp_path, RING[:100]))
    assert error.value.reason == "syntax"
    with pytest.raises(taut.FileError):
        gismo.read(tmp_path / "none.xml")
    with pytest.raises(taut.FileError):
        gismo.write([], tmp_path / "none" / "out.xml")


def test_tolerance(tmp_path):
    """A basis of sines is written within the tolerance."""
    curve, t = taut.Curve(taut.c_bezier(1.2), np.eye(4, 3)), np.linspace(0, 1.2, 50)
    gismo.write([curve], tmp_path / "out.xml", tolerance=1e-6)
    spline, = gismo.read(tmp_path / "out.xml")
    assert 0 < np.abs(spline(t * spline.t.range[1] / 1.2) - curve(t * curve.t.range[1] / 1.2)).max() < 1e-6
