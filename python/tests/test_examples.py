"""Every example through Python is byte for byte what the program makes."""
import inspect
import os
import pickle
import re
import subprocess

import pytest
from conftest import ROOT, document, names

import taut


def made_by(program, path):
    """What the program prints; a claim that does not hold is exit 1."""
    return subprocess.run([program, "make", "--quiet", str(path)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout


@pytest.mark.parametrize("name", names())
def test_example_is_the_programs(name, program, examples, monkeypatch):
    monkeypatch.chdir(ROOT / "examples")
    path = examples[name]
    expected = made_by(program, path)
    model = taut.make(path)
    assert model.to_json().encode() == expected
    members = {key: value for key, value in document(path).items() if key not in ("taut", "construct")}
    function = getattr(taut, document(path)["construct"].replace("-", "_"))
    assert function(**members) == model
    assert taut.make(document(path)) == model
    copy = pickle.loads(pickle.dumps(model))
    assert copy == model and hash(copy) == hash(model) and copy.certificate == model.certificate
    proof = taut.certify(model, path)
    assert [(one.claim, one.holds) for one in proof] == [(one.claim, one.holds) for one in model.certificate]


def test_all_constructions_have_a_function():
    library = taut._library.library
    listed = {library.taut_construct_name(i).decode().replace("-", "_") for i in range(library.taut_construct_count())}
    assert listed == set(taut.constructions.__all__)


@pytest.mark.parametrize("name", taut.constructions.__all__)
def test_help_says_it_all(name):
    """Every argument, what comes back, what is raised and where it comes from."""
    function = getattr(taut, name)
    for argument in inspect.signature(function).parameters:
        assert re.search(rf"^    {argument} +\S", function.__doc__, re.M), argument
    reasons = re.findall(r"[a-z]+(?:-[a-z]+)*", "".join(re.findall(r"^    (?:InputError|NoSolution) .*(?:\n {20}.*)*", function.__doc__, re.M)))
    assert len(reasons) > 3 and "Gives the Model" in function.__doc__ and "Source: " in function.__doc__


def test_functions_are_current():
    assert subprocess.run(["/usr/bin/env", "python3", str(ROOT / "tools/python_constructions.py"), "--check"], check=False).returncode == 0


def test_boundary_is_beside_its_document(examples, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    for name, path in examples.items():
        if "boundary" in document(path):
            assert taut.make(path).certificate.holds, name
            assert not os.listdir(tmp_path)


def test_readme(program, tmp_path, monkeypatch, capsys):
    """The README's problem by the README's lines of Python."""
    text = (ROOT / "README.md").read_text()
    (tmp_path / "tent.json").write_text(re.search(r"```json\n(.*?)```", text, re.S)[1])
    monkeypatch.chdir(tmp_path)
    exec(re.search(r"```python\n(.*?)```", text, re.S)[1], {})
    said = re.fullmatch(r"\[(.*)\] \(3, 3, 3\)\nTrue (4\.199715535\d*)\n", capsys.readouterr().out)
    assert said and [float(x) for x in said[1].split()] == [0, 0, 0.375]  # 4 x 1/8 - 1/2 x 1/4


def test_lesson(tmp_path, monkeypatch, capsys):
    """The lesson's lines on cutting patterns, beside its file: what is left along a seam is left on its right alone."""
    lessons = ROOT / "docs/tutorial"
    (tmp_path / "sail.json").write_text((lessons / "sail.json").read_text())
    monkeypatch.chdir(tmp_path)
    exec(re.search(r"```python\n(.*?)```", (lessons / "7-sail.md").read_text(), re.S)[1], {})
    said = capsys.readouterr().out.splitlines()
    assert [line.rsplit(" ", 1)[0] for line in said[:4]] == ["P1 [0.03, 0.05]", "P2 [0, 0.03]", "P3 [0.03, 0.06]", "P4 [0.05, 0.03]"]
    assert [line.split()[0] for line in said[4:]] == ["S1", "S2", "S3"] and os.path.getsize("python.dxf") > 10000


def test_page(tmp_path, monkeypatch):
    """The page's lines run as they stand."""
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(re.search(r"```python\n(.*?)```", (ROOT / "docs/python.md").read_text(), re.S)[1], names)
    assert names["model"].certificate["stationary"].holds and os.path.getsize("roof.step") > 1000
