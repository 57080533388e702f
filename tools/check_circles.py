#!/usr/bin/env python3
"""check_circles.py [ROOT] -- refuses circles between source files.

File A stands on file B where A uses a name (a function or an object) that B defines. The tables that the three lists
name (basis_list.h, construct_list.h, format_list.h) are left out: what is registered may use what registers it.
Prints every set of files that stand on each other, with the names that close the circle, and fails.
"""
import os
import re
import sys

REGISTERED = re.compile(r"^taut_(basis|construct|certify|document|format|change)_[a-z0-9_]+$")
DEFINITION = re.compile(r"^(?!static\b|typedef\b|extern\b|return\b|else\b|#)[A-Za-z_][\w \t*]*?\b((?:taut|cli)_\w+)\s*([(=\[;])", re.M)
NAME = re.compile(r"\b(?:taut|cli)_\w+")


def plain(text):
    """The text without comments and strings."""
    return re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"', " ", text, flags=re.S)


def sources(root):
    for folder in ("src", "cad"):
        for path, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                if name.endswith((".c", ".cpp")):
                    yield os.path.relpath(os.path.join(path, name), root)


def defined(text):
    """Names that are defined at the left margin: functions with a body, objects with a value."""
    names = set()
    for match in DEFINITION.finditer(text):
        name, mark = match.group(1), match.group(2)
        if mark == "(":
            depth, i = 1, match.end()
            while i < len(text) and depth > 0:
                depth += {"(": 1, ")": -1}.get(text[i], 0)
                i += 1
            if not text[i:].lstrip().startswith("{"):
                continue  # a declaration
        names.add(name)
    return names


def circles(edges):
    """Strongly connected sets of more than one file, by Tarjan's algorithm without recursion."""
    index, low, on_stack, stack, found = {}, {}, set(), [], []
    for start in sorted(edges):
        if start in index:
            continue
        work = [(start, iter(sorted(edges[start])))]
        index[start] = low[start] = len(index)
        stack.append(start)
        on_stack.add(start)
        while work:
            node, rest = work[-1]
            for other in rest:
                if other not in index:
                    index[other] = low[other] = len(index)
                    stack.append(other)
                    on_stack.add(other)
                    work.append((other, iter(sorted(edges[other]))))
                    break
                if other in on_stack:
                    low[node] = min(low[node], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    group = []
                    while True:
                        other = stack.pop()
                        on_stack.discard(other)
                        group.append(other)
                        if other == node:
                            break
                    if len(group) > 1:
                        found.append(sorted(group))
    return found


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    texts = {}
    for path in sorted(sources(root)):
        with open(os.path.join(root, path), encoding="utf-8") as file:
            texts[path] = plain(file.read())
    owners = {}
    for path, text in texts.items():
        for name in defined(text):
            if not REGISTERED.match(name):
                owners.setdefault(name, set()).add(path)
    uses = {path: {} for path in texts}
    for path, text in texts.items():
        for name in set(NAME.findall(text)):
            for owner in owners.get(name, ()):
                if owner != path and path not in owners[name]:
                    uses[path].setdefault(owner, set()).add(name)
    found = circles({path: set(used) for path, used in uses.items()})
    for group in found:
        print("a circle of %d files:" % len(group))
        for path in group:
            for other in group:
                if other in uses[path]:
                    print("  %s stands on %s: %s" % (path, other, ", ".join(sorted(uses[path][other]))))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
