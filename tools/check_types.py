#!/usr/bin/env python3
"""check_types.py ROOT -- types that are not the same everywhere: `long` has 32 or 64 bits, `long double` 64, 80 or 128. int64_t,
ptrdiff_t, size_t and core/twice.h stand in their place. Asked by check_layers.sh."""
import pathlib
import re
import sys

SKIPPED = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
# Labels and strings aside: the word, and numbers or conversions that have its type.
WRONG = re.compile(r"\blong\b|\b(?:0x[0-9a-fA-F]+|[0-9]+)[uU]?[lL]{1,2}[uU]?\b|\b[0-9]+\.[0-9]*[lL]\b|\.[0-9]+[lL]\b|\b(?:sqrt|fabs|fmax|fmin|ldexp)l\b|\b(?:labs|lrint|atol|ftell)\b")


def find_wrong(path: pathlib.Path) -> int:
    text = SKIPPED.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), path.read_text(encoding="utf-8"))
    found = 0
    for number, line in enumerate(text.split("\n"), 1):
        match = WRONG.search(line)
        if match:
            print(f"{path}:{number}: `{match.group()}` differs between systems: int64_t, ptrdiff_t, size_t or core/twice.h")
            found += 1
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    files = [p for part in ("src", "include") for p in sorted((root / part).rglob("*.[ch]"))]
    return 1 if sum(find_wrong(p) for p in files) else 0


if __name__ == "__main__":
    sys.exit(main())
