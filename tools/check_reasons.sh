#!/bin/sh
# check_reasons.sh [ROOT] -- the reasons of errors are those of the lists, and each has its row (tools/check_reasons.py).
exec python3 "$(dirname "$0")/check_reasons.py" "${1:-$(dirname "$0")/..}"
