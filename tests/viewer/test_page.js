/* test_page.js TAUT FOLDER AXE [PICTURES] -- the pages of `taut view` in Chromium: they load without a complaint and without
 * asking for any other address, something is drawn, every control and key acts, they work at the width of a phone, and
 * names that are markup stay text; a point that is picked is where the surface has it, by formulas; axe (the file of axe-core,
 * or -) finds nothing serious. With PICTURES, every state is written there as PNG, to be looked at. */
'use strict';
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { Browser, Page, decode, inked, differs } = require('./browser.js');
const { placeOf } = require('../../src/page/viewer/script/place.js');

const [taut, folder, axe, pictures] = process.argv.slice(2);
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

/* The page and the program have the same units of the same words. */
function testUnits() {
    const source = path.join(__dirname, '../..');
    const words = [...fs.readFileSync(path.join(source, 'src/cli/unit.c'), 'utf8').matchAll(/\{"(\w+)", (-?\d)\}/g)].map(([, word, power]) => word + ' ' + power);
    const table = /new Map\(Object\.entries\(\{([^]*?)\}\)/.exec(fs.readFileSync(path.join(source, 'src/page/viewer/script/certificate.js'), 'utf8'))[1];
    const said = [...table.matchAll(/'(-?\d)': ((?:'[^']*'[\s+]*)+)/g)].flatMap(([, power, text]) =>
        [...text.matchAll(/'([^']*)'/g)].map((part) => part[1]).join('').trim().split(' ').map((word) => word + ' ' + power));
    check(words.length > 30 && words.sort().join() === said.sort().join(), 'units of the page, ' + said + ', of the program, ' + words);
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
    check((await page.evaluate('document.getElementById("figures").innerText')).includes('4.5 mm²'), 'an area has no unit');
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
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '-', 'ArrowDown', 'ArrowRight', 'n', 'c', 'r', 'l', 'p', '1', '2', '3', '4', 'x', 'd']) {
        await mustChange(page, 'key-' + key, () => page.key(key));
    }
    for (const key of ['p', 'l', 'r', 'n', 'c', 'c', 'c', 'x', 'x', 'x', 'd', '0']) {
        await page.key(key);
    }
    await page.evaluate('document.activeElement.blur()');
    check(differs(home, decode(await page.picture('#stage'))) < 0.0005, 'undoing everything does not come back');
    check(await page.evaluate(`[...document.querySelectorAll('input, button, canvas, [role=img]')].every((e) =>
        e.labels && e.labels.length > 0 || e.getAttribute('aria-label') || e.textContent.trim() || e.closest('[hidden]'))`), 'something has no name');
    quiet(page, 'one surface');
    await page.close();
}

/* x = u, y = v, z = u v / 4 over [0, 2] x [0, 3], in metres; its normal, H and K at (u, v). */
const sheet = { name: 'sheet', u: { type: 'bspline', degree: 1, knots: [0, 0, 2, 2] }, v: { type: 'bspline', degree: 1, knots: [0, 0, 3, 3] },
    points: [[[0, 0, 0], [0, 3, 0]], [[2, 0, 0], [2, 3, 1.5]]] };
function sheetAt(u, v) {
    const size = Math.sqrt(1 + (u * u + v * v) / 16);
    return { x: u, y: v, z: u * v / 4, H: -u * v / 64 / size ** 3, K: -1 / 16 / size ** 4, normal: [-v / 4 / size, -u / 4 / size, 1 / size] };
}

const numberIn = (text) => Number(/[-−]?[\d.]+(e[-−]?\d+)?/.exec(text)[0].replaceAll('−', '-'));

/* What the box at the upper left says, by name. */
async function probed(page) {
    await page.settled();
    return page.evaluate(`document.getElementById('probe').hidden ? null : Object.fromEntries([...document.querySelectorAll('#probe dt')]
        .map((e) => [e.textContent, e.nextSibling.textContent]).concat([['name', document.getElementById('probe-name').textContent]]))`);
}

async function clickAt(page, x, y) {
    await page.mouse('mousePressed', x, y);
    await page.mouse('mouseReleased', x, y);
}

/* A point, by formulas; from point to point; the name under the pointer; the section; keys. */
async function testPicks(browser) {
    const line = { name: 'mast', t: { type: 'bezier', degree: 1 }, points: [[0, 0, 1], [2, 3, 3]] };
    const page = await Page.open(browser, makePage('sheet', { taut: 1, unit: 'm', surfaces: [sheet], curves: [line] }, '--view', '-60,50'), 1000, 600);
    await page.until(drawn);
    let before = null;
    for (const [x, y] of [[260, 330], [330, 400]]) {
        await clickAt(page, x, y);
        const seen = await probed(page);
        const [u, v] = [numberIn(seen.u), numberIn(seen.v)];
        const exact = sheetAt(u, v);
        const off = (name) => Math.abs(numberIn(seen[name]) - exact[name]);
        check(seen.name === 'sheet', 'the surface has a name where it is picked');
        /* numbers of a page: points to 2^-15 of its size, 3.4 m; straight between samples that are 1/100 apart */
        check(off('x') < 5e-4 && off('y') < 5e-4 && off('z') < 2e-3, 'a picked point is not on the surface: ' + JSON.stringify(seen));
        check(off('H') < 2e-3 && off('K') < 2e-3, 'the curvatures of a picked point are wrong: ' + JSON.stringify([seen, exact]));
        check(seen.x.endsWith(' m') && seen.H.endsWith(' 1/m') && seen.K.endsWith(' 1/m²'), 'a picked point has no units');
        const normal = seen.normal.replaceAll('−', '-').split(' ').map(Number);
        check(exact.normal.every((n, c) => Math.abs(n - normal[c]) < 3e-3), 'the normal of a picked point is wrong');
        before = before || [exact, seen];
    }
    await page.click('#measure'); /* from the point that was picked last */
    await clickAt(page, 260, 330);
    const measured = await probed(page);
    const [, from] = before;
    const last = await page.evaluate('document.querySelectorAll("#probe dd").length');
    check(last === 4 && measured.name.startsWith('from'), 'nothing is measured');
    await page.click('#measure');
    await clickAt(page, 330, 400);
    const to = await probed(page);
    const far = Math.hypot(...['x', 'y', 'z'].map((c) => numberIn(from[c]) - numberIn(to[c])));
    check(Math.abs(numberIn(measured.distance) - far) < 1e-3, 'the distance is ' + measured.distance + ', not ' + far);
    snap(await page.picture(), 'picked');

    await page.mouse('mouseMoved', 330, 401, { button: 'none', buttons: 0 });
    await page.until('document.getElementById("hover").textContent === "sheet" && !document.getElementById("hover").hidden');
    await page.evaluate('document.getElementById("probe-close").click()');
    check((await probed(page)) === null, 'a picked point cannot be let go');
    await clickAt(page, 20, 20);
    check((await probed(page)) === null, 'nothing is picked where nothing is');
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('Enter');
    check((await probed(page)).name === 'sheet', 'Enter picks nothing');
    await page.key('Escape');
    check((await probed(page)) === null, 'Escape does not let go');

    /* All beyond the section is gone, and cannot be picked; the bar of the scale is as long as it says. */
    await page.evaluate(`(() => { const s = document.getElementById('section'); s.value = '2'; s.dispatchEvent(new Event('change')); })()`);
    await page.evaluate(`(() => { const s = document.getElementById('section-at'); s.value = '-0.8'; s.dispatchEvent(new Event('input')); })()`);
    const height = numberIn(await page.evaluate('document.getElementById("section-number").textContent'));
    for (let x = 120; x < 560; x += 60) {
        await clickAt(page, x, 380);
        const seen = await probed(page);
        check(seen === null || numberIn(seen.z) <= height + 2e-3, 'a point is picked that is cut away');
    }
    snap(await page.picture(), 'section');
    await page.evaluate(`(() => { const s = document.getElementById('section'); s.value = '-1'; s.dispatchEvent(new Event('change')); })()`);
    await page.click('[data-view=top]'); /* x to the right, y up: from corner to corner of the sheet is 2 by 3 m */
    const [length, pixels] = await page.evaluate(`[document.querySelector('#scale span').textContent, document.querySelector('#scale i').getBoundingClientRect().width]`);
    const image = decode(await page.picture('#stage'));
    const inkedColumns = Array.from({ length: image.width }, (_, x) => Array.from({ length: 300 }, (_, y) => image.at(x, y + 80)).filter((p) => p.some((c) => c < 250)).length);
    const wide = inkedColumns.map((n, x) => n > 200 ? x : -1).filter((x) => x >= 0);
    check(Math.abs((wide[wide.length - 1] - wide[0]) / pixels * numberIn(length) - 2) < 0.03, 'the scale bar is wrong: ' + length + ' in ' + pixels);
    check(await page.evaluate('[...document.querySelectorAll("#cross line")].map((l) => [l.getAttribute("x2"), l.getAttribute("y2")].map(Number)).every(([x, y], c) => Math.abs(x - [24, 0, 0][c]) < 0.1 && Math.abs(y - [0, -24, 0][c]) < 0.1)'), 'the cross of the axes is wrong from above');
    quiet(page, 'the picks');
    await page.close();
}

/* The picture and the model out of the page, full screen, on paper, in the dark. */
async function testSaving(browser) {
    const page = await Page.open(browser, path.join(folder, 'sheet.html'), 1000, 600);
    await page.until(drawn);
    const saved = fs.mkdtempSync(path.join(folder, 'saved-'));
    await browser.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: saved, eventsEnabled: true });
    const arrived = async (ending) => {
        for (let tries = 0; tries < 200; tries++) {
            const name = fs.readdirSync(saved).find((n) => n.endsWith(ending));
            if (name && fs.statSync(path.join(saved, name)).size > 0) {
                return path.join(saved, name);
            }
            await new Promise((resolve) => setTimeout(resolve, 50));
        }
        throw new Error('nothing is saved as ' + ending);
    };
    await page.click('[name=colour][value=K]');
    await page.click('#save');
    const picture = decode(fs.readFileSync(await arrived('.png')));
    check(inked(picture) > 0.05 && picture.width > 400, 'the picture that is saved is blank');
    await page.click('#download');
    const given = fs.readFileSync(await arrived('.json'), 'utf8');
    const own = path.join(folder, 'own.json');
    execFileSync(taut, ['convert', path.join(folder, 'sheet.json'), '-o', own]);
    check(given === fs.readFileSync(own, 'utf8'), 'the model that is saved is not that of the program, byte by byte');
    await page.click('#full');
    await page.until('document.fullscreenElement !== null');
    await page.evaluate('document.exitFullscreen()');
    const light = decode(await page.picture('#stage'));
    await page.click('#dark');
    const dark = snap(await page.picture(), 'dark');
    check(light.at(5, 5)[0] > 250 && dark.at(5, 5)[0] < 40 && dark.at(990, 590)[0] < 60, 'the dark is not dark');
    const { data } = await page.send('Page.printToPDF', {});
    check(data.length > 20000 && await page.evaluate('document.getElementById("paper").src.length > 5000'), 'paper is blank');
    check(await page.evaluate('document.documentElement.classList.contains("dark")'), 'printing turns the light on');
    quiet(page, 'saving');
    await page.close();
    await browser.send('Browser.setDownloadBehavior', { behavior: 'default' });

    const asked = await Page.open(browser, path.join(folder, 'frames.html'), 800, 420, [{ name: 'prefers-color-scheme', value: 'dark' }, { name: 'prefers-reduced-motion', value: 'reduce' }]);
    await asked.until(drawn);
    check(await asked.evaluate('document.documentElement.classList.contains("dark")'), 'the dark that a person wants is not there');
    await asked.click('#play');
    await asked.evaluate('new Promise((r) => setTimeout(r, 400))');
    check(await asked.evaluate('document.getElementById("frame").value === "0"'), 'frames hurry where a person wants less motion');
    await asked.close();
}

/* A click on a claim shows where; numbers stay on their line; a pipe shows no net at first; axe. */
async function testClaims(browser) {
    for (const example of ['bonnet-roof', 'pipe-run']) {
        const file = path.join(folder, example + '.json');
        execFileSync(taut, ['make', path.join(__dirname, '../../examples/' + example + '.json'), '-o', file, '--quiet']);
        const page = await Page.open(browser, makePage(example, JSON.parse(fs.readFileSync(file, 'utf8'))), 1000, 600);
        await page.until(drawn);
        check(await page.evaluate('document.getElementById("net").checked') === (example !== 'pipe-run'), 'the net of ' + example + ' at first');
        const count = await page.evaluate('document.querySelectorAll(".place").length');
        check(count >= 3, example + ' shows the places of ' + count + ' claims');
        for (let k = 0; k < count; k++) {
            const before = decode(await page.picture('#stage'));
            await page.evaluate(`document.querySelectorAll('.place')[${k}].click()`);
            check(differs(before, snap(await page.picture('#stage'), example + '-claim-' + k)) > 1e-4, 'a claim of ' + example + ' has no place in the picture');
            check((await probed(page)).where.length > 0 && await page.evaluate(`document.querySelectorAll('.place')[${k}].getAttribute('aria-pressed')`) === 'true', 'a place is not said');
        }
        await page.evaluate(`document.querySelectorAll('.place')[${count - 1}].click()`);
        check((await probed(page)) === null, 'a place cannot be let go');
        check(await page.evaluate(`[...document.querySelectorAll('.number')].filter((e) => e.offsetHeight > 0).every((e) => e.getClientRects().length === 1 && (() => {
            const r = document.createRange(); r.selectNodeContents(e); return r.getClientRects().length <= 1; })())`), 'a number of ' + example + ' is broken over two lines');
        await testAxe(page, example);
        await page.click('#dark');
        await testAxe(page, example + ' in the dark');
        quiet(page, example);
        await page.close();
    }
}

/* Words as certificates have them, and what they mean. */
function testPlaces() {
    const surfaces = ['blend1', 'blend10', 'v1', 'pipe.2'].map((name) => ({ name }));
    const curves = [{ name: 'B9' }];
    const cases = [
        ['blend1 at (0.6, -1.6e-2)', surfaces, { kind: 'surface', index: 0, u: 0.6, v: -0.016 }],
        ['blend10, u = 0.484863, v = 0.492188', surfaces, { kind: 'surface', index: 1, u: 0.484863, v: 0.492188 }],
        ['the curvature of blend1, t = 0.5', surfaces, { kind: 'surface', index: 0, t: 0.5 }],
        ['blend10.u1, blend1.u0', surfaces, { kind: 'surface', index: 1, edge: 'u1' }],
        ['/surfaces/3/points/2/1', surfaces, { kind: 'surface', index: 3, point: [2, 1] }],
        ['/surfaces/9/points/2/1', surfaces, null],
        ['B9 at 0.08', surfaces, { kind: 'curve', index: 0, t: 0.08 }],
        ['pipeX2', surfaces, null],
        ['v1, t = 0.25; on no edge above 2e-14', surfaces.slice(0, 1), { kind: 'surface', index: 0, t: 0.25, edge: 'v1' }],
        ['derivatives across', surfaces.slice(0, 1), null],
        ['', surfaces, null]
    ];
    for (const [words, list, place] of cases) {
        check(JSON.stringify(placeOf(words, list, curves)) === JSON.stringify(place), 'the place of "' + words + '" is ' + JSON.stringify(placeOf(words, list, curves)));
    }
}

async function testAxe(page, what) {
    if (axe === '-') {
        return;
    }
    const found = await page.violations(fs.readFileSync(axe, 'utf8'));
    check(found.length === 0, 'axe finds in ' + what + ': ' + found.join('; '));
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

/* A film of threads shows what they pull with, one of supports what these do; nothing of that is offered of anything else. */
async function testForces(browser) {
    const held = (name) => ({ [name]: 'fixed' });
    const flat = path.join(folder, 'flat.json');
    fs.writeFileSync(flat, JSON.stringify({ taut: 1, construct: 'film', unit: 'm', force_density: [3, 1.5],
        corners: { u0v0: [0, 0, 0], u1v0: [2, 0, 0], u0v1: [0, 3, 0], u1v1: [2, 3, 0] },
        edges: { ...held('u0'), ...held('u1'), ...held('v0'), ...held('v1') } }));
    const model = path.join(folder, 'flat-model.json');
    execFileSync(taut, ['make', flat, '-o', model, '--quiet']);
    const page = await Page.open(browser, makePage('flat-film', JSON.parse(fs.readFileSync(model, 'utf8'))), 800, 420);
    await page.until(drawn);
    await page.evaluate('document.getElementById("canvas").focus()');
    await mustChange(page, 'warp', () => page.click('[name=colour][value=U]'));
    check((await page.evaluate('document.getElementById("legend-title").textContent')) === 'Stress along the warp (u), force per m', 'the scale of the stress has no name');
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('Enter');
    const found = await probed(page); /* 3 * 2 / 3 along u, 1.5 * 3 / 2 along v */
    check(Math.abs(numberIn(found['warp stress']) - 2) < 1e-3 && found['warp stress'].endsWith(' 1/m'), 'warp stress ' + found['warp stress']);
    check(Math.abs(numberIn(found['weft stress']) - 2.25) < 1e-3, 'weft stress ' + found['weft stress']);
    check(await page.evaluate('document.getElementById("reaction-choice").hidden'), 'supports that carry nothing have arrows');
    quiet(page, 'the flat film');
    await page.close();
    for (const [name, count] of [['film-warp-weft', 4], ['film-tent', 5]]) {
        const file = path.join(folder, name + '.json');
        execFileSync(taut, ['make', path.join(__dirname, '../../examples/' + name + '.json'), '-o', file, '--quiet']);
        const made = JSON.parse(fs.readFileSync(file, 'utf8'));
        const longest = Math.max(...made.certificate.figures.reactions.map((force) => Math.hypot(...force)));
        const sail = await Page.open(browser, makePage(name + '-page', made), 800, 420);
        await sail.until(drawn);
        check(made.certificate.figures.reactions.length === count, name + ' has other supports');
        if (made.details.cables.length > 0) {
            const told = await sail.evaluate('document.getElementById("details").innerText');
            check(/length\s+[0-9.]+ m(\s|$)/.test(told), name + ': a cable\'s length has no unit: ' + told.slice(0, 400));
            check(!/force\s+[0-9.]+ m/.test(told), name + ': a force is a length');
        }
        await mustChange(sail, name + '-reactions', () => sail.click('#reactions'));
        const note = await sail.evaluate('document.getElementById("reaction-note").textContent');
        check(Math.abs(numberIn(note.replace(/\.$/, '')) / longest - 1) < 0.005, name + ': ' + note + ', the longest is ' + longest);
        await sail.evaluate('document.getElementById("canvas").focus()');
        await mustChange(sail, name + '-reactions-off', () => sail.key('a'));
        check(await sail.evaluate('document.getElementById("weft-choice").hidden') === (name === 'film-tent'), name + ': weft is offered wrongly');
        if (name === 'film-warp-weft') {
            await mustChange(sail, 'weft', () => sail.click('[name=colour][value=V]'));
        }
        quiet(sail, name);
        await sail.close();
    }
    const plain = await Page.open(browser, path.join(folder, 'frames.html'), 800, 420);
    await plain.until(drawn);
    check(await plain.evaluate('["reaction-choice", "warp-choice", "weft-choice"].every((id) => document.getElementById(id).hidden)'), 'forces are offered where there are none');
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

/* Lines of a net behind its surface are seen through it, so that no point of it floats; a gap is an area beside its bound alone. */
async function testNetBehind(browser) {
    const basis = { type: 'bezier', degree: 2 };
    const sag = { taut: 1, details: { roll: { gap: 3, waste: 0.25 } }, surfaces: [{ name: 'sag', u: basis, v: basis,
        points: [[[0, 0, 0], [0, 1, 0], [0, 2, 0]], [[1, 0, 0], [1, 1, -2], [1, 2, 0]], [[2, 0, 0], [2, 1, 0], [2, 2, 0]]] }] };
    const page = await Page.open(browser, makePage('sag', sag, '--view', '0,90'), 900, 600);
    await page.until(drawn);
    const inner = async () => {
        const image = decode(await page.picture('#stage'));
        const [x, y] = [image.width, image.height].map((n) => Math.round(n / 2));
        return Array.from({ length: 81 }, (_, k) => image.at(x + k - 40, y + 30)).map((p) => p[0]);
    };
    const shown = await inner();
    await page.click('#net');
    const bare = await inner();
    const paler = bare.map((c, k) => c - shown[k]);
    check(Math.max(...paler) > 8 && Math.max(...paler) < 90, 'lines of a net behind the surface: ' + paler);
    const told = await page.evaluate('document.getElementById("details").innerText');
    check(/gap\s+3 mm(?!\u00b2)/.test(told), 'the gap on a roll is no length: ' + told);
    quiet(page, 'a net behind its surface');
    await page.close();
}

/* A net: its nodes are points, and say their names under the pointer; its curves theirs beside them. */
async function testNodes(browser) {
    const made = path.join(folder, 'net.json');
    fs.writeFileSync(made, execFileSync(taut, ['example', 'trace-principal']));
    execFileSync(taut, ['make', made, '-o', path.join(folder, 'net-made.json'), '--quiet']);
    const net = JSON.parse(fs.readFileSync(path.join(folder, 'net-made.json')));
    const page = await Page.open(browser, makePage('nodes', net, '--view', '0,90'), 900, 600);
    await page.until(drawn);
    /* seen from above, one is in the middle of the canvas */
    const middle = net.details.nodes.find((node) => Math.hypot(...node.at) < 1e-6);
    const [x, y] = await page.evaluate('(() => { const b = document.getElementById("canvas").getBoundingClientRect();' +
        ' return [b.left + b.width / 2, b.top + b.height / 2]; })()');
    await page.mouse('mouseMoved', x + 1, y + 1, { button: 'none', buttons: 0 });
    await page.until('document.getElementById("hover").textContent === "' + middle.node + '"');
    snap(await page.picture(), 'nodes');
    quiet(page, 'the page of a net');
    await page.close();
}

/* Pieces of cloth: coloured by their strain, flat beside the surface, then mounted on it, each place where the surface has it,
 * and back as they were. */
async function testCloth(browser) {
    const made = path.join(folder, 'cloth.json');
    fs.writeFileSync(made, execFileSync(taut, ['example', 'pattern-sail']));
    execFileSync(taut, ['make', made, '-o', path.join(folder, 'cloth-made.json'), '--quiet']);
    const cloth = JSON.parse(fs.readFileSync(path.join(folder, 'cloth-made.json')));
    const page = await Page.open(browser, makePage('cloth', cloth), 1000, 700);
    await page.until(drawn);
    const flat = snap(await page.picture('#stage'), 'cloth-flat');
    check(await page.evaluate('document.querySelector("[name=colour][value=S]").checked && !document.getElementById("cloth").hidden'), 'cloth is not coloured by its strain');
    check((await page.evaluate('document.getElementById("legend").getAttribute("aria-label")')).includes('Strain'), 'the scale of the strain has no name');
    await mustChange(page, 'cloth-mounted', async () => {
        await page.click('[name=cloth][value=mounted]');
        await page.until('document.getElementById("canvas").dataset.flight === "1"');
    });
    const found = [];
    const box = await page.evaluate('(() => { const b = document.getElementById("canvas").getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()');
    for (let k = 0; k < 36; k++) {
        await clickAt(page, box[0] + box[2] * (0.1 + 0.16 * (k % 6)), box[1] + box[3] * (0.1 + 0.16 * Math.floor(k / 6)));
        const seen = await probed(page);
        if (seen) {
            found.push(seen);
        }
    }
    check(new Set(found.map((seen) => seen.name)).size > 2, 'mounted pieces are not found: ' + found.length);
    for (const seen of found) {
        const [x, y, z] = ['x', 'y', 'z'].map((name) => numberIn(seen[name]));
        check(/^P[1-4]$/.test(seen.name), 'mounted, ' + seen.name + ' is seen');
        check(Math.abs(z - 0.3 * (x * x - y * y)) < 1e-3, seen.name + ' is not on the surface: ' + [x, y, z]);
        check(Math.abs(numberIn(seen.strain)) < 0.02, 'the strain of ' + seen.name + ' is ' + seen.strain);
    }
    await page.key('Escape');
    await page.key('o');
    await page.until('document.getElementById("canvas").dataset.flight === "0"');
    await page.evaluate('document.activeElement.blur()');
    const again = snap(await page.picture('#stage'), 'cloth-again');
    check(differs(flat, again) < 0.001, 'pieces do not come back as they were: ' + differs(flat, again));
    quiet(page, 'the page of cloth');
    await page.close();
}

async function main() {
    testPlaces();
    const browser = new Browser(process.env.CHROMIUM || 'chromium');
    try {
        testUnits();
    await testControls(browser);
        await testFrames(browser);
        await testPicks(browser);
        await testSaving(browser);
        await testClaims(browser);
        await testGap(browser);
        await testForces(browser);
        await testPhone(browser);
        await testLarge(browser);
        await testFarNet(browser);
        await testNetBehind(browser);
        await testNodes(browser);
        await testCloth(browser);
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
