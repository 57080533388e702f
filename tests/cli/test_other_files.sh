# test_other_files.sh -- STEP and IGES files that others made (Debian's gmsh-doc, netgen-doc, occt-misc; TAUT_CAD_FILES: a folder of them):
# every face is read, trimmed ones are told apart and refused unless --untrim, and the others have the area that OpenCASCADE finds.
. "$SOURCE/tests/cli/cli.sh"

doc=/usr/share/doc occt=/usr/share/opencascade/data
fetch() { # fetch NAME PATH: a copy of it as NAME, from the folder or from its package; 1 where it is not there
    if [ -n "${TAUT_CAD_FILES:-}" ] && [ -e "$TAUT_CAD_FILES/$1" ]; then
        cp "$TAUT_CAD_FILES/$1" "$1"
    elif [ -e "$2.gz" ]; then
        gunzip -c "$2.gz" > "$1"
    elif [ -e "$2" ]; then
        cp "$2" "$1"
    else
        return 1
    fi
}
"$PROBE" || skip OpenCASCADE 'tools/deps.sh test, and build anew'

# faces FILE FACES TRIMMED: what is read of it
faces() {
    run 4 convert "$1" -o whole.json --json
    grep -q '"reason": "trimmed".*"found": '"$3"',' err.txt || complain "$1: $(cat err.txt), expected $3 trimmed faces"
    run 0 convert "$1" --untrim -o whole.json
    contains err.txt "$1: warning: surface [0-9]+ .*: the face is trimmed; this is the whole surface under it"
    [ "$(grep -c '"u": {' whole.json)" = "$2" ] || complain "$1: $(grep -c '"u": {' whole.json) faces, expected $2"
    run 0 boundary "$1" --json
    python3 - out.txt <<'PY' || complain "$1: edges of trimmed faces do not go around"
import collections, json, re, sys
ends, sizes, names = collections.defaultdict(list), [], set()
for row in json.load(open(sys.argv[1]))["curves"]:
    part = re.fullmatch(r"(.*)\.(\d+)", row["name"])
    if row["kind"] == "edge" and part:
        ends[part[1]] += [row["from"], row["to"]]
        names.add(part[1])
    sizes += [max(map(abs, row["from"])), max(map(abs, row["to"]))]
near = 1e-4 * max(sizes)
for name, points in ends.items():
    odd = [p for p in points if sum(max(abs(a - b) for a, b in zip(p, q)) < near for q in points) % 2]
    assert not odd, (name, odd)
assert names
PY
    ! grep -q 'is left out' whole.json || complain "$1: $(grep 'is left out' whole.json)"
}
# areas FILE TRIMMED: of the faces that are not trimmed, to 1e-6 of themselves
areas() {
    "$PROBE" --areas "$1" > theirs.txt || complain "$1: not read by OpenCASCADE"
    grep -o 'surface [0-9]* [^:]*: the face is trimmed' whole.json | cut -d ' ' -f 2 > trimmed.txt
    [ "$(wc -l < trimmed.txt)" = "$2" ] || complain "$1: $(wc -l < trimmed.txt) trimmed faces are named, expected $2"
    python3 - <<'PY' || complain "$1: not filtered"
import json
model = json.load(open("whole.json"))
trimmed = {int(line) - 1 for line in open("trimmed.txt")}
kept = [s for i, s in enumerate(model["surfaces"]) if i not in trimmed]
json.dump({"taut": 1, "unit": model["unit"], "surfaces": kept}, open("kept.json", "w"))
theirs = [line for i, line in enumerate(open("theirs.txt")) if i not in trimmed]
open("theirs.txt", "w").writelines(theirs)
PY
    run 0 measure kept.json --json --grid 2
    tr -d ' \n' < out.txt | sed 's/"name"/\n/g' | sed -n 's/.*"area":\([^,]*\),.*/\1/p' > ours.txt
    per=1 # square millimetres, which OpenCASCADE reads all in
    ! grep -q '"unit": "in"' whole.json || per=645.16
    awk -v file="$1" -v per=$per 'FILENAME == "ours.txt" { ours[FNR] = $1 * per; next }
        { d = ours[FNR] / $1 - 1; n++; if (!(d < 1e-6 && d > -1e-6)) { bad++; print file, FNR, ours[FNR], $1 } }
        END { exit bad > 0 || n == 0 }' ours.txt theirs.txt > areas.txt || complain "areas differ: $(cat areas.txt)"
}
try() { # try NAME PATH FACES TRIMMED [areas]
    if ! fetch "$1" "$2"; then
        missing "$1" 'tools/deps.sh files'
        return
    fi
    if [ "$4" = 0 ]; then
        run 0 convert "$1" -o whole.json
        [ ! -s err.txt ] || complain "$1: $(cat err.txt)"
    else
        faces "$1" "$3" "$4"
    fi
    [ -z "${5:-}" ] || areas "$1" "$4"
    if command -v gmsh > /dev/null; then
        printf 'SetFactory("OpenCASCADE");\nv() = ShapeFromFile("%s");\ns() = Surface{:};\nPrintf("%%g", #s()) >> "count.txt";\n' "$PWD/$1" > count.geo
        rm -f count.txt
        gmsh -v 0 count.geo - > gmsh.txt 2>&1
        [ "$(cat count.txt)" = "$3" ] || complain "$1: gmsh finds $(cat count.txt) faces, expected $3"
    fi
}
try as1-tu-203.stp $doc/gmsh-doc/doc/gmsh/demos/boolean/as1-tu-203.stp 160 50 areas
# An assembly: the innermost product of each face, and its colour.
looks() { # looks FILE EXPECTED: each product, or name, with its colour and how many faces there are of it
    [ -e "$1" ] || return
    run 0 convert "$1" --untrim -o whole.json
    said=$(python3 -c "
import collections, json
model = json.load(open('whole.json'))
names = [s['name'] for s in model['surfaces']]
products, colours = (model['details'].get(key, names) for key in ('products', 'colours'))
print(*(f'{p}:{c}:{n}' for (p, c), n in sorted(collections.Counter(zip(products, colours)).items())))")
    [ "$said" = "$2" ] || complain "$1: $said, expected $2"
}
looks as1-tu-203.stp 'bolt:#0000ff:42 l-bracket:#00ff00:32 nut:#ff0000:64 plate:#c7c700:18 rod:#ff9100:4'
if [ -e as1-tu-203.stp ]; then # 18 uses of 5 products, there and back
    run 0 convert as1-tu-203.stp --untrim -o whole.json
    run 0 convert whole.json -o whole.step
    [ "$(grep -c '=PRODUCT(' whole.step)" = 6 ] && [ "$(grep -c '=NEXT_ASSEMBLY_USAGE' whole.step)" = 18 ] || complain "products: $(grep '=PRODUCT(' whole.step)"
    run 0 convert whole.step -o again.json
    python3 - <<'PY' || complain "as1-tu-203.stp comes back as another assembly"
import json
def parts(file):
    return sorted((p["product"], len(p["surfaces"]), [round(v, 9) + 0 for row in p["placement"] for v in row]) for p in json.load(open(file))["details"]["parts"])
assert parts("whole.json") == parts("again.json") and len(parts("again.json")) == 18
PY
fi
try component8.step $doc/gmsh-doc/doc/gmsh/demos/boolean/component8.step 21 15 areas
try t20_data.step $doc/gmsh-doc/doc/gmsh/tutorial/t20_data.step 21 15 areas
try step_boundary_colors.stp $doc/gmsh-doc/doc/gmsh/demos/api/step_boundary_colors.stp 6 0 areas
looks step_boundary_colors.stp 'PartBody:#0080ff:1 PartBody:#00ff00:1 PartBody:#e1e1e1:3 PartBody:#ff0000:1'
try frame.step $doc/netgen/examples/frame.step 375 42 areas
try screw.step $occt/step/screw.step 10 7 areas
try linkrods.step $occt/step/linkrods.step 37 16 areas
# Every command that reads models takes --untrim; what is refused then is refused for something else.
refuses() { # refuses WORDS: as trimmed, unless --untrim
    "$TAUT" "$@" --json > out.txt 2> err.txt
    code=$?
    [ $code = 4 ] && grep -q '"reason": "trimmed"' err.txt || complain "$*: exit $code: $(cat err.txt)"
    "$TAUT" "$@" --json --untrim > out.txt 2> err.txt
    code=$?
    [ $code != 2 ] && ! grep -q '"reason": "trimmed"' err.txt || complain "$* --untrim: exit $code: $(cat err.txt)"
}
if [ -e screw.step ]; then
    for command in measure certify "panels --kind conical" "convert -o untrimmed.json" "view -o untrimmed.html"; do
        refuses $command screw.step
    done
    run 0 convert screw.step --untrim -o untrimmed.json
    run 0 convert untrimmed.json -o again.step
    contains err.txt 'untrimmed.json: warning: surfaces under trimmed faces are whole in it: [1-9]'
    run 0 convert screw.step --untrim -o untrimmed.json --json
    python3 - err.txt <<'PY' || complain "warnings in JSON: $(cat err.txt)"
import json, sys
told = json.load(open(sys.argv[1]))["warnings"]
notes = json.load(open("untrimmed.json"))["details"]["notes"]
assert [w["message"] for w in told] == notes and {w["where"] for w in told} == {"screw.step"} and len(told) == 7
PY
    run 0 measure screw.step --untrim --json
    [ ! -s err.txt ] || complain "warned beside JSON: $(cat err.txt)"
    contains out.txt 'the face is trimmed; this is the whole surface under it'
    refused 4 not-in-family panels screw.step --kind conical --untrim -o never.obj
    absent never.obj
fi
try bearing.iges $occt/iges/bearing.iges 213 56 areas
try hammer.iges $occt/iges/hammer.iges 45 23 areas
# Of trimmed faces too one that something broken is a part of is named, and not the file refused.
if [ -e hammer.iges ]; then
    for change in '128 0 1=5' '126 0 1=5' '142 0 2=9999'; do
        # shellcheck disable=SC2086
        python3 "$SOURCE/tests/cli/edit_iges.py" hammer.iges broken.iges $change || complain "$change: not changed"
        run 0 convert broken.iges --untrim -o whole.json
        contains whole.json 'face D3 of the file, .*, is left out: entity D[0-9]* is broken'
        [ "$(grep -c 'is left out' whole.json)" = 1 ] || complain "$change: $(grep 'is left out' whole.json)"
        [ "$(grep -c '"u": {' whole.json)" = 44 ] || complain "$change: $(grep -c '"u": {' whole.json) faces"
    done
fi
finish
