#!/bin/sh
# dirichlet_memory.sh TAUT [N] -- makes and certifies a bicubic net of N x N points (1000 unless said), boundary known, with
# an address space of 4 GiB. Fails when the memory does not do or the certificate does not hold; prints both times.
set -eu
taut=${1:?usage: dirichlet_memory.sh TAUT [N]}
n=${2:-1000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -v n="$n" 'BEGIN {
    printf "{ \"taut\": 1, \"construct\": \"dirichlet\",\n"
    for (k = 0; k < 2; k++) printf "  \"%s\": { \"type\": \"bspline\", \"degree\": 3, \"count\": %d },\n", k ? "v" : "u", n
    printf "  \"points\": [\n"
    for (i = 0; i < n; i++) {
        printf "    ["
        for (j = 0; j < n; j++) {
            x = i / (n - 1); y = j / (n - 1)
            if (i == 0 || j == 0 || i == n - 1 || j == n - 1) printf "[%.6f, %.6f, %.6f]", x, y, 0.3 * sin(7 * x) * cos(5 * y)
            else printf "null"
            if (j < n - 1) printf ", "
        }
        printf "]%s\n", i < n - 1 ? "," : ""
    }
    print "  ]\n}"
}' > "$work/problem.json"

ulimit -v 4194304
"$taut" make "$work/problem.json" -o "$work/model.json"
