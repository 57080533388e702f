# test_sheets_peer.sh -- laths to cut as FreeCAD reads their drawing (ezdxf: test_sheets.sh).
. "$SOURCE/tests/cli/cli.sh"

command -v freecadcmd > /dev/null || {
    echo 'left out: FreeCAD is not here: apt-get install freecad (1 GB; continuous integration goes without)'
    finish
}
"$TAUT" example trace-bonnet > net.json
run 0 make net.json --quiet -o made.json -o made.dxf
MODEL=$PWD/made.json DRAWING=$PWD/made.dxf freecadcmd "$SOURCE/tests/cli/read_laths_freecad.py" < /dev/null > freecad.txt 2>&1
contains freecad.txt '^LATHS True$'
grep '^LATHS False' freecad.txt

# a tampered drawing is noticed: an outline that is open
awk '/^POLYLINE/ { n++ } { print } n == 2 && /^ *70$/ { getline; print "0" }' made.dxf > open.dxf
MODEL=$PWD/made.json DRAWING=$PWD/open.dxf freecadcmd "$SOURCE/tests/cli/read_laths_freecad.py" < /dev/null > open.txt 2>&1
contains open.txt '^LATHS False '
finish
