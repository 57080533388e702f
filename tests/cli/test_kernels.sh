# test_kernels.sh -- every example gives the same model, certificate and mesh, byte for byte, and the same exit status with
# every kernel that this processor has.
. "$SOURCE/tests/cli/cli.sh"

kernels=baseline
for kernel in avx2 avx512; do
    TAUT_KERNEL=$kernel "$TAUT" --version | grep -q 'is passed over' || kernels="$kernels $kernel"
done

# Where a sanitizer watches, the first of each construction.
examples=$("$TAUT" example)
grep -q __asan_init "$TAUT" && examples=$(echo "$examples" | awk '{ kind = $1; sub(/-.*/, "", kind) } !seen[kind]++')
count=0
same=0
for name in $examples; do
    "$TAUT" example "$name" > problem.json
    agree=1
    for kernel in $kernels; do
        TAUT_KERNEL=$kernel "$TAUT" make problem.json --quiet -o "$kernel.json" -o "$kernel.glb" 2> "$kernel.said"
        code=$?
        sed -i "s/$kernel\\./model./" "$kernel.said" # what says which files were not written
        echo "exit $code" >> "$kernel.said"
        [ -s "$kernel.json" ] || complain "$name: no model with the kernel $kernel"
        for ending in json glb said; do
            [ -e "$kernel.$ending" ] || [ -e "baseline.$ending" ] || continue
            cmp -s "baseline.$ending" "$kernel.$ending" || agree=0
        done
    done
    rm -f ./*.glb ./*.json ./*.said
    count=$((count + 1))
    same=$((same + agree))
    [ $agree = 1 ] || complain "$name differs between the kernels $kernels"
done
echo "$same of $count examples are the same with the kernels $kernels"
[ $count -gt 5 ] || complain "only $count examples"
finish
