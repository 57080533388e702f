/* arrows.js -- reactions: the force of the cables on each corner that a film is held at, by the figures of the certificate: an arrow whose
 * head is at the corner. */
const ARROW = 0.25; /* the longest: an eighth of the box */
const HEAD = [0.22, 0.07]; /* of an arrow: how long its head is, and how wide to either side */

/* Where a support is, in the cube: "u0v0" of the first surface, or "NAME.u0v0"; null where there is no such corner. */
function cornerOf(support) {
    const [, name, u, v] = /^(?:(.*)\.)?u([01])v([01])$/.exec(support) || [];
    const packed = u === undefined ? undefined : model.surfaces.find((s) => name === undefined || s.name === name);
    if (packed === undefined) {
        return null;
    }
    const grid = unpackSurface(packed);
    return new THREE.Vector3().fromArray(grid.points, 3 * (Number(u) * (grid.nu - 1) * grid.nv + Number(v) * (grid.nv - 1)));
}

/* What the cables pull supports with: { corner, force }. */
const reactions = (function () {
    const figures = model.certificate && model.certificate.figures || {};
    const supports = model.details && model.details.supports;
    if (!Array.isArray(figures.reactions) || !Array.isArray(supports)) {
        return [];
    }
    return figures.reactions.map((force, k) => ({ corner: cornerOf(String(supports[k])),
        force: Array.isArray(force) && force.length === 3 ? new THREE.Vector3(...force) : new THREE.Vector3(NaN) }))
        .filter(({ corner, force }) => corner !== null && force.length() > 0 && Number.isFinite(force.length()));
}());
const strongest = reactions.reduce((most, { force }) => Math.max(most, force.length()), 0);

const arrowOf = (force) => force.clone().multiplyScalar(ARROW / strongest);
const arrowTails = () => reactions.flatMap(({ corner, force }) => corner.clone().sub(arrowOf(force)).toArray());

/* The shafts, with heads in two planes: seen from wherever, one of them is wide. */
function arrowsObject() {
    const pairs = [];
    for (const { corner, force } of reactions) {
        const way = arrowOf(force);
        const across = new THREE.Vector3(...[0, 1, 2].map((c) => way.getComponent(c) ** 2 <= way.lengthSq() / 3 ? 1 : 0));
        const first = across.cross(way).setLength(HEAD[1] * way.length());
        const second = first.clone().cross(way).setLength(first.length());
        const neck = corner.clone().addScaledVector(way, -HEAD[0]);
        pairs.push(...corner.clone().sub(way).toArray(), ...corner.toArray());
        for (const side of [first, second, first.clone().negate(), second.clone().negate()]) {
            pairs.push(...corner.toArray(), ...neck.clone().add(side).toArray());
        }
    }
    return lineObject(pairs, 'reaction', 2.4);
}
