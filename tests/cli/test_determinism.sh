# test_determinism.sh -- the same input gives the same bytes, whatever the number of threads; dates come from SOURCE_DATE_EPOCH.
. "$SOURCE/tests/cli/cli.sh"
SOURCE_DATE_EPOCH=86400
export SOURCE_DATE_EPOCH

# The formats that can be written here: some need a library that may be missing.
"$TAUT" example dirichlet-tent > tent.json
endings=
for ending in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z.]*\)".*/\1/p' "$SOURCE/src/io/format_list.h" "$SOURCE/src/draw/format_list.h"); do
    "$TAUT" make tent.json --quiet -o "probe.$ending" 2> probe.txt && endings="$endings $ending"
done
case $endings in *json*svg*) ;; *) complain "only these formats can be written: $endings" ;; esac

# make_twice EXAMPLE ENDING...: once on one thread, once on two; every output compared.
make_twice() {
    name=$1
    shift
    "$TAUT" example "$name" > problem.json
    for threads in 1 2; do
        outputs=
        mkdir -p "by$threads"
        for ending in "$@"; do
            outputs="$outputs -o by$threads/m.$ending"
        done
        # shellcheck disable=SC2086
        "$TAUT" make problem.json --quiet --threads $threads $outputs
        case $? in 0 | 1) ;; *) complain "$name with $threads threads: not made" ;; esac
    done
    for file in by1/*; do
        cmp -s "$file" "by2/${file#by1/}" || complain "$name: ${file#by1/} differs from one run to the next"
    done
    rm -r by1 by2
}

# Every example in the formats that are quick to write; where a sanitizer watches, the first of each construction.
examples=$("$TAUT" example)
firsts=$(echo "$examples" | awk '{ kind = $1; sub(/-.*/, "", kind) } !seen[kind]++')
grep -q __asan_init "$TAUT" && examples=$firsts
for name in $examples; do
    make_twice "$name" json glb
done
# All formats of one of each.
for name in $firsts; do
    # shellcheck disable=SC2086
    make_twice "$name" $endings
done
for ending in step pdf; do
    if [ -e "probe.$ending" ]; then
        grep -aq '1970-01-02\|19700102' "probe.$ending" || complain "the date in probe.$ending is not SOURCE_DATE_EPOCH"
    fi
done

# What is printed, too.
for threads in 1 2; do
    "$TAUT" make tent.json --quiet --threads $threads > model.json
    "$TAUT" measure model.json --json --threads $threads > "measured$threads"
    "$TAUT" reproduce dirichlet --json --threads $threads > "reproduced$threads"
done
cmp -s measured1 measured2 || complain "measure differs from one run to the next"
cmp -s reproduced1 reproduced2 || complain "reproduce differs from one run to the next"
finish
