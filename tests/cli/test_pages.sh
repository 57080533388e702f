# test_pages.sh -- the documents that the pages show between ```json and ``` are made as they stand, their claims hold, and they
# give what the page says: a comment <!-- gives: PATTERN --> after the document is looked for in the model.
. "$SOURCE/tests/cli/cli.sh"
cat "$SOURCE"/README.md "$SOURCE"/docs/*.md | awk '
    /^```json$/ { on = 1; n++; next }
    /^```/ { on = 0 }
    on { print > ("page" n ".json") }
    sub(/^<!-- gives: /, "") && sub(/ -->$/, "") && n > 0 { print > ("page" n ".gives") }'
count=0
for document in page*.json; do
    count=$((count + 1))
    run 0 make "$document" --quiet -o model.json
    contains model.json '^    "holds": true'
    gives=${document%.json}.gives
    [ -s "$gives" ] || complain "$(head -n 3 "$document"): no <!-- gives: PATTERN --> after it says what it gives" || continue
    while IFS= read -r pattern; do
        contains model.json "$pattern"
    done < "$gives"
done
[ $count -ge 6 ] || complain "only $count documents were found"
finish
