/* shade.js -- how a surface looks: the colours, the light, isolines and reflections of the figures (src/mesh/colour.c,
 * sheet_corners.c), in a shader. */
const plainColours = [0xa6c6e6, 0xeece96, 0xaed8b6, 0xe4aeac, 0xc8bae4, 0x9ed6d8, 0xded69e, 0xd2c2b4];
const curveColours = [0xb02a30, 0x164e8c, 0x1e7040, 0x96540c, 0x683088, 0x146e76];

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
void main() {
    vNormal = normalMatrix * normal;
    vValue = value;
    vShare = share;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
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
        uniforms: Object.assign({ plain: { value: rgb(plainColours[index % plainColours.length]) } }, look, own),
        side: THREE.DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: 1.5,
        polygonOffsetUnits: 2
    });
}
