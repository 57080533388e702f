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
document 3 'd\.json' ''
document 3 'd\.json:1:' '{"taut":1,'
document 3 'd\.json:2:' '{"taut":1,
"taut":1}'
document 3 'd\.json' '[1,2,3]'
document 3 'd\.json' '"text"'
document 3 'd\.json:1:' '{"taut":1,"construct":"dirichlet"} more'
document 3 'd\.json' "$(awk 'BEGIN { for (i = 0; i < 100000; i++) printf "[" }')"
printf '\377\376{}' > d.json
refused 3 'd\.json' make d.json

# A file by its whole name is named once.
printf '{"taut":1,' > d.json
refused 3 "^taut: $work/d\\.json:1:" make "$work/d.json"
refused 3 "^taut: $work/d\\.json:1:" measure "$work/d.json"

# Members.
document 3 'taut' '{"construct":"dirichlet"}'
document 3 'taut' '{"taut":2,"construct":"dirichlet"}'
document 3 'construct' '{"taut":1}'
document 3 'dirichlet' '{"taut":1,"construct":"dirichlte"}'
problem 3 'weights' "$B" "$B" "$P" ',"wieghts":[]'
problem 3 '/unit' "$B" "$B" "$P" ',"unit":"parsec"'
problem 3 '/points/1' "$B" "$B" '[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 '/points/0/1' "$B" "$B" '[[0,0,0],[0,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 '/points/0/1/2' "$B" "$B" '[[0,0,0],[0,1,"one"],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 'd\.json:1:' "$B" "$B" '[[0,0,0],[0,1,1e400],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,1],[2,2,0]]'
problem 3 '/points' "$B" "$B" ''
problem 3 '/weights' "$B" "$B" "$P" ',"weights":[[1,1,1],[1,0,1],[1,1,1]]'
problem 3 '/weights' "$B" "$B" "$P" ',"weights":[[1,1,1],[1,-1,1],[1,1,1]]'
problem 3 '/aspect' "$B" "$B" "$P" ',"aspect":-1'
problem 3 '/aspect' "$B" "$B" "$P" ',"aspect":"wide"'

# Bases: every row of what is legal, broken.
problem 3 '/u/type' '{"type":"spline"}' "$B" "$P"
problem 3 '/u/degree' '{"type":"bspline","degree":0,"count":3}' "$B" "$P"
problem 3 '/u/degree' '{"type":"bspline","degree":1.5,"count":3}' "$B" "$P"
problem 3 '/u' '{"type":"bspline","degree":3,"count":3}' "$B" "$P"
problem 3 '/u/knots' '{"type":"bspline","degree":2,"knots":[0,0,0,1,1]}' "$B" "$P"
problem 3 '/u/knots' '{"type":"bspline","degree":2,"knots":[0,0,0,0,0,0]}' "$B" "$P"
problem 3 '/u/knots' '{"type":"bspline","degree":2,"knots":[0,0,0.5,1,1,1]}' "$B" "$P"
problem 3 '/u/knots/4' '{"type":"bspline","degree":2,"knots":[0,0,0,1,0.5,1]}' "$B" "$P"
problem 3 '/v/knots/1' "$B" '{"type":"bspline","degree":2,"knots":[0,null,0,1,1,1]}' "$P"
problem 3 '/v' "$B" '{"type":"bezier","degree":2,"alpha":1}' "$P"
problem 3 '/v.*ce-bezier' '{"type":"bezier","degree":1}' '{"type":"ce-bezier","alpha":0,"beta":0,"gamma":0}' \
    '[[0,0,0],[0,1,1],[0,2,0],[0,3,0]],[[1,0,0],null,[1,2,0],[1,3,0]]'
problem 3 '/u/knots' '{"type":"bspline","degree":1,"knots":[0,0,1,1,2,2]}' "$B" "$P,[[3,0,0],[3,1,1],[3,2,0]]"

# Well formed, but there is no such surface.
problem 4 'known' "$B" "$B" '[null,null,null],[null,null,null],[null,null,null]'

# Harmonic surfaces: what does not exist, each by its own name.
Q='{"type":"bezier","degree":2}'
harmonic() { # harmonic CODE PATTERN U V POINTS [MORE]
    document "$1" "$2" "{\"taut\":1,\"construct\":\"harmonic\",\"u\":$3,\"v\":$4,\"points\":[$5]${6:-}}"
}
R='[[0,0,0],[0,1,1],[0,2,0]],[null,null,null],[[2,0,0],[2,1,0],[2,2,0]]'
harmonic 4 'inconsistent boundary.*even' "$Q" "$Q" "$R"
harmonic 3 'even' "$Q" "$Q" "$R" ',"even":"mend"'
harmonic 3 '/points.*two opposite' "$Q" "$Q" "$P"
harmonic 4 'degree' '{"type":"bezier","degree":1}' "$Q" '[[0,0,0],[0,1,1],[0,2,0]],[[2,0,0],[2,1,0],[2,2,0]]'
harmonic 3 '/u.*bezier' "$B" "$Q" "$R"
harmonic 3 '/points.*four boundary rows' "$Q" "$Q" "$R" ',"fit":true'
harmonic 3 '/fit.*even' "$Q" "$Q" "$R" ',"fit":true,"even":"corner"'
harmonic 3 '/fit.*true or false' "$Q" "$Q" "$R" ',"fit":1'
D='{"taut":1,"construct":"harmonic","from":"derivative","u":{"type":"bezier","degree":2},"v":{"type":"bezier","degree":2}'
document 4 'inconsistent derivative' "$D,\"edge\":[[0,0,0],[0,1,1],[0,2,0]],\"cross_derivative\":[[1,0,0],[1,0,1],[1,0,0]]}"
document 3 '/edge' "$D,\"edge\":[[0,0,0],[0,1,1]],\"cross_derivative\":[[1,0,0],[1,0,1],[1,0,0]]}"
document 3 '/even' "$D,\"even\":\"corner\",\"edge\":[[0,0,0],[0,1,1],[0,2,0]],\"cross_derivative\":[[1,0,0],[1,0,0],[1,0,0]]}"
X='{"taut":1,"construct":"harmonic-extension","surface":{"u":{"type":"bezier","degree":2},"v":{"type":"bezier","degree":2},"points":[[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],[1,1,0],[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]]}'
document 4 'not harmonic' "$X,\"edge\":\"u1\"}"
document 3 '/edge' "$X,\"edge\":\"top\"}"
document 3 '/width' "$X,\"edge\":\"u1\",\"width\":0}"
document 3 '/alpha' "$X,\"edge\":\"u1\",\"alpha\":1}"

# Biharmonic surfaces.
biharmonic() { # biharmonic CODE PATTERN U V POINTS [MORE]
    document "$1" "$2" "{\"taut\":1,\"construct\":\"biharmonic\",\"u\":$3,\"v\":$4,\"points\":[$5]${6:-}}"
}
W='[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],[2,1,0],[2,2,0]]'
biharmonic 3 '/points.*four boundary rows' "$Q" "$Q" "$R"
biharmonic 3 '/u.*bezier' "$B" "$Q" "$W"
biharmonic 3 '/edge.*without' "$Q" "$Q" "$W" ',"edge":"u1"'
biharmonic 4 '/v/degree.*raise the lower' '{"type":"bezier","degree":3}' "$Q" \
    '[[0,0,0],[0,1,1],[0,2,0]],[[1,0,0],null,[1,2,0]],[[2,0,0],null,[2,2,0]],[[3,0,0],[3,1,0],[3,2,0]]'
Y=$(printf '%s' "$X" | sed 's/harmonic-extension/biharmonic/')
document 3 '/edge' "$Y}"
document 3 '/contact.*c1' "$Y,\"edge\":\"u1\",\"contact\":\"g1\"}"
document 3 '/width' "$Y,\"edge\":\"u1\",\"width\":-1}"
document 3 '/name.*beside' "$Y,\"edge\":\"u1\",\"name\":\"q\"}"
document 4 'one degree' "$(printf '%s' "$Y" | sed 's/"degree":2},"points"/"degree":1},"points"/; s/,\[[0-9],2,0\]//g'),\"edge\":\"u1\"}"
finish
