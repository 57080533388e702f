#!/usr/bin/env python3
"""nets_night.py [TAUT] [NAME ...] -- nets of every kind by --cells 6 on the first surface of each example.

Each either holds, or is refused with a reason (exit 4). Others are named: false with the claims that are, or what the
program said. Fails where one does that KNOWN does not have. A net may take LIMIT seconds.
"""

import json
import os
import subprocess
import sys
import tempfile

NETS = ("asymptotic", "principal", "isoparametric")
LIMIT = 60
# What is known not to hold.
KNOWN = {
    "asymptotic-3": "asymptotic principal",
    "film-cap": "principal",
    "film-sail": "principal",
    "pipe-flat-start": "asymptotic",
    "pipe-legal": "asymptotic",
    "pipe-ones": "asymptotic",
    "pipe-run-closed": "asymptotic",
    "plateau-mast": "principal",
}


def run(arguments, limit):
    try:
        return subprocess.run(arguments, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None


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
        return "slow", "not within %d s" % LIMIT
    if done.returncode in (0, 4):
        return ("holds" if done.returncode == 0 else "refused"), ""
    said = (done.stderr or done.stdout).strip().split("\n")[-1]
    return ("false" if "not all claims" in said else "failed"), said[said.find(": ") + 2 :]


def main():
    taut = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/taut")
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "examples")
    names = sys.argv[2:] or sorted(name[:-5] for name in os.listdir(root) if name.endswith(".json"))
    count = dict.fromkeys(("holds", "refused", "false", "failed", "slow"), 0)
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
                    is_known = net in KNOWN.get(name, "").split()
                    new += not is_known
                    print("%s %s: %s, %s%s" % (name, net, verdict, said, "" if is_known else " (new)"), flush=True)
    print(
        "%d nets, %d hold, %d refused, %d false, %d failed, %d slow"
        % (sum(count.values()), *(count[key] for key in ("holds", "refused", "false", "failed", "slow")))
    )
    return 1 if new else 0


if __name__ == "__main__":
    sys.exit(main())
