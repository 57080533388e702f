"""certify_identity.py -- what a certificate is about: models of all constructions with something beyond it, something twice,
something renamed or missing, in another unit, on another basis; with its problem and alone."""

import copy
import json

from program import complain, example, finish, load, run, save

# One for each way in which a construction fills a model.
NAMES = ["asymptotic-low", "asymptotic-ruled", "biharmonic-c1", "biharmonic-rows", "bonnet-enneper", "bonnet-figure-1a",
         "bonnet-helicoid", "dirichlet-hammock", "dirichlet-tent", "dirichlet-through", "film-sail", "harmonic-derivative", "harmonic-even",
         "harmonic-extension", "harmonic-neighbour", "harmonic-rows", "pattern-cylinder", "pipe-elbow", "pipe-g2", "pipe-paper", "pipe-run",
         "pipe-run-coil", "pipe-run-wall", "plateau-bicubic", "plateau-curves", "plateau-mast", "trace-principal"]
EXAMPLES = [line.split()[0] for line in run("example")[1].splitlines() if line.strip()]
FLAT = {"u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1},
        "points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]}
LINE = {"t": {"type": "bezier", "degree": 1}, "points": [[0, 0, 0], [1, 0, 0]]}
# Constructions whose certificate judges every surface of a model that comes alone.
ALL_JUDGED = ("harmonic", "biharmonic", "bonnet")
asked = 0


def certificate(model, *problem):
    save("changed.json", model)
    code, out, said = run("certify", "changed.json", *problem, "--json")
    return code, json.loads(out) if out else None, said


def identity(proof):
    return next(c for c in proof["claims"] if c["claim"] == "identity")


def expect(what, model, given, holds, listed=None):
    """The claim `identity` is as said, or the model was refused altogether (a problem alone may decide what is missing)."""
    global asked
    asked += 1
    code, proof, said = certificate(model, *given)
    if proof is None:
        if holds or code not in (3, 4) or "needs-problem" in said and given:
            complain(f"{what}: exit {code}: {said}")
        return
    claim = identity(proof)
    if claim["kind"] != "exact" or claim["limit"] != 0 or claim["holds"] is not holds or (claim["residual"] == 0) != holds:
        complain(f"{what}: {claim}")
    if holds is False and (code != 1 or proof["holds"] is not False):
        complain(f"{what}: exit {code}, {proof['holds']}")
    if listed is not None and proof["figures"].get("not_certified", []) != listed:
        complain(f"{what}: not certified: {proof['figures'].get('not_certified')}, expected {listed}")


def changed(model, change):
    copied = copy.deepcopy(model)
    change(copied)
    return copied


def beyond(kind, thing):
    return lambda m: m.setdefault(kind, []).append(thing)


for name in NAMES:
    problem = example(name)
    if isinstance(problem, list):
        continue
    save("problem.json", problem)
    if run("make", "problem.json", "-o", "model.json", "--quiet")[0] > 1:
        complain(f"{name}: not made")
        continue
    model, given = load("model.json"), ("problem.json",)
    alone_works = certificate(model)[1] is not None
    judged = model["certificate"]["construct"] in ALL_JUDGED
    extra, twin = dict(FLAT, name="other"), copy.deepcopy(model["surfaces"][-1])
    expect(f"{name}, as it is", model, given, True)
    expect(f"{name}, one more surface", changed(model, beyond("surfaces", extra)), given, False)
    expect(f"{name}, one more curve", changed(model, beyond("curves", dict(LINE, name="other"))), given, False)
    expect(f"{name}, a surface twice", changed(model, beyond("surfaces", twin)), given, False)
    expect(f"{name}, metres", changed(model, lambda m: m.update(unit="m" if m.get("unit", "mm") != "m" else "ft")), given, False)
    expect(f"{name}, renamed", changed(model, lambda m: m["surfaces"][-1].update(name="other")), given, False)
    if alone_works:
        expect(f"{name} alone", model, (), True, [])
        expect(f"{name} alone, one more curve", changed(model, beyond("curves", dict(LINE, name="line"))), (), True, ["line"])
        expect(f"{name} alone, a surface twice", changed(model, beyond("surfaces", twin)), (), False)
        if not judged:
            expect(f"{name} alone, one more surface", changed(model, beyond("surfaces", extra)), (), True, ["other"])
if {example(name)["construct"] for name in NAMES} != {p["construct"] for p in map(example, EXAMPLES) if isinstance(p, dict)}:
    complain("a construction is not asked")
if asked < 9 * len(NAMES):
    complain(f"only {asked} questions were asked of {len(NAMES)} examples")
finish()
