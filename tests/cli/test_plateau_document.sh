# test_plateau_document.sh -- the members of a plateau problem: each is read and used, and refused when it is wrong.
. "$SOURCE/tests/cli/cli.sh"

# problem MEMBERS: a net of 3 x 3 points with these members besides
problem() {
    printf '{"taut": 1, "construct": "plateau", %s
  "u": {"type": "bezier", "degree": 2}, "v": {"type": "bezier", "degree": 2},
  "points": [[[-1, -1, 0], [-1, 0, 1], [-1, 1, 0]], [[0, -1, 1], null, [0, 1, 1]], [[1, -1, 0], [1, 0, 1], [1, 1, 0]]]}' \
        "$1" > p.json
}
area() {
    sed -n 's/^ *area  *\([0-9.]*\)\( mm^2\)*$/\1/p' err.txt | head -n 1
}

problem ''
run 0 make p.json -o plain.json
least=$(area)
[ -n "$least" ] || complain "no area in the report"

# From elsewhere it comes to the same least area; with a coarser tolerance it stops sooner; by normals it stays above.
line='{"type": "bezier", "degree": 2}'
start='"start": {"u": LINE, "v": LINE, "points": [[[-1, -1, 0], [-1, 0, 1], [-1, 1, 0]], [[0, -1, 1], [0.3, -0.2, 2], [0, 1, 1]],
    [[1, -1, 0], [1, 0, 1], [1, 1, 0]]]},'
problem "$(echo "$start" | sed "s/LINE/$line/g")"
run 0 make p.json -o started.json
[ "$(area | cut -c 1-10)" = "$(echo "$least" | cut -c 1-10)" ] || complain "from another start: area $(area), not $least"
problem '"method": "normal", "name": "film",'
run 0 make p.json -o normal.json
contains normal.json '"name": "film"'
awk -v a="$(area)" -v b="$least" 'BEGIN { exit !(a >= b - 1e-9) }' || complain "by normals: area $(area) below the least $least"
problem '"tolerance": 1e-7, "max_iterations": 50,'
run 0 make p.json -o coarse.json

# Wrong ones, each by its place.
wrong() { # wrong PATTERN MEMBERS
    problem "$2"
    refused 3 "$1" make p.json
}
wrong 'value /tolerance found 1 expected a number above 0 and below 1' '"tolerance": 1,'
wrong 'value /tolerance found 0 expected a number above 0 and below 1' '"tolerance": 0,'
wrong 'type /tolerance found null expected a number' '"tolerance": "small",'
wrong 'value /max_iterations found 0 expected a whole number from 1 to .*' '"max_iterations": 0,'
wrong 'name /method found null expected .*normal.*' '"method": "fast",'
wrong 'conflict /start' \
    '"start": {"u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1}, "points": [[[0, 0, 0], [0, 1, 0]],
    [[1, 0, 0], [1, 1, 0]]]},'
contains err.txt 'the bases of the problem, 3 by 3'
wrong 'missing /start/points' '"start": {"u": {"type": "bezier", "degree": 1}, "v": {"type": "bezier", "degree": 1}},'
wrong 'conflict /start/points/0/0 found 0\.5 expected 0' "$(echo "$start" | sed "s/LINE/$line/g; s/-1, -1, 0/-1, -1, 0.5/")"
printf '{"taut": 1, "construct": "plateau", "u": {"type": "ce-bezier", "alpha": 1, "beta": 1, "gamma": 0},
  "v": {"type": "bezier", "degree": 1}, "points": [[[0,0,0],[0,1,0]],[null,null],[null,null],[[3,0,0],[3,1,0]]]}' > p.json
refused 3 'basis /u' make p.json
problem '"max_iterations": 1, "tolerance": 1e-14,'
refused 1 'iterations p\.json found [0-9.e-]+ expected 1e-14' make p.json

# Curves as edges of a basis whose outermost points lie beside them.
curve='{"t": {"type": "bezier", "degree": 1}, "points": [[FROM], [TO]]}'
edge() { # edge FROM TO
    echo "$curve" | sed "s/FROM/$1/; s/TO/$2/"
}
for basis in '"c-bspline", "alpha": 0.4' '"h-bspline", "beta": 0.4'; do
    printf '{"taut": 1, "construct": "plateau", "u": {"type": "bezier", "degree": 3},
        "v": {"type": %s, "segments": 3}, "curves": {"u0": %s, "u1": %s, "v0": %s, "v1": %s}}' "$basis" "$(edge 0,0,0 0,1,1)" \
        "$(edge 1,0,1 1,1,0)" "$(edge 0,0,0 1,0,1)" "$(edge 0,1,1 1,1,0)" > p.json
    refused 4 'unclamped /v' make p.json
done

# Through a pipe, where nobody knows the length before: more than the first block that is read.
{
    problem ''
    cat p.json
    awk 'BEGIN { for (i = 0; i < 3000; i++) printf "                                        \n" }'
} | "$TAUT" make - --quiet > piped.json 2> err.txt || complain "a long document through a pipe: $(cat err.txt)"
cmp -s piped.json plain.json || complain "a long document through a pipe gives another model"
finish
