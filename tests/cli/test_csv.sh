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
"$TAUT" example trace-enneper > net.json
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
# pieces of cloth, their seams and their roll, in the columns of one table; the columns of pieces are the first ones
"$TAUT" example pattern-sail > cloth.json
run 0 make cloth.json --quiet -o cloth-made.json -o cloth.csv
python3 - cloth-made.json cloth.csv <<'END' || complain "the table of cloth is not that of the details"
import csv, json, sys
details = json.load(open(sys.argv[1]))["details"]
pieces, seams, roll = details["pieces"], details["seams"], details["roll"]
table = list(csv.DictReader(open(sys.argv[2], newline=""), strict=True))
assert all(None not in row and None not in row.values() for row in table), "lines of other lengths"
rows, sewn, rolls = ([row for row in table if row["kind"] == kind] for kind in ("piece", "seam", "roll"))
assert table == rows + sewn + rolls and len(rows) == len(pieces) == 4 and len(sewn) == len(seams) == 3 and len(rolls) == 1
titles = list(table[0])
assert titles[0] == "name" and titles[16] == "kind" and len(set(titles)) == len(titles) == 26, titles
for row, seam in zip(sewn, seams):
    wanted = {"length": seam["length"], "flat_length": seam["flat_length"], "least_stretch": seam["stretch"][0],
              "largest_stretch": seam["stretch"][1], "disagreement": seam["disagreement"]}
    assert row["name"] == seam["name"] and row["pieces"] == " ".join(seam["pieces"]), row
    assert all(float(row[title]) == value for title, value in wanted.items()), (row, wanted)
    assert {title for title in titles if row[title]} == {"name", "kind", "pieces", *wanted}, row
wanted = {title: roll[title] for title in ("length", "width", "gap", "waste")}
assert all(float(rolls[0][title]) == value for title, value in wanted.items()), (rolls[0], wanted)
assert {title for title in titles if rolls[0][title]} == {"kind", *wanted}, rolls
for row, piece in zip(rows, pieces):
    right, left = piece["edges"]["right"], piece["edges"]["left"]
    wanted = {"along": piece["extent"][0], "across": piece["extent"][1], "cut_area": piece["cut_area"], "least_strain": piece["strain"]["min"],
              "right_flat_length": right["flat_length"], "left_length": left["length"], "end_flat_length": piece["edges"]["end"]["flat_length"]}
    assert row["name"] == piece["name"] and row["right"] == right.get("seam", "") and row["left"] == left.get("seam", ""), row
    assert all(float(row[title]) == value for title, value in wanted.items()), (row, wanted)
    assert not any(row[title] for title in titles[17:]), row
END
# seams and a roll that are none
printf '%s' '{ "taut": 1, "curves": [{ "t": { "type": "bezier", "degree": 1 }, "points": [[0,0,0],[1,0,0]] }], "details": {' \
    '"pieces": [{ "name": "A" }], "seams": [7, { "name": "S", "pieces": ["a", "b,c", 3] }, { "pieces": 4 }], "roll": [5] } }' > torn.json
run 0 convert torn.json -o torn.csv
python3 - torn.csv <<'END' || complain "odd seams are not read back"
import csv, sys
rows = [{k: v for k, v in row.items() if v} for row in csv.DictReader(open(sys.argv[1], newline=""), strict=True)]
assert rows == [{"name": "A", "kind": "piece"}, {}, {"name": "S", "kind": "seam", "pieces": "a b,c "}, {"kind": "seam"}, {}], rows
END
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
# Bends of pipes: who bends a tube by LRA comes to the corners of XYZ, and at the end of it to the end of the run. The corners are
# those of the document; each straight piece, with what arcs take of it, is as long as the way between corners.
printf '{ "taut": 1, "construct": "pipe", "radius": 2, "run": [[0,0,0],[100,0,0],[100,80,0],[30,120,60],[30,120,160],[-50,100,120]], "bend_radius": 8 }' > bent-problem.json
"$TAUT" example pipe-run > run-problem.json
"$TAUT" example pipe-run-closed > ring-problem.json
for name in bent run ring; do
    run 0 make $name-problem.json --quiet -o $name.json -o $name.csv
    python3 - $name-problem.json $name.json $name.csv <<'END' || complain "the bends of $name lead elsewhere"
import csv, json, math, sys
problem, model = (json.load(open(f)) for f in sys.argv[1:3])
rows = [{k: float(v) if v else None for k, v in row.items()} for row in csv.DictReader(open(sys.argv[3], newline=""))]
assert list(rows[0]) == ["point", "x", "y", "z", "length", "rotation", "angle", "radius"]
corners = [[r["x"], r["y"], r["z"]] for r in rows]
closed = problem.get("closed", False)
given = problem["run"]
wanted = given[1:] + given[:1] if closed else given[1:-1]
assert corners[1:-1] == wanted, (corners, wanted)
assert (corners[0] == corners[-1]) if closed else (corners[0] == given[0] and corners[-1] == given[-1])
assert all(r["radius"] == problem["bend_radius"] for r in rows[1:-1]) and rows[0]["length"] is None and rows[-1]["angle"] is None
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
minus = lambda a, b: [x - y for x, y in zip(a, b)]
unit = lambda a: [x / math.hypot(*a) for x in a]
def turn(v, axis, degrees): # Rodrigues' formula
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [c * x + s * y + (1 - c) * dot(axis, v) * a for x, y, a in zip(v, cross(axis, v), axis)]
# the bender's own frame: along the tube, and the axis of the first bend
at, along = corners[0], unit(minus(corners[1], corners[0]))
axis = unit(cross(along, minus(corners[2], corners[1])))
worst = 0
for row in rows[1:-1]:
    at = [x + row["length"] * d for x, d in zip(at, along)]
    axis = turn(axis, along, row["rotation"])
    centre = [x + row["radius"] * d for x, d in zip(at, cross(axis, along))]
    reach = row["radius"] * math.tan(math.radians(row["angle"]) / 2)
    worst = max(worst, math.dist([x + reach * d for x, d in zip(at, along)], [row["x"], row["y"], row["z"]]))
    at = [x + y for x, y in zip(centre, turn(minus(at, centre), axis, row["angle"]))]
    along = turn(along, axis, row["angle"])
at = [x + rows[-1]["length"] * d for x, d in zip(at, along)]
worst = max(worst, math.dist(at, corners[-1]))
assert worst < 1e-14 * max(abs(x) for p in corners for x in p), worst # 2e-15 of it seen
END
done
"$TAUT" example pipe-run-harness > harness.json
refused 4 'no-table /details' make harness.json -o none.csv
"$TAUT" example pipe-elbow > elbow.json
refused 4 'no-table /details' make elbow.json -o none.csv
printf '%s' '{ "taut": 1, "curves": [{ "t": { "type": "bezier", "degree": 1 }, "points": [[0,0,0],[1,0,0]] }], "details": { "blends": [7], "bend_radius": "x" } }' > wrong.json
refused 4 'no-table /details' convert wrong.json -o none.csv
absent none.csv
finish
