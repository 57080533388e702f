# test_tutorial.sh -- the lessons of docs/tutorial: each command between ```sh and ``` is run as it stands, ends as it says
# ("# exit 4" behind it; else 0), and what stands between ```text and ``` after it is in what was printed, residuals of
# rounding aside. Each lesson shows a picture that is there.
. "$SOURCE/tests/cli/cli.sh"

mkdir bin
printf '#!/bin/sh\nexec "%s" "$@"\n' "$TAUT" > bin/taut
chmod +x bin/taut
PATH=$work/bin:$PATH

# Residuals of rounding, and limits made of it, differ from machine to machine.
lasting() {
    sed 's/ *$//; s/^ *//; s/): [0-9.]*e-1[0-9]/): ROUNDING/; s/limit [0-9.]*e-1[0-9]/limit ROUNDING/; s/, at .*//'
}

lessons=0
commands=0
for page in "$SOURCE"/docs/tutorial/[1-9]*.md; do
    name=$(basename "$page" .md)
    rm -rf lesson
    cp -r "$SOURCE/docs/tutorial" lesson
    grep -q '^\[!\[.*\](.*\.png)\]' "$page" || complain "$name shows no picture"
    awk -v out=lesson/block '
        /^```(sh|text)$/ { n++; file = sprintf("%s-%02d.%s", out, n, substr($0, 4)); next }
        /^```/ { file = "" }
        file != "" { print > file }' "$page"
    : > lesson/printed
    for block in lesson/block-*; do
        case $block in
        *.sh)
            : > lesson/printed
            while IFS= read -r line; do
                expected=$(printf '%s\n' "$line" | sed -n 's/.*# exit \([0-9]*\)$/\1/p')
                (cd lesson && sh -c "$line") >> lesson/printed 2>&1 < /dev/null
                code=$?
                if grep -q 'install libocct' lesson/printed; then
                    missing OpenCASCADE 'tools/deps.sh test, and build anew'
                    continue 3
                fi
                [ "$code" = "${expected:-0}" ] || complain "$name: $line: exit $code: $(cat lesson/printed)"
                commands=$((commands + 1))
            done < "$block"
            ;;
        *.text)
            lasting < lesson/printed > lesson/lasting
            lasting < "$block" | while IFS= read -r line; do
                grep -qF -- "$line" lesson/lasting || echo "$name: not printed: $line"
            done > lesson/lost
            [ ! -s lesson/lost ] || complain "$(cat lesson/lost lesson/lasting)"
            ;;
        esac
    done
    lessons=$((lessons + 1))
done
[ $lessons = 7 ] || complain "$lessons lessons"
[ $commands -ge 29 ] || complain "only $commands commands"
finish
