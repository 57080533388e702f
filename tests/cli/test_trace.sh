# test_trace.sh -- nets from the command line: by words and by document, of files, with what is wrong told.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example trace-bonnet > net.json
run 0 make net.json -o made.json -o made.svg -o made.step --report report.json
for claim in on-surface asymptotic length ends nodes right-angled complete pattern identity surface; do
    contains err.txt "$claim +holds"
done
contains made.json '"node": "A1B1"'
contains made.json '"ended": \["edge v0", "edge v1"\]'
run 0 certify made.json net.json
run 0 certify made.json

# The words of the command are the same document.
"$TAUT" example bonnet-roof > roof.json
run 0 trace roof.json --net asymptotic --cells 5 --quiet -o words.json
echo '{ "taut": 1, "trace": "asymptotic", "of": "roof.json", "seeds": [{ "cells": 5 }] }' > document.json
run 0 trace document.json --quiet -o document-made.json
cmp words.json document-made.json || complain "the words make another net than the document"
run 0 make document.json --quiet -o by-make.json
cmp words.json by-make.json || complain "make makes another net than trace"
run 0 trace words.json --net principal --family max --edge v0:3 --by length --quiet -o max.json
contains max.json '"name": "A3"'
grep -q '"name": "B1"' max.json && complain "a family was traced that was not asked for"
run 0 trace words.json --net geodesic --seed 0,0.2 --direction 1,0.5 --both --max-length 0.5 --quiet -o geodesic.json
contains geodesic.json '"ended": \["length", "length"\]'
# One way from a place that has no exact double.
run 0 trace words.json --net geodesic --seed 0.1,0.3 --direction 1,0 --quiet -o one-way.json
contains one-way.json '"ended": \["seed", "edge u1"\]'
run 0 trace words.json --net geodesic --seed -0.5,-0.5 --to 0.4,0.5 --quiet -o between.json
contains between.json '"ended": \["seed", "seed"\]'
run 0 certify between.json
refused 2 'value --to x' trace words.json --net geodesic --seed 0,0 --to x -o none.json
refused 2 'conflict' trace words.json --net geodesic --seed 0,0 --to 0.1,0.1 --direction 1,0 -o none.json
refused 2 'net' trace words.json --net asymptotic --seed 0,0 --to 0.1,0.1 -o none.json
# The outer equator of a torus, beyond where its neighbours meet again.
"$TAUT" example trace-torus > torus.json
run 0 make torus.json --quiet -o torus-made.json
run 0 trace torus-made.json --net geodesic --seed 0,0.5 --to 0.3,0.5 --quiet -o equator.json
contains equator.json 'G1 is a geodesic, but not the shortest way'
run 0 trace torus-made.json --net geodesic --seed 0,0.5 --to 0.2,0.5 --quiet -o equator.json
grep -q 'not the shortest' equator.json && complain "a shortest way was told not to be"
run 0 trace words.json --net isoparametric --line -0.5,-0.5:0.5,0.5:3 --quiet -o iso.json
run 0 trace words.json --net asymptotic --cell 0.9 --quiet -o cell.json

run 0 schema trace
contains out.txt '#/\$defs/trace'

# Laths: the words and the document, and pictures as wide as they are asked for.
run 0 trace roof.json --net asymptotic --cells 3 --strip standing --width 0.02 --thickness 0.001 --material steel-s235 --quiet -o laths.json
contains laths.json '"slot_twisted": 1'
contains laths.json '"cut_length"'
echo '{ "taut": 1, "trace": "asymptotic", "of": "roof.json", "seeds": [{ "cells": 3 }], "laths": { "strip": "standing", "width": 0.02, "thickness": 0.001,
    "material": { "E": 210000, "G": 81000, "strength": 235 }, "cut": "mean" } }' > with-laths.json
run 0 make with-laths.json --quiet -o with-laths-made.json
cmp laths.json with-laths-made.json || complain "the words make other laths than the document"
run 0 trace roof.json --net geodesic --seed 0,0.2 --direction 1,0.5 --strip plank --cut axis --play 0 --quiet -o plank.json
contains plank.json '"pattern_end"'
run 0 trace roof.json --net asymptotic --cells 2 --width 64 --quiet -o narrow.svg
refused 2 'value --width 3.5' trace roof.json --net asymptotic --width 3.5 -o none.json
refused 2 'value --width x' trace roof.json --net asymptotic --strip standing --width x -o none.json
refused 2 'option' trace roof.json --net asymptotic --thickness 1 -o none.json
refused 2 'width' trace roof.json --net asymptotic --strip standing --width -1 -o none.json
for wrong in 'width /laths/width: "strip": "standing", "width": 0' 'value /laths/thickness: "strip": "standing", "thickness": -1' \
    'value /laths/play: "strip": "standing", "play": -1' 'material /laths/material: "strip": "plank", "material": "butter"' \
    'material /laths/material/G: "strip": "plank", "material": { "E": 1, "G": 0, "strength": 1 }' \
    'missing /laths/material/strength: "strip": "plank", "material": { "E": 1, "G": 1 }' 'missing /laths/strip: "width": 1' \
    'name /laths/strip: "strip": "lying"' \
    'name /laths/cut: "strip": "plank", "cut": "long"'; do
    echo "{ \"taut\": 1, \"trace\": \"asymptotic\", \"of\": \"roof.json\", \"laths\": { ${wrong#*: } } }" > wrong.json
    refused 3 "${wrong%%:*}" make wrong.json -o none.json --quiet
done
echo '{ "taut": 1, "trace": "asymptotic", "of": "roof.json", "seeds": [{ "cells": 5 }], "laths": { "strip": "standing", "width": 0.1, "thickness": 5 } }' > thick.json
refused 4 'slots /laths/thickness' make thick.json -o none.json --quiet

# Pieces to cut: on one sheet, on several with split laths, curved ones, and planks.
echo '{ "taut": 1, "unit": "m", "construct": "bonnet", "lambda": 0.29, "sign": "-", "alpha": 1.2, "beta": 0.9 }' > metres.json
run 0 trace metres.json --net asymptotic --cells 4 --strip standing --width 0.06 --thickness 0.0015 -o one.json -o one.dxf -o one.svg
contains err.txt 'pattern +holds \(exact\)'
run 0 certify one.json
run 0 trace metres.json --net asymptotic --cells 4 --strip standing --width 0.06 --thickness 0.0015 --sheet 1x0.3 --quiet -o several.json -o several.dxf -o several.svg
contains several.json '"name": "[AB][0-9]/2"'
run 0 trace metres.json --net principal --cells 3 --strip standing --width 0.06 --thickness 0.0015 --tolerance 1e-4 --quiet -o bent.json -o bent.dxf -o bent.svg
run 0 trace metres.json --net geodesic --seed 0,0.2 --direction 1,0.5 --both --seed 0.1,0.4 --strip plank --width 0.06 --quiet -o planks.json -o planks.dxf -o planks.svg
if python_with ezdxf; then
    for name in one several bent planks; do
        "$PYTHON" "$SOURCE/tests/cli/read_laths.py" $name.json $name.dxf $name.svg > $name.txt 2>&1 || complain "$name: $(cat $name.txt)"
    done
    contains one.txt '^SHEET 1$'
    contains several.txt '^SHEET [2-9]$'
    contains one.txt '^SLOT [0-9]+$'
    grep -q SLOT planks.txt && complain "planks have slots"
else
    missing ezdxf 'tools/deps.sh check'
fi
refused 4 'developable /laths/strip' trace metres.json --net asymptotic --cells 4 --strip envelope --width 0.06 -o none.json
run 0 trace metres.json --net geodesic --seed 0.5,0.3 --direction 1,0.3 --both --strip envelope --width 0.06 --quiet -o envelope.json -o envelope.dxf
refused 4 'sheet /sheet/size/0' trace metres.json --net asymptotic --cells 4 --strip standing --width 0.06 --thickness 0.0015 --sheet 0.2x1 -o none.json
refused 4 'sheet /sheet/size/1' trace metres.json --net asymptotic --cells 4 --strip standing --width 0.06 --sheet 3x0.05 -o none.json
refused 2 'value --sheet 3' trace metres.json --net asymptotic --strip standing --width 0.06 --sheet 3 -o none.json
refused 2 'missing' trace metres.json --net asymptotic --sheet 3x1 -o none.json

# What is wrong.
refused 2 'net' trace roof.json --net wavy -o none.json
refused 2 'edge' trace roof.json --net asymptotic --edge w0:3 -o none.json
refused 2 'count' trace roof.json --net asymptotic --edge v0:0 -o none.json
refused 2 'outside' trace roof.json --net asymptotic --seed 5,5 -o none.json
refused 2 'direction' trace roof.json --net geodesic --seed 0.5,0.3 -o none.json
refused 2 'direction' trace roof.json --net geodesic --seed 0.5,0.3 --direction 0,0 -o none.json
refused 2 'name' trace roof.json --net asymptotic --by eye -o none.json
for wrong in 'net /trace: "trace": "wavy"' 'edge /seeds/0/edge: "trace": "asymptotic", "seeds": [{ "edge": "w0", "count": 2 }]' \
    'count /seeds/0/count: "trace": "asymptotic", "seeds": [{ "edge": "v0", "count": 0 }]' 'count /seeds/0/cells: "trace": "asymptotic", "seeds": [{ "cells": 0 }]' \
    'conflict /seeds/0/at: "trace": "asymptotic", "seeds": [{ "at": [0, 0], "edge": "v0", "count": 2 }]' \
    'conflict /seeds/0/cells: "trace": "asymptotic", "seeds": [{ "cell": 1, "cells": 2 }]' \
    'direction /seeds/0: "trace": "geodesic", "seeds": [{ "at": [0, 0] }]' 'outside /seeds/0/at/0: "trace": "asymptotic", "seeds": [{ "at": [5, 0] }]'; do
    echo "{ \"taut\": 1, \"of\": \"roof.json\", ${wrong#*: } }" > wrong.json
    refused 3 "${wrong%%: *}" make wrong.json -o none.json --quiet
done
refused 2 'option' trace roof.json -o none.json
# a model, and a file of another program, without --net
run 0 make roof.json -o own-model.json -o own-model.step
for model in own-model.json own-model.step; do
    refused 2 'option' trace $model
    contains err.txt 'needs --net'
    refused 2 'option' pattern $model
    contains err.txt 'needs --across'
done
refused 2 'value --seed x' trace roof.json --net asymptotic --seed x -o none.json
refused 2 'value --edge v0' trace roof.json --net asymptotic --edge v0 -o none.json
refused 2 'value --line 0,0:1' trace roof.json --net asymptotic --line 0,0:1 -o none.json
refused 2 'family' trace roof.json --net asymptotic --family max -o none.json
refused 3 'no-such-object /surface' trace words.json --net asymptotic --surface nothing -o none.json
refused 5 '[a-z-]+' trace missing.json --net asymptotic -o none.json
absent none.json
echo '{ "taut": 1, "trace": "asymptotic", "of": "document.json" }' > nested.json
refused 3 'kind /of' make nested.json -o none.json --quiet
echo '{ "taut": 1, "trace": "asymptotic", "of": "self.json" }' > self.json
refused 3 'kind /of' make self.json -o none.json --quiet
refused 2 'net' trace roof.json --net asymptotic --panels -o none.json
run 0 trace roof.json --net asymptotic --cells 5 --untrim --quiet -o whole.json
cmp -s words.json whole.json || complain "--untrim changes a model that has no trimmed faces"
# the page tells how far laths are used, and colours those that are used too far in red (0xb3001b)
run 0 trace words.json --net asymptotic --cells 3 --strip standing --width 0.2 --thickness 0.02 --material steel-s235 --quiet -o used.html
contains used.html '"ink": 11730971'
# figures of a net name its nodes where there is room, each beside its point
run 0 trace words.json --net asymptotic --cells 3 --quiet -o nodes.svg -o nodes.json
"$PYTHON" - nodes.svg nodes.json <<'EOF' || complain "figures do not name the nodes"
import json, re, sys
figure, model = open(sys.argv[1]).read(), json.load(open(sys.argv[2]))
known = {node["node"] for node in model["details"]["nodes"]}
named = [name for name in re.findall(r">([^<>]*)</text>", figure) if re.fullmatch(r"A[0-9]+B[0-9]+", name)]
assert len(named) == len(set(named)) >= len(known) / 2 and set(named) <= known, (named, known)
EOF
# laths go to CAD and to meshes as strips, or as solids of their thickness
run 0 trace words.json --net asymptotic --cells 3 --strip standing --width 0.02 --thickness 0.002 --quiet -o laths.json -o strips.step -o strips.glb
run 0 trace words.json --net asymptotic --cells 3 --strip standing --width 0.02 --thickness 0.002 --solid --quiet -o solids.step -o solids.obj
contains strips.step 'A1-strip'
contains solids.step 'MANIFOLD_SOLID_BREP'
contains solids.obj 'A1-front'
run 0 convert laths.json --solid -o again.step
cmp -s solids.step again.step || complain "solids of a model that is read again are others"
# a page of a figure, and one of the sheets: a sheet is 1:1, 72 points an inch
if run 0 convert laths.json -o laths.pdf && command -v pdfinfo >/dev/null; then
    pdfinfo -f 1 -l 2 laths.pdf > pages.txt
    contains pages.txt 'Pages: *2$'
    "$PYTHON" - laths.json pages.txt <<'EOF' || complain "the second page is not as large as the sheets"
import json, re, sys
model = json.load(open(sys.argv[1]))
size = [{"mm": 1, "cm": 10, "m": 1000}[model["unit"]] * x for x in model["details"]["sheets"][0]["size"]]
page = re.search(r"Page +2 size: +([0-9.]+) x ([0-9.]+)", open(sys.argv[2]).read())
sys.exit(any(abs(float(page[i + 1]) - size[i] * 72 / 25.4) > 0.01 for i in range(2)))
EOF
fi
refused 4 'width' trace words.json --net asymptotic --cells 3 --solid -o none.step --quiet
refused 4 'missing' trace words.json --net asymptotic --cells 3 --strip standing --width 0.02 --solid -o none.step --quiet
absent none.step
run 0 trace words.json --net principal --cells 3 --panels --quiet -o panels.json
contains panels.json '"panel_count": [1-9]'
echo '{ "taut": 1, "trace": "asymptotic", "of": "roof.json", "unit": "ft" }' > foot.json
refused 3 'conflict /unit' make foot.json -o none.json --quiet
absent none.json

# curves that two seeds are on, and curves that come back to the edge that seeds them, are there once
printf '{ "taut": 1, "surfaces": [{ "u": { "type": "bezier", "degree": 1, "range": [-1, 1] }, "v": { "type": "bezier", "degree": 1, "range": [-1, 1] },
    "points": [[[-1,-1,1.1],[-1,1,-1.1]],[[1,-1,-1.1],[1,1,1.1]]] }] }' > saddle.json
printf '{ "taut": 1, "surfaces": [{ "u": { "type": "bezier", "degree": 3, "range": [-1, 1] }, "v": { "type": "bezier", "degree": 2, "range": [-1, 1] },
    "points": [[[-3,-3,54],[-3,0,-108],[-3,3,54]],[[-1,-3,54],[-1,0,0],[-1,3,54]],[[1,-3,-54],[1,0,0],[1,3,-54]],[[3,-3,-54],[3,0,108],[3,3,-54]]] }] }' > monkey.json
run 0 trace saddle.json --net asymptotic --seed .1,0 --cells 5 --quiet -o none.json
run 0 trace saddle.json --net asymptotic --seed 0,0 --edge v0:5 --by length --quiet -o none.json
run 0 trace monkey.json --net principal --edge u0:4 --quiet -o none.json
rm -f none.json
# a seed where K = 0 but for rounding: a curve that its steps lead nowhere is left out
"$TAUT" example trace-torus > torus.json
python3 - <<'END'
import json
torus = json.load(open("torus.json"))
for name, seed in (("rim", {"edge": "u0", "count": 1}), ("rims", {"edge": "u0", "count": 7})):
    json.dump(dict(torus, seeds=[seed]), open(name + ".json", "w"))
END
refused 4 'elliptic' make rim.json --quiet -o none.json
run 0 make rims.json --quiet -o rims-made.json
contains rims-made.json '"reason": "elliptic"'
# the same where steps are a little longer: from a place 4e-14 beside a circle with K = 0, on top of it to 1e-14
python3 -c 'import json; net = json.load(open("torus.json")); json.dump(dict(net, trace="asymptotic", seeds=[{"line": [[0.05, 0.1], [0.95, 0.9]], "count": 9}]), open("slanted.json", "w"))'
run 0 make slanted.json --quiet -o rims-made.json
contains rims-made.json '"reason": "elliptic"'
# lines that close at the seam they are seeded on end on the side that they come to
for seed in '"edge": "u0", "count": 3' '"cells": 8'; do
    python3 -c 'import json, sys; net = json.load(open("torus.json")); json.dump(dict(net, trace="principal", seeds=[json.loads("{" + sys.argv[1] + "}")]), open("rings.json", "w"))' "$seed"
    run 0 make rings.json --quiet -o rims-made.json
done
# a lattice goes on round a surface that closes, where what is opposite of its node is farther than a part: a torus, a pipe
python3 -c 'import json; net = json.load(open("torus.json")); json.dump(dict(net, trace="asymptotic", seeds=[{"cells": 6, "at": [0.1, 0.05]}]), open("round.json", "w"))'
run 0 make round.json --quiet -o rims-made.json
"$TAUT" example pipe-paper > pipe.json
run 0 make pipe.json --quiet -o pipe-made.json
run 0 trace pipe-made.json --surface blend --net isoparametric --cells 6 --quiet -o rims-made.json
# blends whose curvatures jump at the knot line that a middle curve runs on, and one that is parted against its own way
for pipe in pipe-cubic pipe-canal; do
    "$TAUT" example "$pipe" > pipe.json
    run 0 make pipe.json --quiet -o pipe-made.json
    run 0 trace pipe-made.json --surface blend --net principal --cells 6 --quiet -o rims-made.json
done
# a sail that is its own mirror image has its umbilics in each of its four corners
"$TAUT" example film-sail > sail.json
run 0 make sail.json --quiet -o sail-made.json
run 0 trace sail-made.json --net principal --cells 3 --quiet -o rims-made.json
python3 -c '
import json
at = [point["at"] for point in json.load(open("rims-made.json"))["details"]["singular_points"]]
quarters = [sum((u < 0.5) == left and (v < 0.5) == low for u, v in at) for left in (0, 1) for low in (0, 1)]
assert quarters[0] > 0 and quarters == 4 * quarters[:1], quarters' || complain "an umbilic of a sail is missing"

# Both curvatures vanish in the corners, and rounding turns the directions there over short spans: k_g of straight sides is seen as 5e-3.
"$TAUT" example film-schwarz-d | sed -e '/"images"/,$d' | sed '$ s/,$/}/' > corners.json
run 0 make corners.json --quiet -o corners-made.json
run 0 trace corners-made.json --net asymptotic --cells 6 --quiet -o rims-made.json
# what a document says is not said twice
refused 2 'option' trace torus.json --strip standing --width 0.05 -o none.json
refused 2 'option' trace torus.json --seed 0,0 -o none.json
refused 2 'option' trace torus.json --surface torus -o none.json
# pieces may touch
"$TAUT" example trace-bonnet > touching.json
python3 - <<'END'
import json
net = json.load(open("touching.json"))
json.dump(dict(net, sheet={"gap": 0}), open("touching.json", "w"))
END
run 0 make touching.json --quiet -o touching-made.json
# sheets of the length that the refusal names hold the longest piece
python3 -c 'import json; net = json.load(open("touching.json")); json.dump(dict(net, sheet={"size": [0.3, 0.3]}), open("short.json", "w"))'
"$TAUT" make short.json --quiet -o none.json 2> short.txt && complain "sheets that are too short are taken"
python3 - <<'END'
import json, re
net = json.load(open("short.json"))
longest = float(re.search(r"at least ([0-9.]+) long", open("short.txt").read())[1])
json.dump(dict(net, sheet={"size": [longest, 0.3]}), open("short.json", "w"))
END
run 0 make short.json --quiet -o touching-made.json
absent none.json

# A curve to a cusp, the last pieces of which are long and bent: they are cut as the others are.
"$TAUT" make "$SOURCE/examples/asymptotic-3.json" --quiet -o cusped.json # its own claim `regular` is false
echo '{ "taut": 1, "trace": "asymptotic", "of": "cusped.json", "seeds": [{ "at": [1, 0.2858395741179469], "family": "+" }] }' > to-cusp.json
run 0 make to-cusp.json --quiet -o to-cusp-made.json
contains to-cusp-made.json '"ended": \["parabolic", "edge u1"\]'

finish
