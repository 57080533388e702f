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
# A net large enough for threads in the solver and the writer, which by default has as many as there are processors.
awk 'BEGIN { n = 120
    printf "{\"taut\":1,\"construct\":\"dirichlet\",\"u\":{\"type\":\"bspline\",\"degree\":3,\"count\":%d},", n
    printf "\"v\":{\"type\":\"bspline\",\"degree\":2,\"count\":%d},\"points\":[", n + 7
    for (i = 0; i < n; i++) {
        printf i ? ",[" : "["
        for (j = 0; j < n + 7; j++) {
            printf j ? "," : ""
            if (i % (n - 1) && j % (n + 6)) printf "null"
            else printf "[%d,%d,%.3f]", i, j, sin(i / 9) * cos(j / 7)
        }
        printf "]"
    }
    print "]}" }' > large.json
for threads in 1 2 3; do
    "$TAUT" make large.json --quiet --threads $threads -o "large$threads.json" -o "large$threads.step"
done
"$TAUT" make large.json --quiet -o large0.json -o large0.step
for threads in 0 2 3; do
    for ending in json step; do
        cmp -s "large1.$ending" "large$threads.$ending" || complain "a large net: $ending by $threads threads differs"
    done
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
