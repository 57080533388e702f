# test_figures.sh -- pictures and pages: their options, what their scales say beside `measure`, what they leave behind.
. "$SOURCE/tests/cli/cli.sh"

# The saddle (x, y, x y) over [-1, 1]^2: K from -1 in the middle to -1/9 at the corners, |H| at most at the corners.
cat > saddle.json <<'JSON'
{ "taut": 1, "unit": "cm", "details": { "<b>": "</script><script>alert(1)</script>" },
  "surfaces": [ { "name": "s", "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 },
    "points": [[[-1,-1,1],[-1,1,-1]], [[1,-1,-1],[1,1,1]]] } ] }
JSON
run 0 convert saddle.json -o k.svg --colour K --isolines 4 --title 'A & B'
contains k.svg 'cm²'
contains k.svg 'A &amp; B'
contains k.svg '>a line every 0\.250<'
contains k.svg '>−1\.0<'
# cells share their edges' pixels, where a browser smoothed both they would show; lines are smooth
contains k.svg '<style>path:not\(\[stroke\]\)\{shape-rendering:crispEdges\}</style>'
# a legend is of what is seen: the caps of these pipes look away
run 0 make "$SOURCE/examples/pipe-run-arcs.json" --quiet -o arcs.svg
contains arcs.svg 'blend1 … 3'
! grep -q cap1 arcs.svg || complain 'the legend names caps that no pixel shows'
run 0 make "$SOURCE/examples/pipe-run-arcs.json" --quiet -o arcs.svg --view 120,20
contains arcs.svg 'cap1'
run 0 convert saddle.json -o i.svg --colour I
run 0 convert saddle.json -o gap.svg --colour gap
contains gap.svg 'undefined'
"$TAUT" example plateau-skew | "$TAUT" make - --quiet -o skew.json
run 0 convert skew.json -o gap.svg --colour gap --isolines 3
contains gap.svg 'Gap per area'
grep -q undefined gap.svg && complain "the gap of a film with its witness has places without one"
run 2 convert skew.json -o gap.glb --colour gap
run 2 convert skew.json -o gap.glb --colour warp
run 0 convert skew.json -o warp.svg --colour warp
contains warp.svg 'undefined'
"$TAUT" example film-warp-weft | "$TAUT" make - --quiet -o cloth.json -o warp.svg --colour warp
contains warp.svg 'Stress, warp'
grep -q undefined warp.svg && complain "the stress of threads has places without one"
run 0 convert cloth.json -o weft.svg --colour weft --isolines 5
contains weft.svg 'Stress, weft'
contains weft.svg 'a line every 0\.6'
run 2 convert cloth.json -o strain.glb --colour strain
run 0 convert cloth.json -o strain.svg --colour strain
contains strain.svg 'undefined'
"$TAUT" example pattern-sail | "$TAUT" make - --quiet -o pieces.json
run 0 convert pieces.json -o plain.glb
run 0 convert pieces.json -o strain.glb --colour strain
cmp plain.glb strain.glb || complain "strains are not what GLB files of patterns show"
cat > patches.json <<'JSON'
{ "taut": 1, "construct": "film", "patches": [
  { "name": "a", "force_density": [2, 1], "corners": { "u0v0": [0,0,0], "u1v0": [1,0,0], "u0v1": [0,1,0], "u1v1": [1,1,0] },
    "edges": { "u0": "fixed", "v0": "fixed", "v1": "fixed" } },
  { "name": "b", "force_density": [1, 3], "corners": { "u0v0": [1,0,0], "u1v0": [2,0,0], "u0v1": [1,1,0], "u1v1": [2,1,0] },
    "edges": { "u1": "fixed", "v0": "fixed", "v1": "fixed" } } ],
  "seams": [["a.u1", "b.u0"]] }
JSON
run 0 make patches.json -o patches.svg --colour weft
grep -q undefined patches.svg && complain "the stress of patches has places without one"
sed 's/"force_density": .1, 3.,/"tension": 1,/' patches.json > half.json
run 0 make half.json -o half.svg --colour weft
contains half.svg 'undefined'
run 0 convert skew.json -o unheld.svg --reactions
contains unheld.svg 'no reactions'
"$TAUT" example film-tent | "$TAUT" make - --quiet -o tent.svg --reactions
contains tent.svg 'the longest arrow is a force of 5\.74'
"$TAUT" example film-tent | "$TAUT" make - --quiet -o tent.svg --no-net
contains tent.svg '>u0, u1<'
contains tent.svg 'stroke="#b02a30"'
# names of images are those of what they are images of; what an open end shows of an axis is not drawn
"$TAUT" example film-bubbles | "$TAUT" make - --quiet -o bubbles.svg --no-net
contains bubbles.svg '>l1, l2<'
"$TAUT" example pipe-run-wall | "$TAUT" make - --quiet -o wall.svg --no-net
if grep -q 'stroke="#b02a30"' wall.svg; then complain "the axis of a pipe is seen in its mouth"; fi
contains i.svg 'Isothermality'
run 0 convert saddle.json -o c.svg --combs --reflections 12 --no-net
contains c.svg 'the longest tooth is a curvature of '
run 0 convert saddle.json -o bare.svg --reactions
contains bare.svg 'no reactions'
"$TAUT" example film-sail | "$TAUT" make - --quiet -o sail.json -o sail.svg --reactions
contains sail.svg 'reactions: as the cables pull at the supports, the longest arrow is a force of '
run 0 convert sail.json -o again.svg --reactions
contains again.svg 'reactions: as the cables pull at the supports, the longest arrow is a force of '

# The limits of the page's scales, rounded up to two digits, are the extremes that `measure` finds.
run 0 view saddle.json -o s.html
run 0 measure saddle.json --json
limit() { # limit INDEX: of H, K, I
    sed -n '/<script type="application\/json"/,/^<\/script>/p' s.html | tr -d ' \n' | sed 's/.*"limits":\[\([^]]*\)\].*/\1/' | cut -d , -f "$1"
}
number() { # number MEMBER INDEX: in what measure said
    tr -d ' \n' < out.txt | grep -o "\"$1\":[-0-9.e]*" | sed -n "$2p" | sed 's/.*://'
}
agree() { # agree LIMIT VALUE: rounded up to two digits
    awk -v limit="$1" -v value="$2" 'BEGIN { if (value < 0) value = -value
        exit !(limit >= value * (1 - 1e-9) && limit <= value * 1.1) }' || complain "the scale ends at $1, measure says $2"
}
agree "$(limit 1)" "$(number max_abs 1)"
agree "$(limit 2)" "$(number min 1)"
[ "$(limit 3)" = 0.5 ] || complain "isothermality ends at $(limit 3), not at 1/2"

# One file that asks for nothing, and no markup out of names.
[ "$(wc -c < s.html)" -lt 1500000 ] || complain "a small page of $(wc -c < s.html) bytes"
grep -qE '(src|href)="?(https?:)?//' s.html && complain "the page asks for another address"
[ "$(grep -c 'alert(1)' s.html)" = 2 ] || complain "the hostile text is not there twice, as what is drawn and as the model"
grep -q '<script>alert(1)' s.html && complain "markup of a name is markup"
contains s.html 'Content-Security-Policy'
run 0 view - < saddle.json
cmp -s out.txt s.html && complain "a title came out of nowhere"
run 0 view saddle.json --title t -o t.html
run 0 view saddle.json --title t
cmp -s out.txt t.html || complain "standard output is another page"
run 0 convert saddle.json -o t2.html --title t
cmp -s t.html t2.html || complain "convert writes another page"

# Several models.
cp saddle.json other.json
run 0 convert saddle.json other.json -o two.svg -o two.pdf --combs
contains two.svg '>saddle<'
contains two.svg '>other<'
[ -s two.pdf ] || complain "no two.pdf"
refused 2 'several two\.obj found 2 expected 1' convert saddle.json other.json -o two.obj
refused 5 'read missing\.json' convert saddle.json missing.json -o none.svg
absent two.obj none.svg

# A paper's column; a page is no taller than what is on it; runs of pipes have two colours and no name for what is not seen.
run 0 convert saddle.json -o column.svg -o column.png --column
contains column.svg 'width="249\.4'
contains column.svg '<title>surface, a figure by taut</title>'
"$TAUT" example pipe-run | "$TAUT" make - --quiet -o run.json -o run.svg --no-net
contains run.svg '>pipe1 … 6<'
contains run.svg '>blend1 … 5<'
grep -q '>axis' run.svg && complain "the axes of pipes are named, which are not seen"
contains run.svg '> *100 mm<'

# Small enough to be sent: vectors stay vectors.
[ "$(wc -c < k.svg)" -lt 800000 ] || complain "a figure of $(wc -c < k.svg) bytes"
grep -q '<image' k.svg && complain "a figure holds pixels"

# Pipes are shown without their nets, unless these are asked for.
"$TAUT" example pipe-run | "$TAUT" make - --quiet -o without.svg -o run.json
cmp -s without.svg run.svg || complain "a pipe has a net"
run 0 convert run.json -o with.svg --show-net
[ "$(wc -c < with.svg)" -gt "$(($(wc -c < run.svg) + 2000))" ] || complain "--show-net shows none"
# A cap's middle is a point: it bends nowhere. A pipe of radius 8 bends by 1/8, its blends by less.
"$TAUT" example pipe-run-coil | "$TAUT" make - --quiet -o caps.svg --combs
contains caps.svg 'the longest tooth is a curvature of 0.125/mm'

run 0 convert saddle.json -o w.png --width 200
refused 2 'value --colour Q found null expected H, K, I, gap, warp, weft or strain' convert saddle.json -o x.svg --colour Q
refused 2 'value --width 8 found 8' convert saddle.json -o x.png --width 8
refused 2 'value --isolines 0 found 0' convert saddle.json -o x.png --isolines 0
refused 2 'value --reflections 1\.5 found 1\.5' convert saddle.json -o x.png --reflections 1.5
refused 2 'value --view 1 found 1 expected two numbers,.*' view saddle.json -o x.html --view 1
refused 2 'operand' view
refused 5 'read missing\.json' view missing.json -o x.html
absent x.svg x.png x.html
finish
