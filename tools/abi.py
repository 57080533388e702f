#!/usr/bin/env python3
"""abi.py [--update] [ROOT] -- src/core/abi_list.h names every struct, member and constant of include/taut, for taut_abi().

Without --update it says what differs, and fails. The compiler puts sizes, offsets and values in: here are only names and the
types as they are written. The headers are read as they are laid out (docs/decisions), not as C in general: what this does not
understand is an error, never left out.
"""
import pathlib
import re
import sys

TARGET = "src/core/abi_list.h"
# Words that do not follow from the constants' names; those of documents.
WORDS = {
    "TAUT_PIPE_SHAPE_GIVEN": "given",
    "TAUT_BIDEGREE_5N_MINUS_7": "5n-7",
    "TAUT_BIDEGREE_N_PLUS_3": "n+3",
}


class Wrong(Exception):
    """What cannot be read."""


def plain(text):
    """A header without comments and preprocessor lines; lists of X(...) apart."""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r"\\\n", " ", text)
    return "\n".join(line for line in text.split("\n") if not line.lstrip().startswith("#"))


def block(text, at):
    """The text between the brace at `at` and its partner, and where that ends."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return text[at + 1:i], i + 1
    raise Wrong("a brace is not closed")


def members(struct, body):
    """(name, type) of each member, those of unions without a name in their place."""
    found, at = [], 0
    while at < len(body):
        rest = body[at:]
        union = re.match(r"\s*union\s*(?=\{)", rest)
        if union:
            inside, end = block(body, at + union.end())
            found += members(struct, inside)
            close = re.match(r"\s*;", body[end:])
            if not close:
                raise Wrong(f"{struct}: a union with a name")
            at = end + close.end()
            continue
        semicolon = rest.find(";")
        if semicolon < 0:
            break
        found += declared(struct, " ".join(rest[:semicolon].split()))
        at += semicolon + 1
    if body[at:].strip():
        raise Wrong(f"{struct}: {body[at:].strip()}")
    return found


def declared(struct, text):
    """(name, type) of `const double *a, b[2]`."""
    function = re.fullmatch(r"(.*?)\(\*(\w+)\)\((.*)\)", text)
    if function:
        return [(function[2], f"{function[1].strip()} (*)({function[3]})")]
    first = re.fullmatch(r"((?:const )?(?:unsigned )?\w+)((?: ?\*(?:const\b)?)* ?)(\w+(?:\[\w+\])*)((?:,.*)?)", text)
    if not first:
        raise Wrong(f"{struct}: {text}")
    found = []
    for declarator in [first[2] + first[3], *first[4].split(",")[1:]]:
        parts = re.fullmatch(r"\s*((?:\*(?:const\b)? ?)*)(\w+)((?:\[\w+\])*)", declarator)
        if not parts:
            raise Wrong(f"{struct}: {declarator}")
        stars = parts[1].strip()
        found.append((parts[2], first[1] + (" " + stars if stars else "") + parts[3]))
    return found


def constants(name, body):
    """The constants of an enumeration; those of statuses come from their list."""
    found = []
    for item in body.split(","):
        if item.strip():
            constant = re.match(r"\s*(TAUT_\w+)\s*(=|$)", item)
            if not constant:
                raise Wrong(f"{name}: {item}")
            found.append(constant[1])
    return found


def words(found):
    """Constants without what their names have in common: TAUT_EDGE_U0, TAUT_EDGE_U1 are u0, u1."""
    parts = [constant.split("_") for constant in found]
    common = 0
    while all(len(p) > common + 1 and p[common] == parts[0][common] for p in parts):
        common += 1
    return [WORDS.get(c, "-".join(p[common:]).lower()) for c, p in zip(found, parts)]


def read(root):
    """Structs and enumerations by name, and the constants of none."""
    structs, enums, loose = {}, {}, []
    for path in sorted((root / "include" / "taut").glob("*.h")):
        raw = path.read_text()
        text = plain(raw)
        loose += re.findall(r"^#define (TAUT_[A-Z0-9_]+) +[0-9]+(?= |$)", raw, flags=re.M)
        for found in re.finditer(r"typedef struct (\w+) (?=\{)", text):
            structs[found[1]] = members(found[1], block(text, found.end())[0])
        for found in re.finditer(r"(?<!\w)(typedef )?enum (\w+ )?(?=\{)", text):
            name, body = found[2], block(text, found.end())[0]
            if name is None:
                loose += constants(path.name, body)
            elif "TAUT_STATUS_LIST" in body:
                enums[name.strip()] = re.findall(r"X\((TAUT_\w+), \d+,", raw)
            else:
                enums[name.strip()] = constants(name, body)
    return structs, enums, loose


def table(root):
    """The list as a C header."""
    structs, enums, loose = read(root)
    lines = ["/* abi_list.h -- every public struct with its members, every enumeration with its constants. Made by",
             " * tools/abi.py --update of include/taut; do not edit. */",
             "#ifndef TAUT_CORE_ABI_LIST_H", "#define TAUT_CORE_ABI_LIST_H", "", "/* clang-format off */", ""]

    def listed(macro, rows):
        lines.extend(" \\\n    ".join([f"#define {macro}", *rows]).split("\n") + [""])

    for name in sorted(structs):
        listed(f"TAUT_ABI_MEMBERS_{name}(X)", [f'X({name}, {m}, "{t}")' for m, t in structs[name]])
    listed("TAUT_ABI_STRUCT_LIST(X)", [f"X({name})" for name in sorted(structs)])
    for name in sorted(enums):
        listed(f"TAUT_ABI_VALUES_{name}(X)", [f'X({c}, "{w}")' for c, w in zip(enums[name], words(enums[name]))])
    listed("TAUT_ABI_ENUM_LIST(X)", [f"X({name})" for name in sorted(enums)])
    listed("TAUT_ABI_CONSTANT_LIST(X)", [f'X({c}, "{c}")' for c in loose])
    lines.append("#endif /* TAUT_CORE_ABI_LIST_H */")
    return "\n".join(lines) + "\n"


def main(arguments):
    """The command line."""
    update = "--update" in arguments
    rest = [a for a in arguments if a != "--update"]
    root = pathlib.Path(rest[0] if rest else pathlib.Path(__file__).resolve().parent.parent)
    target = root / TARGET
    try:
        made = table(root)
    except Wrong as wrong:
        print(f"abi: cannot read include/taut: {wrong}", file=sys.stderr)
        return 1
    if update:
        target.write_text(made)
        return 0
    if not target.is_file() or target.read_text() != made:
        print(f"{TARGET}: is not what include/taut declares: tools/abi.py --update", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
