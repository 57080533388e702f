# test_3mf.sh -- 3MF and sheets with a thickness: by the rules of the core specification (read_3mf.py), by lib3mf, and as STL,
# PLY and OBJ by the same volumes.
. "$SOURCE/tests/cli/cli.sh"

# Two boxes that do not touch, of two surfaces each way, with names that XML must not see; and a square.
box() { # box X
    awk -v x="$1" 'BEGIN { split("0 0 0 1 0 0 0 1 0|0 0 0 0 1 0 0 0 1|0 0 0 0 0 1 1 0 0|0 0 1 1 0 0 0 1 0|1 0 0 0 1 0 0 0 1|0 1 0 0 0 1 1 0 0", side, "|")
        for (s = 1; s <= 6; s++) { split(side[s], n, " "); printf "%s{ \"name\": \"<&> \\\"%d\\\" %d\", \"u\": { \"type\": \"bezier\", \"degree\": 1 }, \"v\": { \"type\": \"bezier\", \"degree\": 1 }, \"points\": [", (s > 1 ? "," : ""), s, x
            for (i = 0; i < 2; i++) { printf "%s[", (i ? "," : "")
                for (j = 0; j < 2; j++) printf "%s[%g,%g,%g]", (j ? "," : ""), x + n[1] + i * n[4] + j * n[7], n[2] + i * n[5] + j * n[8], n[3] + i * n[6] + j * n[9]
                printf "]" }
            printf "] }" } }'
}
printf '{ "taut": 1, "unit": "cm", "surfaces": [ %s, %s ] }' "$(box 0)" "$(box 3)" > boxes.json
printf '{ "taut": 1, "unit": "in", "surfaces": [ { "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 }, "points": [[[0,0,0],[0,3,0]],[[2,0,0],[2,3,0]]] } ] }' > square.json
printf '{ "taut": 1, "construct": "pipe", "radius": 2, "bend_radius": 3, "run": [[1, 2, 3], [1, 12, 3], [11, 12, 3]] }' > pipe.json
"$TAUT" example harmonic-extension > extension.json
"$TAUT" example pipe-run-closed > ring.json

run 0 convert boxes.json -o boxes.3mf
run 0 convert boxes.json -o hollow.3mf --thickness 0.5
run 0 convert square.json -o square.3mf
run 0 convert square.json -o plate.3mf -o plate.stl -o plate.ply -o plate.obj -o plate.glb --thickness 0.25 --divide 2
run 0 make pipe.json --quiet -o pipe-made.json -o pipe.3mf
run 0 make pipe.json --quiet -o wall.3mf --thickness 0.5
run 0 make extension.json --quiet -o extension.3mf --thickness 0.01
run 0 make ring.json --quiet -o ring.3mf
cp boxes.3mf first.3mf
SOURCE_DATE_EPOCH=1700000000 run 0 convert boxes.json -o boxes.3mf --threads 3
cmp -s first.3mf boxes.3mf || complain "the same model gives another 3MF"

python_with struct || missing Python 'tools/deps.sh test'
files="boxes.3mf hollow.3mf square.3mf plate.3mf pipe.3mf wall.3mf extension.3mf ring.3mf"
# shellcheck disable=SC2086
"$PYTHON" "$SOURCE/tests/cli/read_3mf.py" $files > said.txt 2>&1 || complain "3MF: $(cat said.txt)"
contains said.txt '^boxes.3mf unit centimeter$'
contains said.txt '^square.3mf unit inch$'
contains said.txt '^boxes.3mf object <&> "1" 0 type model triangles 12 volume (1.0|0.9999999999999999|1.0000000000000002) area 6.0 colours <&> "1" 0=#A6C6E6 <&> "2" 0=#EECE96 '
contains said.txt '^boxes.3mf object <&> "1" 3 type model triangles 12 volume (1.0|0.99999999999999[0-9]*|1.00000000000000[0-9]*) '
[ "$(grep -c '^boxes.3mf object' said.txt)" = 2 ] || complain "boxes.3mf has not two objects"
[ "$(grep -c '^hollow.3mf object .* type model' said.txt)" = 2 ] || complain "hollow.3mf has not two objects"
contains said.txt '^square.3mf object surface1 type surface triangles 2 '
contains said.txt '^plate.3mf object surface1 type model triangles 32 volume 1.5 area 14.5 colours surface1=#A6C6E6$'
contains said.txt '^pipe.3mf object .* type surface '
contains said.txt '^wall.3mf object .* type model '
contains said.txt '^extension.3mf object .* type model .* colours p=#A6C6E6 extension=#EECE96$'
contains said.txt '^ring.3mf object .* type model '

# A wall holds pi ((r + T/2)^2 - (r - T/2)^2) = 2 pi r T for each unit of its axis, whose length is the open pipe's area over
# 2 pi r: T times the area, but for 2e-3 that chords cut off.
"$PYTHON" - > near.txt 2>&1 <<'PY' || complain "a wall: $(cat near.txt)"
import re
said = open("said.txt").read()
volume = float(re.search(r"^wall.3mf object .* volume (\S+)", said, re.M)[1])
area = float(re.search(r"^pipe.3mf object .* area (\S+)", said, re.M)[1])
print(volume, area, volume / area / 0.5 - 1)
assert abs(volume / area / 0.5 - 1) < 4e-3
hollow = float(re.search(r"^hollow.3mf object .* volume (\S+)", said, re.M)[1])
assert abs(hollow - (1.5 ** 3 - 0.5 ** 3)) < 1e-12, hollow
PY

# shellcheck disable=SC2086
"$PYTHON" "$SOURCE/tests/cli/read_lib3mf.py" $files > lib.txt 2>&1
case $? in
0)
    ! grep -v '^.* warnings 0 unit [1-6]$' lib.txt | grep -vq 'manifold 1 type 1$\|manifold 0 type 4$' || complain "lib3mf: $(cat lib.txt)"
    contains lib.txt '^plate.3mf triangles 32 vertices 18 manifold 1 type 1$'
    contains lib.txt '^hollow.3mf warnings 0 unit 2$'
    [ "$(grep -c 'manifold 1 type 1' lib.txt)" = 8 ] || complain "lib3mf finds other bodies: $(cat lib.txt)"
    ;;
77) missing lib3mf 'tools/deps.sh check' ;;
*) complain "lib3mf: $(cat lib.txt)" ;;
esac

# the other meshes are the same plate: 2 x 3 x 1/4
[ "$(wc -c < plate.stl)" = $((84 + 50 * 32)) ] || complain "plate.stl has $(wc -c < plate.stl) bytes"
head -c 400 plate.ply | grep -qa '^element face 32' || complain "plate.ply: $(head -c 400 plate.ply | tr -d '\0')"
[ "$(grep -c '^f ' plate.obj)" = 16 ] || complain "plate.obj has $(grep -c '^f ' plate.obj) faces"
[ "$(awk '$1 == "v" { print $4 }' plate.obj | sort -u | tr '\n' ' ')" = '-0.125 0.125 ' ] || complain "plate.obj has other heights"

# what cannot be: twice the radius, and a thickness that is none
refused 4 'fold folded\.3mf found 4 expected (4|3\.99999999999999[0-9]*)' make pipe.json -o folded.3mf --thickness 4
refused 4 'fold folded\.stl found 5 expected (4|3\.99999999999999[0-9]*)' make pipe.json -o folded.stl --thickness 5
for ending in json geomdl.json html svg vtu dxf; do # none of them has a thickness
    refused 2 'option' convert square.json -o none.$ending --thickness 0.1
    contains err.txt 'thickness makes sheets in STEP, IGES and meshes'
    absent none.$ending
done
refused 2 'option' convert square.json --thickness 0.1
run 0 convert square.json -o both.stl -o both.svg -o both.json --thickness 0.1
contains err.txt 'both.svg: warning: --thickness makes no difference here'
[ "$(grep -c warning err.txt)" = 1 ] || complain "warnings: $(cat err.txt)"
refused 2 'value --thickness 0 found 0' convert square.json -o none.3mf --thickness 0
refused 2 'value --thickness nan found null' convert square.json -o none.3mf --thickness nan
absent folded.3mf folded.stl none.3mf
finish
