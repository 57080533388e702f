/* pick.js -- what is under the pointer: its name while it moves; at a click the parameters, the point, the curvatures and
 * the normal; from point to point the distance. Values are those of the samples of the page, linear between them. */

/* A surface's samples on the screen, in pixels, and their depth. */
function project(points, position) {
    const out = new Float32Array(points.length);
    const at = new THREE.Vector3();
    for (let k = 0; k < points.length; k += 3) {
        at.set(points[k], points[k + 1], points[k + 2]).add(position).project(stage.camera);
        out[k] = (at.x + 1) / 2 * canvas.clientWidth;
        out[k + 1] = (1 - at.y) / 2 * canvas.clientHeight;
        out[k + 2] = at.z;
    }
    return out;
}

const isCutAway = (p) => shown.section >= 0 && shown.layout !== 'apart' && p[shown.section] > shown.sectionAt;

/* The nearest triangle of a surface under (x, y): { depth, corners, weights }, or null. */
function hitSurface(i, x, y) {
    const grid = unpackSurface(model.surfaces[i]);
    const seen = project(grid.points, stage.surfaces[i].group.position);
    const list = cells(grid.nu, grid.nv).array;
    let best = null;
    for (let k = 0; k < list.length; k += 3) {
        const a = 3 * list[k];
        const b = 3 * list[k + 1];
        const c = 3 * list[k + 2];
        const twice = (seen[b] - seen[a]) * (seen[c + 1] - seen[a + 1]) - (seen[c] - seen[a]) * (seen[b + 1] - seen[a + 1]);
        const s = ((x - seen[a]) * (seen[c + 1] - seen[a + 1]) - (seen[c] - seen[a]) * (y - seen[a + 1])) / twice;
        const t = ((seen[b] - seen[a]) * (y - seen[a + 1]) - (x - seen[a]) * (seen[b + 1] - seen[a + 1])) / twice;
        if (!(s >= -1e-9 && t >= -1e-9 && s + t <= 1 + 1e-9)) {
            continue;
        }
        const weights = [1 - s - t, s, t];
        const depth = weights[0] * seen[a + 2] + s * seen[b + 2] + t * seen[c + 2];
        const corners = [a / 3, b / 3, c / 3];
        if ((best === null || depth < best.depth) && !isCutAway(mix(grid.points, 3, corners, weights))) {
            best = { depth: depth, corners: corners, weights: weights };
        }
    }
    return best;
}

function mix(list, size, corners, weights) {
    return Array.from({ length: size }, (_, c) => weights.reduce((sum, w, k) => sum + w * list[size * corners[k] + c], 0));
}

/* What is seen at (x, y): { index, hit }, or null. */
function pick(x, y) {
    return present().reduce((best, index) => {
        const hit = hitSurface(index, x, y);
        return hit && (best === null || hit.depth < best.hit.depth) ? { index: index, hit: hit } : best;
    }, null);
}

const NEAR = 6; /* pixels */

/* The curve that passes nearest to (x, y), or -1. */
function pickCurve(x, y) {
    let best = NEAR;
    let found = -1;
    stage.curves.children.forEach((group, i) => {
        if (!group.visible || !stage.curves.visible) {
            return;
        }
        const seen = project(unpackPoints(model.curves[i].points), group.position);
        for (let k = 0; k + 5 < seen.length; k += 3) {
            const d = [seen[k + 3] - seen[k], seen[k + 4] - seen[k + 1]];
            const s = Math.min(Math.max(((x - seen[k]) * d[0] + (y - seen[k + 1]) * d[1]) / Math.max(d[0] * d[0] + d[1] * d[1], 1e-9), 0), 1);
            const far = Math.hypot(x - seen[k] - s * d[0], y - seen[k + 1] - s * d[1]);
            if (far < best) {
                best = far;
                found = i;
            }
        }
    });
    return found;
}

/* A curve's name; of a lath how much of its strength is used, too. */
function curveLabel(curve, i) {
    const name = curve.name || 'curve ' + (i + 1);
    return curve.use === undefined ? name : name + ', ' + curve.use.toFixed(2) + ' of its strength';
}

/* A length or coordinate to the digits that the page has of it. */
function showLength(x) {
    const digits = 4 - Math.floor(Math.log10(model.half));
    return digits > 9 ? show(Number(x.toPrecision(4))) : x.toFixed(Math.max(digits, 0)).replace('-', '−');
}

function showField(name, share) {
    const limit = model.limits[fieldNames.indexOf(name)];
    return share > 2 ? 'none' : Math.abs(share) > 1 ? 'beyond ' + show(Math.sign(share) * limit) : show(Number((share * limit).toPrecision(4)));
}

/* All that is known of a hit: { name, place (in the cube, of the picture), point, rows }. */
function describe(found) {
    const packed = model.surfaces[found.index];
    const grid = unpackSurface(packed);
    const { corners, weights } = found.hit;
    const local = mix(grid.points, 3, corners, weights);
    const point = local.map((x, c) => model.centre[c] + model.half * x);
    const normal = new THREE.Vector3(...mix(grid.normals, 3, corners, weights)).normalize();
    const parameter = (list, lines, line) => {
        const share = weights.reduce((sum, w, k) => sum + w * list[line(corners[k])], 0);
        return lines.range[0] + share * (lines.range[1] - lines.range[0]);
    };
    const round = (x) => show(Number(x.toPrecision(4)));
    const rows = [['u', round(parameter(grid.u, packed.u, (k) => Math.floor(k / grid.nv)))], ['v', round(parameter(grid.v, packed.v, (k) => k % grid.nv))]]
        .concat(['x', 'y', 'z'].map((name, c) => [name, showLength(point[c]) + ' ' + model.unit]),
            [['H', 'H', '1/' + model.unit], ['K', 'K', '1/' + model.unit + '²'], ['I', 'isothermality', ''], ['G', 'gap', ''], ['S', 'strain', ''], ['U', 'warp stress', '1/' + model.unit], ['V', 'weft stress', '1/' + model.unit]]
                .filter(([name]) => grid.fields[name]).map(([name, label, unit]) => {
                    const field = grid.fields[name];
                    const isNone = corners.some((k) => field[k] > 2);
                    const text = showField(name, isNone ? 9 : mix(field, 1, corners, weights)[0]);
                    return [label, text + (text === 'none' ? '' : ' ' + unit)];
                }),
            [['normal', normal.toArray().map((x) => x.toFixed(3).replace('-', '−')).join(' ')]]);
    return { name: packed.name || 'surface ' + (found.index + 1), place: new THREE.Vector3(...local).add(stage.surfaces[found.index].group.position), point: point, rows: rows };
}

/* The box at the upper left: a heading and lines of name and value. */
function fillProbe(name, rows) {
    document.getElementById('probe-name').textContent = name;
    document.getElementById('probe-list').replaceChildren(...rows.flatMap(([key, value]) => [element('dt', key), element('dd', value, key === 'where' ? '' : 'number')]));
    document.getElementById('probe').hidden = false;
}

const probe = { from: null, last: null }; /* last: what was described last, for tests and for the next click */

function letGo() {
    probe.from = probe.last = null;
    document.getElementById('probe').hidden = true;
    document.querySelectorAll('.place[aria-pressed=true]').forEach((button) => button.setAttribute('aria-pressed', 'false'));
    setMarks([], []);
}

/* A click, or Enter. */
function pickAt(x, y) {
    const found = pick(x, y);
    const from = shown.measure ? probe.from : null;
    letGo();
    if (!found) {
        return;
    }
    const to = describe(found);
    if (from) {
        const d = to.point.map((value, c) => value - from.point[c]);
        setMarks([...from.place, ...to.place], shown.layout === 'apart' ? [] : [[...from.place, ...to.place]]);
        fillProbe('from ' + from.name + ' to ' + to.name, [['distance', showLength(Math.hypot(...d)) + ' ' + model.unit]]
            .concat(['x', 'y', 'z'].map((name, c) => ['along ' + name, showLength(d[c]) + ' ' + model.unit])));
    } else {
        probe.from = to;
        setMarks([...to.place], []);
        fillProbe(to.name, to.rows);
    }
}

/* The name of the node nearest to (x, y), or ''. */
function pickNode(x, y) {
    let best = NEAR;
    let name = '';
    const seen = stage.nodes.visible ? project(unpackPoints(model.nodes.points), stage.nodes.position) : [];
    for (let k = 0; k < seen.length; k += 3) {
        const far = Math.hypot(x - seen[k], y - seen[k + 1]);
        if (far < best) {
            best = far;
            name = model.nodes.names[k / 3];
        }
    }
    return name;
}

/* The name of what is under the pointer, beside it: a node's, a curve's, a surface's. */
function hover(x, y) {
    const note = document.getElementById('hover');
    const node = pickNode(x, y);
    const curve = node === '' ? pickCurve(x, y) : -1;
    const found = node === '' && curve < 0 ? pick(x, y) : null;
    const name = node !== '' ? node : curve >= 0 ? curveLabel(model.curves[curve], curve) : found ? model.surfaces[found.index].name || 'surface ' + (found.index + 1) : '';
    note.hidden = name === '';
    note.textContent = name;
    note.style.left = Math.min(x + 14, canvas.clientWidth - note.offsetWidth - 4) + 'px';
    note.style.top = Math.min(y + 16, canvas.clientHeight - note.offsetHeight - 4) + 'px';
}

const CLICK = 4; /* pixels that a hand may shake between press and release */

function setPicking() {
    let press = null;
    let isAsked = false;
    const placeOfEvent = (event) => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener('pointerdown', (event) => { press = event.isPrimary && event.button === 0 ? placeOfEvent(event) : null; });
    canvas.addEventListener('pointerup', (event) => {
        const [x, y] = placeOfEvent(event);
        if (press && Math.hypot(x - press[0], y - press[1]) <= CLICK) {
            pickAt(x, y);
        }
        press = null;
    });
    canvas.addEventListener('pointermove', (event) => {
        const [x, y] = placeOfEvent(event);
        if (event.buttons !== 0 || event.pointerType === 'touch') {
            document.getElementById('hover').hidden = true;
        } else if (!isAsked) { /* once a picture at the most */
            isAsked = true;
            requestAnimationFrame(() => {
                isAsked = false;
                hover(x, y);
            });
        }
    });
    canvas.addEventListener('pointerleave', () => { document.getElementById('hover').hidden = true; });
    document.getElementById('probe-close').addEventListener('click', () => {
        letGo();
        canvas.focus();
    });
}
