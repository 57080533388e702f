#!/usr/bin/env python3
"""nets_night.py [TAUT] [NAME ...] -- nets of every kind by --cells 6 on the first surface of each example.

Each either holds, or is refused with a reason: exit 4, or `stalled` (exit 1) with the place. Others are named, and the
stalled: false with the claims that are, or what the program said. Fails where one is false, failed or slow, or stalled
and not in STALLED. A net may take LIMIT seconds of a processor.
"""

import json
import os
import resource
import signal
import subprocess
import sys
import tempfile

NETS = ("asymptotic", "principal", "isoparametric")
LIMIT = 60
COUNTED = ("holds", "refused", "stalled", "false", "failed", "slow")
# What is known to stall.
STALLED = {
    "asymptotic-3": "principal",
    "film-cap": "principal",
    "pipe-flat-start": "asymptotic",
    "pipe-legal": "asymptotic",
    "pipe-ones": "asymptotic",
    "plateau-mast": "principal",
}


def run(arguments, limit):
    """What came of a command, or None: it takes longer, however much else the machine has to do."""

    def hold():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    try:
        done = subprocess.run(arguments, capture_output=True, text=True, timeout=20 * limit, preexec_fn=hold)
    except subprocess.TimeoutExpired:
        return None
    return None if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else done


def surfaces_of(path):
    try:
        with open(path, encoding="utf-8") as file:
            return [surface.get("name") for surface in json.load(file).get("surfaces", [])]
    except (OSError, ValueError):
        return []


def net_of(taut, model, names, net, folder):
    arguments = [taut, "trace", model, "--net", net, "--cells", "6", "--quiet", "-o", os.path.join(folder, "net.json")]
    if len(names) > 1:
        arguments += ["--surface", names[0]]
    done = run(arguments, LIMIT)
    if done is None:
        return "slow", "not within %d s of a processor" % LIMIT
    if done.returncode in (0, 4):
        return ("holds" if done.returncode == 0 else "refused"), ""
    said = (done.stderr or done.stdout).strip().split("\n")[-1]
    verdict = "false" if "not all claims" in said else "stalled" if "help stalled" in said else "failed"
    return verdict, said[said.find(": ") + 2 :]


def main():
    taut = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/taut")
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "examples")
    names = sys.argv[2:] or sorted(name[:-5] for name in os.listdir(root) if name.endswith(".json"))
    count = dict.fromkeys(COUNTED, 0)
    new = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            model = os.path.join(folder, name + ".json")
            if name.startswith(("trace", "pattern")):
                continue
            run([taut, "make", os.path.join(root, name + ".json"), "--quiet", "-o", model], 10 * LIMIT)
            surfaces = surfaces_of(model)
            for net in NETS if surfaces else ():
                verdict, said = net_of(taut, model, surfaces, net, folder)
                count[verdict] += 1
                if verdict not in ("holds", "refused"):
                    is_known = verdict == "stalled" and net in STALLED.get(name, "").split()
                    new += not is_known
                    print("%s %s: %s, %s%s" % (name, net, verdict, said, "" if is_known else " (new)"), flush=True)
    print(
        "%d nets, %d hold, %d refused, %d stalled, %d false, %d failed, %d slow"
        % (sum(count.values()), *(count[key] for key in COUNTED))
    )
    return 1 if new else 0


if __name__ == "__main__":
    sys.exit(main())
