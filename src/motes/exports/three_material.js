// Instances, batches, morph targets and bones move vertices and normals as they do in the materials of three.js.
const vertexShader = /* glsl */ `
#include <common>
#include <batching_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>

varying vec3 vNormal;
varying vec3 vViewPosition;

void main() {
    #include <batching_vertex>
    #include <beginnormal_vertex>
    #include <morphinstance_vertex>
    #include <morphnormal_vertex>
    #include <skinbase_vertex>
    #include <skinnormal_vertex>
    #include <defaultnormal_vertex>
    vNormal = transformedNormal;
    #include <begin_vertex>
    #include <morphtarget_vertex>
    #include <skinning_vertex>
    #include <project_vertex>
    vViewPosition = -mvPosition.xyz;
}
`;

// Lights are in view space; a light's colour is its irradiance on a surface that faces it, as in the materials of three.js.
const fragmentShader = /* glsl */ `
#include <common>
#include <lights_pars_begin>

uniform vec3 motes_albedo;
varying vec3 vNormal;
varying vec3 vViewPosition;

vec3 motes_lit(vec3 N, vec3 V, vec3 L, vec3 irradiance) {
    vec3 tangent = normalize(cross(abs(N.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), N));
    vec3 bitangent = cross(N, tangent);
    vec3 wi = vec3(dot(L, tangent), dot(L, bitangent), dot(L, N));
    vec3 wo = vec3(dot(V, tangent), dot(V, bitangent), dot(V, N));
    return motes_eval(wi, wo) * irradiance * max(wi.z, 0.0);
}

float motes_falloff(float distanceToLight, float cutoff, float decay) {
    float falloff = pow(max(distanceToLight, 0.01), -decay);
    if (cutoff <= 0.0) return falloff;
    float window = clamp(1.0 - pow(distanceToLight / cutoff, 4.0), 0.0, 1.0);
    return falloff * window * window;
}

void main() {
    vec3 N = normalize(vNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 V = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition);
    vec3 outgoing = motes_albedo * ambientLightColor / 3.141592653589793;

    #if NUM_DIR_LIGHTS > 0
    for (int k = 0; k < NUM_DIR_LIGHTS; ++k) {
        outgoing += motes_lit(N, V, directionalLights[k].direction, directionalLights[k].color);
    }
    #endif
    #if NUM_POINT_LIGHTS > 0
    for (int k = 0; k < NUM_POINT_LIGHTS; ++k) {
        vec3 toward = pointLights[k].position + vViewPosition;
        float falloff = motes_falloff(length(toward), pointLights[k].distance, pointLights[k].decay);
        outgoing += motes_lit(N, V, normalize(toward), pointLights[k].color * falloff);
    }
    #endif
    #if NUM_SPOT_LIGHTS > 0
    for (int k = 0; k < NUM_SPOT_LIGHTS; ++k) {
        vec3 toward = spotLights[k].position + vViewPosition;
        float falloff = motes_falloff(length(toward), spotLights[k].distance, spotLights[k].decay);
        float cone = smoothstep(spotLights[k].coneCos, spotLights[k].penumbraCos, dot(normalize(toward), spotLights[k].direction));
        outgoing += motes_lit(N, V, normalize(toward), spotLights[k].color * falloff * cone);
    }
    #endif
    #if NUM_HEMI_LIGHTS > 0
    for (int k = 0; k < NUM_HEMI_LIGHTS; ++k) {
        float above = 0.5 * dot(N, hemisphereLights[k].direction) + 0.5;
        vec3 irradiance = mix(hemisphereLights[k].groundColor, hemisphereLights[k].skyColor, above);
        outgoing += motes_albedo * irradiance / 3.141592653589793;
    }
    #endif
    gl_FragColor = vec4(outgoing, 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
}
`;

function shaderMaterial(THREE, options) {
    const own = { motes_albedo: { value: new THREE.Vector3(...albedo) } };
    for (const parameter of parameters) own[parameter.uniform] = { value: parameter.value };
    return new THREE.ShaderMaterial({
        name,
        lights: true,
        uniforms: THREE.UniformsUtils.merge([THREE.UniformsLib.lights, own]),
        vertexShader,
        fragmentShader: fragmentShader.replace('uniform vec3 motes_albedo;', () => `uniform vec3 motes_albedo;\n${formula}`),
        ...options,
    });
}

// A material that answers to the lights of its scene: a ShaderMaterial for WebGLRenderer, with three/webgpu a NodeMaterial for WebGPURenderer.
//
//     import * as THREE from 'three';  // or 'three/webgpu'
//     import { createMaterial } from './material.js';
//     const mesh = new THREE.Mesh(geometry, createMaterial(THREE));
//
// `values` replaces parameters, by name: { tau: 0.5, K_d: [0.8, 0.7, 0.6] }; `options` go to the material.
export function createMaterial(THREE, values = {}, options = {}) {
    const material = THREE.NodeMaterial ? new (nodeMaterialOf(THREE))(options) : shaderMaterial(THREE, options);
    for (const [key, value] of Object.entries(values)) setParameter(material, key, value);
    return material;
}

// Change a parameter of a material that createMaterial made; a number serves for all channels.  Of WebGPURenderer it may be a node of TSL, too.
export function setParameter(material, key, value) {
    const parameter = parameters.find((candidate) => candidate.name === key);
    if (!parameter) throw new Error(`no parameter ${key}: there are ${parameters.map((p) => p.name).join(', ')}`);
    if (value?.isNode && material.isNodeMaterial) return material.setParameter(parameter, value);
    const wanted = Array.isArray(parameter.value) && !Array.isArray(value) ? [value, value, value] : value;
    for (const number of [wanted].flat()) {
        const low = parameter.min ?? -Infinity;
        const high = parameter.max ?? Infinity;
        if (!(number >= low && number <= high)) throw new RangeError(`${key} = ${number} is outside ${low} to ${high}`);
    }
    if (material.isNodeMaterial) material.setParameter(parameter, wanted);
    else material.uniforms[parameter.uniform].value = wanted;
}
