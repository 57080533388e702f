#!/usr/bin/env python3
"""imports.py OBJDUMP FILE... -- what the program and the library for Windows take from the system: no library but those that
every Windows has, and of its C library nothing that reads, writes or computes numbers, as that rounds otherwise."""
import re
import subprocess
import sys

LIBRARIES = {"ADVAPI32.dll", "KERNEL32.dll", "SHELL32.dll", "msvcrt.dll"}
NUMBERS = re.compile(r"_?(strto[df]|strtold|atof|_?s?n?w?printf\w*|_?vs?n?printf|sscanf|fscanf|scanf|[ef]cvt|gcvt|exp[2m]?1?f?|log\w*|pow|"
                     r"a?(sin|cos|tan)[h2]?f?|hypot|cbrt|fma|sqrt|floor|ceil|round|l?lround|rint|ldexp|frexp|modf|fmod|nextafter)f?l?")
bad = 0
for file in sys.argv[2:]:
    said = subprocess.run([sys.argv[1], "-p", file], capture_output=True, text=True, check=True).stdout
    libraries = set(re.findall(r"DLL Name: (\S+)", said)) - {file.rsplit("/", 1)[-1]}
    imports = said.split("There is an import table", 1)[1].split("There is an export table", 1)[0]
    names = set(re.findall(r"(?m)^\s+[0-9a-f]+\s+\d+\s+(\w+)$", imports))
    foreign = {n for n in names if NUMBERS.fullmatch(n)} - {"_nextafter"}  # exact everywhere
    print(f"{file}: {len(names)} names of {', '.join(sorted(libraries))}")
    if not names or libraries - LIBRARIES or foreign:
        print(f"FAILED {file}: {sorted(libraries - LIBRARIES)} {sorted(foreign)}")
        bad = 1
sys.exit(bad)
