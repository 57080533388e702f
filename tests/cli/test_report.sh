# test_report.sh -- the report for people: names of corners, words that mean one thing, the verdict, --quiet; what a file lacks.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example film-sail > sail.json
run 0 make sail.json -o form.json -o form.step -o form.svg --reactions
contains err.txt '^  each cable +edge u0 force 2 length [0-9.]+ (mm|cm|m)$'
[ "$(grep -c '^  cables ' err.txt)" = 1 ] || complain "cables means two things: $(grep '^  cables ' err.txt)"
for corner in u1v0 u0v1 u1v1; do
    contains err.txt "^ +$corner: -?[0-9.]+, -?[0-9.]+, -?[0-9.]+$"
done
contains err.txt '^  forces on supports +u0v0: 2\.4918, 2\.4918, -1\.8283$' # later digits are the net's
contains err.txt '^  lowest eigenvalue +1\.416$'
contains err.txt '^  mean curvature +[0-9.e-]+$' # times the size
contains err.txt '^  certificate +holds: all 6 claims$'
contains form.svg 'reactions: as the cables pull at the supports'
run 0 make sail.json --quiet -o bare.svg
run 0 make sail.json --quiet -o net.svg --show-net
[ "$(wc -c < net.svg)" -gt "$(($(wc -c < bare.svg) + 5000))" ] || complain "the net of a sail hides it"

# A STEP file has no certificate and no witness, and its certificate says what is missing.
run 0 certify form.json sail.json
contains err.txt '^  certificate +holds: all 6 claims$'
if grep -q note err.txt; then complain "a model of ours lacks something: $(cat err.txt)"; fi
run 0 certify form.step sail.json
contains err.txt '^taut: form\.step: note: .*certificate.*witness'
contains err.txt '^  certificate +holds: 5 of 6 claims; undecided: least$'
run 0 certify form.step sail.json --json
[ ! -s err.txt ] || complain "--json has words for people: $(cat err.txt)"

# --quiet: nothing where it holds, one line where it does not.
run 0 certify --quiet form.json sail.json
[ ! -s err.txt ] && [ ! -s out.txt ] || complain "certify --quiet is not quiet: $(cat err.txt)"
sed 's/-1, -1, 0\.5/-1, -1, 0.6/' sail.json > other.json
run 1 certify form.json other.json --quiet
[ "$(wc -l < err.txt)" = 1 ] || complain "certify --quiet: $(cat err.txt)"
contains err.txt 'certificate +DOES NOT HOLD: [0-9]+ of 6 claims; false: .*held'
run 0 make "$SOURCE/examples/bonnet-enneper.json" --quiet -o exact.json
run 0 convert exact.json --tolerance 1e-4 -o near.json
contains err.txt '^near\.json, '
run 0 convert exact.json --tolerance 1e-4 -o near.json --quiet
[ ! -s err.txt ] || complain "convert --quiet is not quiet: $(cat err.txt)"

# Before anything is made: a folder that is not there, an ending that taut does not write.
refused 5 'write nodir/a\.step' make sail.json -o nodir/a.step
contains err.txt 'there is no folder nodir/'
refused 5 'write nodir/r\.json' make sail.json -o a.json --report nodir/r.json
absent a.json
refused 2 'format x\.JPG' convert form.json -o x.JPG
contains err.txt 'a picture is \.png, \.svg or \.pdf'

# What a sail is where the document does not say it: the tension, edges that are left out, corners round the film.
run 0 make sail.json -o form.json
contains err.txt '^  tension +1$'
if grep -q -e notes -e 'held straight' err.txt; then complain "a sail has notes: $(cat err.txt)"; fi
"$TAUT" example film-tent | "$TAUT" make - > /dev/null 2> err.txt
contains err.txt '^  tension +1$'
sed 's/, "v1": { "cable": { "force": 2 } }//' sail.json > straight.json
run 0 make straight.json -o straight-made.json
contains err.txt '^  held straight +v1$'
sed -e 's/u0v1/there/; s/u1v1/u0v1/; s/there/u1v1/; s/"force": 2/"force": 4/g' sail.json > tie.json
run 0 make tie.json -o tie-made.json
contains err.txt '^  notes +edges u0 and u1 cross: exchange corners u0v1 and u1v1'
run 0 certify tie-made.json tie.json
few='{ "type": "bspline", "degree": 2, "count": 6 }'
sed "s/\"force\": 4/\"force\": 2/g; s/\"corners\"/\"u\": $few, \"v\": $few, &/" tie.json > weak.json
refused 4 'cable-too-weak /edges/u0/cable' make weak.json
contains err.txt 'film of tension 1: .*edges u0 and u1 cross: exchange corners u0v1 and u1v1'

# Slips of newcomers: each has one line that says what to write.
sed 's/"u0": { "cable": { "force": 2 } }/"u0": { "force": 2 }/' sail.json > slip.json
refused 3 'unknown-member /edges/u0/force found null expected .*cable.*' make slip.json
contains err.txt 'inside it: \{ .*cable.*: \{ .*force'
sed 's/"u1v1"/"B"/' sail.json > slip.json
refused 3 'unknown-member /corners/B' make slip.json
contains err.txt 'u0v0.*u1v0.*u0v1.*u1v1'
sed 's/, "u1v1": \[[^]]*\]//' sail.json > slip.json
refused 4 'no-corner /corners/u1v1' make slip.json
contains err.txt 'corner u1v1 has no place.*hold it \(.*\[x, y, z\]\)'
sed 's/-1, -1, 0\.5/-1, -1, 0,5/' sail.json > slip.json
refused 3 'type /corners/u0v0 found null expected a point \[x, y, z\]' make slip.json
contains err.txt '1\.5, not 1,5'
sed '0,/"force": 2/s//"force": 2,5/' sail.json > slip.json
refused 3 'syntax slip\.json:5:44' make slip.json
contains err.txt '1\.5, not 1,5'
echo '{ "taut": 1, "construct": "plateau", "curves": [] }' > slip.json
refused 3 'type /curves found null expected an object with .*u0.*, .*v1.*' make slip.json

# Lengths have their unit, lists that hold nothing have no line, and a word of a setting has no unit.
"$TAUT" example pipe-run-wall > wall.json
run 0 make wall.json -o wall-made.json
contains err.txt '^  wall +2\.6 mm$'
contains err.txt '^  elbow +arc$'
"$TAUT" example film-bubbles > bubbles.json
run 0 make bubbles.json -o bubbles-made.json
contains err.txt '^  volumes +0\.25, 0\.1 mm\^3$'
if grep -E '^  (each cable|lengths|tensions|forces on supports)' err.txt; then complain "a line for a list that holds nothing"; fi
finish
