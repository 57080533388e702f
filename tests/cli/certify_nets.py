"""certify_nets.py -- models of nets and patterns, each changed where no claim looked once: what is cut is no number, another shape,
or of another line. The model as it was made holds; the changed one does not, by the claim named."""

import copy
import json

from program import complain, example, finish, load, run, save

made = {}


def model_of(name):
    """The model of an example, made once, which holds."""
    if name not in made:
        save(name + ".problem.json", example(name))
        code, _, said = run("make", name + ".problem.json", "-o", name + ".json", "--quiet")
        if code != 0:
            complain(f"{name}: exit {code}: {said}")
        made[name] = load(name + ".json")
    return copy.deepcopy(made[name])


def judge(what, model, name, false, problem=None):
    """With the problem the claim `false` does not hold, and where problem is None, nor without."""
    save("changed.json", model)
    given = problem or name + ".problem.json"
    for words in [[given]] if problem else [[given], []]:
        code, out, said = run("certify", "changed.json", *words, "--json")
        claims = json.loads(out)["claims"] if out else []
        if code != 1 or not any(c["claim"] == false and c["holds"] is not True for c in claims):
            complain(f"{name}, {what}, {words}: exit {code}, {false} is not false: "
                     f"{[c['claim'] for c in claims if c['holds'] is not True]} {said}")


def scale_cut(model, share):
    for curve in model["curves"]:
        if curve["name"].endswith(".cut"):
            curve["points"] = [[share * x for x in point] for point in curve["points"]]


def outlines():
    for name in ["trace-bonnet", "trace-planks"]:
        model = model_of(name)
        for piece in model["details"]["pieces"]:
            piece["outline"] = [["a", "b"]] * 3
        judge("outlines of words", model, name, "pattern")


def cloth():
    for at in (["x", "y"], [None, None]):
        model = model_of("pattern-sail")
        for piece in model["details"]["roll"]["pieces"]:
            piece["at"] = at
        judge(f"pieces at {at}", model, "pattern-sail", "roll")
    for name in ["pattern-catenoid", "pattern-cone", "pattern-cylinder", "pattern-sphere"]:
        model = model_of(name)
        scale_cut(model, 0.5)
        judge("cut along half the lines", model, name, "edges")


outlines()
cloth()
finish()
