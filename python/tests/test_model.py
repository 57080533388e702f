"""Models, certificates, files, errors."""
import base64
import copy
import ctypes
import json
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time
import types
import weakref

import numpy as np
import pytest
from conftest import ROOT

import taut


def test_asked_by_name(net):
    """A model is not gone through, its surfaces are."""
    model = taut.dirichlet(net, u=taut.bezier(4), v=taut.bezier(5))
    certificate = model.certificate
    assert "known" in certificate and "roof" not in certificate and certificate["known"] in certificate
    assert "dirichlet" in model and "roof" not in model
    with pytest.raises(TypeError):
        list(model)


def test_piece_of_cloth(net):
    """A piece has its numbers and its lines, which are as long as told."""
    cloth = taut.make(json.loads((ROOT / "examples" / "pattern-cylinder.json").read_text()))
    piece = cloth.piece("P2")
    assert piece["flat"].name == "P2" and piece["cut"].name == "P2.cut"
    assert abs(piece["edges"]["right"]["flat_length"] - 3.84187454245970916) < 1e-9
    ends = piece["lines"]["right"](np.array([0.0, 1.0]))
    assert abs(np.linalg.norm(ends[1] - ends[0]) - piece["edges"]["right"]["flat_length"]) < 1e-9  # straight: a cylinder's geodesic
    flat = taut.dirichlet(net, u=taut.bezier(4), v=taut.bezier(5))
    for model, name in ((cloth, "P99"), (cloth, None), (flat, "P1")):
        with pytest.raises(KeyError):
            model.piece(name)



def test_masked_points_are_to_be_found(net):
    """As NaN are, by every way in."""
    u, v = taut.bezier(4), taut.bezier(5)
    expected = taut.dirichlet(net, u=u, v=v)
    masked = np.ma.masked_array(np.nan_to_num(net, nan=7.0), np.isnan(net))
    single = np.ma.masked_array(masked.data, np.isnan(net) & (np.arange(3) == 1))  # one coordinate of each
    for points in (masked, single):
        assert taut.dirichlet(points, u=u, v=v) == taut.make({"construct": "dirichlet", "u": u, "v": v, "points": points}) == expected
    whole = np.ma.masked_array(expected.surfaces[0].points)
    assert taut.Surface(u, v, whole, name="dirichlet") == expected.surfaces[0]
    with pytest.raises(taut.InputError):
        taut.dirichlet(masked, u=u, v=v, known=np.ones((5, 6), bool))


class Stopped(Exception):
    """Raised in the middle of a call."""


def test_meshes_and_files_tell_progress_and_stop(net, tmp_path):
    """What is raised comes out, and no file is left."""
    surface = taut.dirichlet(net, u=taut.bezier(4), v=taut.bezier(5)).surfaces[0]
    model, told = taut.Model([surface] * 3), []

    def stop(done, what):
        raise Stopped(what)
    for call in (model.mesh, surface.mesh, lambda progress: model.to_text("obj", progress=progress),
                 lambda progress: model.write(tmp_path / "x.stl", progress=progress)):
        told.clear()
        call(progress=lambda done, what: told.append((done, what)))
        meshing = [done for done, what in told if what == "mesh"]  # other words follow while a file is written
        assert meshing and told[0][1] in ("mesh", "write") and all(0 <= done <= 1 for done in meshing) and meshing == sorted(meshing)
        (tmp_path / "x.stl").unlink(missing_ok=True)
        with pytest.raises(Stopped):
            call(progress=stop)
    assert not list(tmp_path.iterdir())
    assert model.mesh(progress=lambda done, what: None) == model.mesh()


def test_lists_of_surfaces_are_values(net):
    """Of a model: what is equal hashes so, whichever model it is of."""
    u, v = taut.bspline(2, count=5), taut.bspline(3, count=6)
    one, other = taut.dirichlet(net, u=u, v=v), taut.dirichlet(net, u=u, v=v)
    assert one.surfaces == other.surfaces == (one.surfaces[0],) and hash(one.surfaces) == hash(other.surfaces)
    assert one.curves == other.curves == () and one.surfaces != one.curves and one.surfaces != [one.surfaces[0]]
    assert copy.deepcopy(one.surfaces) == one.surfaces != taut.dirichlet(net + 1, u=u, v=v).surfaces


def test_bases_that_are_equal_hash_so():
    """-0 and 0 are two knots."""
    one, other = taut.bspline(1, knots=[0.0, 0.0, 1.0, 1.0]), taut.bspline(1, knots=[-0.0, -0.0, 1.0, 1.0])
    assert one != other and one == taut.bspline(1, knots=[0, 0, 1, 1]) and len({one, other, taut.bspline(1, count=2)}) == 2


def test_dirichlet_from_arrays(net):
    u, v = taut.bspline(2, count=5), taut.bspline(3, count=6)
    model = taut.dirichlet(net, u=u, v=v)
    assert model.certificate.holds and model.certificate["stationary"].kind == "bound"
    known = ~np.isnan(net).any(axis=-1)
    filled = np.where(known[..., None], net, 1e9)
    assert taut.dirichlet(filled, u=u, v=v, known=known) == model
    assert taut.dirichlet(net.tolist(), u=u.to_dict(), v=v.to_dict()) == model  # through a document
    assert taut.make({"construct": "dirichlet", "points": net, "u": u, "v": v}) == model
    assert (model.surfaces[0].points[known] == net[known]).all()
    assert copy.deepcopy(model) == model and model["dirichlet"] == model.surfaces[0]
    with pytest.raises(KeyError):
        model["roof"]


def test_dirichlet_is_a_minimum(net):
    """Moving any unknown point raises the energy: a second method."""
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    surface = model.surfaces[0]
    least = taut.measure(surface)["dirichlet_energy"]
    for i, j in ((1, 1), (2, 3), (3, 4)):
        points = np.array(surface.points)
        points[i, j, 2] += 1e-3
        assert taut.measure(taut.Surface(surface.u, surface.v, points))["dirichlet_energy"] > least


def test_certificate(net):
    model = taut.plateau(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    certificate = model.certificate
    document = json.loads(model.to_json())["certificate"]
    assert [one["claim"] for one in document["claims"]] == [one.claim for one in certificate]
    assert certificate.figures == document["figures"] and certificate.construct == "plateau"
    assert certificate["stationary"] == certificate.claims[[one.claim for one in certificate].index("stationary")]
    with pytest.raises(AttributeError):
        certificate.holds = True
    assert "<table>" in certificate._repr_html_()


def test_figures_are_a_copy(net):
    model = taut.dirichlet(net, u=taut.bezier(net.shape[0] - 1), v=taut.bezier(net.shape[1] - 1))
    area = model.certificate.figures["area"]
    model.certificate.figures["area"] = 0
    assert model.certificate.figures["area"] == area


def test_changed_model_fails(net):
    u, v = taut.bspline(2, count=5), taut.bspline(3, count=6)
    problem = {"construct": "dirichlet", "points": net, "u": u, "v": v}
    model = taut.make(problem)
    points = np.array(model.surfaces[0].points)
    points[2, 2] += 1e-3
    forged = taut.Model([taut.Surface(u, v, points, name="dirichlet")])
    certificate = taut.certify(forged, problem)
    assert certificate.holds is False and certificate["stationary"].holds is False


def test_strict():
    path = ROOT / "examples/asymptotic-3.json"
    model = taut.make(path)
    assert model.certificate.holds is False
    with pytest.raises(taut.CheckFailed) as caught:
        taut.make(path, strict=True)
    assert caught.value.model == model


ERRORS = [({"construct": "dirichlet"}, taut.InputError, ""),
          ({"construct": "drichlet"}, taut.InputError, "/construct"),
          ({"construct": "dirichlet", "u": taut.bezier(1), "v": taut.bezier(1), "points": [[[0, 0], [0, 0, 0]], [[0, 0, 0]] * 2]},
           taut.InputError, "/points/0/0"),
          ({"construct": "dirichlet", "u": taut.bezier(1), "v": taut.bezier(1), "points": [[None, None], [None, None]]},
           taut.NoSolution, "/points"),
          ({"construct": "bonnet", "lambda": float("inf"), "sign": "+", "alpha": 1, "beta": 1}, taut.InputError, "/lambda"),
          ({"construct": "bonnet", "lambda": np.array([0.1, np.nan]), "sign": "+", "alpha": 1, "beta": 1}, taut.InputError, "/lambda/1"),
          ({"construct": "bonnet", "lambda": object(), "sign": "+", "alpha": 1, "beta": 1}, taut.InputError, "/lambda"),
          ("/nonexistent/problem.json", taut.FileError, ""), ('{"taut": 1', taut.InputError, "<document>")]


@pytest.mark.parametrize("document, kind, where", ERRORS)
def test_errors_are_data(document, kind, where):
    with pytest.raises(kind) as caught:
        taut.make(document)
    error = caught.value
    assert isinstance(error, taut.Error) and error.reason and error.where.startswith(where), vars(error)
    assert str(error) == error.message
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error) and again.__dict__ == error.__dict__


def test_files(tmp_path, net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    for ending in ("json", "step", "obj", "stl", "ply", "glb", "3mf", "vtu", "svg"):
        path = tmp_path / f"m.{ending}"
        model.write(path)
        assert path.stat().st_size > 100
    assert taut.read(tmp_path / "m.json") == model
    assert model.to_text("obj") == (tmp_path / "m.obj").read_bytes()
    with pytest.raises(taut.InputError):
        model.write(tmp_path / "m.doc")
    with pytest.raises(taut.FileError):
        model.write(tmp_path / "no/m.json")
    with pytest.raises(TypeError):
        model.write(tmp_path / "m.svg", color="mean")
    with pytest.raises(taut.Error):
        taut.read(tmp_path / "m.svg")


def test_mesh(net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    mesh = model.mesh(divide=3)
    assert mesh.triangles.max() < len(mesh.vertices) and len(mesh.triangles) == 2 * len(mesh.quads)
    assert np.abs(model.surfaces[0](*mesh.parameters.T) - mesh.vertices).max() < 1e-13
    assert np.abs(np.linalg.norm(mesh.normals, axis=1) - 1).max() < 1e-12
    corners = mesh.vertices[mesh.triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    assert abs(area - taut.measure(model.surfaces[0])["area"]) < 0.05 * area
    vertices = mesh.vertices
    del mesh, model
    assert np.isfinite(vertices).all()


def test_meshes_are_values(net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    mesh, other = model.mesh(divide=3), model.mesh(divide=4)
    back = pickle.loads(pickle.dumps(mesh))
    assert back == mesh == model.mesh(divide=3) and hash(back) == hash(mesh) and mesh != other and copy.deepcopy(mesh) is mesh
    assert (back.faces == mesh.triangles).all() and not back.vertices.flags.writeable
    with pytest.raises(AttributeError):
        mesh.vertices = other.vertices


def test_models_are_immutable(net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    for one, name in ((model, "unit"), (model, "certificate"), (model, "mine"), (model.surfaces[0], "points"), (model.surfaces[0], "mine"),
                      (model.surfaces[0].u, "degree"), (model.certificate, "holds"), (model.certificate["known"], "residual")):
        with pytest.raises(AttributeError):
            setattr(one, name, None)
    assert weakref.ref(model)() is model
    for one in (model.surfaces[0], model.surfaces[0].u, model.certificate, model.mesh()):
        kept = weakref.WeakKeyDictionary({one: 1})
        assert weakref.ref(one)() is one and kept[one] == 1


def test_mesh_of_a_sheet():
    """A plate of 2 x 3 x 1/4: its volume by the divergence theorem, and refused where it folds."""
    plane = taut.dirichlet(np.array([[[0, 0, 0], [0, 3, 0]], [[2, 0, 0], [2, 3, 0]]], float), u=taut.bezier(1), v=taut.bezier(1))
    mesh = plane.mesh(divide=2, thickness=0.25)
    assert np.abs(np.abs(mesh.vertices[:, 2]) - 0.125).max() == 0
    assert len(mesh.triangles) == 32
    assert plane.to_text("3mf", thickness=0.25)[:4] == b"PK\x03\x04"
    with pytest.raises(taut.Error):
        plane.mesh(thickness=-1.0)


def test_measure_is_the_programs(program, tmp_path, net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    model.write(tmp_path / "m.json")
    said = json.loads(subprocess.run([program, "measure", str(tmp_path / "m.json"), "--json", "--grid", "31"], check=True,
                                     stdout=subprocess.PIPE).stdout)
    assert taut.measure(model, grid=31)["surfaces"] == said["surfaces"]


def test_operations_of_models(net):
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    halves = taut.split(model, u=0.4)
    assert len(halves.surfaces) == 2 and halves.certificate is None
    joined = taut.join(halves.surfaces[0], "u1", halves.surfaces[1], "u0")
    assert joined["c_order"] >= 1 and joined["kind"] == "bound"
    assert taut.refine(model).surfaces[0].u.count > 5
    nurbs, bound = taut.to_nurbs(taut.make(ROOT / "examples/bonnet-helicoid.json"), 1e-8)
    assert nurbs.surfaces[0].u.type == "bspline" and 0 < bound < 1e-6
    with pytest.raises(taut.InputError):
        taut.split(model)
    with pytest.raises(taut.Error):
        taut.split(model, u=7.0)


def test_progress_and_what_it_raises():
    path = ROOT / "examples/plateau-curves.json"
    told = []
    model = taut.make(path, progress=lambda done, what: told.append((done, what)))
    assert told and all(what for _, what in told) and model.certificate.holds

    def stop(done, what):
        raise RuntimeError("enough")
    with pytest.raises(RuntimeError, match="enough"):
        taut.make(path, progress=stop)
    assert taut.make(path) == model

    for work in (lambda **said: taut.certify(model, path, **said), lambda **said: taut.measure(model, **said)):
        told.clear()
        result = work(progress=lambda done, what: told.append(what))
        assert set(told) <= {"proving", "measuring"} and told
        with pytest.raises(RuntimeError, match="enough"):
            work(progress=stop)
        again = work()
        assert again.claims == result.claims if isinstance(again, taut.Certificate) else again == result


def test_strict_proof():
    model = taut.make(ROOT / "examples/dirichlet-tent.json")
    other = json.loads((ROOT / "examples/dirichlet-tent.json").read_text())
    other["aspect"] = 3
    assert taut.certify(model, other).holds is False
    with pytest.raises(taut.CheckFailed) as caught:
        taut.certify(model, other, strict=True)
    assert caught.value.model is model


SLOW = '''
import signal, sys
import taut, numpy as np
signal.signal(signal.SIGINT, signal.default_int_handler)  # what a shell puts into the background ignores it
n = 70
x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
points = np.stack([x, y, 0.3 * np.sin(9 * x) * np.cos(11 * y)], axis=-1)
points[1:-1, 1:-1] = np.nan
print("begun", flush=True)
try:
    taut.plateau(points, u=taut.bspline(3, count=n), v=taut.bspline(3, count=n), gap=1e-9)
except KeyboardInterrupt:
    print("interrupted", signal.getsignal(signal.SIGINT) is signal.default_int_handler)
'''


def test_ctrl_c():
    import os
    process = subprocess.Popen([sys.executable, "-c", SLOW], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                               env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    assert process.stdout.readline() == "begun\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=300)
    assert out == "interrupted True\n", errors
    assert errors == ""


def test_threads_at_once(net):
    """The interpreter's lock is released, and objects may be used from any thread."""
    u, v = taut.bspline(2, count=5), taut.bspline(3, count=6)
    expected = taut.dirichlet(net, u=u, v=v)
    failures = []

    def work():
        for _ in range(50):
            if taut.dirichlet(net, u=u, v=v) != expected or not np.isfinite(expected.surfaces[0](0.5, 0.5)).all():
                failures.append(1)
    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_objects_leave_nothing(net):
    """Objects by the thousand leave the process as large as it was."""
    import resource
    u, v = taut.bspline(2, count=5), taut.bspline(3, count=6)

    def work(count):
        for _ in range(count):
            taut.dirichlet(net, u=u, v=v).surfaces[0].points.sum()
    work(300)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    work(3000)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4000  # kB


def test_layouts_are_those_of_the_headers():
    """Every function that is called is in the headers, with as many arguments."""
    import re
    text = "".join(path.read_text() for path in sorted((ROOT / "include/taut").glob("*.h")))
    for name, signature in taut._library.SIGNATURES.items():
        found = re.search(rf"TAUT_API [^;]*?\b{name}\((.*?)\);", text, re.S)
        assert found, name
        arguments = 0 if found[1].strip() == "void" else found[1].count(",") + 1
        assert arguments == len(signature.split(":")[1]), name


def test_other_library_is_refused(tmp_path):
    import os
    for library, said in (("/nonexistent/libtaut.so", "not found"), (np.core._multiarray_umath.__file__, "has no taut_")):
        result = subprocess.run([sys.executable, "-c", "import taut"], stderr=subprocess.PIPE, universal_newlines=True, check=False,
                                env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "TAUT_LIBRARY": library})
        assert result.returncode == 1 and said in result.stderr


def test_altered_library_is_refused(tmp_path):
    """A copy of the library with one thing changed is refused, with its name: another member, another struct, another version."""
    import os
    library = taut._library.library
    data = pathlib.Path(library._name).read_bytes()
    version = library.taut_version()
    for old, new, said in ((b"\0", b"\0", None), (b"\0time_limit\0", b"\0tame_limit\0", "lays out taut_make_options otherwise"),
                           (b"\0taut_claim\0", b"\0taut_clain\0", "does not know taut_claim"),
                           (version + b"\0", b"9" + version[1:] + b"\0", "is version 9")):
        assert old in data and len(new) == len(old)
        copy = tmp_path / pathlib.Path(library._name).name
        copy.write_bytes(data.replace(old, new))
        result = subprocess.run([sys.executable, "-c", "import taut"], stderr=subprocess.PIPE, universal_newlines=True, check=False,
                                env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "TAUT_LIBRARY": str(copy)})
        assert result.returncode == (0 if said is None else 1) and (said is None or f"{copy}" in result.stderr and said in result.stderr), result.stderr


def structs(change):
    """A library whose table of structs is C's, changed."""
    library = taut._library
    table = ctypes.cast(library.library.taut_abi(), ctypes.POINTER(library.AbiTable)).contents
    kept = (library.AbiStruct * table.struct_count)(*(table.structs[i] for i in range(table.struct_count)))
    members = []
    for struct in kept:
        members.append((library.AbiMember * struct.count)(*(struct.members[i] for i in range(struct.count))))
        struct.members = members[-1]
    other = library.AbiTable(table.number, table.pointer_size, table.size_size, table.struct_count, kept)
    change({struct.name: struct for struct in kept}, other)
    return types.SimpleNamespace(_name="other", taut_version=library.library.taut_version, taut_abi=lambda: ctypes.addressof(other), keep=(kept, members, other))


def moved(structs_by_name, _):
    """A member elsewhere."""
    structs_by_name[b"taut_mesh_options"].members[1].offset += 4


def wider(structs_by_name, _):
    """A member of another size."""
    structs_by_name[b"taut_error"].members[0].size = 8


def larger(structs_by_name, _):
    """A struct with room at its end."""
    structs_by_name[b"taut_monitor"].size += 8


def shorter(structs_by_name, _):
    """A member less."""
    structs_by_name[b"taut_basis_spec"].count -= 1


def fewer(_, table):
    """Structs that are not there."""
    table.struct_count = 1


@pytest.mark.parametrize("change", [moved, wider, larger, shorter, fewer])
def test_altered_layout_is_refused(change):
    sizes = dict(taut._library.sizes)
    try:
        taut._library._check(structs(lambda *_: None))
        taut._library.sizes.clear()
        with pytest.raises(taut._library.LibraryError, match="other (lays out taut_|does not know taut_)"):
            taut._library._check(structs(change))
    finally:
        taut._library.sizes.update(sizes)


def test_shows_itself(net):
    page = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))._repr_html_()
    assert "<iframe" in page and "<noscript><img" in page and "stationary" in page


def test_shows_a_picture(net, monkeypatch):
    """Where pages are not shown, in a printed notebook say: PNG as IPython takes it, SVG where there is none, and nothing where neither is."""
    model = taut.dirichlet(net, u=taut.bspline(2, count=5), v=taut.bspline(3, count=6))
    bundle = model._repr_mimebundle_()
    assert set(bundle) == {"text/plain", "text/html", "image/png"}
    assert bundle["text/html"] == model._repr_html_() and bundle["text/plain"] == repr(model)
    assert base64.b64decode(bundle["image/png"], validate=True) == model.to_text("png") and model.to_text("png")[1:4] == b"PNG"
    assert set(model._repr_mimebundle_(include={"image/png"})) == {"image/png"}
    assert set(model._repr_mimebundle_(exclude={"text/html"})) == {"text/plain", "image/png"}
    drawn = taut.Model.to_text

    def without(*kinds):
        def to_text(self, kind, *rest, **options):
            if kind in kinds:
                raise taut.InputError("there is no such module", "", "no-module")
            return drawn(self, kind, *rest, **options)
        monkeypatch.setattr(taut.Model, "to_text", to_text)
    without("png")
    bundle = model._repr_mimebundle_()
    assert set(bundle) == {"text/plain", "text/html", "image/svg+xml"} and bundle["image/svg+xml"].startswith(("<svg", "<?xml"))
    assert "data:image/svg+xml" in bundle["text/html"]
    without("png", "svg")
    assert set(model._repr_mimebundle_()) == {"text/plain", "text/html"}
