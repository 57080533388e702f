# test_harmonic.sh -- harmonic surfaces by the program alone: merging of pieces, ranges far from 0, what is said of planar nets.
. "$SOURCE/tests/cli/cli.sh"

# surface FILE NAME: one surface of a model, on one line.
surface() {
    "$TAUT" convert "$1" --surface "$2" -o - | tr -d ' \n' | sed 's/.*"surfaces":\[\({.*\]\]\]\)}\].*/\1}/'
}

# merge A B EDGE [MORE]: the problem of merging two pieces, each a file with a surface on one line.
merge() {
    printf '{"taut": 1, "construct": "harmonic-extension", "edge": "%s", "surface": %s, "neighbour": %s%s}\n' \
        "$3" "$(cat "$1")" "$(cat "$2")" "${4:-}" > problem.json
}

# Two pieces of a surface, merged across all four edges, are the surface again.
run 0 make "$SOURCE/examples/harmonic-rows.json" -o whole.json
for direction in u v; do
    run 0 split whole.json --$direction 0.375 -o pieces.json
    surface pieces.json harmonic-0 > low
    surface pieces.json harmonic-1 > high
    merge low high ${direction}1
    run 0 make problem.json -o merged.json
    run 0 join merged.json h.${direction}0 whole.json ${direction}0 --json
    contains out.txt '"max_gap": ([0-9.]+e-1[0-9]|0),'
    merge high low ${direction}0
    run 0 make problem.json -o merged.json
    contains err.txt 'harmonic +holds'
    contains merged.json '"name": "h"'

    # Pieces that are others are refused, each way by its name.
    merge low low ${direction}1
    refused 4 'other-surface /neighbour found 0\.[0-9]+' make problem.json -o no.json
    merge high low ${direction}1
    refused 4 'other-surface /neighbour' make problem.json -o no.json
    absent no.json
done
printf '{"name": "b", "u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1}, "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]}' > bilinear
merge low bilinear v1
refused 4 'other-surface /neighbour' make problem.json -o no.json
contains err.txt 'degrees are 1 and 1, the surface.s 3 and 3'
merge low high v1 ', "width": 2'
refused 3 'conflict /neighbour' make problem.json -o no.json
merge low high v1 ', "contact": "g1"'
refused 3 'conflict /neighbour' make problem.json -o no.json

# Exactly: at 0.3, where 1 - 0.3 is no double; a digit that doubles cannot hold is one too many.
run 0 make "$SOURCE/examples/harmonic-exact.json" --exact --quiet -o exact.json 2> /dev/null
if grep -q '16/45' exact.json; then
    run 0 split exact.json --u 0.3 --exact -o pieces.json
    surface pieces.json p-0 > low
    surface pieces.json p-1 > high
    merge low high u1
    run 0 make problem.json --exact -o merged.json
    contains err.txt 'harmonic +holds \([a-z]+\): 0, limit 0'
    [ "$(surface merged.json h | sed 's/.*"points"//')" = "$(surface exact.json p | sed 's/.*"points"//')" ] ||
        complain "the pieces merged are not the whole, digit for digit"
    sed 's|"7/10"|"7000000000000000000000000000001/10000000000000000000000000000000"|' high > near
    if ! cmp -s near high; then
        merge low near u1
        run 0 make problem.json -o merged.json
        refused 4 'other-surface /neighbour' make problem.json --exact -o no.json
    else
        complain "no coordinate was changed: $(cat high)"
    fi
fi

# A range far from 0, where parameters are few: the same figures, and extensions to parameters there are.
at() { # at RANGE: the rows over it in u
    sed 's/"u": { "type": "bezier", "degree": 3 }/"u": { "type": "bezier", "degree": 3, "range": '"$1"' }/' "$SOURCE/examples/harmonic-rows.json"
}
at '[0, 1]' > near.json
at '[10000000, 10000001]' > far.json
grep -q 10000001 far.json || complain "the example has another form"
for k in near far; do
    run 0 make $k.json -o $k.out.json
    grep -E 'dirichlet|isothermality' err.txt > $k.figures
done
cmp -s near.figures far.figures || complain "figures of a range far from 0: $(cat near.figures far.figures)"
printf '{"taut": 1, "construct": "harmonic-extension", "edge": "u1", "width": 0.7, "surface": %s}\n' "$(surface far.out.json harmonic)" > problem.json
run 0 make problem.json -o extended.json
contains err.txt 'harmonic +holds'

# Biharmonic neighbours too are of least bending there.
sed 's/"u": {[^}]*}/"u": {"type": "bezier", "degree": 4, "range": [10000000, 10000001]}/' "$SOURCE/examples/biharmonic-c1.json" > far.json
grep -q 10000001 far.json || complain "the example has another form"
for contact in c1 c2; do
    sed 's/"contact": "[^"]*"/"contact": "'$contact'"/' far.json > problem.json
    run 0 make problem.json -o neighbour.json
    contains err.txt 'least-bending +holds'
    run 0 certify neighbour.json
done

# The nearest surface to four rows is as near there; and numbers so small that doubles have few digits for them are no failure.
sed 's/"u": *{[^}]*}/"u": {"type": "bezier", "degree": 4, "range": [10000000.125, 10000001]}/' "$SOURCE/examples/harmonic-fit.json" > far.json
grep -q 10000001 far.json || complain "the example has another form"
run 0 make far.json -o fit.json
contains err.txt 'nearest +holds'
cat > small.json <<'JSON'
{ "taut": 1, "construct": "harmonic", "u": { "type": "bezier", "degree": 3 }, "v": { "type": "bezier", "degree": 3 },
  "points": [[[-3e-310, 7.1e-311, 0], [2.3e-310, 1e-310, 5e-324], [1.9e-310, -4.7e-310, 0], [0, 1e-310, 1e-310]],
             [null, null, null, null], [null, null, null, null],
             [[9e-311, 0, 0], [4.3e-310, 1e-311, 0], [-1.25e-310, 0, 2e-310], [3e-310, 1.3e-311, -9.9e-311]]] }
JSON
run 0 make small.json -o small.out.json

# The amplification is told of data from a derivative, rationally completed or not, and of biharmonic neighbours.
run 0 make "$SOURCE/examples/harmonic-derivative.json" -o d.json
grep amplification err.txt > rounded
contains rounded 'amplification +[1-9][0-9.]*$'
if grep -q '16/45' exact.json; then
    run 0 make "$SOURCE/examples/harmonic-derivative.json" --exact -o d.json
    grep amplification err.txt > exactly
    cmp -s rounded exactly || complain "amplification: $(cat rounded exactly)"
fi
run 0 make "$SOURCE/examples/biharmonic-c2.json" -o c2.json
contains err.txt 'amplification +[1-9][0-9.]*$'

# Planar nets: proved of one sign, turned over, folded and where, and nothing of what is not planar.
planar() { # planar NAME ROW: the square's net with this row at u = 1
    printf '{"taut": 1, "construct": "harmonic", "u": {"type": "bezier", "degree": 3}, "v": {"type": "bezier", "degree": 3},
      "points": [[[0,0,0],[0,1,0],[0,2,0],[0,3,0]],[null,null,null,null],[null,null,null,null],%s]}\n' "$2" > "$1.json"
    run 0 make "$1.json" --quiet -o "$1.out.json"
    run 0 measure "$1.out.json"
}
planar good '[[3,0,0],[4,1,0],[4,2,0],[3,3,0]]'
contains out.txt '^jacobian'
contains out.txt 'one_sign +yes$'
contains out.txt '  sign +1$'
contains out.txt 'lowest +(6|5[.]9999999)'
planar turned '[[-3,0,0],[-4,1,0],[-4,2,0],[-3,3,0]]'
contains out.txt 'one_sign +yes$'
contains out.txt '  sign +-1$'
planar folded '[[3,0,0],[-6,1,0],[4,2,0],[3,3,0]]'
contains out.txt 'one_sign +no$'
contains out.txt 'lowest +-105$'
contains out.txt 'lowest_at +1 0$'
planar line '[[3,0,0],[3,0,0],[3,0,0],[3,0,0]]'
contains out.txt 'one_sign +yes$'
run 0 measure whole.json
grep -q jacobian out.txt && complain "a surface in space has a Jacobian: $(cat out.txt)"

# Rows written to twelve digits: the repair that is asked for is made, and the surface is harmonic.
for even in corner project raise; do
    printf '{"taut": 1, "construct": "harmonic", "u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 2}, "even": "%s",
      "points": [[[0,0,0],[0,1,0],[0,2,0]],[null,null,null],[[1,0,0],[1,1,0.000000000001],[1,2,0]]]}\n' "$even" > almost.json
    run 0 make almost.json -o almost.out.json
    grep -q "\"kind\": \"$even\"" almost.out.json || complain "no $even: $(cat almost.out.json)"
done

# Edges told to too few digits for the condition of even degree: the claim says so, and is no leave for other errors.
printf '{"taut": 1, "construct": "harmonic", "u": {"type": "bezier", "degree": 4}, "v": {"type": "bezier", "degree": 4}, "points": [
[[0,0,0],[0,1,1],[0,2,0.3],[0,3,1],[0,4,0]],[null,null,null,null,null],[null,null,null,null,null],[null,null,null,null,null],
[[4,0,0],[4,1,1],[4,2,0.3],[4,3,1],[4,4,1e-11]]]}\n' > short.json
run 0 make short.json -o short.out.json
contains err.txt 'harmonic +undecided \([a-z]+\): .*miss the condition of a harmonic patch by 1e-11.*"even" can repair'
if python_with json; then
    "$PYTHON" -c 'import json
m = json.load(open("short.out.json"))
m["surfaces"][0]["points"][2][2][2] += 1e-11
json.dump(m, open("moved.json", "w"))'
    run 1 certify moved.json short.json
    cat out.txt err.txt > said.txt
    contains said.txt "harmonic +DOES NOT HOLD"
else
    missing python3 'tools/deps.sh test'
fi
finish
