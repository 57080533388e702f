#!/bin/sh
# mutants.sh [PATTERN | --check [ROOT] | --compile BUILD | --tidy] -- shows that the tests notice when the code is wrong: see mutants.py.
exec python3 -B "$(dirname "$0")/mutants.py" "$@"
