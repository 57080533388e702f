#!/bin/sh
# find_prefix.sh PREFIX -- the lines by which a shell finds what make install put in a folder of one's own.
set -eu
[ -z "${DESTDIR:-}" ] || exit 0 # a package: others find it where it is put later
prefix=$(cd "$1" && pwd)
config=$(find "$prefix" -name taut.pc | head -n 1)
package=$(dirname "$config")
cat << EOF
In a shell that uses it:
  export PATH="$prefix/bin:\$PATH"
  export PKG_CONFIG_PATH="$package"
  export LD_LIBRARY_PATH="$(dirname "$package")"
EOF
