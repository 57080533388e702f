#!/bin/sh
# test_errors.sh -- errors as data: --json on every command.
exec python3 "$(dirname "$0")/errors.py" "${TAUT:?the program}" "${SOURCE:?the source tree}/examples"
