# test_certify_refusals.sh -- certifying models that other hands have changed: what is missing or wrong is refused by its place,
# what can be judged is judged, claim by claim.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tests/cli/certify_refusals.py" || complain "models that were changed"
finish
