# test_dxf.sh -- DXF: nets, axes, cables, other curves, and panels, read back by ezdxf number by number, and by FreeCAD.
. "$SOURCE/tests/cli/cli.sh"

cat > odd.json <<'JSON'
{ "taut": 1, "unit": "ft", "curves": [
  { "name": "line", "t": { "type": "bezier", "degree": 1 }, "points": [[0,0,0],[1,1e-300,-2.5]] },
  { "name": "chain", "t": { "type": "bspline", "degree": 1, "knots": [0,0,1,2,3,3] }, "points": [[0,0,0],[1,0,0.1],[1,1,0],[0,0,0]] },
  { "name": "circle", "t": { "type": "bspline", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,4,4,4] },
    "points": [[1,0,0],[1,1,0],[0,1,0],[-1,1,0],[-1,0,0],[-1,-1,0],[0,-1,0],[1,-1,0],[1,0,0]],
    "weights": [1,0.7071067811865476,1,0.7071067811865476,1,0.7071067811865476,1,0.7071067811865476,1] },
  { "name": "odd \u00e4\ud83d\ude00\n\"<>", "t": { "type": "bezier", "degree": 3, "range": [2, 5] }, "points": [[0,0,0],[1,2,3],[0.1,0.2,0.3],[4,5,6]] },
  { "t": { "type": "c-bezier", "alpha": 1.2 }, "points": [[3,0,0],[3,1,0],[3,2,0.3],[3,3,0]] } ],
  "details": { "trace": "net <1>", "laths": [ { "name": "chain", "family": "a/b" }, 7, { "family": 3 } ] } }
JSON
for name in trace-enneper film-sail pipe-run bonnet-enneper; do
    "$TAUT" example $name > $name-problem.json
done
run 0 convert odd.json -o odd.dxf
for name in trace-enneper film-sail pipe-run; do
    run 0 make $name-problem.json --quiet -o $name.json -o $name.dxf
done
run 0 panels bonnet-enneper-problem.json --kind circular --divide 4,3 --quiet -o panels.json -o panels.dxf
cp odd.dxf first.dxf
run 0 convert odd.json -o odd.dxf
cmp -s first.dxf odd.dxf || complain "the same model gives another drawing"
[ "$(LC_ALL=C tr -d '\n\040-\176' < odd.dxf | wc -c)" = 0 ] || complain "odd.dxf is not ASCII"
contains odd.dxf '^odd \\U\+00E4__"<>$'

if python_with ezdxf; then
    for name in odd trace-enneper film-sail pipe-run panels; do
        "$PYTHON" "$SOURCE/tests/cli/read_dxf.py" $name.json $name.dxf > $name.txt 2>&1 || complain "$name.dxf: $(cat $name.txt)"
    done
    contains odd.txt '^UNIT 2 AC1015$'
    contains odd.txt '^LINE curves 1$'
    contains odd.txt '^POLYLINE net _1_ a_b 1$'
    contains odd.txt '^SPLINE curves 3$'
    contains trace-enneper.txt '^UNIT 4 AC1015$'
    contains trace-enneper.txt '^SPLINE asymptotic \+ [0-9]+$'
    contains trace-enneper.txt '^SPLINE asymptotic - [0-9]+$'
    contains film-sail.txt '^SPLINE cables 4$'
    contains pipe-run.txt '^LINE axes 6$'
    contains panels.txt '^LWPOLYLINE panels 72$'
    contains panels.txt '^TEXT names 72$'
else
    missing ezdxf 'tools/deps.sh check'
fi

# FreeCAD's own reader: as many objects, as long together as the curves of the model
if command -v freecadcmd > /dev/null; then
    "$TAUT" measure trace-enneper.json --json > measured.json
    cat > look.py <<PY
import FreeCAD, importDXF, json
draft = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft")
draft.SetBool("dxfShowDialog", False)
draft.SetBool("dxfUseLegacyImporter", False)
draft.SetBool("groupLayers", False) # an object for each curve, whatever was set last
importDXF.open("$PWD/trace-enneper.dxf")
objects = [o for o in FreeCAD.ActiveDocument.Objects if hasattr(o, "Shape")]
length = sum(o.Shape.Length for o in objects)
curves = json.load(open("$PWD/measured.json"))["curves"]
print("")
print("LOOK", len(objects) == len(curves), abs(length / sum(c["length"] for c in curves) - 1) < 1e-6, length)
PY
    # and pieces to cut: edges as many and as long as those of outlines, slots and marks
    "$TAUT" example trace-bonnet | "$TAUT" make - --quiet -o laths.json -o laths.dxf
    cat >> look.py <<PY
import Import, math
details = json.load(open("$PWD/laths.json"))["details"]
lines = [([[0, 0], [w, 0], [w, h], [0, h]], True) for w, h in (sheet["size"] for sheet in details["sheets"])]
for piece in details["pieces"]:
    lines += [(piece["outline"], True)] + [(s["outline"], True) for s in piece["slots"]] + [(l, False) for l in piece["lines"]]
edges = [math.dist(a, b) for points, closed in lines for a, b in zip(points, points[1:] + (points[:1] if closed else []))]
document = FreeCAD.newDocument("laths")
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft").SetBool("dxfUseLegacyImporter", False)
Import.readDXF("$PWD/laths.dxf", document.Name)
seen = [e.Length for o in document.Objects if hasattr(o, "Shape") for e in o.Shape.Edges]
print("")
print("CUT", len(seen) == len(edges), abs(sum(seen) / sum(edges) - 1) < 1e-9, len(seen), sum(seen))
PY
    freecadcmd look.py > freecad.txt 2>&1
    contains freecad.txt '^LOOK True True '
    contains freecad.txt '^CUT True True '
else
    echo 'left out: FreeCAD is not here: apt-get install freecad (1 GB; continuous integration goes without)'
fi

"$TAUT" example dirichlet-tent > tent.json
refused 4 'no-drawing none\.dxf found 0 expected 1' make tent.json -o none.dxf
refused 4 'no-drawing none\.dxf found 0 expected 1' make tent.json -o none.dxf -o none.stl
printf '{ "taut": 1, "curves": [ { "t": { "type": "bezier", "degree": 26 }, "points": [%s[0,1,2]] } ] }' "$(printf '[0,0,0],%.0s' $(seq 26))" > high.json
refused 4 'degree none\.dxf found 26 expected 25' convert high.json -o none.dxf
absent none.dxf none.stl
finish
