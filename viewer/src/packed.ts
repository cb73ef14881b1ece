// What a page holds as base64: numbers, and deflated JSON.

import { strFromU8, unzlibSync } from 'three/examples/jsm/libs/fflate.module.js';

/** The bytes of base64. */
export function bytes(text: string): ArrayBuffer {
  const letters = atob(text);
  const array = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k += 1) array[k] = letters.charCodeAt(k);
  return array.buffer;
}

/** A JSON value that was deflated as zlib does. */
export function inflated(text: string): unknown {
  return JSON.parse(strFromU8(unzlibSync(new Uint8Array(bytes(text)))));
}
