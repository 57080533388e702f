/* test_site.js SITE [PICTURES] -- every page of the site in Chromium, from the disk, at the widths of a desk and of a phone:
 * it loads without a complaint, asks for no other address, has a heading, all its pictures, and is no wider than the
 * window; the search finds. With PICTURES, what is seen is written there as PNG. */
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const { Browser, Page } = require('../viewer/browser.js');

const [site, pictures] = process.argv.slice(2);
let failures = 0;

function check(holds, what) {
    if (!holds) {
        failures++;
        console.log('FAILED: ' + what);
    }
}

function pagesBelow(folder) {
    return fs.readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
        const file = path.join(folder, entry.name);
        return entry.isDirectory() ? pagesBelow(file) : /\.html$/.test(file) && !/(404|studio-page)\.html$/.test(file) ? [file] : [];
    });
}

async function look(page, file) {
    page.complaints.length = page.requests.length = 0;
    const name = path.relative(site, file);
    const url = 'file://' + path.resolve(file);
    await page.send('Page.navigate', { url });
    await page.until(`location.href === ${JSON.stringify(url)} && document.readyState === "complete"`);
    for (const [width, height] of [[1280, 900], [390, 800]]) {
        await page.resize(width, height);
        await page.settled();
        const seen = await page.evaluate(`(() => ({ headings: document.querySelectorAll('h1').length,
            wide: document.documentElement.scrollWidth - innerWidth,
            lost: [...document.images].filter((i) => !i.complete || i.naturalWidth === 0).map((i) => i.src),
            words: document.body.innerText.length }))()`);
        check(seen.headings >= 1, name + ' has no heading');
        check(seen.wide <= 0, name + ' is ' + seen.wide + ' pixels wider than ' + width);
        check(seen.lost.length === 0, name + ' lacks ' + seen.lost.join(' '));
        check(seen.words > 60, name + ' is empty');
        if (pictures) {
            fs.writeFileSync(path.join(pictures, name.replace(/\W/g, '-') + '-' + width + '.png'), await page.picture());
        }
    }
    check(page.complaints.length === 0, name + ' complains: ' + page.complaints.join('; '));
    check(page.requests.every((asked) => /^(file|data):/.test(asked)), name + ' asks for ' + page.requests.join(' '));
}

async function search(page, words, wanted) {
    await page.evaluate(`(() => { const input = document.getElementById('words'); input.value = ${JSON.stringify(words)};
        input.dispatchEvent(new Event('input')); })()`);
    const hits = await page.evaluate("[...document.querySelectorAll('#found a')].map((a) => a.getAttribute('href'))");
    check(wanted === null ? hits.length === 0 : hits.slice(0, 5).includes(wanted), `search for "${words}" finds ${hits.slice(0, 5)}`);
}

(async () => {
    const browser = new Browser(process.env.CHROMIUM);
    const files = pagesBelow(site);
    check(files.length > 90, 'only ' + files.length + ' pages');
    const page = await Page.open(browser, files[0], 1280, 900);
    for (const file of files) {
        await look(page, file);
    }
    await look(page, path.join(site, 'search.html'));
    await search(page, 'cable-too-weak', 'film.html');
    await search(page, 'taut_surface_points', 'reference/surface.html');
    await search(page, 'planar curvature lines', 'bonnet.html');
    await search(page, 'xyzzy', null);
    await browser.close();
    console.log(files.length + ' pages, ' + failures + ' failures');
    process.exit(failures ? 1 : 0);
})();
