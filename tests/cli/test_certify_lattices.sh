# test_certify_lattices.sh -- nets of surfaces that ask for much hold, and curves that close have each crossing once.
. "$SOURCE/tests/cli/cli.sh"
python_with json || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tests/cli/certify_nets.py" lattices || complain "nets that were hard to make"
finish
