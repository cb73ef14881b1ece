// The viewer: what it is made of, and how a change reaches all of it.

import type { BufferGeometry } from 'three';
import { Agreement } from './agreement';
import { button, Choice, section, Slider, Switch } from './controls';
import { clamp, h, tidy } from './dom';
import { accept, open } from './drop';
import { radianceMap } from './environment';
import type { Payload } from './generated';
import { Lobe } from './lobe';
import { fromJson, fromView, toJson, valuesAt, type Material, type Values } from './material';
import { fromView as pointsFrom, type Measurement } from './measurement';
import { readMesh } from './meshfiles';
import { Messages } from './messages';
import { orbit } from './orbit';
import { Parameters } from './parameters';
import { Probe } from './probe';
import { Problem } from './problem';
import { Reflection } from './reflection';
import { Picture } from './scene';
import { embedded, prepared } from './shapes';
import { decode, encode, initial, merged, RANGES, Store, type State } from './state';
import { copy, pictureOf, save, slug } from './takeaway';
import { Transport } from './transport';
import { Trends } from './trends';

export interface Host {
  /** A page has a link that holds the state; a widget does not. */
  link: boolean;
  changed?: (state: State) => void;
}

const SHAPES: Record<string, string> = { sphere: 'Sphere', teapot: 'Teapot', bunny: 'Bunny' };
const LARGEST_RATIO = 2;

export class App {
  readonly store: Store;
  readonly start: State;
  readonly picture: Picture;
  readonly probe: Probe;
  readonly messages = new Messages();
  /** Milliseconds from the start of the page to the first picture. */
  firstPicture = 0;
  data: Measurement | null = null;
  private readonly own: (Material | null)[];
  private materials: (Material | null)[];
  /** Meshes by name; those of the page are unpacked when they are first looked at. */
  private readonly geometries = new Map<string, BufferGeometry | null>();
  private readonly canvas: HTMLCanvasElement;
  private readonly stage: HTMLElement;
  private readonly title = h('h1');
  private readonly subtitle = h('p', { class: 'motes-model' });
  private readonly lobe = new Lobe();
  private readonly parameters: Parameters;
  private readonly reflection: Reflection;
  private readonly agreement: Agreement;
  private readonly trends = new Trends();
  private readonly transport: Transport;
  private readonly followers: ((state: State) => void)[] = [];
  private readonly names = [h('span', { class: 'motes-name left' }), h('span', { class: 'motes-name right' })];
  private readonly progress = h('span', { class: 'motes-progress' });
  private readonly tabs = h('div', { class: 'motes-tabs', role: 'group', 'aria-label': 'Which material' });
  private readonly agreementSection: HTMLDetailsElement;
  private readonly trendSection: HTMLDetailsElement;
  private readonly splitLine = h('div', { class: 'motes-cut' });
  private readonly observer: ResizeObserver;
  private readonly stop = new AbortController();
  private pending = 0;
  private plotsDue = true;
  private lost = false;

  constructor(
    private readonly root: HTMLElement,
    private readonly payload: Payload,
    private readonly host: Host,
  ) {
    this.own = [fromView(payload.materials[0]!), payload.materials[1] ? fromView(payload.materials[1]) : null];
    this.materials = [...this.own];
    this.data = payload.measurement ? pointsFrom(payload.measurement) : null;
    for (const view of payload.shapes.shapes) this.geometries.set(view.name, null);
    const first = this.materials.map((material) => material?.time?.interval[0]).find((hours) => hours !== undefined);
    this.start = initial(payload.shapes.shapes[0]!.name, first ?? 0, this.own[1] !== null);
    if (this.data) this.start.incidence = commonIncidence(this.data);
    this.store = new Store(structuredClone(this.start));
    this.canvas = h('canvas', { tabindex: 0, role: 'application', 'aria-label': 'The material on a shape. Arrow keys turn it, with Shift the lamp; plus and minus zoom; Space plays time.' });
    this.picture = new Picture(this.canvas);
    this.picture.lobe = this.lobe;
    this.probe = new Probe(this.picture.renderer);
    const change = (patch: Partial<State>): void => this.store.change(patch);
    this.parameters = new Parameters((name, value) => this.store.hold(this.store.state.active, name, value), this.messages.fail);
    this.reflection = new Reflection(change);
    this.agreement = new Agreement(change, this.messages.fail);
    this.transport = new Transport((hours) => change({ hours }), () => this.request());
    this.agreementSection = section('Measured and computed', true, this.agreement.element);
    this.trendSection = section('Over time', true, this.trends.element);
    this.stage = h('div', { class: 'motes-stage' }, this.canvas, ...this.names, this.splitLine, this.progress);
    this.build();
    orbit(this.canvas, this.store);
    this.canvas.addEventListener('keydown', (event) => {
      if (event.key !== ' ') return;
      event.preventDefault();
      this.transport.toggle();
    });
    this.observer = new ResizeObserver(() => this.request());
    this.observer.observe(this.stage);
    this.canvas.addEventListener('webglcontextlost', () => this.contextLost());
    this.canvas.addEventListener('webglcontextrestored', () => this.contextRestored());
    accept(this.root, this, this.stop.signal);
    this.store.listen((changed) => this.follow(changed));
    if (host.link) {
      this.restore();
      addEventListener('hashchange', () => this.restore(), { signal: this.stop.signal });
    }
    this.rebuild();
    this.follow(new Set(Object.keys(this.store.state) as (keyof State)[]));
  }

  // ---------------------------------------------------------------- what others ask for

  /** The material at a place, 0 or 1. */
  material(index: number): Material | null {
    return this.materials[index] ?? null;
  }

  values(index: number): Values {
    const material = this.materials[index];
    const { state } = this.store;
    return material ? valuesAt(material, material.time ? state.hours : null, state.values[index as 0 | 1]) : {};
  }

  /** The BRDF [1/sr] of the present values, from the shader. */
  evaluate(index: number, wi: ArrayLike<number>, wo: ArrayLike<number>): Float32Array {
    const material = this.materials[index];
    if (!material) throw new Problem(`There is no material ${index}`, 'Open a second one');
    return this.probe.evaluate(material, this.values(index), wi, wo);
  }

  /** Radiance of an environment, a map of 64 x 128 cells: linear sRGB by polar angle (from y up) and azimuth. */
  environment(name: string): Float32Array {
    return radianceMap(name);
  }

  get relativeRms(): number {
    return this.agreement.relativeRms;
  }

  /** Show a material's JSON, in place of the active one or as the second. */
  openMaterial(json: unknown, second: boolean): void {
    const index = second ? 1 : this.store.state.active;
    const { material, notes } = fromJson(json, this.payload.library);
    const dropped: [unknown, unknown] = [...this.store.state.dropped];
    const values: [Values, Values] = [...this.store.state.values];
    dropped[index] = json;
    values[index as 0 | 1] = {};
    const hours = material.time && !this.interval ? material.time.interval[0] : this.store.state.hours;
    this.store.change({ dropped, values, hours, ...(index === 1 ? { compare: this.store.state.compare === 'one' ? 'split' : this.store.state.compare } : {}) });
    this.messages.say([`${material.name} is shown: ${material.json.model}`, ...notes].join('. '));
  }

  openData(data: Measurement): void {
    this.data = data;
    this.messages.say(`${data.name}: ${data.count.toLocaleString('en')} pairs of directions are shown over the material. ${data.note}`.trim());
    this.store.change({ incidence: commonIncidence(data) });
    this.followAll();
  }

  openMesh(name: string, data: ArrayBuffer): void {
    const geometry = prepared(readMesh(name, data), this.payload.shapes.dust_by_inclination);
    this.geometries.get(name)?.dispose();
    this.geometries.set(name, geometry);
    const count = (geometry.getIndex()!.count / 3).toLocaleString('en');
    this.messages.say(`${name} is shown: ${count} triangles`);
    this.store.change({ shape: name });
    this.followAll();
  }

  /** The link that restores what is seen. */
  link(): string {
    return location.href.replace(/#.*$/s, '') + encode(this.store.state, this.start);
  }

  apply(data: Record<string, unknown>): void {
    this.store.change(merged(this.start, data));
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.observer.disconnect();
    this.stop.abort();
    this.transport.pause();
    this.picture.dispose();
    for (const geometry of this.geometries.values()) geometry?.dispose();
  }

  // ---------------------------------------------------------------- construction

  private build(): void {
    const { store } = this;
    const change = (patch: Partial<State>): void => store.change(patch);
    const shape = new Choice('Shape', [], (value) => change({ shape: value }));
    this.followers.push((state) => {
      shape.fill([...this.geometries.keys()].map((name) => [name, SHAPES[name] ?? name] as const));
      shape.show(state.shape);
    });
    const slider = (label: string, key: keyof typeof RANGES, extra: { symbol?: string; unit?: string; step?: number } = {}): HTMLElement => {
      const made = new Slider({ label, ...extra, ...RANGES[key], set: (value) => change({ [key]: within(label, value, key) }), reset: () => change({ [key]: this.start[key] }) }, this.messages.fail);
      this.followers.push((state) => made.show(state[key], state[key] !== this.start[key]));
      return made.element;
    };
    const choice = (label: string, key: 'environment' | 'tone' | 'compare', options: [string, string][]): HTMLElement => {
      const made = new Choice(label, options, (value) => change({ [key]: value }));
      this.followers.push((state) => made.show(state[key]));
      return made.element;
    };
    const onOff = (label: string, key: 'dust' | 'lobe' | 'backdrop', hint: string): HTMLElement => {
      const made = new Switch(label, (on) => change({ [key]: on }), hint);
      this.followers.push((state) => made.show(state[key]));
      return made.element;
    };
    const dust = onOff('Dust lies where it settles', 'dust', 'tau by inclination and shelter instead of the same everywhere');
    this.followers.push(() => (dust.hidden = !this.materials.some((material) => material?.tau)));
    const scene = section(
      'Scene',
      true,
      h('div', { class: 'motes-pair' }, shape.element, choice('Surroundings', 'environment', [['studio', 'Studio'], ['sky', 'Sky'], ['dome', 'White dome'], ['none', 'Nothing']])),
      slider('lamp', 'lamp', { step: 0.05 }),
      slider('lamp azimuth', 'lampAzimuth', { unit: '°', step: 1 }),
      slider('lamp height', 'lampElevation', { unit: '°', step: 1 }),
      slider('surroundings', 'sky', { step: 0.05 }),
      slider('exposure', 'exposure', { unit: 'EV', step: 0.1 }),
      choice('Tone mapping', 'tone', [['neutral', 'Khronos PBR Neutral'], ['agx', 'AgX'], ['clip', 'Clip at 1']]),
      dust,
      onOff('Lobe in the corner', 'lobe', 'The BRDF in three dimensions'),
      onOff('Surroundings behind', 'backdrop', 'Show the environment as the background'),
      h('p', { class: 'motes-caption' }, 'Drag to turn, Shift-drag to move the lamp, scroll to zoom. The lamp is a point; light from the surroundings is the sum over up to 1,024 directions, finished some frames after the last change. Nothing casts shadows.'),
    );
    const compareNote = h('p', { class: 'motes-caption' });
    const comparison = choice('Show', 'compare', [['one', 'One material'], ['split', 'Two, split'], ['side', 'Two, side by side']]);
    const cut = slider('where it is split', 'split', { step: 0.01 });
    this.followers.push((state) => {
      const two = this.materials[1] !== null;
      comparison.querySelector('select')!.disabled = !two;
      cut.hidden = !two || state.compare !== 'split';
      compareNote.textContent = two ? `Left: ${this.materials[0]!.name}. Right: ${this.materials[1]!.name}.` : 'Open a second material (a material.json) to compare.';
    });
    const second = this.fileButton('Open second material…', '.json', true);
    const compare = section('Compare', this.own[1] !== null, comparison, cut, compareNote, second);
    const active = (): { material: Material; values: Values; held: Values } => {
      const index = store.state.active;
      return { material: this.materials[index]!, values: this.values(index), held: store.state.values[index as 0 | 1] };
    };
    const json = (): string => {
      const { material, values, held } = active();
      return `${JSON.stringify(toJson(material, values, held, material.time ? store.state.hours : null), null, 1)}\n`;
    };
    const copied = (what: string, text: () => string) => (): void => {
      copy(text()).then(() => this.messages.say(`${what} is copied`), this.messages.fail);
    };
    const takeaway = section(
      'Take away',
      true,
      h(
        'div',
        { class: 'motes-buttons' },
        button('Copy material', copied('The material', json)),
        button('Save material', () => save(`${slug(active().material.name)}.json`, json(), 'application/json')),
        button('Copy shader', copied('The shader', () => active().material.shader.source)),
        button('Save shader', () => save(`${slug(active().material.name)}.glsl`, active().material.shader.source)),
        button('Save picture', () => void pictureOf(this.canvas).then((blob) => save(`${slug(active().material.name)}.png`, blob), this.messages.fail)),
        this.host.link
          ? button('Copy link', () => {
              const address = this.link();
              try {
                history.replaceState(null, '', address);
              } catch {
                // Some browsers refuse for files; the link itself is copied all the same.
              }
              copied('The link, which restores what you see,', () => address)();
            })
          : null,
        this.fileButton('Open file…', '.json,.csv,.txt,.obj,.ply,.glb', false),
        button('Reset all', () => store.change({ ...structuredClone(this.start), dropped: [null, null] })),
      ),
      h('p', { class: 'motes-caption' }, 'Open or drop a material.json, a table of measurements (CSV: theta_i, phi_i, theta_r, phi_r, channels) or a mesh (OBJ, PLY, GLB). Files stay in this page; nothing is sent and nothing is remembered.'),
    );
    this.root.replaceChildren(
      h('header', { class: 'motes-head' }, this.title, this.subtitle, ...this.payload.notes.map((note) => h('p', { class: 'motes-note' }, note))),
      h('div', { class: 'motes-view' }, this.stage, this.transport.element, this.messages.element),
      h(
        'div',
        { class: 'motes-panel' },
        section('Parameters', true, this.tabs, this.parameters.element),
        this.trendSection,
        section('Reflection', true, this.reflection.element),
        this.agreementSection,
        scene,
        compare,
        takeaway,
        h('p', { class: 'motes-foot' }, `Motes ${this.payload.motes}. Shaded by GLSL that Motes printed from its equations; f in 1/sr, without the cosine. This page asks the network for nothing.`),
      ),
    );
  }

  private fileButton(label: string, types: string, second: boolean): HTMLElement {
    const input = h('input', { type: 'file', accept: types, class: 'motes-offscreen', tabindex: -1, 'aria-label': label });
    input.addEventListener('change', () => {
      const file = input.files?.[0];
      if (file) open(file, this, second).catch(this.messages.fail);
      input.value = '';
    });
    return h('span', {}, button(label, () => input.click()), input);
  }

  // ---------------------------------------------------------------- following changes

  private get interval(): [number, number] | null {
    const { state } = this.store;
    const shown = state.compare === 'one' ? [this.materials[state.active]] : this.materials;
    const intervals = shown.flatMap((material) => (material?.time ? [material.time.interval] : []));
    return intervals.length ? [Math.min(...intervals.map((i) => i[0])), Math.max(...intervals.map((i) => i[1]))] : null;
  }

  private restore(): void {
    const state = decode(location.hash, this.start);
    if (state) this.store.change(state);
    else if (location.hash.startsWith('#motes=')) this.messages.fail(new Problem('The link is damaged and restores nothing', 'Copy it again'));
  }

  /** The materials that the state names. */
  private rebuild(): void {
    const { dropped } = this.store.state;
    this.materials = [0, 1].map((index) => {
      const json = dropped[index];
      if (!json) return this.own[index]!;
      const now = this.materials[index];
      if (now?.dropped && JSON.stringify(now.json) === JSON.stringify({ ...(json as object), name: now.json.name, channels: now.json.channels })) return now;
      try {
        return fromJson(json, this.payload.library).material;
      } catch (error) {
        this.messages.fail(error);
        return this.own[index]!;
      }
    });
    this.probe.keep(this.materials);
    this.tabs.replaceChildren(
      ...(this.materials[1]
        ? this.materials.map((material, k) => button(material!.name, () => this.store.change({ active: k }), { 'data-active': String(k), 'aria-pressed': 'false' }))
        : []),
    );
  }

  private followAll(): void {
    this.follow(new Set(Object.keys(this.store.state) as (keyof State)[]));
  }

  private follow(changed: ReadonlySet<keyof State>): void {
    if (changed.has('dropped')) this.rebuild();
    const { state } = this.store;
    if (!this.materials[1] && (state.compare !== 'one' || state.active !== 0)) {
      this.store.change({ compare: 'one', active: 0 });
      return;
    }
    if (changed.has('shape') || changed.has('dropped')) this.picture.setGeometry(this.geometry(state.shape));
    if (['dropped', 'compare', 'active'].some((key) => changed.has(key as keyof State))) {
      const shown = state.compare === 'one' ? [this.materials[state.active]!] : [this.materials[0]!, this.materials[1]!];
      this.picture.setMaterials(shown);
    }
    for (const follower of this.followers) follower(state);
    this.words(state);
    const cosmetic = [...changed].every((key) => ['exposure', 'tone', 'incidence', 'lobe', 'radius', 'scale', 'active'].includes(key));
    if (!cosmetic) this.picture.restart();
    const scene = new Set<keyof State>(['azimuth', 'elevation', 'distance', 'lampAzimuth', 'lampElevation', 'lamp', 'environment', 'sky', 'exposure', 'tone', 'split', 'dust', 'backdrop', 'shape']);
    if (![...changed].every((key) => scene.has(key))) this.plotsDue = true;
    this.host.changed?.(state);
    this.request();
  }

  private geometry(name: string): BufferGeometry {
    const found = this.geometries.get(name);
    if (found) return found;
    const view = this.payload.shapes.shapes.find((each) => each.name === name) ?? this.payload.shapes.shapes[0]!;
    const made = this.geometries.get(view.name) ?? embedded(view);
    this.geometries.set(view.name, made);
    return made;
  }

  private words(state: State): void {
    const shown = state.compare === 'one' ? [this.materials[state.active]!] : [this.materials[0]!, this.materials[1]!];
    this.title.textContent = shown.map((material) => material.name).join(' and ');
    this.subtitle.textContent = [...new Set(shown.map((material) => material.json.model))].join(' · ');
    this.names.forEach((name, k) => {
      name.hidden = shown.length < 2;
      name.textContent = shown[k]?.name ?? '';
    });
    this.splitLine.hidden = shown.length < 2;
    this.splitLine.style.left = `${100 * (state.compare === 'side' ? 0.5 : state.split)}%`;
    for (const tab of Array.from(this.tabs.children)) tab.setAttribute('aria-pressed', String(tab.getAttribute('data-active') === String(state.active)));
    const active = this.materials[state.active]!;
    this.parameters.show(active, this.values(state.active), state.values[state.active as 0 | 1]);
    this.transport.show(this.interval, state.hours);
    this.trendSection.hidden = !active.time;
    this.agreementSection.hidden = !this.data;
  }

  // ---------------------------------------------------------------- frames

  request(): void {
    if (!this.pending && !this.lost) this.pending = requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    this.pending = 0;
    if (this.lost) return;
    this.transport.advance(now, this.store.state.hours);
    const { state } = this.store;
    const ratio = Math.min(devicePixelRatio || 1, LARGEST_RATIO);
    this.picture.resize(this.stage.clientWidth, this.stage.clientHeight, ratio);
    if (this.plotsDue && this.firstPicture) this.plots(state);
    const shown = state.compare === 'one' ? [this.values(state.active)] : [this.values(0), this.values(1)];
    this.lobe.visible = state.lobe && this.firstPicture > 0;
    this.picture.draw(state, shown);
    if (!this.firstPicture) {
      // Drawing happens elsewhere; a pixel that is read has been drawn.
      const gl = this.picture.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.firstPicture = performance.now();
      this.root.dataset['firstPicture'] = this.firstPicture.toFixed(0);
    }
    this.progress.textContent = this.picture.complete ? '' : `${Math.round(100 * this.picture.progress)} %`;
    this.root.dataset['complete'] = String(this.picture.complete && !this.plotsDue);
    if (!this.picture.complete || this.plotsDue || this.transport.playing) this.request();
  }

  private plots(state: State): void {
    this.plotsDue = false;
    const materials = this.materials.filter((material): material is Material => material !== null);
    const values = materials.map((_, k) => this.values(k));
    const active = materials[state.active]!;
    this.lobe.update(state, active, values[state.active]!, this.probe);
    this.reflection.update(state, materials, values, this.probe, this.data);
    if (this.data) {
      try {
        this.agreement.update(state, materials[0]!, values[0]!, this.probe, this.data);
      } catch (error) {
        this.messages.fail(error);
      }
    }
    if (active.time) this.trends.update(state, active, values[state.active]!);
  }

  private contextLost(): void {
    this.lost = true;
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    this.messages.say('The graphics device was lost; the picture comes back with it');
  }

  private contextRestored(): void {
    this.lost = false;
    this.picture.revive();
    this.probe.revive();
    this.plotsDue = true;
    this.messages.say('The graphics device is back');
    this.request();
  }
}

function within(label: string, value: number, key: keyof typeof RANGES): number {
  const { low, high } = RANGES[key];
  if (!Number.isFinite(value)) throw new Problem(`${label} is not a number`, `Choose one from ${tidy(low)} to ${tidy(high)}`);
  return clamp(value, low, high);
}

/** An angle of incidence [degrees] at which many samples lie in the plane of incidence. */
function commonIncidence(data: Measurement): number {
  const counts = new Float64Array(90);
  for (let k = 0; k < data.count; k += 1) {
    const aside = Math.abs(Math.sin(data.dphi[k]!)) * Math.min(Math.sin(data.thetaI[k]!), Math.sin(data.thetaR[k]!));
    if (aside > 0.05) continue;
    const angle = Math.round((data.thetaI[k]! * 180) / Math.PI);
    if (angle <= RANGES.incidence.high) counts[angle]! += 1;
  }
  // Among the angles that have many, the one nearest to 45.
  const enough = 0.4 * Math.max(...counts);
  let best = 45;
  let off = Infinity;
  counts.forEach((count, angle) => {
    if (count >= enough && enough > 0 && Math.abs(angle - 45) < off) [best, off] = [angle, Math.abs(angle - 45)];
  });
  return best;
}
