#!/bin/sh
# new_mutant.sh NAME CAUGHT-BY WHAT -- keeps the uncommitted change of src/ as tests/mutants/NAME.patch and undoes it.
# It must compile without a warning: what a compiler notices needs no test.
set -eu
cd "$(dirname "$0")/.."
if [ $# -ne 3 ] || git diff --quiet -- src; then
    echo "usage: break something in src/, then new_mutant.sh NAME CAUGHT-BY WHAT" >&2
    exit 2
fi
{
    printf 'What: %s\nCaught-by: %s\n\n' "$3" "$2"
    git diff --no-color -U2 -- src
} > "tests/mutants/$1.patch"
git checkout -q -- src
echo "tests/mutants/$1.patch"
