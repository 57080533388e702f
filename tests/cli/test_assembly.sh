# test_assembly.sh -- assemblies in STEP: the parts that a model says it has (details.parts) are products with placements, those that are
# alike one product with several uses, and come back from OpenCASCADE as they were; FreeCAD has them as parts that can be moved.
. "$SOURCE/tests/cli/cli.sh"

python3 - > parts.json <<'PY'
import json, math
def patch(name, points, place):
    moved = [[[sum(a * x for a, x in zip(row, p)) + row[3] for row in place] for p in line] for line in points]
    return {"name": name, "u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 2}, "points": moved}
bolt = [("head", [[[0, 0, 0], [0, 1, 1], [0, 2, 0]], [[3, 0, 0], [3, 1, 1], [3, 2, 0.5]]]),
        ("shank", [[[3, 0, 0], [3, 1, 1], [3, 2, 0.5]], [[5, 0, -1], [5, 1, 0], [5, 2, 0]]])]
plate = [("plate", [[[0, 0, 0], [0, 5, 0], [0, 10, 0]], [[10, 0, 0], [10, 5, 1], [10, 10, 0]]])]
def turn(angle, x, y, z):
    c, s = math.cos(angle), math.sin(angle)
    return [[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, z]]
uses = [("bolt", bolt, turn(0, 1, 2, 3)), ("plate \u00e4", plate, turn(0, 0, 0, 0)), ("bolt", bolt, turn(0.7, -20, 4, 0.1)),
        ("bolt", bolt, [[0, 0, 1, 30], [1, 0, 0, 0], [0, 1, 0, 0]])]
surfaces, parts = [], []
for name, patches, place in uses:
    parts.append({"product": name, "placement": place, "surfaces": [len(surfaces) + i for i in range(len(patches))]})
    surfaces += [patch(n, p, place) for n, p in patches]
surfaces.append(patch("loose", plate[0][1], turn(0.2, 100, 0, 0)))
colours = ["#ff0000" if s["name"] == "head" else "#00ff80" for s in surfaces]
json.dump({"taut": 1, "unit": "cm", "surfaces": surfaces, "details": {"parts": parts, "colours": colours, "product": "Br\u00fccke"},
           "curves": [{"name": "rope", "t": {"type": "bezier", "degree": 1}, "points": [[0, 0, 0], [1, 2, 3]]}]}, open("/dev/stdout", "w"))
PY
run 0 convert parts.json -o parts.step
[ "$(grep -c '=PRODUCT(' parts.step)" = 3 ] || complain "$(grep '=PRODUCT(' parts.step)"
[ "$(grep -c '=NEXT_ASSEMBLY_USAGE_OCCURRENCE(' parts.step)" = 4 ] || complain "$(grep NEXT_ASSEMBLY parts.step)"
sed -n 's/^#\([0-9]*\)=.*/\1/p' parts.step | sort -n > there.txt
sort -nu there.txt | cmp -s - there.txt || complain "an instance is there twice"
grep -o '#[0-9]*' parts.step | tr -d '#' | sort -nu | cmp -s - there.txt || complain "references and instances differ"
[ "$(grep -c "=PRODUCT('Br.X2.00FC.X0.cke'" parts.step)" = 1 ] || complain "the whole: $(grep '=PRODUCT(' parts.step)"
sed 's/, "product": "Br[^"]*"}, "curves"/}, "curves"/' parts.json > plain.json
run 0 convert plain.json -o plain.step
contains plain.step "=PRODUCT.'assembly'"
run 0 convert parts.json -o again.step
cmp -s parts.step again.step || complain "the same model gives another file"

if [ -e "$(dirname "$TAUT")/../libexec/taut-cad" ]; then
    run 0 convert parts.step -o back.json
    python3 - <<'PY' || complain "the assembly comes back as another"
import json
there, back = (json.load(open(f)) for f in ("parts.json", "back.json"))
def parts(model):
    found = []
    for part in model["details"]["parts"]:
        surfaces = [model["surfaces"][i] for i in part["surfaces"]]
        found.append((part["product"], [v for row in part["placement"] for v in row], [(s["name"], [c for l in s["points"] for p in l for c in p])
                      for s in surfaces], [model["details"]["colours"][i] for i in part["surfaces"]]))
    return sorted(found, key=lambda part: (part[0], [round(v, 6) for v in part[1]]))
ours, theirs = parts(there), parts(back)
assert back["details"]["product"] == there["details"]["product"] and back["details"]["products"].count("Br\u00fccke") == 1
assert len(ours) == len(theirs) == 4, [part[0] for part in theirs]
for a, b in zip(ours, theirs):
    assert a[0] == b[0] and a[3] == b[3], (a[0], b[0], a[3], b[3])
    assert max(abs(x - y) for x, y in zip(a[1], b[1])) < 1e-13, (a[1], b[1])
    for (name, p), (own, q) in zip(a[2], b[2]):
        assert name == own and max(abs(x - y) for x, y in zip(p, q)) < 1e-13, (name, own)
assert back["unit"] == "cm" and len(back["surfaces"]) == 8 and [c["name"] for c in back["curves"]] == ["rope"]
PY
    # written once more it is the same assembly, of the same name; so is one of one part
    run 0 convert parts.step -o twice.step
    products='s/.*=PRODUCT(\([^,]*\),.*/product \1/p; s/.*=NEXT_ASSEMBLY_USAGE_OCCURRENCE(\([^,]*,[^,]*\),.*/use \1/p'
    for file in parts twice; do
        sed -n "$products" $file.step | sort > $file.txt
    done
    cmp -s parts.txt twice.txt || complain "written again: $(diff parts.txt twice.txt)"
    python3 -c 'import json
model = json.load(open("parts.json"))
del model["surfaces"][2:], model["details"]["parts"][1:], model["details"]["colours"][2:]
json.dump(model, open("one.json", "w"))'
    run 0 convert one.json -o one.step
    run 0 convert one.step -o two.step
    for file in one two; do
        sed -n "$products" $file.step | sort > $file.txt
    done
    [ "$(wc -l < one.txt)" = 3 ] || complain "one part: $(cat one.txt)"
    cmp -s one.txt two.txt || complain "one part written again: $(diff one.txt two.txt)"
else
    missing OpenCASCADE 'tools/deps.sh test, and build anew'
fi
if command -v freecadcmd > /dev/null; then
    cat > look.py <<PY
import Part
shape = Part.Shape()
shape.read("$PWD/parts.step")
for child in shape.childShapes(False, False):
    print("LOOK", len(child.Faces), *(round(v, 6) + 0 for v in child.Placement.Base))
PY
    freecadcmd look.py > freecad.txt 2>&1 < /dev/null
    for part in '2 10.0 20.0 30.0' '2 -200.0 40.0 1.0' '2 300.0 0.0 0.0' '1 0.0 0.0 0.0'; do
        contains freecad.txt "^LOOK $part\$"
    done
else
    missing FreeCAD 'the Debian package freecad'
fi

# Uses of a part whose faces have no names, or those that the reader gives them, a row through all uses, and no colours, are uses of one
# product; where a colour is given to one face, of two.
python3 - <<'PY'
import json
model = json.load(open("parts.json"))
del model["details"]["colours"]
for name in (lambda i: "", lambda i: f"bolt.{i + 1}"):
    for i in (i for part in model["details"]["parts"] if part["product"] == "bolt" for i in part["surfaces"]):
        model["surfaces"][i]["name"] = name(i)
    json.dump(model, open("nameless.json" if name(0) == "" else "numbered.json", "w"))
model["details"]["colours"] = ["#ff0000" if i == 3 else "" for i in range(len(model["surfaces"]))]
json.dump(model, open("coloured.json", "w"))
PY
products() { # products FILE COUNT
    run 0 convert $1.json -o $1.step
    [ "$(grep -c '=PRODUCT(' $1.step)" = "$2" ] || complain "$1: $(grep '=PRODUCT(' $1.step), expected $2 products"
    [ "$(grep -c '=NEXT_ASSEMBLY_USAGE_OCCURRENCE(' $1.step)" = 4 ] || complain "$1: $(grep NEXT_ASSEMBLY $1.step)"
}
products nameless 3
products numbered 3
products coloured 4

# Parts that make no sense are no assembly's: numbers of no surface, a placement that is no rotation.
sed 's/"surfaces": \[0, 1\]/"surfaces": [0, 99, -1, "x"]/; s/\[\[0, 0, 1, 30\]/[[0, 0, 7, 30]/' parts.json > odd.json
run 0 convert odd.json -o odd.step
contains odd.step '=NEXT_ASSEMBLY_USAGE_OCCURRENCE'
finish
