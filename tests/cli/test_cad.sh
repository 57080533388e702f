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
    "$helper" --version | grep -q '^taut-cad, protocol 5, OpenCASCADE [0-9]' || complain "$helper says no version"
    "$helper" model.igs > /dev/null 2>&1 && complain "$helper takes an argument"
fi
finish
