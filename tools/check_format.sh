#!/bin/sh
# check_format.sh [--fix] -- every C and C++ file is as clang-format 14 writes it.
set -eu
cd "$(dirname "$0")/.."
tool=$(command -v clang-format-14 || command -v clang-format || true)
case $("${tool:-false}" --version 2>/dev/null) in
*'version 14.'*) ;;
*)
    echo "check_format: clang-format 14 is needed (tools/deps.sh check)" >&2
    exit 1
    ;;
esac
if [ "${1:-}" = --fix ]; then
    set -- -i
else
    set -- --dry-run -Werror
fi
git ls-files -z --cached --others --exclude-standard -- '*.c' '*.h' '*.cpp' '*.hpp' |
    xargs -0 sh -c 'for f; do [ -e "$f" ] && printf "%s\\0" "$f"; done' sh | xargs -0 "$tool" "$@"
