/* save.js -- out of the page: the picture with its scales, the model, paper. */
function give(blob, name) {
    const link = element('a');
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/* A name that every system takes for a file. */
function fileName(ending) {
    return (document.getElementById('title').textContent.replace(/[^\w.-]+/g, '-').replace(/^[-.]+|-+$/g, '').slice(0, 60) || 'taut') + ending;
}

function drawScaleBar(ink, height) {
    const [length, pixels] = scaleBar();
    ink.fillRect(18, height - 22, pixels, 2);
    ink.fillRect(18, height - 26, 2, 10);
    ink.fillRect(16 + pixels, height - 26, 2, 10);
    ink.fillText(show(Number(length.toPrecision(3))) + ' ' + model.unit, 24 + pixels, height - 17);
}

function drawAxes(ink, height) {
    ink.lineWidth = 1.5;
    axesOnScreen().forEach(([x, y], c) => {
        const at = [46, height - 78];
        const length = Math.max(Math.hypot(x, y), 1e-9);
        ink.beginPath();
        ink.moveTo(...at);
        ink.lineTo(at[0] + AXIS * x, at[1] + AXIS * y);
        ink.stroke();
        ink.fillText('xyz'[c], at[0] + AXIS * x + 8 * x / length - 4, at[1] + AXIS * y + 8 * y / length + 4);
    });
}

/* The legend as it lies over the picture. */
function drawLegend(ink, width) {
    const legend = document.getElementById('legend');
    if (legend.hidden) {
        return;
    }
    const list = [...document.querySelectorAll('#legend-ticks li')];
    const left = width - 90;
    legendColours().forEach((colour, k, all) => {
        ink.fillStyle = css(colour);
        ink.fillRect(left, 60 + 208 * k / all.length, 18, 208 / all.length + 1);
    });
    ink.fillStyle = css(inks.edge[isDark ? 1 : 0]);
    ink.textAlign = 'right';
    ink.fillText(document.getElementById('legend-title').textContent, width - 16, 40);
    ink.textAlign = 'left';
    list.forEach((item) => ink.fillText(item.textContent, left + 26, 64 + 2.08 * parseFloat(item.style.top)));
}

/* What is seen, with title, scale and legend, on a canvas of its own. */
function composed() {
    const ratio = stage.renderer.getPixelRatio();
    const page = element('canvas');
    const ink = page.getContext('2d');
    page.width = canvas.width;
    page.height = canvas.height;
    render(); /* now: what is on the canvas is gone after the frame */
    ink.drawImage(canvas, 0, 0);
    ink.scale(ratio, ratio);
    ink.fillStyle = ink.strokeStyle = css(inks.edge[isDark ? 1 : 0]);
    ink.font = '14px system-ui, "DejaVu Sans", sans-serif';
    ink.fillText(document.getElementById('title').textContent.slice(0, 80), 16, 26);
    drawScaleBar(ink, canvas.clientHeight);
    drawAxes(ink, canvas.clientHeight);
    drawLegend(ink, canvas.clientWidth);
    return page;
}

function savePicture() {
    composed().toBlob((blob) => give(blob, fileName('.png')));
}

/* The document that the page carries: in the page every < is \u003c. */
function documentText() {
    return document.getElementById('document').textContent.replace(/\\(?:u003c|[^])/g, (found) => found === '\\u003c' ? '<' : found);
}

function setSaving() {
    const text = documentText();
    document.getElementById('download').hidden = text === '';
    document.getElementById('download').addEventListener('click', () => give(new Blob([text], { type: 'application/json' }), fileName('.json')));
    document.getElementById('save').addEventListener('click', savePicture);
    document.getElementById('full').hidden = !document.fullscreenEnabled;
    document.getElementById('full').addEventListener('click', fullScreen);
    window.addEventListener('beforeprint', () => { /* a canvas is blank on paper: its picture is not */
        const wasDark = isDark;
        setDark(false);
        document.getElementById('paper').src = composed().toDataURL();
        setDark(wasDark);
    });
}

function fullScreen() {
    if (document.fullscreenElement) {
        document.exitFullscreen();
    } else {
        document.getElementById('stage').requestFullscreen().catch(() => 0);
    }
}

function setDark(on) {
    isDark = on;
    document.documentElement.classList.toggle('dark', on);
    document.getElementById('dark').setAttribute('aria-pressed', String(on));
    setPaper();
}
