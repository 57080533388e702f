"""read_lib3mf.py FILE... -- reads 3MF files with lib3mf, the 3MF Consortium's own reader (Debian: lib3mf1), by its C calls.

Prints "FILE warnings N unit U" and for each object "FILE triangles N vertices N manifold B type T". Exit 77 where there is no lib3mf.
"""

import ctypes
import sys
from ctypes import byref, c_int32, c_uint32, c_void_p

try:
    library = ctypes.CDLL("lib3MF.so.1")
except OSError:
    sys.exit(77)


def call(name, *arguments):
    function = getattr(library, "lib3mf_" + name)
    function.restype = c_int32
    if function(*arguments) != 0:
        sys.exit(f"FAILED: lib3mf_{name}")


def made(name, *arguments):
    pointer = c_void_p()
    call(name, *arguments, byref(pointer))
    return pointer


def number(name, *arguments):
    value = c_uint32()
    call(name, *arguments, byref(value))
    return value.value


for path in sys.argv[1:]:
    model = made("createmodel")
    reader = made("model_queryreader", model, b"3mf")
    call("reader_readfromfileutf8", reader, path.encode())
    print(path, "warnings", number("reader_getwarningcount", reader), "unit", number("model_getunit", model))
    objects = made("model_getmeshobjects", model)
    while number("resourceiterator_movenext", objects):
        mesh = made("resourceiterator_getcurrent", objects)
        print(path, "triangles", number("meshobject_gettrianglecount", mesh), "vertices", number("meshobject_getvertexcount", mesh),
              "manifold", number("meshobject_ismanifoldandoriented", mesh) & 1, "type", number("object_gettype", mesh))
