# test_watch.sh -- make --watch makes again when the file is saved, goes on after a document that is wrong, and ends with 130.
. "$SOURCE/tests/cli/cli.sh"

refused 2 'operand' make --watch - -o out.json
refused 2 'option' make --watch problem.json
refused 2 'option' make --watch --lines problem.jsonl -o out.jsonl
refused 5 'read' make --watch missing.json -o out.json # saving cannot help: it is not there

# A condition that comes true, or a minute of waiting on a machine that does nothing.
await() {
    tries=0
    until eval "$1"; do
        tries=$((tries + 1))
        [ $tries -lt 600 ] || { complain "never so: $1; $(cat said.txt)"; return; }
        sleep 0.1
    done
}

height() { sed -n 's/.*\[0, 0, \(-\{0,1\}[0-9.]*\)\].*/\1/p' model.json 2> /dev/null; }
document() { # document HEIGHT: of the middles of the edges
    echo "{ \"taut\": 1, \"construct\": \"dirichlet\", \"u\": { \"type\": \"bezier\", \"degree\": 2 },
        \"v\": { \"type\": \"bezier\", \"degree\": 2 }, \"points\": [[[-1, -1, 0], [-1, 0, $1], [-1, 1, 0]],
        [[0, -1, $1], null, [0, 1, $1]], [[1, -1, 0], [1, 0, $1], [1, 1, 0]]] }"
}

document 1 > problem.json
# In a group of its own, with the interrupt as a terminal sends it: a shell ignores it for what it puts in the background.
python_with signal || skip Python 'tools/deps.sh test'
cat > start.py <<'PY'
import os, signal, sys
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])
PY
"$PYTHON" start.py "$TAUT" make --watch problem.json -o model.json 2> said.txt &
child=$!
await '[ "$(grep -c "^taut: watching" said.txt)" = 1 ]'
[ "$(height)" = -0.5 ] || complain "made first: $(height)"
document 2 > next.json && mv next.json problem.json # as editors save
await '[ "$(grep -c "^taut: watching" said.txt)" = 2 ]'
[ "$(height)" = -1 ] || complain "saved: $(height)"
echo '{ "taut": 1, ' > problem.json
await 'grep -q "see: taut help syntax" said.txt'
[ "$(height)" = -1 ] || complain "a document that is wrong changed the model: $(height)"
document 4 > problem.json
await '[ "$(grep -c "^taut: watching" said.txt)" = 4 ]'
[ "$(height)" = -2 ] || complain "after one that was wrong: $(height)"
kill -INT $child
wait $child
code=$?
[ $code = 130 ] || complain "interrupted: exit $code"
absent next.json
finish
