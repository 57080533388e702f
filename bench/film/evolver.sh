#!/bin/sh
# evolver.sh TAUT -- films by taut and by Surface Evolver, whole processes: what they are off by, and processor seconds, the middle one
# of five. Evolver: refined, gradient steps with averaging, then Newton's on quadratic elements and on those of degree 4 or 6. The
# finest sail needs conjugate gradients before, and sails Newton's steps with a line search: without these it runs away.
set -eu
taut=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

row() { # row NAME EXACT COMMAND...: a line of the table
    python3 - "$@" << 'END'
import json, resource, subprocess, sys
name, exact, command = sys.argv[1], [float(value) for value in sys.argv[2].split(",")], sys.argv[3:]
times = []
for _ in range(5):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    found = subprocess.run(command, capture_output=True, text=True, errors="replace").stdout
    times.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
if "make" in command:
    figures = json.load(open("model.json"))["certificate"]["figures"]
    values = [figures["area"]] if len(exact) == 1 else [figures["energy"], figures["area"], sum(figures["lengths"])]
else:
    said = [line for line in found.splitlines() if line.startswith("found ")][-1].split()[1:]
    values = [float(value) for value in said]
off = " | ".join(f"{abs(value / right - 1):.0e}" for value, right in zip(values, exact))
print(f"| {name} | {off} | {sorted(times)[2]:.2f} |", flush=True)
END
}
evolve() { # evolve REFINEMENTS BEGIN: commands for Evolver
    printf 'quiet\n%b' "$2"
    for _ in $(seq "$1"); do printf 'r\n{ g 10; V; u; V } 20\n'; done
    printf 'M 2\nU\ng 100\nU\nhessian_seek; hessian; hessian\nlagrange 4\nhessian; hessian; hessian\n'
    printf 'printf "found %%.15g\\n", total_area\nq\nq\n'
}
draw() { # draw REFINEMENTS DEGREE FORCE BEGIN: the same with cables of one force
    printf 'quiet\n%b' "$4"
    for _ in $(seq "$1"); do printf 'r\n{ g 10; V; u; V } 20\n'; done
    [ "$1" -lt 3 ] || [ "$3" != 2 ] || printf 'U\ng 300\nU\n{ hessian_seek } 3\n'
    printf 'M 2\nU\ng 100\nU\n{ hessian_seek } 5\nlagrange %s\n{ hessian_seek } 3\n' "$2"
    printf 'printf "found %%.15g %%.15g %%.15g\\n", total_energy, total_area, cable.value / %s\nq\nq\n' "$3"
}
echo "| film | off by | seconds |"
echo "|---|---|---|"
for points in 12,6 16,8; do
    cat > ring.json << END
{ "taut": 1, "construct": "film", "u": { "type": "bspline", "degree": 4, "count": ${points%,*} },
  "v": { "type": "bspline", "degree": 4, "count": ${points#*,} }, "seams": [["u0", "u1"]], "edges": {
  "v0": { "fixed": { "circle": { "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1 } } },
  "v1": { "fixed": { "circle": { "center": [0, 0, 1], "normal": [0, 0, 1], "radius": 1 } } } } }
END
    row "catenoid, taut, ${points%,*} x ${points#*,} points" 5.99179697580228191 "$taut" make ring.json --quiet -o model.json
done
for levels in 2 3; do
    evolve $levels '' > commands
    row "catenoid, Evolver, refined $levels times" 5.99179697580228191 evolver -x -fcommands "$here/ring.fe"
done
for points in 8 10; do
    "$taut" example film-neovius | sed -e "s/\"count\": 10/\"count\": $points/" -e '/"images"/,$d' | sed '$ s/,$//' > neovius.json
    echo '}' >> neovius.json
    row "Neovius, taut, $points x $points points" 0.0731349610814478 "$taut" make neovius.json --quiet -o model.json
done
for levels in 1 2; do
    evolve $levels 'r\n' > commands
    row "Neovius, Evolver, refined $((levels + 1)) times" 0.0731349610814478 evolver -x -fcommands "$here/../../tests/cli/film-neovius.fe"
done
echo
echo "| sail | energy off by | area | lengths | seconds |"
echo "|---|---|---|---|---|"
sail=21.26014312285168,2.3306052677,9.4647689275757 # 30 x 30 points of degree 6; 29 x 29 of degree 5 are 1e-15 from it in energy
for points in 8 12 20; do
    basis="{ \"type\": \"bspline\", \"degree\": 4, \"count\": $points }"
    "$taut" example film-sail | sed "s/^ *\"construct\".*/&\n  \"least\": false, \"u\": $basis, \"v\": $basis,/" > sail.json
    row "saddle, taut, $points x $points points" $sail "$taut" make sail.json --quiet -o model.json
done
for levels in 1 2 3; do
    draw $levels 4 2 'r\n' > commands
    row "saddle, Evolver, refined $((levels + 1)) times" $sail evolver -x -fcommands "$here/../../tests/cli/film-sail.fe"
done
cable=3.536649624758578637,2.004664184976782615,5.106618132605986741
for points in 12,6 16,8 20,10; do
    cat > cable.json << END
{ "taut": 1, "construct": "film", "u": { "type": "bspline", "degree": 4, "count": ${points%,*} },
  "v": { "type": "bspline", "degree": 4, "count": ${points#*,} }, "seams": [["u0", "u1"]], "edges": {
  "v0": { "fixed": { "circle": { "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1 } } },
  "v1": { "cable": { "force": 0.3 }, "plane": { "point": [0, 0, 0.3], "normal": [0, 0, 1] } } } }
END
    row "ring and cable, taut, ${points%,*} x ${points#*,} points" $cable "$taut" make cable.json --quiet -o model.json
done
for how in '2 4' '2 6' '3 6'; do
    draw ${how% *} ${how#* } 0.3 '' > commands
    row "ring and cable, Evolver, refined ${how% *} times, degree ${how#* }" $cable evolver -x -fcommands "$here/cable.fe"
done
