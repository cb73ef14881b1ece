// Values of the printed shader for lists of directions, read back from the GPU: what all plots are drawn from.

import { DataTexture, FloatType, Mesh, NearestFilter, OrthographicCamera, PlaneGeometry, RGBAFormat, Scene, GLSL3, ShaderMaterial, WebGLRenderTarget, type WebGLRenderer } from 'three';
import { FULL_VERTEX, probeFragment, uniformValues } from './glsl';
import type { Material, Values } from './material';

const WIDTH = 256;

export class Probe {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly mesh = new Mesh(new PlaneGeometry(2, 2));
  private readonly programs = new Map<Material, ShaderMaterial>();
  private target: WebGLRenderTarget | null = null;

  constructor(private readonly renderer: WebGLRenderer) {
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** The BRDF [1/sr] for pairs of directions, three numbers each; `channels` numbers a pair. */
  evaluate(material: Material, values: Values, wi: ArrayLike<number>, wo: ArrayLike<number>): Float32Array {
    const count = wi.length / 3;
    const channels = material.shader.channels;
    const found = new Float32Array(count * channels);
    if (!count) return found;
    const height = Math.ceil(count / WIDTH);
    const [toLight, toViewer] = [this.texture(wi, height), this.texture(wo, height)];
    if (!this.target || this.target.height !== height) {
      this.target?.dispose();
      this.target = new WebGLRenderTarget(WIDTH, height, { type: FloatType, format: RGBAFormat, minFilter: NearestFilter, magFilter: NearestFilter, depthBuffer: false });
    }
    const program = this.program(material);
    Object.assign(program.uniforms, uniformValues(material, values));
    this.mesh.material = program;
    const pixels = new Float32Array(4 * WIDTH * height);
    const step = channels <= 3 ? 3 : 4;
    for (let first = 0; first < channels; first += step) {
      program.uniforms['toLight'] = { value: toLight };
      program.uniforms['toViewer'] = { value: toViewer };
      program.uniforms['firstChannel'] = { value: first };
      program.uniformsNeedUpdate = true;
      this.renderer.setRenderTarget(this.target);
      this.renderer.render(this.scene, this.camera);
      this.renderer.readRenderTargetPixels(this.target, 0, 0, WIDTH, height, pixels);
      const width = Math.min(step, channels - first);
      for (let k = 0; k < count; k += 1) for (let c = 0; c < width; c += 1) found[k * channels + first + c] = pixels[4 * k + c]!;
    }
    this.renderer.setRenderTarget(null);
    toLight.dispose();
    toViewer.dispose();
    return found;
  }

  /** Keep the programs of these materials alone. */
  keep(materials: readonly (Material | null)[]): void {
    for (const [material, program] of this.programs) {
      if (materials.includes(material)) continue;
      program.dispose();
      this.programs.delete(material);
    }
  }

  /** After a lost context came back. */
  revive(): void {
    this.target = null;
  }

  private program(material: Material): ShaderMaterial {
    let program = this.programs.get(material);
    if (!program) {
      program = new ShaderMaterial({ glslVersion: GLSL3, vertexShader: FULL_VERTEX, fragmentShader: probeFragment(material), depthTest: false, depthWrite: false });
      this.programs.set(material, program);
    }
    return program;
  }

  private texture(directions: ArrayLike<number>, height: number): DataTexture {
    const data = new Float32Array(4 * WIDTH * height);
    for (let k = 0; k < directions.length / 3; k += 1) for (let j = 0; j < 3; j += 1) data[4 * k + j] = directions[3 * k + j]!;
    const texture = new DataTexture(data, WIDTH, height, RGBAFormat, FloatType);
    texture.needsUpdate = true;
    return texture;
  }
}
