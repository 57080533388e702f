#!/usr/bin/env python3
"""check_reasons.py [ROOT] -- the words that errors give are what the lists say.

Each word that code gives (an argument that its function names `reason`, or what a variable or member of that name is
set to) stands in a list that its room may use; each word of a list is given somewhere; and each has its row in the
page: docs/<name>.md for a construction, a section of docs/errors.md for all others. Prints what is not so and fails.
"""
import glob
import os
import re
import sys

# The lists that all rooms of the layer share, by header, and their sections in docs/errors.md.
SECTIONS = {
    "status": "Any call",
    "basis": "Bases",
    "surface": "Surfaces, curves and models",
    "construct": "Certificates",
    "read": "Documents",
    "write": "Files",
    "cli": "The command line",
}
MAY_USE = {  # folder of src, or cad: lists besides that of status.h
    "basis": "basis read",
    "geometry": "basis surface read",
    "measure": "basis surface read",
    "mesh": "basis surface read",
    "shell": "basis surface read",
    "trace": "basis surface read trace",
    "construct": "basis surface read",
    "certify": "basis surface read construct",
    "io": "basis surface read write",
    "draw": "surface write",
    "page": "surface write",
    "cad": "surface write",
    "cli": "basis surface read write cli",
}
BESIDES = {"plateau": "dirichlet"}  # a construction that begins with another
PAGES = {"panels": "bonnet"}  # a construction that stands on another's page

STRING = r'"(?:\\.|[^"\\])*"'
LIST = re.compile(r"#define ((?:TAUT|CLI)_(?:[A-Z]+_)?REASON_LIST)\(X\)((?:.*\\\n)*.*)")
ROW = re.compile(r'\bX\(\s*"([^"]*)"\s*,\s*(?:%s\s*)+,\s*(?:%s\s*)+\)' % (STRING, STRING))
WORD = re.compile(r"[a-z][a-z0-9-]{0,30}$")
TAKES = re.compile(r"\b(\w+)\(([^()]*\bconst char \*reason\b[^()]*)\)")
REPORTED = re.compile(r"\| *`([a-z0-9-]+)`(?:, (?:exit )?| \| )\d")  # a reason and its exit code
SET = re.compile(r"\breason *=(?!=)([^;{}]*?)(?:;|,\s*\.|\})")


def read(path):
    """A file, without comments where it is code: the lines stay where they are."""
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if path.endswith(".md"):
        return text
    return re.sub(r"%s|'\\?.'|/\*.*?\*/" % STRING,
                  lambda m: re.sub(r"[^\n]", " ", m.group(0)) if m.group(0)[0] == "/" else m.group(0), text, flags=re.S)


def arguments(text, start):
    """The arguments of the call whose parenthesis opens before `start`."""
    found, depth, begin = [], 0, start
    for match in re.compile(r"%s|'\\?.'|[()\[\]{},]" % STRING).finditer(text, start):
        mark = match.group(0)
        if mark in ("(", "[", "{"):
            depth += 1
        elif mark in (")", "]", "}"):
            depth -= 1
        if depth < 0 or (mark == "," and depth == 0):
            found.append(text[begin:match.start()])
            begin = match.end()
        if depth < 0:
            break
    return found


def words_of(text):
    return [word[1:-1] for word in re.findall(STRING, text) if word != '""']


def lists_of_headers(wrong):
    """Name of the header -> {word}, of all that have a list."""
    lists = {}
    for header in sorted(glob.glob("include/taut/*.h")) + ["src/cli/cli.h"]:
        for match in LIST.finditer(read(header)):
            body = match.group(2).replace("\\\n", "\n")
            words = ROW.findall(body)
            if not words or len(re.findall(r"\bX\(", body)) != len(words):
                wrong.append("%s: %s cannot be read" % (header, match.group(1)))
            wrong += ['%s: %s names "%s" twice' % (header, match.group(1), w)
                      for w in sorted(set(words)) if words.count(w) > 1]
            wrong += ['%s: "%s" is no word of a-z, 0-9 and -' % (header, w) for w in words if not WORD.match(w)]
            lists.setdefault(os.path.basename(header)[:-2], set()).update(words)
    return lists


def lists_of_room(path, constructions):
    """Names of the lists that a source may use."""
    part = path.split("/")
    layer = part[1] if part[0] == "src" else part[0]
    names = ["status", *MAY_USE.get(layer, "").split()]
    if layer == "problem":  # what a problem means, problem/film_complex.c
        own = os.path.basename(path).split(".")[0].split("_")[0]
        return ["status", own] if own in constructions else ["status"]
    if layer in ("construct", "certify", "io"):
        own = part[2]
        if layer == "io":  # the longest name that the file's begins with: harmonic_extension.c is harmonic's
            stem = part[-1].split(".")[0]
            begins = [name for name in constructions if (stem + "_").startswith(name + "_")]
            own = max(begins, key=len, default=stem) if part[2] == "problem" else ""
        names += [own] if own in constructions else constructions if own != "" and layer != "io" else []
        names += BESIDES.get(own, "").split()
    return names


def main():
    os.chdir(sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    wrong = []
    lists = lists_of_headers(wrong)
    constructions = sorted(name for name in lists if name not in SECTIONS)
    shared = [name for name in SECTIONS if name in lists and name != "cli"]
    for i, name in enumerate(shared):  # a construction may tell more of a shared word on its own page
        for other in shared[:i]:
            twice = sorted(lists[name] & lists[other])
            if twice:
                wrong.append("the lists of %s and %s both have %s" % (other, name, ", ".join(twice)))
    for name in sorted(os.listdir("src/construct")) if os.path.isdir("src/construct") else []:
        if os.path.exists("include/taut/%s.h" % name) and name not in constructions:
            wrong.append("include/taut/%s.h lists no reasons" % name)

    paths = sorted(glob.glob("src/**/*.[ch]", recursive=True) + glob.glob("cad/*.[ch]pp"))
    texts = {path: read(path) for path in paths}
    takes = {}  # function that is given a reason: which argument it is
    for text in texts.values():
        for match in TAKES.finditer(text):
            names = [argument.split("*")[-1].strip() for argument in arguments(text, match.start(2))]
            takes[match.group(1)] = names.index("reason")
    call = re.compile(r"\b(%s)\(" % "|".join(sorted(takes) or ["(?!)"]))
    given = {name: set() for name in lists}
    for path, text in texts.items():
        said = [(match.start(), match.group(1)) for match in SET.finditer(text)]
        for match in call.finditer(text):
            said.append((match.start(), (arguments(text, match.end()) + [""] * 9)[takes[match.group(1)]]))
        may_use = [name for name in lists_of_room(path, constructions) if name in lists]
        for place, what in said:
            for word in words_of(what):
                known = [name for name in may_use if word in lists[name]]
                # what all rooms share speaks for the constructions that repeat its word
                all_know = constructions if not set(may_use) & set(constructions) else []
                for name in known + [name for name in all_know if word in lists[name]]:
                    given[name].add(word)
                if not known:
                    wrong.append('%s:%d: "%s" stands in no list that this room may use' %
                                 (path, text.count("\n", 0, place) + 1, word))
    for name in sorted(lists):
        unused = sorted(lists[name] - given[name])
        if unused:
            wrong.append("the list of %s has words that nothing gives: %s" % (name, ", ".join(unused)))
        page = "docs/errors.md" if name in SECTIONS else "docs/%s.md" % PAGES.get(name, name)
        section = SECTIONS.get(name, "What can go wrong")
        text = re.search(r"^## %s\n(.*?)(?=^## |\Z)" % re.escape(section), read(page), flags=re.M | re.S)
        rows = set(REPORTED.findall(text.group(1))) if text else set()
        of_page = lists[name].union(*[lists[other] for other in lists if PAGES.get(other) == name])
        lost, strange = sorted(lists[name] - rows), sorted(rows - of_page)
        if lost:
            wrong.append('%s, "%s": no row for %s' % (page, section, ", ".join(lost)))
        if strange and name not in PAGES:
            wrong.append('%s, "%s": no reason is called %s' % (page, section, ", ".join(strange)))
    print("\n".join(wrong) if wrong else "%d words in %d lists" % (sum(map(len, lists.values())), len(lists)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
