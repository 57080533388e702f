"""certify_changed.py COUNT -- COUNT models of each construction, each changed in one place by chance, are judged or refused with
one line. TAUT_TEST_SEED chooses the places."""

import copy
import os
import random
import sys

from program import complain, finish, load, run, save

VALUES = [None, "x", -1, 0, 1e300, [], {}, True, "bezier", 2]


def places(x, path=()):
    """Of every member, and of the first three items of a list."""
    if path:
        yield path
    if isinstance(x, dict):
        for key in x:
            yield from places(x[key], path + (key,))
    elif isinstance(x, list):
        for i in range(min(len(x), 3)):
            yield from places(x[i], path + (i,))


def at(x, path):
    for key in path:
        x = x[key]
    return x


def changed(model, path, every):
    """Left out, another value, another size, twice, or what stands elsewhere."""
    other = copy.deepcopy(model)
    parent, key, how = at(other, path[:-1]), path[-1], random.randrange(5)
    value = parent[key]
    if how == 0:
        del parent[key]
    elif how == 1:
        parent[key] = random.choice(VALUES)
    elif how == 2 and isinstance(value, (int, float)):
        parent[key] = value * random.choice([-1, 1e-6, 1e6, 2]) + random.choice([0, 1])
    elif how == 3 and isinstance(parent, list):
        parent.append(copy.deepcopy(value))
    else:
        parent[key] = copy.deepcopy(at(model, random.choice(every)))
    return other


def examples():
    """The names of the examples of each construction."""
    names = {}
    for line in run("example")[1].splitlines():
        names.setdefault(line.split("-")[0], []).append(line.split()[0])
    return names.values()


def main():
    seed = int(os.environ.get("TAUT_TEST_SEED", "1"))
    random.seed(seed)
    each = int(sys.argv[1])
    tried = 0
    for names in examples():
        name = random.choice(names)
        with open("problem.json", "w") as file:
            file.write(run("example", name)[1])
        if run("make", "problem.json", "-o", "model.json", "--quiet")[0] not in (0, 1):
            continue
        model = load("model.json")
        every = list(places(model))
        for path in random.sample(every, min(each, len(every))):
            save("changed.json", changed(model, path, every))
            for problem in ([], ["problem.json"]):
                code, out, err = run("certify", "changed.json", *problem)
                tried += 1
                lines = len(err.strip().splitlines())
                if code not in (0, 1, 3, 4) or (code > 1 and lines != 1) or "nan" in out.lower():
                    complain(f"{name} changed at {path}, seed {seed}: exit {code}, {err[:200]}")
    print(tried, "models tried")
    if tried < 8 * each:
        complain(f"only {tried} models were tried")


main()
finish()
