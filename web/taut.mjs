// taut.mjs -- the WebAssembly module in JavaScript's own terms.
//
//     const taut = await load(bytes);          bytes of taut.wasm, in the browser or in node
//     const surface = taut.open(text);         a problem or a model, JSON
//     surface.make(); surface.certify();
//     const { positions, normals } = surface.grid(0, 65, 65);
//     surface.set("/points/0/0", [0, 0, 1]); surface.make();     a point was dragged
//     surface.write("json"); surface.close();
//
// What goes wrong is an Error whose message is the library's sentence, `where` the place in the document, `reason` a word.
// @ts-check

/** Calls of WASI that the library makes without a host: time and random numbers, and no files. */
function host(/** @type {{memory: WebAssembly.Memory | null}} */ held) {
  const view = () => new DataView(/** @type {WebAssembly.Memory} */ (held.memory).buffer);
  const NOSYS = 52, BADF = 8;
  /** @type {Record<string, (...words: any[]) => number>} */
  const calls = {
    clock_time_get(clock, _precision, to) {
      const ms = clock === 0 ? Date.now() : performance.now(); // the date, or a clock that only goes forward
      view().setBigUint64(to, BigInt(Math.round(ms * 1e6)), true);
      return 0;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    random_get(to, length) {
      crypto.getRandomValues(new Uint8Array(view().buffer, to, length));
      return 0;
    },
    fd_write(fd, vectors, count, to) { // what the C library says before it gives up
      let text = "", written = 0;
      for (let i = 0; i < count; i++) {
        const at = view().getUint32(vectors + 8 * i, true), length = view().getUint32(vectors + 8 * i + 4, true);
        text += new TextDecoder().decode(new Uint8Array(view().buffer, at, length));
        written += length;
      }
      if (fd !== 1 && fd !== 2) return BADF;
      console.error(text.trimEnd());
      view().setUint32(to, written, true);
      return 0;
    },
    fd_prestat_get: () => BADF,
    proc_exit(code) {
      throw new Error(`taut ended with ${code}`);
    },
  };
  return new Proxy(calls, { get: (known, name) => known[/** @type {string} */ (name)] ?? (() => NOSYS) });
}

/**
 * @param {BufferSource | WebAssembly.Module} bytes  of taut.wasm, or that compiled
 */
export async function load(bytes) {
  const held = { memory: /** @type {WebAssembly.Memory | null} */ (null) };
  const module = bytes instanceof WebAssembly.Module ? bytes : await WebAssembly.compile(bytes);
  const calls = host(held);
  const imports = Object.fromEntries(WebAssembly.Module.imports(module).map(({ name }) => [name, calls[name]]));
  const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: imports });
  const raw = /** @type {any} */ (instance.exports);
  held.memory = raw.memory;
  raw._initialize();
  return new Taut(raw);
}

class Taut {
  constructor(/** @type {any} */ raw) {
    this.raw = raw;
  }

  /** A text that ends in a 0. */
  text(/** @type {number} */ at, /** @type {number} */ length = -1) {
    const all = new Uint8Array(this.raw.memory.buffer);
    return new TextDecoder().decode(all.subarray(at, length < 0 ? all.indexOf(0, at) : at + length));
  }

  /** Calls `use` with a text's place and length. */
  given(/** @type {string} */ text, /** @type {(at: number, length: number) => number} */ use) {
    const bytes = new TextEncoder().encode(text);
    const at = this.raw.taut_web_alloc(bytes.length + 1);
    if (at === 0) throw new Error("memory ran out");
    const room = new Uint8Array(this.raw.memory.buffer, at, bytes.length + 1);
    room.set(bytes);
    room[bytes.length] = 0;
    const found = use(at, bytes.length);
    this.raw.taut_web_free(at);
    return found;
  }

  failure() {
    const { raw } = this;
    return Object.assign(new Error(this.text(raw.taut_web_error())),
      { reason: this.text(raw.taut_web_reason()), where: this.text(raw.taut_web_where()) });
  }

  open(/** @type {string} */ text) {
    const handle = this.given(text, (at, length) => this.raw.taut_web_open(at, length));
    if (handle === 0) throw this.failure();
    return new Surface(this, handle);
  }
}

class Surface {
  constructor(/** @type {Taut} */ taut, /** @type {number} */ handle) {
    this.taut = taut;
    this.handle = handle;
  }

  /**
   * Another value in one place of the problem, by a JSON pointer; make() then makes it anew. What is refused leaves the
   * problem, and the model, as they were.
   */
  set(/** @type {string} */ pointer, /** @type {unknown} */ value) {
    const { raw } = this.taut;
    const status = this.taut.given(pointer, (place) =>
      this.taut.given(JSON.stringify(value), (at, length) => raw.taut_web_set(this.handle, place, at, length)));
    if (status !== 0) throw this.taut.failure();
  }

  /** The problem as it is now; null where a model was opened. */
  problem() {
    const at = this.taut.raw.taut_web_problem(this.handle);
    return at === 0 ? null : JSON.parse(this.taut.text(at));
  }

  /** Makes the model of the problem that was opened. */
  make() {
    if (this.taut.raw.taut_web_make(this.handle) !== 0) throw this.taut.failure();
  }

  /**
   * The model as a draft, some cheap steps from that of another surface of nearly the same problem: of `film` and `plateau`.
   * False where there is no way from there: make() it then.
   */
  draft(/** @type {Surface} */ before, steps = 1) {
    const status = this.taut.raw.taut_web_draft(this.handle, before.handle, steps);
    if (status > 0) throw this.taut.failure();
    return status === 0;
  }

  /** Proves it: true, false, or null where a claim is undecided. */
  certify() {
    if (this.taut.raw.taut_web_certify(this.handle) !== 0) throw this.taut.failure();
    const holds = this.taut.raw.taut_web_holds(this.handle);
    return holds < 0 ? null : holds === 1;
  }

  get count() {
    return this.taut.raw.taut_web_surfaces(this.handle);
  }

  name(/** @type {number} */ s) {
    return this.taut.text(this.taut.raw.taut_web_name(this.handle, s));
  }

  /** Positions and unit normals at nu by nv parameters, three numbers each: views that hold until the next call. */
  grid(/** @type {number} */ s, /** @type {number} */ nu, /** @type {number} */ nv) {
    const at = this.taut.raw.taut_web_grid(this.handle, s, nu, nv);
    if (at === 0) throw new Error(`no grid of surface ${s} with ${nu} by ${nv} points`);
    const all = new Float32Array(this.taut.raw.memory.buffer, at, 6 * nu * nv);
    return { positions: all.subarray(0, 3 * nu * nv), normals: all.subarray(3 * nu * nv) };
  }

  /**
   * Mean and Gaussian curvatures at the same parameters, NaN where there is none, and how far these are from isothermal, 0 to 1:
   * views that hold until the next call.
   */
  curvatures(/** @type {number} */ s, /** @type {number} */ nu, /** @type {number} */ nv) {
    const at = this.taut.raw.taut_web_curvatures(this.handle, s, nu, nv);
    if (at === 0) throw new Error(`no curvatures of surface ${s} with ${nu} by ${nv} points`);
    const all = new Float32Array(this.taut.raw.memory.buffer, at, 3 * nu * nv);
    return { mean: all.subarray(0, nu * nv), gaussian: all.subarray(nu * nv, 2 * nu * nv), isothermality: all.subarray(2 * nu * nv) };
  }

  /** How far the film is from the least area there is, per area, at the same parameters; null where no witness says so. */
  gaps(/** @type {number} */ s, /** @type {number} */ nu, /** @type {number} */ nv) {
    const at = this.taut.raw.taut_web_gaps(this.handle, s, nu, nv);
    return at === 0 ? null : new Float32Array(this.taut.raw.memory.buffer, at, nu * nv);
  }

  get curveCount() {
    return this.taut.raw.taut_web_curves(this.handle);
  }

  /** Points of curve c from end to end, three numbers each: a view that holds until the next call. */
  curve(/** @type {number} */ c, /** @type {number} */ count) {
    const at = this.taut.raw.taut_web_curve(this.handle, c, count);
    if (at === 0) throw new Error(`no curve ${c} with ${count} points`);
    return new Float32Array(this.taut.raw.memory.buffer, at, 3 * count);
  }

  /** The control points of surface s, [count of u][count of v][3]. */
  points(/** @type {number} */ s) {
    const { raw } = this.taut;
    const nu = raw.taut_web_count(this.handle, s, 0), nv = raw.taut_web_count(this.handle, s, 1);
    return { nu, nv, points: new Float64Array(raw.memory.buffer, raw.taut_web_points(this.handle, s), 3 * nu * nv) };
  }

  /** The model in a format, such as "json", "svg", "obj". */
  write(/** @type {string} */ format) {
    return new TextDecoder().decode(this.bytes(format));
  }

  /** The same as bytes: a view that holds until the next call. */
  bytes(/** @type {string} */ format) {
    const { raw } = this.taut;
    const at = this.taut.given(format, (name) => raw.taut_web_write(this.handle, name));
    if (at === 0) throw this.taut.failure();
    return new Uint8Array(raw.memory.buffer, at, raw.taut_web_length(this.handle));
  }

  close() {
    this.taut.raw.taut_web_close(this.handle);
    this.handle = 0;
  }
}
