#!/usr/bin/env python3
"""claim_mutants.py [--check | CONSTRUCTION CLAIM] -- how many mutants made by hand break what a claim is judged by.

A row of tests/mutants counts for a claim if it changes a function or a constant of src/certify that the claim's code calls or
names, at any distance. A claim's code is what writes its name into a certificate, in the folders of its construction; and where
that tells only what others found, the functions of FOUND. Functions are told by their names, in their own file first. So a row in
what several claims are computed by counts for each of them.

With a construction and a claim: the names of these rows. With --check: fails where docs/certificate.md says more of a claim than
there are. tools/claims_table.py writes that column.
"""
import collections
import pathlib
import re
import sys

import mutant_table

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/certificate.md"
COMMENT = re.compile(r"/\*.*?\*/", re.S)
FUNCTION = re.compile(r"^(?:static\s+|const\s+)*[A-Za-z_][\w \t*]*?\b(\w+)\([^;{}]*\)\s*\{(.*?)^\}", re.M | re.S)
VALUES = re.compile(r"^(?:static\s+)?(?:const\b|enum\b)[^;(){}=]*(?:=\s*[^;{]*)?(?:\{.*?\}[^;]*)?;", re.M | re.S)
STRUCT_VALUES = re.compile(r"^static const struct\s*\{.*?\}\s*(\w+)[^;]*;", re.M | re.S)
FOLDERS = {"harmonic-extension": ("harmonic",), "biharmonic": ("biharmonic", "harmonic")}
READ = re.compile(r"(?:strcmp|record_\w+|net_text|item_named|find\w*)\([^;]*?$", re.S)
FOUND = {
    "bonnet": {
        "isothermal harmonic minimal": "taut_bonnet_prove",
        "smooth": "taut_bonnet_smooth",
        "algebraic": "taut_bonnet_algebra",
        "formula": "taut_bonnet_against_formula",
        "closed-form": "compare_closed taut_bonnet_integrate",
    },
    "asymptotic": {
        "asymptotic osculating": "add_edges taut_edge_prove edges_are_elsewhere",
        "regular": "taut_certify_regular taut_certify_add_regular",
    },
    "dirichlet": {
        "stationary": "find_gradient add_stationary",
        "aspect": "find_gradient add_aspect",
    },
    "plateau": {"stationary": "prove_stationary add_stationary find_directions prove_witness"},
    "film": {
        "stationary": "find_rest settle add_stationary find_gain judge",
        "stable": "find_stability add_stable",
        "length": "find_rest judge_ropes add_length",
        "volume": "judge_volumes add_volume",
        "least": "add_least",
        "equilibrium": "add_equilibrium taut_film_lines_measure",
        "images": "taut_film_images_certify",
    },
    "harmonic-extension": {"continuity merged": "add_meeting"},
    "pipe": {"embedded": "taut_pipe_claim_embedded claim_embedded taut_pipe_find_figures"},
    "trace": {
        "surface": "taut_certify_of",
        "on-surface asymptotic principal geodesic isoparametric length": "look_at",
        "figures": "look_at taut_net_crossings_look taut_net_panels_look taut_net_told_look",
    },
}


class Code:
    """What src/certify consists of: functions and constants, and who names whom."""

    def __init__(self, root):
        self.spans = collections.defaultdict(list)  # file -> [(start, end, name)]
        self.body = {}
        self.files = collections.defaultdict(set)
        for path in sorted((root / "src/certify").glob("*/**/*.[ch]")):
            file = str(path.relative_to(root))
            text = COMMENT.sub(lambda found: " " * len(found[0]), path.read_text(encoding="utf-8"))
            for found in FUNCTION.finditer(text):
                self.add(file, found, [found[1]])
            for found in VALUES.finditer(text):
                self.add(file, found, re.findall(r"(?<![.\w])(\w+)(?:\[[^\]]*\])*\s*=" if "enum" not in found[0] else
                                                 r"(?<=[{,])\s*(\w+)", found[0]))
            for found in re.finditer(r"^#define (\w+).*", text, re.M):
                self.add(file, found, [found[1]])
            for found in STRUCT_VALUES.finditer(text):
                self.add(file, found, [found[1]])

    def add(self, file, found, names):
        """One function, or one declaration of constants, by all names."""
        for name in names:
            self.spans[file].append((found.start(), found.end(), name))
            self.body[file, name] = self.body.get((file, name), "") + found[0]
            self.files[name].add(file)

    def at(self, file, place):
        """What stands there."""
        return {(file, name) for start, end, name in self.spans[file] if start <= place < end}

    def reached(self, roots):
        """All that these call or name, themselves included."""
        seen, left = set(roots), list(roots)
        while left:
            file, name = left.pop()
            for word in set(re.findall(r"\w+", self.body[file, name])):
                there = self.files.get(word, ())
                for other in [file] if file in there else there if word.lower().startswith("taut_") else ():
                    if (other, word) not in seen:
                        seen.add((other, word))
                        left.append((other, word))
        return seen

    def telling(self, construct, claim):
        """What writes the claim's name into a certificate."""
        folders = tuple(f"src/certify/{folder}/" for folder in FOLDERS.get(construct, (construct,)))
        own = {key for key in self.body if key[0].startswith(folders)}
        common = {key for key in self.body if key[0].startswith("src/certify/common/")}
        for claims, names in FOUND.get(construct, {}).items():
            if claim in claims.split():
                missing = set(names.split()) - {name for _, name in own | common}
                if missing:
                    raise mutant_table.Wrong(f"claim_mutants: {construct} {claim}: no function {' '.join(sorted(missing))}")
                return {key for key in own | common if key[1] in names.split()}
        writes = [{key for key in some if self.writes(key, claim)} for some in (own, common)]
        if claim == "identity":
            return writes[1] | {key for key in own if key[1].startswith("identify")}
        return writes[0] or writes[1] or (self.telling(construct, claim.removeprefix("inner_")) if "inner_" in claim else set())

    def writes(self, key, claim):
        """Whether it has the name as a string that it does not read a record by."""
        body = self.body[key]
        return any(not READ.search(body[:found.start()]) for found in re.finditer(f'"{re.escape(claim)}"', body))


def counts(root, pairs):
    """(construction, claim) -> names of its rows, for these pairs; and the rows of src/certify that count for none of them."""
    code, broken = Code(root), {}
    for row in mutant_table.load(root):
        for change in row.changes:
            if change.file.startswith("src/certify/"):
                found = mutant_table.pattern(change.old).search((root / change.file).read_bytes().decode())
                broken.setdefault(row.name, set()).update(code.at(change.file, found.start()) if found else ())
    result = {}
    for construct, claim in pairs:
        reached = code.reached(code.telling(construct, claim))
        result[construct, claim] = sorted(name for name, places in broken.items() if places & reached)
    return result, sorted(set(broken) - {name for names in result.values() for name in names})


def told():
    """(construction, claim) -> what the page says of it."""
    rows = (line.split("|") for line in PAGE.read_text(encoding="utf-8").splitlines() if re.match(r"\| [a-z-]+ \| `", line))
    return {(cells[1].strip(), cells[2].strip(" `")): int(cells[7]) for cells in rows if len(cells) == 9}


def main(arguments):
    """The command line."""
    said = told()
    if len(arguments) == 2:
        print("\n".join(counts(ROOT, [tuple(arguments)])[0][tuple(arguments)]))
        return 0
    found, none = counts(ROOT, said)
    if arguments == ["--check"]:
        fewer = [f"{c} {n}: {len(found[c, n])} mutants, docs/certificate.md says {count}"
                 for (c, n), count in said.items() if len(found[c, n]) < count]
        print("\n".join(fewer + ["claim_mutants: tools/claims_table.py TAUT --write"] if fewer else ["mutants by claim: ok"]))
        return 1 if fewer or not said else 0
    print("\n".join(f"{len(names):4} {construct} {claim}" for (construct, claim), names in found.items()))
    print(f"of none: {', '.join(none)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
