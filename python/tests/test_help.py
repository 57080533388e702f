"""help() is enough: all that is public says what it is, what is raised, and where constructions come from."""
import importlib
import inspect
import json
import re

import pytest

import taut
from conftest import ROOT

MODULES = ["taut"] + ["taut." + name for name in ("gismo", "hosts", "neighbours")]


def public():
    """(name, object) of all functions, classes, and of classes their functions and properties."""
    for module in map(importlib.import_module, MODULES):
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isfunction(value) or inspect.isclass(value):
                yield f"{module.__name__}.{name}", value
            if inspect.isclass(value) and not issubclass(value, Exception):
                for key, member in vars(value).items():
                    if (not key.startswith("_") or key == "__call__") and isinstance(member, (property, classmethod, type(public))):
                        yield f"{module.__name__}.{name}.{key}", member


ALL = dict(public())


def test_all_is_there():
    assert len(ALL) > 100 and "taut.plateau" in ALL and "taut.Surface.grid" in ALL and "taut.Surface.u" in ALL


@pytest.mark.parametrize("name", sorted(ALL))
def test_says_what_it_is(name):
    assert len(inspect.getdoc(ALL[name]) or "") >= 8


@pytest.mark.parametrize("name", sorted(name for name, value in ALL.items() if inspect.isfunction(value) or isinstance(value, classmethod)))
def test_says_what_it_raises(name):
    """All that takes something names an error, but for reports of what it is given."""
    value = ALL[name]
    function = value.__func__ if isinstance(value, classmethod) else value
    taken = [key for key in inspect.signature(function).parameters if key not in ("self", "cls")]
    if taken and name not in ("taut.hosts.claims", "taut.hosts.told"):
        assert re.search(r"Errors?\b|ImportError", inspect.getdoc(function)), inspect.getdoc(function)


@pytest.mark.parametrize("name", sorted(taut.constructions.__all__))
def test_constructions(name):
    """Each member with what it is, what is raised, and a source to look up."""
    function = getattr(taut.constructions, name)
    text = inspect.getdoc(function)
    assert re.search(r"Source: .*docs/[a-z]+\.md", text, re.DOTALL) and "Raises" in text
    for key in inspect.signature(function).parameters:
        assert re.search(rf"(?m)^{key}\b", text), key


def test_forms_are_told():
    """What the objects in a document look like: all their members, also of those in lists, with a mark at what may be left out."""
    definitions = json.loads((ROOT / "docs/schema/problem.json").read_text())["$defs"]

    def objects(member):
        member = definitions[member["$ref"].rsplit("/", 1)[1]] if "$ref" in member else member
        for one in [*member.get("oneOf", ()), *([member["items"]] if isinstance(member.get("items"), dict) else ())]:
            yield from objects(one)
        if "points" not in member.get("properties", {"points": 0}):
            yield member
    seen = 0
    for option in definitions["problem"]["oneOf"]:
        body = definitions[option["$ref"].rsplit("/", 1)[1]]
        text = inspect.getdoc(getattr(taut, body["properties"]["construct"]["const"].replace("-", "_")))
        assert "as in docs/format.md" not in text
        for key, member in body["properties"].items():
            for one in objects(member):
                lines = re.search(rf"(?m)^{key}_? .*(\n  +.*)*", text)[0] if member.get("type") != "string" else ""
                for name in one["properties"] if member.get("$ref") != "#/$defs/basis" else ():
                    seen += 1
                    assert f'"{name}"' + "?" * (name not in one.get("required", ())) in lines, (key, name, lines)
    assert seen > 50
    assert '"point", "direction": (3,), "handle"?: number' in inspect.getdoc(taut.pipe)
