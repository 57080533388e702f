"""schemas.py -- the schemas of docs/schema and the readers know the same documents and the same members."""

import json
import os

from jsonschema import Draft202012Validator

from program import SOURCE, complain, example, finish, load, run, save

SCHEMAS = {name: load(f"{SOURCE}/docs/schema/{name}.json") for name in ("problem", "model", "report")}
VALIDATORS = {name: Draft202012Validator(schema) for name, schema in SCHEMAS.items()}

# Documents that are lists, and the exit code of taut make: an empty list and a list in a list are none.
PROBLEM = example("dirichlet-bicubic")
LISTS = [([PROBLEM], 0), ([PROBLEM, PROBLEM], 0), ([], 3), ([[PROBLEM]], 3), ([1], 3)]

# The objects of a model, and a model with such an object of one member.
OBJECTS = [
    ("surface", lambda member: {"taut": 1, "surfaces": [member]}),
    ("curve", lambda member: {"taut": 1, "curves": [member]}),
    ("certificate", lambda member: {"taut": 1, "certificate": member}),
    ("claim", lambda member: {"taut": 1, "certificate": {"construct": "x", "claims": [member]}}),
]


def check(kind, what, document):
    error = next(VALIDATORS[kind].iter_errors(document), None)
    if error is not None:
        complain(f"{what}: read, but against the schema of a {kind}: {error.message[:200]}")


def check_made(what):
    """The models and the reports that taut make has written, of a problem or of a list."""
    models, reports = load("made.json"), load("report.json")
    check("report", what + " (report)", reports)
    for model in models if isinstance(models, list) else [models]:
        check("model", what + " (made)", model)


def files():
    for folder in (f"{SOURCE}/tests/fuzz/corpus/documents", f"{SOURCE}/examples"):
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            if os.path.isfile(path):
                yield path


def check_documents():
    """What is read satisfies the schema: the fuzz corpus, the examples, and what taut writes."""
    count = {"problem": 0, "model": 0}
    for path in files():
        try:
            with open(path, encoding="utf-8-sig") as file:
                document = json.load(file)
        except (ValueError, RecursionError):
            continue
        if isinstance(document, dict) and "shape" in document and "taut" not in document:
            continue # geomdl's: its members are another's to say
        code = run("make", path, "-o", "made.json", "--report", "report.json", "--quiet")[0]
        if code in (0, 1, 4):
            count["problem"] += 1
            check("problem", path, document)
        if code == 0:
            check_made(path)
        if run("convert", path, "-o", "converted.json")[0] == 0:
            count["model"] += 1
            check("model", path, document)
    if min(count.values()) < 8:
        complain(f"only {count} documents were read")


def check_lists():
    for document, wanted in LISTS:
        save("list.json", document)
        code = run("make", "list.json", "-o", "made.json", "--report", "report.json", "--quiet")[0]
        if code != wanted or VALIDATORS["problem"].is_valid(document) != (wanted == 0):
            complain(f"{str(document)[:40]}: exit {code}, and the schema differs")
        if code == 0:
            check_made("a list")


def check_members(where, schema, build, command="measure"):
    """Every member that a schema has is known to the reader, and no other."""
    for name in [*schema["properties"], "strange"]:
        save("d.json", build(name))
        known = "there is no such member" not in run(command, "d.json")[2]
        if known != (name != "strange"):
            complain(f"{where}: the reader and the schema differ over \"{name}\"")


def check_models():
    definitions = SCHEMAS["model"]["$defs"]
    check_members("model", SCHEMAS["model"], lambda name: {"taut": 1, name: None})
    for where, build in OBJECTS:
        check_members(where, definitions[where], lambda name: build({name: None}))
    bases = {}
    for basis in definitions["basis"]["oneOf"]:
        bases.setdefault(basis["properties"]["type"]["const"], {}).update(basis["properties"])
    for word, properties in bases.items():
        check_members(word, {"properties": properties}, lambda name: {"taut": 1, "curves": [
            {"t": {"type": word, name: word if name == "type" else None}, "points": [[0, 0, 0]]}]})


def check_problems():
    definitions = SCHEMAS["problem"]["$defs"]
    for option in definitions["problem"]["oneOf"]:
        schema = definitions[option["$ref"].split("/")[-1]]
        construct = schema["properties"]["construct"]["const"]
        check_members(construct, schema, lambda name: {"taut": 1, name: None, "construct": construct}, "make")


for each in SCHEMAS.values():
    Draft202012Validator.check_schema(each)
check_documents()
check_lists()
check_models()
check_problems()
finish()
