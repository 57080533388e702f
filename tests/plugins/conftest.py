"""Hosts of plug-ins: each test runs a script in one, which prints RESULT and JSON; a host that is missing is said, with how to get it."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("TAUT_BUILD", ROOT / "build/release"))
HERE = pathlib.Path(__file__).parent
os.environ.setdefault("TAUT_LIBRARY", str(BUILD / "libtaut.so.0"))
sys.path.insert(0, str(ROOT / "python"))

COMMANDS = {
    "freecadcmd": ["freecadcmd", "{script}"],
    "blender": ["blender", "-b", "--factory-startup", "--python-use-system-env", "--python-exit-code", "1", "--python", "{script}"],
    "blender-window": ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "blender", "--factory-startup", "--python-use-system-env",
                       "--enable-event-simulate", "--window-geometry", "0", "0", "1280", "800", "--python", "{script}"],
    "freecad": ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "freecad", "{script}"],
    "pvpython": ["pvpython", "--force-offscreen-rendering", "{script}"],
}


@pytest.fixture
def run_in(tmp_path):
    """run_in(host, script, folder of the plug-in, **what the script reads in TAUT_TEST): what it printed as JSON."""

    def run(host, script, plugin, **given):
        for needed in (host.split("-")[0], COMMANDS[host][0]):
            if shutil.which(needed) is None:
                pytest.skip(f"there is no {needed} here: tools/deps.sh hosts")
        environment = dict(os.environ, PYTHONPATH=f"{ROOT / 'python'}:{ROOT / 'plugins' / plugin}:{ROOT / 'plugins' / plugin / 'compat'}:{HERE}", TAUT_TEST=json.dumps({**given, "folder": str(tmp_path)}),
                           HOME=str(tmp_path), LIBGL_ALWAYS_SOFTWARE="1", QTWEBENGINE_DISABLE_SANDBOX="1", PYTHONDONTWRITEBYTECODE="1")
        # a session of its own: with the host end the programs that it or xvfb-run started, too
        process = subprocess.Popen([word.format(script=HERE / script) for word in COMMANDS[host]], env=environment, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL, cwd=tmp_path, start_new_session=True)
        try:
            out, said = process.communicate(timeout=200)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, said = process.communicate()
        lines = [line for line in out.splitlines() if "RESULT " in line]
        assert lines, f"{host} ended with {process.returncode}:\n{out[-4000:]}\n{said[-4000:]}"
        return json.loads(lines[-1].split("RESULT ", 1)[1])

    return run


@pytest.fixture
def make(tmp_path):
    """make(problem): the model that the program makes."""
    import taut

    def run(problem):
        path = tmp_path / "problem.json"
        path.write_text(json.dumps({"taut": 1, **problem}))
        done = subprocess.run([str(BUILD / "bin/taut"), "make", str(path)], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return taut.Model.from_json(done.stdout)

    return run
