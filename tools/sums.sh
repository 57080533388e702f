#!/bin/sh
# sums.sh [PROGRAM] -- a line for each example and kernel of this processor: the exit status of `taut make` and the SHA-256 of the
# model with its certificate and of the mesh. The same lines on every machine:
#
#     tools/sums.sh build/release/bin/taut > here; diff here there
set -eu
program=${1:-build/release/bin/taut}
case $program in /*) ;; *) program=$PWD/$program ;; esac
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
kernels=baseline
for kernel in avx2 avx512; do
    TAUT_KERNEL=$kernel "$program" --version | grep -q 'is passed over' || kernels="$kernels $kernel"
done
for name in $("$program" example | awk '{ print $1 }'); do
    "$program" example "$name" > problem.json
    for kernel in $kernels; do
        code=0
        TAUT_KERNEL=$kernel "$program" make problem.json --quiet -o model.json -o model.glb 2> said || code=$?
        for file in model.json model.glb; do
            [ ! -e $file ] || cat $file
        done | sha256sum | awk -v what="$name $kernel $code" '{ print what, $1 }'
        rm -f model.json model.glb
    done
done
