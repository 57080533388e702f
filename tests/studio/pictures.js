/* pictures.js TAUT FOLDER [NAME...] -- the pictures of the studio in docs/gallery, to be looked at before they are kept: all, or those named. */
'use strict';
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { Browser, Page } = require('../viewer/browser.js');

const [taut, folder, ...only] = process.argv.slice(2);
const act = (name) => `[...document.querySelectorAll('details.menu button')].find((b) => b.textContent.startsWith('${name}')).click()`;
const off = 'document.getElementById("net").click()';

const pictures = [
    { name: 'studio', example: 'film-sail' },
    { name: 'studio-dark', example: 'dirichlet-tent', dark: true, then: [act('Colour by H'), act('Height lines')] },
    { name: 'studio-phone', example: 'film-sail-length', width: 390, height: 844 },
    { name: 'studio-error', example: 'film-sail', then: ['taut.set("/edges/u0/cable/force", 0.2).catch(() => 0)'] },
    { name: 'studio-pipe', example: 'pipe-g2', then: [off, act('Colour by K')] },
    { name: 'studio-lines', example: 'plateau-scherk', then: [off, act('Reflection lines')] }
];

async function draw(file, { name, width = 1280, height = 860, dark = false, then = [] }) {
    const browser = new Browser(process.env.CHROMIUM || 'chromium');
    const page = await Page.open(browser, file, width, height, dark ? [{ name: 'prefers-color-scheme', value: 'dark' }] : []);
    await page.evaluate('taut.ready.then(() => true)');
    await page.until('document.getElementById("proof").dataset.state !== "draft"');
    for (const step of then) {
        await page.evaluate(step);
        await page.settled();
    }
    await page.evaluate('taut.model().then(() => true)'); /* after what was asked for */
    fs.writeFileSync(path.join(folder, name + '.png'), await page.picture());
    await browser.close();
}

(async () => {
    const work = fs.mkdtempSync(path.join(os.tmpdir(), 'taut-pictures-'));
    for (const picture of pictures.filter(({ name }) => only.length === 0 || only.includes(name))) {
        const file = path.join(work, picture.name + '.html');
        execFileSync(taut, ['studio', picture.example, '-o', file]);
        await draw(file, picture);
    }
    fs.rmSync(work, { recursive: true });
})();
