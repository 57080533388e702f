# test_site.sh -- the site is built, all its links lead somewhere, and test_site.js looks at every page.
. "$SOURCE/tests/cli/cli.sh"
command -v mkdocs > /dev/null || skip mkdocs 'tools/deps.sh site'
for tool in node "${CHROMIUM:=chromium}"; do
    command -v "$tool" > /dev/null || skip "$tool" 'tools/deps.sh browser'
done
export CHROMIUM
if "$SOURCE/tools/site.py" "$work/site" > built.txt 2>&1; then
    node "$SOURCE/tests/site/test_site.js" "$work/site" ${PICTURES:+"$PICTURES"} || complain "the pages of the site"
else
    complain "the site: $(cat built.txt)"
fi
finish
