# test_studio.sh -- the studio: what its command says, its parts under node, its page in Chromium.
. "$SOURCE/tests/cli/cli.sh"
[ -f "$STUDIO" ] || skip 'the page of the studio' 'tools/deps.sh wasm, and build anew'
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

run 2 studio
run 2 studio -o page.htm
run 2 studio no-such-example -o page.html
[ ! -e page.html ] || complain 'a page was written for no problem'
echo '{ "taut": 1, "construct": "dirichlet" }' > wrong.json
run 3 studio wrong.json -o page.html
[ ! -e page.html ] || complain 'a page was written for a wrong problem'
"$TAUT" example plateau-scherk > own.json
sed 's/"construct"/"name": "<\/script>", "construct"/' own.json > markup.json
run 0 studio markup.json -o page.html
! grep -q '"name": "</script>"' page.html || complain 'markup in a name stands in the page'

node --test "$SOURCE/tests/studio/test_parts.mjs" > parts.txt 2>&1 || complain "$(cat parts.txt)"
if command -v tsc > /dev/null; then
    tsc --noEmit --checkJs --allowJs --strict --target es2022 --module es2022 --moduleResolution node --lib es2022,dom,dom.iterable \
        "$SOURCE/studio/globals.d.ts" "$SOURCE/studio/main.js" > types.txt 2>&1 || complain "$(cat types.txt)"
fi
node "$SOURCE/tests/studio/test_studio.js" "$TAUT" "$work" "$file" ${PICTURES:+"$PICTURES"} || complain 'the page of the studio'
finish
