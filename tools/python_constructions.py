#!/usr/bin/env python3
"""python_constructions.py [--check] -- writes python/taut/constructions.py: a function for each construction of the schema.

Members of a document become keyword arguments, descriptions become docstrings; with --check says whether the file is current.
"""
import json
import keyword
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCHEMA, OUT = ROOT / "docs/schema/problem.json", ROOT / "python/taut/constructions.py"
LEFT_OUT = {"taut", "construct"}
HEAD = '''"""A function for each construction, its arguments the members of its document: written by tools/python_constructions.py from
docs/schema/problem.json. Arguments that are None are left out of the document. What all take besides:

    threads    how many; the result is the same
    progress   called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict     a claim that does not hold raises CheckFailed
    tolerance  largest distance from the exact surface over its size, where a construction approximates; None: 1e-6
"""
from __future__ import annotations

from typing import Any, Literal, Mapping, Sequence, Union

import numpy.typing as npt

from ._direct import made_of, take_words
from .bases import BasisLike
from .geometry import Curve, Surface
from .making import Progress
from .model import Model

CurveLike = Union[Curve, Mapping[str, Any]]
SurfaceLike = Union[Surface, Mapping[str, Any]]
'''


def resolved(schema, member):
    """A member's own schema, its reference followed; its description stays."""
    reference = member.get("$ref")
    if reference is None:
        return member, ""
    name = reference.rsplit("/", 1)[1]
    return {**schema["$defs"][name], **{key: value for key, value in member.items() if key != "$ref"}}, name


def annotation_of(schema, member):
    """Python's type of a member."""
    body, name = resolved(schema, member)
    if name in ("basis", "curve", "point", "weights"):
        return {"basis": "BasisLike", "curve": "CurveLike"}.get(name, "npt.ArrayLike")
    if "enum" in body:
        return "Literal[" + ", ".join(json.dumps(value) for value in body["enum"]) + "]"
    if "const" in body:
        return f"Literal[{json.dumps(body['const'])}]"
    if "oneOf" in body:
        kinds = list(dict.fromkeys(annotation_of(schema, one) for one in body["oneOf"]))
        return kinds[0] if len(kinds) == 1 else "Union[" + ", ".join(kinds) + "]"
    kind = body.get("type")
    if kind == "object":
        properties = set(body.get("properties", ()))
        if {"u", "v", "points"} <= properties:
            return "SurfaceLike"
        inner = {annotation_of(schema, one) for one in body.get("properties", {}).values()}
        return f"Mapping[str, {inner.pop()}]" if len(inner) == 1 else "Mapping[str, Any]"
    if kind == "array":
        inner = annotation_of(schema, body.get("items", {}))
        return "npt.ArrayLike" if inner in ("float", "int", "npt.ArrayLike") else "Sequence[Any]"
    return {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None"}.get(kind, "Any")


def argument_of(member):
    """A member's name as Python allows it: from_, lambda_."""
    return member + "_" if keyword.iskeyword(member) else member


def packed(items, first, rest, width=124):
    """items with commas between, broken only behind one."""
    lines, line = [], first
    for i, item in enumerate(items):
        piece = item + ("," if i + 1 < len(items) else "")
        if line.strip() and len(line) + 1 + len(piece) > width:
            lines.append(line.rstrip())
            line = rest
        line += piece + " "
    return "\n".join([*lines, line.rstrip()])


def description_of(schema, name, key, member, has_mask):
    """The lines of the docstring about one argument."""
    about, _ = resolved(schema, member)
    said = [about["description"]] if "description" in about else []
    if key == "points":
        said = ["(nu, nv, 3); a point with a NaN" + (", or where `known` is False," if has_mask else "") + " is to be found"] + said
    if "enum" in about:
        said.append("one of " + ", ".join(json.dumps(value) for value in about["enum"]))
    if "minimum" in about or "exclusiveMinimum" in about:
        said.append(f"at least {about['minimum']}" if "minimum" in about else f"above {about['exclusiveMinimum']}")
    if "default" in about:
        said.append(f"{json.dumps(about['default'])} if not given")
    said = said or ["as in docs/format.md"]
    return textwrap.wrap(f"    {argument_of(key):<22} " + "; ".join(said), 120, subsequent_indent=" " * 27)


def function_of(schema, name, body):
    """The text of one construction's function."""
    members = {key: value for key, value in body["properties"].items() if key not in LEFT_OUT and not value.get("deprecated")}
    words = [key for key, value in body["properties"].items() if keyword.iskeyword(key) or value.get("deprecated")]
    has_net, has_mask = "points" in members, "points" in members and "known" not in members
    required = [key for key in body["required"] if key not in LEFT_OUT and key not in words]
    others = sorted((key for key in members if key != "points"), key=lambda key: (key not in required, key not in ("u", "v")))
    keys = (["points"] if has_net else []) + others
    arguments = (["points: npt.ArrayLike | None = None"] if has_net else []) + ["*"]
    for key in others:
        kind = annotation_of(schema, members[key])
        arguments.append(f"{argument_of(key)}: {kind}" + ("" if key in required else " = None" if kind == "Any" else " | None = None"))
    if has_mask:
        arguments.append("known: npt.ArrayLike | None = None")
    options = {"tolerance": "float | None = None", "threads": "int | None = None", "progress": "Progress | None = None",
               "strict": "bool = False", "exact": "bool = False"}
    if not name.startswith("harmonic"):
        del options["exact"]
    arguments += [f"{option}: {kind}" for option, kind in options.items() if option not in members]
    if words:
        arguments.append("**members: Any")
    lines = [line for key in keys for line in description_of(schema, name, key, members[key], has_mask)]
    if has_mask:
        lines.append("    known                  (nu, nv) of truth values: which points are given")
    if words:
        lines += textwrap.wrap("    members                also as the document spells them: " + ", ".join(sorted(words)), 120)
    given = [f'"{key}": {argument_of(key)}' for key in keys]
    calls = [f'{option}={option}' for option in options if option not in members]
    return "\n".join([
        packed(arguments, f"def {name.replace('-', '_')}(", " " * 8) + ") -> Model:",
        textwrap.fill(f'    """{body["description"]}', 118, subsequent_indent="    "), "", *lines, '    """',
        packed(given, "    said: dict[str, Any] = {", " " * 8) + "}",
        *([f"    take_words(said, members, {json.dumps(sorted(words))})"] if words else []),
        f"    return made_of({json.dumps(name)}, said, {'known' if has_mask else 'None'}, {', '.join(calls)})", ""])


def text():
    """The whole file."""
    schema = json.loads(SCHEMA.read_text())
    functions, names = [], []
    for option in schema["$defs"]["problem"]["oneOf"]:
        body = schema["$defs"][option["$ref"].rsplit("/", 1)[1]]
        name = body["properties"]["construct"]["const"]
        names.append(name.replace("-", "_"))
        functions.append(function_of(schema, name, body))
    listed = ", ".join(json.dumps(name) for name in names)
    return HEAD + "\n\n" + "\n\n".join(functions) + f"\n\n__all__ = [{listed}]\n"


def main():
    """The command line."""
    new = re.sub(r" +$", "", text(), flags=re.M)
    if sys.argv[1:] == ["--check"]:
        if not OUT.exists() or OUT.read_text() != new:
            print(f"{OUT.relative_to(ROOT)} is not current: run tools/python_constructions.py")
            return 1
        return 0
    OUT.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
