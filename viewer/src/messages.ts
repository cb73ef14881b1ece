// Sentences for the user: what went wrong and what to do, or what happened.

import { h } from './dom';
import { Problem } from './problem';

const MOST = 4;

export class Messages {
  readonly element: HTMLElement;
  private readonly polite = h('div', { role: 'status', 'aria-live': 'polite' });
  private readonly urgent = h('div', { role: 'alert' });

  constructor() {
    this.element = h('div', { class: 'motes-messages' }, this.urgent, this.polite);
  }

  say(text: string): void {
    this.put(this.polite, 'said', text, '');
  }

  /** Arrow, so that it can be handed on. */
  fail = (error: unknown): void => {
    const [text, hint] = error instanceof Problem ? [error.message, error.hint] : [`The viewer failed in a way it should not: ${error instanceof Error ? error.message : String(error)}`, 'Load the page again and report this'];
    this.put(this.urgent, 'failed', text, hint);
  };

  private put(place: HTMLElement, kind: string, text: string, hint: string): void {
    const line = h('div', { class: `motes-message ${kind}` }, h('p', {}, `${text.replace(/\.$/, '')}.`, hint ? h('span', {}, ` ${hint.replace(/\.$/, '')}.`) : null), h('button', { type: 'button', 'aria-label': 'Dismiss', onclick: () => line.remove() }, '×'));
    for (const other of Array.from(place.children)) if (other.querySelector('p')?.textContent === line.querySelector('p')!.textContent) other.remove();
    place.prepend(line);
    while (place.children.length > MOST) place.lastElementChild!.remove();
  }
}
