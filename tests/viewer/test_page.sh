# test_page.sh -- test_page.js where node and chromium are.
. "$SOURCE/tests/cli/cli.sh"
for tool in node "${CHROMIUM:=chromium}"; do
    command -v "$tool" > /dev/null || skip "$tool" 'tools/deps.sh browser'
done
export CHROMIUM
node "$SOURCE/tests/viewer/test_page.js" "$TAUT" "$work" ${PICTURES:+"$PICTURES"} || complain "the pages of taut view"
finish
