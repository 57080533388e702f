"""Taut's workbench. The package taut comes with it, in vendor/, unless there is another."""
import os
import sys

HERE = os.path.dirname(__file__)
try:
    import taut  # noqa: F401
except ImportError:
    sys.path.append(os.path.join(HERE, "vendor"))
    import taut  # noqa: F401
