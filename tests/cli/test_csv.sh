# test_csv.sh -- tables: the cables of a film, number by number as they stand in its details, read by Python's csv; quoting, empty
# cells, and models that have none.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example film-sail-length > sail.json
run 0 make sail.json --quiet -o model.json -o cables.csv
run 0 convert model.json -o again.csv
cmp -s cables.csv again.csv || complain "a converted model has another table"
python3 - model.json cables.csv 4 <<'END' || complain "the table is not that of the details"
import csv, json, sys
cables = json.load(open(sys.argv[1]))["details"]["cables"]
with open(sys.argv[2], newline="") as file:
    rows = list(csv.DictReader(file))
titles = {"edge": "edge", "force": "force", "length": "length", "unstressed": "unstressed_length"}
assert len(rows) == len(cables) == int(sys.argv[3]), (len(rows), len(cables))
assert any("unstressed" in cable for cable in cables) and any("unstressed" not in cable for cable in cables)
for row, cable in zip(rows, cables):
    assert list(row) == list(titles.values()), row
    for member, title in titles.items():
        found, wanted = row[title], cable.get(member, "")
        assert found == wanted if isinstance(wanted, str) else float(found) == wanted, (title, found, wanted)
END

# what a name may hold: quotes, commas, ends of lines; values that are no cells stay empty
printf '%s' '{ "taut": 1, "curves": [{ "t": { "type": "bezier", "degree": 1 }, "points": [[0,0,0],[1,0,0]] }], "details": { "cables": [' \
    '{ "edge": "a \"b\", c\nd", "force": 1e-300, "length": [1] }, 7, {}, { "length": 0.1, "edge": null, "force": "1, 2" }] } }' > odd.json
run 0 convert odd.json -o odd.csv
python3 - odd.csv <<'END' || complain "odd cells are not read back"
import csv, sys
rows = list(csv.reader(open(sys.argv[1], newline="")))
assert rows[1:] == [['a "b", c\nd', "1e-300", "", ""], ["", "", "", ""], ["", "", "", ""], ["", "1, 2", "0.1", ""]], rows
END

# laths of a net, with what is cut for them and without
"$TAUT" example trace-bonnet > net.json
sed 's/"seeds"/"laths": { "strip": "standing", "width": 0.02, "thickness": 0.001, "material": "timber-c24" }, "seeds"/' net.json > laths.json
for name in net laths; do
    run 0 make $name.json --quiet -o $name-made.json -o $name.csv
    python3 - $name-made.json $name.csv $name <<'END' || complain "the table of $name is not that of the details"
import csv, json, sys
laths = json.load(open(sys.argv[1]))["details"]["laths"]
rows = list(csv.DictReader(open(sys.argv[2], newline="")))
titles = ["name", "family", "length", "cut_length", "width", "thickness", "least_radius", "twist", "use", "nodes"]
assert len(rows) == len(laths) > 8, (len(rows), len(laths))
for row, lath in zip(rows, laths):
    assert list(row) == titles, row
    wanted = dict(lath, use=lath.get("stress", {}).get("use", ""), nodes=" ".join(node for node, s in lath["nodes"]))
    assert (wanted["use"] == "") == (sys.argv[3] == "net") and (row["cut_length"] == "") == (sys.argv[3] == "net")
    for title in titles:
        value = wanted.get(title, "")
        assert row[title] == value if isinstance(value, str) else float(row[title]) == value, (title, row[title], value)
END
done
printf '%s' '{ "taut": 1, "curves": [{ "t": { "type": "bezier", "degree": 1 }, "points": [[0,0,0],[1,0,0]] }], "details": { "laths": [' \
    '{ "name": "A1", "stress": 7, "nodes": [["a", 1], [], 3, [4], ["b,\"c", 1]] }, { "nodes": "none", "stress": {} }, { "nodes": [] }] } }' > strange.json
run 0 convert strange.json -o strange.csv
python3 - strange.csv <<'END' || complain "odd laths are not read back"
import csv, sys
rows = list(csv.reader(open(sys.argv[1], newline="")))
assert rows[1:] == [["A1", *[""] * 8, 'a    b,"c'], [""] * 10, [""] * 10], rows
END

for name in plateau-enneper film-none; do
    "$TAUT" example plateau-enneper > plateau-enneper.json
    printf '%s' '{ "taut": 1, "construct": "film", "corners": { "u0v0": [0,0,0], "u1v0": [2,0,0], "u0v1": [0,2,0], "u1v1": [2,2,0] } }' > film-none.json
    refused 4 'no-table /details' make $name.json --quiet -o beside.json -o none.csv
    absent beside.json
    absent none.csv
done
finish
