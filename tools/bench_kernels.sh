#!/bin/sh
# bench_kernels.sh COMMIT... -- the loops of src/numeric/kernel of other commits beside those of this tree, kernel by kernel, in one run:
# nanoseconds of processor time a unit, the least of many turns. COMMIT+off takes the fused operations out of the loops of a commit that
# had them, so that what these were worth stands apart from all else.
#
#     tools/bench_kernels.sh 5471e09 5471e09+off        the table in docs/platforms.md
set -eu
cd "$(dirname "$0")/.."
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cc=${CC:-gcc}
flags="-std=c17 -O3 -DNDEBUG -fno-math-errno -fPIC -D_POSIX_C_SOURCE=200809L -D_XOPEN_SOURCE=700"

module() { # module TREE NAME: compiles the kernels of a tree
    vectors=-ffp-contract=off
    fused2= fused512=
    if grep -q 'int lanes' "$1/src/numeric/kernel/kernel.h"; then
        lanes=-DLANES_OF_KERNEL
        case $2 in *+off) ;; *) vectors=-ffp-contract=fast fused2=-mfma fused512=-mfma ;; esac
    else
        lanes=
    fi
    for file in baseline avx2 avx512 kernel; do
        case $file in
            avx2) own="$vectors -mavx2 $fused2" ;;
            avx512) own="$vectors -mavx512f -mavx512dq -mavx512vl -mavx2 $fused512" ;;
            *) own=-ffp-contract=off ;;
        esac
        # shellcheck disable=SC2086
        $cc $flags $own -I"$1/src" -I"$1/include" -c "$1/src/numeric/kernel/$file.c" -o "$work/$file.o"
    done
    # shellcheck disable=SC2086
    $cc $flags -ffp-contract=off $lanes -I"$1/src" -I"$1/include" -shared -o "$work/$2.so" "$root/bench/kernels/loops.c" \
        "$work/baseline.o" "$work/avx2.o" "$work/avx512.o" "$work/kernel.o"
}

set -- "$@" now
list=
for name in "$@"; do
    tree=$work/tree-$name
    case $name in
        now) tree=$root ;;
        *)
            mkdir -p "$tree"
            git archive "${name%+off}" src/numeric/kernel src/core include | tar -x -C "$tree"
            case $name in
                *+off)
                    for file in "$tree"/src/numeric/kernel/simd_avx*.h; do
                        # the same operations, each rounded
                        sed -i -E -e 's/^#define v_fma\(.*/#define v_fma(a, b, c) ((a) * (b) + (c))/' \
                            -e 's/^#define v_fnma\(.*/#define v_fnma(a, b, c) ((c) - (a) * (b))/' \
                            -e '/^#define v_product_error/,$d' -e 's/,fma"/"/' "$file"
                        sed -n '/^static inline v_double v_product_error/,/^}/p' "$tree/src/numeric/kernel/simd_baseline.h" >> "$file"
                    done
                    ;;
            esac
            ;;
    esac
    module "$tree" "$name"
    list="$list $name=$work/$name.so"
done
$cc $flags -o "$work/compare" bench/kernels/compare.c -ldl -lm
# shellcheck disable=SC2086
"$work/compare" $list
