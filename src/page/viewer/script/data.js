/* data.js -- the model out of the page: html_page.h says how its numbers are packed. */
const model = JSON.parse(document.getElementById('model').textContent);
const fieldNames = ['H', 'K', 'I', 'G', 'S', 'U', 'V'];

/* 16-bit numbers out of base64, low byte first whatever the machine. */
function shorts(text) {
    const bytes = atob(text);
    const numbers = new Int16Array(bytes.length / 2);
    for (let i = 0; i < numbers.length; i++) {
        numbers[i] = bytes.charCodeAt(2 * i) | (bytes.charCodeAt(2 * i + 1) << 8);
    }
    return numbers;
}

/* Points of the box [-1, 1]^3. */
function unpackPoints(text) {
    return Float32Array.from(shorts(text), (x) => x / 32767);
}

/* Octahedral normals; (0, 0, 0) where there is none. */
function unpackNormals(text) {
    const packed = shorts(text);
    const normals = new Float32Array(packed.length / 2 * 3);
    for (let i = 0; i < packed.length / 2; i++) {
        if (packed[2 * i] === -32768) {
            continue;
        }
        let x = packed[2 * i] / 32767;
        let y = packed[2 * i + 1] / 32767;
        const z = 1 - Math.abs(x) - Math.abs(y);
        if (z < 0) {
            const folded = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
            y = (1 - Math.abs(x)) * (y < 0 ? -1 : 1);
            x = folded;
        }
        const length = Math.hypot(x, y, z);
        normals[3 * i] = x / length;
        normals[3 * i + 1] = y / length;
        normals[3 * i + 2] = z / length;
    }
    return normals;
}

/* Shares of the scale's limit; 9 where there is no value. */
function unpackValues(text) {
    return Float32Array.from(shorts(text), (x) => x === -32768 ? 9 : x / 32766);
}

/* What a surface holds, unpacked when it is first shown: a model may have hundreds. */
function unpackSurface(packed) {
    if (packed.grid === undefined) {
        const fields = {};
        const named = fieldNames.filter((name) => packed[name] !== undefined);
        for (const name of named) {
            fields[name] = unpackValues(packed[name]);
        }
        packed.grid = {
            nu: packed.u.count,
            nv: packed.v.count,
            u: unpackPoints(packed.u.at),
            v: unpackPoints(packed.v.at),
            points: unpackPoints(packed.points),
            normals: unpackNormals(packed.normals),
            fields: fields
        };
        named.concat('points', 'normals').forEach((name) => { packed[name] = null; });
    }
    return packed.grid;
}

/* A number to so many digits, for people. */
function show(x, digits = 5) {
    if (typeof x !== 'number') {
        return x === null ? '–' : String(x);
    }
    const size = Math.abs(x);
    const text = x === 0 ? '0' : size >= 1e6 || size < 1e-3 ? String(x.toExponential(Math.min(digits, 4) - 1)).replace(/\.?0+e/, 'e')
        : String(Number(x.toPrecision(digits)));
    return text.replaceAll('-', '−').replace('e+', 'e');
}
