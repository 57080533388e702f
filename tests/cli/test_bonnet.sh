# test_bonnet.sh -- minimal surfaces with planar curvature lines from documents: made, proved, measured, panelled, drawn, refused.
. "$SOURCE/tests/cli/cli.sh"

example=$SOURCE/examples

run 0 make "$example/bonnet-figure-2a.json" -o a.json --report r.json
contains err.txt 'algebraic +holds'
contains err.txt 'area +6\.4160332156'
contains r.json '"construct": "bonnet"'
run 0 certify a.json "$example/bonnet-figure-2a.json"
run 0 certify a.json
contains err.txt 'algebraic +holds'
run 1 certify a.json "$example/bonnet-figure-1b.json"
contains err.txt 'formula +DOES NOT HOLD'

# Frames: as many surfaces, Enneper's at the end; one figure with all of them.
run 0 make "$example/bonnet-enneper.json" -o film.json -o film.svg
contains err.txt 'frame-5: 4 x 4 points, bezier x bezier'
contains film.svg 'lambda 0\.6'

# measure says which member of the family a net is, and nothing of others.
run 0 measure film.json --surface frame-5
contains out.txt "surface +Enneper's surface"
run 0 make "$example/bonnet-helicoid.json" -o helicoid.json
run 0 measure helicoid.json --json
contains out.txt '"surface": "helicoid"'
contains out.txt '"theta": 1\.57079632679'
run 0 refine helicoid.json -o fine.json
run 0 measure fine.json
contains out.txt 'surface +helicoid'
run 0 make "$example/dirichlet-tent.json" -o tent.json
run 0 measure tent.json
grep -q minimal_family out.txt && complain "the tent is recognised"

# Panels of a problem and of its model: as many quads, residuals of rounding.
for kind in conical circular; do
    run 0 panels "$example/bonnet-roof.json" --kind $kind --divide 12,8 -o p.obj
    contains err.txt 'planarity +[0-9.]+e-1[5-7]'
    contains err.txt '(balance|circle) +([0-9.]+e-1[4-7]|0)'
    [ "$(grep -c '^f ' p.obj)" = 96 ] || complain "not 96 panels of kind $kind"
    [ "$(grep -c '^v ' p.obj)" = 117 ] || complain "not 117 vertices"
    run 0 panels a.json --kind $kind -o q.obj --quiet
    [ "$(grep -c '^f ' q.obj)" = 64 ] || complain "not 64 panels"
    [ ! -s err.txt ] || complain "--quiet said $(cat err.txt)"
done
run 0 panels "$example/bonnet-enneper.json" --kind conical -o e.ply --surface frame-5
refused 2 'option' panels a.json -o p.obj
contains err.txt 'needs --kind'
refused 2 'value --divide 0,4 found null expected whole numbers from 1 to 500000' panels a.json --kind conical --divide 0,4 -o x.obj
refused 4 'theta /theta found 1\.57[0-9]* expected 0' panels "$example/bonnet-helicoid.json" --kind conical -o x.obj
refused 4 'not-in-family /surfaces/0' panels tent.json --kind circular -o x.obj
absent x.obj

# NURBS within a proved distance, also as JSON when a tolerance is given.
run 0 convert a.json -o n.json --tolerance 1e-6
contains err.txt 'n\.json, within [0-9.]+e-0[67] mm of the model'
contains n.json '"type": "bspline"'
run 0 convert a.json -o same.json
contains same.json '"type": "c-bezier"'

# What does not exist.
bonnet() { # bonnet MEMBERS: a problem of sign -, alpha 1, beta 1 unless said
    printf '{ "taut": 1, "construct": "bonnet", "sign": "-", %s }\n' "$1" > p.json
}
bonnet '"lambda": 1, "alpha": 1, "beta": 1'
refused 4 'lambda /lambda found 1 expected 1' make p.json -o x.json
contains err.txt 'normalize'
bonnet '"lambda": 1.5, "alpha": 1, "beta": 1, "normalize": true'
refused 4 'lambda /lambda found 1\.5 expected 1' make p.json -o x.json
bonnet '"lambda": -0.5, "alpha": 1, "beta": 1'
refused 4 'lambda /lambda found -0\.5 expected 0' make p.json -o x.json
bonnet '"lambda": 0.5, "alpha": 3.15, "beta": 1, "mesh": "bspline"'
refused 4 'segment-length /alpha found 3\.15 expected 3\.14159[0-9]*' make p.json -o x.json
contains err.txt 'more segments'
bonnet '"lambda": 0.5, "alpha": 3.15, "beta": 1'
refused 3 'segment-length /alpha found 3\.15 expected 3\.14159[0-9]*' make p.json -o x.json
contains err.txt 'bspline'
bonnet '"lambda": 0.5, "alpha": 4, "beta": 1, "normalize": true'
refused 3 'segment-length /alpha found 4 expected 3\.6275[0-9]*' make p.json -o x.json
contains err.txt 'two windows'
bonnet '"lambda": 0.5, "alpha": 1, "beta": 178'
refused 4 'far-window /beta found 178 expected 177' make p.json -o x.json
bonnet '"lambda": 0.5, "alpha": 0, "beta": 1'
refused 3 'value /alpha found 0 expected a positive length' make p.json -o x.json
bonnet '"lambda": 0.5, "alpha": 1, "beta": 1, "start": [1e13, 0]'
refused 3 'far-window /start/0 found 10000000000000 expected 1000000000000' make p.json -o x.json
bonnet '"lambda": [0, 0.5], "alpha": 1, "beta": 1'
refused 3 'size /lambda found 2 expected 1' make p.json -o x.json
bonnet '"lambda": 0.5, "alpha": 1, "beta": 1, "segments": [2, 2]'
refused 3 'conflict /segments' make p.json -o x.json
absent x.json

# A window so small that rounding leaves it open: said, and no failure.
bonnet '"lambda": 0.5, "alpha": 1e-6, "beta": 1e-6'
run 0 make p.json -o tiny.json
contains err.txt 'minimal +undecided \([a-z]+\): .*warning'
contains tiny.json '"holds": null'

# A tolerance below rounding: the least one is named in the measure it is asked for in, and then works.
bonnet '"lambda": 0.5, "alpha": 0.001, "beta": 0.001'
run 0 make p.json -o tiny.json
refused 2 'tolerance /surfaces/0 found 1e-12 expected [0-9.]+e-10' convert tiny.json --tolerance 1e-12 -o x.json
absent x.json
least=$(sed 's/.*ask for \([0-9.e-]*\) at least.*/\1/' err.txt)
run 0 convert tiny.json --tolerance "$least" -o x.json
finish
