/* place.js -- where a claim's words say its largest residual is: "bonnet at (0.6, 0.16)", "blend1, u = 0.48, v = 0.49",
 * "v1, t = 0.25", "blend1.u1, pipe2.u0", "/surfaces/0/points/2/1", "B9 at 0.08". */

/* { kind: 'surface' or 'curve', index, u, v, t, edge, point: [i, j] }, what the words do not say left out; null where they name
 * nothing that is drawn. surfaces, curves: lists of { name }. */
function placeOf(words, surfaces, curves) {
    const pointer = /\/(surfaces|curves)\/(\d+)(?:\/(?:points|weights)\/(\d+)(?:\/(\d+))?)?/.exec(words);
    const place = pointer ? ofPointer(pointer, surfaces, curves) : named(words, surfaces, curves);
    const number = '(-?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?)';
    const read = (pattern) => (new RegExp(pattern).exec(words) || []).slice(1).map(Number);
    const edge = /(?:^|[^a-z0-9])([uv][01])(?![a-z0-9])/.exec(words);
    if (!place && surfaces.length !== 1) {
        return null;
    }
    const found = place || { kind: 'surface', index: 0 };
    const pair = read('\\(' + number + ', ' + number + '\\)').concat(read('\\bu = ' + number + ', v = ' + number));
    const along = read('\\bt = ' + number).concat(found.kind === 'curve' ? read(' at ' + number) : []);
    if (pair.length >= 2 && found.kind === 'surface') {
        [found.u, found.v] = pair;
    } else if (along.length > 0) {
        found.t = along[0];
    }
    if (edge && found.kind === 'surface') {
        found.edge = edge[1];
    }
    return place || found.u !== undefined || found.edge ? found : null;
}

function ofPointer([, list, index, i, j], surfaces, curves) {
    const kind = list === 'surfaces' ? 'surface' : 'curve';
    const isThere = Number(index) < (kind === 'surface' ? surfaces : curves).length;
    return isThere ? Object.assign({ kind: kind, index: Number(index) }, i === undefined ? {} : { point: [Number(i), Number(j || 0)] }) : null;
}

/* The part whose name is longest among those that the words have as a word, the first of them. */
function named(words, surfaces, curves) {
    const parts = [surfaces.map((s, index) => ({ kind: 'surface', index: index, name: s.name })),
        curves.map((c, index) => ({ kind: 'curve', index: index, name: c.name }))].flat();
    const isIn = (name) => name.length > 0 && new RegExp('(?:^|[^\\w-])' + name.replace(/[^\w]/g, '\\$&') + '(?![\\w-])').test(words);
    const found = parts.filter((p) => isIn(p.name)).sort((a, b) => b.name.length - a.name.length || words.indexOf(a.name) - words.indexOf(b.name))[0];
    return found ? { kind: found.kind, index: found.index } : null;
}

if (typeof module !== 'undefined') { /* for the studio and for tests without a page */
    module.exports = { placeOf: placeOf };
}
