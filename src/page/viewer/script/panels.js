/* panels.js -- a surface cut along its parameters into flat-looking panels, and how flat they are. */

/* Where share s lies among the rising shares `at`: the line below it and the part beyond. */
function locate(at, s) {
    let i = 0;
    while (i + 2 < at.length && at[i + 1] <= s) {
        i++;
    }
    const gap = at[i + 1] - at[i];
    return [i, gap > 0 ? Math.min(Math.max((s - at[i]) / gap, 0), 1) : 0];
}

/* list[..][size] of the grid at shares (s, t), linear between its lines. */
function between(grid, list, size, s, t) {
    const [i, a] = locate(grid.u, s);
    const [j, b] = locate(grid.v, t);
    const at = (i * grid.nv + j) * size;
    const out = [];
    for (let c = 0; c < size; c++) {
        const low = list[at + c] * (1 - b) + list[at + size + c] * b;
        const high = list[at + grid.nv * size + c] * (1 - b) + list[at + grid.nv * size + size + c] * b;
        out.push(low * (1 - a) + high * a);
    }
    return out;
}

/* The distance of the two diagonals of a quad over their mean length: 0 where it is flat. */
function bend(p) {
    const d = new THREE.Vector3().fromArray(p[2]).sub(new THREE.Vector3().fromArray(p[0]));
    const e = new THREE.Vector3().fromArray(p[3]).sub(new THREE.Vector3().fromArray(p[1]));
    const across = new THREE.Vector3().crossVectors(d, e);
    const gap = new THREE.Vector3().fromArray(p[1]).sub(new THREE.Vector3().fromArray(p[0]));
    const mean = (d.length() + e.length()) / 2;
    return across.length() > 0 && mean > 0 ? Math.abs(gap.dot(across)) / across.length() / mean : 0;
}

/* Panels of one surface, each with one normal and one value: { object, worst }. */
function panelObject(packed, index, count, colour) {
    const grid = unpackSurface(packed);
    const field = colour === 'plain' ? null : grid.fields[colour] || missing(packed);
    const positions = [];
    const normals = [];
    const values = [];
    const pairs = [];
    let worst = 0;
    for (let i = 0; i < count; i++) {
        for (let j = 0; j < count; j++) {
            const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]
                .map(([a, b]) => between(grid, grid.points, 3, a / count, b / count));
            const d = new THREE.Vector3().fromArray(corners[2]).sub(new THREE.Vector3().fromArray(corners[0]));
            const e = new THREE.Vector3().fromArray(corners[3]).sub(new THREE.Vector3().fromArray(corners[1]));
            const n = d.cross(e).normalize();
            const value = field ? between(grid, field, 1, (i + 0.5) / count, (j + 0.5) / count)[0] : 0;
            worst = Math.max(worst, bend(corners));
            for (const k of [0, 1, 2, 0, 2, 3]) {
                positions.push(...corners[k]);
                normals.push(n.x, n.y, n.z);
                values.push(value);
            }
            for (let k = 0; k < 4; k++) {
                pairs.push(...corners[k], ...corners[(k + 1) % 4]);
            }
        }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(normals), 3));
    geometry.setAttribute('value', new THREE.BufferAttribute(new Float32Array(values), 1));
    geometry.setAttribute('share', new THREE.BufferAttribute(new Float32Array(positions.length / 3 * 2), 2));
    const object = new THREE.Group();
    object.add(new THREE.Mesh(geometry, surfaceMaterial(index, { isolines: { value: 0 } })), lineObject(pairs, 'panel', 1.4));
    return { object: object, worst: worst };
}

function disposeOf(object) {
    object.traverse((part) => {
        if (part.geometry) {
            part.geometry.dispose();
        }
    });
}
