# test_exact.sh -- rational arithmetic: Example 2.1 of [NiWang2015] fraction by fraction, there and back, and refusals.
. "$SOURCE/tests/cli/cli.sh"

if [ "$("$TAUT" make "$SOURCE/examples/harmonic-exact.json" --exact --quiet -o here.json 2>&1 | grep -c 'not installed')" = 1 ]; then
    echo "built without FLINT: rational arithmetic is refused by name, and there is nothing more to see"
    finish
fi
row() { # row FILE A B C D: a row of four points with these coordinates, quoted
    wanted=$(printf '%s' "[[$2], [$3], [$4], [$5]]" | sed 's/\([-0-9/]\{1,\}\)/"\1"/g')
    grep -qF -- "$wanted" "$1" || complain "$1 has no row $wanted"
}

# Completion: rows 1 and 2 as printed.
run 0 make "$SOURCE/examples/harmonic-exact.json" --exact -o p.json
row p.json '-1, 0, 1' '-1, 3/4, 1' '-1/2, 5/4, 1' '1/2, 5/4, 1'
row p.json '-5/12, -1/5, 2/3' '-5/12, 16/45, 2/3' '0, 32/45, 2/3' '5/6, 19/30, 2/3'
row p.json '-1/3, -3/20, 1/3' '-1/3, 53/180, 1/3' '0, 53/90, 1/3' '2/3, 31/60, 1/3'
contains err.txt 'harmonic +holds \([a-z]+\): 0, limit 0, at in rational arithmetic'

# Extension and merged surface.
extend() { # extend EDGE [MORE]: of the surface in p.json
    tr -d '\n' < p.json | sed 's/.*"surfaces": \[ *\({.*}\) *\],  "details.*/{"taut":1,"construct":"harmonic-extension","edge":"'"$1"'"'"${2:-}"',"surface":\1}/' > problem.json
}
extend u1
run 0 make problem.json --exact -o q.json
row q.json '-2/3, 3/20, -1/3' '-2/3, 91/180, -1/3' '-1/2, 73/90, -1/3' '-1/6, 53/60, -1/3'
row q.json '-13/12, 2/5, -2/3' '-13/12, 7/9, -2/3' '-1, 52/45, -2/3' '-5/6, 41/30, -2/3'
row q.json '-3/2, 3/5, -1' '-3/2, 21/20, -1' '-3/2, 31/20, -1' '-3/2, 39/20, -1'
row q.json '1/6, -2/5, 1/3' '1/6, -7/180, 1/3' '1/2, 31/180, 1/3' '7/6, 1/60, 1/3'
row q.json '-2/3, 1/5, -1/3' '-2/3, 91/180, -1/3' '-1/2, 137/180, -1/3' '-1/6, 47/60, -1/3'
contains q.json '"merged_square_residual": 9'
run 0 certify q.json --exact
contains err.txt 'harmonic +holds \([a-z]+\): 0, limit 0'
run 0 join q.json p.u1 q.json extension.u0 --json
contains out.txt '"one_surface": true'
contains out.txt '"c_order": 3'

# The merged surface cut in two is both again, digit for digit.
run 0 split q.json --surface h --u 1 --exact -o s.json
points() { # points FILE NAME: the net of a surface on one line
    tr -d '\n ' < "$1" | sed "s/.*\"name\":\"$2\"//; s/.*\"points\"://" | sed 's/\]\]\].*/]]]/'
}
net() { # net FILE N: the N-th net
    grep -A5 '"points"' "$1" | grep '\[\[' | sed "$((4 * $2 - 3)),$((4 * $2))!d"
}
for k in 1 2; do
    net q.json $k > whole.txt
    net s.json $k > piece.txt
    [ -s whole.txt ] && [ "$(sed 's/,$//' whole.txt)" = "$(sed 's/,$//' piece.txt)" ] ||
        complain "piece $k is not what was merged"
done

# Other edges and widths: every residual is 0 itself.
for edge in u0 v0 v1; do
    extend $edge ',"width":0.375'
    run 0 make problem.json --exact -o r.json
    contains err.txt 'harmonic +holds \([a-z]+\): 0, limit 0'
done

# What is not harmonic to the last digit is not carried on.
sed 's|"16/45"|0.35555555555555557|' problem.json > decimal.json
refused 4 'not-harmonic /surface found [0-9.]+e-16 expected 0' make decimal.json --exact -o d.json
contains err.txt 'coordinates written as texts'
absent d.json

# A digit changed is noticed, where doubles would not.
sed 's|"32/45"|"32000000000000000000001/45000000000000000000000"|' p.json > wrong.json
run 0 certify wrong.json
run 1 certify wrong.json --exact

# Without --exact texts are numbers; they are refused where they are none.
run 0 make "$SOURCE/examples/harmonic-exact.json" -o d.json
contains d.json '0[.]71111111111111'
for bad in '1/0' '1/' '/2' '1.5' '+1' ' 1' '1/-2' '' 'x' '--1' '1e3' '1/00'; do
    sed "s|\"3/4\"|\"$bad\"|" "$SOURCE/examples/harmonic-exact.json" > bad.json
    refused 3 'value /points/0/1/1 found null expected .*rational.*' make bad.json
done

# Rows of even degree must agree exactly, or be mended.
cat > even.json <<'JSON'
{ "taut": 1, "construct": "harmonic", "u": { "type": "bezier", "degree": 2 }, "v": { "type": "bezier", "degree": 2 },
  "points": [[[0,0,0],[0,"1/3",1],[0,1,0]], [null,null,null], [[1,0,0],[1,"1/3","1/7"],[1,1,0]]] }
JSON
refused 4 'inconsistent /points found 1\.714[0-9]* expected 0' make even.json --exact
for mend in corner project raise; do
    sed "s/\"harmonic\",/\"harmonic\", \"even\": \"$mend\",/" even.json > mended.json
    run 0 make mended.json --exact -o m.json
    contains err.txt 'harmonic +holds \([a-z]+\): 0, limit 0'
    contains m.json "\"kind\": \"$mend\""
done
refused 2 'no-rationals .*/dirichlet-bicubic\.json' make "$SOURCE/examples/dirichlet-bicubic.json" --exact
refused 2 'no-rationals /fit' make "$SOURCE/examples/harmonic-fit.json" --exact
refused 2 'no-rationals /contact' make "$SOURCE/examples/harmonic-neighbour.json" --exact
cat > rational.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "w", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
  "points": [[[0,0,0],["1/3",0,0]],[[0,1,0],[1,1,0]]], "weights": [[1,1],[1,2]] } ] }
JSON
refused 4 'not-exact rational\.json' split rational.json --u 0.5 --exact
finish
