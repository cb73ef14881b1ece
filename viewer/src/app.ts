// The viewer: what it is made of, and how a change reaches all of it.

import { Agreement } from './agreement';
import { button, section } from './controls';
import { h, tidy, write } from './dom';
import { accept, fileButton } from './drop';
import { radianceMap } from './environment';
import { declare } from './expression';
import type { Payload } from './generated';
import { Lobe } from './lobe';
import type { Material, Values } from './material';
import { commonIncidence, fromView as pointsFrom, type Measurement } from './measurement';
import { Meshes } from './meshes';
import { Messages } from './messages';
import { orbit } from './orbit';
import { Pair } from './pair';
import { Parameters } from './parameters';
import { Probe } from './probe';
import { Problem, quoted } from './problem';
import { Reflection } from './reflection';
import { Picture } from './scene';
import { Settings } from './settings';
import { decode, encode, initial, merged, Store, type State } from './state';
import { takeawaySection } from './takeaway';
import { Transport } from './transport';
import { Trends } from './trends';

export interface Host {
  /** A page has a link that holds the state; a widget does not. */
  link: boolean;
  changed?: (state: State) => void;
}

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
  private readonly pair: Pair;
  private readonly meshes: Meshes;
  private readonly settings: Settings;
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
    declare(payload.models);
    this.pair = new Pair(payload);
    this.meshes = new Meshes(payload.shapes);
    this.canvas = h('canvas', { tabindex: 0, role: 'application', 'aria-label': 'The material on a shape. Arrow keys turn it, with Shift the lamp; plus and minus zoom; Space plays time.' });
    this.picture = new Picture(this.canvas);
    this.start = initial(payload.shapes.shapes[0]!.name, this.pair.firstHours ?? 0, this.pair.cameWithTwo);
    // Compiling takes longer than all that follows, and is done elsewhere.
    this.picture.setMaterials(this.pair.shown(this.start));
    this.picture.prepare(this.start, this.pair.shownValues(this.start), this.meshes.get(this.start.shape, this.start.up));
    this.data = payload.measurement ? pointsFrom(payload.measurement) : null;
    if (this.data) this.start.incidence = commonIncidence(this.data);
    this.store = new Store(structuredClone(this.start));
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
    this.settings = new Settings(this.store, this.start, this.messages.fail, this.meshes, this.pair, fileButton('Open second material…', '.json', this, true));
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
    this.followAll();
  }

  // ---------------------------------------------------------------- what others ask for

  /** The material at a place, 0 or 1. */
  material(index: number): Material | null {
    return this.pair.at(index);
  }

  values(index: number): Values {
    return this.pair.values(this.store.state, index);
  }

  /** The BRDF [1/sr] of the present values, from the shader. */
  evaluate(index: number, wi: ArrayLike<number>, wo: ArrayLike<number>): Float32Array {
    const material = this.pair.at(index);
    if (!material) throw new Problem(`There is no material ${index}`, 'Open a second one');
    return this.probe.evaluate(material, this.values(index), wi, wo);
  }

  /** Radiance of an environment, a map of 64 x 128 cells: linear sRGB by polar angle (from y up) and azimuth. */
  environment(name: string): Float32Array {
    return name === 'own' ? this.picture.own ?? radianceMap('none') : radianceMap(name);
  }

  get relativeRms(): number {
    return this.agreement.relativeRms;
  }

  /** Show a material's JSON, in place of the active one or as the second. */
  openMaterial(json: unknown, second: boolean): void {
    const index = second ? 1 : this.store.state.active;
    const { material, notes } = this.pair.read(json);
    const dropped: [unknown, unknown] = [...this.store.state.dropped];
    const values: [Values, Values] = [...this.store.state.values];
    dropped[index] = json;
    values[index as 0 | 1] = {};
    const hours = material.time && !this.pair.interval(this.store.state) ? material.time.interval[0] : this.store.state.hours;
    this.store.change({ dropped, values, hours, ...(index === 1 ? { compare: this.store.state.compare === 'one' ? 'split' : this.store.state.compare } : {}) });
    this.messages.say([`${material.name} is shown: ${material.json.model}`, ...notes].join('. '));
  }

  openData(data: Measurement): void {
    this.data = data;
    this.messages.say(`${data.name}: ${data.count.toLocaleString('en')} pairs of directions are shown over the material. ${data.note}`.trim());
    this.store.change({ incidence: commonIncidence(data) });
    this.followAll();
  }

  async openMesh(name: string, data: ArrayBuffer): Promise<void> {
    const { triangles, tau } = await this.meshes.add(name, data, this.store.state.up);
    const { active } = this.store.state;
    const slot = this.pair.active(this.store.state).tau;
    const dusty = !tau ? '' : slot ? `. Its own dust lies on it, tau up to ${tidy(tau)}, which the slider scales` : `. Its own dust, tau up to ${tidy(tau)}, is not shown: the material has no layer of dust`;
    this.messages.say(`${name} is shown: ${triangles.toLocaleString('en')} triangles${dusty}`);
    this.store.change({ shape: name, ...(tau && slot ? { dust: true } : {}) });
    if (tau && slot) this.store.hold(active, slot, [tau]);
    this.followAll();
  }

  /** Light from all around out of a file. */
  openSky(name: string, map: Float32Array): void {
    this.picture.setOwn(map);
    this.settings.skyName = name;
    this.messages.say(`${name} lights the scene, as 64 x 128 cells`);
    this.store.change({ environment: 'own' });
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
    this.meshes.dispose();
  }

  // ---------------------------------------------------------------- construction

  private build(): void {
    const openFile = fileButton('Open file…', '.json,.csv,.txt,.obj,.ply,.glb,.hdr,.exr', this, false);
    const takeaway = takeawaySection(this.store, this.start, this.pair, this.canvas, this.messages, this.host.link ? () => this.link() : null, openFile);
    for (const each of [this.settings.scene, this.settings.compare, takeaway]) each.classList.add('motes-controls');
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
        this.settings.scene,
        this.settings.compare,
        takeaway,
        h('p', { class: 'motes-foot' }, `Motes ${this.payload.motes}. Shaded by GLSL that Motes printed from its equations; f in 1/sr, without the cosine. This page asks the network for nothing.`),
      ),
    );
  }

  // ---------------------------------------------------------------- following changes

  private restore(): void {
    const state = decode(location.hash, this.start);
    if (state) {
      this.store.change(state);
      const left = [0, 1].flatMap((index) => Object.keys(state.values[index as 0 | 1]).filter((name) => !Object.hasOwn(this.pair.held(state, index), name)));
      if (left.length) this.messages.fail(new Problem(`The link sets ${quoted(left.join(', '))} to what the material cannot have; it is left out`, 'Copy the link again'));
    }
    if (!state && location.hash.startsWith('#motes=')) this.messages.fail(new Problem('The link is damaged and restores nothing', 'Copy it again'));
  }

  /** The materials that the state names. */
  private rebuild(): void {
    this.pair.follow(this.store.state, this.messages.fail);
    this.probe.keep(this.pair.all);
    this.tabs.replaceChildren(
      ...(this.pair.two
        ? this.pair.all.map((material, k) => button(material!.name, () => this.store.change({ active: k }), { 'data-active': String(k), 'aria-pressed': 'false' }))
        : []),
    );
  }

  private followAll(): void {
    this.follow(new Set(Object.keys(this.store.state) as (keyof State)[]));
  }

  private follow(changed: ReadonlySet<keyof State>): void {
    if (changed.has('dropped')) this.rebuild();
    const { state } = this.store;
    if (!this.pair.two && (state.compare !== 'one' || state.active !== 0)) {
      this.store.change({ compare: 'one', active: 0 });
      return;
    }
    if (changed.has('shape') || changed.has('dropped') || changed.has('up')) this.picture.setGeometry(this.meshes.get(state.shape, state.up));
    if (['dropped', 'compare', 'active'].some((key) => changed.has(key as keyof State))) this.picture.setMaterials(this.pair.shown(state));
    this.settings.follow(state);
    this.words(state);
    const cosmetic = [...changed].every((key) => ['exposure', 'tone', 'incidence', 'lobe', 'radius', 'scale', 'active'].includes(key));
    if (!cosmetic) this.picture.restart();
    this.picture.stale = true;
    const scene = new Set<keyof State>(['azimuth', 'elevation', 'distance', 'lampAzimuth', 'lampElevation', 'lamp', 'environment', 'sky', 'exposure', 'tone', 'split', 'dust', 'backdrop', 'ground', 'up', 'shape']);
    if (![...changed].every((key) => scene.has(key))) this.plotsDue = true;
    this.host.changed?.(state);
    this.request();
  }

  private words(state: State): void {
    const shown = this.pair.shown(state);
    write(this.title, shown.map((material) => material.name).join(' and '));
    write(this.subtitle, [...new Set(shown.map((material) => material.json.model))].join(' · '));
    this.names.forEach((name, k) => {
      name.hidden = shown.length < 2;
      write(name, shown[k]?.name ?? '');
    });
    this.splitLine.hidden = shown.length < 2;
    this.splitLine.style.left = `${100 * (state.compare === 'side' ? 0.5 : state.split)}%`;
    for (const tab of Array.from(this.tabs.children)) tab.setAttribute('aria-pressed', String(tab.getAttribute('data-active') === String(state.active)));
    const active = this.pair.active(state);
    this.parameters.show(active, this.values(state.active), this.pair.held(state, state.active));
    this.transport.show(this.pair.interval(state), state.hours);
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
    this.stage.style.setProperty('--aspect', String(this.stage.clientWidth / Math.max(this.stage.clientHeight, 1)));
    this.picture.resize(this.stage.clientWidth, this.stage.clientHeight, ratio);
    if (this.plotsDue && this.firstPicture) this.plots(state);
    this.lobe.visible = state.lobe && this.firstPicture > 0;
    this.picture.draw(state, this.pair.shownValues(state));
    if (!this.firstPicture) {
      // Drawing happens elsewhere; a pixel that is read has been drawn.
      const gl = this.picture.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.firstPicture = performance.now();
      this.root.dataset['firstPicture'] = this.firstPicture.toFixed(0);
    }
    write(this.progress, this.picture.complete ? '' : `${Math.round(100 * this.picture.progress)} %`);
    const complete = String(this.picture.complete && !this.plotsDue);
    if (this.root.dataset['complete'] !== complete) this.root.dataset['complete'] = complete;
    if (!this.picture.complete || this.plotsDue || this.transport.playing) this.request();
  }

  private plots(state: State): void {
    this.plotsDue = false;
    this.picture.stale = true;
    const materials = this.pair.all.filter((material): material is Material => material !== null);
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
