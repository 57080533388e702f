/* lines.js -- boundaries, knot lines, nets and curves: lines some pixels wide, and round points. */
const DEPTH_GREATER = 6; /* THREE.GreaterDepth, which the bundle goes without */
const lineMaterials = new Map();
function lineMaterial(colour, width, isBehind) {
    const key = colour + ' ' + width + ' ' + isBehind;
    if (!lineMaterials.has(key)) {
        const behind = { transparent: true, opacity: 0.35, depthFunc: DEPTH_GREATER, depthWrite: false };
        const material = new THREE.LineMaterial({ linewidth: width, ...(isBehind ? behind : {}) });
        material.userData.ink = colour;
        inkLine(material);
        lineMaterials.set(key, material);
    }
    return lineMaterials.get(key);
}

function inkLine(material) {
    const ink = inkOf(material.userData.ink);
    material.color.setRGB(ink.x, ink.y, ink.z); /* as it is to be seen: not turned to linear light */
}

/* The polyline through points[order[0]], points[order[1]], ... as pairs of ends. */
function addPolyline(pairs, points, order) {
    for (let k = 0; k + 1 < order.length; k++) {
        const a = 3 * order[k];
        const b = 3 * order[k + 1];
        pairs.push(points[a], points[a + 1], points[a + 2], points[b], points[b + 1], points[b + 2]);
    }
}

function lineObject(pairs, colour, width) {
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(pairs.length > 0 ? pairs : [0, 0, 0, 0, 0, 0]);
    return new THREE.LineSegments2(geometry, lineMaterial(colour, width, false));
}

/* The same lines where something is in front of them: thin and paler, as in figures, for points of a net to hang together. */
function lineBehind(line) {
    const { userData, linewidth } = line.material;
    return new THREE.LineSegments2(line.geometry, lineMaterial(userData.ink, 0.7 * linewidth, true));
}

const row = (i, nv) => Array.from({ length: nv }, (_, j) => i * nv + j);
const column = (j, nu, nv) => Array.from({ length: nu }, (_, i) => i * nv + j);

/* The boundary of a surface and its knot lines. */
function outline(packed) {
    const grid = unpackSurface(packed);
    const edges = [];
    const knots = [];
    const group = new THREE.Group();
    for (const i of [0, grid.nu - 1]) {
        addPolyline(edges, grid.points, row(i, grid.nv));
    }
    for (const j of [0, grid.nv - 1]) {
        addPolyline(edges, grid.points, column(j, grid.nu, grid.nv));
    }
    packed.u.knots.forEach((i) => addPolyline(knots, grid.points, row(i, grid.nv)));
    packed.v.knots.forEach((j) => addPolyline(knots, grid.points, column(j, grid.nu, grid.nv)));
    group.add(lineObject(edges, 'edge', 2.2));
    if (knots.length > 0) {
        group.add(lineObject(knots, 'knot', 1));
    }
    return group;
}

/* Points of a net, smaller where there are many, and before the lines that end in them. */
const pointScale = { value: 1 };
function pointMaterial(count) {
    const size = count <= 60 ? 9 : count <= 250 ? 7 : 5;
    return new THREE.ShaderMaterial({
        uniforms: { size: { value: size }, pixels: pointScale },
        clipping: true,
        transparent: true, /* drawn with what is, after lines behind the surface */
        vertexShader: `
uniform float size;
uniform float pixels;
#include <clipping_planes_pars_vertex>
void main() {
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    #include <clipping_planes_vertex>
    gl_Position = projectionMatrix * mvPosition;
    gl_Position.z -= 0.0006 * gl_Position.w;
    gl_PointSize = size * pixels;
}`,
        fragmentShader: `
#include <clipping_planes_pars_fragment>
void main() {
    #include <clipping_planes_fragment>
    float r = 2.0 * length(gl_PointCoord - 0.5);
    if (r > 1.0) discard;
    gl_FragColor = vec4(r > 0.62 ? vec3(0.24, 0.26, 0.32) : vec3(0.98), 1.0);
}`
    });
}

/* Round points, smaller where there are many. */
function pointsObject(points, count) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
    const object = new THREE.Points(geometry, pointMaterial(count));
    object.renderOrder = 1;
    return object;
}

/* A net of nu by nv points, a polygon when nu is 1, or nothing where it is left out. */
function netObject(net) {
    const points = unpackPoints(net.points);
    const pairs = [];
    const group = new THREE.Group();
    if (net.nu === 0) {
        return group;
    }
    for (let i = 0; i < net.nu; i++) {
        addPolyline(pairs, points, row(i, net.nv));
    }
    for (let j = 0; net.nu > 1 && j < net.nv; j++) {
        addPolyline(pairs, points, column(j, net.nu, net.nv));
    }
    const lines = lineObject(pairs, 'net', net.nu * net.nv <= 100 ? 1.2 : 0.9);
    group.add(lines, lineBehind(lines));
    if (net.nu * net.nv <= 1200) {
        group.add(pointsObject(points, net.nu * net.nv));
    }
    return group;
}

/* Laths by how much of their strength is used, other curves by their place in the model. */
function curveColour(curve) {
    return curve.ink || curveColours[curve.colour % curveColours.length];
}

function curveObject(curve) {
    const points = unpackPoints(curve.points);
    const pairs = [];
    addPolyline(pairs, points, row(0, points.length / 3));
    return lineObject(pairs, curveColour(curve), 3);
}
