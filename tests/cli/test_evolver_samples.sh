# test_evolver_samples.sh -- Surface Evolver's own sample files, of the Debian package evolver-doc, written as documents of taut
# (bench/film/samples): areas and pressures side by side, after each file's own commands, on elements of degree 4 to 8. Areas by taut
# are checked against closed forms where there are some. Films in two frames, tetra and cubeframe, have files of Evolver beside them.
. "$SOURCE/tests/cli/cli.sh"

samples=/usr/share/doc/evolver/examples
command -v evolver > /dev/null || skip 'Surface Evolver' 'tools/deps.sh check'
[ -f $samples/cat.fe ] || skip 'its samples' 'the Debian package evolver-doc'

evolve() { # evolve NAME COMMANDS: theirs-NAME.txt
    printf 'quiet\n%b\nprintf "\\nAREA %%.15g\\n", total_area\nq\nq\n' "$2" > commands
    file="$SOURCE/bench/film/samples/$1.fe"
    [ -f "$file" ] || file="$samples/$1.fe"
    evolver -x -fcommands "$file" > "theirs-$1.txt" 2>&1 < /dev/null || complain "Evolver failed over $1.fe: $(tail -n 3 "theirs-$1.txt")"
}
finer='hessian\nlagrange 4\nhessian; hessian; hessian'
pressure='printf "\\nPRESSURE %.15g\\n", body[1].pressure'
evolve cat gogo4
evolve catbody "gogo\n$finer\n$pressure"
evolve quad 'gogo\nlagrange 6\nhessian; hessian; hessian'
evolve mound "gogo\n$finer\n$pressure"
evolve cube "gogo2\n$pressure"
settle='{ g 10; V; u; V } 10\nM 2\nU\ng 60\nU\nhessian; hessian\nlagrange 6\nhessian; hessian; hessian'
for name in tetra cubeframe; do
    evolve $name "g 5\nr\ng 20\nr\n$settle"
done
for name in cat catbody quad mound cube tetra cubeframe; do
    run 0 make "$SOURCE/bench/film/samples/$name.json" --quiet -o $name.json
done
python3 - <<'END' || complain "Evolver has other films"
import json, math, re

def theirs(name, word):
    text = open(f"theirs-{name}.txt", errors="replace").read()
    return float(re.findall(rf"^{word} (\S+)", text, re.M)[-1])

def ours(name):
    certificate = json.load(open(name + ".json"))["certificate"]
    assert not [claim for claim in certificate["claims"] if claim["holds"] is False], name
    figures = certificate["figures"]
    return figures["area"], figures.get("pressures", [None])[0]

def near(found, expected, part, what):
    print(what, found, expected, found / expected - 1)
    assert abs(found / expected - 1) < part, (what, found, expected)

table = 9                            # the plate that mound.fe shows its drop on
copies = {"mound": 4, "cube": 8}     # of the piece between mirrors
for name, part, pressure in (("cat", 4e-10, None), ("catbody", 2e-8, 3e-6), ("quad", 4e-11, None),
                             ("mound", 2e-8, 2e-8), ("cube", 1e-12, 1e-10),
                             ("tetra", 1e-13, None), ("cubeframe", 5e-10, None)):
    area, force = ours(name)
    area *= copies.get(name, 1)
    near(theirs(name, "AREA") - (table if name == "mound" else 0), area, part, name)
    if pressure is not None:         # catbody.json has what is around its body
        near(theirs(name, "PRESSURE"), -force if name == "catbody" else force, pressure, name + ", pressure")
z, drop, ball = 0.55, (3 / (2 * math.pi)) ** (1 / 3), (3 / (4 * math.pi)) ** (1 / 3)
near(ours("cat")[0], 2 * math.pi * (z + math.sinh(2 * z) / 2), 1e-12, "catenoid")
near(4 * ours("mound")[0], 2 * math.pi * drop ** 2, 1e-12, "half a ball")
near(ours("mound")[1], 2 / drop, 1e-9, "its pressure")
near(ours("tetra")[0], 3 / (2 * math.sqrt(2)), 1e-14, "tetrahedron")
near(8 * ours("cube")[0], 4 * math.pi * ball ** 2, 1e-12, "a ball")
END
# cat.fe as it comes has rings a little too far apart, and its tutorial lets the neck collapse
refused 4 'collapses /edges/v1' make "$SOURCE/bench/film/samples/cat-given.json" -o given.json
finish
