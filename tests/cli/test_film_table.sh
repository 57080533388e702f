# test_film_table.sh -- every reason for which a film is refused, in one table: exit code, place, what was found and what was expected,
# and the remedy. Numbers are closed forms; where the way to them is by halved steps, between bounds. Nothing is written. (`unstable`
# needs a film to start from: unit/construct/film/start; `folds` is what no document is sure to meet.)
. "$SOURCE/tests/cli/cli.sh"

TAUT="$TAUT" python3 - <<'END' || complain "refusals are other ones"
import json, os, subprocess, sys
from math import acosh, sqrt

def basis(degree, count): return {"type": "bspline", "degree": degree, "count": count}
def cable(**law): return {"cable": law}
def plane(point, normal): return {"point": point, "normal": normal}
def circle(z, radius=1): return {"fixed": {"circle": {"center": [0, 0, z], "normal": [0, 0, 1], "radius": radius}}}
def ring(v0, v1, **more):
    return dict({"u": basis(4, 20), "v": basis(4, 10), "seams": [["u0", "u1"]], "edges": {"v0": v0, "v1": v1}}, **more)
def four(edge): return {name: edge for name in ("u0", "u1", "v0", "v1")}
def held(z, pull): return {"cable": {"force": pull}, "plane": plane([0, 0, z], [0, 0, 1])}
def air(**what): return [dict({"name": "air", "sides": ["film"]}, **what)]
def two(count=4, corner=(1, 0, 0), **more):
    a = {"u0v0": [0, 0, 0], "u1v0": [1, 0, 0], "u0v1": [0, 1, 0], "u1v1": [1, 1, 0]}
    b = {"u0v0": list(corner), "u1v0": [2, 0, 0], "u0v1": [1, 1, 0], "u1v1": [2, 1, 0]}
    return {"patches": [dict({"name": "a", "u": basis(2, 4), "v": basis(2, 4), "corners": a}, **more),
                        {"name": "b", "u": basis(2, 4), "v": basis(2, count), "corners": b}], "seams": [["a.u1", "b.u0"]]}
def grid(inside=None, row=True):
    net = [[[i / 3, j / 3, 0] if i in (0, 3) or j in (0, 3) else None for j in range(4)] for i in range(4)]
    net[1][1] = inside
    for j in (1, 2) if not row else (): net[3][j] = None
    return {"u": basis(3, 4), "v": basis(3, 4), "points": net}
square = {"u0v0": [0, 0, 0], "u1v0": [2, 0, 0], "u0v1": [0, 2, 0], "u1v1": [2, 2, 0]}
saddle = {"u0v0": [-1, -1, 0.5], "u1v0": [1, -1, -0.5], "u0v1": [-1, 1, -0.5], "u1v1": [1, 1, 0.5]}
oblong = {"u0v0": [0, 0, 0], "u1v0": [4, 0, 0], "u0v1": [0, 1, 0], "u1v1": [4, 1, 0]}
sides = {e: {"slide": plane([2 * (e == "u1"), 2 * (e == "v1"), 0], [int(e[0] == "u"), int(e[0] == "v"), 0])} for e in four(0)}

# The farthest that a catenoid reaches from the unit circle to a cable of force 0.3 (h = a (acosh(1 / a) - acosh(r / a)), r^2 = a^2 + T^2), and
# to a plane; the largest pressure in a tube between unit circles at distance 1: with dz / ds = C = p r / 2 + c / r, widest at R where C is 1,
# the height is the integral of C / sqrt(1 - C^2) dr, and R is 1.42 where p is largest.
necks = [k / 20000 for k in range(1, 20000)]
to_cable = max(a * (acosh(1 / a) - acosh(sqrt(a * a + 0.09) / a)) for a in necks if a * a + 0.09 < 1)
to_plane = max(a * acosh(1 / a) for a in necks)
def height(widest, p, pieces=2000):
    c, total = widest - p * widest ** 2 / 2, 0
    for k in range(pieces):
        t = (k + 0.5) / pieces
        r = widest - (widest - 1) * t * t
        slope = p * r / 2 + c / r
        total += slope / sqrt(1 - slope ** 2) * 2 * (widest - 1) * t / pieces
    return total
def pressure(widest):
    low, high = 2.2, 2.7
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if height(widest, middle) > 0.5 else (low, middle)
    return low
bulge = max(pressure(1.38 + 0.01 * k) for k in range(9))

near = lambda x, share=1e-11: (x * (1 - share), x * (1 + share))
any_number, none = (-1e300, 1e300), None
rows = [ # reason, exit, place, found, expected, words of the message, the document
    ("seam-mismatch", 3, "/seams/0", near(5), near(4), "a.u1 b.u0", two(count=5)),
    ("corner-conflict", 3, "/patches/1/corners/u0v0", near(1e-3, 1e-9), (0, 0), "0.001 apart", two(corner=(1, 0, 1e-3))),
    ("edge-conflict", 3, "/seams/0/0", near(1), near(1), "leave out one", two(edges={"u1": cable(force=1)})),
    ("curve-ends", 3, "/edges/v0/fixed", near(0.5), (0, 1e-8), "u1v0 0.5",
     {"corners": dict(square, u1v0=[2.5, 0, 0]), "edges": {"v0": {"fixed": {"line": [[0, 0, 0], [2, 0, 0]]}}}}),
    ("cell-sides", 3, "/cells/1/sides/0", near(2), near(1), "once",
     ring(circle(0), {"pole": None}, cells=[dict(cell, name=name) for cell in air(volume=1) for name in ("a", "b")])),
    ("free-edge", 4, "/edges/u1", none, none, "give it a cable or a plane", grid(row=False)),
    ("floating", 4, "/edges", near(2), near(3), "(0, 0, 1) hold a corner", {"corners": {c: {"near": p} for c, p in square.items()}, "edges": sides}),
    ("point-support", 4, "/points/1/1", none, none, "use a ring, or cables that end there", grid(inside=[0.3, 0.3, 1])),
    ("point-support", 4, "/through", none, none, "use a ring, or cables that end there", {"corners": square, "through": []}),
    ("point-support", 4, "/edges/v1/pole", none, none, "use a ring, or cables that end there", ring(circle(0), {"pole": [0, 0, 1]})),
    ("open-cell", 4, "/cells/0/from", near(0.3), (0, 1e-8), "0.3 away", ring(circle(0), held(0.3, 0.3), cells=air(pressure=0.1))),
    ("cable-too-short", 4, "/edges/u0/cable/length", near(1.9), near(2), "more length",
     {"corners": square, "edges": dict(four(cable(force=2)), u0=cable(length=1.9))}),
    ("cable-too-weak", 4, "/edges/u0/cable", near(0.9), near(sqrt(2)), "do not span their chords", {"corners": square, "edges": four(cable(force=0.9))}),
    ("cable-too-weak", 4, "/edges/u0/cable", near(1.4), near(sqrt(2)), "arcs touch", {"corners": square, "edges": four(cable(force=1.4))}),
    ("cable-too-weak", 4, "/edges/v1/cable", near(2.4), near(2.5), "arcs touch", {"corners": oblong, "edges": {"v1": cable(force=2.4)}}),
    ("cable-too-weak", 4, "/edges/u0/cable", near(1.5), (1.6, 1.75), "lowered together last found",
     {"u": basis(3, 8), "v": basis(3, 8), "corners": saddle, "edges": four(cable(force=1.5))}),
    ("collapses", 4, "/edges", near(1.4), near(1.32548683869836), "proved bring them together", ring(circle(0), circle(1.4))),
    ("collapses", 4, "/edges/v1", near(1), (to_cable / 0.5 * (1 - 5e-4), to_cable / 0.5), "neck bring them together", ring(circle(0), held(0.5, 0.3))),
    ("slides-away", 4, "/edges/v1", near(1), (to_plane / 0.7 * (1 - 5e-4), to_plane / 0.7), "slides off",
     ring(circle(0), {"slide": plane([0, 0, 0.7], [0, 0, 1])})),
    ("pressure-too-high", 4, "/cells/0/pressure", near(2.05), near(2, 1e-9), "proved give a volume", ring(circle(0), {"pole": None}, cells=air(pressure=2.05))),
    ("pressure-too-high", 4, "/cells/0/pressure", near(3), (bulge * (1 - 2e-3), bulge), "raised from 0 give a volume",
     ring(circle(0), circle(1), u=basis(4, 14), v=basis(4, 8), cells=air(pressure=3))),
    ("no-corner", 4, "/corners/u1v1", none, none, "hold it", {"corners": dict(square, u1v1=None), "edges": four(cable(force=2))}),
    ("crossed", 4, "/corners", none, none, "exchange two", {"corners": dict(square, u0v1=[2, 2, 0], u1v1=[0, 2, 0]), "edges": four(cable(force=3))}),
    ("not-converged", 1, "film.json", any_number, near(1e-10), "1 steps", {"corners": saddle, "edges": four(cable(force=2)), "max_iterations": 1}),
]
wrong = 0
for reason, code, where, found, expected, words, members in rows:
    json.dump(dict({"taut": 1, "construct": "film", "least": False}, **members), open("film.json", "w"))
    run = subprocess.run([os.environ["TAUT"], "make", "--json", "film.json", "-o", "none.json", "--quiet"], capture_output=True, text=True)
    try:
        error = json.loads(run.stderr)["error"]
    except (ValueError, KeyError):
        error = {"reason": "none", "where": "", "message": run.stderr, "found": None, "expected": None}
    def inside(value, bounds): return value is None if bounds is None else value is not None and bounds[0] <= value <= bounds[1]
    at = 0
    for word in words.split(): # one after the other
        at = error["message"].find(word, at) if at >= 0 else at
    if not (run.returncode == code and error["reason"] == reason and error["where"] == where and at >= 0 and
            inside(error["found"], found) and inside(error["expected"], expected) and not os.path.exists("none.json")):
        wrong += 1
        print(f"{reason} at {where}, {found}, {expected}, {words!r}:\n    exit {run.returncode}: {error}", file=sys.stderr)
sys.exit(wrong > 0)
END
finish

# Six copies of the quad of Schwarz's D, measured in all: 6 K(sqrt 3 / 2) / K(1 / 2).
"$TAUT" example film-schwarz-d > cell.json
run 0 make cell.json -o cell-film.json --quiet
run 0 measure cell-film.json
contains out.txt '^together$'
contains out.txt '^  surfaces +6$'
contains out.txt '^  surface_area +7[.]67556942[67]'
run 0 measure cell-film.json --json --surface film
tr -d '\n' < out.txt | grep -q together && complain "one surface is not several"
