#!/bin/sh
# test_mutants.sh -- tools/mutants.sh tells mutants that are caught from those that are not, and refuses rows that fit nothing;
# tools/new_mutant.py makes such a row.
set -u
: "${SOURCE:?the source tree}"
unset MUTANTS_TREE MUTANTS_COUNT GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
table=$tree/tests/mutants/core.json
failures=0

fail() {
    echo "FAIL: $*"
    failures=$((failures + 1))
}

# A project of one function, whose test wants one(1) to be 2, and a test that looks at nothing.
mkdir -p "$tree/tools" "$tree/src/core" "$tree/src/io" "$tree/tests/mutants"
cp "$SOURCE/tools/mutants.sh" "$SOURCE/tools/mutants.py" "$SOURCE/tools/mutant_table.py" "$SOURCE/tools/mutant_compile.py" \
    "$SOURCE/tools/new_mutant.py" "$SOURCE/tools/check_mutants.sh" "$tree/tools"
printf '%s\n' '#include <stddef.h>' 'int one(int x);' 'int one(int x)' '{' '    const int most = 9;' '    if (x > most) {' \
    '        x = most;' '    }' '    x += 1; /* x += 2; */' '    return x;' '}' > "$tree/src/core/one.c"
printf 'int one(int x);\nint main(void) { return one(1) != 2; }\n' > "$tree/src/core/check.c"
printf 'int main(void) { return 0; }\n' > "$tree/src/io/blind.c"
cat > "$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small C)
enable_testing()
add_executable(test-unit-core-one src/core/one.c src/core/check.c)
add_test(NAME unit/core/one COMMAND test-unit-core-one)
add_executable(test-unit-io-blind src/core/one.c src/io/blind.c)
add_test(NAME unit/io/blind COMMAND test-unit-io-blind)
END
printf '/build/\n' > "$tree/.gitignore"
cp -r "$tree" "$tree.clean"
trap 'rm -rf "$tree" "$tree.clean"' EXIT
(cd "$tree" && git init -q . && git add . && git -c user.name=T -c user.email=t@example.org commit -qm small) || fail git

row() { # row NAME OLD NEW [CAUGHT-BY [FILE]]: one row
    printf '    {\n        "name": "%s",\n        "what": "so",\n        "file": "%s",\n        "old": "%s",\n        "new": "%s",\n' \
        "$1" "${5:-src/core/one.c}" "$2" "$3"
    printf '        "caught_by": "%s"\n    }' "${4:-^unit/core/one\$}"
}
rows() { # rows ROW...: the table
    printf '[\n%s' "$1"
    shift
    for each in "$@"; do
        printf ',\n%s' "$each"
    done
    printf '\n]\n'
}
refuses() { # refuses EXPECTED ARGUMENT...: mutants.sh fails and says so in a line
    expected=$1
    shift
    said=$("$tree/tools/mutants.sh" "$@" 2>&1) && fail "mutants.sh $* lets through what should be: $expected"
    printf '%s\n' "$said" | grep -qF -- "$expected" || fail "mutants.sh $* says \"$said\", expected \"$expected\""
    [ "$(printf '%s\n' "$said" | wc -l)" -eq 1 ] || fail "mutants.sh $* says more than a line: $said"
}
passes() {
    said=$("$tree/tools/check_mutants.sh" "$tree" 2>&1) || fail "check_mutants.sh refuses: $said"
}

# Rows that fit, whatever the layout, and rows that do not.
good=$(row sum 'x+=1;' 'x -= 1;')
rows "$(row limit 'if (x > most) { x = most;}' '')" "$good" > "$table"
passes
rows "$(row sum 'x += 3;' 'x -= 1;')" > "$table"
refuses 'core.json: sum: not found in src/core/one.c: x += 3;' --check
refuses 'core.json: sum: not found in src/core/one.c: x += 3;' sum
rows "$(row sum 'one(int x)' 'one(int y)')" > "$table"
refuses 'core.json: sum: found twice in src/core/one.c: one(int x)' --check
refuses 'core.json: sum: found twice in src/core/one.c: one(int x)'
rows "$(row sum 'int' 'long')" > "$table"
refuses 'sum: found 5 times' --check
rows "$(row sum 'mos' 'least')" > "$table"
refuses 'sum: not found' --check
rows "$(row sum 'x += 1;' 'x+=1;')" > "$table"
refuses 'sum: old and new are the same: x += 1;' --check
rows "$(row sum 'x += 1;' '' '' src/core/two.c)" > "$table"
refuses 'sum: no file src/core/two.c' --check

# Rows that a build with warnings as errors would refuse.
cmake -S "$tree" -B "$tree/build/release" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_C_FLAGS=-Wall > /dev/null || fail cmake
rows "$good" > "$table"
said=$("$tree/tools/mutants.sh" --compile "$tree/build/release" 2>&1) || fail "mutants.sh --compile refuses: $said"
rows "$(row limit 'if (x > most) { x = most;}' '')" "$good" > "$table"
refuses 'core.json: limit: does not compile: src/core/one.c:5:15: error: unused variable' --compile "$tree/build/release"
rows "$(row sum 'x += 1;' 'x += ;')" > "$table"
refuses 'core.json: sum: does not compile: src/core/one.c:9' --compile "$tree/build/release"
rm -r "$tree/build"
rows "$(row sum 'x += 1;' '' '' src/../../one.c)" > "$table"
refuses 'sum: no file src/../../one.c' --check
rows "$(row sum '' 'x')" > "$table"
refuses 'sum: an empty text' --check
rows "$(row sum 'x += 1;' '' '(')" > "$table"
refuses 'sum: caught_by is no regular expression' --check
rows "$good" | sed '/caught_by/d; s/\("new".*\),$/\1/' > "$table"
refuses 'sum: has file, name, new, old, what; should have caught_by, file, name, new, old, what' --check
rows "$good" "$good" > "$table"
refuses 'core.json: sum: the name is there twice' --check
echo '[' > "$table"
refuses 'core.json: no JSON' --check
rows "$(row blind 'x += 1;' 'x -= 1;' '^unit/core/two$')" > "$table"
refuses 'core.json: blind: no test matches ^unit/core/two$' blind
refuses 'no row matches "bland"' bland
changes='"changes": [
            {
                "file": "src/core/one.c",
                "old": "x += 1;",
                "new": "x += 2;"
            },
            {
                "file": "src/core/one.c",
                "old": "%s",
                "new": ""
            }
        ],'
# shellcheck disable=SC2059
two() { printf '    {\n        "name": "two",\n        "what": "so",\n        %s\n        "caught_by": "^unit/core/one$"\n    }' "$(printf "$changes" "$1")"; }
rows "$(two 'x = most;')" > "$table"
passes
rows "$(two '+= 1; \/')" > "$table"
refuses 'two: two changes of one place' --check

# Tables that are not in order, and tidied.
rows "$good" "$(row limit 'most = 9' 'most = 0')" "$(row other 'return 0' 'return 1' '^unit/io/' src/io/blind.c)" > "$table"
refused=$("$tree/tools/mutants.sh" --check 2>&1) && fail "mutants.sh --check lets a table through that is not in order"
case $refused in *'core.json: not in order'*'io.json: not in order'*) ;; *) fail "of order mutants.sh says $refused" ;; esac
"$tree/tools/mutants.sh" --tidy || fail "mutants.sh --tidy"
passes
[ "$(cd "$tree/tests/mutants" && grep -c name ./*.json | tr '\n' ' ')" = './core.json:2 ./io.json:1 ' ] || fail "tidied tables"
rm "$tree/tests/mutants/io.json"

# What becomes of mutants, in a copy and in place.
verdicts() { # verdicts WHERE: of sum, nothing, broken
    said=$("$tree/tools/mutants.sh" 2>&1) && fail "$1: mutants.sh succeeds where mutants survive"
    for verdict in 'broken  *DOES NOT BUILD so' 'nothing  *SURVIVED   so' 'sum  *caught     so' '3 mutants tried, 2 not caught'; do
        printf '%s\n' "$said" | grep -qx -- "$verdict" || fail "$1: mutants.sh says \"$said\", expected \"$verdict\""
    done
}
rows "$(row broken 'return x;' 'return y;')" "$(row nothing 'x += 1;' 'x -= 1;' '^unit/io/blind$')" "$good" > "$table"
verdicts copy
diff -r "$tree/src" "$tree/build/mutants/tree/src" || fail "the copy is not mended"
cp -r "$tree/build/mutants/tree" "$tree/place"
cmake -S "$tree/place" -B "$tree/place/build/release" -G Ninja > /dev/null || fail cmake
export MUTANTS_TREE="$tree/place"
verdicts place
diff -r "$tree/src" "$tree/place/src" || fail "the tree is not mended"
said=$("$tree/tools/mutants.sh" sum) || fail "mutants.sh sum says $said"
case $said in *'1 mutants tried, 0 not caught') ;; *) fail "mutants.sh sum says $said" ;; esac
said=$(MUTANTS_COUNT=2 "$tree/tools/mutants.sh") && fail "two of three are caught where one is"
case $said in *'2 mutants tried, '[12]' not caught') ;; *) fail "of two mutants mutants.sh says $said" ;; esac
unset MUTANTS_TREE
rm -r "$tree/place"

# Where tests fail before anything is broken they catch nothing.
sed -i 's/!= 2/!= 3/' "$tree/src/core/check.c"
said=$("$tree/tools/mutants.sh" sum) && fail "mutants.sh trusts a test that fails anyway"
case $said in *'unit/core/one'*'sum  '*'UNKNOWN    its tests fail on the unbroken tree'*) ;; *) fail "of such a test: $said" ;; esac
(cd "$tree" && git checkout -q src) || fail "git checkout"

# Made from a change.
rm "$table"
makes() { # makes NAME OLD NEW: of the change in src/core/one.c
    (cd "$tree" && tools/new_mutant.py "$1" '^unit/core/one$' so > made) || fail "new_mutant.py $1"
    diff -r "$tree.clean/src" "$tree/src" || fail "new_mutant.py $1 leaves the change"
    row "$1" "$2" "$3" > "$tree/expected"
    grep -qx 'tests/mutants/core.json' "$tree/made" || fail "new_mutant.py says $(cat "$tree/made")"
    sed -n '/^    {/,/^    }/p' "$table" | sed 's/^    },$/    }/' | grep -F -A 5 "\"$1\"" > "$tree/row"
    sed '1d; $d' "$tree/expected" | diff - "$tree/row" || fail "new_mutant.py $1"
    passes
}
sed -i 's/    x += 1;/    x += 3;/' "$tree/src/core/one.c"
makes third 'x += 1;' 'x += 3;'
sed -i '/x = most/d' "$tree/src/core/one.c"
makes second 'x = most;' ''
sed -i '/return x;/i\    x =\n        (\n        x);' "$tree/src/core/one.c"
makes first 'return x;' 'x = (x); return x;'
[ "$(sed -n 's/.*"name": "\(.*\)".*/\1/p' "$table" | tr '\n' ' ')" = 'first second third ' ] || fail "the order of $(cat "$table")"
sed -i 's/most = 9/most = 8/; s/return x/return x - 1/' "$tree/src/core/one.c"
(cd "$tree" && tools/new_mutant.py both '^unit/core/one$' so > made) || fail "new_mutant.py both"
for line in '"old": "const int most = 9;",' '"new": "const int most = 8;"' '"old": "return x;",' '"new": "return x - 1;"'; do
    sed -n '/"both"/,/caught_by/p' "$table" | grep -qxF "                $line" || fail "new_mutant.py both lacks $line"
done
passes
sed -i 's/    x += 1;/    x += 3;/' "$tree/src/core/one.c"
"$tree/tools/new_mutant.py" third '^unit/core/one$' so > /dev/null 2>&1 && fail "new_mutant.py takes a name twice"
grep -q 'x += 3' "$tree/src/core/one.c" || fail "new_mutant.py undoes a change that it did not keep"

echo "$failures failures"
[ "$failures" -eq 0 ]
