/* cloth.js -- flat pieces of cloth that fly to where they are mounted on the surface, and back. */
const pieces = model.surfaces.map((s, i) => s.mounted === undefined ? -1 : i).filter((i) => i >= 0);
const hasStrain = pieces.length > 0;
const cutLines = new Set(pieces.map((i) => model.surfaces[i].name + '.cut'));
const FLIGHT_MS = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 1400;
const LATER = 0.5; /* the last piece starts when the first one has flown so far */

/* The place in the middle of a grid, and how it lies there: along u, across, normal. */
function frameOf(grid, points, normals) {
    const at = Math.floor(grid.nu / 2) * grid.nv + Math.floor(grid.nv / 2);
    const vector = (list, k) => new THREE.Vector3().fromArray(list, 3 * k);
    const normal = vector(normals, at);
    const along = vector(points, at + grid.nv).sub(vector(points, at - grid.nv));
    along.addScaledVector(normal, -along.dot(normal)).normalize();
    return { middle: vector(points, at), axes: [along, new THREE.Vector3().crossVectors(normal, along), normal] };
}

/* The axis and the angle that turn one frame into another one. */
function turnOf(from, to) {
    const axis = new THREE.Vector3();
    let trace = 0;
    from.forEach((a, k) => {
        axis.add(new THREE.Vector3().crossVectors(a, to[k]));
        trace += a.dot(to[k]);
    });
    if (axis.length() < 1e-4 && trace < 0) { /* half a turn: about what stays as it is */
        const sums = from.map((a, k) => a.clone().add(to[k])).sort((a, b) => b.length() - a.length());
        axis.copy(sums[0]);
    }
    return { axis: axis.length() > 0 ? axis.normalize() : axis.set(0, 0, 1), angle: Math.acos(Math.min(Math.max((trace - 1) / 2, -1), 1)) };
}

/* A piece's way, made when it first flies: both ends about their middles, the mounted one turned back to lie as the flat one. */
function wayOf(packed) {
    const grid = unpackSurface(packed);
    if (!grid.way) {
        const flat = [grid.points.slice(), grid.normals.slice()];
        const mounted = [unpackPoints(packed.mounted), unpackNormals(packed.mounted_normals)];
        const frames = [flat, mounted].map(([points, normals]) => frameOf(grid, points, normals));
        const turned = turnOf(frames[0].axes, frames[1].axes);
        const about = (list, frame, angle) => {
            const at = new THREE.Vector3();
            for (let k = 0; k < list.length; k += 3) {
                at.fromArray(list, k).sub(frame).applyAxisAngle(turned.axis, angle).toArray(list, k);
            }
            return list;
        };
        const none = new THREE.Vector3();
        grid.way = { middles: frames.map((frame) => frame.middle), turned: turned,
            points: [about(flat[0], frames[0].middle, 0), about(mounted[0], frames[1].middle, -turned.angle)],
            normals: [flat[1], about(mounted[1], none, -turned.angle)] };
    }
    return grid.way;
}

/* A piece at the share x of its way: it moves and turns as a whole, and bends as it goes. */
function placePiece(packed, x) {
    const grid = unpackSurface(packed);
    const way = wayOf(packed);
    const middle = way.middles[0].clone().lerp(way.middles[1], x);
    const at = new THREE.Vector3();
    const end = new THREE.Vector3();
    const put = (to, [from, goal], move) => {
        for (let k = 0; k < to.length; k += 3) {
            at.fromArray(from, k).lerp(end.fromArray(goal, k), x).applyAxisAngle(way.turned.axis, x * way.turned.angle).add(move).toArray(to, k);
        }
    };
    put(grid.points, way.points, middle);
    put(grid.normals, way.normals, new THREE.Vector3());
}

const flight = { at: 0, to: 0, began: 0, from: 0, ends: null }; /* 0: flat, 1: mounted; ends: what the camera sees then */

const isFlat = () => flight.at === 0;
/* The surface itself is where mounted pieces are, and outlines are of flat ones. */
const isUnderCloth = (i) => i === 0 && hasStrain && !isFlat();
const isCutLine = (curve) => cutLines.has(curve.name);

/* The camera comes nearer to what is mounted, as it was turned and moved by hand. */
function follow() {
    if (!flight.ends) {
        const seams = model.curves.filter((curve) => !isCutLine(curve)).map((curve) => unpackPoints(curve.points));
        flight.ends = [{ reach: stage.reach, centre: stage.centre.clone() },
            reachOf(pieces.map((i) => unpackPoints(model.surfaces[i].mounted)).concat(seams))];
    }
    const [from, to] = flight.ends;
    const centre = from.centre.clone().lerp(to.centre, flight.at);
    adjust(from.reach.map((x, c) => x + (to.reach[c] - x) * flight.at), centre);
}

function placePieces() {
    if (shown.layout === 'together') {
        follow();
    }
    pieces.forEach((i, k) => {
        const delay = pieces.length > 1 ? LATER * k / (pieces.length - 1) : 0;
        const x = Math.min(Math.max(flight.at * (1 + LATER) - delay, 0), 1);
        const made = part(i);
        placePiece(model.surfaces[i], x * x * (3 - 2 * x));
        made.mesh.geometry.attributes.position.needsUpdate = true;
        made.mesh.geometry.attributes.normal.needsUpdate = true;
        made.mesh.geometry.computeBoundingSphere(); /* or it is not drawn where it was not before */
        made.group.remove(made.outline);
        disposeOf(made.outline);
        made.outline = outline(model.surfaces[i]);
        made.group.add(made.outline);
    });
    change({});
}

function fly(now) {
    const x = FLIGHT_MS > 0 ? Math.min((now - flight.began) / (FLIGHT_MS * Math.abs(flight.to - flight.from)), 1) : 1;
    flight.at = flight.from + (flight.to - flight.from) * x;
    placePieces();
    if (x < 1) {
        requestAnimationFrame(fly);
    }
    canvas.dataset.flight = flight.at;
}

/* Mounts the pieces, or lays them flat. */
function mount(on) {
    const isFlying = flight.at !== flight.to;
    flight.to = on ? 1 : 0;
    flight.from = flight.at;
    flight.began = performance.now();
    document.querySelector('[name=cloth][value=' + (on ? 'mounted' : 'flat') + ']').checked = true;
    letGo();
    if (!isFlying && flight.from !== flight.to) {
        requestAnimationFrame(fly);
    }
}
