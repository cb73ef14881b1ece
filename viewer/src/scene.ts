// The picture: a mesh of the material under a lamp and a sky, refined while nothing changes, tone mapped; the lobe in a corner.

import {
  AgXToneMapping,
  BackSide,
  FloatType,
  GLSL3,
  LinearToneMapping,
  Mesh,
  NearestFilter,
  NeutralToneMapping,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
  type BufferGeometry,
  type DataTexture,
  type GLSLVersion,
} from 'three';
import { radians } from './dom';
import { directionsTexture, DIRECTIONS, radianceMap, upward } from './environment';
import { backdropTexture, BACKDROP_FRAGMENT, BACKDROP_VERTEX } from './backdrop';
import { groundMaterial, groundOf } from './ground';
import { FULL_VERTEX, SHADE_VERTEX, shadeFragment, uniformValues } from './glsl';
import type { Lobe } from './lobe';
import type { Material, Values } from './material';
import { Problem } from './problem';
import type { State } from './state';

const TONES = { neutral: NeutralToneMapping, agx: AgXToneMapping, clip: LinearToneMapping };
const LAMP_DISTANCE = 6;
/** A finished picture has at least so many frames, each with its own place in the pixels, and all directions of the sky. */
const FRAMES = 16;
/** Directions of the sky a frame: what the machine can do within the patience while things move, and not fewer at rest than the third. */
const FEWEST = 2;
const MOST = 64;
const AT_REST = 8;
const PATIENCE_MS = 45;

const AVERAGE = /* glsl */ `
uniform sampler2D before;
uniform sampler2D now;
uniform float share;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = mix(texelFetch(before, at, 0), texelFetch(now, at, 0), share);
}`;

// Tone mapping works on what covers a pixel, which then covers it by its share.  three.js fills in its operators here.
const SHOW = /* glsl */ `
uniform sampler2D average;
uniform int coarseness;
void main() {
  gl_FragColor = texelFetch(average, ivec2(gl_FragCoord.xy) / coarseness, 0);
  float covered = gl_FragColor.a;
  if (covered > 0.0) gl_FragColor.rgb /= covered;
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  // Eight bits of a smooth slope would show as steps: noise of half a step to either side, the same at every frame, spreads them.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  if (covered > 0.0) gl_FragColor.rgb += noise / 255.0;
  gl_FragColor = vec4(gl_FragColor.rgb * covered, covered);
}`;

interface Shown {
  material: Material;
  program: ShaderMaterial;
}

export class Picture {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(30, 1, 0.05, 100);
  private readonly scene = new Scene();
  private readonly mesh = new Mesh<BufferGeometry, ShaderMaterial>();
  private readonly backdrop: Mesh<SphereGeometry, ShaderMaterial>;
  private readonly ground = new Mesh<BufferGeometry, ShaderMaterial>(undefined, groundMaterial());
  /** The radiance that a white diffuser facing up gets of the surroundings. */
  private up = 0;
  /** A sky of the user's. */
  own: Float32Array | null = null;
  private readonly flat = new Scene();
  private readonly flatCamera = new OrthographicCamera();
  private readonly quad = new Mesh(new PlaneGeometry(2, 2));
  private readonly averaging = quadMaterial(AVERAGE, GLSL3, { before: { value: null }, now: { value: null }, share: { value: 1 } });
  private readonly showing = quadMaterial(SHOW, null, { average: { value: null }, coarseness: { value: 1 } });
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
  /** Directions of the sky a frame while things move, and how many pixels are drawn as one; both follow the machine. */
  batch = 4;
  coarseness = 2;
  private readonly times: number[] = [];
  lobe: Lobe | null = null;

  constructor(readonly canvas: HTMLCanvasElement) {
    // The drawing buffer is kept for those who copy the picture.
    const attributes: WebGLContextAttributes = { antialias: true, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' };
    const context = canvas.getContext('webgl2', attributes);
    if (!context) throw new Problem('This browser has no WebGL 2, which the viewer draws with', 'Switch on hardware acceleration or try another browser; the pictures below stand in for it');
    if (!context.getExtension('EXT_color_buffer_float')) throw new Problem('This browser cannot draw into floating-point textures, which the viewer needs', 'Try another browser; the pictures below stand in for it');
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' });
    this.renderer.autoClear = false;
    this.renderer.setClearColor(0x000000, 0);
    this.mesh.frustumCulled = false;
    this.quad.frustumCulled = false;
    this.flat.add(this.quad);
    this.backdrop = new Mesh(
      new SphereGeometry(40, 32, 16),
      new ShaderMaterial({ glslVersion: GLSL3, vertexShader: BACKDROP_VERTEX, fragmentShader: BACKDROP_FRAGMENT, side: BackSide, depthWrite: false, uniforms: { sky: { value: null }, strength: { value: 1 } } }),
    );
    this.ground.frustumCulled = false;
    this.scene.add(this.backdrop, this.ground, this.mesh);
    this.sample = target(1, 1, true);
    this.sums = [target(1, 1, false), target(1, 1, false)];
  }

  /** The materials that are drawn, the second only when it is compared. */
  setMaterials(materials: readonly Material[]): void {
    const before = this.shown;
    this.shown = materials.map((material) => before.find((each) => each.material === material) ?? { material, program: shadeMaterial(material) });
    for (const old of before) if (!this.shown.includes(old)) old.program.dispose();
    this.restart();
  }

  setGeometry(geometry: BufferGeometry): void {
    this.mesh.geometry = geometry;
    this.ground.geometry.dispose();
    this.ground.geometry = groundOf(geometry);
    this.restart();
  }

  /** The canvas follows its box; returns whether it changed. */
  resize(width: number, height: number, ratio: number): void {
    const [w, h] = [Math.max(Math.round(width * ratio), 1), Math.max(Math.round(height * ratio), 1)];
    if (this.sample.width === w && this.sample.height === h) return;
    this.renderer.setSize(w, h, false);
    this.sample.setSize(w, h);
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
    const coarse = this.moved ? this.coarseness : 1;
    if (this.moved) this.adapt();
    if (!this.complete) {
      const count = Math.min(this.moved ? this.batch : Math.max(this.batch, AT_REST), MOST, DIRECTIONS);
      this.shade(state, values, Math.ceil(this.sample.width / coarse), Math.ceil(this.sample.height / coarse), count);
      if (coarse === 1) {
        this.drawn += count;
        this.add(count / this.drawn);
        this.frame += 1;
      }
    }
    this.show(state, coarse === 1 ? this.sums[0] : this.sample, coarse);
    this.lobe?.draw(this.renderer, this.camera, this.sample.width, this.sample.height);
    this.moved = false;
  }

  /** The materials on the mesh, into the lower left corner of `sample`. */
  private shade(state: State, values: readonly Values[], w: number, h: number, count: number): void {
    const renderer = this.renderer;
    this.place(state, w, h);
    this.sample.scissorTest = false;
    renderer.setRenderTarget(this.sample);
    renderer.clear();
    this.parts(state, w).forEach(([x, width, viewX, viewWidth], k) => {
      const { material, program } = this.shown[k]!;
      Object.assign(program.uniforms, uniformValues(material, values[k]!));
      this.light(program, state, count);
      this.mesh.material = program;
      this.sample.viewport.set(viewX, 0, viewWidth, h);
      this.sample.scissor.set(x, 0, width, h);
      this.sample.scissorTest = true;
      renderer.setRenderTarget(this.sample);
      renderer.render(this.scene, this.camera);
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
    this.sample = target(width, height, true);
    this.sums = [target(width, height, false), target(width, height, false)];
    this.environment = '';
    this.sky = null;
    this.backdrop.material.uniforms['sky']!.value = null;
    this.restart();
  }

  dispose(): void {
    for (const { program } of this.shown) program.dispose();
    for (const each of [this.sample, ...this.sums]) each.dispose();
    this.sky?.dispose();
    this.ground.geometry.dispose();
    this.ground.material.dispose();
    this.renderer.dispose();
  }

  /** For each material: the part of the picture it fills, and the part that the camera's view fills. */
  private parts(state: State, w: number): [number, number, number, number][] {
    if (this.shown.length < 2) return [[0, w, 0, w]];
    if (state.compare === 'side') return [[0, Math.floor(w / 2), 0, Math.floor(w / 2)], [Math.ceil(w / 2), Math.floor(w / 2), Math.ceil(w / 2), Math.floor(w / 2)]];
    const cut = Math.round(w * state.split);
    return [[0, cut, 0, w], [cut, w - cut, 0, w]];
  }

  private place(state: State, w: number, h: number): void {
    const [azimuth, elevation] = [radians(state.azimuth), radians(state.elevation)];
    const aspect = this.shown.length > 1 && state.compare === 'side' ? w / 2 / h : w / h;
    this.camera.aspect = aspect;
    // What fits a square also fits a narrow picture: the distance grows.
    const distance = state.distance * Math.max(1, 1 / aspect);
    this.camera.position.set(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation)).multiplyScalar(distance);
    this.camera.lookAt(0, 0, 0);
    // Each frame samples another place of the pixels; the first their middle.
    const jitter = [halton(this.frame, 2), halton(this.frame, 3)];
    this.camera.setViewOffset(w, h, jitter[0]!, jitter[1]!, w, h);
    this.camera.updateProjectionMatrix();
    this.backdrop.visible = state.backdrop && state.environment !== 'none';
    // What a white ground gets of the surroundings, of all that it gets with the lamp.
    const [sky, lamp] = [this.up * state.sky, state.lamp * Math.max(Math.sin(radians(state.lampElevation)), 0)];
    this.ground.visible = state.ground && !this.dark && !this.backdrop.visible;
    this.ground.material.uniforms['strength']!.value = sky > 0 ? sky / (sky + lamp) : 0;
  }

  private light(program: ShaderMaterial, state: State, count: number): void {
    const [azimuth, elevation] = [radians(state.lampAzimuth), radians(state.lampElevation)];
    const uniforms = program.uniforms;
    uniforms['lampPosition']!.value.set(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation)).multiplyScalar(LAMP_DISTANCE);
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

  private show(state: State, shown: WebGLRenderTarget, coarseness: number): void {
    const renderer = this.renderer;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, this.sample.width, this.sample.height);
    renderer.clear();
    renderer.toneMapping = TONES[state.tone as keyof typeof TONES] ?? NeutralToneMapping;
    renderer.toneMappingExposure = 2 ** state.exposure;
    this.showing.uniforms['average']!.value = shown.texture;
    this.showing.uniforms['coarseness']!.value = coarseness;
    this.quad.material = this.showing;
    renderer.render(this.flat, this.flatCamera);
  }

  /** Called at frames in a row in which things move: more directions and pixels where the machine is quick, fewer where it is not. */
  private adapt(): void {
    const now = performance.now();
    if (this.times.length && now - this.times.at(-1)! > 500) this.times.length = 0;
    this.times.push(now);
    if (this.times.length < 6) return;
    const mean = (now - this.times[0]!) / (this.times.length - 1);
    if (mean > PATIENCE_MS) {
      if (this.batch > FEWEST) this.batch /= 2;
      else this.coarseness = 2;
    } else if (mean < PATIENCE_MS / 2) {
      if (this.coarseness > 1) this.coarseness = 1;
      else if (this.batch < MOST) this.batch *= 2;
    }
    this.times.length = 0;
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

function target(width: number, height: number, depthBuffer: boolean): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, { type: FloatType, format: RGBAFormat, minFilter: NearestFilter, magFilter: NearestFilter, depthBuffer });
}

function quadMaterial(fragmentShader: string, glslVersion: GLSLVersion | null, uniforms: Record<string, { value: unknown }>): ShaderMaterial {
  return new ShaderMaterial({ glslVersion, vertexShader: FULL_VERTEX, fragmentShader, uniforms, depthTest: false, depthWrite: false });
}

function shadeMaterial(material: Material): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: SHADE_VERTEX,
    fragmentShader: shadeFragment(material),
    uniforms: {
      lampPosition: { value: new Vector3() },
      lampStrength: { value: 1 },
      skyDirections: { value: null },
      skyFirst: { value: 0 },
      skyCount: { value: 0 },
      skyStrength: { value: 1 },
      painted: { value: 0 },
    },
    side: 2,
  });
}

/** Halton's sequence about the middle, within half a pixel; 0 at first. */
function halton(index: number, base: number): number {
  let [value, share, rest] = [0, 1, index];
  while (rest > 0) {
    share /= base;
    value += share * (rest % base);
    rest = Math.floor(rest / base);
  }
  return index === 0 ? 0 : value - 0.5;
}
