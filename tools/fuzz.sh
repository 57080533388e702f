#!/bin/bash
# fuzz.sh [SECONDS [TARGET...]] -- runs every fuzz target of build/sanitize (or those named) so long, as many at a time as
# there are processors, each from its committed corpus. An input that crashes is kept in build/fuzz/<target>/, to be
# added to tests/fuzz/corpus/<target>/ with the mend.
set -u
cd "$(dirname "$0")/.." || exit 1
seconds=${1:-60}
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

fuzz_one() { # fuzz_one TARGET SECONDS
    local work=build/fuzz/$1 options=()
    mkdir -p "$work/found"
    [ -e "tests/fuzz/$1.dict" ] && options+=("-dict=tests/fuzz/$1.dict")
    if "build/sanitize/fuzz/fuzz-$1" "${options[@]}" -max_total_time="$2" -timeout=20 -rss_limit_mb=3000 \
        -artifact_prefix="$work/" "$work/found" "tests/fuzz/corpus/$1" > "$work/log" 2>&1; then
        printf '%-20s %s\n' "$1" "$(tail -n 1 "$work/log")"
    else
        printf '%-20s FAILED\n' "$1"
        grep -vE '^(#[0-9]+|NEW|INFO)' "$work/log" | tail -n 40
        return 1
    fi
}
export -f fuzz_one
printf '%s\0' "${targets[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c "fuzz_one {} $seconds"
