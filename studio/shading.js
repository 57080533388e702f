// shading.js -- how surfaces, lines and points look; colours are those of the page's style sheet.
// @ts-check

const surfaceVertex = `
attribute float value;
varying vec3 vNormal;
varying float vValue;
varying vec3 vPlace;
void main() {
  vPlace = position;
  vNormal = normalMatrix * normal;
  vValue = value;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const surfaceFragment = `
uniform vec3 plain;
uniform float coloured;
uniform float stale;
uniform float stripes;
uniform vec3 cut;
uniform float cutAt;
varying vec3 vNormal;
varying float vValue;
varying vec3 vPlace;
vec3 scale(float t) {
  vec3 cold = vec3(0.13, 0.34, 0.66), none = vec3(0.93, 0.93, 0.91), warm = vec3(0.72, 0.16, 0.18);
  return t < 0.0 ? mix(none, cold, -t) : mix(none, warm, t);
}
/* A dark line of a pixel or two wherever x passes a whole number. */
float lineAt(float x) {
  float width = max(fwidth(x), 1e-6);
  float far = abs(fract(x - 0.5) - 0.5) / width;
  return 1.0 - smoothstep(0.6, 1.6, far);
}
void main() {
  if (dot(cut, cut) > 0.5 && dot(cut, vPlace) > cutAt) discard;
  float size = length(vNormal);
  vec3 n = size > 0.1 ? vNormal / size : vec3(0.0, 0.0, 1.0);
  bool back = n.z < 0.0;
  n = back ? -n : n;
  vec3 ink = back ? mix(plain, vec3(0.55, 0.52, 0.53), 0.4) : plain;
  ink = coloured > 0.5 ? (vValue > 2.0 ? vec3(0.6) : scale(clamp(vValue, -1.0, 1.0))) : ink;
  float wrap = 0.5 + 0.5 * dot(n, normalize(vec3(-0.45, 0.6, 0.66)));
  float shine = max(dot(n, normalize(vec3(-0.25, 0.34, 0.91))), 0.0);
  ink = mix(ink, vec3(0.09, 0.11, 0.16), (coloured > 0.5 ? 0.25 : 0.5) * (1.0 - wrap * wrap));
  ink = mix(ink, vec3(1.0), 0.18 * pow(shine, 18.0));
  if (stripes > 1.5) ink = mix(ink, vec3(0.1), 0.75 * lineAt(10.0 * vPlace.z));
  else if (stripes > 0.5) { /* the room is bars along one way, seen in the surface as in a mirror: breaks of curvature break them */
    vec3 seen = reflect(vec3(0.0, 0.0, -1.0), n);
    float angle = atan(seen.x, seen.z + 1e-9) * 24.0 / 3.14159265;
    float width = fwidth(angle);
    float bar = smoothstep(0.25 - width, 0.25 + width, abs(fract(angle) - 0.5));
    ink = mix(ink, vec3(0.12), width > 0.7 ? 0.3 : 0.6 * bar);
  }
  float grey = dot(ink, vec3(0.3, 0.59, 0.11));
  gl_FragColor = vec4(mix(ink, vec3(0.35 + 0.4 * grey), 0.85 * stale), 1.0);
}`;

const pointVertex = `
attribute float mark;
uniform float pixels;
varying float vMark;
void main() {
  vMark = mark;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.002 * gl_Position.w;
  gl_PointSize = (mark > 1.5 ? 15.0 : mark > 0.5 ? 13.0 : mark < -0.5 ? 6.0 : 10.0) * pixels;
}`;

const pointFragment = `
uniform vec3 ink;
uniform vec3 taken;
varying float vMark;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  if (r > 1.0) discard;
  vec3 rim = vMark > 0.5 ? taken : vMark < -0.5 ? mix(ink, vec3(0.6), 0.5) : ink;
  gl_FragColor = vec4(r > 0.6 ? rim : vMark > 1.5 ? taken : vec3(1.0), 1.0);
}`;

/** "#rrggbb" as three numbers. */
export function colourOf(/** @type {string} */ name) {
  const hex = parseInt(getComputedStyle(document.documentElement).getPropertyValue(name).trim().slice(1), 16);
  return new THREE.Vector3((hex >> 16 & 255) / 255, (hex >> 8 & 255) / 255, (hex & 255) / 255);
}

/** What all materials share, so that one change changes all. */
export const look = {
  plain: { value: null }, coloured: { value: 0 }, stale: { value: 0 }, stripes: { value: 0 },
  /** @type {{ value: any }} */
  cut: { value: null }, cutAt: { value: 0 },
  ink: { value: null }, taken: { value: null }, pixels: { value: 1 },
};

/** @type {{ surface: any, point: any }} One of each, as what changes is shared. */
const materials = { surface: null, point: null };

export function surfaceMaterial() {
  const { plain, coloured, stale, stripes, cut, cutAt } = look;
  cut.value ??= new THREE.Vector3(0, 0, 0);
  return materials.surface ??= new THREE.ShaderMaterial({ vertexShader: surfaceVertex, fragmentShader: surfaceFragment, uniforms: { plain, coloured, stale, stripes, cut, cutAt },
    side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2 });
}

export function pointMaterial() {
  const { ink, taken, pixels } = look;
  return materials.point ??= new THREE.ShaderMaterial({ vertexShader: pointVertex, fragmentShader: pointFragment, uniforms: { ink, taken, pixels } });
}

/** isAbove: before another line in the same place, as a cable is before the edge that it draws. */
export function lineMaterial(/** @type {string} */ colour, /** @type {number} */ width, isAbove = false) {
  const material = new THREE.LineMaterial({ linewidth: width, polygonOffset: isAbove, polygonOffsetFactor: -2, polygonOffsetUnits: -16 });
  const ink = colourOf(colour);
  material.color.setRGB(ink.x, ink.y, ink.z); // as it is to be seen: not turned to linear light
  return material;
}
