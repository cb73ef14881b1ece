// The program that lights what is seen of a mesh: a material under the lamp and the sky.

import { GLSL3, ShaderMaterial, Vector3 } from 'three';
import { radians } from './dom';
import { shadeFragment } from './glsl';
import { beginning } from './kept';
import type { Material } from './material';
import { SEEN_VERTEX, seenUniforms } from './surface';

/** Where the camera or the lamp stands: a unit vector, y up, by its azimuth from z over x and its elevation [degrees]. */
export function direction(azimuth: number, elevation: number): Vector3 {
  const [a, e] = [radians(azimuth), radians(elevation)];
  return new Vector3(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e));
}

export function shadeMaterial(material: Material): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: SEEN_VERTEX,
    fragmentShader: shadeFragment(material, beginning(material)),
    uniforms: {
      ...seenUniforms(),
      lampPosition: { value: new Vector3() },
      lampStrength: { value: 1 },
      skyDirections: { value: null },
      skyFirst: { value: 0 },
      skyCount: { value: 0 },
      skyStrength: { value: 1 },
      painted: { value: 0 },
      kept: { value: null },
    },
    depthTest: false,
    depthWrite: false,
  });
}
