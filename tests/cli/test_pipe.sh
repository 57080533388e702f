# test_pipe.sh -- pipes from documents: what is made, what is refused and how.
. "$SOURCE/tests/cli/cli.sh"

example=$SOURCE/examples

# The paper's pipe, in its extended domain, with a warning; proved again with and without the problem.
run 0 make "$example/pipe-paper.json" -o paper.json --report r.json
contains err.txt 'embedded +holds \([a-z]+\): 0\.519'
contains err.txt 'largest radius +1\.9259107226'
contains r.json '"warnings"'
contains paper.json '"name": "blend"'
contains paper.json '"type": "ce-bezier"'
run 0 certify paper.json "$example/pipe-paper.json"
run 0 certify paper.json --json
contains out.txt '"joint_curvature"'
run 0 eval paper.json --at 0,0
contains out.txt 'point +6 +0 +0'
run 0 join paper.json pipe1.u1 paper.json blend.u0
contains out.txt 'g_order +1'
run 1 certify paper.json "$example/pipe-cubic.json"
contains err.txt 'ends +DOES NOT HOLD'

# Chosen: shape, handles, feet.
run 0 make "$example/pipe-auto.json" -o auto.json
contains err.txt 'optimal +holds'
contains err.txt 'bending +0\.7127017852'
run 0 make "$example/pipe-feet.json" -o feet.json
contains err.txt 'handles'
run 0 make "$example/pipe-directed.json" -o directed.json -o directed.obj
contains err.txt 'ends +holds'

# Joints of equal curvature: no beta, no Frenet frame.
run 0 make "$example/pipe-g2.json" -o g2.json
contains err.txt 'curvature2 +holds'
contains g2.json '"joint": "g2"'
sed 's/"shape": "auto"/"shape": { "alpha": 0, "gamma": 0 }/' "$example/pipe-g2.json" > edited.json
run 0 make edited.json
sed 's/"shape": "auto"/"shape": { "alpha": 0, "beta": 1, "gamma": 0 }/' "$example/pipe-g2.json" > edited.json
refused 4 'parameter-domain /shape/beta found 1' make edited.json
contains err.txt 'PARAMETER_DOMAIN: '
sed 's/"g2"/"g2", "frame": "frenet"/' "$example/pipe-g2.json" > edited.json
refused 4 'frenet-undefined /frame found 0 expected 0' make edited.json
sed 's/"g2"/"g3"/' "$example/pipe-g2.json" > edited.json
refused 3 'name /joint found null expected .*g1.*' make edited.json

# Elliptic ends.
run 0 make "$example/pipe-elliptic.json" -o elliptic.json
contains err.txt 'section turn +-1\.265'
run 0 certify elliptic.json "$example/pipe-elliptic.json"
sed 's/"b": 8, //' "$example/pipe-elliptic.json" > edited.json
refused 3 'missing /sections/0/b' make edited.json
sed 's/"sections"/"radius": 3, "sections"/' "$example/pipe-elliptic.json" > edited.json
refused 3 'conflict edited\.json' make edited.json
sed 's/"direction": \[0, 0, 1\]/"direction": [2, 0, 0]/' "$example/pipe-elliptic.json" > edited.json
refused 4 'section-along /sections/0/direction found 0 expected 0' make edited.json

# Two radii.
run 0 make "$example/pipe-canal.json" -o canal.json
contains err.txt 'regular +holds'
contains err.txt 'graph +holds'
run 0 certify canal.json "$example/pipe-canal.json"
sed 's/"radii"/"surface": "naive-sweep", "radii"/' "$example/pipe-canal.json" > edited.json
run 0 make edited.json -o naive.json
contains naive.json '"surface": "naive-sweep"'
run 1 certify naive.json "$example/pipe-canal.json"
sed 's/"radii"/"joint": "g2", "radii"/' "$example/pipe-canal.json" > edited.json
refused 4 'canal-joint /joint' make edited.json
sed 's/"radii": \[20, 8\]/"radii": [20]/' "$example/pipe-canal.json" > edited.json
refused 3 'size /radii found null expected an array of 2 radii.*' make edited.json

# Runs: corners, a ring, straight pipes where they are; every format; caps.
run 0 make "$example/pipe-run.json" -o run.json -o run.step -o run.iges -o run.obj -o run.stl -o run.glb
contains err.txt 'joints +holds'
contains err.txt 'least bend radius +60\.0000'
contains err.txt '^ +\.\.\. and 3 more$'
contains err.txt 'blends +\(5 rows: see --report\)'
contains run.json '"name": "axis-blend5"'
[ "$(grep -c ADVANCED_FACE run.step)" = 26 ] || complain "not one face for each straight piece and four for each elbow"
run 0 certify run.json "$example/pipe-run.json"
run 0 certify run.json
run 1 certify run.json "$example/pipe-run-closed.json"
sed 's/"bend_radius": 60/"bend_radius": 90/' "$example/pipe-run.json" > edited.json
run 1 certify run.json edited.json
contains err.txt 'bend_radius +DOES NOT HOLD'
sed 's/"bend_radius": 60/"bend_radius": 900/' "$example/pipe-run.json" > edited.json
refused 4 'leg-too-short /run/3 found 900 expected 113\.3[0-9]*' make edited.json
sed 's/"radius": 12/"radius": 40/' "$example/pipe-run-closed.json" > edited.json
refused 4 'self-intersect-local /radius found 40 expected 36\.0000[0-9]*' make edited.json
contains err.txt 'of blend'
run 0 make "$example/pipe-run-closed.json" -o closed.json
contains closed.json '"holonomy"'
# A model that tells otherwise of itself than it is.
sed 's/"closed": true/"closed": false/' closed.json > edited.json
run 1 certify edited.json
contains err.txt 'embedded +DOES NOT HOLD'
sed 's/"radius": 12,/"radius": 12.001,/' closed.json > edited.json
run 1 certify edited.json
contains err.txt 'tube +DOES NOT HOLD'
sed 's/"name": "blend5"/"name": "elbow5"/' closed.json > edited.json
refused 3 'size /surfaces found 4 expected 5' certify edited.json
sed 's/"name": "pipe1"/"name": "first"/' closed.json > edited.json
run 1 certify edited.json
contains err.txt 'joints +DOES NOT HOLD'
sed 's/\[0, 220, 20\]/&, [0, 0, 0]/' "$example/pipe-run-closed.json" > edited.json
refused 3 'value /run/5 found 0' make edited.json
contains err.txt 'leave it out'
run 0 make "$example/pipe-run-coil.json" -o coil.json -o coil.step
contains err.txt 'caps +holds'
run 0 convert coil.json -o coil.stl
sed 's/"radius": 12/"radius": 12, "frame": "frenet"/' "$example/pipe-run-closed.json" > edited.json
refused 3 'conflict /frame' make edited.json
sed 's/"closed": true/"closed": 1/' "$example/pipe-run-closed.json" > edited.json
refused 3 'type /closed found 1 expected true or false' make edited.json
sed 's/\[240, 160, 0\]/{ "from": [0, 0, 0] }/' "$example/pipe-run-closed.json" > edited.json
refused 3 'type /run/2' make edited.json
sed 's/"to": \[60, 40, 20\]/"direction": [0, 1, 0]/' "$example/pipe-run-coil.json" > edited.json
refused 3 'conflict /run/1' make edited.json
sed 's/"to": \[60, 40, 20\]/"to": [60, 160, 20]/' "$example/pipe-run-coil.json" > edited.json
refused 3 'value /run/1/to found null expected another place.*' make edited.json
sed 's/"radius": 1,/"radius": 1, "closed": true,/' "$example/pipe-paper.json" > edited.json
refused 3 'conflict /closed' make edited.json

# Arcs for elbows: tori between cylinders, of the bend radius in diameters; its bends are those of the table.
arcs() { # arcs MEMBERS
    printf '{ "taut": 1, "construct": "pipe", "radius": 2, "caps": true, "run": [[0,0,0],[40,0,0],[40,30,0],[40,30,26],[70,50,10]], %s }\n' "$1" > arcs.json
}
arcs '"elbow": "arc", "bend_radius": "1.5D"'
run 0 make arcs.json -o made.json -o arcs.step -o bends.csv --report report.json
run 0 certify made.json arcs.json
run 0 certify made.json
contains report.json '"max_curvature": 0\.1666666666666'
[ "$(grep -c '=TOROIDAL_SURFACE(' arcs.step)" = 3 ] || complain "not three bends"
[ "$(grep -c '=CYLINDRICAL_SURFACE(' arcs.step)" = 4 ] || complain "not four straight pipes"
! grep -q B_SPLINE_SURFACE arcs.step || complain "an elbow is a spline"
[ "$(grep -c ',6$' bends.csv)" = 3 ] || complain "bends: $(cat bends.csv)"
arcs '"elbow": "arc", "bend_radius": "1.5D", "wall": 0.3'
run 0 make arcs.json --quiet -o walled.json -o walled.step
run 0 certify walled.json arcs.json
run 0 certify walled.json
[ "$(grep -c MANIFOLD_SOLID_BREP walled.step)" = 1 ] || complain "a tube with a wall is not one solid"
[ "$(grep -c 'FACE_BOUND(' walled.step)" = 2 ] || complain "not two rings"
run 1 certify made.json arcs.json
arcs '"wall": 2.1'
refused 3 'value /wall' make arcs.json
arcs '"wall": 0'
refused 3 'value /wall' make arcs.json
sed 's/"radius": 12/"radius": 12, "wall": 1/' "$example/pipe-run-closed.json" > edited.json
refused 3 'conflict /wall' make edited.json
arcs '"bend_radius": "1.5D"'
run 1 certify made.json arcs.json
arcs '"elbow": "arc", "bend_radius": "4D"'
refused 3 'name /bend_radius' make arcs.json
arcs '"elbow": "arc", "shape": "auto"'
refused 3 'conflict /shape' make arcs.json
arcs '"elbow": "arc", "joint": "g2"'
refused 3 'conflict /elbow' make arcs.json
arcs '"elbow": "round"'
refused 3 'name /elbow' make arcs.json
sed 's/"radius": 1,/"radius": 1, "elbow": "arc",/' "$example/pipe-paper.json" > edited.json
refused 3 'conflict /elbow' make edited.json
sed 's/"radius": 12/"radius": 12, "elbow": "arc"/' "$example/pipe-run-closed.json" > edited.json
refused 4 'arc-frame /elbow' make edited.json -o never.json
absent never.json
sed 's/"radius": 1,/"radius": 1, "caps": true, "bend_radius": 1.9,/' "$example/pipe-paper.json" > edited.json
run 0 make edited.json
contains err.txt 'caps +holds'
sed 's/"radius": 1,/"radius": 1, "bend_radius": 2,/' "$example/pipe-paper.json" > edited.json
refused 4 'bend-radius /bend_radius found 2 expected 1\.92[0-9]*' make edited.json

# What does not exist: 4, with what would mend it.
edit() { sed "$1" "$example/pipe-paper.json" > edited.json; }
edit 's/"extended"/"strict"/'
refused 4 'parameter-domain /shape/alpha found 3 expected 1' make edited.json -o no.json
absent no.json
edit 's/"alpha": 3/"alpha": -3/'
refused 4 'tangent-lost /shape/alpha found -3 expected -3' make edited.json
edit 's/"radius": 1/"radius": 2/'
refused 4 'self-intersect-local /radius found 2 expected 1\.9259107226[0-9]*' make edited.json
edit 's/\[5, 2, 0\]/[5, 0, 0]/'
refused 4 'degenerate-edge /polygon/1 found 0' make edited.json
sed 's/"shape"/"frame": "frenet", "shape"/' "$example/pipe-offset.json" > edited.json
refused 4 'frenet-undefined /frame found 0 expected 1e-9' make edited.json
sed 's/\[0, 0\.6, 0\.8\]/[1, 0, 0]/' "$example/pipe-feet.json" > edited.json
refused 4 'parallel-axes /axes found 0 expected 1e-9' make edited.json

# The document is wrong: 3, with the pointer.
edit 's/"radius": 1/"radius": 0/'
refused 3 'value /radius found 0' make edited.json
edit 's/"radius": 1/"radius": 1e200/'
refused 3 'value /radius found 1e200 expected .*1e90.*' make edited.json
edit 's/"gamma": 1/"delta": 1/'
refused 3 'unknown-member /shape/delta found null expected .*beta.*' make edited.json
edit 's/, "gamma": 1//'
refused 3 'missing /shape/gamma' make edited.json
edit 's/"domain": "extended"/"domain": "open"/'
refused 3 'name /domain' make edited.json
edit 's/"domain": "extended"/"pipe_lengths": [1, -2]/'
refused 3 'value /pipe_lengths/1 found -2' make edited.json
edit 's/"domain": "extended"/"pipe_lengths": [1]/'
refused 3 'size /pipe_lengths found null expected an array of 2 lengths' make edited.json
edit 's/"domain": "extended"/"axes": []/'
refused 3 'conflict edited\.json found 2 expected 1' make edited.json
edit 's/"polygon"/"polygons"/'
refused 3 'unknown-member /polygons found null expected .*polygon.*' make edited.json
edit 's/\[5, 0, 0\], //'
refused 3 'size /polygon found null expected an array of 4 points.*' make edited.json
sed 's/"direction": \[0, 1, 0\]/"direction": [0, 0, 0]/' "$example/pipe-directed.json" > edited.json
refused 3 'value /to/direction' make edited.json
sed 's/"shape": "auto"/"shape": "automatic"/' "$example/pipe-directed.json" > edited.json
refused 3 'type /shape found null expected .*auto.*' make edited.json
sed 's/"to"/"too"/' "$example/pipe-directed.json" > edited.json
refused 3 'unknown-member /too' make edited.json
refused 2 'value --tolerance 1e-16 found 1e-16' make "$example/pipe-paper.json" --tolerance 1e-16

# A coarser tolerance takes fewer segments; what lies outside the pipes' range is refused.
run 0 make "$example/pipe-paper.json" --tolerance 1e-2 -o coarse.json
contains err.txt 'segments +[4-9]$'
run 0 convert paper.json -o paper.glb
[ -s paper.glb ] || complain "no mesh"

# Where no radius and no shape works, that is what is said.
pipe() {
    echo "{ \"taut\": 1, \"construct\": \"pipe\", \"radius\": 1, $1 }" > p.json
}
pipe '"polygon": [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 0]], "shape": { "alpha": 0, "beta": 0, "gamma": 0 }'
refused 4 'self-intersect-local /radius found 1 expected 0' make p.json -o x.json
contains err.txt 'no radius would work'
sed 's/"radius": 1/"radius": 0.1/' p.json > edited.json
refused 4 'self-intersect-global /radius found 0\.1 expected 0' make edited.json -o x.json
contains err.txt 'no radius would work'
pipe '"from": { "point": [0, 0, 0], "direction": [1, 0, 0] }, "to": { "point": [10, 0, 0], "direction": [-1, 0, 0] }'
refused 4 'not-regular /shape' make p.json -o x.json
contains err.txt 'all shape numbers tried; move an end aside'
absent x.json

# Capped pipes are closed, and all their faces look to one side: each edge of the mesh is run through once either way.
pipe '"from": { "point": [0, 0, 0], "direction": [1, 0, 0] }, "to": { "point": [10, 6, 3], "direction": [0, 1, 0] }, "caps": true'
run 0 make p.json -o capped.obj --quiet
pipe '"run": [[0, 0, 0], [10, 0, 0], [10, 10, 0], [10, 10, 9]], "bend_radius": 3, "caps": true'
cp p.json run.json
run 0 make run.json -o run.obj --quiet
for file in capped run; do
    awk '$1 == "v" { at = $2 " " $3 " " $4; if (!(at in id)) id[at] = ++places; place[++n] = id[at] }
        $1 == "f" { for (i = 2; i <= NF; i++) { split($i, a, "/"); split($(i < NF ? i + 1 : 2), b, "/")
            p = place[a[1]]; q = place[b[1]]
            if (p != q && ++runs[p, q] > 1) twice++ } faces++ }
        END { for (e in runs) { split(e, ends, SUBSEP); if (!((ends[2], ends[1]) in runs)) open++ }
            print faces + 0, twice + 0, open + 0; exit !(faces > 100 && !twice && !open) }' $file.obj > said.txt ||
        complain "$file: faces, edges run twice, edges run one way: $(cat said.txt)"
done
finish
