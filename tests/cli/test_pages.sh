# test_pages.sh -- the documents that the pages show between ```json and ``` are made as they stand, their claims hold, and they
# give the numbers that the pages say.
. "$SOURCE/tests/cli/cli.sh"
cat "$SOURCE"/README.md "$SOURCE"/docs/*.md |
    awk '/^```json$/ { on = 1; n++; next } /^```/ { on = 0 } on { print > ("page" n ".json") }'
count=0
for document in page*.json; do
    count=$((count + 1))
    run 0 make "$document" --quiet -o model.json
    contains model.json '^    "holds": true'
    construct=$(sed -n 's/.*"construct": "\([a-z-]*\)".*/\1/p' "$document")
    case $construct in
    biharmonic) contains model.json '\[1, 1, 2\]' ;;
    bonnet) contains model.json '^ *\[\[0, 0, 1\]' ;;
    dirichlet) contains model.json '\[0, 0, -0.5\].*' && contains model.json '"area": 4\.19971553' ;;
    harmonic-extension) contains model.json '\[3, 1, 3\]' ;;
    plateau) contains model.json '-0\.46917728[0-9]*\]' && contains model.json '"area": 4\.1995568101' ;;
    *) complain "$document: a document of $construct, about which the page's words are not tried here" ;;
    esac
done
[ $count -ge 6 ] || complain "only $count documents were found"
finish
