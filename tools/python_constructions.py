#!/usr/bin/env python3
"""python_constructions.py [--check] -- writes python/taut/constructions.py: a function for each construction of the schema.

Members of a document become keyword arguments, descriptions become docstrings, which also name the reasons of the page's "What can go
wrong" and the header's source; with --check says whether the file is current.
"""
import json
import keyword
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCHEMA, OUT = ROOT / "docs/schema/problem.json", ROOT / "python/taut/constructions.py"
LONGEST = 480  # a form that is told whole
LEFT_OUT = {"taut", "construct"}
OPTIONS = {
    "tolerance": ("float | None = None", "largest distance from the exact surface over its size, where one is approximated; 1e-6 if not given"),
    "threads": ("int | None = None", "how many, 1 to 256; 1 if not given; the result is the same"),
    "progress": ("Progress | None = None", "called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work"),
    "strict": ("bool = False", "a claim that does not hold raises CheckFailed, whose `model` is the model"),
    "exact": ("bool = False", "in rational arithmetic"),
}
KINDS = {"1": "NotConverged", "2": "InputError", "3": "InputError", "4": "NoSolution", "5": "FileError"}  # by exit codes
HEAD = '''"""A function for each construction, its arguments the members of its document: written by tools/python_constructions.py from
docs/schema/problem.json. Arguments that are None are left out of the document. Lengths are in `unit`, angles in radians."""
from __future__ import annotations

import os
from typing import Any, Literal, Mapping, Sequence, Union

import numpy.typing as npt

from ._direct import made_of, take_words
from ._watch import Progress
from .bases import BasisLike
from .geometry import Curve, Surface
from .model import Model

CurveLike = Union[Curve, Mapping[str, Any]]
SurfaceLike = Union[Surface, Mapping[str, Any]]
ModelLike = Union[Model, Mapping[str, Any]]
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
    if "oneOf" in body and "properties" not in body:
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


NAMED = {"basis": "a basis", "curve": "a Curve", "point": "(3,)"}
PLAIN = {"number": "number", "integer": "whole number", "string": "text", "boolean": "True or False", "null": "None"}


def form_of(schema, member, depth=3):
    """What a member looks like, in a line: {"point": (3,), "handle"?: number}; the question mark where it may be left out."""
    body, name = resolved(schema, member)
    if name in NAMED:
        return NAMED[name]
    if "enum" in body or "const" in body:
        return " | ".join(json.dumps(value) for value in body.get("enum", [body.get("const")]))
    if "oneOf" in body and "properties" not in body:
        return " | ".join(dict.fromkeys(form_of(schema, one, depth) for one in body["oneOf"]))
    if body.get("type") == "array":
        inner = form_of(schema, body.get("items", {}), depth)
        return {"(3,)": "(n, 3)", "(n, 3)": "(nu, nv, 3)", "number": "numbers"}.get(inner, f"[{inner}, ..]")
    if body.get("type") != "object":
        return PLAIN.get(body.get("type"), "..")
    members = body.get("properties", {})
    if {"u", "v", "points"} <= set(members) <= {"name", "u", "v", "points", "weights"}:
        return "a Surface"
    forms = {}
    for key, one in members.items():
        mark = "" if key in body.get("required", ()) else "?"
        forms.setdefault(form_of(schema, one, depth - 1) if depth > 0 else "..", []).append(json.dumps(key) + mark)
    return "{" + ", ".join(", ".join(keys) + ": " + form for form, keys in forms.items()) + "}" if forms else "a dict"


def description_of(schema, name, key, member, has_mask):
    """The lines of the docstring about one argument."""
    about, _ = resolved(schema, member)
    said = [about["description"].rstrip(".")] if "description" in about else []
    if key == "points":
        said = ["(nu, nv, 3); a point with a NaN" + (", or where `known` is False," if has_mask else "") + " is to be found"] + said
    if "enum" in about:
        said.append("one of " + ", ".join(json.dumps(value) for value in about["enum"]))
    if "minimum" in about or "exclusiveMinimum" in about:
        said.append(f"at least {about['minimum']}" if "minimum" in about else f"above {about['exclusiveMinimum']}")
    if "default" in about:
        said.append(f"{json.dumps(about['default'])} if not given")
    if about is not member and member.get("$ref", "").endswith("/basis"):
        said.append("such as taut.bspline(3, count=8)")
    form = form_of(schema, member)
    if "{" in form or not said:
        said.append(form if len(form) <= LONGEST else form_of(schema, member, 1))
    return textwrap.wrap(f"    {argument_of(key):<22} " + "; ".join(said), 120, subsequent_indent=" " * 27)


def errors_of(page):
    """Lines about what is raised: the words of the page's table "What can go wrong"."""
    words = {kind: [] for kind in ("InputError", "NoSolution", "NotConverged", "FileError")}
    for word, exits in re.findall(r"^\| `([a-z0-9-]+)` \| ([0-9, ]+) \|", page.read_text(), flags=re.M):
        for kind in dict.fromkeys(KINDS[code.strip()] for code in exits.split(",") if code.strip() in KINDS):
            if word not in words[kind]:
                words[kind].append(word)
    lines = ["    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:"]
    for kind, found in words.items():
        if found:
            lines += textwrap.wrap(f"    {kind:<22} " + ", ".join(found), 120, subsequent_indent=" " * 27, break_on_hyphens=False)
    return lines


def source_of(name, header, page):
    """A line about papers: those that the header cites."""
    text = re.sub(r"\s+\*?\s*", " ", header.read_text())
    found = {}
    for key, part in re.findall(r"\[([A-Za-z]+\d{4})\]((?: (?:sections?|chapters?) [0-9][0-9.]*(?:(?:,| to| and) [0-9][0-9.]*)*)?)", text):
        found[key] = found.get(key) or part.rstrip(".")
    return textwrap.wrap("    Source: " + "; ".join([f"[{key}]{part}" for key, part in found.items()] + [f"docs/{page.name}"]), 120)


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
        if key == "of":  # what a net or a pattern is of
            kind = "Union[ModelLike, Surface, str, os.PathLike[str]]"
        elif key == "start" and kind == "Mapping[str, Any]":
            kind = "ModelLike"
        arguments.append(f"{argument_of(key)}: {kind}" + ("" if key in required else " = None" if kind == "Any" else " | None = None"))
    if has_mask:
        arguments.append("known: npt.ArrayLike | None = None")
    options = {option: about for option, about in OPTIONS.items() if option not in members and (option != "exact" or name.startswith("harmonic"))}
    arguments += [f"{option}: {kind}" for option, (kind, _) in options.items()]
    if words:
        arguments.append("**members: Any")
    lines = [line for key in keys for line in description_of(schema, name, key, members[key], has_mask)]
    if has_mask:
        lines.append("    known                  (nu, nv) of truth values: which points are given")
    if words:
        lines += textwrap.wrap("    members                also as the document spells them: " + ", ".join(sorted(words)), 120)
    lines += [line for option, (_, about) in options.items()
              for line in textwrap.wrap(f"    {option:<22} {about}", 120, subsequent_indent=" " * 27)]
    room = name.split("-")[0]  # of the header and the page
    page = ROOT / f"docs/{room}.md"
    lines += ["", "    Gives the Model, with its certificate.", "", *errors_of(page), "", *source_of(name, ROOT / f"include/taut/{room}.h", page)]
    given = [f'"{key}": {argument_of(key)}' for key in keys]
    calls = [f'{option}={option}' for option in options]
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
