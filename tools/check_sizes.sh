#!/bin/sh
# check_sizes.sh [ROOT] -- a source file over 500 lines is split, or says in its first ten lines why it is "long because".
set -eu
cd "${1:-$(dirname "$0")/..}"
bad=0
list=$(find . -name build -prune -o -name out -prune -o -name node_modules -prune -o -name .git -prune -o \
    -type f \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.js' -o -name '*.sh' -o -name '*.cmake' \
    -o -name '*.py' \) -print | sort)
for file in $list; do
    lines=$(wc -l < "$file")
    if [ "$lines" -gt 500 ] && ! head -n 10 "$file" | grep -qi 'long because'; then
        echo "$file: $lines lines: split it, or say in its first lines what it is long because of"
        bad=1
    fi
done
exit $bad
