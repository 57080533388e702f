#!/bin/sh
# evolver.sh TAUT -- films by taut and by Surface Evolver, whole processes: what their areas are off by, and processor seconds, the
# middle one of five. Evolver: refined, gradient steps with averaging, then Newton's on quadratic elements and on those of degree 4.
set -eu
taut=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

row() { # row NAME EXACT COMMAND...: a line of the table
    python3 - "$@" << 'END'
import resource, subprocess, sys
name, exact, command = sys.argv[1], float(sys.argv[2]), sys.argv[3:]
times = []
for _ in range(5):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    found = subprocess.run(command, capture_output=True, text=True, errors="replace").stdout
    times.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
area = None if "make" in command else [line for line in found.splitlines() if line.startswith("area ")][-1][5:]
if "make" in command:
    import json
    area = json.load(open("model.json"))["certificate"]["figures"]["area"]
print(f"| {name} | {abs(float(area) / exact - 1):.0e} | {sorted(times)[2]:.2f} |")
END
}
evolve() { # evolve REFINEMENTS BEGIN: commands for Evolver
    printf 'quiet\n%b' "$2"
    for _ in $(seq "$1"); do printf 'r\n{ g 10; V; u; V } 20\n'; done
    printf 'M 2\nU\ng 100\nU\nhessian_seek; hessian; hessian\nlagrange 4\nhessian; hessian; hessian\n'
    printf 'printf "area %%.15g\\n", total_area\nq\nq\n'
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
