#!/bin/bash
# fuzz.sh [SECONDS [TARGET...]] -- runs the fuzz targets of build/sanitize (or those named) for so long in all (default 300 s of the
# clock, by FUZZ_SECONDS): as many at a time as there are processors, each its share, from its committed corpus and what was found
# before; `problems` in longer runs also from the examples. An input that crashes is kept in build/fuzz/<target>/, to be added to
# tests/fuzz/corpus/<target>/ with the mend.
#
#     FUZZ_SEED  a number: what is tried depends on it alone. Each target starts from its committed corpus and tries as many inputs
#                as a slow machine does in its share of the time, so that a failure comes again where it is run again.
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

runs_per_second() { # of a target, about half of what one processor of 2020 does
    case $1 in
    cad | basis) echo 20000 ;;
    readers) echo 400 ;;
    calls) echo 100 ;;
    *) echo 200 ;;
    esac
}

fuzz_one() { # fuzz_one TARGET SECONDS
    local work=build/fuzz/$1 options=() seeds=() fixed=() most=$2
    if [ -n "${FUZZ_SEED:-}" ]; then
        rm -rf "$work/found"
        options+=("-seed=$FUZZ_SEED" "-runs=$(($(runs_per_second "$1") * $2))")
        most=$((2 * $2))
        setarch -R true > /dev/null 2>&1 && fixed=(setarch -R) # addresses are compared, too
    fi
    mkdir -p "$work/found"
    [ -e "tests/fuzz/$1.dict" ] && options+=("-dict=tests/fuzz/$1.dict")
    [ "$1" = problems ] && [ "$2" -ge 300 ] && seeds+=(examples) # some take seconds under the sanitizers
    if "${fixed[@]}" "build/sanitize/fuzz/fuzz-$1" "${options[@]}" -max_total_time="$most" -timeout=100 -rss_limit_mb=3000 -max_len=8192 \
        -artifact_prefix="$work/" "$work/found" "tests/fuzz/corpus/$1" "${seeds[@]}" > "$work/log" 2>&1; then
        printf '%-12s %s\n' "$1" "$(tail -n 1 "$work/log")"
    else
        printf '%-12s FAILED\n' "$1"
        grep -vE '^(#[0-9]+|NEW|INFO)' "$work/log" | tail -n 40
        return 1
    fi
}
export -f fuzz_one runs_per_second
printf '%s\0' "${targets[@]}" | xargs -0 -P "$at_once" -I{} bash -c "fuzz_one {} $share"
