# test_sheets.sh -- --thickness in STEP: minimal cells and other surfaces as solid sheets that OpenCASCADE, gmsh and FreeCAD find
# valid and closed, of the volume that Steiner's formula has for a surface of area A and total curvature K,
#
#     V = T A + T^3 / 12 K
#
# A and K of cells are in closed form: 1.279261571171006 and -2 pi / 3 for each quad of Schwarz's D, and of the gyroid, which is
# that quad bent to another size; 2.345102884044167 and -8 pi for a cell of P.
. "$SOURCE/tests/cli/cli.sh"

near() { # near FOUND EXPECTED PART WHAT
    awk "BEGIN { d = $1 / $2 - 1; exit !(d < $3 && d > -$3) }" || complain "$4: $1, expected $2"
}
steiner() { # steiner THICKNESS AREA CURVATURE-OVER-PI
    awk -v t="$1" -v a="$2" -v k="$3" 'BEGIN { printf "%.17g", t * a + t * t * t / 12 * k * atan2(0, -1) }'
}

for cell in d p; do
    run 0 make "$SOURCE/examples/film-schwarz-$cell.json" --quiet -o $cell.json
done
run 0 make "$SOURCE/examples/film-gyroid.json" --quiet -o g.json
run 0 make "$SOURCE/examples/pipe-run-closed.json" --quiet -o ring.json
sheet() { # sheet NAME THICKNESS WORDS: NAME.step of NAME.json
    name=$1 thickness=$2
    shift 2
    run 0 convert "$name.json" -o "$name.step" --thickness "$thickness" "$@"
}
sheet d 0.1 --tolerance 1e-8
sheet p 0.02
sheet g 0.02
sheet ring 5
contains d.step "'sheets of thickness 0.1 mm, proved to lie within [0-9.e-]* mm of both sides'"
# what the file approximates has no bound of its normals
run 0 make "$SOURCE/examples/bonnet-thomsen.json" --quiet -o bonnet.json -o bonnet.step --thickness 0.02 --report bonnet.txt
contains bonnet.step "'sheets of thickness 0.02 mm, found within [0-9.e-]* mm of both sides'"
[ "$(tr -d ' \n' < bonnet.txt | grep -o '"distances":.*')" = '"distances":[null,null]}' ] || complain "$(tail -n 3 bonnet.txt)"
run 0 make "$SOURCE/examples/film-schwarz-d.json" --quiet -o whole.step --thickness 0.02 --report whole.txt
grep -q "\"distances\": \[[1-9][.0-9]*e-[0-9]*\]" whole.txt || complain "$(tail -n 3 whole.txt)"
contains d.step "^#[0-9]*=MANIFOLD_SOLID_BREP"
contains ring.step "^#[0-9]*=BREP_WITH_VOIDS"
contains d.step "^#[0-9]*=ADVANCED_FACE.'film.top'"
contains d.step "^#[0-9]*=ADVANCED_FACE.'film.[uv][01]'"
# the tolerance is of the diagonal, 1.732 here: splines come so near, unless quads meet at angles that are too large
within() { # within FILE: what taut says of it
    sed -n "s/.*proved to lie within \([0-9.e-]*\) mm of both sides'.*/\1/p" "$1"
}
sed '/"[uv]":/s/"degree": 5, "count": 10/"degree": 6, "count": 12/' "$SOURCE/examples/film-schwarz-p.json" > fine.problem.json
run 0 make fine.problem.json --quiet -o fine.json -o fine.step --thickness 0.05
awk "BEGIN { exit !($(within fine.step) < 1.7321e-6) }" || complain "fine.step is within $(within fine.step)"
run 0 make "$SOURCE/examples/film-neovius.json" --quiet -o neovius.json
sheet neovius 0.05
awk "BEGIN { exit !($(within neovius.step) < 3e-6) }" || complain "neovius.step is within $(within neovius.step)"
rm neovius.step
refused 4 'sheet neovius\.step found 2\.[0-9e-]* expected 1\.732[0-9]*e-6' convert neovius.json -o neovius.step --thickness 0.05 --tolerance 1e-6
absent neovius.step
sed '/"[uv]":/s/"count": 10/"count": 20/' "$SOURCE/examples/film-neovius.json" > finer.problem.json
run 0 make finer.problem.json --quiet -o finer.step --thickness 0.05 --tolerance 1e-6
awk "BEGIN { exit !($(within finer.step) < 1.7321e-6) }" || complain "finer.step is within $(within finer.step)"
d=$(steiner 0.1 7.675569427026036 -4)
p=$(steiner 0.02 2.345102884044167 -8)
g=$(steiner 0.02 3.091443798778584 -16)

if "$PROBE"; then
    "$PROBE" d.step p.step g.step ring.step > probe.txt || complain "not read: $(cat probe.txt)"
    contains probe.txt '^d.step read 1 valid 1 closed 1 solids 1 shells 1 faces 24 .* free 0 '
    contains probe.txt '^p.step read 1 valid 1 closed 1 solids 1 shells 1 faces 72 .* free 0 '
    contains probe.txt '^g.step read 1 valid 1 closed 1 solids 1 shells 1 faces 82 .* free 0 '
    contains probe.txt '^ring.step read 1 valid 1 closed 1 solids 1 shells 2 faces 20 .* free 0 '
    volume() { sed -n "s/^$1.step.* volume \([-+.e0-9]*\) .*/\1/p" probe.txt; }
    near "$(volume d)" "$d" 2e-8 'd.step, OpenCASCADE'
    near "$(volume p)" "$p" 1e-6 'p.step, OpenCASCADE'
    near "$(volume g)" "$g" 1e-6 'g.step, OpenCASCADE'
    # a pipe of radius r all round, hollow: 2 pi r T for each unit of its axis is T times its area
    area=$("$TAUT" measure ring.json --json | tr -d ' \n' | grep -o '"area":[-+.e0-9]*' | awk -F: '{ s += $2 } END { printf "%.17g", s }')
    near "$(volume ring)" "$(steiner 5 "$area" 0)" 1e-5 'ring.step, OpenCASCADE'
else
    missing OpenCASCADE 'tools/deps.sh test, and build anew'
fi
if command -v gmsh > /dev/null; then
    for name in d p g; do
        rm -f volume.txt
        cat > volume.geo <<GEO
SetFactory("OpenCASCADE");
v() = ShapeFromFile("$PWD/$name.step");
s() = Volume{:};
For i In {0 : #s() - 1}
  m = Mass Volume{s(i)};
  Printf("%.16g", m) >> "volume.txt";
EndFor
GEO
        gmsh -v 0 volume.geo - > gmsh.txt 2>&1 || complain "gmsh $name.step: $(cat gmsh.txt)"
        [ "$(wc -l < volume.txt)" = 1 ] || complain "gmsh finds $(cat volume.txt) in $name.step"
        eval "expected=\$$name"
        near "$(head -n 1 volume.txt)" "$expected" 2e-5 "$name.step, gmsh"
    done
else
    missing gmsh 'tools/deps.sh check'
fi
if command -v freecadcmd > /dev/null; then
    for name in d p g ring; do
        cat > look.py <<PY
import Part
shape = Part.Shape()
shape.read("$PWD/$name.step")
print("LOOK", shape.isValid(), len(shape.Solids), all(s.isClosed() for s in shape.Shells), repr(shape.Volume))
PY
        freecadcmd look.py > freecad.txt 2>&1 < /dev/null
        contains freecad.txt '^LOOK True 1 True '
    done
else
    missing FreeCAD 'the Debian package freecad'
fi

# IGES has the same surfaces; a file written twice is the same, for any number of threads.
run 0 convert d.json -o d.igs --thickness 0.1
sheet p 0.02 --threads 3
cp p.step first.step
sheet p 0.02
cmp -s first.step p.step || complain "the same sheet is another file"

# What folds, meets at edges, or has three sides is refused, with what would do.
refused 4 'fold p\.step found 1 expected 0.463[0-9]*' convert p.json -o p.step --thickness 1
contains err.txt 'its least radius of curvature is 0.23'
run 0 make "$SOURCE/examples/film-bubbles.json" --quiet -o bubbles.json
refused 4 'sheet bubbles\.step' convert bubbles.json -o bubbles.step --thickness 0.01
run 0 make "$SOURCE/examples/film-ridge.json" --quiet -o ridge.json
refused 4 'sheet ridge\.step found 7[0-9.]*' convert ridge.json -o ridge.step --thickness 0.01
[ ! -e ridge.step ] || complain "ridge.step is there"
finish
