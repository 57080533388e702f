#!/bin/sh
# test_readme.sh -- what the README shows is what the program does: its problem gives its report, times and rounding aside, its files
# are written, its commands, constructions, bases and formats are those there are.
set -u
: "${TAUT:?the program}" "${SOURCE:?the source tree}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() {
    echo "FAIL: $*"
    failures=$((failures + 1))
}

block() { # block LANGUAGE: the first block of that language in the README
    awk -v fence="\`\`\`$1" '$0 == fence { on = 1; next } /^```/ { if (on) exit } on' "$SOURCE/README.md"
}

lasting() { # times differ from run to run; residuals of rounding, and limits made of it, from machine to machine
    grep -v -e '^ *time' -e '^taut: ' | sed 's/ *$//; s/\(holds ([a-z]*)\): [0-9.e+-]*/\1: RESIDUAL/; s/limit [0-9.]*e-1[0-9]/limit OF ROUNDING/'
}

block json > tent.json
"$TAUT" make tent.json -o model.json -o model.obj -o model.png 2> report || fail "the problem of the README is not made"
for file in model.json model.obj model.png; do
    [ -s $file ] || fail "$file is not written"
done
block text | lasting > promised
lasting < report > said
cmp -s promised said || fail "the report differs from the README's: $(diff promised said)"

"$TAUT" --help > help
sed -n 's/^| `taut \([a-z]*\) .*/\1/p; s/^| `taut \([a-z]*\)`.*/\1/p' "$SOURCE/README.md" | sort -u > listed
sed -n 's/^  taut \([a-z]*\)  .*/\1/p' help | sort -u > real
cmp -s listed real || fail "the table of commands differs from taut --help: $(diff listed real)"

# Every row of the lists is named in the README, in the form documents use.
for list in src/basis/basis_list.h src/problem/construct_list.h; do
    for name in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z-]*\)".*/\1/p' "$SOURCE/$list"); do
        grep -q "\`$name\`" "$SOURCE/README.md" || fail "$name of $list is not in the README"
    done
done
for name in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z]*\)".*/\1/p' "$SOURCE/src/io/format_list.h" "$SOURCE/src/draw/format_list.h"); do
    sed -n '/^Formats/,/^## /p' "$SOURCE/README.md" | grep -qi "\<$name\>" || fail "format $name is not in the README"
done

echo "$failures failures"
[ "$failures" -eq 0 ]
