// The section of the data: measured points over the curve, and what is left between them.

import { Chart } from './chart';
import { Slider } from './controls';
import { degrees, h, radians, tidy } from './dom';
import type { Material, Values } from './material';
import { scanAt, type Measurement } from './measurement';
import type { Probe } from './probe';
import { near, signed } from './reflection';
import { inPlane, scaled, shownChannels } from './slice';
import { RANGES, type State } from './state';

const ANGLES = [-90, -60, -30, 0, 30, 60, 90];
const MOST_DOTS = 2500;

export class Agreement {
  readonly element: HTMLElement;
  private readonly curve = new Chart('Measured and computed');
  private readonly rest = new Chart('Residuals', 170);
  private readonly words = h('p', { class: 'motes-caption' });
  private readonly restWords = h('p', { class: 'motes-caption' });
  private readonly incidence: Slider;
  /** Of the present values over all shown samples of the present scan, in parts of the measured root mean square. */
  relativeRms = NaN;

  constructor(change: (patch: Partial<State>) => void, fail: (error: unknown) => void) {
    this.incidence = new Slider({ label: 'angle of incidence', symbol: 'θ_i', unit: '°', ...RANGES.incidence, step: 1, set: (incidence) => change({ incidence: Math.min(Math.max(incidence, 0), 88) }) }, fail);
    this.element = h('div', {}, this.curve.svg, this.words, this.incidence.element, this.rest.svg, this.restWords);
  }

  update(state: State, material: Material, values: Values, probe: Probe, data: Measurement): void {
    this.incidence.show(state.incidence);
    const channels = material.shader.channels;
    const shown = shownChannels(data.channels, material.wavelengths);
    const scan = scanAt(data, state.hours);
    const measured = (k: number, c: number): number => data.values[(scan * data.count + k) * data.channels.length + c]!;
    const own = (c: number): number => (channels === 1 ? 0 : Math.min(c, channels - 1));
    // The curve, and the points near it.
    const theta = Float32Array.from({ length: 179 }, (_, k) => radians(k + 1 - 90));
    const wo = Float32Array.from([...theta].flatMap(inPlane));
    const wi = new Float32Array(wo.length);
    for (let k = 0; k < theta.length; k += 1) wi.set(inPlane(-radians(state.incidence)), 3 * k);
    const f = probe.evaluate(material, values, wi, wo);
    const some = near(data, state.incidence);
    const points = shown.map(({ channel }) => some.map((k) => scaled(measured(k, channel), state.scale)));
    const curves = shown.map(({ channel }) => Array.from(theta, (_, k) => scaled(f[k * channels + own(channel)]!, state.scale)));
    let most = 0;
    const steep = radians(86); // beyond, curves may grow without bound
    for (const list of points) for (const y of list) if (y > most) most = y;
    for (const list of curves) list.forEach((y, k) => (Math.abs(theta[k]!) < steep && y > most ? (most = y) : 0));
    const write = (value: number): string => tidy(state.scale === 'cube root' ? value ** 3 : value, 2);
    const label = `${data.name}: measured and computed BRDF in the plane of incidence at ${tidy(state.incidence)}°`;
    this.curve.begin(label, { low: -90, high: 90, ticks: ANGLES, label: 'θ_r (°), mirror side positive' }, { low: 0, high: most * 1.06 || 1, label: 'f (1/sr)', write });
    shown.forEach(({ tint }, k) => {
      this.curve.line({ x: theta.map(degrees), y: curves[k]!, tint });
      this.curve.dots(some.map((i) => degrees(signed(data, i))), points[k]!, tint);
    });
    this.curve.mark(-state.incidence);
    const nearest = some.length ? '' : ` No sample lies within 2.5° of this incidence and 3° of the plane; the nearest incidence with one is ${this.nearest(data, state.incidence)}.`;
    const time = data.hours.length > 1 ? ` Scan ${scan + 1} of ${data.hours.length}, at ${tidy(data.hours[scan]!)} ${data.unit}.` : '';
    this.words.textContent = `${some.length} measured directions near the plane of incidence (dots), the model (lines).${time}${nearest}`;
    this.residuals(material, values, probe, data, scan, measured, own);
  }

  private residuals(material: Material, values: Values, probe: Probe, data: Measurement, scan: number, measured: (k: number, c: number) => number, own: (c: number) => number): void {
    const channels = material.shader.channels;
    const f = probe.evaluate(material, values, data.wi, data.wo);
    let [squares, all, count] = [0, 0, 0];
    const shown = shownChannels(data.channels, material.wavelengths);
    const differences = shown.map(() => new Float32Array(data.count));
    for (let k = 0; k < data.count; k += 1) {
      for (let c = 0; c < data.channels.length; c += 1) {
        const value = measured(k, c);
        const difference = f[k * channels + own(c)]! - value;
        if (!Number.isFinite(difference)) continue;
        squares += difference * difference;
        all += value * value;
        count += 1;
      }
      shown.forEach(({ channel }, i) => (differences[i]![k] = f[k * channels + own(channel)]! - measured(k, channel)));
    }
    const level = Math.sqrt(all / Math.max(count, 1)) || 1;
    this.relativeRms = Math.sqrt(squares / Math.max(count, 1)) / level;
    const step = Math.max(Math.ceil(data.count / MOST_DOTS), 1);
    const picked = Array.from({ length: Math.floor(data.count / step) }, (_, k) => k * step);
    // The middle 98 % set the axis: a few far-off samples would hide the rest.
    const sizes = differences.flatMap((list) => picked.map((k) => Math.abs(list[k]!))).filter(Number.isFinite).sort((a, b) => a - b);
    const reach = ((sizes[Math.floor(0.98 * (sizes.length - 1))] ?? 1) / level) * 100 * 1.15 || 1;
    const label = `Residuals of ${data.name}: computed less measured, in percent of the measured root mean square, over theta_h; relative RMS ${tidy(100 * this.relativeRms, 3)} %`;
    this.rest.begin(label, { low: 0, high: 90, ticks: [0, 15, 30, 45, 60, 75, 90], label: 'θ_h (°)' }, { low: -reach, high: reach, label: 'residual (%)' });
    shown.forEach(({ tint }, i) => this.rest.dots(picked.map((k) => degrees(data.thetaH[k]!)), picked.map((k) => (differences[i]![k]! / level) * 100), tint));
    this.restWords.textContent = `Computed less measured, in percent of the measured root mean square. Relative RMS ${tidy(100 * this.relativeRms, 3)} % over ${count.toLocaleString('en')} samples${data.hours.length > 1 ? ` of scan ${scan + 1}` : ''}.${data.note ? ` ${data.note}` : ''}`;
  }

  private nearest(data: Measurement, incidenceDeg: number): string {
    let best = NaN;
    for (let k = 0; k < data.count; k += 1) {
      const angle = degrees(data.thetaI[k]!);
      if (!(Math.abs(angle - incidenceDeg) >= Math.abs(best - incidenceDeg)) && near(data, angle, 1).length) best = angle;
      if (k > 400 && Number.isFinite(best)) break;
    }
    return Number.isFinite(best) ? `${tidy(best, 3)}°` : 'none';
  }
}
