// Numbers that a page holds as base64.

/** The bytes of base64. */
export function bytes(text: string): ArrayBuffer {
  const letters = atob(text);
  const array = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k += 1) array[k] = letters.charCodeAt(k);
  return array.buffer;
}
