# tools.sh -- what the tests of tools/ share. SOURCE is the source tree; tree an empty folder.
set -u
: "${SOURCE:?the source tree}"
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

fail() {
    echo "FAIL: $*"
    failures=$((failures + 1))
}

finish() {
    echo "$failures failures"
    [ "$failures" -eq 0 ]
    exit
}
