# test_asymptotic.sh -- asymptotic problems from documents: what is made, what is refused and how.
. "$SOURCE/tests/cli/cli.sh"

example=$SOURCE/examples

# Corner data, every branch told, a model that can be proved again.
run 0 make "$example/asymptotic-1.json" -o a.json --report r.json
contains err.txt 'curve energy +4\.563279376'
contains err.txt 'asymptotic +holds'
contains r.json '"branch": "\+-\+-"'
contains a.json '"name": "patch"'
run 0 certify a.json "$example/asymptotic-1.json"
run 0 certify a.json --json
contains out.txt '"construct": "asymptotic"'
run 0 make "$example/asymptotic-1-in.json" -o in.json
contains err.txt 'curve energy +5\.8807219272'
run 0 make "$example/asymptotic-low.json" -o low.json
contains err.txt 'degree +7'
run 1 certify low.json "$example/asymptotic-2.json"
contains err.txt 'boundary +DOES NOT HOLD'

# The curves of a model, given, make the same patch.
{
    printf '{ "taut": 1, "construct": "asymptotic", "curves": {'
    sed -n '/"curves": \[/,/^  \]/p' a.json | tr -d '\n' | sed 's/^ *"curves": \[//; s/ *\] *,* *$//' |
        sed 's/{ *"name": "\([uv][01]\)"/"\1": { "name": "\1"/g'
    printf '} }\n'
} > curves.json
run 0 make curves.json -o b.json
contains err.txt 'branch +-\+-\+'

# A curve whose second control point lies on its first has no direction there.
sed 's/\("v0": {.*"points": \[\)\(\[[^]]*\]\), *\[[^]]*\]\(.*"v1":\)/\1\2, \2\3/' curves.json > legless.json
refused 4 'no-leg /curves' make legless.json -o legless-made.json
contains err.txt 'control point of v0 beside corner u0v0'

# Curves that run the wrong way are named; no hint where that is not all.
ruled=$example/asymptotic-ruled.json
sed '/"u0"/s/"points": .*/"points": [[0, 1, 0], [0, 0, 0]] },/' "$ruled" > turned.json
refused 4 'not-closed /curves found 1' make turned.json -o turned-made.json
contains err.txt 'v0 and u0 do not meet at corner u0v0.*all four close with u0 reversed'
sed '/"u0"/s/"points": .*/"points": [[0, 0, 0], [0, 0.5, 0]] },/' "$ruled" > gap.json
refused 4 'not-closed /curves found 0\.5' make gap.json -o gap-made.json
contains err.txt 'at corner u0v1: the gap is 0\.5"'

# A far origin leaves too few digits of the coordinates.
sed 's/"u\([01]\)v\([01]\)": \[\([01]\), /"u\1v\2": [100000000000\3, /' "$example/asymptotic-1.json" > far.json
refused 3 'far-away /corners found 0\.00022[0-9]* expected 1e-6' make far.json -o far-made.json

# Numbers whose products leave the range of double are refused by name, not by what becomes of them.
sed 's/\("v0": {.*"points": \[\)\[[^]]*\], *\[[^]]*\]\(.*"v1":\)/\1[1, 0, 0], [1e300, 0, 1]\2/' curves.json > huge.json
refused 3 'too-large /curves found 1e300 expected 1e20' make huge.json -o huge-made.json
contains err.txt 'control point of v0'
for member in legs curvature weights; do
    case $member in legs) value='[[0, 1e300, 1], [0, 0.2, -0.1]]' ;; curvature) value='[1e-300, 1]' ;; *) value='[1e300, 1]' ;; esac
    tr -d '\n' < "$example/asymptotic-1.json" |
        sed 's/\("v0": *{[^}]*"'$member'": *\)\(\[\[[^]]*\], *\[[^]]*\]\]\|\[[^]]*\]\)/\1'"$value"'/' > extreme.json
    refused 3 "value /edges/v0/$member found 1e-?300 expected 1e-?30" make extreme.json -o extreme-made.json
done

# Example 3 is singular: refused with the place, or built and said.
sed 's/, *"singular": "report"//; s/"singular": "report"/"branch": "lowest"/' "$example/asymptotic-3.json" > three.json
refused 4 'singular three\.json found 0\.811599[0-9]*' make three.json -o c.json
contains err.txt 'edge v0 is singular'
absent c.json
run 1 make "$example/asymptotic-3.json" -o c.json
contains err.txt 'regular +DOES NOT HOLD'
[ -s c.json ] || complain "the singular model was not written"
run 1 make "$example/asymptotic-3.json" --quiet -o c.json -o c.step
contains err.txt '^taut: not all claims hold: regular; only JSON is written then, not c\.step$'
absent c.step

# What does not exist: 4, with the condition and what is nearest.
sed 's/"curvature": \[1, 1\]/"curvature": [1, 1.3]/; t' "$example/asymptotic-1.json" |
    awk '/curvature/ && !done { done = 1; print; next } { gsub(/\[1, 1\.3\]/, "[1, 1]"); print }' > open.json
refused 4 'closing /edges found -0\.2623[0-9]*' make open.json
contains err.txt 'nearest curvatures, each .*: v0 \['
sed 's/"degree": 4/"degree": 4, "branch": "++++"/' "$example/asymptotic-1.json" > branch.json
refused 4 'no-branch /branch' make branch.json
contains err.txt 'those that exist: -\+-\+ \+-\+-'
sed 's/"weights": \[1, 1\]/"weights": [1, 2]/' "$example/asymptotic-1.json" > unequal.json
refused 4 'end-weights /edges found 2 expected 1' make unequal.json
contains err.txt 'v0 and u1 differ at corner .*nearest weights: v0 \[1,1\.4142'

# The document is wrong: 3, with the pointer.
sed 's/"degree": 4/"degree": 9/' "$example/asymptotic-1.json" > degree.json
refused 3 'value /degree found 9' make degree.json
sed 's/"degree": 4/"degree": 4, "branch": "+-"/' "$example/asymptotic-1.json" > short.json
refused 3 'type /branch found null expected .*lowest.*' make short.json
sed 's/"degree": 4/"degree": 4, "surface": "n+2"/' "$example/asymptotic-1.json" > surface.json
refused 3 'name /surface' make surface.json
sed 's/"curvature"/"curvatures"/' "$example/asymptotic-1.json" > member.json
refused 3 'unknown-member /edges/v0/curvatures found null expected .*curvature.*' make member.json
sed 's/"degree": 4/"degree": 3/' "$example/asymptotic-1.json" > three-legs.json
refused 3 'size /edges/v0/legs' make three-legs.json
sed 's/"curves": {/"degree": 4, "curves": {/' curves.json > both.json
refused 3 'conflict /degree' make both.json
finish
