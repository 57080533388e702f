"""What each call that computes takes: threads, progress, strict; what progress raises stops it, and so does Ctrl-C."""
import builtins
import inspect
import os
import signal

import numpy as np
import pytest

import taut
from taut import hosts

POINTS = np.random.default_rng(5).standard_normal((5, 5, 3))
POINTS[1:-1, 1:-1] = np.nan
B = taut.bspline(2, count=5)
PROBLEM = {"construct": "dirichlet", "u": B, "v": B, "points": POINTS}
MODEL = taut.make(PROBLEM)
FALSE = taut.Model.from_json(MODEL.to_json().replace('"holds": true', '"holds": false'))
EDGES = [taut.Curve(taut.bezier(1), ends) for ends in ([[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 1]], [[1, 1, 1], [0, 1, 0]], [[0, 1, 0], [0, 0, 0]])]

# Each call with a model and with keywords; calls that make a model of their own take the model for nothing.
CALLS = {
    "certify": lambda model, path, **how: taut.certify(model, PROBLEM, **how),
    "follow": lambda model, path, **how: taut.follow(model.surfaces[0], "geodesic", (0.5, 0.5), (1, 0), **how),
    "gradient": lambda model, path, **how: taut.gradient(PROBLEM, model, "dirichlet_energy", **how),
    "join": lambda model, path, **how: taut.join(model.surfaces[0], "u0", model.surfaces[0], "u1", **how),
    "map": lambda model, path, **how: list(taut.map([PROBLEM] * 3, **how)),
    "make": lambda model, path, **how: taut.make(PROBLEM, **how),
    "measure": lambda model, path, **how: taut.measure(model, **how),
    "pieces": lambda model, path, **how: taut.pieces(model, **how),
    "read": lambda model, path, **how: taut.read(path, **how),
    "refine": lambda model, path, **how: taut.refine(model, **how),
    "split": lambda model, path, **how: taut.split(model, u=0.5, **how),
    "to_nurbs": lambda model, path, **how: taut.to_nurbs(model, **how),
    "to_unit": lambda model, path, **how: taut.to_unit(model, "m", **how),
    "Model.mesh": lambda model, path, **how: model.mesh(**how),
    "Model.to_text": lambda model, path, **how: model.to_text("step", **how),
    "Model.write": lambda model, path, **how: model.write(path.with_suffix(".step"), **how),
    "Surface.mesh": lambda model, path, **how: model.surfaces[0].mesh(**how),
    "hosts.between": lambda model, path, **how: hosts.between("dirichlet", EDGES, **how),
    "hosts.blend": lambda model, path, **how: hosts.blend([[0, 0, -3], [0, 0, 0]], [[3, 0, 3], [6, 0, 3]], 0.5, **how),
}
MADE = {"map", "make", "hosts.between", "hosts.blend"}  # what is given is a problem: nothing in it can fail a claim
OTHERS = {"film_gradient"}  # below
MAKERS = {name for name in taut.__all__ if inspect.isfunction(getattr(taut, name)) and "Basis" == inspect.signature(getattr(taut, name)).return_annotation}


@pytest.fixture(name="path")
def path_of_a_model(tmp_path):
    """Of a file with the model of which a claim does not hold."""
    FALSE.write(tmp_path / "model.json")
    return tmp_path / "model.json"


def computing():
    """All functions of the package but those that make bases, and the methods that compute."""
    functions = {name: getattr(taut, name) for name in [*taut.__all__, "map"] if inspect.isfunction(getattr(taut, name)) and name not in MAKERS}
    methods = {name: getattr(getattr(taut, name.split(".")[0]), name.split(".")[1]) for name in CALLS if name[0].isupper()}
    return {**functions, **methods}


def test_all_take_them():
    for name, function in computing().items():
        parameters = inspect.signature(function).parameters
        defaults = {key: parameters[key].default for key in ("threads", "progress", "strict")}
        assert defaults == {"threads": None, "progress": None, "strict": False}, name
    assert set(computing()) == {name for name in CALLS if not name.startswith("hosts.")} | OTHERS | set(taut.constructions.__all__)


@pytest.mark.parametrize("name", CALLS)
def test_threads(name, path):
    CALLS[name](MODEL, path, threads=2)
    for wrong in (0, -1, "2", 1.5, 2**40):
        with pytest.raises(taut.InputError) as caught:
            CALLS[name](MODEL, path, threads=wrong)
        assert caught.value.reason in ("argument", "type")


@pytest.mark.parametrize("name", CALLS)
def test_progress(name, path):
    told = []
    CALLS[name](MODEL, path, progress=lambda done, what: told.append((done, what)))
    assert told and all((0 <= done <= 1 or done != done) and isinstance(what, str) and what for done, what in told), told

    class Enough(Exception):
        pass

    def stop(done, what):
        calls.append(what)
        raise Enough
    calls = []
    with pytest.raises(Enough):
        CALLS[name](MODEL, path, progress=stop)
    assert len(calls) == 1
    with pytest.raises(taut.InputError) as caught:
        CALLS[name](MODEL, path, progress="loud")
    assert caught.value.reason == "type"
    CALLS[name](MODEL, path)  # nothing of what was stopped stays


@pytest.mark.parametrize("name", sorted(set(CALLS) - MADE))
def test_strict(name, path):
    if name not in ("read", "certify"):
        CALLS[name](MODEL, path, strict=True)
    if name == "certify":  # it looks at the model, not at what was said of it
        assert CALLS[name](FALSE, path, strict=True).holds
        return
    CALLS[name](FALSE, path)
    with pytest.raises(taut.CheckFailed) as caught:
        CALLS[name](FALSE, path, strict=True)
    assert caught.value.model == FALSE and caught.value.reason == "claim"


def test_strict_sweep(tmp_path, monkeypatch):
    """The result is CheckFailed with the model; the line is the model's, and read again it is the same."""
    monkeypatch.setattr(taut.sweeps, "make", lambda *_, **__: FALSE)
    out = tmp_path / "results.jsonl"
    for _ in range(2):
        ((index, result),) = taut.map([PROBLEM], threads=1, out=out, strict=True)
        assert index == 0 and isinstance(result, taut.CheckFailed) and result.model == FALSE
    assert [result for _, result in taut.map([PROBLEM], out=out)] == [FALSE]


def test_progress_of_a_sweep(tmp_path):
    told = []
    list(taut.map([PROBLEM] * 4, threads=2, progress=lambda done, what: told.append(done)))
    assert told == [0.25, 0.5, 0.75, 1.0]
    told.clear()
    list(taut.map(iter([PROBLEM] * 2), threads=1, progress=lambda done, what: told.append(done)))
    assert len(told) == 2 and np.isnan(told).all()

    def stop(done, what):
        if done >= 0.5:
            raise KeyError("enough")
    out = tmp_path / "results.jsonl"
    with pytest.raises(KeyError):
        list(taut.map([PROBLEM] * 4, threads=1, out=out, progress=stop))
    assert out.read_text().count("\n") >= 2
    assert len(list(taut.map([PROBLEM] * 4, threads=1, out=out))) == 4


def test_film_gradient(examples):
    problem = examples["film-sail"]
    model = taut.make(problem)
    told = []
    slopes = taut.film_gradient(problem, model, "area", threads=2, progress=lambda done, what: told.append(what), strict=True)
    assert told and np.isfinite(slopes.corners["u0v0"]).all()
    false = taut.Model.from_json(model.to_json().replace('"holds": true', '"holds": false'))
    with pytest.raises(taut.CheckFailed):
        taut.film_gradient(problem, false, strict=True)
    with pytest.raises(taut.InputError):
        taut.film_gradient(problem, model, threads=0)


@pytest.mark.parametrize("name", sorted(CALLS))
def test_interrupt(name, path):
    """SIGINT that comes while a call is at work is KeyboardInterrupt behind it, and its handler stays."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    sent = []

    def send(done, what):
        if not sent:
            sent.append(what)
            os.kill(os.getpid(), signal.SIGINT)
    try:
        with pytest.raises(KeyboardInterrupt):
            CALLS[name](MODEL, path, progress=send)
        assert sent and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)


def test_star_hides_nothing():
    """`from taut import *` leaves Python's own names as they are."""
    names = {}
    exec("from taut import *", names)  # pylint: disable=exec-used
    assert "plateau" in names and not [name for name in names if hasattr(builtins, name) and not name.startswith("__")]
    assert taut.map is taut.sweeps.map
