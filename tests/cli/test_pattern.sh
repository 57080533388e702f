# test_pattern.sh -- cutting patterns from the command line: by words and by document, drawings read back, with what is wrong told.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example pattern-sail > sail.json
run 0 make sail.json -o made.json -o made.dxf -o made.svg -o made.step --report report.json
for claim in surface cover on-surface geodesic edges seams no-fold no-overlap allowance stationary stable exhausts roll identity; do
    contains err.txt "$claim +holds"
done
contains made.json '"name": "P4.cut"'
run 0 certify made.json sail.json
run 0 certify made.json

# The words of the command are the same document.
sed -n '/"of"/,/^  },/p' sail.json | sed '1s/.*/{/; $s/.*/}/' > surface.json
run 0 pattern surface.json --across v0,v1 --count 4 --width 0.75 --warp 0.02 --weft 0.045 --allowance 0.02 --border 0.05 --marks 0.25 \
    --quiet -o words.json
sed 's/"of": {/"of": "surface.json",/; /"taut": 1,/,/^  },/{/"construct"\|"pattern"\|^  "taut"/!{/"of"/!d}}' sail.json > document.json
run 0 make document.json --quiet -o document-made.json
cmp words.json document-made.json || complain "the words make another pattern than the document"
run 0 pattern surface.json --across u1,u0 --width 0.8 --by parameter --material pvc-pes --seam-length true --quiet -o wide.json
contains wide.json '"seam_length": "true"'
run 0 pattern surface.json --across v0,v1 --count 2 -o rule.json
contains err.txt '^  seam rule +shared$'
contains err.txt '^  seam length +[0-9]'
run 0 certify wide.json
for threads in 1 3; do
    run 0 pattern surface.json --across v0,v1 --count 5 --threads $threads --quiet -o threads-$threads.json
done
cmp threads-1.json threads-3.json || complain "threads change the pattern"

# From below: the same model, drawings mirrored across the roll.
sed 's/"cloth": {/"cloth": { "side": "lower",/' sail.json > lower.json
run 0 make lower.json --quiet -o lower-made.json -o lower.dxf
run 0 certify lower-made.json lower.json
grep -v '"side"' made.json | tr -d ' \n,' > a.txt
grep -v '"side"' lower-made.json | tr -d ' \n,' > b.txt
cmp a.txt b.txt || complain "the lower side is another model"
ys() { awk '{ gsub(/\r/, "") } getline value { if (value ~ /ENTITIES/) on = 1; if (on && $1 == 20) printf "%.12f\n", value }' "$1"; } # pairs of lines: a code, its value
ys made.dxf > up.txt
ys lower.dxf > down.txt
paste -d ' ' up.txt down.txt | awk '$1 == 0 && $2 == 0 { next } # the heads of polylines, which are no places
    { s = $1 + $2; if (!n++) low = high = s; if (s < low) low = s; if (s > high) high = s }
    END { exit !(n > 100 && high - low < 1e-9 && high > 0) }' || complain "drawings of the lower side are not mirrored"

run 0 pattern surface.json --across v0,v1 --count 3 --hold v0 --hold left --quiet -o held.json
run 0 certify held.json
refused 2 'held' pattern surface.json --across v0,v1 --count 3 --hold w1 -o none.json
refused 2 'value --across v0' pattern surface.json --across v0 --count 3 -o none.json
refused 2 'edge' pattern surface.json --across v0,u1 --count 3 -o none.json
refused 2 'compensation' pattern surface.json --across v0,v1 --count 3 --warp 0.5 -o none.json
refused 2 'missing' pattern surface.json --across v0,v1 -o none.json
refused 2 'allowance' pattern surface.json --across v0,v1 --count 3 --allowance -1 -o none.json
refused 4 'allowance' pattern surface.json --across v0,v1 --count 3 --allowance 9 -o none.json
refused 4 'strain' pattern surface.json --across v0,v1 --strain 1e-9 -o none.json
refused 4 'strain /strain found 0.0011[0-9]* expected 0.001' pattern surface.json --across v0,v1 --count 4 --strain 0.001 -o none.json
contains err.txt 'take at least 5 strips'
run 0 pattern surface.json --across v0,v1 --strain 0.005 --quiet -o strained.json
contains strained.json '"strain": 0.005'
refused 2 'material' pattern surface.json --across v0,v1 --count 3 --material silk -o none.json
"$TAUT" example trace-torus > torus.json
refused 2 'option' pattern torus.json -o none.json
refused 2 'option' pattern torus.json --allowance 0.01 -o none.json
refused 4 'width' pattern surface.json --across v0,v1 --count 2 --width 0.3 -o none.json
refused 3 'kind' pattern sail.json --across v0,v1 --count 2 -o none.json
run 0 schema pattern
contains out.txt '#/\$defs/pattern'

# A ramp of more than one turn lies over itself when it is flat, but not when it is cut across.
awk 'BEGIN {
    printf "{ \"taut\": 1, \"pattern\": \"cloth\", \"of\": { \"taut\": 1, \"surfaces\": [{ \"name\": \"ramp\", \"u\": { \"type\": \"bezier\", \"degree\": 1 }, "
    printf "\"v\": { \"type\": \"bspline\", \"degree\": 3, \"count\": 30 }, \"points\": ["
    for (r = 1; r < 2; r += 0.6)
        for (k = 0; k < 30; k++)
            printf "%s[%.6f, %.6f, %.6f]%s", k == 0 ? "[" : "", r * cos(8.168 * k / 29), r * sin(8.168 * k / 29), 0.6 * k / 29, k < 29 ? ", " : r < 1.5 ? "], " : "]"
    print "] }] }, \"seams\": [{ \"across\": [\"v0\", \"v1\"], \"count\": 1 }] }"
}' > ramp.json
refused 4 'overlap' make ramp.json -o none.json
sed 's/"count": 1 }\]/"count": 1 }, { "butt": "P1", "at": 0.5 }]/' ramp.json > ramps.json
run 0 make ramps.json --quiet -o ramps-made.json

# A film with cables, from its problem; its tension is the prestress.
"$TAUT" example film-sail | sed 's/"force": 2/"force": 8/g; s/"construct": "film",/"construct": "film", "tension": 4,/' > sail-film.json
for stress in film numbers; do
    [ $stress = film ] && word='"film"' || word='[4, 4]'
    cat > $stress.json << EOF
{ "taut": 1, "pattern": "cloth", "of": $(cat sail-film.json), "seams": [{ "across": ["v0", "v1"], "count": 2 }],
  "cloth": { "material": "pvc-pes" }, "prestress": $word }
EOF
    run 0 make $stress.json --quiet -o $stress-made.json
    run 0 certify $stress-made.json $stress.json
done
cmp film-made.json numbers-made.json || complain "the film's tension is another prestress"
contains film-made.json '"warp": 0.00318979266347'
cat > no-film.json << 'EOF'
{ "taut": 1, "pattern": "cloth", "of": "surface.json", "seams": [{ "across": ["v0", "v1"], "count": 2 }],
  "cloth": { "material": "pvc-pes" }, "prestress": "film" }
EOF
refused 3 'type /prestress' make no-film.json -o none.json

# Pieces are wider than the roll: how many strips fit.
"$TAUT" example pattern-sail > wide.json
sed -i 's/"count": 4/"count": 3/; s/"width": [0-9.]*/"width": 0.75/' wide.json
refused 4 'width /seams/0 found 0.[0-9]* expected 0.75' make wide.json -o none.json
contains err.txt 'with a count of 4 all fit'

# A ring is sewn along its closing line.
"$TAUT" example film-ring > ring.json
run 0 make ring.json --quiet -o ring-made.json
run 0 pattern ring-made.json --across v0,v1 --count 4 --allowance 0.02 -o ring-cloth.json
contains ring-cloth.json '"name": "S4"'
refused 4 'no-geodesic' pattern ring-made.json --across u0,u1 --count 4 -o none.json
contains err.txt 'would end where it begins, as these edges are one line: run it between the other two'

# a roof with a ridge along u = 1, and a surface that crosses itself up to a point in its middle, where it has no normal
printf '{"taut": 1, "surfaces": [{"u": {"type": "bspline", "degree": 1, "knots": [0,0,1,2,2]}, "v": {"type": "bezier", "degree": 1},
    "points": [[[0,0,0],[0,1,0]],[[1,0,0.6],[1,1,0.8]],[[2,0,0],[2,1,0]]]}]}' > roof.json
refused 4 'crease' pattern roof.json --across v0,v1 --count 3 -o none.json
refused 4 'crease' pattern roof.json --line v=0.5 -o none.json
refused 4 'crease' pattern roof.json --across u0,u1 --count 2 -o none.json
run 0 pattern roof.json --line u=1 --quiet -o none.json
run 0 pattern roof.json --across v0,v1 --count 4 --quiet -o none.json
rm -f none.json
printf '{"taut": 1, "surfaces": [{"u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 1},
    "points": [[[1,-1,1],[-1,1,1]],[[0,-1,-1],[0,1,-1]],[[-1,-1,1],[1,1,1]]]}]}' > pinch.json
refused 4 'singular' pattern pinch.json --line u=0.5 -o none.json
refused 1 'folds' pattern pinch.json --line v=0.5 -o none.json

# Seams of other rules.
run 0 pattern surface.json --line u=0.5 --geodesic "v0:0.75 0.8,1" --marks 0.3 --quiet -o rules.json -o rules.dxf
contains rules.json '"kind": "line"'
run 0 certify rules.json
run 0 pattern surface.json --radial u1 --count 3 --quiet -o radial.json
refused 2 'value --geodesic' pattern surface.json --geodesic "v0:0.75" -o none.json
refused 2 'value --line' pattern surface.json --line w=1 -o none.json
refused 2 'value --radial' pattern surface.json --across v0,v1 --radial v0 --count 2 -o none.json
refused 2 'outside' pattern surface.json --line u=3 -o none.json
refused 4 'crossing' pattern surface.json --line u=0.5 --line v=0.5 -o none.json
refused 4 'shape' pattern surface.json --geodesic "0.5,0 1,0.5" -o none.json

# A seam with an allowance of its own, other on its right than on its left.
sed 's/"allowance": {/"allowance": { "S2": [0.04, 0.01],/' sail.json > own.json
run 0 make own.json --quiet -o own-made.json -o own.dxf -o own.svg
run 0 certify own-made.json own.json
run 1 certify own-made.json sail.json
contains err.txt 'allowance +DOES NOT HOLD'
sed 's/"S2"/"S9"/' own.json > none-own.json
refused 3 'allowance /allowance/S9' make none-own.json -o none.json

# For prints: no drawing to cut by.
"$TAUT" example pattern-sphere | sed 's/"seams"/"flatten": "conformal", "seams"/' > print.json
run 0 make print.json --quiet -o print-made.json -o print.svg
run 0 certify print-made.json print.json
contains err.txt 'conformal +holds'
run 0 certify print-made.json
refused 4 'no-drawing /details/flatten' convert print-made.json -o none.dxf
sed 's/"conformal"/"even"/' print.json > none-print.json
refused 3 'name /flatten' make none-print.json -o none.json

# Drawings, as another program reads them.
if python_with ezdxf; then
    for name in made own; do
        [ $name = made ] && model=made.json || model=own-made.json
        "$PYTHON" "$SOURCE/tests/cli/read_cloth.py" $model $name.dxf $name.svg > read.txt || complain "$name: $(cat read.txt)"
    done
fi
absent none.json

finish
