# test_mesh_files.sh -- STL, PLY, GLB, VTU: written, then read back by something else.
. "$SOURCE/tests/cli/cli.sh"

# A cube of six patches of different degrees and senses, and a rational tube on c-, h- and other bases.
cat > cube.json <<'JSON'
{ "taut": 1, "unit": "cm", "surfaces": [
  { "name": "bottom", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]] },
  { "name": "top", "u": { "type": "bezier", "degree": 2 }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[0,0,1],[1,0,1]],[[0,0.5,1],[1,0.5,1]],[[0,1,1],[1,1,1]]] },
  { "name": "front", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bspline", "degree": 1, "count": 3 },
    "points": [[[1,0,0],[1,0,0.5],[1,0,1]],[[0,0,0],[0,0,0.5],[0,0,1]]] },
  { "name": "back", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[0,1,0],[0,1,1]],[[1,1,0],[1,1,1]]] },
  { "name": "left <&> \"\u00e4\"", "u": { "type": "bezier", "degree": 1, "range": [2, 5] }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[0,0,0],[0,0,1]],[[0,1,0],[0,1,1]]] },
  { "name": "right", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[1,0,1],[1,0,0]],[[1,1,1],[1,1,0]]] } ] }
JSON
cat > tube.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "tube", "u": { "type": "bspline", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,4,4,4] },
  "v": { "type": "bezier", "degree": 1 },
  "points": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]],[[-1,1,0],[-1,1,2]],[[-1,0,0],[-1,0,2]],
             [[-1,-1,0],[-1,-1,2]],[[0,-1,0],[0,-1,2]],[[1,-1,0],[1,-1,2]],[[1,0,0],[1,0,2]]],
  "weights": [[1,1],[0.7071067811865476,0.7071067811865476],[1,1],[0.7071067811865476,0.7071067811865476],[1,1],
              [0.7071067811865476,0.7071067811865476],[1,1],[0.7071067811865476,0.7071067811865476],[1,1]] },
  { "name": "quasi", "u": { "type": "c-bezier", "alpha": 1.2 }, "v": { "type": "h-bspline", "beta": 0.8, "segments": 1 },
    "points": [[[3,0,0],[3,1,0],[3,2,0.3],[3,3,0]],[[4,0,0],[4,1,0],[4,2,0.3],[4,3,1]],
               [[5,0,0],[5,1,0],[5,2,0.3],[5,3,0.5]],[[6,0,0],[6,1,0],[6,2,0.3],[6,3,0]]] } ] }
JSON
# A ball of radius 1: half circles of two pieces around a circle of four, a pole at each end.
awk 'BEGIN { h = sqrt(0.5); split("1 1 0 -1 -1 -1 0 1 1", x); split("0 1 1 1 0 -1 -1 -1 0", y)
    split("0 1 1 1 0", r); split("-1 -1 0 1 1", z)
    printf "{ \"taut\": 1, \"surfaces\": [ { \"u\": { \"type\": \"bspline\", \"degree\": 2, \"knots\": [0,0,0,1,1,2,2,3,3,4,4,4] },\n"
    printf "\"v\": { \"type\": \"bspline\", \"degree\": 2, \"knots\": [0,0,0,1,1,2,2,2] },\n\"points\": ["
    for (i = 1; i <= 9; i++) { printf "%s[", (i > 1 ? "," : "")
        for (j = 1; j <= 5; j++) { printf "%s[%g,%g,%g]", (j > 1 ? "," : ""), x[i] * r[j], y[i] * r[j], z[j] }
        printf "]" }
    printf "],\n\"weights\": ["
    for (i = 1; i <= 9; i++) { printf "%s[", (i > 1 ? "," : "")
        for (j = 1; j <= 5; j++) { printf "%s%.17g", (j > 1 ? "," : ""), (i % 2 ? 1 : h) * (j % 2 ? 1 : h) }
        printf "]" }
    printf "] } ] }\n" }' > ball.json
for model in cube tube ball; do
    run 0 convert $model.json -o $model.stl -o $model.ply -o $model.glb -o $model.vtu -o $model.obj
    run 0 convert $model.json -o $model-h.glb --colour H --divide 5
done
run 0 convert tube.json -o quasi.vtu --surface quasi
for ending in stl ply obj; do
    run 0 convert tube.json -o pipe.$ending --surface tube
done
refused 2 'surface never\.stl found 0 expected 1' convert tube.json -o never.stl --surface other
absent never.stl

# Sizes say how many triangles there are: two for bottom and top, four for the front with its knot and so for all sides
# that go around with it; the header says the unit.
[ "$(wc -c < cube.stl)" = $((84 + 50 * 20)) ] || complain "cube.stl has $(wc -c < cube.stl) bytes"
head -c 80 cube.stl | grep -qa 'unit cm' || complain "cube.stl does not say its unit"
head -c 400 cube.ply | grep -qa '^element face 20' || complain "cube.ply: $(head -c 400 cube.ply | tr -d '\0')"
contains cube.vtu 'unit cm'

# A long thin pipe stays round: its own radius, not the length of the model, says how far a chord may be off. By Pappus: 0.5 %.
printf '{ "taut": 1, "construct": "pipe", "radius": 1, "caps": true, "bend_radius": 3, "run": [[0,0,0],[0,500,0],[500,500,0]] }' > long.json
run 0 make long.json --quiet -o long-model.json -o long.stl
python_with struct || missing Python 'tools/deps.sh test'
"$PYTHON" - > said.txt 2>&1 <<'PY' || complain "a long pipe: $(cat said.txt)"
import json, math, struct
data = open("long.stl", "rb").read()
volume, off = 0, 0
for k in range(struct.unpack("<I", data[80:84])[0]):
    a, b, c = (struct.unpack("<3f", data[84 + 50 * k + o:][:12]) for o in (12, 24, 36))
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    # the normal is that of the corners as they are, slivers of 0.05 x 500 too
    p, q = ([x - y for x, y in zip(end, a)] for end in (b, c))
    n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    off = max(off, math.dist(struct.unpack("<3f", data[84 + 50 * k:][:12]), [x / math.hypot(*n) for x in n]))
assert off < 1e-7, off
exact = json.load(open("long-model.json"))["certificate"]["figures"]["volume"]
print(volume, exact)
assert 0 < exact - volume < 0.005 * exact
PY

# A cutting pattern: pieces on their roll in the colours of their strains, red in tension, blue in compression, up to the limit; each seam
# above and below the surface.
"$TAUT" example pattern-sail > cloth-problem.json
run 0 make cloth-problem.json --quiet -o cloth.json -o cloth.glb
run 0 convert cloth.json -o cloth-h.glb --colour H
run 0 convert cloth.json -o cloth-one.glb --surface P2
"$PYTHON" - > said.txt 2>&1 <<'PY' || complain "a pattern: $(cat said.txt)"
import json, math, struct
def read(name):
    data = open(name, "rb").read()
    length = struct.unpack("<I", data[12:16])[0]
    head, body = json.loads(data[20:20 + length]), data[28 + length:]
    def numbers(accessor, form):
        view = head["bufferViews"][accessor["bufferView"]]
        width = {"VEC3": 3, "VEC4": 4}[accessor["type"]]
        start = view["byteOffset"] + accessor["byteOffset"]
        flat = struct.unpack_from(f"<{width * accessor['count']}{form}", body, start)
        return [flat[k:k + width] for k in range(0, len(flat), width)]
    return head, {}, numbers
head, _, numbers = read("cloth.glb")
details = json.load(open("cloth.json"))["details"]
names = [mesh["name"] for mesh in head["meshes"]]
assert names[:5] == ["sail", "P1", "P2", "P3", "P4"] and sorted(names[5:11]) == ["S1", "S1", "S2", "S2", "S3", "S3"], names
assert names[11:] == ["P1.cut", "P2.cut", "P3.cut", "P4.cut"] and [n["name"] for n in head["nodes"]][1:] == names, names
extras = head["materials"][0]["extras"]
most = max(abs(piece["strain"][end]) for piece in details["pieces"] for end in ("min", "max"))
assert extras["colour"] == "strain" and 0.9 * most < extras["limit"] < 1.2 * most, (extras, most)
boxes = []
for mesh in head["meshes"][:5]:
    primitive = mesh["primitives"][0]["attributes"]
    colours = numbers(head["accessors"][primitive["COLOR_0"]], "H")
    boxes.append(head["accessors"][primitive["POSITION"]])
    red, blue = (sum(c[i] > c[2 - i] + 6000 for c in colours) for i in (0, 2))
    assert (len(set(colours)) == 1) if mesh["name"] == "sail" else (red > 20 and blue > 20), (mesh["name"], red, blue)
for k, one in enumerate(boxes): # none lies on another one
    for other in boxes[:k]:
        middles = [[(box["min"][d] + box["max"][d]) / 2 for d in range(3)] for box in (one, other)]
        assert math.dist(*middles) > 0.4, (names, middles)
seams = {}
for mesh in head["meshes"][5:11]:
    seams.setdefault(mesh["name"], []).append(numbers(head["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]], "f"))
    assert mesh["primitives"][0]["mode"] == 3
for name, (above, below) in seams.items():
    gap = [math.dist(a, b) for a, b in zip(above, below)]
    middle = [[(x + y) / 2 for x, y in zip(a, b)] for a, b in zip(above, below)]
    long = sum(math.dist(a, b) for a, b in zip(middle, middle[1:]))
    told = next(seam["length"] for seam in details["seams"] if seam["name"] == name)
    assert max(gap) < 0.03 and min(gap) > 0.001 and abs(long - told) < 1e-3 * told, (name, max(gap), long, told)
    assert max(abs(z - 0.3 * (x * x - y * y)) for x, y, z in middle) < 1e-5, name
assert read("cloth-h.glb")[0]["materials"][0]["extras"]["colour"] == "H"
assert [mesh["name"] for mesh in read("cloth-one.glb")[0]["meshes"]] == ["P2"]
PY

# The validator is where CI puts it (TAUT_GLTF), or where `npm ci` in tests/gltf does.
modules=${TAUT_GLTF:-$SOURCE/tests/gltf}/node_modules
if command -v node > /dev/null && [ -d "$modules/gltf-validator" ]; then
    NODE_PATH=$modules node "$SOURCE/tests/gltf/validate.js" cube.glb cube-h.glb tube.glb tube-h.glb ball.glb ball-h.glb cloth.glb cloth-h.glb > said.txt 2>&1 ||
        complain "the validator: $(cat said.txt)"
    contains said.txt '^cube.glb: .* 20 triangles'
    grep -qa COLOR_0 cube-h.glb || complain "cube-h.glb has no colours"
else
    missing 'the Khronos validator' 'tools/deps.sh check, and npm ci in tests/gltf'
fi

# VTK: the area of the exact cells, cut finely, and the fields at their points.
if python_with vtkmodules.vtkIOXML; then
    "$PYTHON" "$SOURCE/tests/cli/read_vtu.py" tube.vtu quasi.vtu > said.txt 2>&1 || complain "VTK: $(cat said.txt)"
    run 0 convert tube.json -o tube-coefficients.vtu --coefficients
    "$PYTHON" "$SOURCE/tests/cli/read_vtu.py" tube-coefficients.vtu quasi.vtu > said.txt 2>&1 || complain "VTK: $(cat said.txt)"
    "$TAUT" example dirichlet-bicubic > sheet-problem.json
    run 0 make sheet-problem.json --quiet -o sheet.vtu --divide 4
    run 0 make sheet-problem.json --quiet -o coefficients.vtu --divide 4 --coefficients
    "$PYTHON" "$SOURCE/tests/cli/read_fields.py" 4 sheet.vtu coefficients.vtu > said.txt 2>&1 || complain "fields: $(cat said.txt)"
    "$PYTHON" - > said.txt 2>&1 <<'PY' || complain "fields at poles: $(cat said.txt)"
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName("ball.vtu")
reader.Update()
grid = reader.GetOutput()
part, data = grid.GetCellData().GetArray("part"), grid.GetPointData()
points = [grid.GetCell(i).GetPointId(k) for i in range(grid.GetNumberOfCells()) if part.GetTuple1(i) == 0
          for k in range(grid.GetCell(i).GetNumberOfPoints())]
for p in points: # 1.3e-12 seen
    assert abs(abs(data.GetArray("H").GetTuple1(p)) - 1) < 1e-11 and abs(data.GetArray("K").GetTuple1(p) - 1) < 1e-11, p
    assert 0 <= data.GetArray("isothermality").GetTuple1(p) <= 1, p
PY
    # Lagrange cells: degrees 3 and 2, uneven knots, one of them double.
    cat > wave.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "wave", "u": { "type": "bspline", "degree": 3, "knots": [0,0,0,0,0.3,0.3,1.1,2,2,2,2] },
  "v": { "type": "bspline", "degree": 2, "knots": [-1,-1,-1,0.5,1,1,1] },
  "points": [[[0,0,0],[0.1,1,0.5],[0,2,0],[0,3,1]],[[1,0,0.2],[1,1,0],[1.2,2,0],[1,3,0]],[[2,0,0],[2,1.1,1],[2,2,0.4],[2,3,0]],
             [[3,0,0],[3,1,0],[3,2,2],[3,3,0.1]],[[4,0,1],[4,0.9,0],[4,2,0],[4,3,0]],[[5,0,0],[5,1,0.7],[5.1,2,0],[5,3,0]],
             [[6,0,0],[6,1,0],[6,2,0.3],[6,3,0.5]]] } ] }
JSON
    run 0 convert wave.json -o wave.vtu
    run 0 convert wave.json -o wave-lagrange.vtu --lagrange
    "$PYTHON" "$SOURCE/tests/cli/read_lagrange.py" wave.json wave-lagrange.vtu wave.vtu > said.txt 2>&1 || complain "Lagrange cells: $(cat said.txt)"
    refused 2 'argument never\.vtu found null expected null' convert wave.json -o never.vtu --lagrange --coefficients
    absent never.vtu
    # Others go as quads, here 32 x 8 of the rational tube; nets are left out.
    run 0 convert tube.json -o tube-lagrange.vtu --lagrange --divide 8 --surface tube
    "$PYTHON" - > said.txt 2>&1 <<'PY' || complain "Lagrange cells of a rational tube: $(cat said.txt)"
import math
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName("tube-lagrange.vtu")
reader.Update()
grid = reader.GetOutput()
assert grid.GetNumberOfCells() == 32 * 8 and {grid.GetCellType(i) for i in range(256)} == {9}, grid.GetNumberOfCells()
assert all(abs(math.hypot(*grid.GetPoint(i)[:2]) - 1) < 1e-14 for i in range(grid.GetNumberOfPoints()))
assert grid.GetPointData().GetArray("RationalWeights") is None
try:
    import meshio
except ImportError:
    raise SystemExit
assert [(block.type, len(block.data)) for block in meshio.read("tube-lagrange.vtu").cells] == [("quad", 256)]
PY
    "$PYTHON" "$SOURCE/tests/cli/read_meshes.py" cube ball pipe > said.txt 2>&1 || complain "VTK: $(cat said.txt)"
else
    missing VTK 'tools/deps.sh check'
fi
finish
