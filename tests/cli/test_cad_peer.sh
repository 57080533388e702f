# test_cad_peer.sh -- STEP and IGES read by gmsh: its area and box are those of `taut measure`.
. "$SOURCE/tests/cli/cli.sh"

cat > probe.geo <<'GEO'
SetFactory("OpenCASCADE");
v() = ShapeFromFile("PLACE");
s() = Surface{:};
For i In {0 : #s() - 1}
  a = Mass Surface{s(i)};
  b() = BoundingBox Surface{s(i)};
  Printf("%.16g %.16g %.16g %.16g %.16g %.16g %.16g", a, b(0), b(1), b(2), b(3), b(4), b(5)) >> "probe.txt";
EndFor
GEO
probe() { # probe FILE: area and box of each surface, a line each, in probe.txt
    rm -f probe.txt
    sed "s|PLACE|$PWD/$1|" probe.geo > this.geo
    gmsh -v 0 this.geo - > gmsh.txt 2>&1 || complain "gmsh $1: $(cat gmsh.txt)"
    [ -s probe.txt ] || complain "gmsh finds no surface in $1"
}
measured() { # measured MODEL: the same by taut
    "$TAUT" measure "$1" --json | tr -d ' \n' | sed 's/"name"/\n/g' | sed -n \
        's/.*"area":\([^,]*\),.*"bounding_box":\[\[\([^]]*\)\],\[\([^]]*\)\]\].*/\1 \2 \3/p' | tr ',' ' '
}
# The area to 1e-6 of itself, the box to 1e-6 of its size: OpenCASCADE widens boxes by 1e-7.
same() { # same MODEL FILE
    probe "$2"
    measured "$1" > taut.txt
    paste -d ' ' taut.txt probe.txt | awk '{ size = 0
        for (k = 2; k <= 4; k++) size += ($(k + 3) - $k) ^ 2
        size = sqrt(size); off = ($1 - $8) / $1
        if (NF != 14 || off > 1e-6 || off < -1e-6) bad = 1
        for (k = 2; k <= 7; k++) { d = $k - $(k + 7); if (d > 1e-6 * size || d < -1e-6 * size) bad = 1 }
        } END { exit bad || NR == 0 }' || complain "$2: taut $(cat taut.txt) gmsh $(cat probe.txt)"
}

# gmsh takes the box of the control points: cut at the highest point of the edges, where it is the surface's own. It also
# integrates with few points to a span: halving spans, which changes nothing else, brings it near.
cat > saddle.json <<'JSON'
{ "taut": 1, "construct": "dirichlet", "u": { "type": "bezier", "degree": 3 }, "v": { "type": "bezier", "degree": 3 },
  "points": [[[0,0,0],[0,1,1],[0,2,1],[0,3,0]], [[1,0,-1],null,null,[1,3,-1]], [[2,0,-1],null,null,[2,3,-1]],
             [[3,0,0],[3,1,1],[3,2,1],[3,3,0]]] }
JSON
cat > quasi.json <<'JSON'
{ "taut": 1, "surfaces": [ { "name": "quasi", "u": { "type": "c-bezier", "alpha": 1.2 }, "v": { "type": "h-bezier", "beta": 0.8 },
    "points": [[[3,0,0],[3,1,0],[3,2,0.3],[3,3,0.7]],[[4,0,0],[4,1,0.1],[4,2,0.4],[4,3,0.9]],
               [[5,0,0],[5,1,0.2],[5,2,0.5],[5,3,1]],[[6,0,0.1],[6,1,0.3],[6,2,0.8],[6,3,1.4]]] } ] }
JSON
run 0 make saddle.json --quiet -o once.json
run 0 split once.json --u 0.5 -o halves.json
run 0 split halves.json --v 0.5 -o quarters.json
run 0 refine quarters.json -o saddle-fine.json
run 0 refine quasi.json -o quasi-fine.json
"$TAUT" convert quasi.json -o probe.igs 2> err.txt
if grep -q 'install libocct' err.txt; then
    skip OpenCASCADE 'tools/deps.sh test, and build anew'
fi
command -v gmsh > /dev/null || missing gmsh 'tools/deps.sh check'
for name in saddle quasi; do
    for ending in step igs; do
        run 0 convert $name-fine.json -o $name.$ending --tolerance 1e-8
        ! command -v gmsh > /dev/null || same $name-fine.json $name.$ending
    done
done

# What gmsh writes, taut reads: the same surfaces.
if command -v gmsh > /dev/null; then
    printf 'SetFactory("OpenCASCADE");\nv() = ShapeFromFile("%s");\nSave "again.step";\n' "$PWD/saddle.step" > again.geo
    gmsh -v 0 again.geo - > gmsh.txt 2>&1 || complain "gmsh again.geo: $(cat gmsh.txt)"
    run 0 convert again.step -o again.json
    measured again.json | cut -d ' ' -f 1 | cut -c 1-12 > there.txt
    measured saddle-fine.json | cut -d ' ' -f 1 | cut -c 1-12 > here.txt
    cmp -s here.txt there.txt || complain "areas by way of gmsh: $(cat there.txt), not $(cat here.txt)"
fi

finish
