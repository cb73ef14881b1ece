// Controls with their labels: sliders with a number beside them, choices, switches, buttons.

import { fresh, h, symbol, tidy } from './dom';

export interface SliderOptions {
  /** For everybody; `shown` is what is seen where that is shorter. */
  label: string;
  shown?: string;
  symbol?: string;
  unit?: string;
  hint?: string;
  low: number;
  high: number;
  /** Of a single step; fine by default. */
  step?: number;
  tint?: string;
  /** A value that somebody set; may throw a `Problem`. */
  set: (value: number) => void;
  reset?: () => void;
  resetLabel?: string;
}

export class Slider {
  readonly element: HTMLElement;
  private readonly range: HTMLInputElement;
  private readonly number: HTMLInputElement;
  private readonly button: HTMLButtonElement | null = null;
  private shown = NaN;

  constructor(
    private readonly options: SliderOptions,
    fail: (error: unknown) => void,
  ) {
    const id = fresh('slider');
    const { low, high, label, unit, hint } = options;
    const step = options.step ?? (high - low) / 500;
    const words = `${label}${unit ? `, ${unit}` : ''}`;
    this.range = h('input', { type: 'range', id, min: low, max: high, step: 'any', class: `motes-range ${options.tint ?? ''}`, title: hint, 'aria-label': words });
    this.number = h('input', { type: 'number', step: Number(step.toPrecision(1)), class: 'motes-number', 'aria-label': `${words}: number` });
    const attempt = (value: number): void => {
      try {
        options.set(value);
      } catch (error) {
        fail(error);
        this.show(this.shown, undefined, true);
      }
    };
    this.range.addEventListener('input', () => attempt(Number(this.range.value)));
    // `any` lets the value be what it is; the keys then need steps of their own.
    this.range.addEventListener('keydown', (event) => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const span = (high - low) / 100;
      attempt(Math.min(Math.max(Number(this.range.value) + by * (options.step ?? span), low), high));
    });
    this.number.addEventListener('change', () => attempt(this.number.value === '' ? NaN : Number(this.number.value)));
    if (options.reset) {
      const reset = options.reset;
      this.button = h('button', { type: 'button', class: 'motes-reset', title: options.resetLabel ?? 'Reset', 'aria-label': `Reset ${label}`, onclick: () => reset() }, '↺');
    }
    const name = h('label', { for: id, title: hint }, options.symbol ? symbol(options.symbol) : null, options.symbol ? ' ' : null, h('span', {}, options.shown ?? label), unit ? h('span', { class: 'motes-unit' }, `\u00a0${unit}`) : null);
    this.element = h('div', { class: 'motes-slider' }, name, this.range, this.number, this.button);
  }

  /** Follow a value; `held` says whether it was set by hand. */
  show(value: number, held?: boolean, force = false): void {
    if (value !== this.shown || force) {
      this.shown = value;
      this.range.value = String(value);
      this.number.value = tidy(value);
      this.range.setAttribute('aria-valuetext', `${tidy(value)}${this.options.unit ? ` ${this.options.unit}` : ''}`);
    }
    if (held !== undefined && this.button) this.button.disabled = !held;
  }
}

/** A choice among words. */
export class Choice {
  readonly element: HTMLElement;
  private readonly select: HTMLSelectElement;
  private filled = '';

  constructor(label: string, options: readonly (readonly [string, string])[], set: (value: string) => void) {
    const id = fresh('choice');
    this.select = h('select', { id, onchange: () => set(this.select.value) });
    this.fill(options);
    this.element = h('div', { class: 'motes-choice' }, h('label', { for: id }, label), this.select);
  }

  fill(options: readonly (readonly [string, string])[]): void {
    const wanted = JSON.stringify(options);
    if (wanted === this.filled) return;
    this.filled = wanted;
    const now = this.select.value;
    this.select.replaceChildren(...options.map(([value, words]) => h('option', { value }, words)));
    this.show(now);
  }

  show(value: string): void {
    if (Array.from(this.select.options).some((option) => option.value === value)) this.select.value = value;
  }
}

/** On or off. */
export class Switch {
  readonly element: HTMLElement;
  private readonly box: HTMLInputElement;

  constructor(label: string, set: (on: boolean) => void, hint?: string) {
    this.box = h('input', { type: 'checkbox', onchange: () => set(this.box.checked) });
    this.element = h('label', { class: 'motes-switch', title: hint }, this.box, ' ', label);
  }

  show(on: boolean): void {
    this.box.checked = on;
  }
}

export function button(label: string, action: () => void, attributes: Record<string, string> = {}): HTMLButtonElement {
  return h('button', { type: 'button', ...attributes, onclick: () => action() }, label);
}

/** A part of the panel that opens and closes. */
export function section(title: string, open: boolean, ...children: (Node | null)[]): HTMLDetailsElement {
  return h('details', { class: 'motes-section', open }, h('summary', {}, h('h2', {}, title)), h('div', { class: 'motes-body' }, ...children));
}
