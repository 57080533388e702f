# test_cad.sh -- STEP and IGES: out and back the same numbers; where OpenCASCADE was not there at build time, STEP goes out
# all the same, and for the rest there is word of what to install.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example dirichlet-tent > problem.json
run 0 make problem.json --quiet -o model.json
points() { # points FILE: the coordinates of its first surface, one a line
    tr -d ' \n' < "$1" | sed 's/.*"points":\[\[\[//; s/\]\]\].*//' | tr '[],' '\n\n\n' | grep .
}
points model.json > here.txt
for file in model.step model.igs; do
    "$TAUT" convert model.json -o $file 2> err.txt
    code=$?
    if [ $file = model.igs ] && [ $code = 5 ] && grep -q install err.txt; then
        absent $file
        continue
    fi
    [ $code = 0 ] || complain "convert to $file: exit $code: $(cat err.txt)"
    "$TAUT" convert $file -o back.json 2> err.txt
    code=$?
    if [ $file = model.step ] && [ $code = 5 ] && grep -q install err.txt; then
        absent back.json
        continue
    fi
    [ $code = 0 ] || complain "convert from $file: exit $code: $(cat err.txt)"
    points back.json > there.txt
    cmp -s here.txt there.txt || complain "$file does not give the same points back"
    sed 's/"name": "[^"]*"/"name": "a\\nb"/' model.json > named.json
    run 0 convert named.json -o named.${file#model.}
    run 0 convert named.${file#model.} -o never.json
    rm never.json
    head -c 2000 $file > cut.${file#model.}
    run 3 convert cut.${file#model.} -o never.json
    absent never.json
done
# What is started as taut-cad is told when it is none, and nothing is written; so where its libraries find no memory.
helper=$(dirname "$TAUT")/../libexec/taut-cad
if [ -e "$helper" ]; then
    printf '#!/bin/sh\nulimit -v 40000\nexec %s\n' "$helper" > poor
    printf '#!/bin/sh\nkill -9 $$\n' > killed
    chmod +x poor killed
    for program in "$PWD/poor" /bin/cat /bin/false "$TAUT" "$PWD/model.json" nowhere; do
        export TAUT_CAD="$program"
        refused 5 'helper|not-installed' convert model.igs -o never.json
        refused 5 'helper|not-installed' convert model.json -o never.igs
        contains err.txt "$program"
        absent never.json never.igs
    done
    TAUT_CAD=$PWD/killed
    refused 3 'library' convert model.igs -o never.json
    refused 6 'library' convert model.json -o never.igs
    absent never.json never.igs
    TAUT_CAD=
    run 0 convert model.igs -o back.json # nothing said
    # colours of the file that a model came from stay with it: in STEP and back, meshes, figures and the page
    "$TAUT" example harmonic-neighbour > problem.json
    run 0 make problem.json --quiet -o plain.json
    python3 - <<'PY' || complain "colours: not set"
import json
model = json.load(open("plain.json"))
model["details"] = {"colours": ["#12ab34", "#fedcba"][:len(model["surfaces"])]}
json.dump(model, open("own.json", "w"))
PY
    run 0 convert own.json -o own.step -o own.3mf -o own.svg -o own.html -o own.glb
    run 0 convert own.step -o again.json
    contains again.json '"#12ab34"'
    contains again.json '"#fedcba"'
    contains own.svg '#12ab34'
    contains own.html "\"colour\": *$((16777216 + 0x12ab34))"
    unzip -p own.3mf 3D/3dmodel.model > own.xml
    contains own.xml '#12AB34'
    run 0 convert plain.json -o plain.step
    run 0 convert plain.step -o again.json
    ! grep -q colours again.json || complain "colours of taut's own are said"
    # numbers of three-digit exponents, below 0 too
    line='{ "type": "bezier", "degree": 1 }'
    echo "{ \"taut\": 1, \"surfaces\": [ { \"u\": $line, \"v\": $line, \"points\":
        [ [ [0, 0, 0], [0, 1, 0] ], [ [1, 0, 0], [-1.2345e-178, 1, -1.5e-99] ] ] } ] }" > small.json
    run 0 convert small.json -o small.igs
    run 0 convert small.igs -o back.json
    contains back.json '1[.]2345e-178'
    contains back.json '1[.]5e-99'
    # several surfaces and curves are one group, under the name of the construction
    "$TAUT" example pipe-elbow > problem.json
    run 0 make problem.json --quiet -o pipe.igs
    contains pipe.igs '^ +402 '
    contains pipe.igs '4Hpipe'
    ! grep -q '^ *402 ' model.igs || complain "a group of one"
    run 0 convert pipe.igs -o back.json
    [ "$(grep -c '"name": "' back.json)" = 4 ] || complain "names out of a group: $(grep '"name"' back.json)"
    # a face that cannot be had is named and left out, with what it is a part of only; the rest of the file is read
    "$TAUT" example pipe-run-coil > problem.json
    run 0 make problem.json --quiet -o coil.step
    run 0 convert coil.step -o coil.json # its coils are four faces each there, and one surface each
    surfaces=$(sed '/"curves"/,$ d' coil.json | grep -c '"name"')
    sed 's/^\(#[0-9]*\)=PLANE(.*/\1=LEAF_SURFACE(1.);/' coil.step > kind.step
    run 0 convert kind.step -o kind.json
    contains err.txt 'face #[0-9]* of the file, "cap1", is left out: entity #[0-9]* is broken: its surface is of a kind that OpenCASCADE does not know'
    [ "$(grep -c 'is left out' err.txt)" = 2 ] || complain "planes: $(cat err.txt)"
    sed '/"curves"/,$ d' kind.json | grep -c '"name"' > count.txt
    [ "$(cat count.txt)" = $((surfaces - 2)) ] || complain "without planes: $(cat count.txt) of $surfaces surfaces"
    python3 - <<'PY' || complain 'multiplicities: not set'
import re
text = open("coil.step").read()
made, count = re.subn(r"(B_SPLINE_SURFACE_WITH_KNOTS\s*\(\()5,", r"\g<1>6,", text, count=1)
open("often.step", "w").write(made)
raise SystemExit(count != 1)
PY
    run 0 convert often.step -o often.json
    contains err.txt 'is left out: OpenCASCADE makes no spline of entity #[0-9]*: its degrees, knots, multiplicities and points do not agree'
    [ "$(grep -c 'is left out' err.txt)" = 1 ] || complain "multiplicities: $(cat err.txt)"
    sed '/"curves"/,$ d' often.json | grep -c '"name"' > count.txt
    [ "$(cat count.txt)" = "$surfaces" ] || complain "without one: $(cat count.txt) of $surfaces surfaces" # three quarters of one are there
    # what is a part of no face is none to be done without
    sed 's/^\(#[0-9]*=MANIFOLD_SOLID_BREP([^,]*,\)#[0-9]*/\1#1/' coil.step > body.step
    run 3 convert body.step -o body.json
    contains err.txt 'taut help broken'
    absent body.json
    # a cone of FreeCAD (Part.makeCone(10, 4, 20)), whose face lies by a matrix and its ends by none: one body, no assembly
    run 0 convert "$SOURCE/tests/cli/cone.igs" -o cone.json
    ! grep -q '"parts"' cone.json || complain 'a cone is an assembly'
    run 0 convert cone.json -o cone.step
    contains cone.step 'MANIFOLD_SOLID_BREP'
    # a box of FreeCAD turned in space, 10 by 20 by 30: its faces lie askew in their planes, whose directions OpenCASCADE chooses
    run 0 convert "$SOURCE/tests/cli/box.igs" -o box.json -o box.step
    [ ! -s err.txt ] || complain "a box: $(cat err.txt)"
    contains box.step 'MANIFOLD_SOLID_BREP'
    run 0 measure box.json --json --grid 2
    python3 - <<'PY' || complain 'the box of FreeCAD has other faces'
import json, math
model, measured = json.load(open("box.json")), json.load(open("out.txt"))["surfaces"]
assert [s["u"]["degree"] for s in model["surfaces"]] == [1] * 6
for area, expected in zip(sorted(s["area"] for s in measured), (200, 200, 300, 300, 600, 600)):
    assert abs(area / expected - 1) < 1e-9, (area, expected)
corners = {tuple(round(c, 6) for c in p) for s in model["surfaces"] for line in s["points"] for p in line}
assert len(corners) == 8 and abs(max(math.dist(a, b) for a in corners for b in corners) - math.sqrt(1400)) < 1e-5
PY
    # plane faces of FreeCAD: four corners, a corner inwards, five corners, a corner that does not turn, a hole
    run 4 convert "$SOURCE/tests/cli/quads.step" -o quads.json
    run 0 convert "$SOURCE/tests/cli/quads.step" --untrim -o quads.json
    said=$(grep -o 'surface [0-9]' err.txt | tr -d '\n')
    [ "$said" = 'surface 2surface 3surface 5' ] || complain "trimmed: $(cat err.txt)"
    run 0 measure quads.json --json --grid 2
    python3 - <<'PY' || complain 'faces of four corners have other areas'
import json
areas = [s["area"] for s in json.load(open("out.txt"))["surfaces"]]
assert abs(areas[0] - 7.5) < 1e-9 and abs(areas[3] - 8) < 1e-9, areas
PY
    # the same in IGES: what cannot be read is named, the rest is read; nothing is dropped in silence
    run 0 make problem.json --quiet -o coil.igs
    left_out() { # left_out FACES PATTERN TYPE NTH CHANGE...: so many of the nine faces are read, and this is said once
        faces=$1 pattern=$2
        shift 2
        python3 "$SOURCE/tests/cli/edit_iges.py" "${from:-coil.igs}" broken.igs "$@" || complain "$*: not changed"
        run 0 convert broken.igs -o broken.json
        [ "$(grep -c warning err.txt)" = 1 ] && grep -Eq "$pattern" err.txt || complain "$*: $(cat err.txt)"
        sed '/"curves"/,$ d' broken.json | grep -c '"name"' > count.txt
        [ "$(cat count.txt)" = "$faces" ] || complain "$*: $(cat count.txt) faces, expected $faces"
    }
    left_out 8 'face D3 of the file, "pipe1", is left out: OpenCASCADE makes no spline of it' 128 0 15=0.1
    left_out 8 'entity D3 of the file, "", is left out: OpenCASCADE makes nothing of entities of type 599' 128 0 type=599
    left_out 8 'face D3 of the file, "", is left out: entity D3 is broken' 128 0 cut=40
    left_out 8 'face D3 of the file, "", is left out: entity D3 is broken' 128 0 2=-8
    left_out 9 'curve D39 of the file, "axis-pipe1", is left out: OpenCASCADE makes no spline of it' 126 0 8=9
    left_out 9 'entity D1 is broken: .*; the file is read without it' 406 0 type=212
    python3 "$SOURCE/tests/cli/edit_iges.py" model.igs broken.igs 128 0 2=-8 || complain 'not changed'
    run 3 convert broken.igs -o never.json
    contains err.txt 'entity D[0-9]* is broken.*taut help broken'
    absent never.json
    # a unit that documents do not have: lengths are converted to mm, which is said
    run 0 make "$SOURCE/examples/bonnet-enneper.json" --quiet -o model.step -o small.igs
    sed 's/SI_UNIT(\.MILLI\.,\.METRE\.)/SI_UNIT(.KILO.,.METRE.)/' model.step > large.step
    sed 's/,2,2HMM,/,7,2HKM,/' small.igs > large.igs
    before=$("$TAUT" measure model.step | sed -n 's/^area *\([0-9.e+]*\) mm^2$/\1/p' | head -n 1)
    for file in large.step large.igs; do
        run 0 measure $file
        contains err.txt 'the file is in units of (kilometre|KM): its lengths are converted, to be in mm'
        after=$(sed -n 's/^area *\([0-9.e+]*\) mm^2$/\1/p' out.txt | head -n 1)
        awk "BEGIN { d = ($after) / (($before) * 1e12) - 1; exit !(d < 1e-9 && d > -1e-9) }" || complain "$file: $after mm^2, $before in mm"
    done
    # the one product of a file keeps its name, in STEP, in IGES and by way of JSON
    sed "s/=PRODUCT('pipe','pipe'/=PRODUCT('Leitung 7','Leitung 7'/" coil.step > named.step
    run 0 convert named.step -o named.json
    contains named.json '"product": "Leitung 7"'
    run 0 convert named.json -o named2.step -o named.igs
    contains named2.step "=PRODUCT.'Leitung 7'"
    contains named.igs '9HLeitung 7'
    # its limits are set before it reads a byte of the request
    mkfifo request answer
    cat answer > hello.txt &
    "$helper" < request > answer &
    exec 7> request
    for i in $(seq 1000); do
        [ -s hello.txt ] && break
        sleep 0.01
    done
    grep -Eq '^Max cpu time +20 ' /proc/$!/limits || complain "without a request: $(grep -E 'cpu|address' /proc/$!/limits)"
    exec 7>&-
    wait
    grep -aq 'the request of taut-cad is cut off' hello.txt || complain "$helper takes no request for one"
    "$helper" --version | grep -q '^taut-cad, protocol 6, OpenCASCADE [0-9]' || complain "$helper says no version"
    "$helper" model.igs > /dev/null 2>&1 && complain "$helper takes an argument"
fi
finish
