#!/bin/sh
# check_abi.sh [ROOT] -- the table behind taut_abi() names every public struct, member and constant (tools/abi.py).
exec python3 "$(dirname "$0")/abi.py" "${1:-$(dirname "$0")/..}"
