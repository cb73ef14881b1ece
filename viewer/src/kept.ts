// What a shader computes from parameters alone, where that is long: a table of it over the share of the layer that lies at a place.

import { DataTexture, FloatType, GLSL3, Mesh, OrthographicCamera, PlaneGeometry, RGBAFormat, Scene, ShaderMaterial, type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import { SHARES, type ShaderView } from './generated';
import { FULL_VERTEX, uniformValues, withShare } from './glsl';
import type { Material, Values } from './material';
import { bytes } from './packed';
import { target } from './passes';

/** Each number of the variables, in order: its text, and how it is written from a number. */
function numbers(shader: ShaderView): { read: string; write: (value: string) => string }[] {
  return shader.kept.flatMap(({ name, type }) => {
    if (type === 'bool') return [{ read: `(${name} ? 1.0 : 0.0)`, write: (value) => `${name} = ${value} > 0.5;` }];
    const parts = type === 'vec3' ? ['.x', '.y', '.z'] : [''];
    return parts.map((part) => ({ read: name + part, write: (value: string) => `${name}${part} = ${value};` }));
  });
}

/** `void begin(vec3 wo, float share)`, before `name_light`: the parameters' part out of the table, where there is one. */
export function beginning(material: Material): string {
  const { shader } = material;
  if (!shader.stages) return 'void begin(vec3 wo, float share) {}';
  const arguments_ = withShare(material, 'share');
  const view = `${shader.name}_view(${['wo', ...arguments_].join(', ')});`;
  if (!shader.kept.length) return `void begin(vec3 wo, float share) {\n  ${shader.name}_parameters(${arguments_.join(', ')});\n  ${view}\n}`;
  const all = numbers(shader);
  const rows = Array.from({ length: Math.ceil(all.length / 4) }, (_, row) => [
    `  row = mix(texelFetch(kept, ivec2(column, ${row}), 0), texelFetch(kept, ivec2(column + 1, ${row}), 0), part);`,
    ...all.slice(4 * row, 4 * row + 4).map(({ write }, k) => `  ${write(`row.${'xyzw'[k]}`)}`),
  ]).flat();
  return [
    'uniform sampler2D kept;',
    'void begin(vec3 wo, float share) {',
    // Between no dust and the least of it nothing is tabulated.
    `  float place = share > 0.0 ? clamp(pow(share, 1.0 / 3.0) * ${SHARES - 1}.0, 1.0, ${SHARES - 1}.0) : 0.0;`,
    `  int column = min(int(place), ${SHARES - 2});`,
    '  float part = place - float(column);',
    '  vec4 row;',
    ...rows,
    `  ${view}`,
    '}',
  ].join('\n');
}

/** A table that Motes made: for each share its numbers, four to a texel and a row of these for each four. */
function tabulated(data: ArrayBuffer, count: number, rows: number): DataTexture {
  const numbers = new Float32Array(data);
  const texels = new Float32Array(4 * SHARES * rows);
  for (let share = 0; share < SHARES; share += 1) {
    for (let k = 0; k < count; k += 1) texels[4 * (Math.floor(k / 4) * SHARES + share) + (k % 4)] = numbers[share * count + k]!;
  }
  const texture = new DataTexture(texels, SHARES, rows, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** The table of one material, drawn anew when its values change. */
export class Kept {
  private target: WebGLRenderTarget;
  private readonly program: ShaderMaterial;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly quad: Mesh<PlaneGeometry, ShaderMaterial>;
  private drawn = '';
  /** That of the values that the page came with, which needs no program yet. */
  private given: DataTexture | null = null;

  constructor(private readonly material: Material) {
    const { shader } = material;
    const all = numbers(shader);
    const rows = Math.ceil(all.length / 4);
    const cases = Array.from({ length: rows }, (_, row) => `    case ${row}: value = vec4(${Array.from({ length: 4 }, (__, k) => all[4 * row + k]?.read ?? '0.0').join(', ')}); break;`);
    this.target = target(SHARES, rows, false);
    this.program = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: FULL_VERTEX,
      fragmentShader: `${shader.source}\nout vec4 value;\nvoid main() {\n  float share = floor(gl_FragCoord.x) / ${SHARES - 1}.0;\n  share *= share * share;\n  ${shader.name}_parameters(${withShare(material, 'share').join(', ')});\n  switch (int(gl_FragCoord.y)) {\n${cases.join('\n')}\n  }\n}`,
      depthTest: false,
      depthWrite: false,
    });
    this.quad = new Mesh(new PlaneGeometry(2, 2), this.program);
    this.quad.frustumCulled = false;
    this.scene.add(this.quad);
    if (shader.table) this.given = tabulated(bytes(shader.table.data), all.length, rows);
  }

  /** The table of these values. */
  texture(renderer: WebGLRenderer, values: Values): Texture {
    if (this.given && this.isGiven(values)) return this.given;
    const wanted = JSON.stringify(values);
    if (wanted !== this.drawn) {
      Object.assign(this.program.uniforms, uniformValues(this.material, values));
      this.program.uniformsNeedUpdate = true;
      renderer.setRenderTarget(this.target);
      renderer.render(this.scene, this.camera);
      this.drawn = wanted;
    }
    return this.target.texture;
  }

  /** Compile the program, which takes a while where the processor draws, before somebody moves a slider. */
  ready(renderer: WebGLRenderer, values: Values): void {
    if (!this.given) return;
    Object.assign(this.program.uniforms, uniformValues(this.material, values));
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, this.camera);
  }

  private isGiven(values: Values): boolean {
    const given = this.material.shader.table?.values ?? {};
    return Object.entries(given).every(([slot, numbers]) => numbers.every((x, k) => Math.abs(x - (values[slot]?.[k] ?? NaN)) <= 1e-6 * Math.abs(x)));
  }

  /** After a lost context came back. */
  revive(): void {
    this.target = target(SHARES, this.target.height, false);
    this.drawn = '';
  }

  dispose(): void {
    this.target.dispose();
    this.given?.dispose();
    this.program.dispose();
    this.quad.geometry.dispose();
  }
}
