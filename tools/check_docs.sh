#!/bin/sh
# check_docs.sh [ROOT] -- nothing public without a word about it: every declaration in include/taut has its comment or stands in
# a group that has one; every construction, basis, format and command has its place in the pages; every link leads somewhere.
set -eu
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
    fi
    grep -lq "\"construct\": *\"$name\"" examples/*.json || complain "no example of $name"
done
for name in $(names src/basis/basis_list.h); do
    grep -q "^| \`$name\`" docs/format.md || complain "docs/format.md has no row for the basis $name"
done
for name in $(names src/io/format_list.h); do
    grep -q "^| .*\`\.$name\`" docs/format.md || complain "docs/format.md has no row for the format $name"
done
for name in $(sed -n 's/^ *X(\([a-z]*\)).*/\1/p' src/cli/command_list.h 2> /dev/null); do
    grep -q "^| \`taut $name[ \`]" README.md || complain "README.md has no row for taut $name"
done

# Links of the pages, but those to the web and within a page.
for page in README.md CONTRIBUTING.md docs/*.md docs/*/*.md; do
    [ -e "$page" ] || continue
    sed 's/`[^`]*`//g' "$page" | grep -o '](\([^)#]*\)[^)]*)' | sed 's/^](//; s/[)# ].*//' | sort -u | while read -r link; do
        case $link in http:* | https:* | mailto:* | '') continue ;; esac
        [ -e "$(dirname "$page")/$link" ] || echo "$page: leads to $link, which is not there"
    done
done > "$lost"
if [ -s "$lost" ]; then
    cat "$lost"
    bad=1
fi
exit $bad
