# test_make_list.sh -- make on a list of problems: the same models as one at a time, in one file or in many, all or none.
. "$SOURCE/tests/cli/cli.sh"

# problem HEIGHT: a net of 5 x 4 points with one corner at this height.
problem() {
    printf '{ "taut": 1, "construct": "dirichlet", "u": { "type": "bspline", "degree": 3, "count": 5 },\n'
    printf '  "v": { "type": "bezier", "degree": 3 }, "points": [[[0,0,%s],[0,1,0],[0,2,1],[0,3,0]],\n' "$1"
    printf '  [[1,0,0],null,null,[1,3,0]], [[2,0,1],null,null,[2,3,0]], [[3,0,0],null,null,[3,3,0]],\n'
    printf '  [[4,0,0],[4,1,0],[4,2,2],[4,3,0]]] }\n'
}
list() {
    comma='['
    for height in "$@"; do
        printf '%s' "$comma"
        problem "$height"
        comma=','
    done
    printf ']\n'
}

# Eleven of them, in one file, in many, and on standard output.
list 0 1 2 3 4 5 6 7 8 9 10 > list.json
run 0 make list.json -o all.json -o m.obj -o 'one-%.json' --report r.json
contains err.txt '^11 problems$'
contains err.txt 'm\.obj, numbered'
contains err.txt '3 more that hold'
for i in 0 1 2 3 4 5 6 7 8 9 10; do
    number=$(printf '%02d' "$i")
    problem "$i" > p.json
    run 0 make p.json --quiet -o single.json -o single.obj
    cmp -s single.json "one-$number.json" || complain "problem $i gives another model in a list"
    cmp -s single.obj "m-$number.obj" || complain "problem $i gives another mesh in a list"
done
[ "$(grep -c '^  {' all.json)" = 11 ] || complain "all.json is not a list of 11"
[ "$(grep -c '"holds": true' r.json)" -ge 11 ] || complain "the report does not tell of all"
contains r.json '"m-07.obj"'
run 0 make list.json --quiet
cmp -s out.txt all.json || complain "standard output is another list"
[ ! -s err.txt ] || complain "--quiet said something"
run 0 make - --quiet < list.json
cmp -s out.txt all.json || complain "standard input gives another list"
rm -f m-*.obj

# The number goes before the whole ending, and a folder keeps its %.
list 1 2 > list.json
mkdir '50%'
run 0 make list.json --quiet -o m.geomdl.json -o '50%/all.json' -o '50%/m.stl'
for i in 0 1; do
    contains "m-$i.geomdl.json" '"shape"'
    [ -s "50%/m-$i.stl" ] || complain "no 50%/m-$i.stl"
done
[ "$(head -c 1 '50%/all.json')" = '[' ] || complain "a % in a folder makes 50%/all.json no list"
rm -rf m-*.geomdl.json '50%'

# A list of one is a list; a problem is none.
list 3 > list.json
run 0 make list.json --quiet -o all.json -o m.obj
[ -s m-0.obj ] && [ "$(head -c 1 all.json)" = '[' ] || complain "a list of one is no list"
rm -f all.json m-0.obj

# One that fails leaves nothing of any, and is named by its place.
list 1 2 null 4 > list.json
refused 3 'type /2/points/0/0/2 found null expected a number' make list.json -o all.json -o m.obj
run 3 make list.json -o all.json -o m.obj
contains err.txt '^taut: list\.json: /2/points/0/0/2: '
printf '[%s, { "taut": 1, "construct": "dirichlet", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
  "points": [[null, null], [null, null]] }]\n' "$(problem 1)" > list.json
refused 4 'nothing-known /1/points found 0 expected 1' make list.json -o all.json -o m.obj
printf '[]' > list.json
refused 3 'size list\.json found null expected an array of problems, one at least' make list.json -o all.json
printf '[[%s]]' "$(problem 1)" > list.json
refused 3 'type /0 found null expected an object' make list.json -o all.json
list 1 2 > list.json
refused 5 'write' make list.json --quiet -o all.json -o nowhere/m.obj
contains err.txt 'nowhere/m\.obj'
absent all.json m-0.obj m-1.obj
mkdir -p taken/m-1.obj # the second picture cannot be written
refused 5 'write' make list.json --quiet -o all.json -o taken/m.obj
contains err.txt 'taken/m-1\.obj'
absent all.json taken/m-0.obj

# A claim that does not hold is exit 1; the list is written to be looked at, pictures of that one are not.
cp "$SOURCE/examples/asymptotic-3.json" irregular.json
if grep -q '"singular": "report"' irregular.json; then
    printf '[%s, %s]' "$(problem 1)" "$(cat irregular.json)" > list.json
    run 1 make list.json -o all.json -o m.obj
    contains err.txt '/1 +asymptotic DOES NOT HOLD'
    [ -s all.json ] && [ -s m-0.obj ] && [ ! -e m-1.obj ] || complain "files beside a claim that does not hold"
fi
finish
