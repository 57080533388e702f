/* controls.js -- what a person can change, by pointer, finger or key. */
const byId = (id) => document.getElementById(id);

const headings = {
    H: ['Mean curvature H', '1/', ''],
    K: ['Gaussian curvature K', '1/', '²'],
    I: ['Isothermality, 0 where isothermal', '', ''],
    G: ['Gap to the least area, 0 where none', '', ''],
    S: ['Strain of the cloth, beyond the compensation', '', ''],
    U: ['Stress along the warp (u)', 'force per ', ''],
    V: ['Stress along the weft (v)', 'force per ', '']
};

/* A round step of 1, 2 or 5 that gives two to five ticks to the limit. */
function tickStep(limit) {
    const power = 10 ** Math.floor(Math.log10(limit));
    const first = limit / power;
    return power * (first < 2 ? 0.5 : first < 5 ? 1 : 2);
}

/* Where the scale begins and ends, in its limit: values of one sign take one arm of it. */
function legendEnds() {
    const sign = model.sign[fieldNames.indexOf(shown.colour)];
    return [sign > 0 ? 0 : -1, sign < 0 ? 0 : 1];
}

/* The colours of the scale, from its upper end. */
function legendColours() {
    const [from, to] = legendEnds();
    return model.map.slice(16 + 16 * from, 17 + 16 * to).reverse();
}

function fillLegend() {
    const legend = byId('legend');
    legend.hidden = shown.colour === 'plain' || model.surfaces.length === 0;
    if (legend.hidden) {
        return;
    }
    const k = fieldNames.indexOf(shown.colour);
    const limit = model.limits[k];
    const [from, to] = legendEnds();
    const [name, over, power] = headings[shown.colour];
    const colours = legendColours().map(css);
    const title = name + (over ? ', ' + over + model.unit + power : '') + (model.cut[k] ? '; ends: beyond' : '');
    byId('legend-title').textContent = title;
    byId('legend-bar').style.background = 'linear-gradient(' + colours.join(',') + ')';
    const ticks = byId('legend-ticks');
    const step = tickStep(limit);
    ticks.replaceChildren();
    for (let i = from * Math.floor(limit / step + 1e-9); i <= to * Math.floor(limit / step + 1e-9); i++) {
        const item = element('li', show(Number((i * step).toPrecision(3))));
        item.style.top = (100 - 100 * (i * step / limit - from) / (to - from)) + '%';
        ticks.append(item);
    }
    legend.setAttribute('aria-label', title + ', from ' + show(from * limit) + ' to ' + show(to * limit));
}

/* Worst flatness of the panels that are shown. */
function fillPanels(list) {
    byId('panel-row').hidden = !shown.panels;
    byId('panel-number').textContent = shown.panelCount;
    const worst = list.reduce((most, i) => Math.max(most, stage.surfaces[i].worst), 0);
    byId('panel-note').textContent = shown.panels && list.length > 0
        ? 'Least flat panel: its diagonals pass at ' + show(Number((100 * worst).toPrecision(3))) + ' % of their length.' : '';
}

function fillFrame() {
    const count = model.surfaces.length;
    const packed = model.surfaces[shown.frame];
    byId('frames').hidden = shown.layout !== 'frames';
    byId('frame').value = shown.frame;
    byId('frame').setAttribute('aria-valuetext', (shown.frame + 1) + ' of ' + count);
    byId('frame-name').textContent = (shown.frame + 1) + ' / ' + count + (packed && packed.name ? ' ' + packed.name : '');
}

/* Where the section is, said in the model's unit. */
function fillSection() {
    byId('section').disabled = shown.layout === 'apart';
    byId('section').value = shown.section;
    byId('section-at').hidden = byId('section-number').hidden = shown.section < 0 || shown.layout === 'apart';
    byId('section-at').value = shown.sectionAt;
    if (shown.section >= 0) {
        const text = 'xyz'[shown.section] + ' = ' + showLength(model.centre[shown.section] + model.half * shown.sectionAt) + ' ' + model.unit;
        byId('section-number').textContent = text;
        byId('section-at').setAttribute('aria-valuetext', text);
    }
}

const views = { front: [-90, 0], right: [0, 0], top: [-90, 90], iso: [-45, 35.264] };

function change(values) {
    if (values.layout !== undefined || values.frame !== undefined) {
        letGo();
    }
    Object.assign(shown, values);
    const list = refresh();
    if (values.layout !== undefined) {
        measure(list);
        home();
    } else if (values.reactions !== undefined && shown.layout === 'together') {
        const { reach, centre } = reachOfList(list);
        adjust(reach, centre);
    }
    byId('net').checked = shown.net;
    byId('reflections').checked = shown.reflections;
    byId('isolines').checked = shown.isolines;
    byId('panels').checked = shown.panels;
    byId('measure').checked = shown.measure;
    byId('reactions').checked = shown.reactions;
    byId('reaction-note').textContent = shown.reactions ? 'The longest arrow is a force of ' + show(Number(strongest.toPrecision(3))) + '.' : '';
    fillSection();
    document.querySelector('[name=colour][value=' + shown.colour + ']').checked = true;
    document.querySelector('[name=layout][value=' + shown.layout + ']').checked = true;
    byId('list').hidden = byId('list').dataset.any !== '1' || shown.layout !== 'together';
    fillLegend();
    if (values.colour !== undefined) {
        resize();
    }
    fillPanels(list);
    fillFrame();
    byId('layout-note').textContent = shown.layout === 'apart' && list.length < model.surfaces.length
        ? list.length + ' of ' + model.surfaces.length + ' are shown.' : '';
}

let player = 0;
const FRAME_MS = matchMedia('(prefers-reduced-motion: reduce)').matches ? 1000 : 80;

function play(on) {
    clearInterval(player);
    player = on ? setInterval(() => change({ frame: (shown.frame + 1) % model.surfaces.length }), FRAME_MS) : 0;
    byId('play').textContent = on ? 'Stop' : 'Play';
    byId('play').setAttribute('aria-pressed', String(on));
}

function step(by) {
    const count = model.surfaces.length;
    if (shown.layout === 'frames') {
        play(false);
        change({ frame: (shown.frame + by + count) % count });
    }
}

const hasGap = model.surfaces.some((s) => s.G !== undefined);
const hasStress = model.surfaces.some((s) => s.U !== undefined);
const colours = ['plain', 'H', 'K', 'I'].concat(hasGap ? ['G'] : [], hasStrain ? ['S'] : [], hasStress ? ['U', 'V'] : []);
const keys = {
    ArrowLeft: () => turn(-6, 0),
    ArrowRight: () => turn(6, 0),
    ArrowUp: () => turn(0, 6),
    ArrowDown: () => turn(0, -6),
    '+': () => zoom(1.2),
    '=': () => zoom(1.2),
    '-': () => zoom(1 / 1.2),
    0: home,
    Home: home,
    n: () => change({ net: !shown.net }),
    r: () => change({ reflections: !shown.reflections }),
    l: () => change({ isolines: !shown.isolines }),
    p: () => change({ panels: !shown.panels }),
    a: () => { if (reactions.length > 0) change({ reactions: !shown.reactions }); },
    c: () => change({ colour: colours[(colours.indexOf(shown.colour) + 1) % colours.length] }),
    1: () => lookFrom(...views.front),
    2: () => lookFrom(...views.right),
    3: () => lookFrom(...views.top),
    4: () => lookFrom(...views.iso),
    x: () => change({ section: shown.section < 2 ? shown.section + 1 : -1 }),
    m: () => change({ measure: !shown.measure }),
    o: () => { if (hasStrain) mount(flight.to === 0); },
    s: savePicture,
    f: fullScreen,
    d: () => setDark(!isDark),
    Enter: () => pickAt(canvas.clientWidth / 2, canvas.clientHeight / 2),
    Escape: letGo,
    ',': () => step(-1),
    '.': () => step(1),
    ' ': () => { if (shown.layout === 'frames') play(player === 0); }
};

/* A box for each part of a model that has some, but not hundreds. */
function fillParts() {
    const parts = model.surfaces.map((s, i) => ['surface ' + i, s.name || 'surface ' + (i + 1), plainColour(colourIndex(i))])
        .concat(model.curves.map((c, i) => ['curve ' + i, curveLabel(c, i), curveColour(c)]));
    if (parts.length < 2 || parts.length > 40) {
        return;
    }
    byId('list').dataset.any = '1';
    for (const [key, name, colour] of parts) {
        const label = element('label');
        const box = element('input');
        const swatch = element('span', '■ ');
        box.type = 'checkbox';
        box.checked = true;
        swatch.style.color = css(colour);
        swatch.setAttribute('aria-hidden', 'true');
        box.addEventListener('change', () => {
            shown.hidden[box.checked ? 'delete' : 'add'](key);
            change({});
        });
        label.append(box, swatch, name);
        byId('list').append(label);
    }
}

function setControls() {
    for (const id of ['net', 'reflections', 'isolines', 'panels', 'reactions', 'measure']) {
        byId(id).addEventListener('change', (event) => change({ [id]: event.target.checked }));
    }
    for (const name of ['colour', 'layout']) {
        document.querySelectorAll('[name=' + name + ']').forEach((radio) =>
            radio.addEventListener('change', () => change({ [name]: radio.value })));
    }
    byId('panel-count').addEventListener('input', (event) => change({ panelCount: Number(event.target.value) }));
    byId('frame').max = Math.max(model.surfaces.length - 1, 0);
    byId('frame').addEventListener('input', (event) => { play(false); change({ frame: Number(event.target.value) }); });
    byId('play').addEventListener('click', () => play(player === 0));
    byId('home').addEventListener('click', home);
    document.querySelectorAll('[data-view]').forEach((button) => button.addEventListener('click', () => lookFrom(...views[button.dataset.view])));
    byId('section').addEventListener('change', (event) => change({ section: Number(event.target.value) }));
    byId('section-at').addEventListener('input', (event) => change({ sectionAt: Number(event.target.value) }));
    byId('dark').addEventListener('click', () => setDark(!isDark));
    setPicking();
    setSaving();
    byId('layout').hidden = model.surfaces.length < 2;
    document.querySelectorAll('form').forEach((form) => form.addEventListener('submit', (event) => event.preventDefault()));
    canvas.addEventListener('keydown', (event) => {
        const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (act && !event.ctrlKey && !event.metaKey && !event.altKey) {
            act();
            event.preventDefault();
        }
    });
    byId('gap-choice').hidden = !hasGap;
    byId('warp-choice').hidden = byId('weft-choice').hidden = !hasStress;
    byId('reaction-choice').hidden = reactions.length === 0;
    byId('strain-choice').hidden = byId('cloth').hidden = !hasStrain;
    document.querySelectorAll('[name=cloth]').forEach((radio) => radio.addEventListener('change', () => mount(radio.value === 'mounted')));
    fillParts();
}
