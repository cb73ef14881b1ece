// The section of time: each parameter that changes, with its band, what each scan said, and the present time.

import { Chart } from './chart';
import { h, tidy } from './dom';
import type { Material, Values } from './material';
import { shownChannels } from './slice';
import type { State } from './state';

const [WIDTH, HEIGHT] = [250, 140];

export class Trends {
  readonly element = h('div', { class: 'motes-trends' });
  private readonly charts = new Map<string, { chart: Chart; words: HTMLElement }>();
  private material: Material | null = null;

  update(state: State, material: Material, values: Values): void {
    if (material !== this.material) this.make(material);
    const time = material.time;
    if (!time) return;
    const hours = time.hours;
    for (const [name, trend] of Object.entries(time.trends)) {
      const shown = this.charts.get(name);
      const slot = material.slots.find((each) => each.name === name);
      if (!shown || !slot) continue;
      const width = trend.values[0]!.length;
      const picks = width === 1 ? [{ channel: 0, tint: 'grey' }] : shownChannels(material.channels, material.wavelengths);
      const columns = picks.map(({ channel }) => {
        const y = trend.values.map((row) => row[channel]!);
        const error = trend.stderr ? trend.stderr.map((row) => row[channel] ?? 0) : null;
        return { y, low: error ? y.map((v, k) => v - 1.96 * error[k]!) : y, high: error ? y.map((v, k) => v + 1.96 * error[k]!) : y };
      });
      const scans = trend.scans;
      let [low, high] = [Math.min(...columns.flatMap((c) => c.low)), Math.max(...columns.flatMap((c) => c.high))];
      if (scans) {
        for (const row of scans.values) {
          for (const { channel } of picks) {
            const value = row[channel];
            // What a scan alone hardly determines may lie far off; the axis does not follow it beyond the trend's own reach.
            if (typeof value === 'number') [low, high] = [Math.min(low, Math.max(value, low - (high - low))), Math.max(high, Math.min(value, high + (high - low)))];
          }
        }
      }
      const bounds = slot.declared;
      low = Math.max(low, bounds.low);
      if (bounds.high !== null) high = Math.min(high, bounds.high);
      const room = (high - low) * 0.08 || Math.abs(high) * 0.2 || 0.1;
      const label = `${name} over time: ${trend.kind}, from ${list(trend.values[0]!)} to ${list(trend.values.at(-1)!)}; at ${tidy(state.hours)} h ${list(values[name]!)}`;
      shown.chart.begin(label, { low: hours[0]!, high: hours.at(-1)!, label: 'hours' }, { low: low - room, high: high + room, label: `${slot.declared.symbol}${slot.declared.unit ? ` (${slot.declared.unit})` : ''}` });
      picks.forEach(({ channel, tint }, k) => {
        const { y, low: below, high: above } = columns[k]!;
        if (trend.stderr) shown.chart.band(hours, below, above, tint);
        if (scans) {
          const value = scans.values.map((row) => row[channel] ?? NaN);
          const error = scans.stderr.map((row) => row[channel] ?? NaN);
          shown.chart.bars(scans.hours, value.map((v, i) => v - error[i]!), value.map((v, i) => v + error[i]!), tint);
          shown.chart.dots(scans.hours, value, tint);
        }
        shown.chart.line({ x: hours, y, tint });
      });
      shown.chart.mark(state.hours);
      shown.words.textContent = `${name}: ${trend.kind.replaceAll('_', ' ')}, now ${list(values[name]!)}${slot.declared.unit ? ` ${slot.declared.unit}` : ''}`;
    }
  }

  private make(material: Material): void {
    this.material = material;
    this.charts.clear();
    const trends = Object.entries(material.time?.trends ?? {});
    const parts = trends.map(([name]) => {
      const chart = new Chart(`${name} over time`, HEIGHT, WIDTH);
      const words = h('figcaption', {});
      this.charts.set(name, { chart, words });
      return h('figure', { class: 'motes-trend' }, words, chart.svg);
    });
    const banded = trends.some(([, trend]) => trend.stderr);
    const scanned = trends.some(([, trend]) => trend.scans);
    const legend = [banded ? 'Bands: 95 %.' : 'No errors are known, so there are no bands.', scanned ? 'Dots: what each scan says on its own, with one standard error.' : ''].filter(Boolean).join(' ');
    this.element.replaceChildren(h('div', { class: 'motes-multiples' }, ...parts), h('p', { class: 'motes-caption' }, legend));
  }
}

const list = (values: readonly number[]): string => (values.length > 4 ? `${tidy(values[0]!, 3)} … ${tidy(values.at(-1)!, 3)}` : values.map((value) => tidy(value, 3)).join(', '));
