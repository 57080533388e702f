#!/bin/sh
# check_abi.sh [ROOT] -- the table behind taut_abi() names every public struct, member and constant (tools/abi.py), and
# docs/bindings.md every public function (tools/bindings_list.py, without ROOT).
set -eu
python3 "$(dirname "$0")/abi.py" "${1:-$(dirname "$0")/..}"
[ $# -gt 0 ] || python3 "$(dirname "$0")/bindings_list.py"
