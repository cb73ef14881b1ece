// Copying and saving: material JSON, shader, picture, link.

import { button, section } from './controls';
import { h } from './dom';
import { toJson, type Material } from './material';
import type { Messages } from './messages';
import type { Pair } from './pair';
import type { State, Store } from './state';

/** Text to the clipboard; where a page has none, an old way that asks nobody. */
export async function copy(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    return;
  } catch {
    const area = h('textarea', { 'aria-hidden': 'true', tabindex: -1, class: 'motes-offscreen' });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    if (!done) throw new Error('The browser does not let this page copy');
  }
}

/** A file to keep. */
export function save(name: string, content: Blob | string, type = 'text/plain'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type }) : content;
  const address = URL.createObjectURL(blob);
  const link = h('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** A name as part of a file's name. */
export function slug(name: string): string {
  return name.replace(/[^\w.-]+/g, '-').replace(/^[-.]+|[-.]+$/g, '').slice(0, 60) || 'material';
}

/** The picture as large as it is seen: while things move the canvas has fewer pixels. */
export function pictureOf(canvas: HTMLCanvasElement): Promise<Blob> {
  let whole = canvas;
  if (canvas.width < canvas.clientWidth) {
    whole = h('canvas', { width: canvas.clientWidth, height: canvas.clientHeight });
    whole.getContext('2d')?.drawImage(canvas, 0, 0, whole.width, whole.height);
  }
  return new Promise((resolve, reject) => whole.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture cannot be read')))));
}

/** The part of the panel with the buttons; `link` is null where there is none. */
export function takeawaySection(store: Store, start: State, pair: Pair, canvas: HTMLCanvasElement, messages: Messages, link: (() => string) | null, openFile: HTMLElement): HTMLDetailsElement {
  const active = (): Material => pair.active(store.state);
  const named = (suffix: string): string => `${slug(active().name)}.${suffix}`;
  const json = (): string => {
    const { state } = store;
    return `${JSON.stringify(toJson(active(), pair.values(state, state.active), pair.held(state, state.active), active().time ? state.hours : null), null, 1)}\n`;
  };
  const copied = (what: string, text: () => string) => (): void => {
    copy(text()).then(() => messages.say(`${what} is copied`), messages.fail);
  };
  const copyLink = (address: string): void => {
    try {
      history.replaceState(null, '', address);
    } catch {
      // Some browsers refuse for files; the link itself is copied all the same.
    }
    copied('The link, which restores what you see,', () => address)();
  };
  return section(
    'Take away',
    true,
    h(
      'div',
      { class: 'motes-buttons' },
      button('Copy material', copied('The material', json)),
      button('Save material', () => save(named('json'), json(), 'application/json')),
      button('Copy shader', copied('The shader', () => active().shader.source)),
      button('Save shader', () => save(named('glsl'), active().shader.source)),
      button('Save picture', () => void pictureOf(canvas).then((blob) => save(named('png'), blob), messages.fail)),
      link ? button('Copy link', () => copyLink(link())) : null,
      openFile,
      button('Reset all', () => store.change({ ...structuredClone(start), dropped: [null, null] })),
    ),
    h('p', { class: 'motes-caption' }, 'Open or drop a material.json, a table of measurements (CSV: theta_i, phi_i, theta_r, phi_r, channels) or a mesh (OBJ, PLY, GLB). Files stay in this page; nothing is sent and nothing is remembered.'),
  );
}
