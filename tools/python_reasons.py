#!/usr/bin/env python3
"""python_reasons.py [--check] -- writes python/taut/_reasons.py: what to change, by the word of an error, out of the lists of the
public headers. With --check fails where the file is not what would be written."""
import pathlib
import sys

import check_reasons

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "python/taut/_reasons.py"
HEAD = '''"""What to change, by the word of an error: written by tools/python_reasons.py from the lists in include/taut."""

REMEDIES = {
'''


def remedies():
    """Word to remedies, in the order of the headers; a word of several lists has several."""
    found = {}
    for header in sorted((ROOT / "include/taut").glob("*.h")):
        for _, body in check_reasons.LIST.findall(check_reasons.read(str(header))):
            text = body.replace("\\\n", "\n")
            for row in check_reasons.ROW.finditer(text):
                parts = check_reasons.arguments(text, row.start() + text[row.start():].index("(") + 1)
                remedy = "".join(check_reasons.words_of(parts[-1])).replace('\\"', '"')
                if remedy not in found.setdefault(row.group(1), []):
                    found[row.group(1)].append(remedy)
    return found


def page():
    lines = [f"    {word!r}: {'; or '.join(some)!r},\n" for word, some in sorted(remedies().items())]
    return HEAD + "".join(lines) + "}\n"


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        if PAGE.read_text() != page():
            sys.exit(f"{PAGE}: the headers say other words: tools/python_reasons.py writes it anew")
    else:
        PAGE.write_text(page())
