# test_plans.sh -- plans of flat pieces in PDF: on one page, smaller, and on sheets of paper that are put together again.
. "$SOURCE/tests/cli/cli.sh"

cat > small.json << 'EOF'
{ "taut": 1, "unit": "mm", "surfaces": [ { "name": "sail", "u": { "type": "bezier", "degree": 2 }, "v": { "type": "bezier", "degree": 2 },
  "points": [[[-300, -300, 0], [-300, 0, 180], [-300, 300, 0]], [[0, -300, -180], [0, 0, 0], [0, 300, -180]],
             [[300, -300, 0], [300, 0, 180], [300, 300, 0]]] } ] }
EOF
run 0 pattern small.json --across v0,v1 --count 2 --allowance 5 --border 8 --marks 50 --quiet -o cloth.json -o cloth.svg
"$TAUT" convert cloth.json -o probe.pdf > probe.txt 2>&1 || skip "cairo" "the figures in PDF"

run 0 convert cloth.json -o tiles.pdf --tiles a4
run 0 convert cloth.json -o page.pdf --scale 1:4
run 0 convert cloth.json -o whole.pdf
run 0 pattern small.json --across v0,v1 --count 2 --allowance 5 --border 8 --marks 50 --quiet -o tiles-2.pdf --tiles a4
cmp tiles.pdf tiles-2.pdf || complain "the words print other sheets than the model"
refused 2 'value --tiles a5' convert cloth.json -o none.pdf --tiles a5
refused 2 'value --scale 4' convert cloth.json -o none.pdf --scale 4
refused 2 'value --scale 1:-4' convert cloth.json -o none.pdf --scale 1:-4
refused 2 'option' convert cloth.json -o none.pdf --scale 1:4 --tiles a3
sed 's/"unit": "mm"/"unit": "m"/' cloth.json > large.json
refused 2 'argument' convert large.json -o none.pdf --tiles a4
absent none.pdf

if command -v pdftotext > /dev/null && python_with json; then
    "$PYTHON" "$SOURCE/tests/cli/read_plan.py" cloth.json tiles.pdf cloth.svg > read.txt || complain "$(cat read.txt)"
    pdfinfo -l 9 page.pdf > page.txt
    pdfinfo -l 9 whole.pdf > whole.txt
    awk '/Page +2 size/ { print $4, $6 }' page.txt whole.txt > sizes.txt
    awk 'NR == 1 { x = $1; y = $2 } NR == 2 && ($1 / x > 4.001 || $1 / x < 3.999 || $2 / y > 4.001 || $2 / y < 3.999) { exit 1 }' sizes.txt ||
        complain "the page is not 1:4: $(cat sizes.txt)"
else
    missing "pdftotext" "what is on the sheets"
fi
finish
