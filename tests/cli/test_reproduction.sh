# test_reproduction.sh -- every row of every paper comes out, and docs/reproduction.md is what the program says now.
set -eu
: "${TAUT:?the program}" "${SOURCE:?the source tree}"
"$SOURCE/tools/reproduction.sh" --check "$TAUT"
