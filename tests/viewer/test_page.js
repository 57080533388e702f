/* test_page.js TAUT FOLDER [PICTURES] -- the pages of `taut view` in Chromium: they load without a complaint and without
 * asking for any other address, something is drawn, every control and key acts, they work at the width of a phone, and
 * names that are markup stay text. With PICTURES, every state is written there as PNG, to be looked at. */
'use strict';
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { Browser, Page, decode, inked, differs } = require('./browser.js');

const [taut, folder, pictures] = process.argv.slice(2);
let failures = 0;

function check(holds, what) {
    if (!holds) {
        failures++;
        console.log('FAILED: ' + what);
    }
}

function makePage(name, model, ...words) {
    const file = path.join(folder, name + '.json');
    const page = path.join(folder, name + '.html');
    fs.writeFileSync(file, JSON.stringify(model));
    execFileSync(taut, ['view', file, '-o', page, ...words]);
    return page;
}

/* A saddle over [-1, 1]^2, its middle at a height: K < 0 everywhere, H not the same everywhere. */
function saddle(name, height) {
    const basis = { type: 'bezier', degree: 2 };
    return { name, u: basis, v: basis,
        points: [[[-1, -1, 0.2], [-1, 0, 1], [-1, 1, 0]], [[0, -1, -1], [0, 0, height], [0, 1, -1]], [[1, -1, 0], [1, 0, 1], [1, 1, 0]]] };
}

function snap(image, name) {
    if (pictures) {
        fs.writeFileSync(path.join(pictures, name + '.png'), image);
    }
    return decode(image);
}

/* act() must change what is seen of the canvas, by at least a few pixels. */
async function mustChange(page, name, act) {
    const before = page.seen || decode(await page.picture('#stage'));
    await act();
    const after = snap(await page.picture('#stage'), name);
    page.seen = after; /* nothing else changes it */
    check(differs(before, after) > 0.0005, name + ' changes the picture (' + differs(before, after) + ')');
    return after;
}

function quiet(page, what) {
    check(page.complaints.length === 0, what + ' complains: ' + page.complaints.join('; '));
    check(page.requests.every((url) => url.startsWith('file:') || url.startsWith('data:')) &&
        page.requests.filter((url) => url.startsWith('file:')).length === 1, what + ' asks for ' + page.requests.join(' '));
}

const drawn = 'document.getElementById("canvas").dataset.drawn > 0';

async function testControls(browser) {
    const hostile = '</script><script>window.broken = 1</script><img src=x onerror="window.broken = 2">';
    const model = { taut: 1, surfaces: [saddle(hostile, 0.5)],
        curves: [{ name: '<!-- </b>', t: { type: 'bezier', degree: 1 }, points: [[-1, -1, 1], [1, 1, 1.5]] }],
        details: { '<b>': hostile, note: '<!--' },
        certificate: { construct: hostile, holds: false, claims: [{ claim: hostile, residual: 2.5, limit: 1, holds: false, where: hostile }], figures: { area: 4.5 } } };
    const page = await Page.open(browser, makePage('one', model, '--title', hostile), 800, 420);
    await page.until(drawn);
    check(await page.evaluate('window.broken === undefined && document.querySelectorAll("aside b, aside img, aside script").length === 0'), 'markup in a name is markup');
    check((await page.evaluate('document.querySelector("h1").textContent')) === hostile, 'the title is not the text that was given');
    check((await page.evaluate('document.body.innerText')).includes('not all claims hold'), 'the certificate says that it does not hold');
    check(inked(snap(await page.picture('#stage'), 'plain')) > 0.05, 'the picture is blank');

    /* What is seen in the very frame in which the canvas gets another size. */
    await page.evaluate(`(() => {
        const stage = document.getElementById('stage');
        let times = 0;
        const watch = new ResizeObserver(() => {
            if (times++ > 0) {
                const small = document.createElement('canvas');
                small.width = small.height = 64;
                const ink = small.getContext('2d');
                ink.drawImage(document.getElementById('canvas'), 0, 0, 64, 64);
                const seen = ink.getImageData(0, 0, 64, 64).data;
                window.inked = seen.filter((value, i) => i % 4 === 0 && value < 200 && seen[i + 3] > 0).length;
                watch.disconnect();
                stage.style.width = '';
            } else {
                requestAnimationFrame(() => { stage.style.width = stage.clientWidth - 40 + 'px'; });
            }
        });
        watch.observe(stage);
    })()`);
    await page.until('window.inked !== undefined');
    check(await page.evaluate('window.inked > 100'), 'the picture is gone for a frame when its size changes');

    for (const colour of ['H', 'K', 'I', 'plain']) {
        await mustChange(page, 'colour-' + colour, () => page.click('[name=colour][value=' + colour + ']'));
        check(await page.evaluate('document.getElementById("legend").hidden') === (colour === 'plain'), 'legend at ' + colour);
    }
    for (const id of ['net', 'reflections', 'isolines', 'panels']) {
        await mustChange(page, id, () => page.click('#' + id));
    }
    check((await page.evaluate('document.getElementById("panel-note").textContent')).includes('%'), 'flatness of the panels is said');
    await mustChange(page, 'panel-count', () => page.evaluate('(() => { const r = document.getElementById("panel-count"); r.value = 5; r.dispatchEvent(new Event("input")); })()'));
    for (const id of ['panels', 'isolines', 'reflections', 'net']) {
        await mustChange(page, id + '-back', () => page.click('#' + id));
    }
    await mustChange(page, 'part-off', () => page.click('#list input'));
    await mustChange(page, 'part-on', () => page.click('#list input'));
    await mustChange(page, 'drag', async () => {
        await page.mouse('mousePressed', 250, 200);
        await page.mouse('mouseMoved', 330, 220, { buttons: 1 });
        await page.mouse('mouseReleased', 330, 220);
    });
    await mustChange(page, 'wheel', () => page.send('Input.dispatchMouseEvent', { type: 'mouseWheel', x: 250, y: 200, deltaX: 0, deltaY: -240 }));
    const home = await mustChange(page, 'home', () => page.click('#home'));
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('0'); /* the first key shows the ring of focus */
    page.seen = null;
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '-', 'ArrowDown', 'ArrowRight', 'n', 'c', 'r', 'l', 'p']) {
        await mustChange(page, 'key-' + key, () => page.key(key));
    }
    for (const key of ['p', 'l', 'r', 'n', 'c', 'c', 'c', '0']) {
        await page.key(key);
    }
    await page.evaluate('document.activeElement.blur()');
    check(differs(home, decode(await page.picture('#stage'))) < 0.0005, 'undoing everything does not come back');
    check(await page.evaluate(`[...document.querySelectorAll('input, button, canvas, [role=img]')].every((e) =>
        e.labels && e.labels.length > 0 || e.getAttribute('aria-label') || e.textContent.trim() || e.closest('[hidden]'))`), 'something has no name');
    quiet(page, 'one surface');
    await page.close();
}

async function testFrames(browser) {
    const model = { taut: 1, surfaces: [0, 1, 2, 3, 4].map((k) => saddle('frame ' + k, k / 2 - 1)), details: { frames: 5 } };
    const page = await Page.open(browser, makePage('frames', model), 800, 420);
    await page.until(drawn);
    check(await page.evaluate('!document.getElementById("frames").hidden && document.querySelector("[value=frames]").checked'), 'frames are not shown as such');
    await mustChange(page, 'frame-last', () => page.evaluate('(() => { const r = document.getElementById("frame"); r.value = 4; r.dispatchEvent(new Event("input")); })()'));
    check((await page.evaluate('document.getElementById("frame-name").textContent')).includes('5 / 5 frame 4'), 'the frame is named');
    await page.evaluate('document.getElementById("canvas").focus()');
    await mustChange(page, 'frame-back', async () => { await page.key(','); await page.key(','); });
    await page.click('#play');
    const start = await page.evaluate('document.getElementById("frame").value');
    await page.until('document.getElementById("frame").value !== "' + start + '"');
    await page.click('#play');
    page.seen = null;
    await mustChange(page, 'apart', () => page.click('[value=apart]'));
    await mustChange(page, 'together', () => page.click('[value=together]'));
    quiet(page, 'frames');
    await page.close();
}

/* A film that carries the witness of its least area shows where it is how far from it; others do not offer that. */
async function testGap(browser) {
    const film = path.join(folder, 'film.json');
    execFileSync(taut, ['make', path.join(__dirname, '../../examples/plateau-bicubic.json'), '-o', film, '--quiet']);
    const page = await Page.open(browser, makePage('film', JSON.parse(fs.readFileSync(film, 'utf8'))), 800, 420);
    await page.until(drawn);
    check(await page.evaluate('!document.getElementById("gap-choice").hidden'), 'a film with a witness has no gap to colour by');
    await mustChange(page, 'gap', () => page.click('[name=colour][value=G]'));
    check((await page.evaluate('document.getElementById("legend-title").textContent')).includes('Gap'), 'the scale of the gap has no name');
    check((await page.evaluate('document.querySelector("#claims tbody").textContent')).includes('bound'), 'the kinds of claims are not shown');
    quiet(page, 'the film');
    await page.close();
    const plain = await Page.open(browser, path.join(folder, 'frames.html'), 800, 420);
    await plain.until(drawn);
    check(await plain.evaluate('document.getElementById("gap-choice").hidden'), 'a gap is offered where there is none');
    await plain.close();
}

async function testPhone(browser) {
    const page = await Page.open(browser, path.join(folder, 'frames.html'), 390, 800);
    await page.until(drawn);
    check(await page.evaluate('document.documentElement.scrollWidth <= 390'), 'a phone must scroll sideways');
    check(inked(snap(await page.picture(), 'phone')) > 0.05, 'a phone sees nothing');
    await page.click('[value=K]');
    check(await page.evaluate('[...document.querySelectorAll("label, button")].filter((e) => e.offsetHeight > 0).every((e) => e.getBoundingClientRect().height >= 24)'), 'something is too small for a finger');
    snap(await page.picture(), 'phone-scrolled');
    quiet(page, 'the phone');
    await page.close();
}

/* Where a model is too large for a page it is thinned, and the page says so. */
async function testLarge(browser) {
    const n = 100;
    const basis = { type: 'bspline', degree: 3, count: n };
    const surfaces = Array.from({ length: 20 }, (_, f) => ({ name: 'f' + f, u: basis, v: basis,
        points: Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => [i, j, Math.round(100 * Math.sin(i / 16 + f / 3) * Math.cos(j / 20)) / 10])) }));
    const page = await Page.open(browser, makePage('large', { taut: 1, surfaces }, '--frames'), 800, 420);
    await page.until(drawn);
    check((await page.evaluate('document.getElementById("dropped").textContent')).includes('one point in'), 'what is dropped is not said');
    await mustChange(page, 'large-frame', () => page.evaluate('(() => { const r = document.getElementById("frame"); r.value = 9; r.dispatchEvent(new Event("input")); })()'));
    quiet(page, 'the large model');
    await page.close();
}

/* A net that reaches far beyond its surface is left out, said, and frames nothing: the surface fills the picture as it does
 * with a net that is near. */
async function testFarNet(browser) {
    const basis = { type: 'bezier', degree: 2 };
    const points = [-1, 0, 1].map((x) => [-1, 0, 1].map((y) => [x, y, x === 0 && y === 0 ? 1e6 : 0]));
    const weights = [[1, 1, 1], [1, 1e-9, 1], [1, 1, 1]];
    const page = await Page.open(browser, makePage('far', { taut: 1, surfaces: [{ name: 'far', u: basis, v: basis, points, weights }] }), 800, 420);
    await page.until(drawn);
    check((await page.evaluate('document.getElementById("dropped").textContent')).includes('1 of 1 control nets left out'), 'a net far away is not said to be left out');
    check(inked(snap(await page.picture('#stage'), 'far-net')) > 0.2, 'a net far away makes the surface small');
    await page.click('#net');
    quiet(page, 'a net far away');
    await page.close();
}

async function main() {
    const browser = new Browser(process.env.CHROMIUM || 'chromium');
    try {
        await testControls(browser);
        await testFrames(browser);
        await testGap(browser);
        await testPhone(browser);
        await testLarge(browser);
        await testFarNet(browser);
    } finally {
        await browser.close();
    }
    console.log(failures + ' failures');
    process.exit(failures > 0 ? 1 : 0);
}

main().catch((fault) => {
    console.log(fault);
    process.exit(1);
});
