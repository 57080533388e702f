"""mutant_table.py -- the mutants: rows of tests/mutants/<layer>.json, each of which breaks one thing in the sources.

    {
        "name": "bernstein-derivative-sign",
        "what": "the first Bernstein derivative has the wrong sign at its left end",
        "file": "src/basis/bernstein.c",
        "old": "b[0] = -degree * b[0];",
        "new": "b[0] = degree * b[0];",
        "caught_by": "^unit/basis/bases$"
    }

A row that breaks several places has "changes", a list of such "file", "old" and "new", instead. "old" is whole words and
signs that stand exactly once in the file; blanks and ends of lines do not count, so that a row outlives a new layout and a
new indentation. "caught_by" is a regular expression over the names that ctest gives. A table holds the rows of one folder of
src/, by name.
"""
import collections
import difflib
import json
import pathlib
import re

Change = collections.namedtuple("Change", "file old new")
Row = collections.namedtuple("Row", "name what changes caught_by table")

# What C is made of, as far as the ends of its statements go: comments, directives, strings, words, signs.
LEXEME = re.compile(r"""/\*.*?\*/ | ^[ \t]*\#(?:\\\n|[^\n])* | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*' | \w+ | \S""",
                    re.S | re.M | re.X)
SHORT, LONG = 6, 100  # characters: of a longer statement a part is taken, and none that is shorter


class Wrong(Exception):
    """What is wrong with a row or a table, in one line."""


def tokens(text):
    """The words and signs of text: all that counts when texts are compared."""
    return re.findall(r"\w+|[^\w\s]", text)


def folded(text):
    """text in one line, where it is no directive and has no comment that ends with its line."""
    if re.search(r"(?m)^\s*#|\\$|//", text):
        return text.strip("\n")
    return re.sub(r"\s*\n\s*", " ", re.sub(r"(?<=[(\[])\s*\n\s*", "", text.strip()))


# --- Tables -------------------------------------------------------------------------------------------------------


def table_of(file):
    """The table for a change of that file: the layer of src/foo/bar.c is foo, that of foo/bar.c too."""
    parts = pathlib.PurePosixPath(file).parts
    return (parts[1] if parts[0] == "src" and len(parts) > 2 else parts[0]) + ".json"


def row_of(entry, table):
    """The row that a table holds as entry."""
    name = entry.get("name") if isinstance(entry, dict) else None
    if not isinstance(name, str) or not re.fullmatch("[a-z0-9-]+", name):
        raise Wrong(f"{table}: a row without a name of small letters, digits and hyphens")
    changes = entry.get("changes", [{key: entry.get(key) for key in Change._fields}])
    allowed = {"name", "what", "caught_by"} | ({"changes"} if "changes" in entry else set(Change._fields))
    if set(entry) != allowed:
        raise Wrong(f"{table}: {name}: has {', '.join(sorted(entry))}; should have {', '.join(sorted(allowed))}")
    if not isinstance(changes, list) or not changes or \
            any(not isinstance(c, dict) or set(c) != set(Change._fields) for c in changes):
        raise Wrong(f"{table}: {name}: changes should be a list of objects with file, old and new")
    texts = [entry["what"], entry["caught_by"]] + [c[key] for c in changes for key in Change._fields]
    if not all(isinstance(text, str) for text in texts):
        raise Wrong(f"{table}: {name}: a value is no text")
    if not all(text.strip() for text in texts[:2] + [c[key] for c in changes for key in ("file", "old")]):
        raise Wrong(f"{table}: {name}: an empty text; only new may be empty")
    try:
        re.compile(entry["caught_by"])
    except re.error as error:
        raise Wrong(f"{table}: {name}: caught_by is no regular expression: {error}") from None
    return Row(name, entry["what"], [Change(**c) for c in changes], entry["caught_by"], table)


def entry_of(row):
    """What a table holds for a row."""
    changes = [change._asdict() for change in row.changes]
    broken = changes[0] if len(changes) == 1 else {"changes": changes}
    return {"name": row.name, "what": row.what, **broken, "caught_by": row.caught_by}


def text_of(rows):
    """A table's file: rows by name, one member a line."""
    return json.dumps([entry_of(row) for row in sorted(rows)], indent=4, ensure_ascii=False) + "\n"


def load(root):
    """All rows below root, by name."""
    rows = []
    for path in sorted((root / "tests/mutants").glob("*.json")):
        table = str(path.relative_to(root))
        try:
            entries = json.loads(path.read_text())
        except ValueError as error:
            raise Wrong(f"{table}: no JSON: {error}") from None
        if not isinstance(entries, list):
            raise Wrong(f"{table}: should be a list of rows")
        rows += [row_of(entry, table) for entry in entries]
    rows.sort()
    for one, next_one in zip(rows, rows[1:]):
        if one.name == next_one.name:
            raise Wrong(f"{next_one.table}: {one.name}: the name is in {one.table} too" if one.table != next_one.table
                        else f"{one.table}: {one.name}: the name is there twice")
    return rows


def tidy(rows):
    """The tables as they should stand: name of the file in tests/mutants, its text."""
    tables = collections.defaultdict(list)
    for row in rows:
        tables[table_of(row.changes[0].file)].append(row)
    return {name: text_of(rows) for name, rows in tables.items()}


def untidy(root, rows):
    """The tables that tidy would write otherwise."""
    wanted = tidy(rows)
    there = {path.name: path.read_text() for path in (root / "tests/mutants").glob("*.json")}
    return sorted(name for name in {*wanted, *there} if wanted.get(name) != there.get(name))


def write(root, rows):
    """Writes all tables anew."""
    folder = root / "tests/mutants"
    wanted = tidy(rows)
    for name in untidy(root, rows):
        if name in wanted:
            folder.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(wanted[name])
        else:
            (folder / name).unlink()


# --- Breaking -----------------------------------------------------------------------------------------------------


def pattern(old):
    """Finds old, with any blanks between its words and signs, and at least some between two words."""
    parts = tokens(old)
    words = [re.match(r"\w", part) is not None for part in parts]
    text = re.escape(parts[0])
    for i in range(1, len(parts)):
        text += (r"\s+" if words[i - 1] and words[i] else r"\s*") + re.escape(parts[i])
    return re.compile((r"(?<!\w)" if words[0] else "") + text + (r"(?!\w)" if words[-1] else ""))


def applied(file, text, changes):
    """What the changes make of the text of that file."""
    places = []
    for change in changes:
        found = [place.span() for place in pattern(change.old).finditer(text)]
        times = "not found" if not found else "found twice" if len(found) == 2 else f"found {len(found)} times"
        if len(found) != 1:
            raise Wrong(f"{times} in {file}: {folded(change.old)}")
        if tokens(change.old) == tokens(change.new):
            raise Wrong(f"old and new are the same: {folded(change.old)}")
        places.append((*found[0], change))
    behind = len(text)
    for start, end, change in sorted(places, reverse=True):
        if end > behind:
            raise Wrong(f"two changes of one place in {file}: {folded(change.old)}")
        text, behind = text[:start] + change.new + text[end:], start
    return text


def broken_files(root, row):
    """What the files of a row become: path, its text. Nothing is written."""
    texts = {}
    for file in dict.fromkeys(change.file for change in row.changes):
        inside, path = pathlib.PurePosixPath(file), root / file
        try:
            if inside.is_absolute() or ".." in inside.parts or not path.is_file():
                raise Wrong(f"no file {file}")
            texts[path] = applied(file, path.read_bytes().decode(), [c for c in row.changes if c.file == file])
        except Wrong as wrong:
            raise Wrong(f"{row.table}: {row.name}: {wrong}") from None
    return texts


# --- Making rows --------------------------------------------------------------------------------------------------


class Text:
    """A file as words and signs, with the places where its statements and its clauses end."""

    def __init__(self, text):
        self.text = text
        self.spans = [found.span() for found in LEXEME.finditer(text)]
        self.tokens = [text[a:b] for a, b in self.spans]
        # An end is before the token of that number. Braces after "=", "," or a brace of that kind hold values.
        self.statement, self.clause = {0, len(self.tokens)}, {0, len(self.tokens)}
        depth, values = 0, []
        for i, token in enumerate(self.tokens):
            depth += (token in ("(", "[")) - (token in (")", "]"))
            if token == "{":
                before = self.tokens[i - 1] if i > 0 else ""
                values.append(before in ("=", ",") or (before == "{" and bool(values) and values[-1]))
            if token.startswith("/*") or token.lstrip().startswith("#") or (token in ("{", "}") and not (values and values[-1])):
                depth = 0
                self.statement |= {i, i + 1}
            elif token == ";" and depth == 0:
                self.statement.add(i + 1)
            if token in (",", ";"):
                self.clause.add(i + 1)
            elif token in ("(", ")", "{", "}", "?", ":", "&", "|"):
                self.clause |= {i, i + 1}
            if token == "}" and values:
                values.pop()
        self.clause |= self.statement

    def part(self, first, end):
        """What stands from one token to before another."""
        return self.text[self.spans[first][0]:self.spans[end - 1][1]] if first < end else ""

    def is_one(self, first, end):
        """Whether that stands nowhere else, and can be read."""
        part = self.part(first, end)
        return len(part) >= SHORT and len(pattern(part).findall(self.text)) == 1


def widened(text, first, end, ends):
    """The fewest pieces between ends that hold these tokens and stand once."""
    ends = sorted(ends)
    low = max(i for i, at in enumerate(ends) if at <= first)
    high = min(i for i, at in enumerate(ends) if at >= end)
    for more in range(len(ends)):
        ways = [(ends[max(low - left, 0)], ends[min(high + more - left, len(ends) - 1)]) for left in range(more + 1)]
        unique = [way for way in ways if text.is_one(*way)]
        if unique:
            return min(unique, key=lambda way: len(text.part(*way)))
    raise Wrong("nothing in the file stands once")


def changes_of(file, before, after):
    """The changes that make one text of a file another, each as short as can be read and stands once."""
    old, new = Text(before), Text(after)
    codes = difflib.SequenceMatcher(None, old.tokens, new.tokens, autojunk=False).get_opcodes()
    groups = [code[1:] for code in codes if code[0] != "equal"]  # old first, old end, new first, new end
    while True:
        wide = []
        for first, end, _, _ in groups:
            place = widened(old, first, end, old.statement)
            wide.append(place if len(old.part(*place)) <= LONG else widened(old, first, end, old.clause))
        near = [k for k in range(len(groups) - 1) if wide[k][1] >= wide[k + 1][0]]
        if not near:
            break
        k = near[0]
        groups[k:k + 2] = [(groups[k][0], groups[k + 1][1], groups[k][2], groups[k + 1][3])]
    return [Change(file, folded(old.part(first, end)), folded(new.part(group[2] - group[0] + first, group[3] + end - group[1])))
            for (first, end), group in zip(wide, groups)]
