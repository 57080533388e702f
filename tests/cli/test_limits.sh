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

# too_much PATTERN DOCUMENT: refused as a document, with the pattern in the message
too_much() {
    printf '%s' "$2" > d.json
    refused 3 "$1" measure d.json
}
curve() { # curve BASIS: a model of one curve on it
    printf '{"taut": 1, "curves": [{"t": %s, "points": [[0, 0, 0], [1, 0, 0]]}]}' "$1"
}
line='{"type": "bezier", "degree": 1}'

too_much 'from 1 to 128$' "$(curve '{"type": "bezier", "degree": 129}')"
too_much 'from 1 to 1000000$' "$(curve '{"type": "bspline", "degree": 3, "count": 1000001}')"
too_much '1 to 999997$' "$(curve '{"type": "c-bspline", "alpha": 1, "segments": 999998}')"
too_much 'at most 1e\+60' "$(curve '{"type": "bspline", "degree": 1, "knots": [0, 0, 1e61, 1e61]}')"
too_much 'at most 1e\+60' "$(curve '{"type": "bezier", "degree": 1, "range": [0, 2e60]}')"
too_much 'narrower than 1e-60' "$(curve '{"type": "bezier", "degree": 1, "range": [0, 1e-61]}')"
too_much 'at least 1e-60' "$(curve '{"type": "c-bezier", "alpha": 1e-61}')"
too_much 'at most 700' "$(curve '{"type": "h-bezier", "beta": 701}')"
too_much 'at most 1000 ' "$(curve '{"type": "ce-bezier", "alpha": 1001, "beta": 0, "gamma": 0}')"
name=$(awk 'BEGIN { for (i = 0; i < 256; i++) printf "x" }')
too_much 'at most 255$' "{\"taut\": 1, \"curves\": [{\"name\": \"$name\", \"t\": $line, \"points\": [[0, 0, 0], [1, 0, 0]]}]}"
too_much 'at most 1000$' "$(awk 'BEGIN {
    printf "{\"taut\": 1, \"details\": {"
    for (i = 0; i <= 1000; i++) printf "%s\"a%d\": 1", i ? ", " : "", i
    printf "}}" }')"
too_much 'more than 256 ' "$(awk 'BEGIN {
    printf "{\"taut\": 1, \"details\": {\"a\": "
    for (i = 0; i < 257; i++) printf "["
    for (i = 0; i < 257; i++) printf "]"
    printf "}}" }')"
awk -v line="$line" 'BEGIN {
    printf "{\"taut\": 1, \"curves\": ["
    for (i = 0; i <= 100000; i++) printf "%s{\"t\": %s, \"points\": [[0, 0, 0], [1, 0, 0]]}", i ? "," : "", line
    printf "]}" }' > d.json
refused 3 'at most 100000 ' measure d.json
printf '{"taut": 1, "construct": "asymptotic", "degree": 9, "corners": {}, "edges": {}}' > d.json
refused 3 'from 3 to 8$' make d.json
printf '{"taut": 1, "construct": "harmonic", "u": {"type": "bezier", "degree": 25}, "v": {"type": "bezier", "degree": 25},
"points": [' > d.json
awk 'BEGIN { for (i = 0; i <= 25; i++) { printf "%s[", i ? ",\n" : ""
    for (j = 0; j <= 25; j++) printf "%s%s", j ? ", " : "", i % 25 ? "null" : "[" i ", " j ", 0]"
    printf "]" } printf "]}" }' >> d.json
refused 4 '1e\+?15' make d.json

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
refused 4 'to degree 64' make d.json
square biharmonic '{"type": "bezier", "degree": 19}' 19 "$edges" ''
refused 4 '1e\+?11' make d.json
square plateau '{"type": "bspline", "degree": 3, "count": 41}' 40 "$edges" ', "refine": 6'
refused 3 'at most 1000000$' make d.json
square plateau '{"type": "h-bspline", "beta": 700, "segments": 96}' 98 "$edges" ''
refused 1 'at most 6e\+?07' make d.json
[ "$(wc -c < d.json)" -lt 65536 ] || complain "the net that asks for many Gauss points is no small document"
square plateau '{"type": "bspline", "degree": 2, "count": 52}' 51 "$edges" ', "tolerance_area": 1e-11'
refused 3 'at most 2500' make d.json
for degree in 27 33; do # of a flat surface, continued with equal second derivatives
    square biharmonic "{\"type\": \"bezier\", \"degree\": $degree}" $degree 1 ''
    sed 's/"u": /"edge": "u1", "contact": "c2", "surface": {&/; s/,[0-9.]*\]/,0]/g; s/$/}/' d.json > "neighbour$degree.json"
done
refused 4 '2e\+?09' make neighbour27.json
refused 4 'at most 32.*up to degree 64' make neighbour33.json

bonnet='"taut": 1, "construct": "bonnet", "sign": "-", "alpha": 1'
printf '{%s, "lambda": [0, 0.5], "beta": 1, "frames": 100001}' "$bonnet" > d.json
refused 3 'to 100000$' make d.json
printf '{%s, "lambda": 0.5, "beta": 1, "mesh": "bspline", "segments": [1, 500001]}' "$bonnet" > d.json
refused 3 'to 500000$' make d.json
printf '{%s, "lambda": [0, 0.5], "beta": 1, "mesh": "bspline", "segments": [97, 97], "frames": 5001}' "$bonnet" > d.json
refused 3 'at most 50000000$' make d.json
printf '{%s, "lambda": 0.5, "beta": 178}' "$bonnet" > d.json
refused 4 'at most 177' make d.json
awk 'BEGIN { printf "["; for (i = 0; i <= 100000; i++) printf "%s{}", i ? "," : ""; printf "]" }' > d.json
refused 3 'at most 100000 problems' make d.json
too_much 'at most 20000 ' "{\"taut\": 1, \"curves\": [{\"t\": $line, \"points\": [[0, 0, \"1/$(awk 'BEGIN {
    for (i = 0; i < 20000; i++) printf "9" }')\"], [1, 0, 0]]}]}"

# Files that are too large are not read; those that are none are told as such.
if truncate -s 4000000001 d.json 2> /dev/null; then
    refused 5 'larger than the 4000000000 bytes' measure d.json
fi
rm d.json

curve "$line" > line.json
refused 2 '2 to 20000$' measure line.json --grid 20001
refused 2 '1 to 256$' measure line.json --threads 257
refused 2 '1 to 1000$' convert line.json -o x.obj --divide 1001
refused 2 '1 to 100$' convert line.json -o x.svg --isolines 101
refused 2 '1 to 100$' convert line.json -o x.svg --reflections 101
refused 2 '16 to 2400$' convert line.json -o x.svg --width 2401
# shellcheck disable=SC2046
refused 2 '12 at most$' convert $(awk 'BEGIN { for (i = 0; i < 13; i++) print "line.json" }') -o x.svg
awk 'BEGIN { printf "{\"taut\": 1, \"curves\": [{\"t\": {\"type\": \"bezier\", \"degree\": 26}, \"points\": ["
    for (i = 0; i <= 26; i++) printf "%s[%d,0,0]", i ? "," : "", i
    printf "]}]}" }' > high.json
[ ! -e "$(dirname "$TAUT")/../modules/taut-occt.so" ] || refused 4 'above 25$' convert high.json -o x.step
refused 2 'from 1e-14 to 1$' convert line.json -o x.obj --tolerance 1e-15
# shellcheck disable=SC2046
refused 2 'more than 4096 times' eval line.json $(awk 'BEGIN { for (i = 0; i <= 4096; i++) printf "--at 0 " }')
awk 'BEGIN {
    printf "{\"taut\": 1, \"surfaces\": [{\"u\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 20}, "
    printf "\"v\": {\"type\": \"bspline\", \"degree\": 1, \"count\": 20}, \"points\": ["
    for (i = 0; i < 20; i++) { printf "%s[", i ? "," : ""
        for (j = 0; j < 20; j++) printf "%s[%d,%d,0]", j ? "," : "", i, j
        printf "]" }
    printf "]}]}" }' > plane.json
refused 2 'at most 50000000 ' convert plane.json -o x.obj --divide 1000
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
