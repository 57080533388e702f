#!/bin/sh
# check_all.sh -- every check that needs no build, one after the other; fails if any does.
cd "$(dirname "$0")" || exit 1
bad=0
for check in layers words citations docs reasons faults abi mutants format; do
    if ./check_$check.sh; then
        echo "$check: ok"
    else
        echo "$check: FAILED"
        bad=1
    fi
done
if ./bench_table.py --check; then
    echo "bench tables: ok"
else
    bad=1
fi
if ./draw_architecture.py --check; then
    echo "picture of the architecture: ok"
else
    bad=1
fi
./claim_mutants.py --check || bad=1
exit $bad
