#!/bin/bash
# forge_night.sh [FIRST [LAST]] -- forgeries and random problems against the judge from outside, seeds FIRST to LAST (1 to 50 unless
# said). A seed is a fiftieth of a million forgeries and of ten thousand problems, of cheap constructions many, of dear ones few: the
# counts stand below. What is done lies in build/forge/results, a file for each seed, construction and mode, under the commit that
# it was done with: a run that was stopped goes on where it was. After each seed they are added to docs/bench/forgeries.json and .md
# (tools/forge_table.py); what is counted there is not done again. On all processors, or JOBS of them; NICE says how politely. Every
# false `holds` is left with its documents in build/forge/found. Fails where there is one.
set -eu
cd "$(dirname "$0")/.."
first=${1:-1}
last=${2:-50}
export forge=build/release/tests/forge results=build/forge/results found=build/forge/found
if [ ! -x "$forge" ]; then
    echo "forge_night: $forge is not built (cmake --build --preset release)" >&2
    exit 1
fi
mkdir -p "$results" "$found"
commit=$(git rev-parse --short=10 HEAD 2> /dev/null || echo unknown)
if ! git diff --quiet HEAD -- src include tests 2> /dev/null; then
    commit=$commit-changed
fi
counted=$(python3 -B tools/forge_table.py --done)
export commit counted
# glibc gives large blocks back after every certificate and takes them anew: a third of a pipe's time
export MALLOC_TRIM_THRESHOLD_=268435456 MALLOC_MMAP_THRESHOLD_=268435456

forge_one() { # forge_one MODE CONSTRUCT COUNT SEED
    local name=$results/$1.$2.$4.txt status=0
    if [ -s "$name" ] || grep -qx "$1 $2 $4" <<< "$counted"; then
        return 0
    fi
    nice -n "${NICE:-10}" "$forge" --seed "$4" --count "$3" --construct "$2" --mode "$1" --folder "$found" --table \
        > "$name.part" 2>&1 || status=$?
    echo "commit $commit" >> "$name.part"
    if [ $status -gt 1 ]; then # not a verdict: stopped, or out of order
        mv "$name.part" "$name.failed"
        return 1
    fi
    mv "$name.part" "$name"
    printf '%-22s %s\n' "$1 $2" "$(grep '^seed ' "$name")"
    return $status
}
export -f forge_one

status=0
for seed in $(seq "$first" "$last"); do
    while read -r mode construct count; do
        echo "$mode $construct $count $seed"
    done << 'COUNTS' | xargs -P "${JOBS:-$(nproc)}" -L 1 bash -c 'forge_one "$@"' forge_one || status=1
forge asymptotic 200
forge biharmonic 6000
forge bonnet 800
forge dirichlet 780
forge film 100
forge harmonic 11900
forge pipe 150
forge plateau 70
made asymptotic 14
made biharmonic 50
made bonnet 40
made dirichlet 24
made film 10
made harmonic 40
made pipe 6
made plateau 16
COUNTS
    python3 -B tools/forge_table.py "$results"
done
grep -h '^FALSE HOLDS' "$results"/*.txt || true
exit $status
