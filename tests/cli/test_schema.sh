# test_schema.sh -- the schemas are JSON, and they say what the readers do.
. "$SOURCE/tests/cli/cli.sh"

for name in problem model report; do
    run 0 schema "$name"
    cmp -s out.txt "$SOURCE/docs/schema/$name.json" || complain "schema $name is another than docs/schema/$name.json"
    # taut's own parser gets through it, and stumbles over its first member only
    refused 3 '/\$schema: there is no such member' measure "$SOURCE/docs/schema/$name.json"
done

python_with jsonschema || skip python3-jsonschema 'tools/deps.sh test'

# Every document that is read must satisfy its schema: the fuzz corpus, the examples, and what taut writes.
cat > valid.py <<'END'
import json, os, subprocess, sys
from jsonschema import Draft202012Validator

taut, source = os.environ["TAUT"], os.environ["SOURCE"]
schemas = {n: json.load(open(f"{source}/docs/schema/{n}.json")) for n in ("problem", "model", "report")}
for schema in schemas.values():
    Draft202012Validator.check_schema(schema)
validators = {n: Draft202012Validator(s) for n, s in schemas.items()}
failures = 0
read = {"problem": 0, "model": 0}

def complain(what):
    global failures
    failures += 1
    print("FAILED:", what, file=sys.stderr)

def run(*words):
    done = subprocess.run([taut, *words], capture_output=True)
    return done.returncode, done.stderr.decode(errors="replace")

def check(kind, path, document):
    error = next(validators[kind].iter_errors(document), None)
    if error is not None:
        complain(f"{path}: read, but against the schema of a {kind}: {error.message[:200]}")

# What is read satisfies the schema.
folders = [f"{source}/tests/fuzz/corpus/documents", f"{source}/examples"]
for path in [os.path.join(f, n) for f in folders if os.path.isdir(f) for n in sorted(os.listdir(f))
             if os.path.isfile(os.path.join(f, n))]:
    try:
        document = json.loads(open(path, encoding="utf-8-sig").read())
    except (ValueError, RecursionError):
        continue
    if isinstance(document, dict) and "shape" in document and "taut" not in document:
        continue # geomdl's: its members are another's to say
    code, _ = run("make", path, "-o", "made.json", "--report", "report.json", "--quiet")
    if code in (0, 1, 4):
        read["problem"] += 1
        check("problem", path, document)
    if code == 0:
        check("model", path + " (made)", json.load(open("made.json")))
        check("report", path + " (report)", json.load(open("report.json")))
    code, _ = run("convert", path, "-o", "converted.json")
    if code == 0:
        read["model"] += 1
        check("model", path, document)
if read["problem"] < 8 or read["model"] < 8:
    complain(f"only {read} documents were read")

# Every member that a schema has is known to the reader, and no other.
BEZIER = {"type": "bezier", "degree": 1}
NET = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]

def known(document, command):
    with open("d.json", "w") as file:
        json.dump(document, file)
    return "there is no such member" not in run(command, "d.json")[1]

def members(where, schema, build, command="measure"):
    for name in list(schema["properties"]) + ["strange"]:
        if known(build(name), command) != (name != "strange"):
            complain(f"{where}: the reader and the schema differ over \"{name}\"")

# A list of problems and the list of their reports are documents too; an empty list and a list in a list are none.
problem = json.load(open(f"{source}/examples/dirichlet-bicubic.json"))
for what, wanted in (([problem], 0), ([problem, problem], 0), ([], 3), ([[problem]], 3), ([1], 3)):
    with open("list.json", "w") as file:
        json.dump(what, file)
    code, _ = run("make", "list.json", "-o", "made.json", "--report", "report.json", "--quiet")
    if code != wanted or validators["problem"].is_valid(what) != (wanted == 0):
        complain(f"{str(what)[:40]}: exit {code}, and the schema differs")
    if code == 0:
        check("report", "a list (report)", json.load(open("report.json")))
        for model in json.load(open("made.json")):
            check("model", "a list (made)", model)

definitions = schemas["model"]["$defs"]
members("model", schemas["model"], lambda n: {"taut": 1, n: None})
members("surface", definitions["surface"], lambda n: {"taut": 1, "surfaces": [{n: None}]})
members("curve", definitions["curve"], lambda n: {"taut": 1, "curves": [{n: None}]})
members("certificate", definitions["certificate"], lambda n: {"taut": 1, "certificate": {n: None}})
members("claim", definitions["claim"],
        lambda n: {"taut": 1, "certificate": {"construct": "x", "claims": [{n: None}]}})
bases = {}
for basis in definitions["basis"]["oneOf"]:
    bases.setdefault(basis["properties"]["type"]["const"], {}).update(basis["properties"])
for name, properties in bases.items():
    members(name, {"properties": properties},
            lambda n: {"taut": 1, "curves": [{"t": {"type": name, n: name if n == "type" else None},
                                              "points": [[0, 0, 0]]}]})
for option in schemas["problem"]["$defs"]["problem"]["oneOf"]:
    schema = schemas["problem"]["$defs"][option["$ref"].split("/")[-1]]
    construct = schema["properties"]["construct"]["const"]
    members(construct, schema, lambda n: {"taut": 1, n: None, "construct": construct}, "make")

sys.exit(failures != 0)
END
"$PYTHON" -W ignore valid.py || complain "the schemas and the readers differ"
finish
