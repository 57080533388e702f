# test_bindings.sh -- a binding without headers, by Python's ctypes (test_bindings.py).
. "$SOURCE/tests/cli/cli.sh"
python_with ctypes || skip python3 'tools/deps.sh test'
"$PYTHON" "$SOURCE/tests/bindings/test_bindings.py" "$TAUT_LIBRARY" || complain "the binding"
finish
