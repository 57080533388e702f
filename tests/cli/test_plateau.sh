# test_plateau.sh -- films from the command line: curves, estimates, and stopping halfway.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example plateau-curves > curves.json
run 0 make curves.json -o film.json
contains err.txt 'deviation'
contains err.txt 'boundary +holds'
run 0 certify film.json curves.json
sed '/"u0"/s/\[-1.0, -1.0, 0.0\]/[-1.0, -1.0, 0.25]/' curves.json > apart.json
cmp -s curves.json apart.json && complain "nothing was moved"
refused 3 'misses' make apart.json --quiet
"$TAUT" example plateau-bicubic | sed 's/"points"/"refine": 2, "points"/' > refine.json
run 0 make refine.json -o film.json
contains film.json 'estimated_least_area'
sed 's/"refine": 2/"tolerance_area": 1e-7/' refine.json > adapt.json
run 0 make adapt.json -o film.json
run 0 certify film.json adapt.json
sed 's/"refine": 2/"refine": 2, "tolerance_area": 1e-7/' refine.json > both.json
refused 3 'tolerance_area' make both.json --quiet
sed 's/"refine": 2/"tolerance_area": 0/' refine.json > zero.json
refused 3 'tolerance_area' make zero.json --quiet

# A film that takes long, stopped: nothing is left behind, and the exit code is that of the signal.
"$TAUT" example plateau-curves | sed 's/"count": [0-9]*/"count": 60/g' > long.json
timeout --preserve-status -s INT 1 "$TAUT" make long.json -o long-film.json -o long.obj > out.txt 2> err.txt
code=$?
[ "$code" = 130 ] || complain "interrupted: exit $code, expected 130"
absent long-film.json long.obj
finish
