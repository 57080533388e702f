/* browser.js -- Chromium without a window, driven through a pipe (its DevTools protocol), so that a test needs node and
 * nothing of npm. */
'use strict';
const { spawn } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const zlib = require('node:zlib');

const flags = [
    '--headless=new', '--remote-debugging-pipe', '--no-first-run', '--no-sandbox', '--disable-dev-shm-usage',
    '--disable-extensions', '--disable-background-networking', '--disable-component-update', '--mute-audio',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--force-device-scale-factor=1', '--hide-scrollbars'
];

class Browser {
    constructor(command) {
        this.home = fs.mkdtempSync(path.join(os.tmpdir(), 'taut-view-'));
        this.process = spawn(command, [...flags, '--user-data-dir=' + this.home], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
        this.waiting = new Map();
        this.listeners = [];
        this.count = 0;
        let rest = Buffer.alloc(0);
        this.process.stdio[4].on('data', (bytes) => {
            rest = Buffer.concat([rest, bytes]);
            for (let end = rest.indexOf(0); end >= 0; end = rest.indexOf(0)) {
                this.take(JSON.parse(rest.subarray(0, end).toString()));
                rest = rest.subarray(end + 1);
            }
        });
        this.ended = new Promise((resolve) => this.process.on('exit', resolve));
    }

    take(message) {
        if (message.id !== undefined) {
            const { resolve, reject } = this.waiting.get(message.id);
            this.waiting.delete(message.id);
            if (message.error) {
                reject(new Error(JSON.stringify(message.error)));
            } else {
                resolve(message.result);
            }
        } else {
            this.listeners.forEach((listener) => listener(message));
        }
    }

    send(method, params, sessionId) {
        const id = ++this.count;
        this.process.stdio[3].write(JSON.stringify({ id, method, params: params || {}, sessionId }) + '\0');
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    }

    async close() {
        this.send('Browser.close').catch(() => 0);
        await this.ended;
        fs.rmSync(this.home, { recursive: true, force: true, maxRetries: 5 });
    }
}

/* A page, everything it complains of and every address it asks for. */
class Page {
    /* wishes: what the person set, such as [{ name: 'prefers-color-scheme', value: 'dark' }] */
    static async open(browser, file, width, height, wishes) {
        const page = new Page();
        const { targetId } = await browser.send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await browser.send('Target.attachToTarget', { targetId, flatten: true });
        page.send = (method, params) => browser.send(method, params, sessionId);
        page.targetId = targetId;
        page.browser = browser;
        page.complaints = [];
        page.requests = [];
        browser.listeners.push((m) => m.sessionId === sessionId && page.hear(m));
        for (const domain of ['Page', 'Runtime', 'Log', 'Network']) {
            await page.send(domain + '.enable');
        }
        await page.resize(width, height);
        await page.send('Emulation.setEmulatedMedia', { features: wishes || [] });
        await page.send('Page.navigate', { url: 'file://' + path.resolve(file) });
        await page.until('document.readyState === "complete"');
        return page;
    }

    hear(message) {
        const p = message.params;
        if (message.method === 'Runtime.exceptionThrown') {
            this.complaints.push(p.exceptionDetails.text + ' ' + (p.exceptionDetails.exception || {}).description);
        } else if (message.method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(p.type)) {
            this.complaints.push(p.type + ': ' + p.args.map((a) => a.value || a.description).join(' '));
        } else if (message.method === 'Log.entryAdded' && ['error', 'warning'].includes(p.entry.level)) {
            this.complaints.push(p.entry.level + ': ' + p.entry.text);
        } else if (message.method === 'Network.requestWillBeSent') {
            this.requests.push(p.request.url);
        }
    }

    resize(width, height) {
        return this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
    }

    async evaluate(expression) {
        const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true });
        if (exceptionDetails) {
            throw new Error(expression + ': ' + JSON.stringify(exceptionDetails));
        }
        return result.value;
    }

    async until(expression) {
        for (let tries = 0; tries < 400; tries++) {
            if (await this.evaluate(expression)) {
                return;
            }
            await new Promise((resolve) => setTimeout(resolve, 50));
        }
        throw new Error('never: ' + expression);
    }

    /* After the next picture has been drawn. */
    async settled() {
        await this.evaluate('new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(r, 30))))');
    }

    /* What is seen, as PNG; of one element, or of all. */
    async picture(selector) {
        await this.settled();
        const clip = selector && await this.evaluate(`(() => { const r = document.querySelector('${selector}').getBoundingClientRect();
            return { x: r.x + scrollX, y: r.y + scrollY, width: r.width, height: r.height, scale: 1 }; })()`);
        const { data } = await this.send('Page.captureScreenshot', clip ? { clip } : {});
        return Buffer.from(data, 'base64');
    }

    async key(key, text) {
        const code = { ' ': 32, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9 }[key] || key.toUpperCase().charCodeAt(0);
        const event = { key, windowsVirtualKeyCode: code, text: text === undefined && key.length === 1 ? key : text };
        await this.send('Input.dispatchKeyEvent', { type: 'keyDown', ...event });
        await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, windowsVirtualKeyCode: code });
    }

    async mouse(type, x, y, more) {
        await this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1, ...more });
    }

    /* A click in the middle of an element, as a person would make it. */
    async click(selector) {
        const [x, y] = await this.evaluate(`(() => { const e = document.querySelector('${selector}'); e.scrollIntoView({ block: 'center' });
            const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
        await this.mouse('mousePressed', x, y);
        await this.mouse('mouseReleased', x, y);
    }

    /* What axe-core, the text of its file, has against the page: "impact rule: elements". */
    async violations(axe) {
        await this.evaluate(axe + '; 0');
        return this.evaluate(`axe.run().then((r) => r.violations.map((v) => v.impact + ' ' + v.id + ': ' + v.nodes.map((n) => n.html.slice(0, 100)).join(' | ')))`);
    }

    close() {
        return this.browser.send('Target.closeTarget', { targetId: this.targetId });
    }
}

/* The pixels of an 8-bit PNG without interlace: { width, height, channels, at(x, y) }. */
function decode(png) {
    const width = png.readUInt32BE(16);
    const height = png.readUInt32BE(20);
    const channels = png[25] === 6 ? 4 : 3;
    const parts = [];
    for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
        if (png.toString('latin1', at + 4, at + 8) === 'IDAT') {
            parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
        }
    }
    const raw = zlib.inflateSync(Buffer.concat(parts));
    const stride = width * channels;
    const pixels = Buffer.alloc(stride * height);
    for (let y = 0; y < height; y++) {
        const filter = raw[y * (stride + 1)];
        for (let x = 0; x < stride; x++) {
            const a = x >= channels ? pixels[y * stride + x - channels] : 0;
            const b = y > 0 ? pixels[(y - 1) * stride + x] : 0;
            const c = x >= channels && y > 0 ? pixels[(y - 1) * stride + x - channels] : 0;
            const p = a + b - c;
            const paeth = Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c) ? a : Math.abs(p - b) <= Math.abs(p - c) ? b : c;
            const guess = [0, a, b, (a + b) >> 1, paeth][filter];
            pixels[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
        }
    }
    return { width, height, channels, at: (x, y) => [...pixels.subarray(y * stride + x * channels, y * stride + x * channels + 3)] };
}

/* The share of pixels that are not white, and the share that differs between two pictures of one size. */
function inked(image) {
    let count = 0;
    for (let y = 0; y < image.height; y++) {
        for (let x = 0; x < image.width; x++) {
            count += image.at(x, y).some((v) => v < 250);
        }
    }
    return count / image.width / image.height;
}

function differs(a, b) {
    let count = 0;
    for (let y = 0; y < Math.min(a.height, b.height); y++) {
        for (let x = 0; x < Math.min(a.width, b.width); x++) {
            const p = a.at(x, y);
            const q = b.at(x, y);
            count += Math.abs(p[0] - q[0]) + Math.abs(p[1] - q[1]) + Math.abs(p[2] - q[2]) > 24;
        }
    }
    return count / a.width / a.height;
}

module.exports = { Browser, Page, decode, inked, differs };
