"""certify_refusals.py -- models that are made, changed in one place and certified: the exit code, and what is said."""

import copy
import json
import re
import sys

from program import complain, example, finish, load, run, save

# What a model is certified with: nothing else, the problem it was made from, or another problem.
ALONE, ITSELF = "alone", "itself"

BILINEAR = {"name": "flat", "u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1},
            "points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}
RATIONAL = dict(BILINEAR, weights=[[1, 2], [1, 1]])
QUASI = dict(BILINEAR, u={"type": "c-bezier", "alpha": 1}, points=[[[i, 0, 0], [i, 1, i]] for i in range(4)])
CUBIC = {"type": "bezier", "degree": 3}
ONCE = {"type": "c-bezier", "alpha": 1}


# Changes: functions of a document. A path is written as a JSON pointer; -1 is the last item.

def place(document, path):
    """The parent of a path, and its last key."""
    keys = [int(k) if re.fullmatch("-?[0-9]+", k) else k for k in path.split("/")[1:]]
    for key in keys[:-1]:
        document = document[key]
    return document, keys[-1]


def same(document):
    pass


def replaced(path, value):
    def change(document):
        parent, key = place(document, path)
        parent[key] = value
    return change


def without(path):
    def change(document):
        parent, key = place(document, path)
        del parent[key]
    return change


def moved(from_path, to_path):
    """What stands at one path stands at another, too."""
    def change(document):
        parent, key = place(document, from_path)
        replaced(to_path, parent[key])(document)
    return change


def both(*changes):
    def change(document):
        for one in changes:
            one(document)
    return change


def shifted(x):
    """Every point of the surfaces moves along x."""
    def change(model):
        for s in model["surfaces"]:
            s["points"] = [[[p[0] + x, p[1], p[2]] for p in row] for row in s["points"]]
    return change


def on_the_brink(model):
    """A hump of 1e-7 at the largest doubles there are: the step that would tell its gain leads beyond."""
    most, s = sys.float_info.max, model["surfaces"][0]
    s["points"] = [[[(i - 1.5) * 6e307, most * (1 if i in (1, 2) and j in (1, 2) else 1 - 1e-7), (j - 1.5) * 6e307]
                    for j in range(4)] for i in range(4)]
    model["details"]["tolerance"] = 1e-30


def raised(path, amount):
    """One number is a little larger."""
    def change(document):
        parent, key = place(document, path)
        parent[key] += amount
    return change


def shrunk(model):
    """The first surface shrinks to where the axis begins, and nothing else tells a radius."""
    start = model["curves"][0]["points"][0]
    model["surfaces"][0]["points"] = [[start] * len(row) for row in model["surfaces"][0]["points"]]
    del model["details"]["radius"]


def at_rest(model):
    """The axis is a point."""
    model["curves"][0]["points"] = [model["curves"][0]["points"][0]] * 4


def axis_lost(model):
    model["curves"] = [c for c in model["curves"] if c["name"] != "axis-pipe1"]


def pieces_renamed(model):
    model["details"].pop("blends", 0)
    for s in model["surfaces"]:
        s["name"] = "s" + s["name"]


def axis_of_two_pieces(model):
    axis = next(c for c in model["curves"] if c["name"] == "axis-pipe1")
    axis.update(t={"type": "bspline", "degree": 1, "count": 3}, points=[[0, 0, 0], [1, 0, 0], [2, 0, 0]])


def problem(name, change=same):
    document = example(name)
    change(document)
    return document


NORMAL = problem("plateau-bicubic", replaced("/method", "normal"))
NORMAL_SPLINE = problem("plateau-curves", replaced("/method", "normal"))
FINER = problem("plateau-bicubic", both(replaced("/weights", [[1, 1.3, 1.3, 1]] * 4), replaced("/tolerance_area", 1e-2)))
MANY = problem("bonnet-helicoid", both(replaced("/segments", [20, 2]), replaced("/alpha", 0.3)))
SNUG = problem("pipe-auto", replaced("/radius", 2.12))
STEEP = [[10 ** (11.5 * i)] * 3 for i in range(3)]
CROSSED = [[10.0 ** (11 * (i == 1) - 11 * (j == 1)) for j in range(4)] for i in range(4)]
SHARP = both(replaced("/curves/0/points", [[0, 0, 0], [1, 0, 0], [0, 3e-9, 0], [1, 3e-9, 0]]),
             replaced("/curves/0/t", {"type": "ce-bezier", "alpha": 0, "beta": 0, "gamma": 0}))

# What, the problem or the name of an example, the change of its model, what it is certified with, the exit code, what is said;
# a pattern that begins with "not " must not be.
CASES = [
    # no construction
    ("no certificate", "dirichlet-bicubic", without("/certificate"), ALONE, 3, "/certificate/construct", "give its problem too"),

    # dirichlet, plateau
    ("steep weights", "dirichlet-biquadratic", replaced("/surfaces/0/weights", STEEP), ALONE, 1, "stationary +undecided .*2.43 apart"),
    ("crossed weights", "plateau-bicubic", replaced("/surfaces/0/weights", CROSSED), ALONE, 1, "stationary +DOES NOT HOLD"),
    ("nothing unknown", "dirichlet-tent", replaced("/details/known", "all"), ALONE, 1,
     "stationary +undecided", "nothing was unknown"),
    ("nothing unknown of a film", "plateau-bicubic", replaced("/details/known", "all"), ALONE, 1,
     "stationary +undecided", "nothing was unknown"),
    ("another type", "dirichlet-bicubic", replaced("/surfaces/0/u", ONCE), ITSELF, 1,
     "known +DOES NOT HOLD \(exact\): 1, limit 0, at /surfaces/0/u or /surfaces/0/v"),
    ("aspect", "dirichlet-aspect", replaced("/details/aspect", -1), ALONE, 3, "/details/aspect"),
    ("normals", NORMAL, same, ALONE, 0, "stationary +holds \(bound\)"),
    ("normals of a spline", NORMAL_SPLINE, same, ITSELF, 0, "stationary +holds \(bound\)"),
    ("normals that the model does not tell", NORMAL, without("/details/directions"), ITSELF, 0, "stationary +holds \(bound\)"),
    ("no witness of the normals", NORMAL, without("/details/dirichlet"), ITSELF, 3, "/details/dirichlet", "make it again"),
    ("a witness with a point too few", NORMAL, without("/details/dirichlet/1/3"), ITSELF, 3, "/details/dirichlet", "make it again"),
    ("a witness that is not at rest", NORMAL, raised("/details/dirichlet/1/1/0", 0.5), ITSELF, 1, "stationary +undecided.*at rest"),
    ("a witness of another boundary", NORMAL, raised("/details/dirichlet/0/1/0", 1e-12), ALONE, 1, "stationary +undecided.*known points"),
    ("a point moved along its normal", NORMAL, raised("/surfaces/0/points/1/1/2", 1e-5), ITSELF, 1, "stationary +DOES NOT HOLD \(bound\)"),
    ("no room for a step", "plateau-bicubic", on_the_brink, ALONE, 1, "stationary +DOES NOT HOLD \([a-z]+\): 1.*e-07"),
    ("a film on which points slide", "plateau-skew", same, ALONE, 0, "stationary +holds \(bound\): .*e-[01][0-9], limit 1e-06"),
    ("a film with a hump where the area is steep", "plateau-skew", raised("/surfaces/0/points/5/5/2", 1e-7), ALONE, 1,
     "stationary +DOES NOT HOLD \(bound\): [0-9.]+e-0[789]"),
    ("an edge away from its curve", "plateau-curves", replaced("/surfaces/0/points/0/3/2", 3), ITSELF, 1,
     "boundary +DOES NOT HOLD", "at u0"),
    ("a deviation that is none", "plateau-curves", replaced("/details/deviation", 1e-7), ITSELF, 1,
     "boundary +DOES NOT HOLD", "deviation is not what is found"),
    ("a rational net with new knots", FINER, same, ITSELF, 0, "boundary +holds"),

    # asymptotic
    ("a plane patch", "asymptotic-1", replaced("/surfaces/0", BILINEAR), ALONE, 3, "/surfaces/0", "degree 2 at least"),
    ("no weights", "asymptotic-1", without("/curves/2/weights"), ITSELF, 1, "boundary +DOES NOT HOLD", "degree"),

    # harmonic, biharmonic and their neighbours
    ("a spline", "harmonic-rows", replaced("/surfaces/0", QUASI), ALONE, 3, "/surfaces/0", "polynomial surface on \"bezier\""),
    ("weights", "harmonic-rows", replaced("/surfaces/0", RATIONAL), ALONE, 3, "/surfaces/0"),
    ("another problem", "harmonic-rows", replaced("/surfaces/0", BILINEAR), ITSELF, 3, "/surfaces/0", "do not belong together"),
    ("a point moved", "biharmonic-rows", replaced("/surfaces/0/points/0/1/2", 7), ITSELF, 1, "boundary +DOES NOT HOLD",
     "/surfaces/0/points, point 1"),
    ("of another problem", "biharmonic-c1", same, problem("biharmonic-rows"), 3, "/surfaces", "no biharmonic surface"),

    # bonnet
    ("frames", "bonnet-figure-4", without("/surfaces/0"), ITSELF, 3, "/surfaces", "do not belong together"),
    ("weights", "bonnet-figure-1a", replaced("/surfaces/0", RATIONAL), ALONE, 3, "/surfaces/0/weights"),
    ("another basis", "bonnet-figure-1a", replaced("/surfaces/0/u", CUBIC), ALONE, 1, "isothermal +DOES NOT HOLD",
     "not algebraic"),
    ("many segments", MANY, same, ITSELF, 0, "minimal +holds", "formula +holds"),

    # pipe
    ("its own axis", "pipe-auto", shrunk, ALONE, 3, "/surfaces/0", "no radius"),
    ("a weighted axis", "pipe-g2", replaced("/curves/0/weights", [1, 2, 1, 1, 2, 1]), ALONE, 3, "/curves/0", "no polynomial"),
    ("an axis that rests", "pipe-auto", at_rest, ALONE, 3, "/curves/0"),
    ("an axis at rest", "pipe-auto", moved("/curves/0/points/0", "/curves/0/points/1"), ALONE, 3, "/curves/0",
     "no direction at its start"),
    ("a cubic axis", "pipe-auto", replaced("/curves/0/t", CUBIC), ALONE, 3, "/curves/0/t/type", "ce-bezier"),
    ("a sharp axis", "pipe-auto", SHARP, ALONE, 1, "embedded +DOES NOT HOLD"),
    ("a pipe on another basis", "pipe-auto", replaced("/surfaces/1", dict(QUASI, name="pipe1")), ALONE, 1,
     "joint1 +DOES NOT HOLD"),
    ("no room", SNUG, same, ITSELF, 0, "optimal +holds"),

    # runs of pipes
    ("no axis", "pipe-run", axis_lost, ALONE, 3, "/curves", "no curve \"axis-pipe1\""),
    ("no pieces", "pipe-run", pieces_renamed, ALONE, 3, "/surfaces", "a run has surfaces"),
    ("an axis of two pieces", "pipe-run", axis_of_two_pieces, ALONE, 3, "/curves", "several pieces"),
    ("its own axis", "pipe-run", shrunk, ALONE, 3, "/surfaces/0", "no radius"),
    ("a ring that does not say so", "pipe-run-closed", without("/details/closed"), ALONE, 0, "joints +holds"),
]
for name in ("dirichlet-bicubic", "plateau-bicubic", "harmonic-rows", "biharmonic-rows", "bonnet-figure-1a", "harmonic-extension"):
    for given in (ALONE, ITSELF):
        CASES.append(("no surface", name, replaced("/surfaces", []), given, 3, "/surfaces"))
for name in ("dirichlet", "plateau"):
    CASES += [
        ("another net", name + "-bicubic", same, problem(name + "-biquadratic"), 3, "/surfaces/0/points", "do not belong"),
        ("known", name + "-bicubic", replaced("/details/known", "some"), ALONE, 3, "/details/known", "problem"),
        ("no details", name + "-bicubic", without("/details"), ALONE, 3, "/details/known"),
        ("far away", name + "-bicubic", shifted(2e13), ALONE, 1, "stationary +undecided", "rounding of the points alone"),
    ]
for name in ("biharmonic-c1", "harmonic-neighbour"):
    for edge, end in (("u0", -1), ("u1", 0), ("v0", -1), ("v1", 0)):
        neighbour = problem(name, replaced("/edge", edge))
        CASES += [
            ("neighbour at " + edge, neighbour, same, ALONE, 0, "continuity +holds"),
            ("torn at " + edge, neighbour, replaced(f"/surfaces/1/points/{end}/{end}/2", 9), ALONE, 1, "continuity +DOES NOT HOLD"),
        ]

made = {} # the model of each problem, by its text


def model_of(document):
    text = json.dumps(document)
    if text not in made:
        save("problem.json", document)
        code, _, said = run("make", "problem.json", "-o", "model.json", "--quiet")
        assert code in (0, 1), said
        made[text] = load("model.json")
    return copy.deepcopy(made[text])


def check(what, document, change, given, expected, *patterns):
    if isinstance(document, str):
        document = problem(document)
    model = model_of(document)
    change(model)
    save("changed.json", model)
    words = ["changed.json"]
    if given != ALONE:
        save("given.json", document if given == ITSELF else given)
        words.append("given.json")
    code, out, said = run("certify", *words)
    wrong = [p for p in patterns if (re.search(p[4:], said) if p.startswith("not ") else not re.search(p, said))]
    if code != expected or wrong or (code > 1 and (out or len(said.splitlines()) != 1)) or "nan" in said:
        complain(f"{what}: exit {code}, expected {expected}, {wrong}: {said}")


for case in CASES:
    check(*case)
finish()
