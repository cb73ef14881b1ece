// Sliders for every parameter of a material, as it declares them.

import { Slider } from './controls';
import type { Slot } from './expression';
import { h, write } from './dom';
import { check, type Material, type Values } from './material';
import { shownChannels } from './slice';

const MOST_SLIDERS = 4;

interface Row {
  slot: Slot;
  sliders: { slider: Slider; channel: number | null }[];
  state: HTMLElement;
}

export class Parameters {
  readonly element = h('div', { class: 'motes-parameters' });
  private rows: Row[] = [];
  private material: Material | null = null;
  private current: Values = {};

  constructor(
    private readonly hold: (name: string, value: number[] | null) => void,
    private readonly fail: (error: unknown) => void,
  ) {}

  /** Follow the values of a material; its sliders are made anew when it is another one. */
  show(material: Material, values: Values, held: Values): void {
    this.current = values;
    if (material !== this.material) this.make(material);
    for (const { slot, sliders, state } of this.rows) {
      const value = values[slot.name]!;
      const byHand = slot.name in held;
      for (const { slider, channel } of sliders) slider.show(channel === null ? mean(value) / (mean(slot.value) || 1) : value[channel]!, byHand);
      const follows = material.time?.trends[slot.name];
      state.classList.toggle('own', byHand);
      write(state, byHand ? ` · set by hand${follows ? ', no longer follows time' : ''}` : follows ? ` · follows time: ${follows.kind.replaceAll('_', ' ')}` : '');
    }
  }

  private make(material: Material): void {
    this.material = material;
    this.rows = material.slots.map((slot) => this.row(material, slot));
    this.element.replaceChildren(
      ...this.rows.map(({ slot, sliders, state }) =>
        h('div', { class: 'motes-parameter', role: 'group', 'aria-label': `${slot.name}: ${slot.declared.meaning}` }, ...sliders.map(({ slider }) => slider.element), h('p', { class: 'motes-meaning' }, `${slot.declared.meaning}, ${range(slot)}`, state)),
      ),
    );
  }

  private row(material: Material, slot: Slot): Row {
    const { declared } = slot;
    const state = h('span', { class: 'motes-held' });
    const width = slot.value.length;
    const common = { symbol: declared.symbol, unit: declared.unit, hint: declared.meaning, reset: () => this.hold(slot.name, null) };
    if (width > MOST_SLIDERS) {
      // Of a spectrum the height is set, the shape kept.
      const set = (factor: number): void => {
        const value = slot.value.map((x) => x * factor);
        for (const x of value) check(slot, x);
        this.hold(slot.name, value);
      };
      return { slot, state, sliders: [{ slider: new Slider({ ...common, label: `${slot.name}, factor for all ${width} channels`, low: 0, high: 2, set }, this.fail), channel: null }] };
    }
    const [low, high] = reach(slot);
    const names = shownChannels(material.channels, material.wavelengths);
    const sliders = slot.value.map((_, channel) => {
      const named = width > 1 ? ` ${material.channels[channel] ?? channel + 1}` : '';
      const set = (value: number): void => {
        check(slot, value);
        this.hold(slot.name, this.current[slot.name]!.map((x, k) => (k === channel ? value : x)));
      };
      const tint = width > 1 ? names.find((each) => each.channel === channel)?.tint : undefined;
      return { slider: new Slider({ ...common, label: `${slot.name}${named}`, shown: `${slot.name === declared.symbol ? '' : slot.name}${named}`, low, high, set, ...(tint ? { tint } : {}) }, this.fail), channel };
    });
    return { slot, sliders, state };
  }
}

/** The range of a slider: what real materials span, and what this one has. */
function reach(slot: Slot): [number, number] {
  const { low, high, open, typical } = slot.declared;
  const hair = open && high !== null ? (high - low) * 1e-3 : 0;
  const least = Math.max(Math.min(typical[0], ...slot.value), low + hair);
  const most = Math.min(Math.max(typical[1], ...slot.value.map((x) => x * 1.25)), (high ?? Infinity) - hair);
  return [least, most];
}

function range(slot: Slot): string {
  const { low, high, open, unit } = slot.declared;
  const top = high === null ? '∞' : String(Number(high.toPrecision(4)));
  return `${open ? '(' : '['}${low}, ${top}${open || high === null ? ')' : ']'}${unit ? ` ${unit}` : ''}`;
}

const mean = (list: readonly number[]): number => list.reduce((sum, x) => sum + x, 0) / list.length;
