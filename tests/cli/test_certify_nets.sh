# test_certify_nets.sh -- nets and patterns whose details lie: the claim that speaks of them does not hold.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tests/cli/certify_nets.py" models || complain "nets and patterns that were changed"
finish
