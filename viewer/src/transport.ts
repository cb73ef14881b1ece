// The time: a slider with play and pause below the picture.

import { fresh, h, tidy, write } from './dom';

/** The whole course is played in so many seconds. */
const SECONDS = 8;

export class Transport {
  readonly element: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly range: HTMLInputElement;
  private readonly words = h('output', { class: 'motes-hours' });
  private interval: [number, number] = [0, 1];
  playing = false;
  private last = 0;

  constructor(
    private readonly set: (hours: number) => void,
    private readonly wake: () => void,
  ) {
    const id = fresh('time');
    this.button = h('button', { type: 'button', class: 'motes-play', 'aria-label': 'Play', onclick: () => this.toggle() }, '▶');
    this.range = h('input', { type: 'range', id, step: 'any', class: 'motes-range' });
    this.range.addEventListener('input', () => {
      this.pause();
      this.set(Number(this.range.value));
    });
    this.range.addEventListener('keydown', (event) => {
      const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      this.pause();
      const [low, high] = this.interval;
      this.set(Math.min(Math.max(Number(this.range.value) + (by * (high - low)) / 100, low), high));
    });
    this.element = h('div', { class: 'motes-transport', role: 'group', 'aria-label': 'Time' }, this.button, h('label', { for: id }, 'time'), this.range, this.words);
  }

  show(interval: [number, number] | null, hours: number): void {
    this.element.hidden = interval === null;
    if (!interval) {
      this.pause();
      return;
    }
    this.interval = interval;
    this.range.min = String(interval[0]);
    this.range.max = String(interval[1]);
    this.range.value = String(hours);
    const words = `${tidy(hours, 3)} h`;
    this.range.setAttribute('aria-valuetext', words);
    write(this.words, words);
  }

  toggle(): void {
    if (this.element.hidden) return;
    if (this.playing) this.pause();
    else {
      this.playing = true;
      this.last = 0;
      if (Number(this.range.value) >= this.interval[1]) this.set(this.interval[0]);
      this.label('Pause', '❚❚');
      this.wake();
    }
  }

  pause(): void {
    this.playing = false;
    this.label('Play', '▶');
  }

  /** Move on by what has passed since the last frame; it begins again after the end. */
  advance(now: number, hours: number): void {
    if (!this.playing) return;
    const passed = this.last ? Math.min(now - this.last, 200) : 0;
    this.last = now;
    const [low, high] = this.interval;
    const next = hours + ((high - low) * passed) / 1000 / SECONDS;
    this.set(next > high ? low : next);
  }

  private label(text: string, sign: string): void {
    this.button.setAttribute('aria-label', text);
    write(this.button, sign);
  }
}
