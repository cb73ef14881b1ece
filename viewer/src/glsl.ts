// The fragment shaders around a printed BRDF: one that shades what is seen of a mesh, one that evaluates lists of directions.

import type { Material, Values } from './material';
import { SEEN } from './surface';

/** Uniforms of a material's parameters. */
export function uniformValues(material: Material, values: Values): Record<string, { value: number | number[] }> {
  return Object.fromEntries(
    material.shader.uniforms.map((uniform) => {
      const value = values[uniform.slot]!;
      return [uniform.name, { value: uniform.size === 1 ? value[0]! : [...value] }];
    }),
  );
}

/** The uniforms as arguments; the layer's tau times `share` where the material has one. */
export function withShare(material: Material, share: string): string[] {
  return material.shader.uniforms.map((uniform) => (share && uniform.slot === material.tau ? `${uniform.name} * ${share}` : uniform.name));
}

/** A printed function of directions and of the uniforms. */
function call(material: Material, which: 'with' | 'light', share: string, output: string): string {
  return `${material.shader.name}_${which}(${['wi', 'wo', ...withShare(material, share), ...(output ? [output] : [])].join(', ')})`;
}

const spectral = (material: Material): boolean => material.shader.channels !== 1 && material.shader.channels !== 3;

/** `vec3 reflected(vec3 wi, vec3 wo, float share)`: the BRDF in linear sRGB, after `begin(wo, share)`. */
function reflected(material: Material): string {
  const { channels, stages } = material.shader;
  const which = stages ? 'light' : 'with';
  const rows = material.toSrgb.map((row) => `vec3(${row.map((x) => x.toPrecision(9)).map((x) => (/[.e]/.test(x) ? x : `${x}.0`)).join(', ')})`);
  const head = 'vec3 reflected(vec3 wi, vec3 wo, float share) {';
  if (channels === 1) return `${head}\n  return ${call(material, which, 'share', '')};\n}`;
  if (channels === 3) return `${head}\n  vec3 f = ${call(material, which, 'share', '')};\n  return f.x * ${rows[0]} + f.y * ${rows[1]} + f.z * ${rows[2]};\n}`;
  return [
    `const vec3 TO_SRGB[${channels}] = vec3[${channels}](${rows.join(', ')});`,
    head,
    `  float f[${channels}];`,
    `  ${call(material, which, 'share', 'f')};`,
    '  vec3 sum = vec3(0.0);',
    `  for (int k = 0; k < ${channels}; ++k) sum += f[k] * TO_SRGB[k];`,
    '  return sum;',
    '}',
  ].join('\n');
}

/** A point lamp, and directions drawn from the environment, each with its radiance over its density; `beginning` defines `begin(wo, share)`. */
export function shadeFragment(material: Material, beginning: string): string {
  return /* glsl */ `
${material.shader.source}
${beginning}
${reflected(material)}
uniform vec3 lampPosition;
uniform float lampStrength;
uniform sampler2D skyDirections;
uniform int skyFirst;
uniform int skyCount;
uniform float skyStrength;
uniform float painted;
${SEEN}
out vec4 color;
const float PI = 3.14159265358979;
const float GRAZING = 0.01;
vec3 lit(vec3 place, vec3 normal, float dust) {
  vec3 view = -normalize(vRay);
  vec3 side = normalize(cross(abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
  mat3 frame = transpose(mat3(side, cross(normal, side), normal));
  vec3 wo = frame * view;
  // Interpolated normals may turn away from the eye at an outline: such a point is seen at grazing.
  wo = normalize(vec3(wo.xy, max(wo.z, GRAZING)));
  float share = mix(1.0, dust, painted);
  begin(wo, share);
  vec3 toLamp = lampPosition - place;
  float squared = dot(toLamp, toLamp);
  // lampStrength: the radiance of a white diffuser at the middle that faces the lamp.
  vec3 weight = vec3(PI * lampStrength * dot(lampPosition, lampPosition) / squared);
  vec3 wi = frame * (toLamp * inversesqrt(squared));
  vec3 sum = vec3(0.0);
  // The lamp goes first through the same loop: where a BRDF is written twice, a processor that draws compiles it twice.
  // What lies below the horizon is passed over before: pixels side by side, which a processor computes together, seldom wait for each other then.
  int next = skyFirst;
  int end = skyFirst + skyCount;
  bool more = true;
  while (more) {
    if (wi.z > 0.0) sum += reflected(wi, wo, share) * (wi.z * weight);
    wi.z = 0.0;
    while (wi.z <= 0.0 && next < end) {
      wi = frame * texelFetch(skyDirections, ivec2((2 * next) & 255, (2 * next) >> 8), 0).xyz;
      next += 1;
    }
    more = wi.z > 0.0;
    int at = max(2 * next - 1, 0);
    weight = texelFetch(skyDirections, ivec2(at & 255, at >> 8), 0).xyz * (skyStrength / float(max(skyCount, 1)));
  }
  return sum;
}
void main() {
  vec3 place, normal;
  float dust;
  // A processor that draws computes what is discarded, but no branch that no pixel takes.
  if (seen(place, normal, dust)) color = vec4(lit(place, normal, dust), 1.0);
  else discard;
}`;
}

export const FULL_VERTEX = /* glsl */ `
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;

/** Values for lists of directions: four channels a pass from `firstChannel` on. */
export function probeFragment(material: Material): string {
  const { channels } = material.shader;
  const body = spectral(material)
    ? `float f[${channels}];\n  ${call(material, 'with', '', 'f')};\n  for (int k = 0; k < 4; ++k) if (firstChannel + k < ${channels}) found[k] = f[firstChannel + k];`
    : `found.xyz = ${call(material, 'with', '', '')};`;
  return /* glsl */ `
${material.shader.source}
uniform sampler2D toLight;
uniform sampler2D toViewer;
uniform int firstChannel;
out vec4 value;
void main() {
  vec3 wi = texelFetch(toLight, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 wo = texelFetch(toViewer, ivec2(gl_FragCoord.xy), 0).xyz;
  vec4 found = vec4(0.0);
  ${body}
  value = found;
}`;
}
