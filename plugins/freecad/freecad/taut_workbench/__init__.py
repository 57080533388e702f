"""Taut's workbench. The package taut comes with it, in vendor/, unless there is another."""
import os
import sys

HERE = os.path.dirname(__file__)
try:
    import taut  # noqa: F401
except ImportError:
    sys.path.append(os.path.join(HERE, "vendor"))
    try:
        import taut  # noqa: F401
    except ImportError as error:
        raise ImportError(f"the workbench Taut finds no package taut ({error}): install taut-freecad.zip, which `make plugins` writes and which "
                          "has it in it, or a wheel of taut for the Python of FreeCAD") from None
