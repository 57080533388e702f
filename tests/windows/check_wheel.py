"""check_wheel.py WHEEL -- the wheel for Windows: its name, what it carries, and that the library in it exports every function that the
package calls and imports nothing but the system's. There is no Python for Windows here to run it with."""
import ctypes
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SYSTEM = {"kernel32.dll", "msvcrt.dll", "bcrypt.dll", "advapi32.dll", "shell32.dll", "user32.dll"}


def called():
    """What the package calls of the library."""
    text = (ROOT / "python/taut/_library.py").read_text()
    return set(re.findall(r'"(taut_\w+)": "[a-z-]:', text))


def tables(library):
    """Exported names, imported libraries."""
    text = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", str(library)], check=True, capture_output=True, text=True).stdout
    exported = set(re.findall(r"^\s*\[\s*\d+\]\s+(?:\+base\[\s*\d+\]\s+)?(?:[0-9a-f]+ )?(\w+)$", text, re.M))
    return exported, {name.lower() for name in re.findall(r"DLL Name: (\S+)", text)}


def main(wheel):
    """Exits with 1 where something is missing."""
    path = pathlib.Path(wheel)
    wrong = []
    if not path.name.endswith("-py3-none-win_amd64.whl"):
        wrong.append(f"its name is {path.name}")
    with zipfile.ZipFile(path) as archive, tempfile.TemporaryDirectory() as folder:
        names = set(archive.namelist())
        for needed in ("taut/lib/libtaut-0.dll", "taut/lib/libtaut-draw-0.dll", "taut/py.typed", "taut/__init__.py"):
            if needed not in names:
                wrong.append(f"{needed} is missing")
        wrong.extend(f"{name} is of another system" for name in names if re.search(r"\.so(\.\d+)*$", name))
        for name in sorted(names):
            if name.endswith(".dll"):
                exported, imported = tables(archive.extract(name, folder))
                wrong.extend(f"{name} imports {other}" for other in sorted(imported - SYSTEM - {"libtaut-0.dll"}))
                if name.endswith("/libtaut-0.dll"):
                    wrong.extend(f"{name} exports no {function}" for function in sorted(called() - exported))
                    print(f"{len(called() & exported)} functions of {name}")
    sizes = {ctypes.sizeof(ctypes.c_int), ctypes.sizeof(ctypes.c_size_t), ctypes.sizeof(ctypes.c_double)}
    if sizes != {4, 8}:  # what all layouts are of, here and there: no long
        wrong.append(f"numbers of {sizes} bytes")
    if "c_long" in (ROOT / "python/taut/_library.py").read_text():
        wrong.append("a layout has a long, which has 4 bytes there")
    for one in wrong:
        print(f"check_wheel.py: {one}", file=sys.stderr)
    print(f"{path.name}: {'wrong' if wrong else 'ok'}")
    return 1 if wrong else 0


sys.exit(main(sys.argv[1]))
