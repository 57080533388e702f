# test_operate.sh -- split, refine, join: the pieces are the whole, in the right order, and refusals.
. "$SOURCE/tests/cli/cli.sh"

cat > patch.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "p", "u": { "type": "bspline", "degree": 2, "count": 4 },
    "v": { "type": "h-bezier", "beta": 1.5 },
    "points": [[[0,0,0],[0,1,1],[0,2,0],[0,3,1]], [[1,0,0],[1,1,2],[1,2,0],[1,3,1]],
               [[2,0,1],[2,1,1],[2,2,0],[2,3,0]], [[3,0,0],[3,1,1],[3,2,0],[3,3,1]]] } ],
  "curves": [ { "name": "c", "t": { "type": "ce-bezier", "alpha": 0, "beta": 1, "gamma": 0.5 },
    "points": [[0,0,0],[1,0,0],[1,1,0],[1,1,1]] } ] }
JSON
at() { # at MODEL NAME U,V: the point
    "$TAUT" eval "$1" --surface "$2" --at "$3" --json | tr -d ' \n' | sed 's/.*"point":\[\([^]]*\)\].*/\1/'
}
near() { # near A B: two lists of numbers agree to 1e-14
    printf '%s\n%s\n' "$1" "$2" | awk -F, 'NR == 1 { split($0, a) } NR == 2 { for (i = 1; i <= NF; i++) {
        d = a[i] - $i; if (d < 0) d = -d; if (!(d <= 1e-14) || NF != 3) exit 1 } }' ||
        complain "$1 is not $2"
}

absent_word() { # absent_word FILE WORD
    ! grep -q -- "$2" "$1" || complain "$1 holds $2"
}

run 0 split patch.json --u 0.3 -o halves.json
near "$(at halves.json p-0 0.2,0.7)" "$(at patch.json p 0.2,0.7)"
near "$(at halves.json p-1 0.9,0.7)" "$(at patch.json p 0.9,0.7)"
run 0 join halves.json p-0.u1 halves.json p-1.u0 --json
contains out.txt '"c_order": 3'
contains out.txt '"g_order": 3'
# several cuts, in any order: each of the pieces that it is inside of
run 0 split patch.json --u 0.6,0.3 -o thirds.json
[ "$(grep -c '"u": {' thirds.json)" = "$(( $(grep -c '"u": {' halves.json) / 2 * 3 ))" ] || complain "two cuts leave $(grep -c '"u": {' thirds.json) pieces"
refused 2 'value --u 0\.3,x' split patch.json --u 0.3,x
refused 2 'value --u 0\.3,' split patch.json --u 0.3,
refused 2 'option' split patch.json --u 0.3,0.6 --exact
run 0 split patch.json --v 1 --surface p -o other.json
near "$(at other.json p-1 0.4,1.2)" "$(at patch.json p 0.4,1.2)"
run 0 refine patch.json -o fine.json
near "$(at fine.json p 0.4,1.2)" "$(at patch.json p 0.4,1.2)"
contains fine.json 'h-bspline'
run 0 refine patch.json --u -o fine.json
contains fine.json 'h-bezier'
run 0 join patch.json p.u0 patch.json u1 --json
contains out.txt '"c_order": -1'

# Bezier extraction: the spans of the spline times one h-bezier piece, and the quartic.
run 0 convert patch.json --pieces -o pieces.json
[ "$(grep -c '"name": "p-' pieces.json)" = 2 ] || complain "two patches"
near "$(at pieces.json p-0 0.3,1.2)" "$(at patch.json p 0.3,1.2)"
near "$(at pieces.json p-1 0.9,0.4)" "$(at patch.json p 0.9,0.4)"
contains pieces.json '"degree": 4'
absent_word pieces.json 'bspline'
absent_word pieces.json 'ce-bezier'
run 0 convert patch.json --pieces --surface p -o pieces.json
contains pieces.json 'ce-bezier'
run 0 convert patch.json --pieces --tolerance 1e-6 -o pieces.json
absent_word pieces.json 'h-bezier'
refused 2 'operand' convert patch.json patch.json --pieces -o both.svg
contains err.txt 'one model at a time'
refused 2 'no-such-object patch\.json' convert patch.json --pieces --surface q -o none.json

refused 4 'parameter /surfaces/0 found 1\.5 expected 1' split patch.json --u 1.5
refused 4 'parameter /surfaces/0 found 0 expected 0' split patch.json --u 0
refused 2 'option' split patch.json
contains err.txt 'one of --u'
refused 2 'option' split patch.json --u 0.1 --v 0.1
contains err.txt 'one of --u'
refused 2 'value --u half found null expected a number' split patch.json --u half
refused 2 'value' join patch.json top patch.json u0
contains err.txt 'found edge .*top.*, expected u0, u1, v0, v1 or'
refused 2 'name' join patch.json q.u1 patch.json u0
contains err.txt 'q\.u1'
refused 2 'name' join halves.json u1 patch.json u0
contains err.txt 'expected NAME\.u1'
refused 2 'no-such-object patch\.json' split patch.json --u 0.5 --surface q
finish
