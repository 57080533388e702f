/* stage.js -- canvas, camera and what stands before it. */
const canvas = document.getElementById('canvas');
const stage = {
    renderer: null,
    scene: new THREE.Scene(),
    camera: new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100),
    orbit: null,
    surfaces: [],  /* by index: { mesh, outline, net, panels, group }, made when first shown */
    curves: new THREE.Group(),
    nodes: new THREE.Group(), /* where curves of a net cross */
    reactions: new THREE.Group(), /* forces on supports (arrows.js) */
    marks: new THREE.Group(), /* points and lines that say where: of a pick, of a claim (marks.js) */
    reach: [1, 1], /* of what is shown from the start, to the right and up from the middle */
    centre: new THREE.Vector3(),
    asked: false   /* is a picture on its way? */
};

/* Nets that cover what they belong to are off at first: those of pipes, wide ones, those of many patches or curves. */
const NET_MOST = 400;
const sizeOf = ({ net }) => net.nu * net.nv;
const coversAll = (model.certificate && model.certificate.construct === 'pipe') || model.surfaces.some((s) => sizeOf(s) > NET_MOST)
    || (!model.frames && model.surfaces.reduce((sum, s) => sum + sizeOf(s), 0) > 2 * NET_MOST)
    || model.curves.reduce((sum, c) => sum + sizeOf(c), 0) > NET_MOST;
const KNOTS_MOST = 12; /* lines of knots that are drawn without the net, which they belong to */

const shown = {
    colour: 'plain', net: !coversAll, reflections: false, isolines: false, panels: false, panelCount: 12,
    layout: 'together', frame: 0, hidden: new Set(),
    section: -1, sectionAt: 0, /* along an axis, 0 to 2, or none; -1 to 1 in the box of the model */
    reactions: false, measure: false
};

const LIGHTS = 12;
const ISOLINES = 10;
const APART_MAX = 12;

/* One picture at the next chance, however many ask. */
function draw() {
    if (!stage.asked && stage.renderer) {
        stage.asked = true;
        requestAnimationFrame(() => {
            stage.asked = false;
            render();
        });
    }
}

function render() {
    stage.renderer.render(stage.scene, stage.camera);
    drawOverlay();
    canvas.dataset.drawn = Number(canvas.dataset.drawn || 0) + 1;
}

function resize() {
    const width = canvas.parentElement.clientWidth;
    const height = canvas.parentElement.clientHeight;
    if (width === 0 || height === 0) {
        return;
    }
    stage.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    stage.renderer.setSize(width, height, false);
    pointScale.value = stage.renderer.getPixelRatio();
    const legend = document.getElementById('legend').offsetWidth; /* it stands at the right, beside the picture if it can */
    const free = legend > 0 && legend < 0.45 * width ? width - legend - 16 : width;
    const half = 1.12 * Math.max(stage.reach[1], stage.reach[0] * height / free);
    stage.camera.top = half;
    stage.camera.bottom = -half;
    stage.camera.left = -half * free / height;
    stage.camera.right = half * (2 * width - free) / height;
    stage.camera.updateProjectionMatrix();
    draw();
}

/* Azimuth and elevation in degrees, as in figures; z is up. */
function lookFrom(azimuth, elevation) {
    const a = azimuth * Math.PI / 180;
    const e = Math.min(Math.max(elevation, -89.99), 89.99) * Math.PI / 180;
    stage.camera.position.set(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e))
        .multiplyScalar(10).add(stage.centre);
    stage.orbit.target.copy(stage.centre);
    stage.orbit.update();
    draw();
}

function home() {
    stage.camera.zoom = 1;
    stage.camera.updateProjectionMatrix();
    lookFrom(model.view[0], model.view[1]);
}

/* Turns about the target by degrees. */
function turn(right, up) {
    const offset = stage.camera.position.clone().sub(stage.orbit.target);
    const azimuth = Math.atan2(offset.y, offset.x) * 180 / Math.PI;
    const elevation = Math.asin(offset.z / offset.length()) * 180 / Math.PI;
    const target = stage.orbit.target.clone();
    lookFrom(azimuth + right, elevation + up);
    stage.camera.position.add(target).sub(stage.centre);
    stage.orbit.target.copy(target);
    stage.orbit.update();
}

function zoom(factor) {
    stage.camera.zoom = Math.min(Math.max(stage.camera.zoom * factor, 0.1), 200);
    stage.camera.updateProjectionMatrix();
    draw();
}

function part(i) {
    if (!stage.surfaces[i]) {
        const packed = model.surfaces[i];
        const made = { group: new THREE.Group(), mesh: surfaceMesh(packed, colourIndex(i)), outline: outline(packed),
            net: netObject(packed.net), panels: null, panelKey: '', worst: 0,
            knots: packed.u.knots.length + packed.v.knots.length };
        made.group.add(made.mesh, made.outline, made.net);
        stage.surfaces[i] = made;
    }
    return stage.surfaces[i];
}

/* Frames are one surface that moves: they keep one colour. */
function colourIndex(i) {
    return model.frames ? 0 : model.surfaces[i].colour;
}

/* The surfaces that are shown now. */
function present() {
    const all = model.surfaces.map((_, i) => i);
    if (shown.layout === 'frames') {
        return all.slice(shown.frame, shown.frame + 1);
    }
    if (shown.layout === 'apart' && all.length > APART_MAX) {
        return Array.from({ length: APART_MAX }, (_, k) => Math.floor(k * (all.length - 1) / (APART_MAX - 1)));
    }
    return all.filter((i) => !shown.hidden.has('surface ' + i) && !isUnderCloth(i));
}

function updatePanels(made, i) {
    const key = shown.panelCount + ' ' + shown.colour + ' ' + flight.at;
    if (shown.panels && made.panelKey !== key && flight.at === flight.to) {
        if (made.panels) {
            made.group.remove(made.panels);
            disposeOf(made.panels);
        }
        const panels = panelObject(model.surfaces[i], colourIndex(i), shown.panelCount, shown.colour);
        made.panels = panels.object;
        made.worst = panels.worst;
        made.panelKey = key;
        made.group.add(made.panels);
    }
    if (made.panels) {
        made.panels.visible = shown.panels;
    }
}

/* Puts what is to be shown, as it is to be shown, before the camera. */
function refresh() {
    const list = present();
    const columns = shown.layout === 'apart' ? Math.ceil(Math.sqrt(list.length)) : 1;
    const rows = Math.ceil(list.length / columns);
    look.coloured.value = shown.colour !== 'plain';
    look.lights.value = shown.reflections ? LIGHTS : 0;
    look.isolines.value = shown.isolines ? ISOLINES : 0;
    stage.surfaces.forEach((made) => stage.scene.remove(made.group));
    list.forEach((i, k) => {
        const made = part(i);
        colourMesh(made.mesh, model.surfaces[i], shown.colour);
        made.mesh.visible = !shown.panels;
        made.outline.children.forEach((line, number) => { line.visible = number === 0 || (!shown.panels && (made.knots <= KNOTS_MOST || shown.net)); });
        made.net.visible = shown.net && (isFlat() || !pieces.includes(i));
        updatePanels(made, i);
        made.group.position.set(0, 0, 0);
        if (shown.layout === 'apart') { /* a grid across the view from the start */
            const [right, up] = axes();
            made.group.position.copy(right.multiplyScalar((k % columns - (columns - 1) / 2) * 2.2))
                .addScaledVector(up, ((rows - 1) / 2 - Math.floor(k / columns)) * 2.2);
        }
        stage.scene.add(made.group);
    });
    cut();
    stage.curves.visible = shown.layout === 'together';
    stage.nodes.visible = stage.curves.visible;
    stage.reactions.visible = stage.curves.visible && shown.reactions;
    stage.curves.children.forEach((group, i) => {
        group.visible = !shown.hidden.has('curve ' + i) && (isFlat() || !isCutLine(model.curves[i]));
        group.children[1].visible = shown.net;
    });
    draw();
    return list;
}

/* What lies beyond the section is not drawn; not where surfaces are moved apart. */
function cut() {
    const isCut = shown.section >= 0 && shown.layout !== 'apart';
    const normal = new THREE.Vector3(...[0, 1, 2].map((c) => c === shown.section ? -1 : 0));
    stage.renderer.clippingPlanes = isCut ? [{ normal: normal, constant: shown.sectionAt }] : [];
}

/* Right and up on the screen, from the start. */
function axes() {
    const a = model.view[0] * Math.PI / 180;
    const e = model.view[1] * Math.PI / 180;
    return [new THREE.Vector3(-Math.sin(a), Math.cos(a), 0),
        new THREE.Vector3(-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e))];
}

/* How far what is shown reaches, for the camera. */
function measure(list) {
    if (shown.layout === 'apart') {
        const columns = Math.ceil(Math.sqrt(list.length));
        stage.reach = [1.1 * columns, 1.1 * Math.ceil(list.length / columns)];
        stage.centre.set(0, 0, 0);
    } else {
        Object.assign(stage, reachOfList(list));
    }
    resize();
}

/* The surfaces, their nets, the curves and arrows, as they are seen from the start; of many frames some. */
function reachOfList(list) {
    const every = Math.ceil(model.surfaces.length / 20);
    const some = shown.layout === 'frames' ? model.surfaces.map((_, i) => i).filter((i) => i % every === 0) : list;
    return reachOf(some.flatMap((i) => [unpackSurface(model.surfaces[i]).points, unpackPoints(model.surfaces[i].net.points)])
        .concat(model.curves.map((curve) => unpackPoints(curve.points)), shown.reactions ? [arrowTails()] : []));
}

/* The camera sees as far as this, as it was turned and moved by hand. */
function adjust(reach, centre) {
    const moved = centre.clone().sub(stage.centre);
    stage.reach = reach;
    stage.centre.copy(centre);
    stage.camera.position.add(moved);
    stage.orbit.target.add(moved);
    stage.orbit.update();
    resize();
}

/* How far lists of points reach on the screen, and their middle. */
function reachOf(lists) {
    const [right, up] = axes();
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    lists.forEach((points) => {
        for (let k = 0; k < points.length; k += 3) {
            [right, up].forEach((axis, c) => {
                const at = points[k] * axis.x + points[k + 1] * axis.y + points[k + 2] * axis.z;
                low[c] = Math.min(low[c], at);
                high[c] = Math.max(high[c], at);
            });
        }
    });
    const centre = new THREE.Vector3();
    if (high[0] >= low[0]) {
        centre.addScaledVector(right, (low[0] + high[0]) / 2).addScaledVector(up, (low[1] + high[1]) / 2);
    }
    return { reach: [0, 1].map((c) => high[c] > low[c] ? Math.max((high[c] - low[c]) / 2, 0.05) : 1), centre: centre };
}

/* Light or dark, all that is drawn. */
function setPaper() {
    stage.renderer.setClearColor(new THREE.Color().setRGB(...rgb(papers[isDark ? 1 : 0]).toArray(), 'srgb-linear'), 1);
    lineMaterials.forEach(inkLine);
    draw();
}

function setStage() {
    stage.renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true });
    stage.renderer.outputColorSpace = 'srgb-linear'; /* the colours are those of the screen already */
    stage.camera.up.set(0, 0, 1);
    stage.orbit = new THREE.OrbitControls(stage.camera, canvas);
    stage.orbit.addEventListener('change', draw);
    model.curves.forEach((curve, i) => {
        const group = new THREE.Group();
        group.add(curveObject(curve), netObject(curve.net));
        stage.curves.add(group);
    });
    if (model.nodes.names.length > 0) {
        stage.nodes.add(pointsObject(unpackPoints(model.nodes.points), 251));
    }
    if (reactions.length > 0) {
        stage.reactions.add(arrowsObject());
    }
    stage.scene.add(stage.curves, stage.nodes, stage.reactions, stage.marks);
    new ResizeObserver(() => {
        resize();
        render(); /* now: the canvas is white since its size was set, and this frame is about to be shown */
    }).observe(canvas.parentElement);
}
