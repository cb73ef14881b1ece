// The lobe in three dimensions: a surface whose distance from the middle is the BRDF (or f cos) in each direction, in a corner of the picture.

import { ArrowHelper, BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Line, LineBasicMaterial, LineLoop, Mesh, PerspectiveCamera, Scene, ShaderMaterial, GLSL3, LinearSRGBColorSpace, NearestFilter, Vector3, WebGLRenderTarget, type Texture, type WebGLRenderer } from 'three';
import { clamp, radians } from './dom';
import type { Material, Values } from './material';
import type { Probe } from './probe';
import { scaled } from './slice';
import type { State } from './state';

const RINGS = 40;
const SIDES = 72;
/** While things move every so many-th ring and side is drawn. */
const COARSE = 4;
const SAMPLES = 4;

const VERTEX = /* glsl */ `
in vec3 tint;
out vec3 vTint;
out vec3 vPosition;
void main() {
  vTint = tint;
  vPosition = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;
const FRAGMENT = /* glsl */ `
in vec3 vTint;
in vec3 vPosition;
out vec4 color;
void main() {
  vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  float facing = abs(dot(normal, normalize(cameraPosition - vPosition)));
  color = vec4(vTint * (0.35 + 0.65 * facing), 1.0);
}`;

/** Local directions (z the normal) in the scene (y up), light from the left: a half turn, no mirror image. */
const place = (x: number, y: number, z: number): [number, number, number] => [-x, z, y];

export class Lobe {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 50);
  private readonly wo: Float32Array;
  private readonly positions = new Float32Array(3 * (RINGS + 1) * SIDES);
  private readonly tints = new Float32Array(this.positions.length);
  private readonly geometry = new BufferGeometry();
  private readonly arrow = new ArrowHelper(new Vector3(0, -1, 0), new Vector3(), 1, asShown(0xe09020), 0.14, 0.08);
  private readonly lines = new LineBasicMaterial({ color: asShown(0x888888) });
  private readonly fine = triangles(1);
  private readonly coarse = triangles(COARSE);
  private target = picture(1);
  /** What of it is drawn. */
  private drawn = '';
  private version = 0;
  visible = true;
  /** The largest radius, in 1/sr: what 1 in the drawing stands for. */
  reach = 1;

  constructor() {
    const directions: number[] = [];
    for (let i = 0; i <= RINGS; i += 1) {
      const theta = (Math.min(i / RINGS, 1 - 1e-4) * Math.PI) / 2;
      for (let j = 0; j < SIDES; j += 1) {
        const phi = (2 * Math.PI * j) / SIDES;
        directions.push(Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta));
      }
    }
    this.wo = Float32Array.from(directions);
    this.geometry.setAttribute('position', new BufferAttribute(this.positions, 3));
    this.geometry.setAttribute('tint', new BufferAttribute(this.tints, 3));
    const surface = new Mesh(this.geometry, new ShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide }));
    surface.frustumCulled = false;
    this.scene.add(surface, this.ground(), this.arrow);
  }

  /** Follow the state: the BRDF for all directions at the angle of incidence. */
  update(state: State, material: Material, values: Values, probe: Probe): void {
    this.visible = state.lobe;
    if (!state.lobe) return;
    const theta = radians(state.incidence);
    const towards = [Math.sin(theta), 0, Math.cos(theta)];
    const count = this.wo.length / 3;
    const wi = new Float32Array(3 * count);
    for (let k = 0; k < count; k += 1) wi.set(towards, 3 * k);
    const f = probe.evaluate(material, values, wi, this.wo);
    const channels = material.shader.channels;
    const rgb = new Float32Array(3 * count);
    const radius = new Float32Array(count);
    for (let k = 0; k < count; k += 1) {
      let mean = 0;
      for (let c = 0; c < channels; c += 1) {
        const value = f[k * channels + c]!;
        mean += value / channels;
        for (let j = 0; j < 3; j += 1) rgb[3 * k + j]! += value * material.toSrgb[c]![j]!;
      }
      radius[k] = scaled(mean * (state.radius === 'f cos' ? this.wo[3 * k + 2]! : 1), state.scale);
    }
    let most = 0;
    for (const value of radius) if (value > most) most = value;
    this.reach = most || 1;
    const tint = new Color();
    for (let k = 0; k < count; k += 1) {
      const r = clamp(radius[k]! / this.reach, 0, 1);
      this.positions.set(place(this.wo[3 * k]! * r, this.wo[3 * k + 1]! * r, this.wo[3 * k + 2]! * r), 3 * k);
      const brightest = Math.max(rgb[3 * k]!, rgb[3 * k + 1]!, rgb[3 * k + 2]!, 1e-9);
      tint.setRGB(Math.max(rgb[3 * k]!, 0) / brightest, Math.max(rgb[3 * k + 1]!, 0) / brightest, Math.max(rgb[3 * k + 2]!, 0) / brightest);
      // The colour of the light that comes out; how much is the distance.
      this.tints.set([0.25 + 0.65 * tint.r ** 0.45, 0.25 + 0.65 * tint.g ** 0.45, 0.25 + 0.65 * tint.b ** 0.45], 3 * k);
    }
    this.geometry.getAttribute('position').needsUpdate = true;
    this.geometry.getAttribute('tint').needsUpdate = true;
    const from = new Vector3(...place(towards[0]!, towards[1]!, towards[2]!));
    this.arrow.position.copy(from.clone().multiplyScalar(1.12));
    this.arrow.setDirection(from.clone().negate());
    this.arrow.setLength(0.9, 0.13, 0.08);
    this.version += 1;
  }

  /** A picture of it for the lower left corner, seen from where the mesh is seen from, never from below. */
  draw(renderer: WebGLRenderer, main: PerspectiveCamera, size: number, moving: boolean): Texture {
    const towards = main.position.clone().normalize();
    towards.y = Math.max(towards.y, 0.16);
    this.camera.position.copy(towards.normalize().multiplyScalar(4.6)).add(new Vector3(0, 0.38, 0));
    const wanted = JSON.stringify([this.camera.position, size, moving, this.version]);
    if (wanted === this.drawn) return this.target.texture;
    this.camera.lookAt(0, 0.38, 0);
    this.geometry.setIndex(moving ? this.coarse : this.fine);
    this.target.setSize(size, size);
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(this.scene, this.camera);
    this.drawn = wanted;
    return this.target.texture;
  }

  /** After a lost context came back. */
  revive(): void {
    this.target = picture(1);
    this.drawn = '';
  }

  private ground(): Group {
    const group = new Group();
    for (const radius of [0.5, 1]) {
      const ring = Array.from({ length: 64 }, (_, k) => new Vector3(Math.cos((k * Math.PI) / 32) * radius, 0, Math.sin((k * Math.PI) / 32) * radius));
      group.add(new LineLoop(new BufferGeometry().setFromPoints(ring), this.lines));
    }
    group.add(new Line(new BufferGeometry().setFromPoints([new Vector3(-1, 0, 0), new Vector3(1, 0, 0)]), this.lines));
    return group;
  }
}

/** Triangles between every `step`-th ring and side. */
function triangles(step: number): BufferAttribute {
  const corners: number[] = [];
  for (let i = 0; i < RINGS; i += step) {
    for (let j = 0; j < SIDES; j += step) {
      const [a, b] = [i * SIDES + j, i * SIDES + ((j + step) % SIDES)];
      const below = step * SIDES;
      corners.push(a, a + below, b, b, a + below, b + below);
    }
  }
  return new BufferAttribute(Uint16Array.from(corners), 1);
}

const picture = (size: number): WebGLRenderTarget => new WebGLRenderTarget(size, size, { samples: SAMPLES, minFilter: NearestFilter, magFilter: NearestFilter });

/** A colour of the screen, as it is: what is drawn here is shown without another word. */
const asShown = (hex: number): Color => new Color().setHex(hex, LinearSRGBColorSpace);
