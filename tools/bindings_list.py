#!/usr/bin/env python3
"""bindings_list.py [--update] -- the last section of docs/bindings.md: every function of include/taut, by what a binding has to know.

Without --update it says whether the page has another list, and fails. What is whose is read off the declarations, by the rules
of the page's section on ownership.
"""
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "bindings.md"
HEADING = "## Every function\n"
INTRODUCTION = """
By header, as declared there (`tools/bindings_list.py` makes the list and checks it): what *gives* makes an object or a
text of the caller's; what *lends* returns what lives as long as what it was asked of; what *changes* an object is for
one thread at a time, and what it returns is the object's; what *frees* takes NULL too. What *queries* is
all else: numbers, or arrays and structs of the caller's that are filled; it is safe from any thread.
"""
KINDS = ("gives", "lends", "changes", "queries", "frees")


def kind_of(name, returned, arguments):
    """One of KINDS."""
    if name.endswith("_free"):
        return "frees"
    if re.search(r"(?<!const )\btaut_(model|record|certificate|outputs) \*(?!\*)", arguments):
        return "changes"
    if re.search(r"(?<!const )\b(taut_\w+|char) \*\*", arguments) or re.match(r"taut_\w+ \*", returned):
        return "gives"
    return "lends" if re.match(r"const .*\*", returned) else "queries"


def made():
    """The section."""
    lines = [HEADING, INTRODUCTION]
    for path in sorted((ROOT / "include" / "taut").glob("*.h")):
        text = " ".join(re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S).split())
        found = {kind: [] for kind in KINDS}
        for returned, name, arguments in re.findall(r"TAUT_API ([^;(]*?)\b(taut_\w+)\(([^;]*)\);", text):
            found[kind_of(name, returned.strip(), arguments)].append(f"`{name}`")
        if any(found.values()):
            lines.append(f"\n`taut/{path.name}`\n\n")
        for kind in KINDS:
            if found[kind]:
                lines.append(textwrap.fill(f"{kind}: {', '.join(found[kind])}", 118, initial_indent="- ",
                                           subsequent_indent="  ", break_on_hyphens=False) + "\n")
    return "".join(lines)


def main(arguments):
    """The command line."""
    page = PAGE.read_text()
    wanted = page.split(HEADING)[0].rstrip("\n") + "\n\n" + made()
    if arguments == ["--update"]:
        PAGE.write_text(wanted)
    elif page != wanted:
        print("docs/bindings.md: its list of functions is not what include/taut declares: tools/bindings_list.py --update", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
