/* certificate.js -- what was proved and decided, as text. Text of the document only ever becomes textContent. */
function element(name, text, className) {
    const made = document.createElement(name);
    if (text !== undefined) {
        made.textContent = text;
    }
    if (className) {
        made.className = className;
    }
    return made;
}

function verdictText(holds, isSaved) {
    return (holds === true ? 'yes' : holds === false ? 'no' : 'undecided') + (isSaved ? ', as saved' : '');
}

/* One sentence on all claims; what was read and not proved since is not told as proved. */
function verdictSentence(certificate, count, saved) {
    const whole = certificate.holds === true ? 'all claims hold' : certificate.holds === false ? 'not all claims hold' : 'undecided';
    if (saved.size === 0) {
        return whole + '.';
    }
    return saved.size < count ? whole + '; those marked are as saved, not proved again.'
        : 'as saved, not proved again: ' + whole + '.';
}

const SHOWN_MOST = 60; /* entries of one list or claims: more are counted */

/* What numbers of records are measured in: powers of the model's unit, as in src/cli/unit.c. */
const POWERS = new Map(Object.entries({
    '1': 'length lengths curve_length unstressed total_length seam_length radius bend_radius least_bend_radius wall distance ' +
        'boundary_gap max_gap gap_bound bounding_box largest_radius point du dv duu duv dvv d1 d2 d3',
    '2': 'area areas area_error dirichlet_area flat_area surface_area lower_bound gap',
    '3': 'volume volumes wall_volume',
    '-1': 'curvature torsion max_curvature mean_curvature max_torsion max_abs_normal_curvature mean_abs_mean_curvature ' +
        'rms_mean_curvature max_abs_mean_curvature',
    '-2': 'gaussian_curvature',
}).flatMap(([power, words]) => words.split(' ').map((word) => [word, Number(power)])));

/* Films and cloth, whose certificates have an energy, call what has no unit of length by these. */
const WITHOUT_LENGTH = ['gap', 'lower_bound', 'mean_curvature', 'curvature'];

/* The gap to a bound of an area is an area, the one between pieces on a roll a length; others are shares. */
function powerOf(key, record) {
    return key !== 'gap' || 'lower_bound' in record ? POWERS.get(key) : 'waste' in record ? 1 : undefined;
}

/* " mm²", or nothing: of a number, or a list of them, that a record calls so. */
function unitText(key, value, record) {
    const power = powerOf(key, record);
    const isNumeric = typeof value === 'number' || Array.isArray(value) && value.flat(2).every((x) => typeof x === 'number') && value.length > 0;
    if (power === undefined || !isNumeric || 'energy' in record && WITHOUT_LENGTH.includes(key)) {
        return '';
    }
    return ' ' + (power < 0 ? '1/' : '') + model.unit + ['', '', '\u00b2', '\u00b3'][Math.abs(power)];
}

/* A value of a record: numbers and words in a line, objects as lists of their own. */
function valueElement(value) {
    if (Array.isArray(value)) {
        if (value.every((x) => x === null || typeof x !== 'object')) {
            const text = value.slice(0, SHOWN_MOST).map((x) => show(x)).join(', ');
            return element('dd', value.length > SHOWN_MOST ? text + ' … (' + value.length + ')' : text);
        }
        const holder = element('dd');
        value.slice(0, SHOWN_MOST).forEach((x) => holder.append(...[valueElement(x)].map((d) => {
            const line = element('div');
            line.append(...d.childNodes);
            return line;
        })));
        if (value.length > SHOWN_MOST) {
            holder.append(element('div', '… (' + value.length + ')'));
        }
        return holder;
    }
    if (value !== null && typeof value === 'object') {
        const holder = element('dd');
        const list = element('dl');
        fillList(list, value);
        holder.append(list);
        return holder;
    }
    return element('dd', show(value), typeof value === 'number' ? 'number' : '');
}

function fillList(list, object) {
    for (const [key, value] of Object.entries(object)) {
        const shown = valueElement(value);
        shown.append(unitText(key, value, object));
        shown.normalize(); /* one line of text */
        list.append(element('dt', key.replaceAll('_', ' ')), shown);
    }
}

/* The claim's name; where the picture can show its place, a button that does. */
function claimHead(claim) {
    const place = placeOf(claim.where || '', model.surfaces, model.curves);
    const head = element('th', place ? undefined : claim.claim);
    head.scope = 'row';
    if (place) {
        const button = element('button', claim.claim, 'place');
        button.type = 'button';
        button.title = 'show the place: ' + claim.where;
        button.setAttribute('aria-pressed', 'false');
        button.addEventListener('click', () => showClaim(button, claim, place));
        head.append(button);
    }
    if (claim.kind) {
        head.append(element('small', claim.kind));
    }
    return head;
}

function fillCertificate() {
    const certificate = model.certificate;
    const verdict = document.getElementById('verdict');
    if (!certificate) {
        verdict.textContent = 'The model carries none.';
    } else {
        const claims = certificate.claims || [];
        const body = document.querySelector('#claims tbody');
        const saved = new Set(model.saved || []);
        const isProved = saved.size < claims.length || claims.length === 0;
        verdict.textContent = (certificate.construct ? certificate.construct + ': ' : '') + verdictSentence(certificate, claims.length, saved);
        verdict.className = certificate.holds === true && isProved ? 'yes' : certificate.holds === false ? 'no' : '';
        claims.slice(0, SHOWN_MOST).forEach((claim, i) => {
            const line = element('tr');
            const head = claimHead(claim);
            line.append(head, element('td', show(claim.residual, 3), 'number'), element('td', show(claim.limit, 3), 'number'),
                element('td', verdictText(claim.holds, saved.has(i)), claim.holds === false ? 'no' : claim.holds === true && !saved.has(i) ? 'yes' : ''));
            line.title = claim.where || '';
            body.append(line);
        });
        if (claims.length > SHOWN_MOST) {
            const cell = element('td', '… ' + claims.length + ' claims in all; the model’s file has them.');
            const line = element('tr');
            cell.colSpan = 4;
            line.append(cell);
            body.append(line);
        }
        document.getElementById('claims').hidden = claims.length === 0;
        if (certificate.figures) {
            document.getElementById('figures-title').hidden = false;
            fillList(document.getElementById('figures'), certificate.figures);
        }
    }
    if (model.details) {
        document.getElementById('details-title').hidden = false;
        fillList(document.getElementById('details'), model.details);
    }
    if (documentText() === '') {
        model.dropped.push('The model is too large to be carried by its page; its file has it.');
    }
    model.dropped.forEach((text) => document.getElementById('dropped').append(element('li', text)));
}

/* Name and size of what is shown, for people and for screen readers. */
function fillHead() {
    const first = model.surfaces[0] || model.curves[0];
    const construct = model.certificate && model.certificate.construct;
    const title = model.title || construct || (first && first.name) || 'taut';
    const parts = [];
    if (model.surfaces.length === 1) {
        parts.push('One surface: ' + model.surfaces[0].basis_u + ' by ' + model.surfaces[0].basis_v + '.');
    } else if (model.surfaces.length > 1) {
        parts.push(model.surfaces.length + ' surfaces.');
    }
    if (model.curves.length > 0) {
        parts.push(model.curves.length === 1 ? 'One curve.' : model.curves.length + ' curves.');
    }
    parts.push('Largest side, net included, ' + show(2 * model.half) + ' ' + model.unit + '.');
    document.title = title + ' – taut';
    document.getElementById('title').textContent = title;
    document.getElementById('summary').textContent = parts.join(' ');
    canvas.setAttribute('aria-label', title + ', drawn in three dimensions. ' + parts.join(' '));
}
