# test_cad.sh -- STEP and IGES: out and back the same numbers; where OpenCASCADE was not there at build time, STEP goes out
# all the same, and for the rest there is word of what to install.
. "$SOURCE/tests/cli/cli.sh"

"$TAUT" example dirichlet-tent > problem.json
run 0 make problem.json --quiet -o model.json
points() { # points FILE: the coordinates of its first surface, one a line
    tr -d ' \n' < "$1" | sed 's/.*"points":\[\[\[//; s/\]\]\].*//' | tr '[],' '\n\n\n' | grep .
}
points model.json > here.txt
for file in model.step model.igs; do
    "$TAUT" convert model.json -o $file 2> err.txt
    code=$?
    if [ $file = model.igs ] && [ $code = 5 ] && grep -q install err.txt; then
        absent $file
        continue
    fi
    [ $code = 0 ] || complain "convert to $file: exit $code: $(cat err.txt)"
    "$TAUT" convert $file -o back.json 2> err.txt
    code=$?
    if [ $file = model.step ] && [ $code = 5 ] && grep -q install err.txt; then
        absent back.json
        continue
    fi
    [ $code = 0 ] || complain "convert from $file: exit $code: $(cat err.txt)"
    points back.json > there.txt
    cmp -s here.txt there.txt || complain "$file does not give the same points back"
    sed 's/"name": "[^"]*"/"name": "a\\nb"/' model.json > named.json
    run 0 convert named.json -o named.${file#model.}
    run 0 convert named.${file#model.} -o never.json
    rm never.json
    head -c 2000 $file > cut.${file#model.}
    run 3 convert cut.${file#model.} -o never.json
    absent never.json
done
finish
