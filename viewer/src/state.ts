// What is set in the viewer, and how a link holds it.  Nothing is kept anywhere else.

import { clamp } from './dom';
import { isRecord, type Values } from './material';

export interface State {
  /** By material: what was set by hand. */
  values: [Values, Values];
  /** Materials that were dropped, as JSON; null where the page's own is shown. */
  dropped: [unknown, unknown];
  active: number;
  hours: number;
  shape: string;
  azimuth: number;
  elevation: number;
  distance: number;
  lampAzimuth: number;
  lampElevation: number;
  lamp: number;
  environment: string;
  sky: number;
  exposure: number;
  tone: string;
  compare: string;
  split: number;
  dust: boolean;
  lobe: boolean;
  backdrop: boolean;
  ground: boolean;
  /** Which axis of a mesh of the user's points up. */
  up: string;
  incidence: number;
  radius: string;
  scale: string;
}

interface Range {
  low: number;
  high: number;
}

/** Angles in degrees. */
export const RANGES: Record<'azimuth' | 'elevation' | 'distance' | 'lampAzimuth' | 'lampElevation' | 'lamp' | 'sky' | 'exposure' | 'split' | 'incidence' | 'hours' | 'active', Range> = {
  azimuth: { low: -180, high: 180 },
  elevation: { low: -89, high: 89 },
  distance: { low: 1.5, high: 30 },
  lampAzimuth: { low: -180, high: 180 },
  lampElevation: { low: -30, high: 90 },
  lamp: { low: 0, high: 4 },
  sky: { low: 0, high: 4 },
  exposure: { low: -6, high: 6 },
  split: { low: 0.05, high: 0.95 },
  incidence: { low: 0, high: 88 },
  hours: { low: -1e9, high: 1e9 },
  active: { low: 0, high: 1 },
};

export const WORDS: Record<'up' | 'environment' | 'tone' | 'compare' | 'radius' | 'scale', readonly string[]> = {
  up: ['y', 'z'],
  environment: ['sky', 'studio', 'dome', 'none', 'own'],
  tone: ['neutral', 'agx', 'clip'],
  compare: ['one', 'side', 'split'],
  radius: ['f', 'f cos'],
  scale: ['linear', 'cube root'],
};

export function initial(shape: string, hours: number, compare: boolean): State {
  return {
    values: [{}, {}],
    dropped: [null, null],
    active: 0,
    hours,
    shape,
    azimuth: 0,
    elevation: 12,
    distance: 5.2,
    lampAzimuth: -45,
    lampElevation: 40,
    lamp: 0.9,
    environment: 'studio',
    sky: 0.8,
    exposure: 0,
    tone: 'neutral',
    compare: compare ? 'split' : 'one',
    split: 0.5,
    dust: true,
    lobe: true,
    backdrop: false,
    ground: true,
    up: 'y',
    incidence: 45,
    radius: 'f',
    scale: 'linear',
  };
}

const LONGEST_SHAPE = 100;

/** What differs from the start, as a link's fragment. */
export function encode(state: State, start: State): string {
  const changed = Object.fromEntries(Object.entries(state).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(start[key as keyof State])));
  if (!Object.keys(changed).length) return '';
  const bytes = new TextEncoder().encode(JSON.stringify(changed));
  return `#motes=${btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '')}`;
}

/** The state of a fragment, or null when it holds none; what is out of range is put inside, what is unknown left out. */
export function decode(fragment: string, start: State): State | null {
  const match = /^#motes=([\w-]+)$/.exec(fragment);
  if (!match) return null;
  try {
    const text = atob(match[1]!.replace(/-/g, '+').replace(/_/g, '/'));
    const data: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(Uint8Array.from(text, (letter) => letter.charCodeAt(0))));
    return isRecord(data) ? merged(start, data) : null;
  } catch {
    return null;
  }
}

/** `start` with what `data` says, checked. */
export function merged(start: State, data: Record<string, unknown>): State {
  const state: State = structuredClone(start);
  const into = state as unknown as Record<string, unknown>;
  for (const [key, range] of Object.entries(RANGES)) if (typeof data[key] === 'number' && Number.isFinite(data[key])) into[key] = clamp(data[key], range.low, range.high);
  for (const [key, words] of Object.entries(WORDS)) if (typeof data[key] === 'string' && words.includes(data[key])) into[key] = data[key];
  for (const key of ['dust', 'lobe', 'backdrop', 'ground']) if (typeof data[key] === 'boolean') into[key] = data[key];
  if (typeof data['shape'] === 'string') state.shape = data['shape'].slice(0, LONGEST_SHAPE);
  state.active = Math.round(state.active);
  for (const index of [0, 1] as const) {
    const held: unknown = Array.isArray(data['values']) ? data['values'][index] : null;
    if (isRecord(held)) {
      state.values[index] = {};
      for (const [name, list] of Object.entries(held)) if (Array.isArray(list) && list.every((x) => typeof x === 'number' && Number.isFinite(x))) state.values[index][name] = list as number[];
    }
    const dropped: unknown = Array.isArray(data['dropped']) ? data['dropped'][index] : null;
    if (isRecord(dropped)) state.dropped[index] = dropped;
  }
  return state;
}

/** The state, and who wants to know of its changes. */
export class Store {
  private readonly listeners = new Set<(changed: ReadonlySet<keyof State>) => void>();

  constructor(public state: State) {}

  listen(listener: (changed: ReadonlySet<keyof State>) => void): void {
    this.listeners.add(listener);
  }

  change(patch: Partial<State>): void {
    const keys = (Object.keys(patch) as (keyof State)[]).filter((key) => JSON.stringify(patch[key]) !== JSON.stringify(this.state[key]));
    if (!keys.length) return;
    this.state = { ...this.state, ...patch };
    const changed = new Set(keys);
    for (const listener of this.listeners) listener(changed);
  }

  /** Set a parameter by hand, or let it go with null. */
  hold(material: number, name: string, value: number[] | null): void {
    const values: [Values, Values] = [{ ...this.state.values[0] }, { ...this.state.values[1] }];
    const held = values[material as 0 | 1];
    if (value) held[name] = value;
    else delete held[name];
    this.change({ values });
  }
}
