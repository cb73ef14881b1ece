// Elements by function calls.  Text is always set as text, so names out of files are never markup.

type Child = Node | string | null | undefined;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: Event) => void)>;

/** An HTML element; attributes that begin with `on` and are functions become listeners, `false` and null leave one out. */
export function h<K extends keyof HTMLElementTagNameMap>(name: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  apply(element, attributes, children);
  return element;
}

/** An SVG element. */
export function s<K extends keyof SVGElementTagNameMap>(name: K, attributes: Attributes = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  apply(element, attributes, children);
  return element;
}

function apply(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true ? '' : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined));
}

/** Set an element's text where it is another: what is set anew is laid out and painted anew, at each frame of what moves. */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** `σ_s` with the part behind the underscore set lower. */
export function symbol(text: string): HTMLElement {
  const [base, lower] = text.split('_');
  return h('i', { class: 'motes-symbol' }, base ?? '', lower ? h('sub', {}, lower) : null);
}

let count = 0;

/** An id of its own: several viewers may stand in one notebook. */
export function fresh(prefix: string): string {
  count += 1;
  return `motes-${prefix}-${count}`;
}

/** A number as people write it, to about four digits. */
export function tidy(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return 'not a number';
  if (value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5)) return value.toExponential(2);
  return String(Number(value.toPrecision(Math.abs(value) < 0.01 ? Math.min(digits, 3) : digits)));
}

export const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
export const degrees = (radians: number): number => (radians * 180) / Math.PI;
export const radians = (degrees: number): number => (degrees * Math.PI) / 180;
