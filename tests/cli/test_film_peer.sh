# test_film_peer.sh -- the sail of film-sail against Surface Evolver: steps downhill on three refinements, then Newton's on quadratic
# elements and on elements of degree 4. What is left is Evolver's own: its sail has more energy than the least of the splines, by
# 6e-9 of it, and at a minimum area and lengths are off by about the root of that. Then a unit of Neovius' surface, between lines and
# mirrors, on four refinements, and a ring between a circle and a cable in a plane, on elements of degree 6.
. "$SOURCE/tests/cli/cli.sh"

command -v evolver > /dev/null || skip 'Surface Evolver' 'tools/deps.sh check'
cp "$SOURCE/tests/cli/film-sail.fe" sail.fe
cat > commands <<'END'
quiet
r
r
{ g 10; V; u; V } 20
r
{ g 10; V; u; V } 20
M 2
U
g 100
U
hessian_seek; hessian; hessian
lagrange 4
hessian; hessian; hessian
printf "%.15g %.15g %.15g\n", total_energy, total_area, cable.value / 2
q
q
END
evolver -x -fcommands sail.fe > evolver.txt 2>&1 || complain "Evolver failed: $(tail -n 3 evolver.txt)"
"$TAUT" example film-sail > sail.json
run 0 make sail.json --quiet -o model.json
python3 - model.json evolver.txt <<'END' || complain "Evolver has another sail"
import json, re, sys
figures = json.load(open(sys.argv[1]))["certificate"]["figures"]
found = [line.split() for line in open(sys.argv[2], errors="replace") if re.fullmatch(r"[\d.]+ [\d.]+ [\d.]+\s*", line)]
energy, area, length = map(float, found[-1])
ours = figures["energy"], figures["area"], sum(figures["lengths"])
apart = energy / ours[0] - 1, area / ours[1] - 1, length / ours[2] - 1
print("apart by", apart, file=sys.stderr)
assert 0 < apart[0] < 8e-9, apart
assert abs(apart[1]) < 1.2e-6, apart
assert abs(apart[2]) < 1.4e-7, apart
END

cp "$SOURCE/tests/cli/film-neovius.fe" neovius.fe
sed -e '/^M 2$/i r\n{ g 10; V; u; V } 20' -e 's/^printf.*/printf "%.15g\\n", total_area/' commands > neovius
evolver -x -fneovius neovius.fe > evolver.txt 2>&1 || complain "Evolver failed: $(tail -n 3 evolver.txt)"
"$TAUT" example film-neovius > neovius.json
run 0 make neovius.json --quiet -o model.json
python3 - model.json evolver.txt <<'END' || complain "Evolver has another surface of Neovius"
import json, re, sys
area = json.load(open(sys.argv[1]))["certificate"]["figures"]["area"]
found = float([line for line in open(sys.argv[2], errors="replace") if re.fullmatch(r"[\d.]+\s*", line)][-1])
print("apart by", found / area - 1, file=sys.stderr)
assert abs(found / area - 1) < 1e-10, found / area - 1
END

cp "$SOURCE/bench/film/cable.fe" cable.fe
cat > commands <<'END'
quiet
{ r; { g 10; V; u; V } 20 } 2
M 2
U
g 100
U
{ hessian_seek } 5
lagrange 6
{ hessian_seek } 3
printf "%.15g %.15g %.15g\n", total_energy, total_area, cable.value / 0.3
q
q
END
evolver -x -fcommands cable.fe > evolver.txt 2>&1 || complain "Evolver failed: $(tail -n 3 evolver.txt)"
cat > cable.json <<'END'
{ "taut": 1, "construct": "film", "u": { "type": "bspline", "degree": 4, "count": 24 }, "v": { "type": "bspline", "degree": 4, "count": 12 },
  "seams": [["u0", "u1"]], "edges": {
  "v0": { "fixed": { "circle": { "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1 } } },
  "v1": { "cable": { "force": 0.3 }, "plane": { "point": [0, 0, 0.3], "normal": [0, 0, 1] } } } }
END
run 0 make cable.json --quiet -o model.json
python3 - model.json evolver.txt <<'END' || complain "Evolver has another ring"
import json, re, sys
figures = json.load(open(sys.argv[1]))["certificate"]["figures"]
found = [line.split() for line in open(sys.argv[2], errors="replace") if re.fullmatch(r"[\d.]+ [\d.]+ [\d.]+\s*", line)]
ours = figures["energy"], figures["area"], figures["lengths"][0]
apart = [float(a) / b - 1 for a, b in zip(found[-1], ours)]
print("apart by", apart, file=sys.stderr)
assert abs(apart[0]) < 4e-11 and abs(apart[1]) < 2e-9 and abs(apart[2]) < 2e-9, apart
END
finish
