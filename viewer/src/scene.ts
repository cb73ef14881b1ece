// The picture: a mesh of the material under a lamp and a sky, refined while nothing changes, tone mapped; the lobe in a corner.

import {
  AgXToneMapping,
  BackSide,
  GLSL3,
  LinearToneMapping,
  Mesh,
  NeutralToneMapping,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  WebGLRenderer,
  type WebGLRenderTarget,
  type BufferGeometry,
  type DataTexture,
  type Texture,
} from 'three';
import { radians } from './dom';
import { directionsTexture, DIRECTIONS, radianceMap, upward } from './environment';
import { backdropTexture, BACKDROP_FRAGMENT, BACKDROP_VERTEX } from './backdrop';
import { groundMaterial, groundOf } from './ground';
import { uniformValues } from './glsl';
import { Kept } from './kept';
import type { Lobe } from './lobe';
import { direction, shadeMaterial } from './lighting';
import type { Material, Values } from './material';
import { AT_REST, MOST, Pace } from './pace';
import { AVERAGE, CORNER, halton, quadMaterial, SHOW, target } from './passes';
import { Problem } from './problem';
import type { State } from './state';
import { Surface, type Part } from './surface';

const TONES = { neutral: NeutralToneMapping, agx: AgXToneMapping, clip: LinearToneMapping };
const LAMP_DISTANCE = 6;
/** A finished picture has at least so many frames, each with its own place in the pixels, and all directions of the sky. */
const FRAMES = 16;
/** The side of the lobe's picture, in parts of the shorter side of the whole. */
const CORNER_SHARE = 0.34;
/** On a slow machine the picture counts as at rest after so long. */
const SETTLED_MS = 120;
interface Shown {
  material: Material;
  program: ShaderMaterial;
  kept: Kept | null;
}

export class Picture {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(30, 1, 0.05, 100);
  private readonly scene = new Scene();
  private readonly surface = new Surface();
  private readonly mesh = this.surface.mesh;
  private readonly backdrop: Mesh<SphereGeometry, ShaderMaterial>;
  private readonly ground = new Mesh<BufferGeometry, ShaderMaterial>(undefined, groundMaterial());
  /** Whether the ground is that of another mesh still: the first picture does without. */
  private groundDue = true;
  private shownOnce = false;
  /** The radiance that a white diffuser facing up gets of the surroundings. */
  private up = 0;
  /** A sky of the user's. */
  own: Float32Array | null = null;
  private readonly flat = new Scene();
  private readonly flatCamera = new OrthographicCamera();
  private readonly quad = new Mesh(new PlaneGeometry(2, 2));
  private readonly averaging = quadMaterial(AVERAGE, GLSL3, { before: { value: null }, now: { value: null }, share: { value: 1 } });
  private readonly showing = quadMaterial(SHOW, null, { average: { value: null } });
  private readonly corner = quadMaterial(CORNER, GLSL3, { corner: { value: null } });
  private shown: Shown[] = [];
  private sample: WebGLRenderTarget;
  private sums: [WebGLRenderTarget, WebGLRenderTarget];
  private frame = 0;
  private drawn = 0;
  private environment = '';
  private sky: DataTexture | null = null;
  private moved = true;
  /** Whether no light comes from the surroundings. */
  private dark = false;
  readonly pace = new Pace();
  private movedAt = 0;
  /** Rows that this pass has drawn. */
  private row = 0;
  /** Whether something else than a further pass is to be shown. */
  stale = true;
  lobe: Lobe | null = null;

  constructor(readonly canvas: HTMLCanvasElement) {
    // The drawing buffer is kept for those who copy the picture.
    const attributes: WebGLContextAttributes = { antialias: false, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' };
    const context = canvas.getContext('webgl2', attributes);
    if (!context) throw new Problem('This browser has no WebGL 2, which the viewer draws with', 'Switch on hardware acceleration or try another browser; the pictures below stand in for it');
    if (!context.getExtension('EXT_color_buffer_float')) throw new Problem('This browser cannot draw into floating-point textures, which the viewer needs', 'Try another browser; the pictures below stand in for it');
    this.renderer = new WebGLRenderer({ canvas, context, antialias: false, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' });
    this.renderer.autoClear = false;
    this.renderer.setClearColor(0x000000, 0);
    this.quad.frustumCulled = false;
    this.flat.add(this.quad);
    this.backdrop = new Mesh(
      new SphereGeometry(40, 32, 16),
      new ShaderMaterial({ glslVersion: GLSL3, vertexShader: BACKDROP_VERTEX, fragmentShader: BACKDROP_FRAGMENT, side: BackSide, depthWrite: false, uniforms: { sky: { value: null }, strength: { value: 1 } } }),
    );
    this.ground.frustumCulled = false;
    Object.assign(this.corner, { transparent: true, premultipliedAlpha: true });
    this.scene.add(this.backdrop, this.ground);
    this.sample = target(1, 1, false);
    this.sums = [target(1, 1, false), target(1, 1, false)];
  }

  /** The materials that are drawn, the second only when it is compared. */
  setMaterials(materials: readonly Material[]): void {
    const before = this.shown;
    this.shown = materials.map((material) => before.find((each) => each.material === material) ?? { material, program: shadeMaterial(material), kept: material.shader.kept.length ? new Kept(material) : null });
    for (const old of before) if (!this.shown.includes(old)) forget(old);
    this.restart();
  }

  setGeometry(geometry: BufferGeometry): void {
    this.mesh.geometry = geometry;
    this.groundDue = true;
    this.restart();
  }

  /** The canvas follows its box; returns whether it changed. */
  resize(width: number, height: number, ratio: number): void {
    const [w, h] = [Math.max(Math.round(width * ratio), 1), Math.max(Math.round(height * ratio), 1)];
    if (this.sample.width === w && this.sample.height === h) return;
    this.sample.setSize(w, h);
    this.surface.setSize(w, h);
    for (const sum of this.sums) sum.setSize(w, h);
    this.restart();
  }

  /** A sky of the user's, for the surroundings called `own`. */
  setOwn(map: Float32Array): void {
    this.own = map;
    this.environment = '';
    this.restart();
  }

  restart(): void {
    this.frame = 0;
    this.drawn = 0;
    this.row = 0;
    this.moved = true;
  }

  /** Everything is drawn that can be: nothing would change. */
  get complete(): boolean {
    return this.frame >= FRAMES && (this.dark || this.drawn >= DIRECTIONS);
  }

  /** The part of the finished picture that is there, 0 to 1. */
  get progress(): number {
    return Math.min(this.frame / FRAMES, this.dark ? 1 : this.drawn / DIRECTIONS, 1);
  }

  /** One more frame: while things move coarsely where the machine is slow, else added to those before. */
  draw(state: State, values: readonly Values[]): void {
    if (state.environment !== this.environment) this.setEnvironment(state.environment);
    this.dark = state.environment === 'none' || state.sky === 0;
    if (this.groundDue && this.shownOnce) {
      this.ground.geometry.dispose();
      this.ground.geometry = groundOf(this.mesh.geometry);
      this.groundDue = false;
      // What the first picture did without, and what the first change will ask for.
      this.shown.forEach(({ kept }, k) => kept?.ready(this.renderer, values[k]!));
    }
    const now = performance.now();
    if (this.moved) this.movedAt = now;
    // Whoever turns the shape on a slow machine makes pauses of a frame or two, and a fine pass in one of them would hold up the next move.
    else if (this.pace.coarseness > 1 && this.frame === 0 && this.row === 0 && now - this.movedAt < SETTLED_MS) return;
    this.pace.follow(now, this.moved, this.sample.height);
    const coarse = this.moved ? this.pace.coarseness : 1;
    let passed = this.moved || this.complete;
    if (this.moved && coarse > 1) this.shade(state, values, ...this.size(coarse), this.pace.batch);
    else if (!this.complete) passed = this.pass(state, values);
    if (passed || (this.stale && this.frame > 0)) {
      const [width, height] = this.fit(coarse);
      this.show(state, coarse === 1 ? this.sums[0] : this.sample, width, height);
      if (this.lobe?.visible) this.cover(this.lobe.draw(this.renderer, this.camera, Math.round(Math.min(width, height) * CORNER_SHARE), coarse > 1));
      this.stale = false;
      this.shownOnce = true;
    }
    this.moved = false;
  }

  /** Width and height of the picture where so many pixels to the side are one. */
  private size(coarse: number): [number, number] {
    return [Math.ceil(this.sample.width / coarse), Math.ceil(this.sample.height / coarse)];
  }

  /** The canvas at that size, which the page stretches: bringing pixels to the screen takes longer than shading a plain material. */
  private fit(coarse: number): [number, number] {
    const [width, height] = this.size(coarse);
    if (this.canvas.width !== width || this.canvas.height !== height) this.renderer.setSize(width, height, false);
    return [width, height];
  }

  /** Some rows of the picture, or all of them, with the next directions; whether it is whole. */
  private pass(state: State, values: readonly Values[]): boolean {
    const { width, height } = this.sample;
    const count = Math.min(this.moved ? this.pace.batch : Math.min(Math.max(this.drawn, AT_REST), MOST), DIRECTIONS - (this.drawn % DIRECTIONS));
    const rows = this.moved ? height : Math.max(Math.floor(this.pace.budget / count), 1);
    const end = Math.min(this.row + rows, height);
    this.shade(state, values, width, height, count, this.row, end);
    this.row = end % height;
    if (this.row) return false;
    this.drawn += count;
    this.add(count / this.drawn);
    this.frame += 1;
    return true;
  }

  /** The materials on the mesh, into the lower left corner of `sample`, of its rows some; the mesh is looked at with the first of them. */
  private shade(state: State, values: readonly Values[], w: number, h: number, count: number, first = 0, end = h): void {
    const renderer = this.renderer;
    const tables = this.shown.map(({ kept }, k) => kept?.texture(renderer, values[k]!) ?? null);
    this.place(state, w, h);
    const parts = this.parts(state, w);
    if (first === 0) this.surface.draw(renderer, this.camera, h, parts);
    this.sample.scissorTest = true;
    this.sample.scissor.set(0, first, w, end - first);
    renderer.setRenderTarget(this.sample);
    renderer.clear();
    parts.forEach((part, k) => {
      const { view, shown } = part;
      const { material, program } = this.shown[k]!;
      Object.assign(program.uniforms, uniformValues(material, values[k]!));
      this.light(program, state, count);
      this.surface.tell(program, this.camera);
      program.uniforms['kept']!.value = tables[k];
      this.sample.viewport.set(view[0], 0, view[1], h);
      this.sample.scissor.set(shown[0], first, shown[1], end - first);
      renderer.setRenderTarget(this.sample);
      // Whoever sees the ground sees no part of the mesh below it.
      if (this.backdrop.visible || this.ground.visible) renderer.render(this.scene, this.camera);
      const [left, right, low, high] = this.surface.bounds(this.camera, h, part);
      const [from, to] = [Math.max(low, first), Math.min(high, end)];
      if (right <= left || to <= from) return;
      this.sample.scissor.set(left, from, right - left, to - from);
      renderer.setRenderTarget(this.sample);
      this.quad.material = program;
      renderer.render(this.flat, this.flatCamera);
    });
  }

  /** Linear sRGB of the picture so far, four numbers a pixel, the bottom row first. */
  radiance(): { width: number; height: number; data: Float32Array } {
    const { width, height } = this.sums[0];
    const data = new Float32Array(4 * width * height);
    this.renderer.readRenderTargetPixels(this.sums[0], 0, 0, width, height, data);
    return { width, height, data };
  }

  /** After a lost context came back: what it held is gone, and must not be deleted in the new one. */
  revive(): void {
    const { width, height } = this.sample;
    this.sample = target(width, height, false);
    this.sums = [target(width, height, false), target(width, height, false)];
    this.surface.revive();
    this.lobe?.revive();
    for (const { kept } of this.shown) kept?.revive();
    this.environment = '';
    this.sky = null;
    this.backdrop.material.uniforms['sky']!.value = null;
    this.restart();
  }

  dispose(): void {
    for (const each of this.shown) forget(each);
    for (const each of [this.sample, ...this.sums]) each.dispose();
    this.sky?.dispose();
    this.surface.dispose();
    this.ground.geometry.dispose();
    this.ground.material.dispose();
    this.renderer.dispose();
  }

  /** For each material its part of the picture. */
  private parts(state: State, w: number): Part[] {
    if (this.shown.length < 2) return [{ view: [0, w], shown: [0, w] }];
    if (state.compare === 'side') return [[0, Math.floor(w / 2)] as const, [Math.ceil(w / 2), Math.floor(w / 2)] as const].map(([x, width]) => ({ view: [x, width], shown: [x, width] }));
    const cut = Math.round(w * state.split);
    return [{ view: [0, w], shown: [0, cut] }, { view: [0, w], shown: [cut, w - cut] }];
  }

  private place(state: State, w: number, h: number): void {
    const aspect = this.shown.length > 1 && state.compare === 'side' ? w / 2 / h : w / h;
    this.camera.aspect = aspect;
    // What fits a square also fits a narrow picture: the distance grows.
    const distance = state.distance * Math.max(1, 1 / aspect);
    this.camera.position.copy(direction(state.azimuth, state.elevation)).multiplyScalar(distance);
    this.camera.lookAt(0, 0, 0);
    // Each frame samples another place of the pixels; the first their middle.
    const jitter = [halton(this.frame, 2), halton(this.frame, 3)];
    this.camera.setViewOffset(w, h, jitter[0]!, jitter[1]!, w, h);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.backdrop.visible = state.backdrop && state.environment !== 'none';
    // What a white ground gets of the surroundings, of all that it gets with the lamp.
    const [sky, lamp] = [this.up * state.sky, state.lamp * Math.max(Math.sin(radians(state.lampElevation)), 0)];
    this.ground.visible = state.ground && !this.groundDue && !this.dark && !this.backdrop.visible;
    this.ground.material.uniforms['strength']!.value = sky > 0 ? sky / (sky + lamp) : 0;
  }

  private light(program: ShaderMaterial, state: State, count: number): void {
    const uniforms = program.uniforms;
    uniforms['lampPosition']!.value.copy(direction(state.lampAzimuth, state.lampElevation)).multiplyScalar(LAMP_DISTANCE);
    uniforms['lampStrength']!.value = state.lamp;
    uniforms['skyDirections']!.value = this.sky;
    uniforms['skyFirst']!.value = this.drawn % DIRECTIONS;
    uniforms['skyCount']!.value = this.dark ? 0 : count;
    uniforms['skyStrength']!.value = state.sky;
    uniforms['painted']!.value = state.dust ? 1 : 0;
    program.uniformsNeedUpdate = true;
    this.backdrop.material.uniforms['strength']!.value = state.sky;
  }

  /** The mean of all frames, each counted by its directions: the new one has this share. */
  private add(share: number): void {
    const renderer = this.renderer;
    this.averaging.uniforms['before']!.value = this.sums[0].texture;
    this.averaging.uniforms['now']!.value = this.sample.texture;
    this.averaging.uniforms['share']!.value = share;
    this.quad.material = this.averaging;
    renderer.setRenderTarget(this.sums[1]);
    renderer.render(this.flat, this.flatCamera);
    this.sums = [this.sums[1], this.sums[0]];
  }

  private show(state: State, shown: WebGLRenderTarget, width: number, height: number): void {
    const renderer = this.renderer;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    renderer.toneMapping = TONES[state.tone as keyof typeof TONES] ?? NeutralToneMapping;
    renderer.toneMappingExposure = 2 ** state.exposure;
    this.showing.uniforms['average']!.value = shown.texture;
    this.quad.material = this.showing;
    renderer.render(this.flat, this.flatCamera);
  }

  /** A square picture in the lower left corner, over what is shown. */
  private cover(picture: Texture): void {
    const { renderer, corner } = this;
    const { width, height } = picture.image as { width: number; height: number };
    corner.uniforms['corner']!.value = picture;
    this.quad.material = corner;
    renderer.setRenderTarget(null);
    renderer.setViewport(0, 0, width, height);
    renderer.render(this.flat, this.flatCamera);
  }

  /** Draw a pixel, so that whoever draws compiles what the first picture needs while the page is built. */
  prepare(state: State, values: readonly Values[], geometry: BufferGeometry): void {
    this.mesh.geometry = geometry;
    this.shade(state, values, 1, 1, 1);
    this.show(state, this.sample, 1, 1);
    this.renderer.getContext().flush();
  }

  private setEnvironment(name: string): void {
    this.sky?.dispose();
    const map = name === 'own' ? (this.own ?? radianceMap('studio')) : radianceMap(name);
    this.up = upward(map);
    this.sky = directionsTexture(map);
    const uniforms = this.backdrop.material.uniforms;
    (uniforms['sky']!.value as DataTexture | null)?.dispose();
    uniforms['sky']!.value = backdropTexture(map);
    this.environment = name;
  }
}

function forget({ program, kept }: Shown): void {
  program.dispose();
  kept?.dispose();
}
