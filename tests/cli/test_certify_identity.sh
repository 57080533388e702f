# test_certify_identity.sh -- every claim is about named surfaces and curves: anything beside them is counted or listed.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tests/cli/certify_identity.py" || complain "what certificates are about"
finish
