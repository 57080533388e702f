#!/bin/sh
# bundle.sh WASM VERSION PAGE -- the page of the studio, one file: scripts by esbuild, the library, three.js, the examples, the schema and what helps against errors
# as gzip in base64. @problem@ is left in it, for `taut studio`.
set -eu
wasm=$1 version=$2 page=$3
here=$(cd "$(dirname "$0")" && pwd)
root=$here/..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

esbuild "$here/worker.js" --bundle --minify --format=iife --target=es2021 --log-level=warning --outfile="$work/worker.js"
esbuild "$here/main.js" --bundle --minify --format=iife --target=es2021 --charset=utf8 --log-level=warning \
    "--define:VERSION=\"$version\"" --outfile="$work/main.js"

# Every example by its name, as one JSON object.
{
    printf '{'
    comma=
    for file in "$root"/examples/*.json; do
        printf '%s"%s":' "$comma" "$(basename "$file" .json)"
        cat "$file"
        comma=,
    done
    printf '}'
} > "$work/examples"
cp "$wasm" "$work/wasm"
awk -f "$here/reasons.awk" "$root"/include/taut/*.h > "$work/reasons"
cp "$root/docs/schema/problem.json" "$work/schema"
cp "$root/src/page/viewer/three/three.min.js" "$work/three"
mv "$work/worker.js" "$work/worker"

part() {
    printf '<script type="text/plain" id="part-%s">' "$1"
    gzip -9nc "$work/$1" | base64 -w 0
    printf '</script>\n'
}
{
    sed '/@style@/,$d' "$here/page.html"
    cat "$here/style.css"
    sed '1,/@style@/d; /@parts@/,$d' "$here/page.html"
    for name in wasm three worker examples schema reasons; do
        part $name
    done
    sed '1,/@parts@/d; /@script@/,$d' "$here/page.html"
    cat "$work/main.js"
    sed '1,/@script@/d' "$here/page.html"
} > "$page.new"
mv "$page.new" "$page"
