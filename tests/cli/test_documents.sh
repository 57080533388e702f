# test_documents.sh -- documents that are wrong: the exit code, the place, what was found and expected.
. "$SOURCE/tests/cli/cli.sh"

B='{"type":"bspline","degree":2,"count":3}'
P='[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'

# document CODE PATTERN TEXT
document() {
    printf '%s' "$3" > d.json
    refused "$1" "$2" make d.json -o never.json
    absent never.json
}
# problem CODE PATTERN U V POINTS [MORE]
problem() {
    document "$1" "$2" "{\"taut\":1,\"construct\":\"dirichlet\",\"u\":$3,\"v\":$4,\"points\":[$5]${6:-}}"
}

# JSON that is none.
document 3 'syntax d\.json:1:1' ''
document 3 'syntax d\.json:1:11' '{"taut":1,'
document 3 'twice d\.json:2:1' '{"taut":1,
"taut":1}'
document 3 'type /0 found 1' '[1,2,3]'
document 3 'type d\.json' '"text"'
document 3 'syntax d\.json:1:36' '{"taut":1,"construct":"dirichlet"} more'
document 3 'depth d\.json:1:257' "$(awk 'BEGIN { for (i = 0; i < 100000; i++) printf "[" }')"
printf '\377\376{}' > d.json
refused 3 'syntax d\.json:1:1' make d.json

# A file by its whole name is named once.
printf '{"taut":1,' > d.json
refused 3 "syntax $work/d\\.json:1:11" make "$work/d.json"
refused 3 "syntax $work/d\\.json:1:11" measure "$work/d.json"
for command in make measure; do
    run 3 $command "$work/d.json"
    contains err.txt "^taut: $work/d\\.json:1:"
done

# Members.
document 3 'missing /taut found null expected 1,.*' '{"construct":"dirichlet"}'
document 3 'version /taut found 2 expected 1,.*' '{"taut":2,"construct":"dirichlet"}'
document 3 'missing /construct' '{"taut":1}'
document 3 'name /construct found null expected .*dirichlet.*' '{"taut":1,"construct":"dirichlte"}'
problem 3 'unknown-member /wieghts found null expected .*weights.*' "$B" "$B" "$P" ',"wieghts":[]'
problem 3 'name /unit' "$B" "$B" "$P" ',"unit":"parsec"'
problem 3 'size /points/1 found null expected an array of 3 points.*' "$B" "$B" '[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 'type /points/0/1' "$B" "$B" '[[0,0,0],[0,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 'value /points/0/1/2' "$B" "$B" '[[0,0,0],[0,1,"one"],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 'value d\.json:1:147' "$B" "$B" '[[0,0,0],[0,1,1e400],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 'size /points' "$B" "$B" ''
problem 3 'value /weights/1/1 found 0' "$B" "$B" "$P" ',"weights":[[1,1,1],[1,0,1],[1,1,1]]'
problem 3 'value /weights/1/1 found -1' "$B" "$B" "$P" ',"weights":[[1,1,1],[1,-1,1],[1,1,1]]'
problem 3 'value /aspect found -1' "$B" "$B" "$P" ',"aspect":-1'
problem 3 'type /aspect' "$B" "$B" "$P" ',"aspect":"wide"'

# Bases: every row of what is legal, broken.
problem 3 'name /u/type' '{"type":"spline"}' "$B" "$P"
problem 3 'value /u/degree found 0' '{"type":"bspline","degree":0,"count":3}' "$B" "$P"
problem 3 'value /u/degree found 1\.5' '{"type":"bspline","degree":1.5,"count":3}' "$B" "$P"
problem 3 'size /u/count found 3 expected 4' '{"type":"bspline","degree":3,"count":3}' "$B" "$P"
problem 3 'size /u/knots found 5 expected 6' '{"type":"bspline","degree":2,"knots":[0,0,0,1,1]}' "$B" "$P"
problem 3 'knots /u/knots found 0 expected 0' '{"type":"bspline","degree":2,"knots":[0,0,0,0,0,0]}' "$B" "$P"
problem 3 'knots /u/knots found null expected 3' '{"type":"bspline","degree":2,"knots":[0,0,0.5,1,1,1]}' "$B" "$P"
problem 3 'knots /u/knots/4 found 0\.5 expected 1' '{"type":"bspline","degree":2,"knots":[0,0,0,1,0.5,1]}' "$B" "$P"
problem 3 'type /v/knots/1' "$B" '{"type":"bspline","degree":2,"knots":[0,null,0,1,1,1]}' "$P"
problem 3 'unknown-member /v/alpha' "$B" '{"type":"bezier","degree":2,"alpha":1}' "$P"
problem 3 'basis /v' '{"type":"bezier","degree":1}' '{"type":"ce-bezier","alpha":0,"beta":0,"gamma":0}' \
    '[[0,0,0],[0,1,1],[0,2,0],[0,3,0]],[[1,0,0],null,[1,2,0],[1,3,0]]'
problem 3 'knots /u/knots/3 found 2 expected 1' '{"type":"bspline","degree":1,"knots":[0,0,1,1,2,2]}' "$B" "$P,[[3,0,0],[3,1,1],[3,2,0]]"

# Well formed, but there is no such surface.
problem 4 'nothing-known /points found 0 expected 1' "$B" "$B" '[null,null,null],[null,null,null],[null,null,null]'

# Harmonic surfaces: what does not exist, each by its own name.
Q='{"type":"bezier","degree":2}'
harmonic() { # harmonic CODE PATTERN U V POINTS [MORE]
    document "$1" "$2" "{\"taut\":1,\"construct\":\"harmonic\",\"u\":$3,\"v\":$4,\"points\":[$5]${6:-}}"
}
R='[[0,0,0],[0,1,1],[0,2,0]],[null,null,null],[[2,0,0],[2,1,0],[2,2,0]]'
harmonic 4 'inconsistent /points found 2' "$Q" "$Q" "$R"
contains err.txt 'inconsistent boundary.*even'
harmonic 3 'name /even' "$Q" "$Q" "$R" ',"even":"mend"'
harmonic 3 'mask /points' "$Q" "$Q" "$P"
contains err.txt 'two opposite'
harmonic 4 'degree /u/degree found 1 expected 2' '{"type":"bezier","degree":1}' "$Q" '[[0,0,0],[0,1,1],[0,2,0]],[[2,0,0],[2,1,0],[2,2,0]]'
harmonic 3 'not-bezier /u found null expected .*bezier.*' "$B" "$Q" "$R"
harmonic 3 'mask /points' "$Q" "$Q" "$R" ',"fit":true'
contains err.txt 'four boundary rows'
harmonic 3 'conflict /fit' "$Q" "$Q" "$R" ',"fit":true,"even":"corner"'
harmonic 3 'type /fit found 1 expected true or false' "$Q" "$Q" "$R" ',"fit":1'
D='{"taut":1,"construct":"harmonic","from":"derivative","u":{"type":"bezier","degree":2},"v":{"type":"bezier","degree":2}'
document 4 'inconsistent /cross_derivative found 2' "$D,\"edge\":[[0,0,0],[0,1,1],[0,2,0]],\"cross_derivative\":[[1,0,0],[1,0,1],[1,0,0]]}"
contains err.txt 'inconsistent derivative'
document 3 'size /edge found null expected an array of 3 points' "$D,\"edge\":[[0,0,0],[0,1,1]],\"cross_derivative\":[[1,0,0],[1,0,1],[1,0,0]]}"
document 3 'type /even' "$D,\"even\":\"corner\",\"edge\":[[0,0,0],[0,1,1],[0,2,0]],\"cross_derivative\":[[1,0,0],[1,0,0],[1,0,0]]}"
X='{"taut":1,"construct":"harmonic-extension","surface":{"u":{"type":"bezier","degree":2},"v":{"type":"bezier","degree":2},"points":[[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],[1,1,0],[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]]}'
document 4 'not-harmonic /surface found 0\.25 expected 1e-10' "$X,\"edge\":\"u1\"}"
document 3 'name /edge' "$X,\"edge\":\"top\"}"
document 3 'value /width found 0' "$X,\"edge\":\"u1\",\"width\":0}"
document 3 'conflict /alpha' "$X,\"edge\":\"u1\",\"alpha\":1}"

# Biharmonic surfaces.
biharmonic() { # biharmonic CODE PATTERN U V POINTS [MORE]
    document "$1" "$2" "{\"taut\":1,\"construct\":\"biharmonic\",\"u\":$3,\"v\":$4,\"points\":[$5]${6:-}}"
}
W='[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]'
biharmonic 3 'mask /points' "$Q" "$Q" "$R"
contains err.txt 'four boundary rows'
biharmonic 3 'not-bezier /u found null expected .*bezier.*' "$B" "$Q" "$W"
biharmonic 3 'conflict /edge' "$Q" "$Q" "$W" ',"edge":"u1"'
biharmonic 4 'degree /v/degree found 2 expected 3' '{"type":"bezier","degree":3}' "$Q" \
    '[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],null,[2,2,0]],[[3,0,0],[3,1,0],[3,2,0]]'
contains err.txt 'raise the lower'
Y=$(printf '%s' "$X" | sed 's/harmonic-extension/biharmonic/')
document 3 'missing /edge' "$Y}"
document 3 'name /contact found null expected .*c1.*' "$Y,\"edge\":\"u1\",\"contact\":\"g1\"}"
document 3 'value /width found -1' "$Y,\"edge\":\"u1\",\"width\":-1}"
document 3 'conflict /name' "$Y,\"edge\":\"u1\",\"name\":\"q\"}"
document 4 'degree /surface found 2 expected 1' "$(printf '%s' "$Y" | sed 's/"degree":2},"points"/"degree":1},"points"/; s/,\[[0-9],2,0\]//g'),\"edge\":\"u1\"}"
finish
