#!/bin/bash
# fuzz.sh [SECONDS [TARGET...]] -- runs the fuzz targets of build/sanitize (or those named) for so long in all (default 300 s of the
# clock, by FUZZ_SECONDS): as many at a time as there are processors, each its share, from its committed corpus and what was found
# before; `problems` in longer runs also from the examples. An input that crashes is kept in build/fuzz/<target>/, to be added to
# tests/fuzz/corpus/<target>/ with the mend.
set -u
cd "$(dirname "$0")/.." || exit 1
total=${1:-${FUZZ_SECONDS:-300}}
shift
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
    for program in build/sanitize/fuzz/fuzz-*; do
        [ -x "$program" ] && targets+=("${program##*/fuzz-}")
    done
fi
if [ ${#targets[@]} -eq 0 ]; then
    echo "fuzz: no target is built (cmake --build --preset sanitize)" >&2
    exit 1
fi
at_once=$(nproc)
rounds=$(((${#targets[@]} + at_once - 1) / at_once))
share=$((total / rounds))
[ "$share" -gt 0 ] || share=1

fuzz_one() { # fuzz_one TARGET SECONDS
    local work=build/fuzz/$1 options=() seeds=()
    mkdir -p "$work/found"
    [ -e "tests/fuzz/$1.dict" ] && options+=("-dict=tests/fuzz/$1.dict")
    [ "$1" = problems ] && [ "$2" -ge 300 ] && seeds+=(examples) # some take seconds under the sanitizers
    if "build/sanitize/fuzz/fuzz-$1" "${options[@]}" -max_total_time="$2" -timeout=100 -rss_limit_mb=3000 -max_len=8192 \
        -artifact_prefix="$work/" "$work/found" "tests/fuzz/corpus/$1" "${seeds[@]}" > "$work/log" 2>&1; then
        printf '%-12s %s\n' "$1" "$(tail -n 1 "$work/log")"
    else
        printf '%-12s FAILED\n' "$1"
        grep -vE '^(#[0-9]+|NEW|INFO)' "$work/log" | tail -n 40
        return 1
    fi
}
export -f fuzz_one
printf '%s\0' "${targets[@]}" | xargs -0 -P "$at_once" -I{} bash -c "fuzz_one {} $share"
