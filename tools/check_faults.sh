#!/bin/sh
# check_faults.sh [ROOT] -- every public function that may run out of memory is called in tests/fault, where each of its
# allocations is made to fail. One that returns a status, makes a record or adds to one counts as such; those that take no memory
# stand in tests/fault/no_memory.txt, with the reason. What a construction's header declares is covered by its example
# (test_examples.c), which the list of constructions brings.
set -eu
cd "${1:-$(dirname "$0")/..}"
exempt=tests/fault/no_memory.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
LC_ALL=C
export LC_ALL

# name of each declaration that may fail: status or record out, or a record that is added to
cat include/taut/*.h | tr '\n' ' ' | sed 's/TAUT_API/\n&/g' | sed -n 's/^TAUT_API \([^;]*\);.*/\1/p' |
    awk '/^taut_status |^taut_record \*|[(,] *taut_record \*record/ { sub(/\(.*/, ""); sub(/.*[ *]/, ""); print }' |
    sort -u > "$work/may_fail"
sed -n 's/^\(taut_[a-z_0-9]*\) .*/\1/p' "$exempt" | sort -u > "$work/exempt"
for construct in $(sed -n 's/.*X(\([a-z_0-9]*\), ".*/\1/p' src/problem/construct_list.h); do
    printf 'taut_%s_make\ntaut_%s_certify\n' "$construct" "$construct"
done > "$work/constructs"
grep -ohE 'taut_[a-z_0-9]+' tests/fault/*.c | sort -u > "$work/called"
bad=0
for name in $(cat "$work/may_fail"); do
    if ! grep -qx "$name" "$work/exempt" && ! grep -qx "$name" "$work/called" &&
        ! grep -qx "$name" "$work/constructs"; then
        echo "$name: no test in tests/fault makes its allocations fail"
        bad=1
    fi
done
for name in $(cat "$work/exempt"); do
    grep -qx "$name" "$work/may_fail" || { echo "$exempt: $name is no public function that may fail"; bad=1; }
done
if grep -nE '^taut_[a-z_0-9]* *$' "$exempt"; then
    echo "$exempt: the reason is missing"
    bad=1
fi
exit $bad
