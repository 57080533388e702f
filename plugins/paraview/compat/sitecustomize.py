"""ParaView 5.11 asks Python for a function that Python 3.11 no longer has, and loads no plug-in in Python: with this folder in PYTHONPATH
it does."""
import inspect

if not hasattr(inspect, "getargspec"):
    inspect.getargspec = inspect.getfullargspec
