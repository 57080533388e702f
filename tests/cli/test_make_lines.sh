# test_make_lines.sh -- make --lines: a problem a line, a model or an error a line, in order; broken off anywhere it goes on to the
# same bytes.
. "$SOURCE/tests/cli/cli.sh"

problem() { # problem HEIGHT: in one line
    printf '{ "taut": 1, "construct": "dirichlet", "u": {"type":"bezier","degree":2}, "v": {"type":"bezier","degree":2}, '
    printf '"points": [[[0,0,%s],[0,1,0],[0,2,1]], [[1,0,0],null,[1,2,0]], [[2,0,0],[2,1,0],[2,2,3]]] }\n' "$1"
}
{
    problem 0
    problem 1
    echo '{ "taut": 1, "construct": "dirichlet" }'
    echo
    echo 'this is no JSON'
    printf '   \t\r\n'
    printf '{ "taut": 1, "construct": "dirichlet", "u": {"type":"bezier","degree":1}, "v": {"type":"bezier","degree":1}, '
    echo '"points": [[null,null],[null,null]] }'
    tr -d '\n' < "$SOURCE/examples/asymptotic-3.json"
    echo
    problem 4 | tr -d '\n' # the last line need have no end
} > in.jsonl

run 1 make --lines in.jsonl -o out.jsonl
contains err.txt '^4 made, 1 that do not hold; 3 errors$'
[ "$(wc -l < out.jsonl)" = 7 ] || complain "not seven lines"
python3 - <<'END' || complain "the lines are not what they should be"
import json
lines = [json.loads(line) for line in open("out.jsonl")]
errors = {i: line["error"] for i, line in enumerate(lines) if "error" in line}
assert sorted(errors) == [2, 3, 4], sorted(errors)
assert (errors[2]["exit"], errors[2]["reason"]) == (3, "missing"), errors[2]
assert errors[3]["exit"] == 3 and errors[3]["where"].startswith("in.jsonl:5:"), errors[3]
assert (errors[4]["exit"], errors[4]["reason"]) == (4, "nothing-known"), errors[4]
assert set(errors[2]) == {"exit", "reason", "where", "message", "found", "expected"}
assert [lines[i]["certificate"]["holds"] for i in (0, 1, 5, 6)] == [True, True, False, True]
END

# A line is the model that its problem alone gives.
problem 1 > one.json
run 0 make one.json --quiet
run 0 make one.json -o alone.json --quiet
sed -n 2p out.jsonl > line.json
run 0 convert line.json -o again.json
cmp -s alone.json again.json || complain "a line is another model than its problem alone"

# Broken off anywhere, it goes on, and makes nothing twice.
cp out.jsonl whole.jsonl
size=$(wc -c < whole.jsonl)
for cut in 0 1 $((size / 3)) $((size / 2)) $((size - 1)) "$size"; do
    head -c "$cut" whole.jsonl > out.jsonl
    run 1 make --lines in.jsonl -o out.jsonl --quiet
    cmp -s out.jsonl whole.jsonl || complain "cut at $cut it goes on to other lines"
    [ ! -s err.txt ] || complain "--quiet said something"
done
printf '{ "kept": 1 }\nbroken' > out.jsonl
run 1 make --lines in.jsonl -o out.jsonl
[ "$(head -n 1 out.jsonl)" = '{ "kept": 1 }' ] || complain "a whole line was made again"
[ "$(tail -n 6 out.jsonl)" = "$(tail -n 6 whole.jsonl)" ] || complain "a broken line was not cut off"
contains err.txt '^1 lines were there$'

# Standard streams; and no error is exit 0.
run 1 make --lines - --quiet < in.jsonl
sed 's/standard input:/in.jsonl:/g' out.txt > named.txt
cmp -s named.txt whole.jsonl || complain "standard output is other lines"
problem 1 > good.jsonl
run 0 make --lines good.jsonl -o good.out --quiet
: > empty.jsonl
run 0 make --lines empty.jsonl -o empty.out --quiet
[ -e empty.out ] && [ ! -s empty.out ] || complain "no lines are not no lines"

# A line longer than any room at first.
python3 -c 'print(" " * 300000 + open("good.jsonl").read(), end="")' > long.jsonl
run 0 make --lines long.jsonl -o long.out --quiet
cmp -s long.out good.out || complain "a long line is another problem"

# What is wrong with the command.
run 5 make --lines missing.jsonl -o out.jsonl
run 5 make --lines good.jsonl -o no/out.jsonl
mkdir folder
run 5 make --lines good.jsonl -o folder
run 5 make --lines good.jsonl -o /dev/null
run 2 make --lines good.jsonl -o a -o b
run 2 make --lines good.jsonl -o a --report r
run 2 make --lines good.jsonl -o good.jsonl
[ "$(cat good.jsonl)" = "$(problem 1)" ] || complain "the input was written to"
finish
