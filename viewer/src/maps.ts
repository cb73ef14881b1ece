// The page of a fitted map: a parameter as a picture, and what was fitted at the texel under the pointer or the keys.

import { Chart } from './chart';
import { Choice, Slider } from './controls';
import { clamp, h, tidy } from './dom';
import type { LayerView, MapPayload } from './generated';
import { bytes } from './packed';
import { shownChannels } from './slice';

/** What of a parameter is drawn. */
type Aspect = 'value' | 'error' | 'verdict';

interface Layer {
  view: LayerView;
  values: Float32Array;
  stderr: Float32Array | null;
  verdicts: Uint8Array | null;
}

interface State {
  layer: number;
  aspect: Aspect;
  time: number;
  x: number;
  y: number;
}

const RESIDUAL = -1;
const STATUS = -2;

export class MapPage {
  readonly state: State = { layer: 0, aspect: 'value', time: 0, x: 0, y: 0 };
  readonly canvas: HTMLCanvasElement;
  private readonly layers: Layer[];
  private readonly residual: Layer;
  private readonly status: Uint8Array;
  private readonly ramp: Uint8Array;
  private readonly rows: number;
  private readonly columns: number;
  private readonly cursor = h('div', { class: 'motes-cursor' });
  private readonly table = h('tbody');
  private readonly where = h('p', { class: 'motes-where', 'aria-live': 'polite' });
  private readonly scale = h('p', { class: 'motes-scale' });
  private readonly meaning = h('p', { class: 'motes-caption' });
  private readonly chart = new Chart('The parameter over time at this texel', 210, 360);
  private readonly aspects: Choice;
  private readonly time: Slider | null;

  constructor(
    private readonly root: HTMLElement,
    private readonly payload: MapPayload,
  ) {
    [this.rows, this.columns] = payload.shape;
    this.layers = payload.layers.map(unpacked);
    this.residual = unpacked(payload.residual);
    this.status = new Uint8Array(bytes(payload.status));
    this.ramp = new Uint8Array(bytes(payload.ramp));
    this.state.x = this.columns >> 1;
    this.state.y = this.rows >> 1;
    this.canvas = h('canvas', { width: this.columns, height: this.rows, tabindex: 0, role: 'application', 'aria-label': 'The map. Arrow keys go from texel to texel, with Shift ten at a time; the table says what was fitted there.' });
    const layer = new Choice('Map', [...this.layers.map(({ view }, k) => [String(k), view.name] as const), [String(RESIDUAL), 'relative residual'], [String(STATUS), 'how fits ended']], (value) => this.set({ layer: Number(value) }));
    layer.show('0');
    this.aspects = new Choice('Show', [], (value) => this.set({ aspect: value as Aspect }));
    const last = payload.hours.length - 1;
    this.time = last > 0 ? new Slider({ label: 'scan, from 0', low: 0, high: last, step: 1, set: (value) => this.set({ time: Math.round(clamp(Number.isFinite(value) ? value : 0, 0, last)) }) }, () => undefined) : null;
    this.build(layer.element);
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerdown', (event) => this.point(event));
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    this.set({});
  }

  /** Show something else. */
  set(patch: Partial<State>): void {
    Object.assign(this.state, patch);
    const layer = this.layers[this.state.layer];
    const offered: [Aspect, string][] = [['value', 'values'], ...(layer?.stderr ? [['error', 'standard errors'] as [Aspect, string]] : []), ...(layer?.verdicts ? [['verdict', 'verdicts'] as [Aspect, string]] : [])];
    this.aspects.fill(offered);
    if (!offered.some(([aspect]) => aspect === this.state.aspect)) this.state.aspect = 'value';
    this.aspects.show(this.state.aspect);
    this.time?.show(this.state.time);
    this.draw();
    this.read();
  }

  /** What was fitted at a texel: a row for each parameter. */
  told(x = this.state.x, y = this.state.y): { name: string; value: string; error: string; verdict: string }[] {
    return this.layers.map(({ view, values, stderr, verdicts }) => {
      const first = this.index(view, x, y);
      const numbers = (source: Float32Array): string => Array.from(source.subarray(first, first + view.channels), (value) => (Number.isFinite(value) ? tidy(value) : '–')).join(', ');
      return { name: view.name, value: numbers(values), error: stderr ? numbers(stderr) : '', verdict: verdicts ? this.word(this.payload.verdicts, this.code(verdicts, x, y)) : '' };
    });
  }

  // ---------------------------------------------------------------- drawing

  private build(layer: HTMLElement): void {
    const { payload } = this;
    const head = ['map', 'value', 'standard error', 'verdict'].map((words) => h('th', { scope: 'col' }, words));
    const size = `${(this.columns * payload.step).toLocaleString('en')} x ${(this.rows * payload.step).toLocaleString('en')} texels`;
    this.root.replaceChildren(
      h('header', { class: 'motes-head' }, h('h1', {}, payload.name), h('p', { class: 'motes-model' }, payload.model), ...payload.notes.map((note) => h('p', { class: 'motes-note' }, note))),
      h('div', { class: 'motes-view' }, h('div', { class: 'motes-map' }, this.canvas, this.cursor), this.scale, this.meaning),
      h(
        'div',
        { class: 'motes-panel' },
        h('section', { class: 'motes-section motes-body', 'aria-label': 'What is shown' }, h('div', { class: 'motes-pair' }, layer, this.aspects.element), this.time?.element),
        h('section', { class: 'motes-section motes-body', 'aria-label': 'The texel' }, this.where, h('table', { class: 'motes-table' }, h('thead', {}, h('tr', {}, ...head)), this.table), payload.hours.length > 1 ? this.chart.svg : null),
        h('p', { class: 'motes-foot' }, `Motes ${payload.motes}. ${payload.step > 1 ? `Every ${payload.step}th of about ${size}` : size}. This page asks the network for nothing.`),
      ),
    );
    // A texel is a square, and the map fits the window.
    this.canvas.style.aspectRatio = `${this.columns} / ${this.rows}`;
    this.canvas.style.width = `min(100%, calc(70vh * ${this.columns / this.rows}))`;
  }

  private draw(): void {
    const image = new ImageData(this.columns, this.rows);
    const color = this.painter();
    for (let y = 0; y < this.rows; y += 1) {
      for (let x = 0; x < this.columns; x += 1) {
        const [r, g, b] = color(x, y);
        image.data.set([r, g, b, 255], 4 * (y * this.columns + x));
      }
    }
    this.canvas.getContext('2d', { willReadFrequently: true })!.putImageData(image, 0, 0);
  }

  /** The colour of texels, and with it what the scale below says. */
  private painter(): (x: number, y: number) => [number, number, number] {
    const { layer, aspect } = this.state;
    const chosen = layer === RESIDUAL ? this.residual : this.layers[layer];
    if (!chosen || (aspect === 'verdict' && chosen.verdicts)) {
      const codes = chosen?.verdicts ?? this.status;
      const named = chosen ? this.payload.verdicts : this.payload.statuses;
      this.meaning.textContent = chosen ? `What the data say about ${chosen.view.name}${chosen.view.channels > 1 ? ', of its channels the worst' : ''}.` : 'How the fits ended.';
      const count = new Map<number, number>();
      for (const code of codes) count.set(code, (count.get(code) ?? 0) + 1);
      const keys = Object.entries(named).filter(([, [code]]) => count.has(code));
      this.scale.replaceChildren(...keys.map(([name, [code, css]]) => h('span', {}, swatch(css), ` ${words(name)}: ${share(count.get(code)! / codes.length)}`)));
      const colors = new Map(Object.values(named).map(([code, css]) => [code, (css.match(/\d+/g) ?? []).map(Number) as [number, number, number]]));
      return (x, y) => colors.get(this.code(codes, x, y)) ?? GREY;
    }
    const { view } = chosen;
    const source = aspect === 'error' && chosen.stderr ? chosen.stderr : chosen.values;
    const what = `${aspect === 'error' ? 'Standard error of ' : ''}${view.name}: ${view.doc}${view.unit ? ` [${view.unit}]` : ''}`;
    if (view.channels > 1 && aspect === 'value') {
      const bright = view.span[1];
      this.meaning.textContent = `${what}; ${this.payload.color}, ${tidy(bright, 3)} is full brightness. Grey: no fit.`;
      this.scale.replaceChildren();
      return (x, y) => {
        const first = this.index(view, x, y);
        const linear: [number, number, number] = [0, 0, 0];
        for (let channel = 0; channel < view.channels; channel += 1) for (let j = 0; j < 3; j += 1) linear[j]! += (source[first + channel]! / bright) * this.payload.to_srgb[channel]![j]!;
        return linear.every(Number.isFinite) ? (linear.map(encoded) as [number, number, number]) : GREY;
      };
    }
    const [low, high] = aspect === 'error' && view.error_span ? view.error_span : view.span;
    this.meaning.textContent = `${what}${view.channels > 1 ? ', the mean of its channels' : ''}. Grey: no fit.`;
    this.scale.replaceChildren(h('span', {}, tidy(low, 3)), h('span', { class: 'motes-ramp' }), h('span', {}, tidy(high, 3)));
    const bar = this.scale.querySelector<HTMLElement>('.motes-ramp')!;
    bar.style.background = `linear-gradient(90deg, ${[0, 51, 102, 153, 204, 255].map((k) => `rgb(${this.ramp.subarray(3 * k, 3 * k + 3).join(',')})`).join(', ')})`;
    return (x, y) => {
      const first = this.index(view, x, y);
      let sum = 0;
      for (let channel = 0; channel < view.channels; channel += 1) sum += source[first + channel]!;
      if (!Number.isFinite(sum)) return GREY;
      const k = 3 * Math.round(clamp((sum / view.channels - low) / (high - low), 0, 1) * 255);
      return [this.ramp[k]!, this.ramp[k + 1]!, this.ramp[k + 2]!];
    };
  }

  /** The words for the texel. */
  private read(): void {
    const { x, y, time } = this.state;
    const { step, hours } = this.payload;
    this.cursor.style.left = `${(100 * (x + 0.5)) / this.columns}%`;
    this.cursor.style.top = `${(100 * (y + 0.5)) / this.rows}%`;
    this.cursor.parentElement?.style.setProperty('--map', this.canvas.style.width);
    const residual = this.residual.values[this.index(this.residual.view, x, y)]!;
    const ended = words(this.word(this.payload.statuses, this.code(this.status, x, y)));
    const at = hours.length > 1 ? ` at ${tidy(hours[time]!)} h` : '';
    this.where.textContent = `Row ${y * step}, column ${x * step}${at}: ${ended}${Number.isFinite(residual) ? `, relative residual ${share(residual)}` : ''}`;
    this.table.replaceChildren(...this.told().map((row) => h('tr', {}, h('th', { scope: 'row' }, row.name), h('td', {}, row.value), h('td', {}, row.error && `± ${row.error}`), h('td', {}, words(row.verdict)))));
    if (hours.length > 1) this.course();
  }

  /** The chosen parameter over time. */
  private course(): void {
    const { x, y, time, layer } = this.state;
    const { hours, channels } = this.payload;
    const chosen = layer === RESIDUAL ? this.residual : (this.layers[layer] ?? this.residual);
    const { view, values, stderr } = chosen;
    if (view.times < 2) {
      this.chart.svg.style.display = 'none';
      return;
    }
    this.chart.svg.style.display = '';
    const texel = (y * this.columns + x) * view.times * view.channels;
    const picks = view.channels === 1 ? [{ channel: 0, tint: 'grey' }] : shownChannels(channels, []);
    const lines = picks.map(({ channel, tint }) => {
      const of = (source: Float32Array): number[] => hours.map((_, k) => source[texel + k * view.channels + channel]!);
      return { tint, middle: of(values), error: stderr ? of(stderr) : null };
    });
    const ends = lines.flatMap(({ middle, error }) => middle.flatMap((value, k) => [value - (error?.[k] || 0), value + (error?.[k] || 0)])).filter(Number.isFinite);
    const [low, high] = ends.length ? [Math.min(...ends), Math.max(...ends)] : [0, 1];
    const room = 0.08 * (high - low || Math.abs(high) || 1);
    this.chart.begin(`${view.name} over time at the texel`, { low: hours[0]!, high: hours.at(-1)!, label: 'hours' }, { low: low - room, high: high + room, label: view.name });
    for (const { tint, middle, error } of lines) {
      if (error) this.chart.bars(hours, middle.map((value, k) => value - error[k]!), middle.map((value, k) => value + error[k]!), tint);
      this.chart.dots(hours, middle, tint);
    }
    this.chart.mark(hours[time]!);
  }

  // ---------------------------------------------------------------- places

  private index(view: LayerView, x: number, y: number): number {
    return ((y * this.columns + x) * view.times + Math.min(this.state.time, view.times - 1)) * view.channels;
  }

  private code(codes: Uint8Array, x: number, y: number): number {
    const times = codes.length / (this.rows * this.columns);
    return codes[(y * this.columns + x) * times + Math.min(this.state.time, times - 1)]!;
  }

  private word(named: Record<string, [number, string]>, code: number): string {
    return Object.entries(named).find(([, [each]]) => each === code)?.[0] ?? '';
  }

  private point(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const x = clamp(Math.floor(((event.clientX - box.left) / box.width) * this.columns), 0, this.columns - 1);
    const y = clamp(Math.floor(((event.clientY - box.top) / box.height) * this.rows), 0, this.rows - 1);
    if (x === this.state.x && y === this.state.y) return;
    Object.assign(this.state, { x, y });
    this.read();
  }

  private key(event: KeyboardEvent): void {
    const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (!dx && !dy) return;
    event.preventDefault();
    const far = event.shiftKey ? 10 : 1;
    Object.assign(this.state, { x: clamp(this.state.x + far * dx!, 0, this.columns - 1), y: clamp(this.state.y + far * dy!, 0, this.rows - 1) });
    this.read();
  }
}

const GREY: [number, number, number] = [128, 128, 128];
const words = (name: string): string => name.replace(/_/g, ' ');
const share = (part: number): string => `${tidy(100 * part, 3)} %`;

function unpacked(view: LayerView): Layer {
  return { view, values: new Float32Array(bytes(view.values)), stderr: view.stderr ? new Float32Array(bytes(view.stderr)) : null, verdicts: view.verdicts ? new Uint8Array(bytes(view.verdicts)) : null };
}

/** A linear value as sRGB of eight bits: IEC 61966-2-1. */
function encoded(linear: number): number {
  const x = clamp(linear, 0, 1);
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

function swatch(css: string): HTMLElement {
  const made = h('i', { class: 'motes-swatch' });
  made.style.background = css;
  return made;
}

const data = document.getElementById('motes-data');
const page = document.getElementById('motes') as (HTMLElement & { motesMap?: MapPage }) | null;
if (data && page) page.motesMap = new MapPage(page, JSON.parse(data.textContent ?? 'null') as MapPayload);
