#!/usr/bin/env python3
"""start_wine.py WINE -- makes wine's folder (WINEPREFIX) and leaves its server running for two minutes more than it is used, so
that not every test starts a Windows of its own."""
import os
import subprocess
import sys

wine = sys.argv[1]
server = next((p for n in ("wineserver64", "wineserver") if os.path.exists(p := os.path.join(os.path.dirname(wine), n))), "wineserver")
# without the folder no server stays, and the next program's would keep that program's output open for as long as tests run
os.makedirs(os.environ["WINEPREFIX"], exist_ok=True)
# the server, which stays, must not keep our own output open
quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
subprocess.run([server, "-p120"], **quiet, timeout=60)
sys.exit(subprocess.run([wine, "cmd", "/c", "exit 0"], **quiet, timeout=170).returncode)
