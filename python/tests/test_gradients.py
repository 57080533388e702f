"""Derivatives against rational numbers, and against makes of moved problems."""
import copy
import fractions
import math

import numpy as np
import pytest

import taut
from conftest import document, names

F = fractions.Fraction


def bernstein_gram(n):
    """Exact mass and stiffness of the Bernstein functions of degree n on [0, 1]."""
    def mass(m):
        return [[F(math.comb(m, i) * math.comb(m, j), (2 * m + 1) * math.comb(2 * m, i + j)) for j in range(m + 1)] for i in range(m + 1)]
    lower, stiff = mass(n - 1), [[F(0)] * (n + 1) for _ in range(n + 1)]
    for i in range(n):
        for j in range(n):
            for a, s in ((i, -1), (i + 1, 1)):
                for b, t in ((j, -1), (j + 1, 1)):
                    stiff[a][b] += n * n * s * t * lower[i][j]
    return mass(n), stiff


def solved(matrix, right):
    """matrix^-1 right, in rationals."""
    rows = [row[:] + [value] for row, value in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i in range(len(rows)):
            if i != k and rows[i][k] != 0:
                rows[i] = [a - rows[i][k] * b for a, b in zip(rows[i], rows[k])]
    return [row[-1] for row in rows]


@pytest.mark.parametrize("degree", [2, 3, 4])
def test_dirichlet_in_rationals(degree):
    """The influence of each boundary point on a sum over the inner ones, by exact elimination."""
    n = degree + 1
    mass, stiff = bernstein_gram(degree)
    at = [(i, j) for i in range(n) for j in range(n)]

    def form(p, q):
        return stiff[p[0]][q[0]] * mass[p[1]][q[1]] + mass[p[0]][q[0]] * stiff[p[1]][q[1]]
    inside = [p for p in at if 0 < p[0] < degree and 0 < p[1] < degree]
    edge = [p for p in at if p not in inside]
    factors = {p: F(3 * p[0] - 2 * p[1] + 1, 7) for p in inside}
    adjoint = solved([[form(p, q) for q in inside] for p in inside], [factors[p] for p in inside])
    expected = {k: -sum(form(p, k) * l for p, l in zip(inside, adjoint)) for k in edge}

    points = np.random.default_rng(degree).standard_normal((n, n, 3))
    points[1:-1, 1:-1] = np.nan
    problem = {"construct": "dirichlet", "u": taut.bezier(degree), "v": taut.bezier(degree), "points": points}
    weights = np.zeros((n, n, 3))
    for p in inside:
        weights[p] = [float(factors[p]), 0, -2 * float(factors[p])]
    found = taut.gradient(problem, taut.make(problem), weights)
    for k in edge:
        assert abs(found[k][0] - float(expected[k])) < 1e-14 and found[k][1] == 0
        assert abs(found[k][2] + 2 * float(expected[k])) < 1e-14
    assert all((found[p] == 0).all() for p in inside)


LINEAR = [name for kind in ("dirichlet", "harmonic-rows", "harmonic-fit", "harmonic-even", "biharmonic-rows") for name in names(kind)
          if name != "dirichlet-through"]  # which has none: taut_gradient says so


def moved(problem, direction):
    """The problem with its known points moved."""
    return {**problem, "points": [[None if point is None else (np.array(point, dtype=float) + step).tolist()
                                   for point, step in zip(row, steps)] for row, steps in zip(problem["points"], direction)]}


@pytest.mark.parametrize("name", LINEAR)
def test_linear_examples(name, examples):
    problem = document(examples[name])
    model = taut.make(problem)
    shape = model.surfaces[0].points.shape
    random = np.random.default_rng(7)
    factors, direction = random.standard_normal(shape), random.standard_normal(shape)
    if problem.get("aspect") == "auto":
        with pytest.raises(taut.InputError) as caught:
            taut.gradient(problem, model, factors)
        assert caught.value.reason == "no-gradient"
        return
    found = taut.gradient(problem, model, factors)
    one, other = (taut.make(moved(problem, s * direction)).surfaces[0].points for s in (1, -1))
    by_points, by_gradient = (factors * (one - other) / 2).sum(), (found * direction).sum()
    # rounding of two makes and one adjoint, each of some hundred terms as large as those of the sums
    assert abs(by_points - by_gradient) < 1e-12 * (np.abs(factors * one).sum() + np.abs(found * direction).sum())
    assert np.abs(found.sum(axis=(0, 1)) - factors.sum(axis=(0, 1))).max() < 1e-12 * np.abs(factors).sum()  # of a translation


@pytest.mark.parametrize("method", ["full", "normal"])
def test_area_of_films(method, net):
    problem = {"construct": "plateau", "method": method, "least": False, "tolerance": 1e-12,
               "u": taut.bezier(4), "v": taut.bspline(3, count=6), "points": net * [1, 1, 0.2]}
    model = taut.make(problem)
    found = taut.gradient(problem, model)
    direction = np.random.default_rng(3).standard_normal(net.shape)

    def area(step):
        return taut.make({**problem, "points": problem["points"] + step * direction}).certificate.figures["area"]
    h = 1e-3
    difference = (8 * (area(h) - area(-h)) - (area(2 * h) - area(-2 * h))) / (12 * h)
    assert abs((found * direction).sum() - difference) < 1e-7 * np.abs(found * direction).sum()
    normal = np.abs(np.einsum("ijk,k->ij", found, np.ones(3)).sum())
    assert normal < 1e-9  # a film that is moved as a whole keeps its area
    assert abs((found * np.nan_to_num(problem["points"])).sum() - 2 * model.certificate.figures["area"]) < 1e-7  # one that grows


def test_descent(net):
    """What it is for: a boundary point goes where the film is smallest."""
    problem = {"construct": "dirichlet", "u": taut.bezier(4), "v": taut.bezier(5), "points": net}
    areas = []
    for _ in range(5):
        model = taut.make(problem)
        areas.append(model.certificate.figures["area"])
        step = taut.gradient(problem, model)
        problem = {**problem, "points": np.where(np.isnan(problem["points"]), np.nan, problem["points"] - 0.02 * step)}
    assert all(b < a for a, b in zip(areas, areas[1:]))


SAIL = {"construct": "film", "u": taut.bspline(4, count=8), "v": taut.bspline(4, count=8), "least": False, "tolerance": 1e-13,
        "corners": {"u0v0": [-1, -1, 0.5], "u1v0": [1, -1, -0.5], "u0v1": [-1, 1, -0.5], "u1v1": [1.2, 1.1, 0.6]},
        "edges": {"u0": {"cable": {"force": 2}}, "v0": {"cable": {"unstressed": 2.2, "stiffness": 30}}, "v1": {"cable": {"sag": 0.12}}}}


@pytest.mark.parametrize("of, edge", [("energy", "u0"), ("area", "u0"), ("length", "v1"), ("tension", "v0")])
def test_films(of, edge):
    """By corners and cables, one edge straight, against films made anew."""
    def figure(corner, force, sag):
        moved = {**SAIL, "corners": {**SAIL["corners"], "u1v1": corner.tolist()},
                 "edges": {**SAIL["edges"], "u0": {"cable": {"force": force}}, "v1": {"cable": {"sag": sag}}}}
        model = taut.make(moved)
        value = model.certificate.figures[{"length": "lengths", "tension": "tensions"}.get(of, of)]
        return value if of in ("energy", "area") else value[[cable["edge"] for cable in model.details["cables"]].index(edge)]

    def along(h):
        return figure(np.array(SAIL["corners"]["u1v1"]) + h * step, 2 + 0.4 * h, 0.12 + 0.02 * h)
    found, step, h = taut.film_gradient(SAIL, taut.make(SAIL), of, edge=edge), np.array([0.3, -0.5, 0.7]), 1e-3
    terms = [*(found.corners["u1v1"] * step), 0.4 * found.cables["u0"], 0.02 * found.cables["v1"]]
    difference = (8 * (along(h) - along(-h)) - (along(2 * h) - along(-2 * h))) / (12 * h)
    # two films differ by some 1e-11 of the number within themselves, which h makes 1e-8
    assert abs(sum(terms) - difference) < 1e-7 * (np.abs(terms).sum() + abs(along(0)))
    assert set(found.cables) == {"u0", "v0", "v1"} and set(found.stiffness) == {"v0"} and found.points.shape == (8, 8, 3)


def test_rings():
    """By the radius of a held circle and the force of the other edge's cable, against rings made anew."""
    def ring(h):
        return {"construct": "film", "u": taut.bspline(3, count=9), "v": taut.bspline(3, count=5), "seams": [["u0", "u1"]],
                "tolerance": 1e-12, "least": False,
                "edges": {"v0": {"fixed": {"circle": {"center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1 + h}}},
                          "v1": {"cable": {"force": 0.3 - 0.5 * h}, "plane": {"point": [0, 0, 0.2], "normal": [0, 0, 1]}}}}

    h, at = 1e-3, (1, -1, 2, -2)
    made, moved = taut.make(ring(0)), [taut.make(ring(k * h)) for k in at]

    def slope(values):
        return (8 * (values[0] - values[1]) - (values[2] - values[3])) / (12 * h)
    edge = slope([m.surfaces[0].points for m in moved])  # of the held edge, as it is fitted to its circle
    for of in ("energy", "area"):
        found = taut.film_gradient(ring(0), made, of)
        assert not any(corner.any() for corner in found.corners.values()) and set(found.cables) == {"v1"}
        terms = (found.points * edge).sum() - 0.5 * found.cables["v1"]
        assert abs(terms - slope([m.certificate.figures[of] for m in moved])) < 3e-8 * (1 + abs(terms))  # all coordinates are at rest to 1e-8


def test_energy_of_patches(examples):
    """A film of two patches has no gradient, but lengths of cables and reactions are those of its energy."""
    ridge, h = document(examples["film-ridge"]), 1e-2
    figures = taut.make(ridge).certificate.figures

    def energy(step, **moved):
        changed = copy.deepcopy(ridge)
        changed["seams"][0]["cable"]["force"] += step * moved.get("force", 0)
        changed["patches"][0]["corners"]["u0v0"][2] += step * moved.get("corner", 0)
        return taut.make(changed).certificate.figures["energy"]

    def slope(**moved):
        return (8 * (energy(h, **moved) - energy(-h, **moved)) - energy(2 * h, **moved) + energy(-2 * h, **moved)) / (12 * h)
    assert abs(slope(force=1) - figures["lengths"][-1]) < 1e-8
    assert abs(slope(corner=1) + figures["reactions"][0][2]) < 1e-4  # as near as this net is to its limit: 2.3e-5


def test_films_refused(examples):
    model = taut.make(SAIL)
    patches = document(examples["film-ridge"])
    for wrong, reason in (((SAIL, model, "volume"), "name"), ((SAIL, model, "length", "u2"), "name"),
                          ((SAIL, model, "tension", "u1"), "argument"), ((patches, taut.make(patches)), "no-gradient")):
        with pytest.raises(taut.InputError) as caught:
            taut.film_gradient(*wrong)
        assert caught.value.reason == reason
    assert "give one patch" in caught.value.message


def test_refused(net, examples):
    problem = {"construct": "dirichlet", "u": taut.bezier(4), "v": taut.bezier(5), "points": net}
    model = taut.make(problem)
    film = document(examples["film-sail"])
    for wrong, reason in (((film, taut.make(film)), "no-gradient"), ((problem, model, "length"), "name"),
                          ((problem, model, np.zeros((2, 2, 3))), "size"), ((problem, model, np.full(net.shape, np.nan)), "argument"),
                          ((problem, taut.make({**problem, "points": net + 1})), "other-model"),
                          (([problem, problem], model), "argument"), ((problem, None), "argument")):
        with pytest.raises(taut.InputError) as caught:
            taut.gradient(*wrong)
        assert caught.value.reason == reason
