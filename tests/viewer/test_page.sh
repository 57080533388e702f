# test_page.sh -- test_page.js where node and chromium are; without them there is nothing to look with, and that is said.
set -u
for tool in node "${CHROMIUM:=chromium}"; do
    if ! command -v "$tool" > /dev/null; then
        echo "there is no $tool here: tools/deps.sh test brings it"
        exit 77
    fi
done
export CHROMIUM
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node "$SOURCE/tests/viewer/test_page.js" "$TAUT" "$work" ${PICTURES:+"$PICTURES"}
