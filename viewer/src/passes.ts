// Passes over the whole picture: the mean of frames, and what is shown of it; where in the pixels each frame samples.

import { FloatType, NearestFilter, RGBAFormat, ShaderMaterial, WebGLRenderTarget, type GLSLVersion } from 'three';
import { FULL_VERTEX } from './glsl';

export const AVERAGE = /* glsl */ `
uniform sampler2D before;
uniform sampler2D now;
uniform float share;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = mix(texelFetch(before, at, 0), texelFetch(now, at, 0), share);
}`;

// Tone mapping works on what covers a pixel, which then covers it by its share.  three.js fills in its operators here.
export const SHOW = /* glsl */ `
uniform sampler2D average;
void main() {
  gl_FragColor = texelFetch(average, ivec2(gl_FragCoord.xy), 0);
  float covered = gl_FragColor.a;
  if (covered > 0.0) gl_FragColor.rgb /= covered;
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  // Eight bits of a smooth slope would show as steps: noise of half a step to either side, the same at every frame, spreads them.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  if (covered > 0.0) gl_FragColor.rgb += noise / 255.0;
  gl_FragColor = vec4(gl_FragColor.rgb * covered, covered);
}`;

/** A picture that covers a corner by its alpha, which its colours have been multiplied by. */
export const CORNER = /* glsl */ `
uniform sampler2D corner;
out vec4 color;
void main() { color = texelFetch(corner, ivec2(gl_FragCoord.xy), 0); }`;

/** Four floats a pixel, as they are. */
export function target(width: number, height: number, depthBuffer: boolean): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, { type: FloatType, format: RGBAFormat, minFilter: NearestFilter, magFilter: NearestFilter, depthBuffer });
}

export function quadMaterial(fragmentShader: string, glslVersion: GLSLVersion | null, uniforms: Record<string, { value: unknown }>): ShaderMaterial {
  return new ShaderMaterial({ glslVersion, vertexShader: FULL_VERTEX, fragmentShader, uniforms, depthTest: false, depthWrite: false });
}

/** Halton's sequence about the middle, within half a pixel; 0 at first. */
export function halton(index: number, base: number): number {
  let [value, share, rest] = [0, 1, index];
  while (rest > 0) {
    share /= base;
    value += share * (rest % base);
    rest = Math.floor(rest / base);
  }
  return index === 0 ? 0 : value - 0.5;
}
