# cli.sh -- what the command line tests share. TAUT is the program, SOURCE the source tree.
set -u
failures=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export PYTHONDONTWRITEBYTECODE=1 # into the source tree

complain() {
    printf '%s\n' "FAILED: $*" >&2
    failures=$((failures + 1))
}

# run CODE WORDS...: runs taut, keeps out.txt and err.txt, checks the exit code.
run() {
    expected=$1
    shift
    "$TAUT" "$@" > out.txt 2> err.txt
    code=$?
    [ "$code" = "$expected" ] || complain "taut $*: exit $code, expected $expected: $(cat err.txt)"
}

# refused CODE PATTERN [COMMAND WORDS...]: with --json, the exit code, nothing on standard output, and on standard error
# one line, the error with its six members, of which "REASON WHERE found FOUND expected EXPECTED" begins with words that
# match (WHERE is left out where it is empty). What the sentence alone says, such as the name of a file, is checked
# afterwards with `contains err.txt`: there its quotes are written \".
refused() {
    expected=$1
    pattern=$2
    shift 2
    if [ $# -gt 0 ]; then
        verb=$1
        shift
        set -- "$verb" --json "$@"
    else
        set -- --json
    fi
    run "$expected" "$@"
    told=$(sed -nE '
        s/^\{ "error": \{ "exit": '"$expected"', "reason": "([a-z0-9-]+)", "where": "(([^"\\]|\\.)*)", "message": "(([^"\\]|\\.)+)", "found": (null|-?[0-9][-+.e0-9]*), "expected": (.*) \} \}$/\1 \2 found \6 expected \7/
        t tell
        s/.*/no error of these members/
        : tell
        s/^([^ ]*)  /\1 /
        s/ expected "(.*)"$/ expected \1/
        p' err.txt)
    printf '%s\n' "$told" | grep -qE -- "^($pattern)( |\$)" || complain "taut $*: told '$told', expected $pattern: $(cat err.txt)"
    [ "$(wc -l < err.txt)" = 1 ] || complain "taut $*: not one line on standard error: $(cat err.txt)"
    [ ! -s out.txt ] || complain "taut $*: wrote to standard output"
}

# absent FILE...: no such files, nor anything half written beside them.
absent() {
    for file in "$@"; do
        [ ! -e "$file" ] || complain "$file is there"
    done
    left=$(find . -name '.*' -type f | head -n 1)
    [ -z "$left" ] || complain "left behind: $left"
}

# missing WHAT HOW: a part of the test cannot be made, and how to get what it needs; where all must be there
# (TAUT_REQUIRE=all) that is a failure. `make test` ends with these lines.
missing() {
    if [ "${TAUT_REQUIRE:-}" = all ]; then
        complain "$1 is not here: $2"
    else
        echo "left out: $1 is not here: $2"
    fi
}

# skip WHAT HOW: the same, and there is nothing else to test; ctest reports it as skipped.
skip() {
    missing "$1" "$2"
    [ "$failures" = 0 ] || exit 1
    exit 77
}

# python_with MODULE: the PYTHON that has it; fails where none has.
python_with() {
    for PYTHON in python3 /usr/bin/python3; do
        if "$PYTHON" -c "import $1" 2> /dev/null; then
            return 0
        fi
    done
    return 1
}

contains() {
    grep -qE -- "$2" "$1" || complain "$1 has no line like $2"
}

finish() {
    [ "$failures" = 0 ] || exit 1
    exit 0
}
