// A material as the viewer works with it: from the page's data, or from a JSON that was dropped.

import { assemble } from './assembly';
import { baseOf, parse, slots as slotsOf, type Model, type Slot } from './expression';
import { LARGEST_MATERIAL, MATERIAL_FORMAT, MATERIAL_VERSION, type MaterialJson, type MaterialView, type ShaderView, type TimeView } from './generated';
import { Problem, quoted } from './problem';

export type Values = Record<string, number[]>;

export interface Material {
  name: string;
  model: Model;
  slots: Slot[];
  shader: ShaderView;
  time: TimeView | null;
  toSrgb: number[][];
  color: string;
  channels: string[];
  wavelengths: number[];
  json: MaterialJson;
  /** The slot of the optical thickness that dust on a mesh scales: that of a layer on top. */
  tau: string | null;
  dropped: boolean;
}

const LONGEST_NAME = 200;

/** From the page's own data. */
export function fromView(view: MaterialView): Material {
  const model = parse(view.json.model);
  const slots = slotsOf(model);
  for (const slot of slots) {
    slot.value = numbersOf(view.json.parameters[slot.name]?.value, slot.name);
    slot.declared = { ...slot.declared, ...view.ranges[slot.name] };
  }
  const printed = view.shader.uniforms.map((uniform) => uniform.slot).join();
  if (printed !== slots.map((slot) => slot.name).join()) throw new Problem('The shader and the model of this page disagree', 'Write the page again with motes view');
  for (const [k, uniform] of view.shader.uniforms.entries()) slots[k]!.value = widened(slots[k]!.value, uniform.size);
  return made(view.json, model, slots, view.shader, view.time, view.to_srgb, view.color, false);
}

/** From a material.json. */
export function fromText(text: string, library: Record<string, ShaderView>): { material: Material; notes: string[] } {
  if (text.length > LARGEST_MATERIAL) throw new Problem(`The file has ${text.length} characters, more than a material may have`, 'Drop a material.json');
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (error) {
    throw new Problem(`The file is not JSON: ${error instanceof Error ? error.message : String(error)}`, 'Drop a material.json that motes fit wrote; NaN is not JSON');
  }
  return fromJson(data, library);
}

export function fromJson(data: unknown, library: Record<string, ShaderView>): { material: Material; notes: string[] } {
  if (!isRecord(data) || data['format'] !== MATERIAL_FORMAT) throw new Problem(`This JSON is not a Motes material: its format is ${quoted(isRecord(data) ? data['format'] : data)}`, 'motes fit DATA -o OUT writes one');
  const version = data['version'];
  if (typeof version !== 'number' || !Number.isInteger(version) || version > MATERIAL_VERSION)
    throw new Problem(`The material's version ${quoted(version)} is newer than ${MATERIAL_VERSION}, which this page reads`, 'Write the page again with a newer Motes');
  const model = parse(String(data['model']));
  const slots = slotsOf(model);
  const parameters = isRecord(data['parameters']) ? data['parameters'] : {};
  for (const key of Object.keys(parameters))
    if (!slots.some((slot) => slot.name === key)) throw new Problem(`The model ${quoted(data['model'])} has no parameter ${quoted(key)}`, `It has ${slots.map((slot) => slot.name).join(', ')}`);
  for (const slot of slots) {
    const entry = parameters[slot.name];
    if (!isRecord(entry)) throw new Problem(`The material has no value for ${slot.name}`, 'Write it again with motes fit');
    slot.value = numbersOf(entry['value'], slot.name);
    for (const value of slot.value) check(slot, value);
    if (slot.value.length > 1 && !slot.declared.perChannel) throw new Problem(`${slot.name} has ${slot.value.length} values; it is one for all channels`, 'Correct the material');
  }
  const count = Math.max(...slots.map((slot) => slot.value.length));
  if (count !== 1 && count !== 3) throw new Problem(`The material has ${count} channels; one or three can be dropped onto a page`, 'motes view MATERIAL writes a page for any number');
  for (const slot of slots) if (slot.value.length !== 1 && slot.value.length !== count) throw new Problem(`${slot.name} has ${slot.value.length} values and the material ${count} channels`, 'Correct the material');
  const name = String(data['name'] ?? 'material').slice(0, LONGEST_NAME);
  const channels = Array.isArray(data['channels']) && data['channels'].length === count ? data['channels'].map(String) : count === 3 ? ['R', 'G', 'B'] : ['grey'];
  const toSrgb = count === 1 ? [[1, 1, 1]] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const notes: string[] = [];
  const time = timeOf(data['trends'], slots, name, notes);
  const json = { ...data, name, channels } as unknown as MaterialJson;
  const color = count === 3 ? 'the three channels are shown as linear sRGB' : 'shown in grey';
  return { material: made(json, model, slots, assemble(model, slots, library, name), time, toSrgb, color, true), notes };
}

function made(json: MaterialJson, model: Model, slots: Slot[], shader: ShaderView, time: TimeView | null, toSrgb: number[][], color: string, dropped: boolean): Material {
  const own = model.kind === 'named' && baseOf(model.name) ? slots.filter((slot) => slot.declared.role === 'depth') : [];
  const tau = own.at(-1)?.name ?? null; // below a layer there may be others, and they come first
  return { name: json.name, model, slots, shader, time, toSrgb, color, channels: json.channels, wavelengths: json.wavelengths_nm ?? [], json, tau, dropped };
}

/** Tables are followed; of other trends only Python knows the formulas, which is said. */
function timeOf(trends: unknown, slots: Slot[], name: string, notes: string[]): TimeView | null {
  if (!isRecord(trends) || !Object.keys(trends).length) return null;
  const tables = Object.entries(trends).flatMap(([slot, trend]) => {
    const table = isRecord(trend) && trend['kind'] === 'tabulated' ? trend : null;
    const hours = table && Array.isArray(table['hours']) ? table['hours'].map(Number) : [];
    const values = table && Array.isArray(table['values']) ? table['values'].map((row) => numbersOf(row, slot)) : [];
    const size = slots.find((each) => each.name === slot)?.value.length;
    const fine = hours.length > 1 && hours.length === values.length && hours.every((t, k) => Number.isFinite(t) && (k === 0 || t > hours[k - 1]!)) && values.every((row) => row.length === size || row.length === 1);
    return fine && size ? [{ slot, hours, values: values.map((row) => widened(row, size)) }] : [];
  });
  if (tables.length < Object.keys(trends).length)
    notes.push(`${name} follows time; a dropped material shows its first moment, for the formulas of its trends are in Python: motes view MATERIAL writes a page that plays it.`);
  if (tables.length < Object.keys(trends).length || !tables.length) return null;
  const interval: [number, number] = [Math.min(...tables.map((t) => t.hours[0]!)), Math.max(...tables.map((t) => t.hours.at(-1)!))];
  const hours = [...new Set(tables.flatMap((t) => t.hours))].sort((a, b) => a - b);
  const rows = (t: (typeof tables)[number]): number[][] => hours.map((hour) => interpolate(t.hours, t.values, hour));
  return { hours, interval, trends: Object.fromEntries(tables.map((t) => [t.slot, { kind: 'tabulated', values: rows(t), stderr: null, scans: null }])) };
}

/** Straight lines between rows, held beyond the ends. */
export function interpolate(hours: readonly number[], rows: readonly number[][], hour: number): number[] {
  if (hour <= hours[0]!) return rows[0]!;
  if (hour >= hours.at(-1)!) return rows.at(-1)!;
  let low = 0;
  let high = hours.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (hours[middle]! <= hour) low = middle;
    else high = middle;
  }
  const share = (hour - hours[low]!) / (hours[high]! - hours[low]!);
  return rows[low]!.map((value, k) => value + share * (rows[high]![k]! - value));
}

/** Of what was set by hand what the material has a place for: its parameters, as many values as they have, in range.  A link may hold anything. */
export function held(material: Material, values: Values): Values {
  const fits = (slot: Slot): boolean => Object.hasOwn(values, slot.name) && values[slot.name]!.length === slot.value.length && values[slot.name]!.every((value) => inside(slot, value));
  return Object.fromEntries(material.slots.filter(fits).map((slot) => [slot.name, values[slot.name]!]));
}

/** The values at a time, with those set by hand in their place. */
export function valuesAt(material: Material, hours: number | null, held: Values): Values {
  const values: Values = {};
  for (const slot of material.slots) {
    const trend = material.time?.trends[slot.name];
    const own = trend && hours !== null ? widened(interpolate(material.time!.hours, trend.values, hours), slot.value.length) : slot.value;
    values[slot.name] = held[slot.name] ?? own;
  }
  return values;
}

/** The material's JSON with other values: what is copied and downloaded.  Trends of what was set by hand are left out. */
export function toJson(material: Material, values: Values, held: Values, hours: number | null): MaterialJson {
  const parameters = Object.fromEntries(
    material.slots.map((slot) => {
      const value = values[slot.name]!;
      const single = value.length === 1 && !Array.isArray(material.json.parameters[slot.name]?.value);
      return [slot.name, { value: single ? value[0] : value, unit: slot.declared.unit, meaning: slot.declared.meaning }];
    }),
  );
  const trends = Object.fromEntries(Object.entries(material.json.trends ?? {}).filter(([name]) => !(name in held)));
  const changed = Object.keys(held);
  const about = { ...material.json.about, ...(changed.length ? { viewer: `set by hand: ${changed.join(', ')}` } : {}), ...(Object.keys(trends).length && hours !== null ? { viewer_hours: hours } : {}) };
  return { ...material.json, parameters, trends, about };
}

function inside(slot: Slot, value: number): boolean {
  const { low, high, open } = slot.declared;
  const top = high ?? Infinity;
  return Number.isFinite(value) && (open ? value > low && value < top : value >= low && value <= top);
}

/** A sentence for a value out of range; nothing is returned for a good one. */
export function check(slot: Slot, value: number): void {
  if (inside(slot, value)) return;
  const { low, high, open, unit, meaning, advice } = slot.declared;
  const range = `${open ? '(' : '['}${low}, ${high === null ? 'inf)' : `${Number(high.toFixed(4))}${open ? ')' : ']'}`}${unit ? ` ${unit}` : ''}`;
  throw new Problem(`${slot.name} = ${value} is outside ${range} (${meaning})`, advice || (unit === 'rad' ? 'Angles are in radians' : `Choose a value in ${range}`));
}

function numbersOf(value: unknown, name: string): number[] {
  const list = (Array.isArray(value) ? value.flat(4) : [value]) as unknown[];
  if (!list.length || !list.every((each): each is number => typeof each === 'number' && Number.isFinite(each))) throw new Problem(`${name} = ${quoted(value)} is not a number or a list of numbers`, 'Correct the material');
  return list;
}

const widened = (value: number[], size: number): number[] => (value.length === 1 && size > 1 ? Array<number>(size).fill(value[0]!) : value);

export const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null && !Array.isArray(value);
