/* shade.js -- how a surface looks: the colours, light or dark paper, the light, isolines and reflections of the figures (src/mesh/colour.c,
 * sheet_corners.c), in a shader. */
const plainColours = [0xa6c6e6, 0xeece96, 0xaed8b6, 0xe4aeac, 0xc8bae4, 0x9ed6d8, 0xded69e, 0xd2c2b4];
/* A number from 1 << 24 on is a colour of its own, that of the file which the model was read from. */
const plainColour = index => index >= 1 << 24 ? index - (1 << 24) : plainColours[index % plainColours.length];
const curveColours = [0xb02a30, 0x164e8c, 0x1e7040, 0x96540c, 0x683088, 0x146e76];

/* Lines by what they are, on light paper and on dark; curves have colours of their own. */
const inks = { edge: [0x242a36, 0xdfe3ea], knot: [0x6d7788, 0x515b6c], net: [0x444a5a, 0x98a2b6], panel: [0x2b3240, 0x2b3240], mark: [0xc2185b, 0xff5c9a], reaction: [0x18685c, 0x5fcbb8] };
const papers = [0xffffff, 0x14171d];
let isDark = false;

/* The colour of a line: of a name above, or of a curve, which dark paper makes lighter. */
function inkOf(name) {
    if (inks[name]) {
        return rgb(inks[name][isDark ? 1 : 0]);
    }
    return isDark ? rgb(name).lerp(new THREE.Vector3(1, 1, 1), 0.45) : rgb(name);
}

function rgb(hex) {
    return new THREE.Vector3((hex >> 16 & 255) / 255, (hex >> 8 & 255) / 255, (hex & 255) / 255);
}

function css(hex) {
    return '#' + hex.toString(16).padStart(6, '0');
}

const vertexShader = `
attribute float value;
attribute vec2 share;
varying vec3 vNormal;
varying float vValue;
varying vec2 vShare;
#include <clipping_planes_pars_vertex>
void main() {
    vNormal = normalMatrix * normal;
    vValue = value;
    vShare = share;
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    #include <clipping_planes_vertex>
    gl_Position = projectionMatrix * mvPosition;
}`;

const fragmentShader = `
uniform vec3 plain;
uniform vec3 map[33];
uniform bool coloured;
uniform float lights;
uniform float isolines;
varying vec3 vNormal;
varying float vValue;
varying vec2 vShare;
#include <clipping_planes_pars_fragment>

vec3 scale(float t) {
    float at = clamp(t, -1.0, 1.0) * 16.0 + 16.0;
    int below = int(min(at, 31.0));
    return mix(map[below], map[below + 1], at - float(below));
}

/* 1 on the lines where f is whole, a pixel and a half wide */
float wholes(float f) {
    float slope = fwidth(f);
    return slope > 0.5 ? 0.0 : 1.0 - smoothstep(0.6, 1.4, abs(fract(f + 0.5) - 0.5) / max(slope, 1e-9));
}

void main() {
    #include <clipping_planes_fragment>
    float size = length(vNormal);
    vec3 n = size > 0.1 ? vNormal / size : vec3(0.0, 0.0, 1.0);
    bool back = n.z < 0.0;
    n = back ? -n : n;
    vec3 ink = back ? mix(plain, vec3(0.588, 0.541, 0.549), 0.35) : plain;
    if (coloured) {
        ink = vValue > 2.0 ? vec3(0.62) : scale(vValue);
    }
    float strength = coloured ? 0.32 : 1.0;
    float wrap = (1.0 + dot(n, vec3(-0.4583, 0.6110, 0.6455))) / 2.0;
    float shine = max(dot(n, vec3(-0.2527, 0.3368, 0.9070)), 0.0);
    ink = mix(ink, vec3(0.094, 0.110, 0.157), strength * 0.38 * (1.0 - wrap * wrap));
    ink = mix(ink, vec3(1.0), strength * 0.2 * pow(shine, 16.0));
    if (lights > 0.0) {
        float s = sin(lights * atan(2.0 * n.z * n.x, 2.0 * n.z * n.z - 1.0));
        float width = max(fwidth(s), 1e-6);
        ink = mix(ink, mix(ink, vec3(0.118, 0.141, 0.204), 0.72), smoothstep(-width, width, s));
    }
    if (isolines > 0.0) {
        float line = coloured ? (vValue > 2.0 ? 0.0 : wholes(vValue * isolines))
                              : max(wholes(vShare.x * (isolines + 1.0)), wholes(vShare.y * (isolines + 1.0)));
        ink = mix(ink, vec3(0.17, 0.19, 0.24), 0.8 * line);
    }
    #if NUM_CLIPPING_PLANES > 0 /* the section itself is a dark line */
        float beyond = clippingPlanes[0].w - dot(vClipPosition, clippingPlanes[0].xyz);
        ink = mix(vec3(0.09, 0.11, 0.16), ink, smoothstep(1.2, 2.4, beyond / max(fwidth(beyond), 1e-9)));
    #endif
    gl_FragColor = vec4(ink, 1.0);
}`;

/* Shared by all surfaces, so that one change changes all. */
const look = {
    map: { value: model.map.map(rgb) },
    coloured: { value: false },
    lights: { value: 0 },
    isolines: { value: 0 }
};

/* own: uniforms that are not shared */
function surfaceMaterial(index, own) {
    return new THREE.ShaderMaterial({
        vertexShader: vertexShader,
        fragmentShader: fragmentShader,
        uniforms: Object.assign({ plain: { value: rgb(plainColour(index)) } }, look, own),
        side: THREE.DoubleSide,
        clipping: true,
        polygonOffset: true,
        polygonOffsetFactor: 1.5,
        polygonOffsetUnits: 2
    });
}
