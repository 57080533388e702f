# test_claims.sh -- docs/certificate.md names every claim that an example carries, with its kind.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tools/claims_table.py" "$TAUT" --check || complain "the table of claims is out of date: tools/claims_table.py TAUT --write"
finish
