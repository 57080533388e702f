#!/usr/bin/env python3
"""interrupt.py COMMAND... -- a program that is interrupted while it writes ends with 130 and leaves nothing."""
import os
import subprocess
import sys
import tempfile

with tempfile.TemporaryDirectory() as folder:
    done = subprocess.run(sys.argv[1:] + ["model.json"], cwd=folder, timeout=170)
    left = os.listdir(folder)
print(f"ended with {done.returncode}, expected 130; left: {left}")
sys.exit(done.returncode != 130 or left != [])
