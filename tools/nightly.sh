#!/bin/bash
# nightly.sh [STEP...] -- what takes too long for each commit: all steps, or those named, one after the other. What came of it is
# written into docs/nightly.md, a row for each step with the day, the commit, the time it took and the verdict; rows of other steps stay.
# Logs are left in build/nightly. Fails where a step does.
#
#     compilers  every example by gcc's program and by clang's, byte for byte
#     musl       another C library: the C tests that need no library, every example byte for byte
#     aarch64    another processor, by qemu, which is fifty times slower: the rooms that compute least, byte for byte every example that
#                is made here within NIGHTLY_WITHIN seconds (60)
#     sanitize   all tests with addresses and undefined behaviour watched
#     windows    all C tests under wine, and every example
#     wasm       every example in the WebAssembly module, byte for byte
#     studio     ten thousand random gestures in the studio, without a complaint, and what they and an hour of dragging leave behind in memory
#     fuzz       every fuzz target, NIGHTLY_FUZZ seconds in all (3600)
#     mutants    every mutant that was made by hand
#     generated  mutants made by rule, for NIGHTLY_GENERATED seconds (7200)
#     recipes    those of packaging/ for conda-forge, Homebrew and vcpkg, run by stand-ins of their tools
#     peers      what other programs make of files: FreeCAD of STEP and DXF, Blender and admesh of meshes, each there
#     plugins    those of FreeCAD, Blender, ParaView and Grasshopper in their hosts
#     layouts    a thousand random films of many patches, against what is known of them
#     elementary a million arguments of each elementary function, three million pairs, against MPFR
#     films      a thousand random sails and rings: films whose claims hold, or refusals that are true by other means
#     nets       nets of every kind on the surfaces of all examples: they hold, or are refused
#     forge      forgeries of models against the judge from outside, seed NIGHTLY_SEED (the day)
set -u
cd "$(dirname "$0")/.." || exit 1
all="compilers musl aarch64 sanitize windows wasm studio fuzz mutants generated recipes peers plugins layouts elementary films nets forge"
page=docs/nightly.md logs=build/nightly
for name in "$@"; do
    case " $all " in *" $name "*) ;; *)
        echo "nightly: no step \"$name\"; there are: $all" >&2
        exit 2
        ;;
    esac
done
mkdir -p "$logs"
export NICE=${NICE:-10} TAUT_REQUIRE=
jobs=${JOBS:-$(nproc)}
native=$PWD/build/release/bin/taut
commit=$(git rev-parse --short=10 HEAD)
git diff --quiet HEAD -- src include tests cmake || commit=$commit-changed

preset() { # preset NAME [CTEST-ARGUMENT...]: configured, built, tested
    cmake --preset "$1" > /dev/null && cmake --build --preset "$1" -j "$jobs" && ctest --preset "$1" -j "$jobs" "${@:2}"
}

do_compilers() { tools/same_bytes.sh --build; }
do_musl() { preset musl && tools/same_bytes.sh "$native" build/musl/bin/taut; }
do_aarch64() {
    # a test that starts itself anew would start qemu; solvers of some hundred unknowns take half an hour there
    local rooms='basis|core|geometry|io|numeric|platform|problem' tests
    cmake --preset aarch64 > /dev/null &&
        tests=$(ninja -C build/aarch64 -t targets all | sed -nE "s/^(test-unit-($rooms)-[^:]*): phony$/\\1/p") &&
        xargs ninja -C build/aarch64 -j "$jobs" taut <<< "$tests" &&
        ctest --preset aarch64 -j "$jobs" -R "^unit/($rooms)/" -E '^unit/io/cad/helper$' &&
        tools/same_bytes.sh --within "${NIGHTLY_WITHIN:-60}" "$native" 'qemu-aarch64 build/aarch64/bin/taut'
}
do_sanitize() { tools/deps.sh check && preset sanitize; }
do_windows() { tools/deps.sh windows && preset mingw; }
do_wasm() {
    tools/deps.sh wasm && cmake --preset wasm > /dev/null && cmake --build --preset wasm -j "$jobs" &&
        node --test tests/web/test_web.mjs
}
do_studio() {
    tools/deps.sh wasm && tools/deps.sh browser && cmake --preset release > /dev/null &&
        cmake --build --preset release -j "$jobs" --target taut --target studio &&
        GESTURES="${NIGHTLY_GESTURES:-10000}" DRAG="${NIGHTLY_DRAG:-3600}" ONLY=gestures node tests/studio/test_studio.js "$native" "$(mktemp -d)" -
}
do_fuzz() {
    tools/deps.sh check && cmake --preset sanitize > /dev/null && cmake --build --preset sanitize -j "$jobs" &&
        tools/fuzz.sh "${NIGHTLY_FUZZ:-3600}"
}
do_mutants() { tools/mutants.sh; }
do_generated() { tools/mutants_generated.py --seconds "${NIGHTLY_GENERATED:-7200}"; }
do_recipes() { tools/recipes.sh; }
do_peers() {
    tools/deps.sh hosts && TAUT_REQUIRE=all ctest --preset release -R '^cli/(assembly|cloth_peer|dxf|mesh_peer|sheets|sheets_peer|step_solids)$'
}
do_plugins() { tools/deps.sh hosts && tools/plugins.sh test; }
do_layouts() { cmake --build --preset release --target test-property-layouts && build/release/tests/test-property-layouts 1000; }
do_elementary() {
    cmake --build --preset release --target test-unit-core-elementary-elementary &&
        build/release/tests/test-unit-core-elementary-elementary 333334 "${NIGHTLY_SEED:-21}"
}
do_films() { cmake --build --preset release --target test-property-film_laws && build/release/tests/test-property-film_laws 1000 200; }
do_nets() { tools/nets_night.py "$native"; }
do_forge() { tools/forge_night.sh "${NIGHTLY_SEED:-$(date +%j)}" "${NIGHTLY_SEED:-$(date +%j)}"; }

# What a step says of itself: of tests how many, of examples how many.
told() { # told LOG
    grep -hE '^[a-z]+: installed, |^[0-9]+ of [0-9]+ examples|^[0-9]+ examples take|tests passed, |^# (pass|fail) |^[0-9]+ (passed|failed)|mutants tried|^seed [0-9]|^[0-9]+ films, |^[0-9]+ arguments of |^[0-9]+ nets, |^after [0-9]+ (gestures|s of dragging)' "$1" | tail -n 3 |
        tr '\n|' ' /' | sed 's/  */ /g; s/ $//'
}

write_page() { # write_page STEP VERDICT SECONDS WHAT: its row in place of the one there was
    local rows step
    rows=$(grep -E '^\| `' "$page" 2> /dev/null | grep -vF "| \`$1\` |")
    {
        cat << 'HEAD'
# What runs at night

`tools/nightly.sh` writes this page: the last run of each step. What the steps are is said at its head. `nets` passes
where each net holds, is refused, or is one of those that `STALLED` in `tools/nets_night.py` lists.

| step | day | commit | seconds | verdict | it says |
|---|---|---|---|---|---|
HEAD
        for step in $all; do
            if [ "$step" = "$1" ]; then
                # shellcheck disable=SC2016
                printf '| `%s` | %s | %s | %s | %s | %s |\n' "$1" "$(date -u +%F)" "$commit" "$3" "$2" "$4"
            else
                grep -F "| \`$step\` |" <<< "$rows"
            fi
        done
    } > "$page.new"
    mv "$page.new" "$page"
}

if ! { tools/deps.sh build test nightly && cmake --preset release && cmake --build --preset release -j "$jobs"; } > "$logs/release.log" 2>&1; then
    echo "nightly: the native program does not build: $logs/release.log" >&2
    exit 1
fi
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- $all
failures=0
for step; do
    begin=$SECONDS verdict=passed
    if ! (set -e; "do_$step") > "$logs/$step.log" 2>&1; then
        verdict=FAILED
        failures=$((failures + 1))
    fi
    write_page "$step" "$verdict" $((SECONDS - begin)) "$(told "$logs/$step.log")"
    printf '%-10s %s, %d s: %s\n' "$step" "$verdict" $((SECONDS - begin)) "$(told "$logs/$step.log")"
done
[ $failures = 0 ]
