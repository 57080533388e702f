"""test_bindings.py LIBTAUT -- a small binding in Python's standard library, as docs/bindings.md describes one.

It reads no header: structs are filled by the offsets that taut_abi() tells. The layouts are checked against ctypes, which lays
structs out by rules of its own; surfaces against de Casteljau's algorithm.
"""
import ctypes as c
import json
import struct
import sys
import threading

lib = c.CDLL(sys.argv[1])


class Member(c.Structure):
    _fields_ = [("name", c.c_char_p), ("type", c.c_char_p), ("offset", c.c_size_t), ("size", c.c_size_t)]


class Struct(c.Structure):
    _fields_ = [("name", c.c_char_p), ("size", c.c_size_t), ("count", c.c_size_t), ("members", c.POINTER(Member))]


class Value(c.Structure):
    _fields_ = [("constant", c.c_char_p), ("word", c.c_char_p), ("value", c.c_int)]


class Enum(c.Structure):
    _fields_ = [("name", c.c_char_p), ("size", c.c_size_t), ("count", c.c_size_t), ("values", c.POINTER(Value))]


class Table(c.Structure):
    _fields_ = [("number", c.c_int), ("pointer_size", c.c_int), ("size_size", c.c_size_t), ("struct_count", c.c_size_t),
                ("structs", c.POINTER(Struct)), ("enum_count", c.c_size_t), ("enums", c.POINTER(Enum))]


lib.taut_abi.restype = c.POINTER(Table)
lib.taut_abi_record.restype = lib.taut_model_surface.restype = lib.taut_surface_u.restype = c.c_void_p
lib.taut_model_certificate.restype = lib.taut_model_details.restype = c.c_void_p
lib.taut_problem_text.restype = lib.taut_enum_name.restype = lib.taut_version.restype = c.c_char_p
lib.taut_surface_points.restype = c.POINTER(c.c_double)
table = lib.taut_abi().contents
LAYOUT = {s.name.decode(): s for s in table.structs[:table.struct_count]}
ENUMS = {e.name.decode(): {v.word.decode(): v.value for v in e.values[:e.count]} for e in table.enums[:table.enum_count]}
STATUS = ENUMS["taut_status"]
CODES = {"int": "i", "double": "d", "int64_t": "q", "size_t": "N"}


def members(name):
    """{member: (type, offset, size)}"""
    return {m.name.decode(): (m.type.decode(), m.offset, m.size) for m in LAYOUT[name].members[:LAYOUT[name].count]}


class Plain:
    """A public struct as bytes, its members by the table."""

    def __init__(self, name, **values):
        self.members, self.kept = members(name), []
        self.bytes = c.create_string_buffer(LAYOUT[name].size)
        for member, value in values.items():
            self[member] = value

    def __setitem__(self, member, value):
        kind, offset, size = self.members[member]
        self.kept.append(value)  # what is pointed at must live as long
        if "*" in kind:
            value = c.cast(value, c.c_void_p).value or 0
            struct.pack_into("P", self.bytes, offset, value)
        elif kind in CODES:
            struct.pack_into(CODES[kind], self.bytes, offset, value)
        else:  # a struct inside
            assert len(value.bytes) == size
            self.bytes[offset:offset + size] = value.bytes.raw

    def __getitem__(self, member):
        kind, offset, size = self.members[member]
        raw = self.bytes.raw[offset:offset + size]
        if kind.startswith("char["):
            return raw.split(b"\0")[0].decode()
        return struct.unpack(CODES.get(kind, "i"), raw)[0]


class Failure(Exception):
    """A taut_error."""

    def __init__(self, error):
        super().__init__(error["message"])
        self.status, self.reason, self.where, self.limit = (error[m] for m in ("status", "reason", "where", "limit"))


def call(function, *arguments):
    """Calls a function whose last argument is an error."""
    error = Plain("taut_error")
    if function(*arguments, error.bytes) != STATUS["ok"]:
        raise Failure(error)


def problem_of(document):
    """A problem of a document in memory."""
    text, problem = json.dumps(document).encode(), c.c_void_p()
    call(lib.taut_problem_read_text, text, c.c_size_t(len(text)), b"document", c.byref(problem))
    return problem


def made_of(problem, options=None):
    """The model of a problem."""
    model = c.c_void_p()
    call(lib.taut_make, problem, options.bytes if options else None, c.byref(model))
    return model


def text_of(model):
    """The model's JSON, bytes."""
    text, length = c.c_char_p(), c.c_size_t()
    call(lib.taut_model_write_text, model, b"json", None, c.byref(text), c.byref(length))
    found = c.string_at(text, length.value)
    lib.taut_text_free(text)
    return found


def doubles(values):
    """double[len(values)]"""
    return (c.c_double * len(values))(*values)


def bezier(points, t):
    """De Casteljau, of points or of rows of them."""
    points = [list(p) for p in points]
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


# ---- the table ----

record = c.c_void_p(lib.taut_abi_record())
text, length = c.c_char_p(), c.c_size_t()
assert lib.taut_record_write(record, c.byref(text), c.byref(length)) == 0
told = json.loads(c.string_at(text, length.value))
lib.taut_text_free(text)
lib.taut_record_free(record)
assert told["number"] == table.number and told["pointer_size"] == c.sizeof(c.c_void_p)
assert {n: s["size"] for n, s in told["structs"].items()} == {n: s.size for n, s in LAYOUT.items()}
assert {n: {v["word"]: v["value"] for v in e["values"]} for n, e in told["enums"].items()} == ENUMS

# ctypes lays the same members out by itself; members of unions stand one over the other, which a row in order cannot.
BASIC = {"int": c.c_int, "double": c.c_double, "int64_t": c.c_int64, "size_t": c.c_size_t, "char": c.c_char, "unsigned char": c.c_ubyte}
made = {}


def ctype_of(kind):
    """The type of a member as ctypes has it; any pointer is one to anything."""
    if "*" in kind:
        inner = c.c_void_p
    else:
        base = kind.split("[")[0]
        inner = BASIC.get(base) or (c.c_int if base in ENUMS else structure(base))
    for size in reversed(kind.split("[")[1:]) if "(" not in kind else []:
        inner = inner * int(size.rstrip("]"))
    return inner


def structure(name):
    """The struct laid out by ctypes."""
    if name not in made:
        made[name] = type(name, (c.Structure,), {"_fields_": [(m, ctype_of(k)) for m, (k, _, _) in members(name).items()]})
    return made[name]


has_union = set()
for name in LAYOUT:
    spans = [(offset, offset + size) for _, offset, size in members(name).values()]
    if any(b[0] < a[1] for a, b in zip(spans, spans[1:])):
        has_union.add(name)


def is_plain(name):
    """Without unions, nor structs that have some."""
    return name not in has_union and all(k.split("[")[0] not in LAYOUT or is_plain(k.split("[")[0])
                                         for k, _, _ in members(name).values())


checked = 0
for name in filter(is_plain, LAYOUT):
    ours = structure(name)
    assert c.sizeof(ours) == LAYOUT[name].size, name
    for member, (_, offset, size) in members(name).items():
        assert (getattr(ours, member).offset, getattr(ours, member).size) == (offset, size), f"{name}.{member}"
        checked += 1
assert checked > 150 and "taut_pipe_section" in has_union, checked
assert lib.taut_enum_name(b"taut_status", STATUS["no-solution"]) == b"no-solution"

# ---- a document in memory, made, proved, written, read back ----

net = [[[0, 0, 0], [0, 1, 0.5], [0, 2, 0]], [[1, 0, 1], None, [1, 2, 1]], [[2, 0, 0], [2, 1, -0.25], [2, 2, 3]]]
document = {"taut": 1, "construct": "dirichlet", "u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 2},
            "points": net}
problem = problem_of(document)
assert json.loads(lib.taut_problem_text(problem, None)) == document
model = made_of(problem)
certificate = c.c_void_p()
call(lib.taut_certify, model, problem, None, c.byref(certificate))
assert lib.taut_certificate_holds(certificate) == ENUMS["taut_verdict"]["true"]
lib.taut_model_set_certificate(model, certificate)  # the model's now
written = text_of(model)
again = c.c_void_p()
call(lib.taut_model_read_text, written, c.c_size_t(len(written)), b"model", c.byref(again))
assert text_of(again) == written
copy = c.c_void_p()
assert lib.taut_model_copy(model, c.byref(copy)) == 0 and text_of(copy) == written
lib.taut_model_free(copy)
lib.taut_model_free(again)

# ---- places in no order: points, derivatives, normals ----

surface = c.c_void_p(lib.taut_model_surface(model, 0))
flat = lib.taut_surface_points(surface)
points = [[[flat[9 * i + 3 * j + k] for k in range(3)] for j in range(3)] for i in range(3)]
u, v = [0.0, 1.0, 0.25, 0.7, 0.7], [1.0, 0.0, 0.5, 0.3, 0.9]
values = doubles([0] * len(u) * 9)
assert lib.taut_surface_eval_points(surface, len(u), doubles(u), doubles(v), 1, 1, values) == 0
for i, (s, t) in enumerate(zip(u, v)):
    rows = [bezier(row, t) for row in points]
    x = bezier(rows, s)
    xu = [2 * d for d in bezier([[b - a for a, b in zip(p, q)] for p, q in zip(rows, rows[1:])], s)]
    assert all(abs(a - b) < 1e-14 for a, b in zip(x + xu, values[9 * i:9 * i + 6])), (s, t)
forms = c.create_string_buffer(LAYOUT["taut_forms"].size * len(u))
assert lib.taut_surface_forms_points(surface, len(u), doubles(u), doubles(v), 1, forms) == 0
for i in range(len(u)):
    at = i * LAYOUT["taut_forms"].size + members("taut_forms")["normal"][1]
    normal = struct.unpack_from("3d", forms, at)
    xu, xv = values[9 * i + 3:9 * i + 6], values[9 * i + 6:9 * i + 9]
    cross = [xu[1] * xv[2] - xu[2] * xv[1], xu[2] * xv[0] - xu[0] * xv[2], xu[0] * xv[1] - xu[1] * xv[0]]
    size = sum(x * x for x in cross) ** 0.5
    assert all(abs(a / size - b) < 1e-13 for a, b in zip(cross, normal)), i
assert lib.taut_surface_eval_points(surface, 1, doubles([1.5]), doubles([0]), 0, 1, values) == STATUS["bad-argument"]

# ---- one surface, several threads at once: ctypes lets go of Python's lock in each call ----

many = 20000
places = [doubles([(7 * i % 101) / 101 for i in range(many)]), doubles([(13 * i % 97) / 97 for i in range(many)])]
found = [doubles([0] * many * 18) for _ in range(4)]
threads = [threading.Thread(target=lib.taut_surface_eval_points, args=(surface, many, *places, 2, 1, f)) for f in found]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert all(bytes(f) == bytes(found[0]) for f in found) and any(found[0])

# ---- another value in one place; refusals as data ----

moved = c.c_void_p()
call(lib.taut_problem_change, problem, b"/points/2/2", b"[2, 2, 0]", c.c_size_t(9), c.byref(moved))
assert json.loads(lib.taut_problem_text(moved, None))["points"][2][2] == [2, 2, 0]
try:
    call(lib.taut_problem_change, problem, b"/points/2/2/1", b"\"x\"", c.c_size_t(3), c.byref(moved))
    raise SystemExit("a text was taken for a number")
except Failure as refused:
    assert (refused.status, refused.reason, refused.where) == (STATUS["bad-input"], "value", "/points/2/2/1"), refused
lib.taut_problem_free(moved)

# ---- arrays in, without a document: the struct by its offsets; the same bytes ----

spec, basis, direct = Plain("taut_basis_spec", type=c.c_char_p(b"bezier"), degree=2), c.c_void_p(), c.c_void_p()
call(lib.taut_basis_new, spec.bytes, 3, c.byref(basis))
flat_net = doubles([x for row in net for p in row for x in (p or [float("nan")] * 3)])
known = (c.c_ubyte * 9)(*[p is not None for row in net for p in row])
data = Plain("taut_dirichlet_problem", u=basis, v=basis, points=flat_net, known=known)
call(lib.taut_dirichlet_make, data.bytes, None, c.byref(direct))
lib.taut_model_set_certificate(model, None)
assert text_of(direct) == text_of(model)
lib.taut_model_free(direct)
lib.taut_basis_free(basis)

# ---- a monitor in Python: enough, and stop ----

calls = []
PROGRESS = c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_double, c.c_char_p)
film = problem_of({"taut": 1, "construct": "plateau", "u": {"type": "bspline", "degree": 3, "count": 6},
                   "v": {"type": "bspline", "degree": 3, "count": 6},
                   "points": [[[i, j, (i % 5 == 0) * (j % 5 == 0) * (i == j) * 2] if i in (0, 5) or j in (0, 5) else None
                               for j in range(6)] for i in range(6)]})
constants = ENUMS[""]
for answer, expected in ((constants["TAUT_GO_ON"], None), (constants["TAUT_ENOUGH"], "request"),
                         (constants["TAUT_STOP"], STATUS["interrupted"])):
    calls.clear()

    @PROGRESS
    def progress(_context, _done, what):
        calls.append(what)
        return answer if len(calls) >= 3 else 0

    options = Plain("taut_make_options", threads=1, monitor=Plain("taut_monitor", progress=progress))
    try:
        ended = made_of(film, options)
        assert json.loads(text_of(ended))["details"].get("stopped") == expected, answer
        assert (len(calls) == 3) == (answer != 0)
        lib.taut_model_free(ended)
    except Failure as stopped:
        assert stopped.status == expected and len(calls) == 3, stopped
options = Plain("taut_make_options", time_limit=1e-9)
try:
    made_of(film, options)
    raise SystemExit("no time was enough")
except Failure as late:
    assert (late.status, late.reason, late.limit) == (STATUS["not-converged"], "time", 1e-9), late

for thing in (problem, film):
    lib.taut_problem_free(thing)
lib.taut_model_free(model)
print(f"{checked} members of {len(LAYOUT)} structs as ctypes has them, taut {lib.taut_version().decode()}")
