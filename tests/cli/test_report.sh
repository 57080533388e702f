# test_report.sh -- the report for people: names of corners, words that mean one thing, the verdict, --quiet; what a file lacks.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example film-sail > sail.json
run 0 make sail.json -o form.json -o form.step -o form.svg --reactions
contains err.txt '^  each cable +edge u0 force 2 length '
[ "$(grep -c '^  cables ' err.txt)" = 1 ] || complain "cables means two things: $(grep '^  cables ' err.txt)"
for corner in u1v0 u0v1 u1v1; do
    contains err.txt "^ +$corner: -?[0-9.]+, -?[0-9.]+, -?[0-9.]+$"
done
contains err.txt '^  forces on supports +u0v0: 2\.4917657'
contains err.txt '^  mean curvature +[0-9.e-]+$' # times the size
contains err.txt '^  certificate +holds: all 6 claims$'
contains form.svg 'reactions: as the cables pull at the supports'

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
finish
