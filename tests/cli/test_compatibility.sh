# test_compatibility.sh -- documents of earlier releases are read, with the same meaning: tests/cli/kept holds problems and
# the models that 0.1 made of them. A file there is never changed, only added.
. "$SOURCE/tests/cli/cli.sh"

count=0
for problem in "$SOURCE"/tests/cli/kept/*.problem.json; do
    name=$(basename "$problem" .problem.json)
    model=$SOURCE/tests/cli/kept/$name.model.json
    run 0 make "$problem" --quiet -o made.json
    [ "$name" = film-sail ] || run 0 certify "$model" # a film says how it is held in its problem alone
    run 0 certify "$model" "$problem"
    run 0 certify made.json "$problem"
    run 0 convert "$model" -o "$name.obj"
    count=$((count + 1))
done
[ "$count" -ge 9 ] || complain "only $count documents are kept"
finish
