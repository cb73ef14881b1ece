// Files that are dropped or opened: what each one is, by its name and its content.

import type { App } from './app';
import { fromCsv } from './measurement';
import { SUFFIXES } from './meshfiles';
import { Problem } from './problem';

const LARGEST_TEXT = 256 * 2 ** 20;

/** A file of the user's. */
export async function open(file: File, app: App, second = false): Promise<void> {
  const lower = file.name.toLowerCase();
  const suffix = lower.slice(lower.lastIndexOf('.'));
  if (SUFFIXES.includes(suffix)) {
    app.openMesh(file.name, await file.arrayBuffer());
    return;
  }
  if (!['.json', '.csv', '.txt', '.tsv'].includes(suffix)) throw new Problem(`${file.name} is neither a material, a table nor a mesh`, 'Drop a .json, .csv, .obj, .ply or .glb file');
  if (file.size > LARGEST_TEXT) throw new Problem(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB, more than ${LARGEST_TEXT / 2 ** 20}`, 'motes view DATA thins any measurement');
  const text = await file.text();
  if (suffix === '.json') app.openMaterial(parsed(file.name, text), second);
  else app.openData(fromCsv(file.name, text));
}

function parsed(name: string, text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Problem(`${name} is not JSON: ${error instanceof Error ? error.message : String(error)}`, 'Drop a material.json that motes fit wrote; NaN is not JSON');
  }
}

/** Take what is dropped anywhere on the viewer. */
export function accept(root: HTMLElement, app: App, signal: AbortSignal): void {
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
      for (const file of Array.from(event.dataTransfer?.files ?? [])) open(file, app, event.shiftKey).catch(app.messages.fail);
    },
    { signal },
  );
}
