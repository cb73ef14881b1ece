// Files that are dropped or opened: what each one is, by its name and its content.

import { decoded } from './cells';
import { button } from './controls';
import { h } from './dom';
import { fromCsv, type Measurement } from './measurement';
import { SUFFIXES } from './meshfiles';
import type { Messages } from './messages';
import { Problem } from './problem';
import { readSky, SKY_SUFFIXES } from './skyfile';

const LARGEST_TEXT = 256 * 2 ** 20;

/** Who takes what a file holds. */
export interface Taker {
  readonly messages: Messages;
  openMaterial(json: unknown, second: boolean): void;
  openData(data: Measurement): void;
  openMesh(name: string, data: ArrayBuffer): Promise<void>;
  openSky(name: string, map: Float32Array): void;
}

/** A file of the user's. */
export async function open(file: File, taker: Taker, second = false): Promise<void> {
  const lower = file.name.toLowerCase();
  const suffix = lower.slice(lower.lastIndexOf('.'));
  if (SUFFIXES.includes(suffix)) {
    await taker.openMesh(file.name, await file.arrayBuffer());
    return;
  }
  if (SKY_SUFFIXES.includes(suffix)) {
    taker.openSky(file.name, readSky(file.name, await file.arrayBuffer()));
    return;
  }
  if (!['.json', '.csv', '.txt', '.tsv', '.dat'].includes(suffix)) throw new Problem(`${file.name} is neither a material, a table, a mesh nor a sky`, 'Drop a .json, .csv, .obj, .ply, .glb, .hdr or .exr file');
  if (file.size > LARGEST_TEXT) throw new Problem(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB, more than ${LARGEST_TEXT / 2 ** 20}`, 'motes view DATA thins any measurement');
  const text = decoded(await file.arrayBuffer());
  if (suffix === '.json') taker.openMaterial(parsed(file.name, text), second);
  else taker.openData(fromCsv(file.name, text));
}

function parsed(name: string, text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Problem(`${name} is not JSON: ${error instanceof Error ? error.message : String(error)}`, 'Drop a material.json that motes fit wrote; NaN is not JSON');
  }
}

/** Take what is dropped anywhere on the viewer. */
export function accept(root: HTMLElement, taker: Taker, signal: AbortSignal): void {
  root.addEventListener(
    'dragover',
    (event) => {
      event.preventDefault();
      root.classList.add('motes-over');
    },
    { signal },
  );
  root.addEventListener('dragleave', () => root.classList.remove('motes-over'), { signal });
  root.addEventListener(
    'drop',
    (event) => {
      event.preventDefault();
      root.classList.remove('motes-over');
      for (const file of Array.from(event.dataTransfer?.files ?? [])) open(file, taker, event.shiftKey).catch(taker.messages.fail);
    },
    { signal },
  );
}

/** A button that opens a file of these types. */
export function fileButton(label: string, types: string, taker: Taker, second: boolean): HTMLElement {
  const input = h('input', { type: 'file', accept: types, class: 'motes-offscreen', tabindex: -1, 'aria-label': label });
  input.addEventListener('change', () => {
    const file = input.files?.[0];
    if (file) open(file, taker, second).catch(taker.messages.fail);
    input.value = '';
  });
  return h('span', {}, button(label, () => input.click()), input);
}
