#!/bin/sh
# left_out.sh [BUILD] -- what the last run of ctest left out, and how to get what it needs; nothing where nothing was.
set -eu
left=$(grep -a '^left out: ' "${1:-$(dirname "$0")/../build/release}/Testing/Temporary/LastTest.log" | sort -u)
[ -z "$left" ] || printf '%s\n' 'Not everything was tested:' "$left"
