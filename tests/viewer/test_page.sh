# test_page.sh -- test_page.js where node and chromium are.
. "$SOURCE/tests/cli/cli.sh"
for tool in node "${CHROMIUM:=chromium}"; do
    command -v "$tool" > /dev/null || skip "$tool" 'tools/deps.sh browser'
done
export CHROMIUM
# axe-core judges accessibility: in AXE, beside the validator of glTF, or as npm has it.
for file in "${AXE:-}" "${TAUT_GLTF:-}/node_modules/axe-core/axe.min.js" /usr/share/nodejs/axe-core/axe.min.js "$(npm root -g 2> /dev/null)/axe-core/axe.min.js"; do
    [ -f "$file" ] && break
    file=-
done
[ "$file" != - ] || missing axe-core 'npm install --global axe-core@4'
node "$SOURCE/tests/viewer/test_page.js" "$TAUT" "$work" "$file" ${PICTURES:+"$PICTURES"} || complain "the pages of taut view"
finish
