# test_dxf_read.sh -- DXF in: drawings that ezdxf writes in every release, lines to splines and blocks in blocks; what taut writes
# comes back; a boundary out of a drawing; files that are none.
. "$SOURCE/tests/cli/cli.sh"

python=python3
$python -c 'import ezdxf' 2> /dev/null || python=/usr/bin/python3
if $python -c 'import ezdxf' 2> /dev/null; then
    $python "$SOURCE/tests/cli/read_dxf_in.py" write . || complain "ezdxf did not write"
    for release in R12 R2000 R2004 R2007 R2010 R2013 R2018; do
        run 0 convert $release.dxf -o model.json
        contains err.txt 'TEXT is left out \(1\)'
        $python "$SOURCE/tests/cli/read_dxf_in.py" check $release.dxf model.json > said.txt 2>&1 || complain "$release: $(tail -n 1 said.txt)"
    done
    run 0 convert R12.dxf -o model.json
    contains err.txt 'says no unit'
else
    missing ezdxf 'tools/deps.sh check'
fi

# Lines as the oldest programs write them, with carriage returns, blanks and numbers as they spell them.
printf '  0\r\nSECTION\r\n  2\r\nENTITIES\r\n' > plain.dxf
line() { # line LAYER X Y Z X Y Z
    printf '  0\r\nLINE\r\n  8\r\n%s\r\n 10\r\n%s\r\n 20\r\n%s\r\n 30\r\n%s\r\n 11\r\n%s\r\n 21\r\n%s\r\n 31\r\n%s\r\n' "$@"
}
{
    line south 0 0. .0 +4 -.0 0
    line east 4.0E0 0 0 004 3 1e0
    line north 4 3 1 0 3 0
    line west 0 3 0 0 0 0
    line mast 2 1.5 -1 2 1.5 3
} >> plain.dxf
printf '  0\r\nENDSEC\r\n  0\r\nEOF\r\n' >> plain.dxf
run 0 boundary plain.dxf
contains out.txt '^ *2  curve  east  .* from 4 0 0  to 4 3 1$'
printf '{ "taut": 1, "construct": "dirichlet", "boundary": { "file": "plain.dxf", "edges": ["south", "east", "north", "west"] } }\n' > problem.json
run 0 make problem.json --quiet -o made.json
run 0 certify made.json problem.json

# Units: those that documents have are kept, others converted and said; a drawing without one, or with one of astronomers or of no
# number, is taken as mm, which is said too, by what makes a surface of it as well.
printf '{ "taut": 1, "unit": "m", "construct": "dirichlet", "boundary": { "file": "unit.dxf", "edges": [1, 2, 3, 4] } }\n' > unit.json
one=0
while read -r number unit metres what; do
    { printf '  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n%s\n  0\nENDSEC\n' "$number"; cat plain.dxf; } > unit.dxf
    run 0 convert unit.dxf -o model.json
    [ "$(sed -n 's/.*"unit": "\(.*\)".*/\1/p' model.json)" = "$unit" ] || complain "unit $number: $(grep '"unit"' model.json)"
    case $what in - | '') [ ! -s err.txt ] || complain "unit $number: $(cat err.txt)" ;; *) contains err.txt "$what" ;; esac
    run 0 make unit.json -o made.json --report report.json
    case $what in - | '') ;; *) contains made.json "unit.dxf: the drawing .*$what" ;; esac
    area=$(sed -n 's/.*"area": \([-+.e0-9]*\).*/\1/p' report.json)
    [ $number != 6 ] || one=$area
    awk "BEGIN { d = $area / ($one * $metres * $metres) - 1; exit !(d < 1e-12 && d > -1e-12) }" || complain "unit $number: area $area"
done <<UNITS
6 m 1
1 in 0.0254
2 ft 0.3048
3 ft 1609.344 in miles: its lengths are multiplied by 5280, to be in ft
4 mm 0.001
5 cm 0.01
7 m 1000 in kilometres: its lengths are multiplied by 1000, to be in m
10 ft 0.9144 in yards: its lengths are multiplied by 3, to be in ft
13 mm 0.000001 in micrometres
14 cm 0.1 in decimetres
21 m 0.3048006096012192 in US survey feet
0 mm 0.001 says no unit that taut has: taken as mm
19 mm 0.001 says no unit
99999999999999999999 mm 0.001 says no unit
-3 mm 0.001 says no unit
UNITS

# A spline on uniform knots, as others write closed ones: a parabola between the middles of its polygon, the same curve on ours.
spline() { # spline KNOTS...: quadratic, three points
    printf '  0\nSECTION\n  2\nENTITIES\n  0\nSPLINE\n  8\nfree\n 71\n2\n'
    printf ' 40\n%s\n' "$@"
    printf ' 10\n%s\n 20\n%s\n 30\n%s\n' 0 0 0 2 4 0 4 0 2
    printf '  0\nENDSEC\n  0\nEOF\n'
}
spline 0 1 2 3 4 5 > uniform.dxf
run 0 convert uniform.dxf -o uniform.json
tr -d ' \n' < uniform.json > one.txt
contains one.txt '"knots":\[2,2,2,3,3,3\]'
contains one.txt '"points":\[\[1,2,0\],\[2,4,0\],\[3,2,1\]\]'
for knots in '0 1 2 2 4 5' '0 1 2 1 4 5' '0 1 3 2 4 5'; do # no parameters, or none in order
    # shellcheck disable=SC2086
    { spline $knots | sed '/ENDSEC/,$d' | sed '$d'; sed 1,4d plain.dxf; } > broken.dxf
    run 0 boundary broken.dxf
    contains err.txt 'a spline of broken knots is left out \(1\)'
done
printf '  0\nSECTION\n  2\nENTITIES\n  0\nSPLINE\n 71\n3\n 11\n0\n 21\n0\n 31\n0\n' > fit.dxf
sed 1,4d plain.dxf >> fit.dxf
run 0 boundary fit.dxf
contains err.txt 'a spline by its fit points alone \(save its control points\) is left out \(1\)'

# What taut writes: names, knots and points, bit for bit.
cat > odd.json <<'JSON'
{ "taut": 1, "unit": "ft", "curves": [
  { "name": "line", "t": { "type": "bspline", "degree": 1, "knots": [0,0,1,1] }, "points": [[0,0,0],[1,1e-300,-2.5]] },
  { "name": "circle \u00e4", "t": { "type": "bspline", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,4,4,4] },
    "points": [[1,0,0],[1,1,0],[0,1,0],[-1,1,0],[-1,0,0],[-1,-1,0],[0,-1,0],[1,-1,0],[1,0,0]],
    "weights": [1,0.7071067811865476,1,0.7071067811865476,1,0.7071067811865476,1,0.7071067811865476,1] },
  { "name": "cubic", "t": { "type": "bspline", "degree": 3, "knots": [0,0,0,0,5,5,5,5] }, "points": [[0,0,0],[1,2,3],[0.1,0.2,0.3],[4,5,6]] } ] }
JSON
run 0 convert odd.json -o odd.dxf
run 0 convert odd.dxf -o back.json
[ ! -s err.txt ] || complain "read back: $(cat err.txt)"
python3 - <<'PY' || complain "not the same curves come back"
import json
there, back = (json.load(open(f, encoding="utf-8")) for f in ("odd.json", "back.json"))
assert back["unit"] == "ft" and len(there["curves"]) == len(back["curves"])
for a, b in zip(there["curves"], back["curves"]):
    assert a["name"] == b["name"] and a["points"] == b["points"] and a.get("weights") == b.get("weights"), (a, b)
    assert a["name"] == "line" or a["t"]["knots"] == b["t"]["knots"], (a, b)
PY

bad() { # bad PATTERN SED: of plain.dxf
    sed "$2" plain.dxf > bad.dxf
    refused 3 "$1" convert bad.dxf -o never.json
    absent never.json
}
bad 'broken' '$d'
contains err.txt 'ends the file'
bad 'broken' '13s/.*/nine/'
contains err.txt 'line 1[34]: '
bad 'broken' '10s/.*/1e999/'
bad 'broken' 's/ENTITIES/TABLES/'
printf 'AutoCAD Binary DXF\r\n\032\000' > bad.dxf
refused 3 broken convert bad.dxf -o never.json
contains err.txt 'binary DXF'
: > bad.dxf
refused 3 broken convert bad.dxf -o never.json
# A block that holds itself has no end, and ends all the same.
printf '0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n10\n0\n0\nINSERT\n2\na\n0\nINSERT\n2\na\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\na\n0\nENDSEC\n0\nEOF\n' > bad.dxf
refused 3 size convert bad.dxf -o never.json
absent never.json
finish
