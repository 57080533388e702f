/* surface.js -- the mesh of a surface. */

/* Two triangles a cell; grids of one shape share the list. */
const cellLists = new Map();
function cells(nu, nv) {
    const key = nu + ' ' + nv;
    if (!cellLists.has(key)) {
        const list = new Uint32Array((nu - 1) * (nv - 1) * 6);
        let k = 0;
        for (let i = 0; i + 1 < nu; i++) {
            for (let j = 0; j + 1 < nv; j++) {
                const a = i * nv + j;
                list.set([a, a + nv, a + nv + 1, a, a + nv + 1, a + 1], k);
                k += 6;
            }
        }
        cellLists.set(key, new THREE.BufferAttribute(list, 1));
    }
    return cellLists.get(key);
}

function shares(grid) {
    const list = new Float32Array(grid.nu * grid.nv * 2);
    for (let i = 0; i < grid.nu; i++) {
        for (let j = 0; j < grid.nv; j++) {
            list[2 * (i * grid.nv + j)] = grid.u[i];
            list[2 * (i * grid.nv + j) + 1] = grid.v[j];
        }
    }
    return list;
}

function surfaceMesh(packed, index) {
    const grid = unpackSurface(packed);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(grid.points, 3));
    geometry.setAttribute('normal', new THREE.BufferAttribute(grid.normals, 3));
    geometry.setAttribute('share', new THREE.BufferAttribute(shares(grid), 2));
    geometry.setAttribute('value', new THREE.BufferAttribute(grid.fields.H, 1));
    geometry.setIndex(cells(grid.nu, grid.nv));
    return new THREE.Mesh(geometry, surfaceMaterial(index));
}

/* No value anywhere: of a field that another surface has. */
function missing(packed) {
    return new Float32Array(packed.u.count * packed.v.count).fill(9);
}

function colourMesh(mesh, packed, colour) {
    if (colour !== 'plain') {
        mesh.geometry.setAttribute('value', new THREE.BufferAttribute(unpackSurface(packed).fields[colour] || missing(packed), 1));
    }
}
