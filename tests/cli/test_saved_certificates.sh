# test_saved_certificates.sh -- what a file says was proved is proved again before a page or a figure shows it, or told as saved.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example dirichlet-bicubic > problem.json
run 0 make problem.json --quiet -o model.json -o fresh.html -o fresh.svg
# A point inside is moved by hand; its certificate still says that all holds.
python_with json || skip Python 'tools/deps.sh test'
"$PYTHON" - <<'PY'
import json
model = json.load(open("model.json"))
model["surfaces"][0]["points"][1][1][2] += 0.3
json.dump(model, open("moved.json", "w"))
PY
contains moved.json '"holds": true'
run 1 certify moved.json

for file in view convert; do
    run 0 $file moved.json -o moved.html
    contains err.txt 'moved.json: warning: not all claims hold: stationary'
    contains moved.html '"holds": false'
done
run 0 convert moved.json -o moved.svg --json # a program is told, too
[ "$(cat err.txt)" = '{ "warnings": [ { "where": "moved.json", "message": "not all claims hold: stationary" } ] }' ] || complain "--json: $(cat err.txt)"
run 0 convert moved.json -o moved.svg
contains err.txt 'not all claims hold: stationary'
contains moved.svg 'not all claims hold'
for ending in json step stl obj glb vtu; do # into every format; what JSON keeps is what was found
    run 0 convert moved.json -o copy.$ending
    contains err.txt 'moved.json: warning: not all claims hold: stationary'
done
contains copy.json '"holds": false'
run 1 certify copy.json
run 0 convert model.json -o copy.json -o copy.stl # one that holds is copied bit by bit
[ ! -s err.txt ] || complain "a copy warns: $(cat err.txt)"
cmp -s copy.json model.json || complain 'a copy differs'

# Unchanged, it holds again; what needs the problem to be proved is marked, by number.
run 0 view model.json -o again.html
[ ! -s err.txt ] || complain "an honest model warns: $(cat err.txt)"
contains again.html '"saved": \[[0-9]+\]'
! grep -q '"saved":' fresh.html || complain 'what was just proved is told as saved'
run 0 convert model.json -o again.svg
cmp -s again.svg fresh.svg || complain 'a figure proved again differs from the first one'

# One that cannot be proved without its problem says so.
"$TAUT" example dirichlet-mast > problem.json
run 0 make problem.json --quiet -o model.json
run 0 view model.json -o saved.html
contains err.txt 'warning: the certificate is shown as saved, not proved again: the model does not say which points were known'
contains saved.html '"saved": \[0, 1, 2\]'
run 0 convert model.json -o saved.svg
contains saved.svg 'certificate as saved, not proved again'
run 0 convert model.json -o copy.json
contains err.txt 'warning: the certificate is kept as saved, not proved again: the model does not say which points were known'
cmp -s copy.json model.json || complain 'a copy of what cannot be proved differs'
run 0 convert model.json -o copy.step # no format says a certificate
[ ! -s err.txt ] || complain "STEP: $(cat err.txt)"
run 0 view model.json --json -o saved.html
contains err.txt '^\{ "warnings": \[ \{ "where": "model.json", "message": "the certificate is shown as saved, not proved again'
[ "$(wc -l < err.txt)" = 1 ] || complain "not one line: $(cat err.txt)"

finish
