# test_certify.sh -- models that were changed by hand in any place are judged or refused with one line, never worse.
. "$SOURCE/tests/cli/cli.sh"

python_with json || skip python3 'tools/deps.sh test'
cat > change.py <<'END'
import copy, json, os, random, subprocess, sys

seed = int(os.environ.get("TAUT_TEST_SEED", "1"))
random.seed(seed)
each = int(sys.argv[1])
failures = tried = 0

def run(*words):
    done = subprocess.run([os.environ["TAUT"], *words], capture_output=True)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")

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
        parent[key] = random.choice([None, "x", -1, 0, 1e300, [], {}, True, "bezier", 2])
    elif how == 2 and isinstance(value, (int, float)):
        parent[key] = value * random.choice([-1, 1e-6, 1e6, 2]) + random.choice([0, 1])
    elif how == 3 and isinstance(parent, list):
        parent.append(copy.deepcopy(value))
    else:
        parent[key] = copy.deepcopy(at(model, random.choice(every)))
    return other

firsts = {}
for line in run("example")[1].splitlines():
    firsts.setdefault(line.split("-")[0], []).append(line.split()[0])
for names in firsts.values():
    name = random.choice(names)
    open("problem.json", "w").write(run("example", name)[1])
    if run("make", "problem.json", "-o", "model.json", "--quiet")[0] not in (0, 1):
        continue
    model = json.load(open("model.json"))
    every = list(places(model))
    for path in random.sample(every, min(each, len(every))):
        json.dump(changed(model, path, every), open("changed.json", "w"))
        for problem in ([], ["problem.json"]):
            code, out, err = run("certify", "changed.json", *problem)
            tried += 1
            lines = len(err.strip().splitlines())
            if code not in (0, 1, 3, 4) or (code > 1 and lines != 1) or "nan" in out.lower():
                failures += 1
                print(f"FAILED: {name} changed at {path}, seed {seed}: exit {code}, {err[:200]}", file=sys.stderr)
print(tried, "models tried")
sys.exit(failures != 0 or tried < 8 * each)
END
each=30
grep -q __asan_init "$TAUT" && each=8
"$PYTHON" change.py $each || complain "models that were changed"
finish
