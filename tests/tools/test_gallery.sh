# test_gallery.sh -- every construction with an example is in docs/gallery/README.md, whose pictures are there, and the
# bundle of three.js is the one that was made.
. "$SOURCE/tests/tools/tools.sh"
cd "$SOURCE" || exit 1
index=docs/gallery/README.md
for construct in $(sed -n 's/.*X([a-z_0-9]*, "\([a-z-]*\)".*/\1/p' src/problem/construct_list.h); do
    if grep -qs "\"construct\": *\"$construct\"" examples/*.json; then
        grep -qx "## $construct" $index || fail "$construct is not in $index: make gallery"
    fi
done
for picture in $(grep -o '([a-z0-9-]*\.png)' $index | tr -d '()'); do
    [ -s "docs/gallery/$picture" ] || fail "docs/gallery/$picture is not there"
done
(cd src/page/viewer/three && sha256sum --check --quiet SHA256SUMS) || fail "three.min.js is not what bundle.sh made"
finish
