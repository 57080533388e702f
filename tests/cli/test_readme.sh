#!/bin/sh
# test_readme.sh -- what the README shows is what the program does: its problem gives its report, times and rounding aside, its files
# are written, its commands and lines of Python run, its constructions and formats are those there are; the table of commands in
# docs/commands.md is whole.
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

# Every other command line of the README that begins with taut, in order; the studio where it was built.
awk '$0 == "```json" { n++; on = n == 2; next } /^```/ { on = 0 } on' "$SOURCE/README.md" > canopy.json
mkdir bin
printf '#!/bin/sh\nexec "%s" "$@"\n' "$TAUT" > bin/taut
chmod +x bin/taut
PATH=$work/bin:$PATH
sed -n 's/^    \(taut .*\)/\1/p; s/.*`\(taut studio [^`]*\)`.*/\1/p' "$SOURCE/README.md" > commands
[ "$(wc -l < commands)" -ge 4 ] || fail "few commands: $(cat commands)"
while IFS= read -r command; do
    sh -c "$command" > said 2>&1
    code=$?
    case $command in
    *' studio '*) [ $code = 0 ] || grep -q 'not-installed' said || fail "$command: exit $code: $(cat said)" ;;
    *) [ $code = 0 ] || fail "$command: exit $code: $(cat said)" ;;
    esac
done < commands
number=$(sed -n 's/.*`taut example` lists \([0-9]*\) worked problems.*/\1/p' "$SOURCE/README.md")
count=$("$TAUT" example | wc -l)
[ "${number:-0}" -le "$count" ] && [ "${number:-0}" -gt $((count - 20)) ] || fail "the README says $number examples, there are $count"
for program in 'make demo' 'make test'; do
    grep -qx "    $program" "$SOURCE/README.md" || fail "the README has no line of its own with $program"
done

# The lines of Python, where numpy is; a library with sanitizers needs a program that has them.
library=$(dirname "$(dirname "$TAUT")")/libtaut.so
block python > tent.py
if [ -e "$library" ] && ! grep -q __asan_init "$TAUT" && python3 -c 'import numpy' 2> /dev/null; then
    TAUT_LIBRARY=$library PYTHONPATH=$SOURCE/python PYTHONDONTWRITEBYTECODE=1 python3 tent.py > said 2>&1 || fail "the lines of Python: $(cat said)"
    grep -q '^True 4\.19971553' said || fail "Python says $(cat said)"
fi

"$TAUT" --help > help
sed -n 's/^| `taut \([a-z]*\) .*/\1/p; s/^| `taut \([a-z]*\)`.*/\1/p' "$SOURCE/docs/commands.md" | sort -u > listed
sed -n 's/^  taut \([a-z]*\)  .*/\1/p' help | sort -u > real
cmp -s listed real || fail "the table of commands differs from taut --help: $(diff listed real)"

# Every construction is named in the README, in the form documents use; bases in docs/format.md (tools/check_docs.sh).
for list in src/problem/construct_list.h; do
    for name in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z-]*\)".*/\1/p' "$SOURCE/$list"); do
        grep -q "\`$name\`" "$SOURCE/README.md" || fail "$name of $list is not in the README"
    done
done
for name in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z]*\)".*/\1/p' "$SOURCE/src/io/format_list.h" "$SOURCE/src/draw/format_list.h"); do
    grep -A 1 '^Files in and out' "$SOURCE/README.md" | grep -qi "\<$name\>" || fail "format $name is not in the README"
done

echo "$failures failures"
[ "$failures" -eq 0 ]
