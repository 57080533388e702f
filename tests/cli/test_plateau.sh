# test_plateau.sh -- films from the command line: curves, estimates, and stopping halfway.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example plateau-curves > curves.json
run 0 make curves.json -o film.json
contains err.txt 'deviation'
contains err.txt 'boundary +holds'
run 0 certify film.json curves.json
sed 's/"deviation": [-+.0-9e]*/"deviation": 1000/' film.json > told.json
cmp -s film.json told.json && complain "no deviation was told"
run 1 certify told.json curves.json
sed '/"u0"/s/\[-1.0, -1.0, 0.0\]/[-1.0, -1.0, 0.25]/' curves.json > apart.json
cmp -s curves.json apart.json && complain "nothing was moved"
refused 3 'corners /curves/v0 found 0\.25' make apart.json --quiet
contains err.txt 'misses u0'
"$TAUT" example plateau-bicubic | sed 's/"points"/"refine": 2, "points"/' > refine.json
run 0 make refine.json -o film.json
contains film.json 'estimated_least_area'
sed 's/"refine": 2/"tolerance_area": 1e-7/' refine.json > adapt.json
run 0 make adapt.json -o film.json
run 0 certify film.json adapt.json
sed 's/"refine": 2/"refine": 2, "tolerance_area": 1e-7/' refine.json > both.json
refused 3 'conflict /tolerance_area' make both.json --quiet
sed 's/"refine": 2/"tolerance_area": 0/' refine.json > zero.json
refused 3 'value /tolerance_area found 0 expected a number from 1e-11 .*' make zero.json --quiet

# A time that is over before there is anything, and one that never is: no file, or the same bytes.
"$TAUT" example plateau-bicubic > timed.json
refused 1 'time timed.json found null expected 1e-6' make timed.json --time-limit 1e-6 -o timed-film.json --quiet
absent timed-film.json
run 0 make timed.json --time-limit 1e6 -o timed-film.json --quiet
run 0 make timed.json -o film.json --quiet
cmp timed-film.json film.json || complain "a limit that is not reached changes the model"
run 2 make timed.json --time-limit 0

# A film proved least, with the witness that the model carries; asked for, it is proved or exit 1.
"$TAUT" example plateau-skew > skew.json
run 0 make skew.json -o film.json
contains err.txt 'least +holds \(bound\): [0-9.]+e-12, limit 1e-06'
contains film.json '"lower_bound": 1\.2792615711[67]'
run 0 certify film.json skew.json
run 0 certify film.json
sed 's/"points"/"least": false, "points"/' skew.json > declined.json
run 0 make declined.json -o declined-film.json
contains err.txt 'least +undecided \(bound\): -, limit 1e-06: declined'
grep -q '"coefficients"' declined-film.json && complain "a witness was looked for"
run 0 make refine.json -o film.json
contains err.txt 'least +undecided \(bound\): 0\.000[0-9]+, limit 1e-06: coarse'
for gap in 1e-4 1e-6 1e-9; do
    sed "s/\"refine\": 2/\"gap\": $gap/" refine.json > gap.json
    run 0 make gap.json -o film.json
    contains err.txt "least +holds \(bound\): .*, limit (0.0001|$gap|1e-0[0-9])"
    run 0 certify film.json gap.json
done
sed 's/"gap": 1e-9/"gap": 1e-11/' gap.json > finer-gap.json
run 1 certify film.json finer-gap.json
contains err.txt 'least +DOES NOT HOLD'
sed 's/"gap": 1e-9/"gap": 1e-9, "least": false/' gap.json > both.json
refused 3 'conflict /gap' make both.json --quiet
sed 's/"gap": 1e-9/"gap": 1e-12/' gap.json > zero.json
refused 3 'value /gap found 1e-12 expected a number above 1e-12 .*' make zero.json --quiet
sed 's/"gap": 1e-9/"gap": 1e-9, "refine": 1/' gap.json > both.json
refused 3 'conflict /gap' make both.json --quiet

cat > bent-in.json << 'END'
{ "taut": 1, "construct": "plateau", "gap": 1e-4,
  "u": { "type": "bezier", "degree": 2 }, "v": { "type": "bezier", "degree": 2 },
  "points": [[[0, 0, 0], [0.5, 1, 0], [0, 2, 0]], [[1, 0, 0], null, [1, 2, 0]], [[2, 0, 0], [2, 1, 0], [2, 2, 0]]] }
END
refused 1 'not-convex /gap' make bent-in.json --quiet
sed 's/"gap": 1e-4,//' bent-in.json > bent.json
run 0 make bent.json -o film.json
contains err.txt 'least +undecided \(bound\): -, limit 1e-06: convex'
cat > faceted.json << 'END'
{ "taut": 1, "construct": "plateau", "method": "normal", "gap": 1e-10,
  "u": { "type": "bspline", "degree": 1, "count": 3 }, "v": { "type": "bspline", "degree": 1, "count": 3 },
  "points": [[[0, 0, 0], [0, 1, 0.5], [0, 2, 0]], [[1, 0, 0], null, [1, 2, 0]], [[2, 0, 0], [2, 1, 0], [2, 2, 0.5]]] }
END
refused 1 'gap /gap found [0-9.e-]+ expected 1e-10' make faceted.json --quiet

# A plane boundary that crosses itself: no quadrature settles the area of what folds.
cat > folded.json << 'END'
{ "taut": 1, "construct": "plateau", "method": "normal",
  "u": { "type": "bspline", "degree": 3, "count": 5 }, "v": { "type": "bspline", "degree": 3, "count": 5 },
  "points": [[[0, 0, 0], [3, 1, 0], [3, 2, 0], [3, 3, 0], [0, 4, 0]],
             [[1, 2.5, 0], null, null, null, [1, 4, 0]],
             [[2, 2.5, 0], null, null, null, [2, 4, 0]],
             [[3, 2.5, 0], null, null, null, [3, 4, 0]],
             [[4, 0, 0], [4, 1, 0], [4, 2, 0], [4, 3, 0], [4, 4, 0]]] }
END
refused 1 'folds folded\.json' make folded.json -o folded-film.json --quiet
absent folded-film.json

# A film that still slides within itself when its steps are up: what would do is said.
cat > few.json << 'END'
{ "taut": 1, "construct": "plateau", "max_iterations": 12,
  "u": { "type": "bspline", "degree": 3, "count": 20 }, "v": { "type": "bspline", "degree": 3, "count": 20 },
  "curves": { "u0": { "t": { "type": "bezier", "degree": 2 }, "points": [[-1, -1, 0], [-1, 0, -2], [-1, 1, 0]] },
              "u1": { "t": { "type": "bezier", "degree": 2 }, "points": [[1, -1, 0], [1, 0, -2], [1, 1, 0]] },
              "v0": { "t": { "type": "bezier", "degree": 2 }, "points": [[-1, -1, 0], [0, -1, 2], [1, -1, 0]] },
              "v1": { "t": { "type": "bezier", "degree": 2 }, "points": [[-1, 1, 0], [0, 1, 2], [1, 1, 0]] } } }
END
refused 1 'slides /tolerance found [0-9.]+e-10 expected 1e-10' make few.json --quiet
contains err.txt 'take the method \\"normal\\", or a tolerance of 1e-0'
# Tables of points are no part of the short report.
"$TAUT" example plateau-bicubic | sed 's/"points"/"method": "normal", "points"/' > normal.json
run 0 make normal.json -o normal-film.json
contains err.txt 'directions +\([0-9]+ rows: see --report\)'

# A film that finds no rest once knots are put in: the space is named.
cat > finer.json << 'END'
{ "taut": 1, "construct": "plateau", "tolerance_area": 1e-6,
  "u": { "type": "bezier", "degree": 3 }, "v": { "type": "bezier", "degree": 3 },
  "points": [[[0, 0, 0], [3, 1, 0], [-2, 2, 0], [0, 3, 0]],
             [[1, 0, 3], null, null, [1, 3, 3]],
             [[2, 0, -3], null, null, [2, 3, 3]],
             [[3, 0, 0], [3, 1, 4], [3, 2, -4], [3, 3, 0]]] }
END
refused 1 'folds finer\.json' make finer.json --quiet
contains err.txt 'with 5 by 5 points'

# A film that takes long, stopped with Ctrl-C by who sees its progress on a terminal: nothing is left behind, and the exit
# code is that of the signal.
"$TAUT" example plateau-curves | sed 's/"count": [0-9]*/"count": 300/g' > long.json
until grep -q 'least area  [0-9]* s\|Script done' seen.txt 2> /dev/null; do
    sleep 0.05
done | { cat; printf '\003'; } |
    script -qefc "exec env --default-signal=INT '$TAUT' make long.json -o long-film.json -o long.obj" seen.txt > /dev/null
code=$?
[ "$code" = 130 ] || complain "interrupted: exit $code, expected 130: $(cat seen.txt)"
absent long-film.json long.obj

# With --json a program is told too, wherever the signal finds it: one line, and nothing else.
for signal in INT TERM; do
    [ "$signal" = INT ] && expected=130 || expected=143
    env --default-signal=$signal "$TAUT" make long.json --json -o long-film.json > out.txt 2> err.txt &
    film=$!
    sleep 0.5
    kill -$signal "$film"
    wait "$film"
    code=$?
    [ "$code" = "$expected" ] || complain "$signal: exit $code, expected $expected: $(cat err.txt)"
    contains err.txt "^{ .error.: { .exit.: $expected, .reason.: .interrupted., .where.: .., .message.: .stopped on request., "
    [ "$(wc -l < err.txt)" = 1 ] || complain "$signal: not one line: $(cat err.txt)"
    absent long-film.json
done
finish
