// The sky behind the mesh, as a picture of its map.

import { DataTexture, FloatType, RGBAFormat } from 'three';
import { HEIGHT, WIDTH } from './environment';

export const BACKDROP_VERTEX = /* glsl */ `
out vec3 vDirection;
void main() {
  vDirection = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position + cameraPosition, 1.0);
}`;

// Interpolated by hand: float textures need an extension to be filtered.
export const BACKDROP_FRAGMENT = /* glsl */ `
uniform sampler2D sky;
uniform float strength;
in vec3 vDirection;
out vec4 color;
const ivec2 SIZE = ivec2(${WIDTH}, ${HEIGHT});
vec3 cell(ivec2 at) { return texelFetch(sky, ivec2((at.x + SIZE.x) % SIZE.x, clamp(at.y, 0, SIZE.y - 1)), 0).xyz; }
void main() {
  vec3 w = normalize(vDirection);
  vec2 place = vec2(atan(w.x, w.z) / 6.283185307, acos(clamp(w.y, -1.0, 1.0)) / 3.141592654) * vec2(SIZE) - 0.5;
  ivec2 at = ivec2(floor(place));
  vec2 part = place - vec2(at);
  vec3 above = mix(cell(at), cell(at + ivec2(1, 0)), part.x);
  vec3 below = mix(cell(at + ivec2(0, 1)), cell(at + ivec2(1, 1)), part.x);
  color = vec4(mix(above, below, part.y) * strength, 1.0);
}`;

/** The map as a texture. */
export function backdropTexture(map: Float32Array): DataTexture {
  const data = new Float32Array((map.length / 3) * 4);
  for (let k = 0; k < map.length / 3; k += 1) data.set(map.subarray(3 * k, 3 * k + 3), 4 * k);
  const texture = new DataTexture(data, WIDTH, HEIGHT, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
