# test_certify.sh -- models that were changed by hand in any place are judged or refused with one line, never worse.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
each=30
grep -q __asan_init "$TAUT" && each=8
"$PYTHON" "$SOURCE/tests/cli/certify_changed.py" $each || complain "models that were changed"
finish
