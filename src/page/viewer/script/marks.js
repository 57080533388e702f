/* marks.js -- points and lines that say where, seen through whatever is before them. */
const markPoints = new THREE.ShaderMaterial({
    uniforms: { ink: { value: null }, pixels: pointScale },
    depthTest: false,
    transparent: true,
    vertexShader: `
uniform float pixels;
void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = 17.0 * pixels;
}`,
    fragmentShader: `
uniform vec3 ink;
void main() {
    float r = 2.0 * length(gl_PointCoord - 0.5);
    if (r > 1.0) discard;
    gl_FragColor = vec4(r > 0.45 && r < 0.72 || r < 0.16 ? ink : vec3(1.0), r > 0.72 || r < 0.45 && r > 0.16 ? 0.75 : 1.0);
}`
});

/* points: flat, in the cube; lines: lists of flat points, each drawn from end to end. */
function setMarks(points, lines) {
    stage.marks.children.slice().forEach((child) => {
        stage.marks.remove(child);
        child.geometry.dispose();
    });
    const pairs = [];
    lines.forEach((line) => addPolyline(pairs, line, row(0, line.length / 3)));
    if (pairs.length > 0) {
        const object = lineObject(pairs, 'mark', 4);
        object.material.depthTest = false;
        object.renderOrder = 1;
        stage.marks.add(object);
    }
    if (points.length > 0) {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(points), 3));
        const object = new THREE.Points(geometry, markPoints);
        markPoints.uniforms.ink.value = inkOf('mark');
        object.renderOrder = 2;
        stage.marks.add(object);
    }
    draw();
}

/* A parameter as a share of its range. */
function shareOf(lines, x) {
    const [low, high] = lines.range;
    return (x - low) / (high - low);
}

function lineOfPoints(grid, along) {
    return along.flatMap((k) => [...grid.points.subarray(3 * k, 3 * k + 3)]);
}

const edgeOf = (grid, name) => lineOfPoints(grid, name[0] === 'u' ? row(name[1] === '0' ? 0 : grid.nu - 1, grid.nv)
    : column(name[1] === '0' ? 0 : grid.nv - 1, grid.nu, grid.nv));

/* The marks of a place (place.js): the point where it says one, else the line, else all edges of its surface. */
function markPlace(place) {
    if (place.kind === 'curve') {
        setMarks([], [[...unpackPoints(model.curves[place.index].points)]]);
        return;
    }
    const packed = model.surfaces[place.index];
    const grid = unpackSurface(packed);
    const at = (s, t) => between(grid, grid.points, 3, s, t);
    const net = packed.net;
    const edge = place.edge ? edgeOf(grid, place.edge) : null;
    if (place.point && net.nu > 0 && net.every === 1) {
        const k = 3 * (place.point[0] * net.nv + place.point[1]);
        setMarks([...unpackPoints(net.points).subarray(k, k + 3)], []);
    } else if (place.u !== undefined) {
        setMarks(at(shareOf(packed.u, place.u), shareOf(packed.v, place.v)), []);
    } else if (edge && place.t !== undefined) {
        const end = place.edge[1] === '0' ? 0 : 1;
        setMarks(place.edge[0] === 'u' ? at(end, shareOf(packed.v, place.t)) : at(shareOf(packed.u, place.t), end), [edge]);
    } else if (edge) {
        setMarks([], [edge]);
    } else if (place.t !== undefined) { /* of a pipe, whose spine runs along u */
        const s = shareOf(packed.u, place.t);
        setMarks([], [Array.from({ length: 65 }, (_, j) => at(s, j / 64)).flat()]);
    } else {
        setMarks([], ['u0', 'u1', 'v0', 'v1'].map((name) => edgeOf(grid, name)));
    }
}

/* A click on a claim: its place in the picture; once more: gone. */
function showClaim(button, claim, place) {
    const isOn = button.getAttribute('aria-pressed') !== 'true';
    letGo();
    if (isOn) {
        if (shown.layout === 'frames' && place.kind === 'surface') {
            change({ frame: place.index });
        } else if (shown.layout === 'apart') {
            change({ layout: 'together' });
        }
        button.setAttribute('aria-pressed', 'true');
        markPlace(place);
        fillProbe(claim.claim, [['where', claim.where]]);
    }
}
