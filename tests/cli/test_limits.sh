# test_limits.sh -- every limit of docs/limits.md that a document or the command line can reach is refused, with the limit in the
# message; the page says the numbers of include/taut/limits.h.
. "$SOURCE/tests/cli/cli.sh"

# Each name of the header stands in the page, with its value.
sed -n 's/^#define \(TAUT_[A-Z_]*\) \([0-9e.-]*\) .*/\1 \2/p' "$SOURCE/include/taut/limits.h" > limits
[ "$(wc -l < limits)" -ge 11 ] || complain "limits.h could not be read"
while read -r name value; do
    said=$(sed -n "s/^| .*\`$name\`.* | \([0-9e.,-]*\) | .*/\1/p" "$SOURCE/docs/limits.md" | head -n 1 | tr -d ,)
    [ -n "$said" ] || complain "docs/limits.md does not name $name"
    awk -v a="$said" -v b="$value" 'BEGIN { exit !(a + 0 == b + 0) }' ||
        complain "docs/limits.md says $said for $name, the header $value"
done < limits

# too_much PATTERN DOCUMENT: refused as a document, with this error
too_much() {
    printf '%s' "$2" > d.json
    refused 3 "$1" measure d.json
}
curve() { # curve BASIS: a model of one curve on it
    printf '{"taut": 1, "curves": [{"t": %s, "points": [[0, 0, 0], [1, 0, 0]]}]}' "$1"
}
line='{"type": "bezier", "degree": 1}'

too_much 'value /curves/0/t/degree found 129 expected a whole number from 1 to 128' "$(curve '{"type": "bezier", "degree": 129}')"
too_much 'value /curves/0/t/count found 1000001 expected a whole number from 1 to 1000000' "$(curve '{"type": "bspline", "degree": 3, "count": 1000001}')"
too_much 'value /curves/0/t/segments found 999998 expected 999997' "$(curve '{"type": "c-bspline", "alpha": 1, "segments": 999998}')"
too_much 'value /curves/0/t/knots found 1e61 expected 1e60' "$(curve '{"type": "bspline", "degree": 1, "knots": [0, 0, 1e61, 1e61]}')"
too_much 'value /curves/0/t/range found 2e60 expected 1e60' "$(curve '{"type": "bezier", "degree": 1, "range": [0, 2e60]}')"
too_much 'short-span /curves/0/t/range found 1e-61 expected 1e-60' "$(curve '{"type": "bezier", "degree": 1, "range": [0, 1e-61]}')"
too_much 'value /curves/0/t/alpha found 1e-61 expected 1e-60' "$(curve '{"type": "c-bezier", "alpha": 1e-61}')"
too_much 'value /curves/0/t/beta found 701 expected 700' "$(curve '{"type": "h-bezier", "beta": 701}')"
too_much 'value /curves/0/t/alpha found 1001 expected 1000' "$(curve '{"type": "ce-bezier", "alpha": 1001, "beta": 0, "gamma": 0}')"
name=$(awk 'BEGIN { for (i = 0; i < 256; i++) printf "x" }')
too_much 'size /curves/0/name found 256 expected 255' "{\"taut\": 1, \"curves\": [{\"name\": \"$name\", \"t\": $line, \"points\": [[0, 0, 0], [1, 0, 0]]}]}"
too_much 'size /details found 1001 expected 1000' "$(awk 'BEGIN {
    printf "{\"taut\": 1, \"details\": {"
    for (i = 0; i <= 1000; i++) printf "%s\"a%d\": 1", i ? ", " : "", i
    printf "}}" }')"
too_much 'depth d\.json:1:284' "$(awk 'BEGIN {
    printf "{\"taut\": 1, \"details\": {\"a\": "
    for (i = 0; i < 257; i++) printf "["
    for (i = 0; i < 257; i++) printf "]"
    printf "}}" }')"
contains err.txt 'more than 256 '
awk -v line="$line" 'BEGIN {
    printf "{\"taut\": 1, \"curves\": ["
    for (i = 0; i <= 100000; i++) printf "%s{\"t\": %s, \"points\": [[0, 0, 0], [1, 0, 0]]}", i ? "," : "", line
    printf "]}" }' > d.json
refused 3 'size /curves found null expected an array of at most 100000 curves' measure d.json
printf '{"taut": 1, "construct": "asymptotic", "degree": 9, "corners": {}, "edges": {}}' > d.json
refused 3 'value /degree found 9 expected a whole number from 3 to 8' make d.json
printf '{"taut": 1, "construct": "harmonic", "u": {"type": "bezier", "degree": 25}, "v": {"type": "bezier", "degree": 25},
"points": [' > d.json
awk 'BEGIN { for (i = 0; i <= 25; i++) { printf "%s[", i ? ",\n" : ""
    for (j = 0; j <= 25; j++) printf "%s%s", j ? ", " : "", i % 25 ? "null" : "[" i ", " j ", 0]"
    printf "]" } printf "]}" }' >> d.json
refused 4 'ill-conditioned d\.json found 5\.97[0-9]*e20 expected 1000000000000000' make d.json

# square CONSTRUCT U-AND-V N WHICH EXTRA: a problem on a net of N + 1 by N + 1 points (i, j, i j / N), of which those are known
# where WHICH holds, an expression in i, j and n
square() {
    awk -v construct="$1" -v basis="$2" -v n="$3" -v extra="$5" "BEGIN {
        printf \"{\\\"taut\\\": 1, \\\"construct\\\": \\\"%s\\\"%s, \\\"u\\\": %s, \\\"v\\\": %s, \\\"points\\\": [\", construct, extra, basis, basis
        for (i = 0; i <= n; i++) { printf \"%s[\", i ? \",\" : \"\"
            for (j = 0; j <= n; j++) printf \"%s%s\", j ? \",\" : \"\", $4 ? \"[\" i \",\" j \",\" i * j / n \"]\" : \"null\"
            printf \"]\" } printf \"]}\" }" > d.json
}
edges='i % n == 0 || j % n == 0'
square harmonic '{"type": "bezier", "degree": 65}' 65 "$edges" ', "fit": true'
refused 4 'degree /v/degree found 65 expected 64' make d.json
square biharmonic '{"type": "bezier", "degree": 19}' 19 "$edges" ''
refused 4 'ill-conditioned /u/degree found [0-9.]+ expected 100000000000' make d.json
square plateau '{"type": "bspline", "degree": 3, "count": 41}' 40 "$edges" ', "refine": 6'
refused 3 'size /refine found 5929225 expected 1000000' make d.json
square plateau '{"type": "h-bspline", "beta": 700, "segments": 96}' 98 "$edges" ''
refused 1 'gauss-points /points found 84934656 expected 60000000' make d.json
[ "$(wc -c < d.json)" -lt 65536 ] || complain "the net that asks for many Gauss points is no small document"
square plateau '{"type": "bspline", "degree": 2, "count": 52}' 51 "$edges" ', "tolerance_area": 1e-11'
refused 3 'size /tolerance_area found 2704 expected 2500' make d.json
for degree in 27 33; do # of a flat surface, continued with equal second derivatives
    square biharmonic "{\"type\": \"bezier\", \"degree\": $degree}" $degree 1 ''
    sed 's/"u": /"edge": "u1", "contact": "c2", "surface": {&/; s/,[0-9.]*\]/,0]/g; s/$/}/' d.json > "neighbour$degree.json"
done
refused 4 'ill-conditioned /surface found [0-9.]+ expected 2000000000' make neighbour27.json
refused 4 'degree /surface found 33 expected 32' make neighbour33.json
contains err.txt 'up to degree 64'

bonnet='"taut": 1, "construct": "bonnet", "sign": "-", "alpha": 1'
printf '{%s, "lambda": [0, 0.5], "beta": 1, "frames": 100001}' "$bonnet" > d.json
refused 3 'value /frames found 100001 expected a whole number from 2 to 100000' make d.json
printf '{%s, "lambda": 0.5, "beta": 1, "mesh": "bspline", "segments": [1, 500001]}' "$bonnet" > d.json
refused 3 'value /segments/1 found 500001 expected a whole number from 1 to 500000' make d.json
printf '{%s, "lambda": [0, 0.5], "beta": 1, "mesh": "bspline", "segments": [97, 97], "frames": 5001}' "$bonnet" > d.json
refused 3 'size /frames found 50010000 expected 50000000' make d.json
printf '{%s, "lambda": 0.5, "beta": 178}' "$bonnet" > d.json
refused 4 'far-window /beta found 178 expected 177' make d.json
awk 'BEGIN { printf "["; for (i = 0; i <= 100000; i++) printf "%s{}", i ? "," : ""; printf "]" }' > d.json
refused 3 'size d\.json found null expected an array of at most 100000 problems' make d.json
too_much 'value /curves/0/points/0/2 found null expected a number, or a rational one as \\"3/4\\", not too large and in at most 20000 bytes' "{\"taut\": 1, \"curves\": [{\"t\": $line, \"points\": [[0, 0, \"1/$(awk 'BEGIN {
    for (i = 0; i < 20000; i++) printf "9" }')\"], [1, 0, 0]]}]}"

# Files that are too large are not read; those that are none are told as such.
if truncate -s 4000000001 d.json 2> /dev/null; then
    refused 5 'large d\.json found 4000000001 expected 4000000000' measure d.json
fi
rm d.json

curve "$line" > line.json
refused 2 'value --grid 20001 found 20001 expected a whole number from 2 to 20000' measure line.json --grid 20001
refused 2 'value --threads 257 found 257 expected a whole number from 1 to 256' measure line.json --threads 257
refused 2 'value --divide 1001 found 1001 expected a whole number from 1 to 1000' convert line.json -o x.obj --divide 1001
refused 2 'value --isolines 101 found 101 expected a whole number from 1 to 100' convert line.json -o x.svg --isolines 101
refused 2 'value --reflections 101 found 101 expected a whole number from 1 to 100' convert line.json -o x.svg --reflections 101
refused 2 'value --width 2401 found 2401 expected a whole number from 16 to 2400' convert line.json -o x.svg --width 2401
# shellcheck disable=SC2046
refused 2 'operand' convert $(awk 'BEGIN { for (i = 0; i < 13; i++) print "line.json" }') -o x.svg
contains err.txt 'it takes 12 at most'
awk 'BEGIN { printf "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 26}, \"points\": ["
    for (i = 0; i <= 26; i++) printf "%s[%d,0,0]", i ? "," : "", i
    printf "]}]}" }' > high.json
if [ -e "$(dirname "$TAUT")/../libexec/taut-cad" ]; then
    refused 4 'degree' convert high.json -o x.step
    contains err.txt 'none above 25"'
fi
refused 2 'value --tolerance 1e-15 found 1e-15 expected a number from 1e-14 to 1' convert line.json -o x.obj --tolerance 1e-15
# shellcheck disable=SC2046
refused 2 'option' eval line.json $(awk 'BEGIN { for (i = 0; i <= 4096; i++) printf "--at 0 " }')
contains err.txt 'more than 4096 times'
awk 'BEGIN {
    printf "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 20}, "
    printf "\"v\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 20}, \"points\": ["
    for (i = 0; i < 20; i++) { printf "%s[", i ? "," : ""
        for (j = 0; j < 20; j++) printf "%s[%d,%d,0]", j ? "," : "", i, j
        printf "]" }
    printf "]}]}" }' > plane.json
refused 2 'too-fine x\.obj found 361038001 expected 50000000' convert plane.json -o x.obj --divide 1000
absent x.obj

# Whoever waits for five seconds of work is told, also through a pipe: here for the area of a net that folds over.
awk 'BEGIN {
    srand(1)
    printf "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bezier\", \"degree\": 40}, "
    printf "\"v\": {\"type\": \"bezier\", \"degree\": 40}, \"points\": ["
    for (i = 0; i <= 40; i++) { printf "%s[", i ? "," : ""
        for (j = 0; j <= 40; j++) printf "%s[%.3f,%.3f,%.3f]", j ? "," : "", rand(), rand(), rand()
        printf "]" }
    printf "]}]}" }' > folded.json
: > err.txt
"$TAUT" measure folded.json > /dev/null 2> err.txt &
pid=$!
tries=0
while [ ! -s err.txt ] && [ $tries -lt 600 ] && kill -0 $pid 2> /dev/null; do
    sleep 0.1
    tries=$((tries + 1))
done
kill $pid 2> /dev/null
wait $pid 2> /dev/null
contains err.txt '`taut measure` has worked for 5 s'
[ "$(wc -l < err.txt)" = 1 ] || complain "five seconds: $(cat err.txt)"
finish
