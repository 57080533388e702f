# test_units.sh -- models in two units come together in one, and numbers are printed with theirs.
. "$SOURCE/tests/cli/cli.sh"

cat > metres.json <<'JSON'
{ "taut": 1, "unit": "m", "surfaces": [ { "name": "lid", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
  "points": [[[0,0,0],[0,2,0]],[[1,0,0],[1,2,0]]] } ] }
JSON
cat > millimetres.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "lid", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
  "points": [[[1000,0,0],[1000,2000,0]],[[3000,0,0],[3000,2000,5]]] } ] }
JSON

# The edge x = 1 m of one is the edge x = 1000 mm of the other.
run 0 join metres.json u1 millimetres.json u0
contains err.txt 'millimetres.json: warning: it is in mm, and converted to m'
contains out.txt '^max_gap +0 m$'
run 0 join millimetres.json u0 metres.json u1 --json
[ ! -s err.txt ] || complain "warned beside JSON: $(cat err.txt)"
contains out.txt '"max_gap": [0-9.e-]+,?'
contains out.txt '"unit": "mm"'

# One figure, one scale of curvature: of its own unit a model would have another.
run 0 convert metres.json millimetres.json -o both.svg --colour H
contains err.txt 'millimetres.json: warning: it is in mm, and converted to m'
contains both.svg 'lid|metres'
run 0 convert metres.json metres.json -o both.svg
[ ! -s err.txt ] || complain "nothing was converted, and yet $(cat err.txt)"

run 0 measure metres.json
contains out.txt '^area +2 m\^2$'
contains out.txt '^    length +2 m$'
contains out.txt '^bounding_box .* m$'
contains out.txt '^  max_abs +0 1/m$'
contains out.txt '^  min +0 1/m\^2$'
contains out.txt '^  max_abs_at +[0-9. ]+$'
run 0 eval metres.json --at 0.5,0.5
for line in 'u +0.5' 'point +0.5 +1 +0 m' 'du +1 +0 +0 m' 'normal +0 +0 1' 'mean_curvature +0 1/m' 'gaussian_curvature +0 1/m\^2'; do
    tr -s ' ' < out.txt | grep -Eq "^$line\$" || complain "eval: no line $line: $(cat out.txt)"
done
run 0 measure metres.json --json
contains out.txt '"unit": "m"'
sed 's/"taut": 1,/"taut": 1, "unit": "ft", /' "$SOURCE/examples/dirichlet-bicubic.json" > feet.json
run 0 make feet.json -o feet-model.json
contains err.txt '^  area +[0-9.]+ ft\^2$'

finish
