#!/bin/sh
# check_symbols.sh [--update] [LIBRARY] -- libtaut.so, and libtaut-draw.so beside it, export what include/taut declares for each,
# all of it named taut_, and just what tools/symbols.txt and tools/symbols_draw.txt list: a symbol that disappears breaks
# programs, one that appears is a promise. --update writes the lists anew, for a change that means it.
set -eu
cd "$(dirname "$0")/.."
update=
if [ "${1:-}" = --update ]; then
    update=1
    shift
fi
main=${1:-build/release/libtaut.so}
drawing=$(dirname "$main")/libtaut-draw.so
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
LC_ALL=C
export LC_ALL
bad=0
report() { # report LIST SAYING
    if [ -s "$1" ]; then
        sed "s|\$|: $2|" "$1"
        bad=1
    fi
}

check() { # check LIBRARY LIST HEADER...
    library=$1
    list=$2
    shift 2
    if [ ! -e "$library" ]; then
        echo "check_symbols: $library is not built" >&2
        exit 1
    fi
    # Left out: what the toolchain itself adds to every library.
    nm -D --defined-only "$library" | awk '{ print $NF }' | sed 's/@.*//' | grep -vE '^(_init|_fini|__bss_start|_edata|_end)$' |
        sort -u > "$work/exported"
    # The last name before the parenthesis of each TAUT_API declaration.
    cat "$@" | tr '\n' ' ' | sed 's/TAUT_API/\n&/g' | sed -n 's/^TAUT_API \([^(;]*\)[(;].*/\1/p' |
        sed 's/.*[ *]\([a-z_0-9]*\) *$/\1/' | grep '^taut_' | sort -u > "$work/declared"
    if [ -n "$update" ]; then
        cp "$work/exported" "$list"
    fi
    # Elementary functions of <math.h>, <complex.h> and their kin in float and long double; core/elementary has ours. Exact ones
    # (sqrt, floor, fmin, frexp, ldexp, fmod, round, ...) are the same everywhere; sqrtl is not.
    nm -D --undefined-only "$library" | awk '{ print $NF }' | sed 's/@.*//' |
        grep -xE '(a?(sin|cos|tan)h?|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow(10)?|atan2|hypot|cbrt|erfc?|[lt]gamma|j[01n]|y[01n]|fma|c(abs|arg|exp|log|pow|sqrt|a?(sin|cos|tan)h?))[fl]?|__(mul|div)[dx]c3' \
        > "$work/rounded" || true
    grep -v '^taut_' "$work/exported" > "$work/foreign" || true
    report "$work/foreign" 'exported, but not named taut_'
    comm -13 "$work/exported" "$work/declared" > "$work/undefined"
    report "$work/undefined" "declared in include/taut, but not in $library"
    comm -23 "$work/exported" "$work/declared" > "$work/undeclared"
    report "$work/undeclared" 'exported, but declared in no public header'
    comm -13 "$work/exported" "$list" > "$work/removed"
    report "$work/removed" 'was exported before and is gone'
    comm -23 "$work/exported" "$list" > "$work/new"
    report "$work/new" 'new: if it is meant, tools/check_symbols.sh --update'
    report "$work/rounded" 'called, but every C library rounds it in its way: core/elementary/elementary.h'
}

check "$main" tools/symbols.txt $(ls include/taut/*.h | grep -v '/draw\.h$')
check "$drawing" tools/symbols_draw.txt include/taut/draw.h
exit $bad
