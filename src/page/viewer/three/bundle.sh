#!/bin/sh
# bundle.sh [--check] -- makes three.min.js and its licence anew from the npm packages that package-lock.json pins (npm
# checks their hashes), or, with --check, says whether that gives the files that are here. Needs node, npm and the network;
# the build of taut needs none of them, because what this makes is committed.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here/package.json" "$here/package-lock.json" "$here/entry.js" "$work"
cd "$work"
npm ci --silent --no-audit --no-fund > /dev/null
# One name, THREE; the licence travels in a comment.
npx --no-install esbuild entry.js --bundle --minify --format=iife --global-name=THREE --target=es2020 --charset=utf8 \
    --legal-comments=none --log-level=warning --outfile=body.js
version=$(sed -n 's/^ *"three": "\(.*\)".*/\1/p' package.json)
{
    printf '/* three.js %s, https://threejs.org, MIT licence, copyright 2010-2026 three.js authors; see three/LICENSE. Long because it is a bundle. */\n' "$version"
    cat body.js
} > three.min.js
cp node_modules/three/LICENSE LICENSE
sha256sum three.min.js LICENSE > SHA256SUMS
if [ "${1:-}" = --check ]; then
    cmp SHA256SUMS "$here/SHA256SUMS"
    (cd "$here" && sha256sum --check --quiet SHA256SUMS)
    echo "three.min.js is what three.js $version and esbuild make of entry.js"
else
    cp three.min.js LICENSE SHA256SUMS "$here"
    ls -l "$here/three.min.js"
fi
