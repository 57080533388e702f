# test_certify_refusals.sh -- certifying models that other hands have changed: what is missing or wrong is refused by its place,
# what can be judged is judged, claim by claim.
. "$SOURCE/tests/cli/cli.sh"

python_with json || skip python3 'tools/deps.sh test'
cat > table.py <<'END'
import copy, json, os, re, subprocess, sys

failures = 0

def taut(*words):
    done = subprocess.run([os.environ["TAUT"], *words], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr

def problem_of(example, change=None):
    problem = json.load(open(os.path.join(os.environ["SOURCE"], "examples", example + ".json")))
    if change:
        change(problem)
    return problem

made = {}

def model_of(problem):
    text = json.dumps(problem)
    if text not in made:
        open("problem.json", "w").write(text)
        code, _, said = taut("make", "problem.json", "-o", "model.json", "--quiet")
        assert code in (0, 1), said
        made[text] = json.load(open("model.json"))
    return copy.deepcopy(made[text])

def check(what, problem, change, given, expected, *patterns, without=None):
    """Make, change, certify -- with `given`, a problem, or the model alone: the exit code and what is said."""
    global failures
    model = model_of(problem)
    change(model)
    json.dump(model, open("changed.json", "w"))
    words = ["changed.json"]
    if given is not None:
        json.dump(given, open("given.json", "w"))
        words.append("given.json")
    code, out, said = taut("certify", *words)
    wrong = [p for p in patterns if not re.search(p, said)]
    if without and re.search(without, said):
        wrong.append("not " + without)
    if code != expected or wrong or (code > 1 and (out or len(said.splitlines()) != 1)) or "nan" in said:
        failures += 1
        print(f"FAILED: {what}: exit {code}, expected {expected}, {wrong}: {said}", file=sys.stderr)

def same(model):
    pass

def member(*path):
    """Replaces the member at a path by a value, or leaves it out: member("a", 0, "b")(value)(model)."""
    def with_value(*value):
        def change(x):
            for key in path[:-1]:
                x = x[key]
            if value:
                x[path[-1]] = value[0]
            else:
                del x[path[-1]]
        return change
    return with_value

def points(f):
    """Every point of the model's surfaces through f."""
    def change(model):
        for s in model["surfaces"]:
            s["points"] = [[f(p) for p in row] for row in s["points"]]
    return change

def both(*changes):
    def change(x):
        for c in changes:
            c(x)
    return change

bilinear = {"name": "flat", "u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1},
            "points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}
rational = dict(bilinear, weights=[[1, 2], [1, 1]])
quasi = dict(bilinear, u={"type": "c-bezier", "alpha": 1}, points=[[[i, 0, 0], [i, 1, i]] for i in range(4)])
cubic = {"type": "bezier", "degree": 3}
nothing = member("surfaces")([])
alone = member("surfaces", 0)

# No construction, no surface.
dirichlet = problem_of("dirichlet-bicubic")
check("no certificate", dirichlet, member("certificate")(), None, 3, "/certificate/construct", "give its problem too")
for example in ("dirichlet-bicubic", "plateau-bicubic", "harmonic-rows", "biharmonic-rows", "bonnet-figure-1a",
                "harmonic-extension"):
    check("no surface", problem_of(example), nothing, None, 3, "/surfaces")
    check("no surface", problem_of(example), nothing, problem_of(example), 3, "/surfaces")

# dirichlet, plateau
for example in ("dirichlet", "plateau"):
    problem = problem_of(example + "-bicubic")
    check("another net", problem, same, problem_of(example + "-biquadratic"), 3, "/surfaces/0/points", "do not belong")
    check("known", problem, member("details", "known")("some"), None, 3, "/details/known", "problem")
    check("no details", problem, member("details")(), None, 3, "/details/known")
    check("far away", problem, points(lambda p: [p[0] + 2e13, p[1], p[2]]), None, 0, "stationary +undecided",
          "rounding of the points alone")
steep = member("surfaces", 0, "weights")([[10 ** (11.5 * i)] * 3 for i in range(3)])
check("steep weights", problem_of("dirichlet-biquadratic"), steep, None, 0, "stationary +undecided", "256 Gauss nodes do not settle")
crossed = member("surfaces", 0, "weights")([[10.0 ** (11 * (i == 1) - 11 * (j == 1)) for j in range(4)] for i in range(4)])
check("crossed weights", problem_of("plateau-bicubic"), crossed, None, 0, "stationary +undecided",
      "256 Gauss nodes do not settle")
check("another type", dirichlet, member("surfaces", 0, "u")({"type": "c-bezier", "alpha": 1}), dirichlet, 1,
      "known +DOES NOT HOLD: 1, limit 0, at /surfaces/0/u or /surfaces/0/v")
check("aspect", problem_of("dirichlet-aspect"), member("details", "aspect")(-1), None, 3, "/details/aspect")
normal = problem_of("plateau-bicubic", member("method")("normal"))
check("directions", normal, same, None, 0, "stationary +holds")
check("directions", normal, member("details", "directions")(), normal, 3, "/details/directions", "make it again")
check("directions", normal, member("details", "directions", 1, 1)([2, 0, 0]), None, 3, "/details/directions", "unit")

def on_the_brink(model):
    """A hump of 1e-7 at the largest doubles there are: the step that would tell its gain leads beyond."""
    most, s = sys.float_info.max, model["surfaces"][0]
    s["points"] = [[[(i - 1.5) * 6e307, most * (1 if i in (1, 2) and j in (1, 2) else 1 - 1e-7), (j - 1.5) * 6e307]
                    for j in range(4)] for i in range(4)]
    model["details"]["tolerance"] = 1e-30

check("no room for a step", problem_of("plateau-bicubic"), on_the_brink, None, 1, "stationary +DOES NOT HOLD: 1.*e-07")

finer = problem_of("plateau-bicubic", both(member("weights")([[1, 1.3, 1.3, 1]] * 4), member("tolerance_area")(1e-2)))
check("a rational net with new knots", finer, same, finer, 0, "boundary +holds")

# asymptotic
corner = problem_of("asymptotic-1")
check("a plane patch", corner, alone(bilinear), None, 3, "/surfaces/0", "degree 2 at least")
check("no weights", corner, member("curves", 2, "weights")(), corner, 1, "boundary +DOES NOT HOLD", "degree")

# harmonic, biharmonic and their neighbours
rows = problem_of("harmonic-rows")
check("a spline", rows, alone(quasi), None, 3, "/surfaces/0", "polynomial surface on \"bezier\"")
check("weights", rows, alone(rational), None, 3, "/surfaces/0")
check("another problem", rows, alone(bilinear), rows, 3, "/surfaces/0", "do not belong together")
inner = problem_of("biharmonic-rows")
check("a point moved", inner, member("surfaces", 0, "points", 0, 1, 2)(7), inner, 1, "boundary +DOES NOT HOLD",
      "/surfaces/0/points, point 1")
c1 = problem_of("biharmonic-c1")
check("of another problem", c1, same, inner, 3, "/surfaces", "no biharmonic surface")
for name in ("biharmonic-c1", "harmonic-neighbour"):
    for edge in ("u0", "u1", "v0", "v1"):
        problem = problem_of(name, member("edge")(edge))
        check("neighbour at " + edge, problem, same, None, 0, "continuity +holds")
        end = -1 if edge in ("u0", "v0") else 0
        check("torn at " + edge, problem, member("surfaces", 1, "points", end, end, 2)(9), None, 1,
              "continuity +DOES NOT HOLD")

# bonnet
frames = problem_of("bonnet-figure-4")
check("frames", frames, member("surfaces", 0)(), frames, 3, "/surfaces", "do not belong together")
check("weights", problem_of("bonnet-figure-1a"), alone(rational), None, 3, "/surfaces/0/weights")
check("another basis", problem_of("bonnet-figure-1a"), member("surfaces", 0, "u")(cubic), None, 1, "isothermal +DOES NOT HOLD",
      without="algebraic")
many = problem_of("bonnet-helicoid", both(member("segments")([20, 2]), member("alpha")(0.3)))
check("many segments", many, same, many, 0, "minimal +holds", "formula +holds")

# pipe
pipe, g2 = problem_of("pipe-auto"), problem_of("pipe-g2")
axis = member("curves", 0, "points")

def shrunk(m):
    """The first surface shrinks to where the axis begins, and nothing else tells a radius."""
    m["surfaces"][0]["points"] = [[m["curves"][0]["points"][0]] * len(row) for row in m["surfaces"][0]["points"]]
    del m["details"]["radius"]

check("its own axis", pipe, shrunk, None, 3, "/surfaces/0", "no radius")
check("a weighted axis", g2, member("curves", 0, "weights")([1, 2, 1, 1, 2, 1]), None, 3, "/curves/0", "no polynomial")
check("an axis that rests", pipe, lambda m: axis([m["curves"][0]["points"][0]] * 4)(m), None, 3, "/curves/0")
check("an axis at rest", pipe, lambda m: member("curves", 0, "points", 1)(m["curves"][0]["points"][0])(m), None, 3,
      "/curves/0", "no direction at its start")
check("a cubic axis", pipe, member("curves", 0, "t")(cubic), None, 3, "/curves/0/t/type", "ce-bezier")
check("a sharp axis", pipe, both(axis([[0, 0, 0], [1, 0, 0], [0, 3e-9, 0], [1, 3e-9, 0]]),
      member("curves", 0, "t")({"type": "ce-bezier", "alpha": 0, "beta": 0, "gamma": 0})), None, 1, "embedded +DOES NOT HOLD")
check("a pipe on another basis", pipe, member("surfaces", 1)(dict(quasi, name="pipe1")), None, 1, "joint1 +DOES NOT HOLD")
snug = problem_of("pipe-auto", member("radius")(2.12))
check("no room", snug, same, snug, 0, "optimal +holds")

# runs of pipes
run = problem_of("pipe-run")
check("no axis", run, lambda m: m.update(curves=[c for c in m["curves"] if c["name"] != "axis-pipe1"]), None, 3, "/curves",
      "no curve \"axis-pipe1\"")
check("no pieces", run, lambda m: (m["details"].pop("blends", 0), [s.update(name="s" + s["name"]) for s in m["surfaces"]]),
      None, 3, "/surfaces", "a run has surfaces")
check("an axis of two pieces", run, lambda m: next(c for c in m["curves"] if c["name"] == "axis-pipe1").update(
      t={"type": "bspline", "degree": 1, "count": 3}, points=[[0, 0, 0], [1, 0, 0], [2, 0, 0]]), None, 3, "/curves",
      "several pieces")
check("its own axis", run, shrunk, None, 3, "/surfaces/0", "no radius")
ring = problem_of("pipe-run-closed")
check("a ring that does not say so", ring, member("details", "closed")(), None, 0, "joints +holds")
sys.exit(failures != 0)
END
"$PYTHON" table.py || complain "models that were changed"
finish
