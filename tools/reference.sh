#!/bin/sh
# reference.sh [--check] [ROOT] -- writes build/reference out of the comments of include/taut: a page for each header, and a
# first page with all headers and all names. --check writes nothing and says whether it is whole: each header and each symbol
# of the library in it, and the pages of docs/ to which it leads there.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)
check=
if [ "${1:-}" = --check ]; then
    check=1
    shift
fi
cd "${1:-$tools/..}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/reference"
touch "$work/calls" "$work/pages"
LC_ALL=C awk -f "$tools/headers.awk" include/taut/taut.h > "$work/said"
for header in include/taut/*.h; do
    if [ "$header" != include/taut/taut.h ] && ! grep -q "^header	${header#include/}\$" "$work/said"; then
        echo "$header: taut.h does not include it"
        exit 1
    fi
done

# Read twice: first for where each name is, then to write.
LC_ALL=C awk -F '\t' -v work="$work" '
    function escape(s) { # text that Markdown leaves as it is
        gsub(/[\\*_<>|~$`]|\[|\]/, "\\\\&", s)
        return s
    }
    function link(s,    words) { # a name, a file or a citation as a link, code as code; "" for what is none of them
        if (s in page) {
            return "[`" s "`](" (page[s] == at ? "" : page[s]) "#" s ")"
        } else if (s ~ /^taut\/[a-z]+\.h$/) {
            words = s
            gsub(/^taut\/|\.h$/, "", words)
            return (s in known) ? "[" s "](" words ".md)" : ""
        } else if (s ~ /^docs\//) {
            print s > (work "/pages")
            return "[" s "](../../" s ")"
        } else if (s ~ /^\[[A-Z][A-Za-z]+[0-9]+\]$/) {
            return "[" escape(s) "](../../docs/references.bib)"
        } else if (s ~ /^`/) {
            return s
        }
        return s ~ /^(taut|TAUT)_/ ? "" : "`" s "`"
    }
    function inline(s,    out, word, before) {
        while (match(s, pattern)) {
            word = substr(s, RSTART, RLENGTH)
            before = substr(s, 1, RSTART - 1)
            s = substr(s, RSTART + RLENGTH)
            out = out escape(before) (before ~ /[A-Za-z0-9)]$/ || link(word) == "" ? escape(word) : link(word))
        }
        return out escape(s)
    }
    function capital(s) {
        return toupper(substr(s, 1, 1)) substr(s, 2)
    }
    function turn(to) { # from one kind of block to another
        if (to == block && to != "para") {
            return
        }
        if (block == "code" || block == "decl") {
            print "```" > file
        }
        if (to != "") {
            print "" > file
        }
        if (to == "code") {
            print "```text" > file
        } else if (to == "decl") {
            print "```c" > file
        }
        block = to
    }
    BEGIN {
        shape = "[A-Za-z_0-9]*(\\[[^][ ,]+( ([+] )?[0-9a-z]+)?\\])+"
        pattern = "`[^`]+`|\\[[A-Z][A-Za-z]+[0-9][0-9][0-9][0-9]\\]|taut/[a-z]+\\.h|docs/[a-z/-]+\\.md|(taut|TAUT)_[A-Za-z0-9_]+|" \
            "[a-z]+->[a-z]+|" shape "|\\*[a-z][a-z_]*"
    }
    FNR == NR {
        if ($1 == "header") {
            known[$2] = 1
            gsub(/^taut\/|\.h$/, "", $2)
            header = $2 ".md"
        } else if ($1 == "name") {
            split($2, word, " ")
            page[word[2]] = header
        }
        next
    }
    $1 == "section" { section = $2 }
    $1 == "header" {
        if (file != "") {
            turn("")
        }
        at = $2
        gsub(/^taut\/|\.h$/, "", at)
        at = at ".md"
        file = work "/reference/" at
        anchors = ""
        print "# " $2 > file
    }
    $1 == "purpose" {
        turn("para")
        print inline(capital($2)) " [All headers](README.md)" > file
        print "| " section " | [taut/" substr(at, 1, length(at) - 3) ".h](" at ") | " inline($2) " |" > (work "/list")
        section = ""
    }
    $1 == "entry" { turn(""); anchors = ""; heading = $2 }
    $1 == "name" {
        split($2, word, " ")
        anchors = anchors "<a id=\"" word[2] "\"></a>"
        print word[2] "\t| [`" word[2] "`](" at "#" word[2] ") | " word[1] " | taut/" substr(at, 1, length(at) - 3) ".h |" > (work "/names")
        next
    }
    heading != "" && $1 != "entry" {
        gsub(/, /, "`, `", heading)
        print "\n### " anchors "`" heading "`" > file
        heading = ""
    }
    $1 == "para" { turn("para"); print inline($2) > file }
    $1 == "code" { turn("code"); print $2 > file }
    $1 == "decl" { turn("decl"); print $2 > file }
    $1 == "item" { turn("item"); print "- `" $2 "`: " inline($3) > file }
    $1 == "para" && at == "status.md" && anchors == "" { print inline($2) "\n" > (work "/calls") }
    END { turn("") }
' "$work/said" "$work/said"

{
    cat << 'TEXT'
# The library, name by name

`#include <taut/taut.h>` is all of `libtaut`; `cc program.c $(pkg-config --cflags --libs taut)` compiles with it. Each header
is a page here, made of the header's own comments (`make reference`), and a manual page, such as taut_surface(3); taut(3) leads to
all of them.
Whole programs: [README](../../README.md#from-c), [examples/c](../../examples/c).

## What holds of every call

TEXT
    sed 's/](#/](status.md#/g' "$work/calls"
    printf '## Headers, in the order of the work\n\n| | header | about |\n|---|---|---|\n'
    cat "$work/list"
    printf '\n## All names\n\n| name | is a | in |\n|---|---|---|\n'
    LC_ALL=C sort -f "$work/names" | cut -f 2
} > "$work/reference/README.md"

if [ -z "$check" ]; then
    mkdir -p build
    rm -rf build/reference
    cp -r "$work/reference" build/reference
    exit
fi
sort -u "$work/pages" | while read -r page; do
    [ -e "$page" ] || echo "the headers lead to $page, which is not there"
done > "$work/lost"
cat tools/symbols*.txt 2> /dev/null | while read -r symbol; do
    grep -q "^| \[\`$symbol\`\]" "$work/reference/README.md" || echo "the headers know no $symbol"
done >> "$work/lost"
cat "$work/lost"
[ ! -s "$work/lost" ]
