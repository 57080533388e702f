#!/bin/sh
# check_mutants.sh [ROOT] -- each mutant fits its file, and the tables of tests/mutants are in order.
exec "$(dirname "$0")/mutants.sh" --check "${1:-$(dirname "$0")/..}"
