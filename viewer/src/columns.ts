// What the name of a column says, by the same tables and rules as motes.measurements._column_names; docs/data.md is the page for people.

import tables from '../../src/motes/measurements/columns.json';
import { Problem } from './problem';

export type Role = 'angle' | 'vector' | 'time' | 'scan' | 'weight' | 'wavelength' | 'channel' | 'value' | 'uncertainty' | 'index' | 'remark';

export interface Column {
  role: Role;
  /** Which angle or component; of a value brdf, brdf_cos_r, brdf_cos_i or reflectance_factor. */
  name: string;
  /** A key of FACTORS, or '' where the name says none. */
  unit: string;
  channel: string;
  wavelength: number | null;
  unitOfWavelength: string;
  relative: boolean;
  expanded: boolean;
}

type Groups = Record<string, string[]>;

export const FACTORS: Record<string, number> = tables.factors;
export const MISSING = new Set<string>(tables.missing);
const DIMENSION: Partial<Record<Role, string>> = { angle: 'angle', time: 'time', wavelength: 'length', value: 'brdf', uncertainty: 'brdf' };
const GREEK: Record<string, string> = { θ: 'theta', ϑ: 'theta', φ: 'phi', ϕ: 'phi', λ: 'lambda', σ: 'sigma', δ: 'delta_' };
const WAVELENGTH = /^(?:x|wl|w|wavelength|lambda|l)?[ _]*((?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d{1,2})?)[ _]*([a-zµμå]*)$/;
const NAMED = /^(?:(.*?)\s*\[\s*(.+?)\s*\]|(.*?):\s*(.+?))$/;
const WORDS = tables.uncertainty;
const CHANNELS: Groups = tables.channels;

/** A name in lower case, with Greek letters and plus-minus signs spelt out. */
export function normal(name: string): string {
  const text = name.normalize('NFKC').replaceAll('\u2212', '-').replaceAll('\u00b5', '\u03bc').trim().toLowerCase();
  const spelt = text.replace(/[θϑφϕλσδ]/g, (letter) => GREEK[letter]!);
  return WORDS.signs.reduce((found, sign) => found.replaceAll(sign, ' uncertainty '), spelt).trim();
}

/** The letters and digits of a name. */
export const key = (name: string): string => name.replace(/[^a-z0-9]/g, '');

const KEYS = new Map<string, { role: Role; name: string; unit: string }>();
const VALUE_WORDS = new Map<string, string>();
for (const [groups, role] of [
  [tables.angles, 'angle'],
  [tables.vectors, 'vector'],
  [tables.values, 'value'],
  [CHANNELS, 'value'],
] as [Groups, Role][]) {
  for (const [name, aliases] of Object.entries(groups)) for (const alias of aliases) KEYS.set(key(alias), { role, name, unit: '' });
}
for (const [unit, aliases] of Object.entries(tables.times as Groups)) for (const alias of aliases) KEYS.set(key(alias), { role: 'time', name: '', unit });
for (const [role, aliases] of Object.entries(tables.others as Groups)) for (const alias of aliases) KEYS.set(key(alias), { role: role as Role, name: '', unit: '' });
for (const alias of tables.index) KEYS.set(key(alias), { role: 'index', name: '', unit: '' });
for (const alias of tables.remarks) KEYS.set(key(alias), { role: 'remark', name: '', unit: '' });
for (const [name, aliases] of Object.entries(tables.values as Groups)) for (const alias of aliases) VALUE_WORDS.set(key(alias), name);

const UNITS = new Map<string, [string, string][]>();
for (const [dimension, units] of Object.entries(tables.units as Record<string, Groups>)) {
  for (const [unit, texts] of Object.entries(units)) for (const text of texts) UNITS.set(text, [...(UNITS.get(text) ?? []), [dimension, unit]]);
}

/** The unit that a text means for a dimension; a ratio is a unit of values. */
export function unitOf(text: string, dimension: string): string | null {
  const found = UNITS.get(normal(text))?.find(([each]) => each === dimension || (dimension === 'brdf' && each === 'ratio'));
  return found ? found[1] : null;
}

export const isUnit = (text: string): boolean => UNITS.has(normal(text));
export const dimensionOf = (role: Role): string | null => DIMENSION[role] ?? null;

const made = (role: Role, more: Partial<Column> = {}): Column => ({ role, name: '', unit: '', channel: '', wavelength: null, unitOfWavelength: '', relative: false, expanded: false, ...more });

/** What a name says, or null for one that is not known; a known name with the unit of something else is a Problem. */
export function column(name: string): Column | null {
  let wrong: Column | null = null;
  for (const [stem, unit] of splits(normal(name))) {
    const found = ofStem(stem, name);
    if (!found || found.role === 'index' || found.role === 'remark') {
      if (unit === '' && found) return found;
      continue;
    }
    if (unit === '') return found.unit === 'with unit' ? null : found;
    const dimension = dimensionOf(found.role);
    const known = dimension ? unitOf(unit, dimension) : null;
    if (known !== null && (found.unit === '' || found.unit === 'with unit')) {
      return known === '%' && found.role === 'uncertainty' ? { ...found, unit: '%', relative: true } : { ...found, unit: known };
    }
    if (known === null && unit.length > 1) wrong ??= found;
  }
  if (wrong) throw new Problem(`The column '${name}' is ${wrong.role} ${wrong.name} by its name, and its unit is that of something else`, 'Correct the name');
  return null;
}

function splits(text: string): [string, string][] {
  const found: [string, string][] = [];
  for (const pattern of [/^(.+?)\s*\(([^()]*(?:\(-?1\))?)\)$/, /^(.+?)\s*\[([^[\]]*)\]$/, /^(.+?)\s*\{([^{}]*)\}$/]) {
    const match = pattern.exec(text);
    if (match && UNITS.has(match[2]!.trim())) found.push([match[1]!, match[2]!.trim()]);
  }
  for (const pattern of [/^(.+?)\s+in\s+(.+)$/, /^(.+?)\s*\/\s*(.+)$/, /^(.+)[\s_.,]+(\S+)$/, /^(.+?)(%|°)$/]) {
    const match = pattern.exec(text);
    const unit = match?.[2]!.replace(/^[ .]+|[ .]+$/g, '');
    if (match && UNITS.has(unit!) && !['1', '-'].includes(match[2]!)) found.push([match[1]!, unit!]); // R.1 is the second column called R
  }
  return [...found, [text, '']];
}

function ofStem(stem: string, original: string): Column | null {
  const known = KEYS.get(key(stem));
  if (known) {
    return known.role === 'value' && !(known.name in tables.values) ? made('value', { name: 'brdf', channel: known.name }) : made(known.role, { name: known.name, unit: known.unit });
  }
  return uncertainty(stem, original) ?? value(stem, original);
}

function value(stem: string, original: string): Column | null {
  const channel = /^(?:channel|band|ch)[ _]*(\d+)$/.exec(stem);
  if (channel) return made('value', { name: 'brdf', channel: `channel ${channel[1]}` });
  const spectral = atWavelength(stem);
  if (spectral) return spectral;
  const named = NAMED.exec(stem);
  const quantity = named ? VALUE_WORDS.get(key(named[1] ?? named[3] ?? '')) : undefined;
  if (named && quantity) {
    const inside = originalCase((named[2] ?? named[4])!, original);
    const part = value(normal(inside), inside);
    return part?.wavelength != null ? { ...part, name: quantity } : made('value', { name: quantity, channel: inside });
  }
  const tokens = stem.split(/[^a-z0-9.]+/).filter(Boolean);
  for (let n = 1; n < tokens.length; n += 1) {
    for (const [words, rest] of [
      [tokens.slice(0, n), tokens.slice(n)],
      [tokens.slice(-n), tokens.slice(0, -n)],
    ] as [string[], string[]][]) {
      const found = VALUE_WORDS.get(words.join(''));
      const part = found ? ofChannel(rest.join(' ')) : null;
      if (found && part) return { ...part, name: found };
    }
  }
  return null;
}

function atWavelength(text: string): Column | null {
  const match = WAVELENGTH.exec(text);
  const unit = match ? (match[2] ? unitOf(match[2], 'length') : '') : null;
  return match && unit !== null ? made('value', { name: 'brdf', channel: text, wavelength: Number(match[1]), unitOfWavelength: unit }) : null;
}

function ofChannel(text: string): Column | null {
  const known = KEYS.get(key(text));
  if (known) return known.name in CHANNELS ? made('value', { name: 'brdf', channel: known.name }) : null;
  return atWavelength(text);
}

function originalCase(text: string, original: string): string {
  const at = normal(original).indexOf(text);
  return at >= 0 && normal(original).length === original.trim().length ? original.trim().slice(at, at + text.length) : text;
}

function uncertainty(stem: string, original: string): Column | null {
  const named = NAMED.exec(stem);
  if (named?.[2] && [...WORDS.words, ...WORDS.first].includes(key(named[1]!))) {
    const of = value(`brdf[${named[2]}]`, `brdf[${originalCase(named[2], original)}]`);
    return of ? { ...of, role: 'uncertainty', name: '' } : null;
  }
  const tokens = stem.replace(/\b(standard|std)[ _.]*(deviation|dev)\b/g, 'stddev').split(/[^a-z0-9.]+/).filter(Boolean);
  const twice = /k\s*=\s*2\b/.test(stem);
  const relative = tokens.some((t) => WORDS.relative.includes(t));
  const expanded = twice || tokens.some((t) => WORDS.expanded.includes(t));
  let rest = tokens.filter((t) => !WORDS.relative.includes(t) && !WORDS.expanded.includes(t) && !(twice && (t === 'k' || t === '2')));
  const marked = new Set(rest.map((t, k) => (WORDS.words.includes(t) || (k === 0 && WORDS.first.includes(t)) ? k : -1)).filter((k) => k >= 0));
  if (!marked.size && !(expanded && !rest.length)) return null;
  if (rest[0] === 'u' && marked.has(0) && original.trim().startsWith('U') && !expanded) return null;
  rest = rest.filter((t, k) => !marked.has(k) && !WORDS.passed_over.includes(t));
  if (!rest.length || VALUE_WORDS.has(rest.join(''))) return made('uncertainty', { relative, expanded });
  const of = ofChannel(rest.join(' ')) ?? value(rest.join(' '), rest.join(' '));
  return of ? made('uncertainty', { relative, expanded, channel: of.channel, wavelength: of.wavelength, unitOfWavelength: of.unitOfWavelength }) : null;
}

/** The three known names that share most pairs of letters with a name. */
export function nearest(name: string): string[] {
  const pairs = (text: string): Set<string> => new Set(Array.from({ length: Math.max(text.length - 1, 1) }, (_, k) => text.slice(k, k + 2)));
  const wanted = pairs(key(normal(name)));
  const likeness = (text: string): number => {
    const own = pairs(key(text));
    return (2 * [...own].filter((pair) => wanted.has(pair)).length) / (own.size + wanted.size);
  };
  const names = [tables.angles, tables.vectors, tables.times, tables.others, tables.values, tables.channels].flatMap((group) => Object.values(group as Groups).flat());
  return [...new Set(names.filter((each) => each.length > 1))].sort((a, b) => likeness(b) - likeness(a)).slice(0, 3);
}
