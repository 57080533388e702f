#!/bin/sh
# check_docs.sh [ROOT] -- nothing public without a word about it: every declaration in include/taut has its comment or stands in
# a group that has one; every construction, basis, format and command has its place in the pages; every link leads somewhere; the
# reference that is made of the headers is whole.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$(dirname "$0")/..}"
bad=0
lost=$(mktemp)
trap 'rm -f "$lost"' EXIT

complain() {
    echo "$*"
    bad=1
}

# A group is what stands between blank lines. A function needs a comment in its group, before it or on its own lines;
# a type, a comment before it or on its members; a macro the same.
for header in include/taut/*.h; do
    [ -e "$header" ] || continue
    awk '
        function close_group(    i) {
            for (i = 1; i <= waiting; i++) {
                printf "%s:%d: no comment says what this is: %s\n", FILENAME, line[i], text[i]
                bad = 1
            }
            waiting = commented = 0
        }
        FNR == 1 && !/^\/\*/ { printf "%s: does not begin with a comment that says what it is for\n", FILENAME; bad = 1 }
        /^$/ && !inside && !braces { close_group(); next }
        /\/\*/ && !/__cplusplus/ {
            commented = 1
            if (!inside) {
                waiting = 0 # also one at the end of the line, or on a member
            }
        }
        /\/\*/ { inside = 1 }
        /\*\// { inside = 0 }
        /^typedef struct taut_[a-z_]+ taut_[a-z_]+;$/ { next } # an opaque type: the head of its header is about it
        /^(TAUT_API|typedef|enum)/ || (/^#define TAUT_[A-Z]/ && !/_H$/ && !/_API/) {
            if (!commented) {
                line[++waiting] = FNR
                text[waiting] = $0
            }
        }
        { braces += gsub(/{/, "{") - gsub(/}/, "}"); if (/extern "C"/) { braces = 0 } }
        END { close_group(); exit bad }
    ' "$header" || bad=1
done

# A worked problem is listed with its title.
for example in examples/*.json; do
    [ -e "$example" ] || continue
    name=$(basename "$example" .json)
    grep -q "^$name: ." examples/titles.txt || complain "examples/titles.txt has no line \"$name: ...\""
done
for name in $(sed -n 's/^\([a-z0-9-]*\):.*/\1/p' examples/titles.txt 2> /dev/null); do
    [ -e "examples/$name.json" ] || complain "examples/titles.txt has a title of $name, which is no example"
done

names() { # names LIST: the words that documents use
    sed -n 's/.*X([a-z_0-9]*, "\([a-z0-9.-]*\)".*/\1/p' "$1" 2> /dev/null || true
}

for name in $(names src/problem/construct_list.h); do
    grep -q "^### .*\`$name\`" docs/format.md || complain "docs/format.md has no section \`$name\`"
    grep -q "\"const\": \"$name\"" docs/schema/problem.json || complain "docs/schema/problem.json does not know $name"
    page=$(grep -lE "^#+ .*\`$name\`" docs/*.md | grep -v format.md | head -n 1)
    if [ -z "$page" ]; then
        complain "no page of docs/ has \`$name\` in a heading"
    elif ! grep -q '!\[[^]].*](gallery/' "$page"; then
        complain "$page shows no picture of $name"
    elif ! grep -q "\"construct\": *\"$name\"" "$page"; then
        complain "$page shows no document of $name"
    else
        for part in 'The problem' 'A worked document' Options Certificate 'What can go wrong' 'Accuracy and cost' Source; do
            grep -qx "## $part" "$page" || complain "$page has no section \"$part\""
        done
    fi
    grep -lq "\"construct\": *\"$name\"" examples/*.json || complain "no example of $name"
done
for name in $(names src/basis/basis_list.h); do
    grep -q "^| \`$name\`" docs/format.md || complain "docs/format.md has no row for the basis $name"
done
for name in $(names src/io/format_list.h; names src/draw/format_list.h); do
    grep -q "^| .*\`\.$name\`" docs/format.md || complain "docs/format.md has no row for the format $name"
done
for name in $(sed -n 's/^ *X(\([a-z]*\)).*/\1/p' src/cli/command_list.h 2> /dev/null); do
    grep -q "^| \`taut $name[ \`]" docs/commands.md || complain "docs/commands.md has no row for taut $name"
done

if [ -e include/taut/taut.h ]; then
    "$tools/reference.sh" --check . || bad=1
fi

# Links of the pages, but those to the web: the file, and in pages the place, a heading in lower case without marks or an id.
pages=$(ls README.md CONTRIBUTING.md CHANGELOG.md docs/*.md docs/*/*.md 2> /dev/null || true)
# shellcheck disable=SC2086
[ -z "$pages" ] || awk '
    function resolve(path,    folder) { # from the folder of this page
        folder = FILENAME
        sub(/[^\/]*$/, "", folder)
        return path == "" ? FILENAME : folder path
    }
    function plain(path) {
        while (sub(/[^\/]+\/\.\.\//, "", path)) { }
        return path
    }
    FNR == 1 { fenced = 0; seen[FILENAME] = 1 }
    /^```/ { fenced = !fenced }
    fenced { next }
    {
        rest = $0
        while (match(rest, /<a id="[^"]*"/)) {
            place[FILENAME "#" substr(rest, RSTART + 7, RLENGTH - 8)] = 1
            rest = substr(rest, RSTART + RLENGTH)
        }
    }
    /^#+ / {
        heading = $0
        gsub(/^#+ |<[^>]*>/, "", heading)
        heading = tolower(heading)
        gsub(/[^a-z0-9_ -]/, "", heading)
        gsub(/ /, "-", heading)
        place[FILENAME "#" heading] = 1
    }
    {
        rest = $0
        gsub(/`[^`]*`/, "", rest)
        while (match(rest, /\]\([^)]*\)/)) {
            link = substr(rest, RSTART + 2, RLENGTH - 3)
            rest = substr(rest, RSTART + RLENGTH)
            sub(/ .*/, "", link)
            if (link ~ /^(https?|mailto):/ || link == "") {
                continue
            }
            mark = index(link "#", "#")
            printf "%s\t%s\t%s\n", FILENAME, link, resolve(substr(link, 1, mark - 1))
            if (mark < length(link)) {
                from[++links] = FILENAME "\t" link
                page[links] = plain(resolve(substr(link, 1, mark - 1)))
                goal[links] = page[links] substr(link, mark)
            }
        }
    }
    END {
        for (i = 1; i <= links; i++) {
            if ((page[i] in seen) && !(goal[i] in place)) {
                print from[i] "\t"
            }
        }
    }' $pages | sort -u | while IFS='	' read -r page link file; do
    if [ -z "$file" ]; then
        echo "$page: leads to $link, where there is no such place"
    elif [ ! -e "$file" ]; then
        echo "$page: leads to $link, which is not there"
    fi
done > "$lost"
if [ -s "$lost" ]; then
    cat "$lost"
    bad=1
fi
# Prose is read in a terminal, too: lines below 120 characters; tables, code, pictures and what programs print are as they are.
prose=$(ls README.md CHANGELOG.md CONTRIBUTING.md docs/*.md docs/tutorial/*.md docs/plugins/*.md 2> "$lost" || true)
# shellcheck disable=SC2086 # no name has a space
[ -z "$prose" ] || awk '
    FNR == 1 { code = printed = 0 }
    /^ *```/ { code = !code }
    /<!-- bench/ { printed = 1 }
    /<!-- end/ { printed = 0 }
    length($0) > 120 && !code && !printed && !/^ *\|/ && !/^    / && !/!\[/ {
        printf "%s:%d: a line of %d characters, expected at most 120\n", FILENAME, FNR, length($0)
        long = 1
    }
    END { exit long }' $prose || bad=1
# A cell holds a phrase: what needs a sentence has its place below the table.
# shellcheck disable=SC2086
[ -z "$prose" ] || awk '
    FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    code || !/^ *\|/ { next }
    {
        row = $0
        gsub(/\\\|/, "  ", row)
        cells = split(row, cell, "|")
        for (i = 1; i <= cells; i++) {
            gsub(/^ +| +$/, "", cell[i])
            if (length(cell[i]) > 160) {
                printf "%s:%d: a cell of %d characters, expected at most 160\n", FILENAME, FNR, length(cell[i])
                long = 1
            }
        }
    }
    END { exit long }' $prose || bad=1
# Words of a private idiom, which a reader has to guess at.
# shellcheck disable=SC2086
[ -z "$prose" ] || awk '
    FNR == 1 { code = 0 }
    /^ *```/ { code = !code }
    code || /^    / || FILENAME ~ /CHANGELOG/ { next }
    match(" " tolower($0) " ", /[^a-z`_](told|stands|unless said|lie apart|at the most)[^a-z`_]/) {
        printf "%s:%d: \"%s\" is no plain word\n", FILENAME, FNR, substr(" " $0 " ", RSTART + 1, RLENGTH - 2)
        private = 1
    }
    END { exit private }' $prose || bad=1
# Python's functions are made from the schema, the pages' reasons and the headers' sources.
[ ! -e tools/python_constructions.py ] || python3 tools/python_constructions.py --check || bad=1
exit $bad
