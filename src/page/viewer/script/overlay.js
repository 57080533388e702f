/* overlay.js -- what lies over the picture: the cross of the axes, the scale bar. */
const SVG = 'http://www.w3.org/2000/svg';
const cross = document.getElementById('cross');
const AXIS = 24; /* pixels */

/* Where the axes point on the screen: [x, y, depth] each, y down. */
function axesOnScreen() {
    const e = stage.camera.matrixWorldInverse.elements;
    return [0, 1, 2].map((c) => [e[4 * c], -e[4 * c + 1], e[4 * c + 2]]);
}

function drawCross() {
    if (cross.childNodes.length === 0) {
        ['x', 'y', 'z'].forEach((name) => {
            const text = document.createElementNS(SVG, 'text');
            text.textContent = name;
            cross.append(document.createElementNS(SVG, 'line'), text);
        });
    }
    axesOnScreen().forEach(([x, y, depth], c) => {
        const line = cross.childNodes[2 * c];
        line.setAttribute('x2', AXIS * x);
        line.setAttribute('y2', AXIS * y);
        line.style.opacity = cross.childNodes[2 * c + 1].style.opacity = depth < -0.05 ? 0.55 : 1; /* away from the eye */
        const length = Math.max(Math.hypot(x, y), 1e-9); /* an axis towards the eye is named beside its point */
        cross.childNodes[2 * c + 1].setAttribute('x', AXIS * x + 8 * (length < 0.1 ? -1 : x / length));
        cross.childNodes[2 * c + 1].setAttribute('y', AXIS * y + 8 * (length < 0.1 ? 1 : y / length) + 4);
    });
}

/* How long a pixel is, in the model's unit: the view is orthographic, the same everywhere. */
function pixelLength() {
    return (stage.camera.top - stage.camera.bottom) / stage.camera.zoom / canvas.clientHeight * model.half;
}

const SCALE_LEAST = 60; /* pixels */

/* The shortest of 1, 2, 5 times a power of ten that is long enough: [length, pixels]. */
function scaleBar() {
    const least = SCALE_LEAST * pixelLength();
    const power = 10 ** Math.floor(Math.log10(least));
    const length = [1, 2, 5, 10].find((m) => m * power >= least * (1 - 1e-9)) * power;
    return [length, length / pixelLength()];
}

function drawOverlay() {
    const bar = document.getElementById('scale');
    const [length, pixels] = scaleBar();
    bar.hidden = !Number.isFinite(length);
    if (!bar.hidden) {
        bar.firstChild.style.width = pixels + 'px';
        const text = show(Number(length.toPrecision(3))) + ' ' + model.unit;
        if (bar.lastChild.textContent !== text) {
            bar.lastChild.textContent = text;
            bar.setAttribute('aria-label', 'Scale: ' + text);
        }
    }
    drawCross();
}
