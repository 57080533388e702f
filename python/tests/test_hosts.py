"""What the plug-ins stand on."""
import itertools
import json
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import taut
from taut import hosts

CORNERS = np.array([[0, 0, 0], [2, 0, 1], [2, 3, 0], [0, 3, 1.0]])
BULGE = [[0, -.5, .4], [.3, 0, -.2], [0, .4, .5], [-.2, 0, .1]]


def ring():
    """Four cubics that close."""
    edges = []
    for i in range(4):
        a, b = CORNERS[i], CORNERS[(i + 1) % 4]
        edges.append(taut.Curve(taut.bezier(3), [a, a + (b - a) / 3 + BULGE[i], b - (b - a) / 3 + BULGE[i], b]))
    return edges


def test_between_equals_the_program(program, tmp_path):
    for construct in ("dirichlet", "plateau", "harmonic"):
        model = hosts.between(construct, ring())
        taut.Model(curves=ring()).write(tmp_path / "edges.json")
        (tmp_path / "problem.json").write_text(json.dumps({"taut": 1, "construct": construct, "boundary": "edges.json"}))
        done = subprocess.run([program, "make", str(tmp_path / "problem.json")], capture_output=True, text=True, check=True)
        theirs = taut.Model.from_json(done.stdout)
        assert np.abs(theirs.surfaces[0].points - model.surfaces[0].points).max() == 0, construct
        assert model.certificate.holds


def test_between_takes_any_order_and_direction():
    base = hosts.between("dirichlet", ring()).certificate.figures["dirichlet_energy"]
    for order in itertools.permutations(range(4)):
        edges = [ring()[i] for i in order]
        edges[order[0]] = taut.Curve(taut.bezier(3), edges[order[0]].points[::-1])
        assert hosts.between("dirichlet", edges).certificate.figures["dirichlet_energy"] == pytest.approx(base, rel=1e-13)


def test_between_asymptotic():
    """A saddle z = u v has straight edges, which are asymptotic curves of it; so has its patch of any degree."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0.0]])
    edges = [taut.Curve(taut.bspline(3, knots=[0] * 4 + [1] * 4),
                        [corners[i] + (corners[(i + 1) % 4] - corners[i]) * s / 3 for s in range(4)]) for i in range(4)]
    model = hosts.between("asymptotic", edges)
    assert model.certificate.holds and model.certificate["asymptotic"].holds


def test_between_refuses():
    with pytest.raises(taut.InputError) as caught:
        hosts.between("dirichlet", ring()[:3])
    assert (caught.value.reason, caught.value.found, caught.value.expected) == ("size", 3, 4)
    with pytest.raises(taut.InputError, match="expected one of dirichlet"):
        hosts.between("pipe", ring())
    apart = ring()
    apart[2] = taut.Curve(taut.bezier(3), apart[2].points + [0, 0, 1])
    with pytest.raises(taut.NoSolution) as caught:
        hosts.between("dirichlet", apart)
    assert caught.value.remedy and caught.value.remedy in hosts.told(caught.value) and caught.value.message in hosts.told(caught.value)
    assert hosts.told(ValueError("so")) == "so" and hosts.told(KeyboardInterrupt()) == "KeyboardInterrupt"


def test_blend_joins_the_nearest_ends():
    one, other = [[-60, 0, 0], [0, 0, 0]], [[240, 160, 120], [240, 300, 120]]
    model = hosts.blend(one, other, 20)
    direct = taut.make({"construct": "pipe", "radius": 20, "from": {"point": [0, 0, 0], "direction": [1, 0, 0]},
                        "to": {"point": [240, 160, 120], "direction": [0, 1, 0]}})
    assert model == direct and hosts.blend(one[::-1], other[::-1], [20, 20]) == direct
    two = hosts.blend(one, other, [20, 12])
    assert two.details["radii"] == [20, 12] and two.certificate.holds
    for bad in ([[0, 0, 0]] * 2, [[0, 0, 0], [np.nan, 0, 0]], [0, 0, 0]):
        with pytest.raises(taut.InputError, match="/to"):
            hosts.blend(one, bad, 1)


def test_nearest():
    model = taut.make({"construct": "pipe", "radius": 20, "from": {"point": [0, 0, 0], "direction": [1, 0, 0]},
                       "to": {"point": [240, 160, 120], "direction": [0, 1, 0]}})
    edge_a, edge_b, report = hosts.nearest(model["pipe1"], model["blend"])
    assert (edge_a, edge_b) == ("u1", "u0") and report == taut.join(model["pipe1"], "u1", model["blend"], "u0")


def test_spline_and_back():
    random = np.random.default_rng(1)
    knots = [0, 0, 0, 0, .25, .25, 1, 1, 1, 1]
    curve = taut.Curve(taut.bspline(3, knots=knots), random.standard_normal((6, 3)), random.uniform(1, 2, 6))
    shape = hosts.spline(curve)
    assert shape.knots == ([0, .25, 1],) and shape.multiplicities == ([4, 2, 4],) and shape.degrees == (3,)
    assert hosts.curve(3, knots, shape.points, shape.weights) == curve == hosts.curve(3, knots[1:-1], shape.points, shape.weights)
    assert hosts.curve(3, knots, shape.points, [2] * 6).weights is None
    patch = hosts.spline(taut.Surface(taut.bezier(2, [1, 3]), taut.bspline(1, count=3), random.standard_normal((3, 3, 3))))
    assert patch.knots == ([1, 3], [0, .5, 1]) and patch.multiplicities == ([3, 3], [2, 1, 2]) and patch.degrees == (2, 1)
    catenoid = taut.bonnet(lambda_=0.0, sign="+", alpha=1, beta=1).surfaces[0]
    nurbs = hosts.spline(catenoid, 1e-9)
    again = taut.Surface(*(taut.bspline(d, knots=np.repeat(k, m)) for d, k, m in zip(*nurbs[:3])), nurbs.points, nurbs.weights)
    (a, b), (c, d) = again.u.range, again.v.range
    (e, f), (g, h) = catenoid.u.range, catenoid.v.range
    assert np.abs(again((a + b) / 2, (c + d) / 2) - catenoid((e + f) / 2, (g + h) / 2)).max() < 1e-7
    for bad in ([0, 0, 0, 1, 2, 3, 3, 3], [0, 0, 0, 0, 1, 1, 1]):
        with pytest.raises(taut.InputError, match="clamped"):
            hosts.curve(3, bad, np.eye(4, 3))


def test_claims():
    certificate = hosts.between("dirichlet", ring()).certificate
    lines = hosts.claims(certificate)
    assert lines[0] == "dirichlet: holds" and any(line.startswith("stationary: holds (bound), ") for line in lines)
    assert f"area: {certificate.figures['area']:.10g}" in lines and hosts.claims(None) == ["no certificate"]


def test_remedies_are_those_of_the_headers():
    if "TAUT_WHEEL" not in __import__("os").environ:
        tool = pathlib.Path(__file__).resolve().parents[2] / "tools/python_reasons.py"
        subprocess.run([sys.executable, str(tool), "--check"], check=True)
    with pytest.raises(taut.InputError) as caught:
        taut.bezier(0)
    assert caught.value.remedy and taut.Error("", reason="no such word").remedy == ""
