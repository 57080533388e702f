/* test_studio.js TAUT FOLDER AXE [PICTURES] -- the page of `taut studio` in Chromium, from the disk: it loads without a complaint and without
 * asking for any other address; window.taut makes, changes, undoes and proves; hands and keys do the same; what it saves and exports
 * are the program's bytes; axe (the file of axe-core, or -) finds nothing. GESTURES: how many at random, 100; DRAG: for how many seconds a
 * corner is led about, none; ONLY=gestures: these alone.
 * With PICTURES, states are written there as PNG, to be looked at. */
'use strict';
const { execFileSync, spawnSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { Browser, Page, decode, differs } = require('../viewer/browser.js');

const [taut, folder, axe, pictures] = process.argv.slice(2);
let failures = 0;

function check(holds, what) {
    if (!holds) {
        failures++;
        console.log('FAILED: ' + what);
    }
}

function write(name, ...words) {
    const file = path.join(folder, name + '.html');
    execFileSync(taut, ['studio', ...words, '-o', file]);
    return file;
}

async function open(browser, file, hash = '', width = 1280, height = 860) {
    const page = await Page.open(browser, file + hash, width, height);
    await page.evaluate('taut.ready.then(() => true)');
    return page;
}

async function snap(page, name, selector) {
    const image = await page.picture(selector);
    if (pictures) {
        fs.writeFileSync(path.join(pictures, name + '.png'), image);
    }
    return decode(image);
}

function quiet(page, what) {
    check(page.complaints.length === 0, what + ' complains: ' + page.complaints.join('; '));
    check(page.requests.every((url) => /^(file|data|blob):/.test(url)) && page.requests.filter((url) => url.startsWith('file:')).length === 1,
        what + ' asks for ' + page.requests.join(' '));
}

const example = (name) => JSON.parse(execFileSync(taut, ['example', name]));
const made = (document) => JSON.parse(execFileSync(taut, ['make', '-', '--quiet'], { input: JSON.stringify(document), maxBuffer: 1 << 28 }));
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/* An error of an expression, as { reason, where, message }; null if there is none. */
const failure = (page, expression) => page.evaluate(`(async () => { try { await ${expression}; return null; }
    catch (e) { return { reason: e.reason, where: e.where, message: e.message }; } })()`);

async function testScripts(browser) {
    const page = await open(browser, write('tent'));
    check(await page.evaluate('typeof taut.version === "string" && taut.version.length > 0'), 'a version');
    const first = await page.evaluate('taut.problem()');
    check(same(first, example('dirichlet-tent')), 'it opens with dirichlet-tent');
    check(same(await page.evaluate('taut.model()'), made(first)), 'the model is the program\'s');
    const before = await snap(page, 'tent', '#stage');
    await page.evaluate('taut.set("/points/0/1", [-1, 0, 2.5])');
    const changed = await page.evaluate('taut.problem()');
    check(same(changed.points[0][1], [-1, 0, 2.5]), 'the document has the value');
    check(same(await page.evaluate('taut.model()'), made(changed)), 'the changed model is the program\'s');
    check(differs(before, await snap(page, 'tent-pulled', '#stage')) > 0.01, 'the picture follows');
    await page.until('document.getElementById("proof").dataset.state === "proved"');

    const stats = await page.evaluate('taut.stats()');
    check(stats.solves >= 2 && stats.draft_ms > 0 && stats.final_ms > 0 && stats.frames > 0 && stats.open_ms > 0, 'stats ' + JSON.stringify(stats));
    check(await page.evaluate('taut.undo()') === true && same(await page.evaluate('taut.problem()'), first), 'undo');
    check(await page.evaluate('taut.undo()') === false, 'no undo beyond the first document');
    check(await page.evaluate('taut.redo()') === true && same(await page.evaluate('taut.problem()'), changed), 'redo');

    const error = await failure(page, 'taut.set("/u/degree", -2)');
    const told = JSON.parse(spawnSync(taut, ['make', '-', '--json'], { input: JSON.stringify({ ...changed, u: { ...changed.u, degree: -2 } }) }).stderr).error;
    check(error && error.reason === told.reason && error.where === told.where && error.message.length > 10,
        'the library\'s error: ' + JSON.stringify(error) + ' for ' + JSON.stringify(told));
    check(same(await page.evaluate('taut.problem()'), changed), 'a failure leaves the document');
    check(same(await page.evaluate('taut.model()'), made(changed)), 'and the last good model');
    check(await page.evaluate('!document.getElementById("fault").hidden'), 'the error is told in the picture');
    await snap(page, 'tent-error');
    check((await failure(page, 'taut.set("/points/9/9", [0, 0, 0])')).reason === 'missing', 'a pointer to nothing');
    check((await failure(page, 'taut.load("{ nonsense")')).reason === 'syntax', 'no JSON');
    await page.evaluate('Promise.all([0, 1, 2, 3].map((k) => taut.set("/points/0/1", [-1, 0, k])))');
    check((await page.evaluate('taut.problem()')).points[0][1][2] === 3, 'changes at once come in order');
    quiet(page, 'the page');
    await page.close();
}

async function testExamples(browser) {
    const page = await open(browser, write('scherk', 'plateau-scherk'));
    for (const name of ['plateau-scherk', 'harmonic-extension', 'biharmonic-boundary', 'bonnet-enneper', 'pipe-straight', 'film-sail', 'trace-bonnet']) {
        if (spawnSync(taut, ['example', name]).status !== 0) {
            continue;
        }
        const document = example(name);
        await page.evaluate(`taut.load(${JSON.stringify(document)})`);
        check(same(await page.evaluate('taut.model()'), made(document)), name + ' is the program\'s');
        await page.until('document.getElementById("proof").dataset.state !== "draft"');
        await snap(page, name);
    }
    await page.evaluate(`taut.load(${JSON.stringify(example('plateau-scherk'))})`);
    await page.until('document.getElementById("proof").dataset.state !== "draft"');
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('g');
    check(Number(await page.evaluate('document.getElementById("legend-high").textContent')) > 0, 'the gap of a film is told');
    await snap(page, 'gap', '#stage');
    check((await page.evaluate('[...document.querySelectorAll("#examples option")].length')) > 60, 'all examples are in the page');
    quiet(page, 'examples');
    await page.close();
}

/* Where points are seen from above, which are framed in the middle of a box of the page. */
function seenFrom(box, points) {
    const low = [0, 1, 2].map((c) => Math.min(...points.map((p) => p[c]))), high = [0, 1, 2].map((c) => Math.max(...points.map((p) => p[c])));
    const half = Math.hypot(...low.map((x, c) => (high[c] - x) / 2)), scale = Math.min(box[2], box[3]) / 2 / 1.1 / half;
    return Object.assign((p) => [box[0] + box[2] / 2 + (p[0] - (low[0] + high[0]) / 2) * scale,
        box[1] + box[3] / 2 - (p[1] - (low[1] + high[1]) / 2) * scale], { scale });
}

const canvasOf = (page) => page.evaluate('(() => { const r = document.getElementById("canvas").getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()');

/* A sail follows by drafts, says so, and is the program's when the hand lets go; where there is none, the last one stays. */
async function testDrafts(browser) {
    const page = await open(browser, write('sail', 'film-sail')), before = await page.evaluate('taut.problem()');
    await page.until('document.getElementById("proof").dataset.state !== "draft"');
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('3', '3');
    const first = await snap(page, 'sail-above', '#stage');
    const corners = Object.values(before.corners), seen = seenFrom(await canvasOf(page), corners), [x, y] = seen(before.corners.u0v0);
    await page.mouse('mousePressed', x, y, { buttons: 1 });
    const solves = (await page.evaluate('taut.stats()')).solves, times = [];
    for (let k = 1; k <= 20; k++) {
        await page.mouse('mouseMoved', x - 4 - k, y + 3 + k / 2, { buttons: 1 });
        await page.until(`taut.stats().solves >= ${solves + k}`);
        times.push((await page.evaluate('taut.stats()')).draft_ms);
    }
    times.sort((a, b) => a - b);
    console.log('a sail of 12 x 12 points follows within ' + times[10].toFixed(0) + ' ms, the middle of 20');
    check(await page.evaluate('document.getElementById("proof").dataset.state') === 'draft', 'a draft says so');
    check(differs(first, await snap(page, 'sail-drag', '#stage')) > 0.01, 'the sail follows');
    await page.mouse('mouseReleased', x - 24, y + 13);
    /* taken again before the film is made: that is given up, and the next follows */
    const [x2, y2] = [x - 24, y + 13];
    await page.mouse('mousePressed', x2, y2, { buttons: 1 });
    await page.mouse('mouseMoved', x2 + 6, y2, { buttons: 1 });
    await page.mouse('mouseMoved', x2 + 10, y2 - 2, { buttons: 1 });
    await page.mouse('mouseReleased', x2 + 10, y2 - 2);
    await page.until(`taut.problem().corners.u0v0[0] !== ${before.corners.u0v0[0]}`);
    await page.evaluate('taut.model().then(() => true)');
    await page.until('document.getElementById("proof").dataset.state !== "draft"');
    check(await page.evaluate('document.getElementById("fault").hidden'), 'nothing is wrong with the sail');
    const after = await page.evaluate('taut.problem()');
    check(same(await page.evaluate('taut.model()'), made(after)), 'the sail is the program\'s');
    for (const [key, name] of [['a', 'forces'], ['a', 'without forces'], ['i', 'isothermality'], ['g', 'gap'], ['c', 'combs'], ['c', 'none'], ['k', 'K']]) {
        await page.evaluate('document.getElementById("canvas").focus()');
        const plain = await snap(page, 'sail-plain', '#stage');
        await page.key(key);
        check(differs(plain, await snap(page, 'sail-' + name, '#stage')) > 0.001, name + ' is seen');
    }
    check((await page.evaluate('document.getElementById("legend-name").textContent')) === 'K', 'the legend says what is coloured');
    const error = await failure(page, 'taut.set("/edges/u0/cable/force", 0.2)');
    check(error && error.reason === 'cable-too-weak', 'a cable that is too weak: ' + JSON.stringify(error));
    check(/what helps: .*force/.test(await page.evaluate('document.getElementById("fault").textContent')), 'and what helps');
    check(same(await page.evaluate('taut.problem()'), after), 'the sail stays');
    quiet(page, 'drafts');
    await page.close();
}

/* A point under a hand: where it is seen is asked of the page's own picture. */
async function testHand(browser) {
    const page = await open(browser, write('hand', 'dirichlet-tent'));
    const before = await page.evaluate('taut.problem()');
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('3', '3'); /* from above: x to the right, y up */
    await page.settled();
    const box = await canvasOf(page);
    const seen = seenFrom(box, before.points.flat().filter((p) => p !== null));
    const scale = seen.scale;
    const [x, y] = seen(before.points[0][0]);
    await page.mouse('mouseMoved', x, y, { button: 'none' });
    await page.mouse('mousePressed', x, y, { buttons: 1 });
    for (let k = 1; k <= 10; k++) {
        await page.mouse('mouseMoved', x - 4 * k, y + 3 * k, { buttons: 1 });
    }
    await snap(page, 'hand-drag');
    await page.mouse('mouseReleased', x - 40, y + 30);
    const corner = before.points[0][0];
    await page.until(`taut.problem().points[0][0][0] !== ${corner[0]}`);
    const after = await page.evaluate('taut.problem()'), moved = after.points[0][0];
    check(Math.abs(moved[0] - corner[0] + 40 / scale) < 0.02 && Math.abs(moved[1] - corner[1] + 30 / scale) < 0.02 &&
        Math.abs(moved[2] - corner[2]) < 0.01, `a corner at ${corner} was dragged to ${moved}`);
    check(same(after.points.map((row) => row.slice(1)), before.points.map((row) => row.slice(1))), 'the others stay');
    check(same(await page.evaluate('taut.model()'), made(after)), 'the dragged model is the program\'s');
    check(await page.evaluate('document.querySelectorAll("#chosen input").length') === 3, 'its numbers can be typed');
    await page.send('Input.dispatchKeyEvent', { type: 'keyDown', key: 'z', modifiers: 2, windowsVirtualKeyCode: 90 });
    await page.until(`JSON.stringify(taut.problem()) === ${JSON.stringify(JSON.stringify(before))}`);
    await testFree(page, seen, before);
    await testMirror(page, seen, before);
    quiet(page, 'hands');
    await page.close();
}

/* A point that the document leaves free is held by a key where it is, and freed by the same. */
async function testFree(page, seen, before) {
    const i = before.points.findIndex((row) => row.includes(null)), j = before.points[i].indexOf(null);
    const at = (await page.evaluate('taut.model()')).surfaces[0].points[i][j], [x, y] = seen(at);
    await page.mouse('mouseMoved', x, y, { button: 'none' });
    await page.mouse('mousePressed', x, y, { buttons: 1 });
    await page.mouse('mouseReleased', x, y);
    await page.key('p');
    await page.until(`taut.problem().points[${i}][${j}] !== null`);
    const held = (await page.evaluate('taut.problem()')).points[i][j];
    check(same(held, at), `a free point at ${at} is held at ${held}`);
    await page.key('p');
    await page.until(`taut.problem().points[${i}][${j}] === null`);
    check(same(await page.evaluate('taut.problem()'), before), 'and free again, the problem is as it was');
}

/* With a mirror across x the image of a corner does what the corner does. */
async function testMirror(page, seen, before) {
    const last = before.points.length - 1, corner = before.points[0][0], image = before.points[last][0], [x, y] = seen(corner);
    if (corner[0] + image[0] !== before.points[0].at(-1)[0] + before.points[last].at(-1)[0] || corner[1] !== image[1] || corner[2] !== image[2]) {
        check(false, 'the example is symmetric across x');
        return;
    }
    await page.evaluate('document.getElementById("mirror").value = "x"');
    await page.mouse('mousePressed', x, y, { buttons: 1 });
    await page.mouse('mouseMoved', x - 30, y + 20, { buttons: 1 });
    await page.mouse('mouseReleased', x - 30, y + 20);
    await page.until(`taut.problem().points[0][0][0] !== ${corner[0]}`);
    const { points } = await page.evaluate('taut.problem()');
    check(Math.abs(points[0][0][0] + points[last][0][0] - corner[0] - image[0]) < 1e-12 && points[0][0][1] === points[last][0][1],
        `a corner at ${points[0][0]} has its image at ${points[last][0]}`);
    await page.evaluate('(document.getElementById("mirror").value = "", taut.undo())');
}

/* Bytes of the page's own objects that are in use. */
async function heapOf(page) {
    await page.send('HeapProfiler.collectGarbage');
    return (await page.send('Runtime.getHeapUsage')).usedSize;
}

/* Random gestures: drags of points, of edges and of the picture, keys, views; the page never complains, and its model is the program's at
 * the end. What it holds is looked at after each tenth; it may not grow by 2 MB from the first to the last. */
async function testGestures(browser, count) {
    const page = await open(browser, write('gestures', 'dirichlet-tent'), '', 840, 420); /* a small picture: the processor draws it */
    let seed = 12345;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    const marks = [], keys = ['n', 'h', 'k', 'i', 'c', 'r', 'z', 'f', 'ArrowLeft', 'd'];
    for (let k = 0; k <= count; k++) {
        if (k % Math.ceil(count / 10) === 0) {
            marks.push(await heapOf(page));
        }
        const x = 20 + 450 * random(), y = 60 + 340 * random();
        await page.mouse('mousePressed', x, y, { buttons: 1 });
        await page.mouse('mouseMoved', x + 40 * (random() - 0.5), y + 40 * (random() - 0.5), { buttons: 1 });
        await page.mouse('mouseReleased', x + 40 * (random() - 0.5), y + 40 * (random() - 0.5));
        if (k % 5 === 0) {
            await page.key(keys[Math.floor(keys.length * random())]);
        }
    }
    /* the problem behind the model: what the last hand let go may be on its way before it */
    const [model, document] = await page.evaluate('taut.model().then((model) => [model, taut.problem()])');
    check(same(model, made(document)), 'after gestures the model is the program\'s');
    const grown = marks.at(-1) - marks[1], { solves } = await page.evaluate('taut.stats()');
    console.log('after ' + count + ' gestures, ' + solves + ' solves, the page holds ' + Math.round(grown / 1000) + ' kB more than after a tenth of them (' +
        marks.map((bytes) => (bytes / 1e6).toFixed(1)).join(', ') + ' MB)');
    check(grown < 2e6, 'the page grows by ' + grown + ' bytes');
    quiet(page, 'gestures');
    await page.close();
}

/* Bytes that the page and its workers hold, the memory of their modules with it, where the browser tells. */
async function heldBy(page, workers) {
    let sum = 0;
    for (const send of [page.send, ...workers.values()]) {
        await send('HeapProfiler.collectGarbage');
        const { usedSize, backingStorageSize } = await send('Runtime.getHeapUsage');
        sum += usedSize + (backingStorageSize || 0);
    }
    return sum;
}

/* A corner is led around a circle, and let go once a turn, for so many seconds; after the first minute, or the first tenth of less, page and
 * workers may not grow by 2 MB. */
async function testDragging(browser, name, seconds) {
    const page = await open(browser, write('dragging', name), '', 840, 420), workers = new Map();
    browser.listeners.push(({ method, params }) => {
        if (method === 'Target.attachedToTarget' && params.targetInfo.type === 'worker') {
            workers.set(params.sessionId, (method2, params2) => browser.send(method2, params2, params.sessionId));
        } else if (method === 'Target.detachedFromTarget') {
            workers.delete(params.sessionId);
        }
    });
    await page.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: true });
    await page.evaluate('document.getElementById("canvas").focus()');
    await page.key('3', '3');
    await page.settled();
    const document = await page.evaluate('taut.problem()'), points = document.corners ? Object.values(document.corners) : document.points.flat();
    const [x, y] = seenFrom(await canvasOf(page), points.filter((point) => point !== null))(points.at(-1)); /* below are the tools */
    const begin = Date.now(), warm = Math.min(60, seconds / 10), marks = [];
    let moves = 0;
    for (let next = warm; Date.now() - begin < seconds * 1000;) {
        await page.mouse('mousePressed', x, y, { buttons: 1 });
        for (let k = 0; k <= 60; k++, moves++) {
            const angle = k / 60 * 2 * Math.PI;
            await page.mouse('mouseMoved', x - 15 * (1 - Math.cos(angle)), y + 15 * Math.sin(angle), { buttons: 1 });
            await page.evaluate('new Promise((resolve) => setTimeout(resolve, 15))');
        }
        await page.mouse('mouseReleased', x, y);
        await page.evaluate('taut.model().then(() => true)');
        if (Date.now() - begin > next * 1000) {
            next += Math.max(warm, seconds / 10);
            marks.push(await heldBy(page, workers));
        }
    }
    const grown = marks.at(-1) - marks[0], { solves } = await page.evaluate('taut.stats()');
    console.log('after ' + seconds + ' s of dragging ' + name + ', ' + moves + ' moves, ' + solves + ' solves, page and workers hold ' + Math.round(grown / 1000) +
        ' kB more than at first (' + marks.map((bytes) => (bytes / 1e6).toFixed(1)).join(', ') + ' MB)');
    check(grown < 2e6, 'page and workers grow by ' + grown + ' bytes');
    check(solves > moves / 20, 'the surface follows ' + moves + ' moves by ' + solves + ' solves');
    quiet(page, 'dragging');
    await page.close();
}

async function testShare(browser) {
    const file = write('share', 'dirichlet-tent');
    const page = await open(browser, file);
    await page.evaluate('taut.set("/points/0/1", [-1, 0, 7])');
    await page.evaluate('[...document.querySelectorAll("details.menu button")].find((b) => b.textContent.startsWith("Share")).click()');
    await page.until('location.hash.length > 20');
    const hash = await page.evaluate('location.hash');
    await page.close();
    const other = await open(browser, file, hash, 420, 800);
    check((await other.evaluate('taut.problem()')).points[0][1][2] === 7, 'a shared address holds the problem');
    await snap(other, 'phone');
    await other.close();
}

/* axe-core, in light and dark, at the widths of a desk and of a phone. */
async function testAccess(browser) {
    if (axe === '-') {
        return;
    }
    for (const width of [1280, 420]) {
        const page = await open(browser, write('access', 'dirichlet-tent'), '', width, 800);
        for (const dark of [true, false]) {
            await page.evaluate(`document.documentElement.classList.toggle('dark', ${dark})`);
            const found = await page.violations(fs.readFileSync(axe, 'utf8'));
            check(found.length === 0, 'axe finds at ' + width + ' in ' + (dark ? 'dark' : 'light') + ': ' + found.join('; '));
        }
        await page.close();
    }
}

async function testAll(browser) {
    const { size } = fs.statSync(write('size'));
    check(size <= 1.6e6, 'the page is ' + size + ' bytes');
    await testScripts(browser);
    await testHand(browser);
    await testDrafts(browser);
    await testShare(browser);
    await testExamples(browser);
    await testAccess(browser);
}

async function main() {
    const browser = new Browser(process.env.CHROMIUM || 'chromium');
    try {
        if (process.env.ONLY !== 'gestures') {
            await testAll(browser);
        }
        await testGestures(browser, Number(process.env.GESTURES || 100));
        for (const name of Number(process.env.DRAG) > 0 ? ['dirichlet-tent', 'film-sail'] : []) {
            await testDragging(browser, name, Number(process.env.DRAG) / 2);
        }
    } catch (error) {
        failures++;
        console.log('FAILED: ' + error.stack);
    }
    await browser.close();
    process.exit(failures > 0 ? 1 : 0);
}

main();
