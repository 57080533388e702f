#!/bin/bash
# mutants.sh [PATTERN] -- shows that the tests notice when the code is wrong.
#
#     MUTANTS_SECONDS  begin no other after so long; each commit takes them in another order (default: all are tried)
#     MUTANTS_TREE     a clone of this commit whose build/release has passed its tests, to break in place (default: a copy is built
#                      and tested first)
#
# Every tests/mutants/*.patch (those whose name matches PATTERN) breaks one thing: a sign, a bound, a certificate. In its
# first lines it says what, and which tests must fail:
#
#     What: the derivative of a Bernstein polynomial has the wrong sign
#     Caught-by: ^unit/basis/bases$          a regular expression over the names ctest gives
#
# Each patch is applied to a copy of the tree, what those tests need is built, and they are run. A mutant that
# survives, does not apply or does not build is a failure.
set -u
cd "$(dirname "$0")/.." || exit 1
root=$PWD
work=$root/build/mutants
tree=${MUTANTS_TREE:-$work/tree}
build=${MUTANTS_TREE:+$MUTANTS_TREE/build/release}
build=${build:-$work/build}
jobs=$(nproc)

field() { # field NAME PATCH
    sed -n "s/^$1: *//p" "$2" | head -n 1
}

# The build targets behind ctest names: test-unit-basis-bases for unit/basis/bases.
targets() { # targets REGEX
    ctest --test-dir "$build" -N -R "$1" 2>/dev/null | sed -n 's/^ *Test *#[0-9]*: *//p' | while read -r name; do
        case $name in
        cli/* | viewer/*) echo product ;;
        tools/*) ;;
        *) echo "test-${name//\//-}" ;;
        esac
    done | sort -u
}

run_tests() { # run_tests REGEX SECONDS; tests that take longer have failed: they name limits of their own to ctest, for slow builds
    timeout -k 5 "$2" ctest --test-dir "$build" -R "$1" -j "$jobs" --output-on-failure > "$work/tests.log" 2>&1
}

build_targets() { # build_targets TARGET...
    cmake --build "$build" --target "$@" > "$work/build.log" 2>&1
}

# Files that were mutated last time are newer than what git says of them.
copy_tree() {
    rm -rf "$tree"
    mkdir "$tree"
    git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
        [ -e "$file" ] && printf '%s\0' "$file"
    done | tar --null -T - -cf - | tar -C "$tree" -xf -
    if [ -s "$work/touched" ]; then
        (cd "$tree" && xargs -r -d '\n' touch -c < "$work/touched")
    fi
    : > "$work/touched"
}

apply() { # apply PATCH [--reverse]; outside of any repository as far as git can see
    (cd "$tree" && GIT_CEILING_DIRECTORIES=$work git apply --whitespace=nowarn "${@:2}" "$1") 2> "$work/apply.log"
}

patches=()
for patch in tests/mutants/*${1:-}*.patch; do
    [ -e "$patch" ] && patches+=("$root/$patch")
done
if [ ${#patches[@]} -eq 0 ]; then
    echo "mutants: no patch matches \"${1:-}\"" >&2
    exit 1
fi

# Where time is short each commit takes them in another order, so that all have their turn.
seconds=${MUTANTS_SECONDS:-0}
if [ "$seconds" -gt 0 ]; then
    salt=$(git rev-parse HEAD 2>/dev/null)
    mapfile -t patches < <(for patch in "${patches[@]}"; do
        printf '%s %s\n' "$(printf '%s' "$salt${patch##*/}" | sha1sum | cut -c 1-16)" "$patch"
    done | sort | cut -d ' ' -f 2-)
fi

mkdir -p "$work"
if [ -z "${MUTANTS_TREE:-}" ]; then
    copy_tree
    cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE='-O1 -DNDEBUG' \
        > "$work/configure.log" 2>&1 || { cat "$work/configure.log"; exit 1; }
fi

# Unbroken, all the tests named must pass, or catching a mutant would mean nothing.
all=
for patch in "${patches[@]}"; do
    regex=$(field Caught-by "$patch")
    if [ -z "$regex" ] || [ -z "$(field What "$patch")" ]; then
        echo "$patch: needs the lines What: and Caught-by:" >&2
        exit 1
    fi
    if [ -z "$(ctest --test-dir "$build" -N -R "$regex" 2>/dev/null | grep 'Test *#')" ]; then
        echo "$patch: no test matches $regex" >&2
        exit 1
    fi
    all="$all${all:+|}$regex"
    if ! apply "$patch" --check; then
        cat "$work/apply.log"
        echo "$patch: does not apply (the code moved on: make the patch anew)" >&2
        exit 1
    fi
done
broken=
mapfile -t wanted < <(targets "$all")
build_targets "${wanted[@]}" || { cat "$work/build.log"; exit 1; }
if [ -z "${MUTANTS_TREE:-}" ] && ! run_tests "$all" 1200; then
    broken=$(sed -n '/tests FAILED:/,$s/^[[:space:]]*[0-9]* - \([^ ]*\) .*/\1/p' "$work/tests.log")
    printf 'Failing in the unbroken tree, so that they can catch nothing:\n%s\n' "$broken"
fi

failed=0
tried=0
begin=$SECONDS
for patch in "${patches[@]}"; do
    if [ "$seconds" -gt 0 ] && [ $((SECONDS - begin)) -ge "$seconds" ]; then
        break
    fi
    tried=$((tried + 1))
    name=$(basename "$patch" .patch)
    regex=$(field Caught-by "$patch")
    sed -n 's|^+++ b/||p' "$patch" >> "$work/touched"
    mapfile -t wanted < <(targets "$regex")
    if [ -n "$broken" ] && grep -qE "$regex" <<< "$broken"; then
        failed=$((failed + 1))
        printf '%-34s %-10s %s\n' "$name" 'UNKNOWN' "its tests fail on the unbroken tree"
        continue
    fi
    if ! apply "$patch"; then
        verdict='DOES NOT APPLY'
        cat "$work/apply.log"
    else
        if ! build_targets "${wanted[@]}"; then
            verdict='DOES NOT BUILD'
            grep -m 3 'error' "$work/build.log"
        elif run_tests "$regex" 100; then
            verdict='SURVIVED'
        else
            verdict=caught
        fi
        if ! apply "$patch" --reverse; then
            echo "mutants: $name cannot be taken back" >&2
            exit 1
        fi
    fi
    [ "$verdict" = caught ] || failed=$((failed + 1))
    printf '%-34s %-10s %s\n' "$name" "$verdict" "$(field What "$patch")"
done
echo "$tried of ${#patches[@]} mutants tried, $failed not caught"
[ "$failed" -eq 0 ]
