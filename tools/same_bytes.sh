#!/bin/sh
# same_bytes.sh [--build] [--within SECONDS] PROGRAM [PROGRAM]... -- every example is made by each PROGRAM, a command that runs a `taut`, and all
# must give the same model with its certificate, the same mesh and the same exit status as the first. --build makes two
# programs first, by gcc and by clang, in build/same-gcc and build/same-clang, and adds them. --within leaves out examples for
# which the first program takes more processor time than that, and says how many those are.
#
#     tools/same_bytes.sh --build
#     tools/same_bytes.sh build/release/bin/taut 'wine64 build/mingw/bin/taut.exe' 'qemu-aarch64 build/arm/bin/taut'
set -eu
cd "$(dirname "$0")/.."
if [ "${1:-}" = --build ]; then
    shift
    for compiler in clang gcc; do
        case $compiler in gcc) cxx=g++ ;; *) cxx=clang++ ;; esac
        if ! command -v $compiler > /dev/null; then
            echo "same_bytes: no $compiler here (tools/deps.sh check)" >&2
            exit 1
        fi
        cmake -S . -B build/same-$compiler -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF \
            -DCMAKE_C_COMPILER=$compiler -DCMAKE_CXX_COMPILER=$cxx > /dev/null
        cmake --build build/same-$compiler -j2 --target taut > build/same-$compiler/log.txt || {
            cat build/same-$compiler/log.txt >&2
            exit 1
        }
        set -- "$PWD/build/same-$compiler/bin/taut" "$@"
    done
fi
within=
if [ "${1:-}" = --within ]; then
    within=$2
    shift 2
fi
if [ $# -lt 2 ]; then
    echo "same_bytes: two programs at least" >&2
    exit 2
fi
first=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0
same=0
slow=0
for document in examples/*.json; do
    name=$(basename "$document" .json)
    if [ -n "$within" ]; then
        status=0
        (ulimit -t "$within" && exec $first make "$document" --quiet -o "$work/0.json") 2> "$work/0.said" || status=$?
        rm -f "$work"/*
        if [ "$status" -gt 128 ]; then
            slow=$((slow + 1))
            continue
        fi
    fi
    number=0
    agree=1
    for program in "$@"; do
        # shellcheck disable=SC2086
        status=0
        $program make "$document" --quiet -o "$work/$number.json" -o "$work/$number.glb" 2> "$work/$number.said" || status=$?
        echo "exit $status" > "$work/$number.status"
        for ending in json glb status; do
            [ -e "$work/0.$ending" ] || [ -e "$work/$number.$ending" ] || continue
            if ! cmp -s "$work/0.$ending" "$work/$number.$ending"; then
                echo "$name: $program gives another $ending than $first"
                agree=0
            fi
        done
        number=$((number + 1))
    done
    rm -f "$work"/*
    count=$((count + 1))
    same=$((same + agree))
done
[ "$slow" = 0 ] || echo "$slow examples take more than $within s and are left out"
echo "$same of $count examples are the same"
[ "$same" = "$count" ] && [ "$count" -gt 50 ]
