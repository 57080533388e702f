// scene.js -- what stands before the camera: surfaces, nets, the points that can be taken. Everything is drawn in a cube
// of side 2 about the origin, so that a surface of a micrometre looks as one of a kilometre.
// @ts-check
import { combsOf } from "./combs.js";
import { arrowsOf } from "./forces.js";
import { colourOf, lineMaterial, look, pointMaterial, surfaceMaterial } from "./shading.js";

/** @typedef {import("./engine.js").Drawn} Drawn */
/** @typedef {import("./places.js").Place} Place */
/** @typedef {import("./places.js").Edge} Edge */

const FIRST_VIEW = { azimuth: -55, elevation: 28 };
const FIELDS = new Set(["H", "K", "isothermality"]);
const MARGIN = 1.1; // of the picture about the ball that holds everything
const NET_MOST = 4000; // points of a net that is drawn
const COMBS = 8; // lines of a surface that have one each way, beside the last
const COMB_LENGTH = 0.25; // of the half of the cube
const ARROW_LENGTH = 0.25; // likewise

export class Scene {
  constructor(/** @type {HTMLCanvasElement} */ canvas) {
    this.canvas = canvas;
    this.frames = 0;
    this.asked = false;
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100);
    this.camera.up.set(0, 0, 1);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = "srgb-linear"; // the colours are those of the screen already
    this.orbit = new THREE.OrbitControls(this.camera, canvas);
    this.orbit.addEventListener("change", () => this.draw());
    this.surfaces = new THREE.Group();
    this.net = new THREE.Group();
    this.curves = new THREE.Group();
    this.combs = new THREE.Group();
    this.arrows = new THREE.Group();
    this.handles = new THREE.Group();
    this.scene.add(this.surfaces, this.net, this.curves, this.combs, this.arrows, this.handles);
    this.box = { centre: [0, 0, 0], half: 1 };
    this.colour = "none";
    this.limit = 0;
    this.hasNet = true;
    this.hasCombs = false;
    this.hasForces = false;
    /** @type {import("./forces.js").Force[]} */
    this.forces = []; // on the supports of what is drawn, once it is proved
    /** @type {(Float32Array | null)[]} */
    this.gaps = []; // of what is drawn, once it is proved
    /** @type {Drawn[]} */
    this.before = []; // as it was before the change
    /** @type {Drawn[]} */
    this.drawn = [];
    /** @type {Float32Array[]} */
    this.courses = [];
    /** @type {{ edge: any, net: any, curve: any, comb: any, force: any, taken: any }} */
    this.materials = { edge: null, net: null, curve: null, comb: null, force: null, taken: null };
    this.restyle();
    new ResizeObserver(() => { this.resize(); this.render(); }).observe(/** @type {Element} */ (canvas.parentElement));
  }

  /** Colours anew: of light or of dark. */
  restyle() {
    this.renderer.setClearColor(new THREE.Color().setRGB(...colourOf("--paper").toArray(), "srgb-linear"), 1);
    for (const [name, variable] of [["plain", "--surface"], ["ink", "--net"], ["taken", "--mark"]]) {
      /** @type {any} */ (look)[name].value = colourOf(variable);
    }
    Object.values(this.materials).forEach((material) => material?.dispose());
    this.materials = { edge: lineMaterial("--ink", 2), net: lineMaterial("--net", 1), curve: lineMaterial("--mark", 2.5, true),
      comb: lineMaterial("--comb", 1), force: lineMaterial("--force", 2), taken: lineMaterial("--mark", 3) };
    this.show(this.drawn);
    this.showCurves(this.courses);
  }

  /** One picture at the next chance, however many ask. */
  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.render();
    });
  }

  render() {
    this.renderer.render(this.scene, this.camera);
    this.frames++;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = /** @type {Element} */ (this.canvas.parentElement);
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    look.pixels.value = this.renderer.getPixelRatio();
    const half = MARGIN * Math.max(1, height / width);
    Object.assign(this.camera, { top: half, bottom: -half, left: -half * width / height, right: half * width / height });
    this.camera.updateProjectionMatrix();
  }

  /** Azimuth and elevation in degrees; z is up. */
  lookFrom(/** @type {number} */ azimuth, /** @type {number} */ elevation) {
    const a = azimuth * Math.PI / 180, e = Math.min(Math.max(elevation, -89.9), 89.9) * Math.PI / 180;
    this.camera.position.set(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)).multiplyScalar(10).add(this.orbit.target);
    this.orbit.update();
    this.draw();
  }

  turn(/** @type {number} */ right, /** @type {number} */ up) {
    const offset = this.camera.position.clone().sub(this.orbit.target);
    this.lookFrom(Math.atan2(offset.y, offset.x) * 180 / Math.PI + right, Math.asin(offset.z / offset.length()) * 180 / Math.PI + up);
  }

  zoom(/** @type {number} */ factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.1), 200);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** The cube is put about these points, and looked at from the start. */
  frame(/** @type {number[][]} */ points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const visit = (/** @type {ArrayLike<number>} */ list) => {
      for (let k = 0; k < list.length; k++) {
        if (!Number.isFinite(list[k])) continue;
        low[k % 3] = Math.min(low[k % 3], list[k]);
        high[k % 3] = Math.max(high[k % 3], list[k]);
      }
    };
    points.forEach(visit);
    this.drawn.forEach(({ positions }) => visit(positions));
    this.courses.forEach(visit);
    const half = Math.hypot(...low.map((x, c) => high[c] / 2 - x / 2));
    const isSome = Number.isFinite(half) && half > 0;
    this.box = { centre: isSome ? low.map((x, c) => x / 2 + high[c] / 2) : [0, 0, 0], half: isSome ? half : 1 };
    this.camera.zoom = 1;
    this.camera.updateProjectionMatrix();
    this.orbit.target.set(0, 0, 0);
    this.lookFrom(FIRST_VIEW.azimuth, FIRST_VIEW.elevation);
    this.show(this.drawn);
    this.showCurves(this.courses);
  }

  /** Points of the document's space in the cube. */
  inCube(/** @type {ArrayLike<number>} */ points) {
    const { centre, half } = this.box;
    return Float32Array.from(points, (x, k) => (x - centre[k % 3]) / half);
  }

  clear(/** @type {any} */ group) {
    for (const child of [...group.children]) {
      group.remove(child);
      child.geometry.dispose();
    }
  }

  /** Surfaces as they were drawn last; the same grid again only moves. */
  show(/** @type {Drawn[]} */ drawn) {
    if (drawn !== this.drawn) this.gaps = this.forces = [];
    this.drawn = drawn;
    this.clear(this.net);
    this.clear(this.surfaces);
    const fields = drawn.map((surface, s) => this.fieldOf(surface, s));
    this.limit = this.colour === "none" ? 0 : limitOf(fields);
    look.coloured.value = this.colour === "none" ? 0 : 1;
    for (const [s, surface] of drawn.entries()) {
      const positions = this.inCube(surface.positions);
      this.surfaces.add(new THREE.Mesh(this.meshOf(surface, positions, fields[s]), surfaceMaterial()));
      this.net.add(this.lines(bordersOf(surface.lines), positions, this.materials.edge));
      const { nu, nv, points } = surface.net;
      if (nu * nv <= NET_MOST) this.net.add(this.lines(linesOf(nu, nv), this.inCube(points), this.materials.net));
    }
    this.net.children.forEach((/** @type {any} */ child) => { child.visible = child.material !== this.materials.net || this.hasNet; });
    this.showCombs();
    this.showForces();
    this.draw();
  }

  /** What the certificate of a film says that its supports carry. */
  setForces(/** @type {import("./forces.js").Force[]} */ forces) {
    this.forces = forces;
    this.showForces();
    this.draw();
  }

  /** An arrow at each support. */
  showForces() {
    this.clear(this.arrows);
    if (!this.hasForces || this.forces.length === 0) return;
    const corners = this.forces.map(({ corner }) => [...this.inCube(corner)]);
    this.arrows.add(this.segments(arrowsOf(this.forces, corners, ARROW_LENGTH), this.materials.force));
  }

  /** What the witness of a film says of what is drawn. */
  setGaps(/** @type {(Float32Array | null)[]} */ gaps) {
    this.gaps = gaps;
    if (this.colour === "gap") this.show(this.drawn);
  }

  /** A comb on every eighth line of a grid each way and on each curve. */
  showCombs() {
    this.clear(this.combs);
    if (!this.hasCombs) return;
    const paths = this.drawn.flatMap(({ lines: n, positions }) => {
      const points = this.inCube(positions), every = Math.max(1, Math.floor((n - 1) / COMBS));
      const numbers = Array.from({ length: Math.floor((n - 1) / every) + 1 }, (_, k) => k * every);
      return numbers.flatMap((k) => [row(k, n), column(k, n, n)]).map((path) => ({ path, points }));
    });
    for (const course of this.courses) paths.push({ path: Array.from({ length: course.length / 3 }, (_, k) => k), points: this.inCube(course) });
    const pairs = combsOf(paths, COMB_LENGTH);
    if (pairs.length > 0) this.combs.add(this.segments(pairs, this.materials.comb));
  }

  /** What is drawn now is what changes are measured from; `isNothing`: from nothing. */
  remember(/** @type {boolean} */ isNothing) {
    this.before = isNothing ? [] : this.drawn;
  }

  /** Is it coloured by what the library has to find at each point? */
  get needsFields() {
    return FIELDS.has(this.colour);
  }

  get lacksFields() {
    return this.needsFields && this.drawn.some(({ mean }) => mean === null);
  }

  /** The values that a surface is coloured by. */
  fieldOf(/** @type {Drawn} */ surface, /** @type {number} */ s) {
    const none = new Float32Array(surface.positions.length / 3).fill(NaN);
    if (this.colour === "H") return surface.mean ?? none;
    if (this.colour === "K") return surface.gaussian ?? none;
    if (this.colour === "isothermality") return surface.isothermality ?? none;
    if (this.colour === "gap") return this.gaps[s] ?? none;
    if (this.colour !== "change") return none;
    const before = this.before[s]?.positions;
    return none.map((_, k) => before?.length !== surface.positions.length ? 0 :
      Math.hypot(...[0, 1, 2].map((c) => surface.positions[3 * k + c] - before[3 * k + c])));
  }

  meshOf(/** @type {Drawn} */ surface, /** @type {Float32Array} */ positions, /** @type {Float32Array} */ field) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(surface.normals, 3));
    const share = this.limit > 0 ? 1 / this.limit : 0;
    geometry.setAttribute("value", new THREE.BufferAttribute(field.map((x) => Number.isFinite(x) ? x * share : 9), 1));
    geometry.setIndex(new THREE.BufferAttribute(cellsOf(surface.lines), 1));
    return geometry;
  }

  /** Polylines through numbered points. */
  lines(/** @type {number[][]} */ paths, /** @type {Float32Array} */ points, /** @type {any} */ material) {
    const pairs = [];
    for (const path of paths) {
      for (let k = 0; k + 1 < path.length; k++) pairs.push(...points.subarray(3 * path[k], 3 * path[k] + 3), ...points.subarray(3 * path[k + 1], 3 * path[k + 1] + 3));
    }
    return this.segments(pairs.length > 0 ? pairs : [0, 0, 0, 0, 0, 0], material);
  }

  /** Segments between pairs of points. */
  segments(/** @type {number[]} */ pairs, /** @type {any} */ material) {
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(pairs);
    return new THREE.LineSegments2(geometry, material);
  }

  /** Curves of a model, as points from end to end. */
  showCurves(/** @type {Float32Array[]} */ curves) {
    this.courses = curves;
    this.clear(this.curves);
    for (const points of curves) {
      this.curves.add(this.lines([Array.from({ length: points.length / 3 }, (_, k) => k)], this.inCube(points), this.materials.curve));
    }
    this.showCombs();
    this.draw();
  }

  /** The points that can be taken: 0 plain, 1 under the pointer, 2 taken; and the edge under the pointer. */
  showHandles(/** @type {Place[]} */ places, /** @type {number[]} */ marks, /** @type {number[] | null} */ edge) {
    this.clear(this.handles);
    if (places.length > 0) {
      const positions = this.inCube(places.flatMap(({ at }) => at));
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
      geometry.setAttribute("mark", new THREE.BufferAttribute(Float32Array.from(marks), 1));
      this.handles.add(new THREE.Points(geometry, pointMaterial()));
      if (edge !== null) this.handles.add(this.lines([edge], positions, this.materials.taken));
    }
    this.draw();
  }

  /** Where a point of the document's space is seen, in pixels of the canvas. */
  seenAt(/** @type {number[]} */ point) {
    const { centre, half } = this.box;
    const at = new THREE.Vector3(...point.map((x, c) => (x - centre[c]) / half)).project(this.camera);
    return [(at.x + 1) / 2 * this.canvas.clientWidth, (1 - at.y) / 2 * this.canvas.clientHeight];
  }

  /** What a pixel to the right and one up are in the document's space, and the way to the eye. */
  axes() {
    const { camera } = this;
    const pixel = (camera.top - camera.bottom) / camera.zoom / this.canvas.clientHeight * this.box.half;
    const [right, up, eye] = [0, 1, 2].map((c) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, c).toArray());
    return { pixel, right, up, eye };
  }

  /** The unit normal of what is drawn at its vertex nearest to a point; null where nothing is. */
  normalNear(/** @type {number[]} */ point) {
    let nearest = Infinity, normal = null;
    for (const { positions, normals } of this.drawn) {
      for (let k = 0; k < positions.length; k += 3) {
        const distance = (positions[k] - point[0]) ** 2 + (positions[k + 1] - point[1]) ** 2 + (positions[k + 2] - point[2]) ** 2;
        if (distance < nearest && normals[k] ** 2 + normals[k + 1] ** 2 + normals[k + 2] ** 2 > 0.5) {
          nearest = distance;
          normal = [...normals.subarray(k, k + 3)];
        }
      }
    }
    return normal;
  }

  setStale(/** @type {boolean} */ isStale) {
    look.stale.value = isStale ? 1 : 0;
    this.draw();
  }

  setNet(/** @type {boolean} */ isShown) {
    this.hasNet = isShown;
    this.show(this.drawn);
  }

  setColour(/** @type {string} */ colour) {
    this.colour = colour;
    this.show(this.drawn);
  }

  /** Lines on the surface: "none", "reflection" of a room of bars, "height", "combs" of curvature, or "forces" on supports. */
  setLines(/** @type {string} */ kind) {
    look.stripes.value = Math.max(0, ["none", "reflection", "height"].indexOf(kind));
    this.hasCombs = kind === "combs";
    this.hasForces = kind === "forces";
    this.showCombs();
    this.showForces();
    this.draw();
  }

  /** Cut away is what lies beyond a share of the picture along an axis, 0 (x), 1 or 2; -1: nothing. */
  setSection(/** @type {number} */ axis, /** @type {number} */ share) {
    look.cut.value = new THREE.Vector3(...[0, 1, 2].map((c) => c === axis ? 1 : 0));
    look.cutAt.value = 2 * share - 1;
    this.draw();
  }
}

/** The end of the scale: what 98 of 100 values stay within. */
function limitOf(/** @type {Float32Array[]} */ fields) {
  const all = fields.flatMap((field) => [...field].filter(Number.isFinite).map(Math.abs));
  all.sort((a, b) => a - b);
  return all.length > 0 ? all[Math.floor(0.98 * (all.length - 1))] : 0;
}

/** Two triangles a cell. */
function cellsOf(/** @type {number} */ n) {
  const list = [];
  for (let i = 0; i + 1 < n; i++) {
    for (let j = 0; j + 1 < n; j++) {
      const a = i * n + j;
      list.push(a, a + n, a + n + 1, a, a + n + 1, a + 1);
    }
  }
  return Uint32Array.from(list);
}

const row = (/** @type {number} */ i, /** @type {number} */ nv) => Array.from({ length: nv }, (_, j) => i * nv + j);
const column = (/** @type {number} */ j, /** @type {number} */ nu, /** @type {number} */ nv) => Array.from({ length: nu }, (_, i) => i * nv + j);
const bordersOf = (/** @type {number} */ n) => [row(0, n), row(n - 1, n), column(0, n, n), column(n - 1, n, n)];
const linesOf = (/** @type {number} */ nu, /** @type {number} */ nv) =>
  [...Array.from({ length: nu }, (_, i) => row(i, nv)), ...Array.from({ length: nv }, (_, j) => column(j, nu, nv))];
