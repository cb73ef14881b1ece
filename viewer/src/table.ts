// A table of measurements, by the rules of motes.measurements.table (docs/data.md): what each column is, and the samples.

import { cellsOf, Numbers, type Cells } from './cells';
import { column, dimensionOf, FACTORS, key, nearest, normal, unitOf, type Column } from './columns';
import { Problem } from './problem';

export type Vector = [number, number, number];

export interface Sample {
  hours: number;
  wi: Vector;
  wo: Vector;
  /** f_r [1/sr] of each channel, NaN where there is none. */
  values: number[];
  /** One standard deviation of each value [1/sr]; null where the table has none. */
  uncertainties: number[] | null;
}

export interface Table {
  channels: string[];
  wavelengths: number[] | null;
  unit: 'h' | 'scan';
  samples: Sample[];
  notes: string[];
}

/** The cosine to the normal above which a direction is above the surface: motes.directions.HORIZON. */
export const HORIZON = 1e-6;
const LARGEST_ANGLE = 2 * Math.PI + 1e-6;
const SHORTEST = 100;
const PHASE = 'phase';
const ROUNDED = (0.06 * Math.PI) / 180; // angles rounded to a tenth of a degree
const SPHERICAL = ['theta_i', 'phi_i', 'theta_r', 'phi_r'] as const;
const HALF = ['theta_h', 'theta_d', 'phi_d', 'phi_h'] as const;
const VECTORS = ['wi_x', 'wi_y', 'wi_z', 'wo_x', 'wo_y', 'wo_z'] as const;
const RENAME = 'Rename the column, or give motes info the option --read column:NAME=ROLE';

interface Roles {
  columns: (Column | null)[];
  angles: Map<string, number>;
  values: number[];
  uncertainties: number[];
  /** The place in values that each uncertainty belongs to; -1 for all. */
  of: number[];
  single: Map<string, number>;
  /** Titles of angles that say degrees, in their names or cells, and of those that say nothing. */
  degrees: string[];
  bare: string[];
}

/** The samples of a table. */
export function readTable(name: string, text: string): Table {
  const table = cellsOf(name, text);
  const roles = assigned(name, table);
  if (!table.rows.length) throw new Problem(`${name} has a header and no row below it`, 'It needs a row a sample');
  const everything = [...roles.angles.values(), ...roles.values, ...roles.uncertainties];
  for (const role of ['weight', 'wavelength']) if (roles.single.has(role)) everything.push(roles.single.get(role)!);
  const numbers = new Numbers(name, table, everything);
  if (numbers.decimalComma) table.notes.push('Its numbers have decimal commas');
  const pairs = directionsOf(name, table, roles, numbers);
  const hours = hoursOf(name, table, roles);
  const { values, factors } = valuesOf(name, table, roles, numbers, pairs);
  const uncertainties = uncertaintiesOf(name, table, roles, numbers, values, factors);
  const samples = pairs.map(([wi, wo], k) => ({ hours: hours[k]!, wi, wo, values: values[k]!, uncertainties: uncertainties?.[k] ?? null }));
  const unit = roles.single.has('scan') ? 'scan' : 'h';
  for (const role of ['wavelength', 'channel']) if (roles.single.has(role)) return { ...long(name, table, roles, numbers, samples, role), unit, notes: table.notes };
  return { ...channelsOf(name, roles.values.map((at) => roles.columns[at]!)), unit, samples, notes: table.notes };
}

// ---------------------------------------------------------------- what the columns are

const called = (header: string[], at: number): string => (header[at] ? `'${header[at].slice(0, 60)}'` : String(at + 1));

function assigned(name: string, table: Cells): Roles {
  const { header, notes } = table;
  const roles: Roles = { columns: [], angles: new Map(), values: [], uncertainties: [], of: [], single: new Map(), degrees: [], bare: [] };
  header.forEach((title, at) => {
    const found = known(name, title);
    if (!found && isIndex(table, at)) {
      notes.push(`The column ${called(header, at)} numbers or names the rows and is left out`);
      roles.columns.push(null);
      return;
    }
    if (!found || (found.role === 'index' && !isIndex(table, at))) throw unknown(name, header, at);
    if (found.role === 'index' || found.role === 'remark') {
      notes.push(`The column ${called(header, at)} ${found.role === 'index' ? 'numbers the rows' : 'holds remarks'} and is left out`);
      roles.columns.push(null);
      return;
    }
    const withUnit = united(name, table, found, at);
    roles.columns.push(withUnit);
    if (withUnit.role === 'angle' || withUnit.role === 'vector') once(name, header, roles.angles, withUnit.name, at);
    else if (withUnit.role === 'value') roles.values.push(at);
    else if (withUnit.role === 'uncertainty') roles.uncertainties.push(at);
    else once(name, header, roles.single, withUnit.role, at);
  });
  settleThetaS(name, table, roles);
  checkValues(name, table, roles);
  return roles;
}

function known(name: string, title: string): Column | null {
  if (title === '') return null;
  try {
    return column(title);
  } catch (error) {
    throw error instanceof Problem ? new Problem(`${name}: t${error.message.slice(1)}`, RENAME) : error;
  }
}

function isIndex(table: Cells, at: number): boolean {
  const title = normal(table.header[at]!);
  const nameless = title === '' || /^unnamed:? ?\d+(\.\d+)*$/.test(title);
  if (!nameless && column(title)?.role !== 'index') return false;
  const cells = table.rows.map((row) => row[at]!);
  if (cells.every((cell) => cell === '')) return true;
  const values = cells.map((cell) => (cell === '' ? NaN : Number(cell)));
  if (values.some(Number.isNaN)) return nameless && new Set(cells).size === cells.length && values.every(Number.isNaN);
  return values.length < 2 || values.every((value, k) => k === 0 || value - values[k - 1]! === 1) || (!nameless && values.every(Number.isInteger));
}

function unknown(name: string, header: string[], at: number): Problem {
  if (!header[at]) return new Problem(`${name}: column ${at + 1} has no name and does not number the rows`, RENAME);
  return new Problem(`${name}: the column ${called(header, at)} is not known; the nearest names are ${nearest(header[at]).join(', ')}`, RENAME);
}

function united(name: string, table: Cells, found: Column, at: number): Column {
  let text = table.units[at] ?? '';
  if (found.role === 'value' && (found.unit === '%' || found.unit === '1')) text ||= found.unit;
  const dimension = dimensionOf(found.role);
  if (!text || !dimension) return found;
  const unit = unitOf(text, dimension);
  const implied = found.unit === 'with unit' ? '' : found.unit;
  const title = table.header[at]!;
  if (unit === null || (implied && implied !== unit)) {
    throw new Problem(`${name}: the column '${title}' has the unit '${text}'${implied ? `, and its name says ${implied}` : `, which is no unit of ${found.name || found.role}`}`, 'Correct one of them');
  }
  if (found.role === 'value' && found.name !== 'reflectance_factor' && (unit === '%' || unit === '1')) {
    throw new Problem(`${name}: the column '${title}' has the unit '${text}', and a BRDF is in 1/sr`, 'Where it is pi times the BRDF, call it reflectance_factor');
  }
  return { ...found, unit, relative: found.relative || (found.role === 'uncertainty' && unit === '%') };
}

function once(name: string, header: string[], places: Map<string, number>, role: string, at: number): void {
  if (places.has(role)) throw new Problem(`${name}: the columns ${called(header, places.get(role)!)} and ${called(header, at)} are both ${role}`, 'Leave one out');
  places.set(role, at);
}

/** theta_s is the scatter angle beside theta_i, and the sun's beside theta_v. */
function settleThetaS(name: string, table: Cells, roles: Roles): void {
  const at = roles.angles.get('theta_s');
  if (at === undefined) return;
  roles.angles.delete('theta_s');
  if (roles.angles.has('theta_i') === roles.angles.has('theta_r')) throw new Problem(`${name}: the column ${called(table.header, at)} may be the angle of the scattered light or of the sun`, RENAME);
  const role = roles.angles.has('theta_i') ? 'theta_r' : 'theta_i';
  roles.angles.set(role, at);
  table.notes.push(`The column ${called(table.header, at)} is taken for ${role}, the other one being there`);
  const azimuth = roles.angles.get('phi_r');
  if (role === 'theta_i' && azimuth !== undefined && key(normal(table.header[azimuth]!)).startsWith('phis')) {
    roles.angles.delete('phi_r');
    roles.angles.set('phi_i', azimuth);
  }
}

function checkValues(name: string, table: Cells, roles: Roles): void {
  const { header } = table;
  const kinds = ['wavelength', 'channel'].filter((role) => roles.single.has(role));
  if (kinds.length === 2) throw new Problem(`${name}: two columns name the channel of a row`, 'Leave one out');
  if (roles.single.has('time') && roles.single.has('scan')) roles.single.delete('scan');
  if (!roles.values.length) throw new Problem(`${name} has no column of values; its columns are ${header.slice(0, 12).join(', ')}`, 'Name a column of the BRDF [1/sr] brdf, or R, G, B, or by its wavelength (630 nm)');
  if (kinds.length && roles.values.length > 1) throw new Problem(`${name} has a row for each ${kinds[0]} and yet ${roles.values.length} columns of values`, 'Leave all but one out');
  const seen = new Map<string, number>();
  for (const at of roles.values) {
    const c = roles.columns[at]!;
    const label = c.wavelength === null ? c.channel : `${c.wavelength} ${c.unitOfWavelength}`;
    if (seen.has(label)) throw new Problem(`${name}: the columns ${called(header, seen.get(label)!)} and ${called(header, at)} hold values of the same channel`, 'Leave one out');
    seen.set(label, at);
  }
  for (const at of roles.uncertainties) {
    const place = belongs(name, table, roles, at);
    if (roles.of.includes(place) || (roles.of.length && (place === -1 || roles.of.includes(-1)))) {
      throw new Problem(`${name}: the columns ${called(header, roles.uncertainties[Math.max(roles.of.indexOf(place), 0)]!)} and ${called(header, at)} are both uncertainties of the same values`, 'Leave one out');
    }
    roles.of.push(place);
  }
}

function belongs(name: string, table: Cells, roles: Roles, at: number): number {
  const c = roles.columns[at]!;
  if (c.channel === '' && c.wavelength === null) {
    if (roles.values.length > 1 && !c.relative) throw new Problem(`${name}: the column ${called(table.header, at)} is an uncertainty [1/sr] of one of ${roles.values.length} channels, and does not say of which`, 'Call it uncertainty[R], for example');
    return roles.values.length === 1 ? 0 : -1;
  }
  const matches = roles.values
    .map((_, k) => k)
    .filter((k) => {
      const v = roles.columns[roles.values[k]!]!;
      return c.wavelength === null ? key(normal(v.channel)) === key(normal(c.channel)) : v.wavelength === c.wavelength && ['', v.unitOfWavelength].includes(c.unitOfWavelength);
    });
  if (matches.length !== 1) throw new Problem(`${name}: the column ${called(table.header, at)} is the uncertainty of ${c.channel}, and no column of values is called so`, RENAME);
  return matches[0]!;
}

// ---------------------------------------------------------------- directions and times

function directionsOf(name: string, table: Cells, roles: Roles, numbers: Numbers): [Vector, Vector][] {
  const has = (role: string): boolean => roles.angles.has(role);
  const groups = [VECTORS, HALF, [...SPHERICAL, PHASE]].filter((group) => group.some(has));
  const byPhase = has(PHASE);
  if (groups.length !== 1 || (byPhase && has('phi_r'))) throw new Problem(`${name} gives directions in several ways: ${[...roles.angles.keys()].join(', ')}`, 'Leave one way out');
  const needed = groups[0] === VECTORS ? VECTORS : groups[0] === HALF ? HALF.slice(0, 3) : byPhase ? ['theta_i', 'theta_r'] : ['theta_i', 'theta_r', 'phi_r'];
  const missing = needed.filter((role) => !has(role));
  if (missing.length) throw new Problem(`${name} has no column ${missing.join(', ')}; it has ${table.header.slice(0, 12).join(', ')}`, 'Add them');
  const column_ = (role: string): { values: number[]; unit: string } => {
    const at = roles.angles.get(role)!;
    const found = numbers.column(at);
    const bad = found.values.findIndex((value) => !Number.isFinite(value));
    if (bad >= 0) throw new Problem(`${name}, line ${table.lines[bad]}: ${table.header[at]} is missing or not finite`, 'Fill it in');
    return found;
  };
  const angle = (role: string): number[] => (has(role) ? inRadians(name, table, roles, role, column_(role)) : table.rows.map(() => 0));
  if (groups[0] === VECTORS) {
    const parts = VECTORS.map((role) => column_(role).values);
    return table.rows.map((_, k) => {
      const pair = [0, 3].map((start) => [0, 1, 2].map((axis) => parts[start + axis]![k]!) as Vector) as [Vector, Vector];
      return pair.map((w, which) => {
        const length = Math.hypot(...w);
        if (!(Math.abs(length - 1) <= 1e-3)) throw new Problem(`${name}: ${which ? 'wo' : 'wi'} in row ${k} has the length ${length.toPrecision(6)} instead of 1`, 'Directions are unit vectors');
        return w.map((x) => x / length) as Vector;
      }) as [Vector, Vector];
    });
  }
  if (groups[0] === HALF) {
    const [thetaH, thetaD, phiD, phiH] = HALF.map(angle) as [number[], number[], number[], number[]];
    return table.rows.map((_, k) => fromHalf(thetaH[k]!, thetaD[k]!, phiD[k]!, phiH[k]!));
  }
  const [thetaI, phiI, thetaR, phiR] = SPHERICAL.map(angle) as [number[], number[], number[], number[]];
  if (byPhase) {
    const phase = angle(PHASE);
    phase.forEach((own, k) => {
      const [i, r] = [thetaI[k]!, thetaR[k]!];
      if (own < Math.abs(i - r) - ROUNDED || own > i + r + ROUNDED || i < 0 || r < 0) {
        throw new Problem(`${name}, line ${table.lines[k]}: a phase angle of ${((own * 180) / Math.PI).toPrecision(6)} degrees is outside what the two polar angles allow`, 'Check the row; polar angles beside a phase angle are not signed');
      }
      const sines = Math.sin(i) * Math.sin(r);
      phiR[k] = phiI[k]! + (sines > 1e-12 ? Math.acos(Math.min(1, Math.max(-1, (Math.cos(own) - Math.cos(i) * Math.cos(r)) / sines))) : 0);
    });
    table.notes.push('The azimuth between light and viewer follows from the phase angle');
  }
  if (!has('phi_i')) table.notes.push('phi_i is missing and taken as 0');
  if ([...thetaI, ...thetaR].some((theta) => theta < 0)) table.notes.push('Negative polar angles are taken for the opposite azimuth');
  return table.rows.map((_, k) => [spherical(thetaI[k]!, phiI[k]!), spherical(thetaR[k]!, phiR[k]!)]);
}

function inRadians(name: string, table: Cells, roles: Roles, role: string, found: { values: number[]; unit: string }): number[] {
  const at = roles.angles.get(role)!;
  const title = table.header[at]!;
  const own = roles.columns[at]!.unit;
  const inCells = found.unit ? unitOf(found.unit, 'angle') : '';
  if (inCells === null || (inCells && own && inCells !== own)) throw new Problem(`${name}: the cells of '${title}' are in '${found.unit}'${own ? `, its name says ${own}` : ''}`, 'Correct one of them');
  const unit = own || inCells;
  if (unit === 'deg') roles.degrees.push(title);
  else if (!unit) roles.bare.push(title);
  if (roles.bare.length && (roles.degrees.length || roles.columns.some((c) => c?.role === 'angle' && c.unit === 'deg'))) throw new Problem(`${name}: '${roles.bare[0]}' names no unit, and other angles are in degrees`, `Call it ${roles.bare[0]}_deg or ${roles.bare[0]}_rad`);
  const radians = found.values.map((value) => value * FACTORS[unit || 'rad']!);
  const bad = radians.findIndex((value) => Math.abs(value) > LARGEST_ANGLE);
  if (bad >= 0) throw new Problem(`${name}, line ${table.lines[bad]}: ${title} = ${found.values[bad]} is outside +-2 pi rad (+-360 degrees)`, unit ? 'Check the row' : `Angles are in radians; call it ${title}_deg for degrees`);
  return radians;
}

export const spherical = (theta: number, phi: number): Vector => [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];

/** Half and difference angles (Rusinkiewicz 1998), as motes.directions.from_half_difference. */
function fromHalf(thetaH: number, thetaD: number, phiD: number, phiH: number): [Vector, Vector] {
  const [x, y, z] = spherical(thetaD, phiD);
  const [c, s] = [Math.cos(thetaH), Math.sin(thetaH)];
  const [tx, ty, tz] = [c * x + s * z, y, c * z - s * x];
  const [cp, sp] = [Math.cos(phiH), Math.sin(phiH)];
  const wi: Vector = [cp * tx - sp * ty, sp * tx + cp * ty, tz];
  const wh = spherical(thetaH, phiH);
  const dot = 2 * (wi[0] * wh[0] + wi[1] * wh[1] + wi[2] * wh[2]);
  return [wi, [dot * wh[0] - wi[0], dot * wh[1] - wi[1], dot * wh[2] - wi[2]]];
}

function hoursOf(name: string, table: Cells, roles: Roles): number[] {
  const role = ['time', 'scan'].find((each) => roles.single.has(each));
  if (!role) return table.rows.map(() => 0);
  const at = roles.single.get(role)!;
  const cells = table.rows.map((row) => row[at]!.trim());
  if (role === 'time' && /\d[:/-]\d|\d\.\d+\.\d/.test(cells.find(Boolean) ?? '')) return stamps(name, table, at, cells);
  const { values, unit } = new Numbers(name, table, [at]).column(at);
  const bad = values.findIndex((value) => !Number.isFinite(value));
  if (bad >= 0) throw new Problem(`${name}, line ${table.lines[bad]}: ${table.header[at]} is missing or not finite`, 'Fill it in');
  if (role === 'scan') return values;
  const own = roles.columns[at]!.unit;
  const inCells = unit ? unitOf(unit, 'time') : '';
  if (inCells === null || (inCells && own && inCells !== own)) throw new Problem(`${name}: the cells of '${table.header[at]}' are in '${unit}'`, 'Correct one of them');
  return values.map((value) => value * FACTORS[own || inCells || 'h']!);
}

function stamps(name: string, table: Cells, at: number, cells: string[]): number[] {
  const durations = cells.map((cell) => /^(-?)(\d{1,6}):(\d{2})(?::(\d{2}(?:\.\d+)?))?$/.exec(cell));
  if (durations.every(Boolean)) return durations.map((m) => (m![1] ? -1 : 1) * (Number(m![2]) + Number(m![3]) / 60 + Number(m![4] ?? 0) / 3600));
  const dates = cells.map((cell, k) => {
    const m = /^(\d{4})-(\d{2})-(\d{2})(?:[T ](\d{2}):(\d{2})(?::(\d{2}(?:\.\d+)?))?)?(Z|[+-]\d{2}:\d{2})?$/.exec(cell);
    if (!m) throw new Problem(`${name}, line ${table.lines[k]}: '${cell.slice(0, 40)}' is no time`, `Write dates in ${called(table.header, at)} as 2024-05-01 10:30, durations as 1:30:00, or numbers of hours`);
    const zone = !m[7] || m[7] === 'Z' ? 0 : (m[7][0] === '-' ? -1 : 1) * (Number(m[7].slice(1, 3)) + Number(m[7].slice(4)) / 60);
    return Date.UTC(Number(m[1]), Number(m[2]) - 1, Number(m[3])) / 3.6e6 + Number(m[4] ?? 0) + Number(m[5] ?? 0) / 60 + Number(m[6] ?? 0) / 3600 - zone;
  });
  const first = Math.min(...dates);
  return dates.map((hours) => hours - first);
}

// ---------------------------------------------------------------- values

function valuesOf(name: string, table: Cells, roles: Roles, numbers: Numbers, pairs: [Vector, Vector][]): { values: number[][]; factors: number[][] } {
  const columns = roles.values.map((at) => numbers.column(at));
  columns.forEach(({ unit }, k) => {
    if (unit && unitOf(unit, 'brdf') !== '1/sr') throw new Problem(`${name}: the cells of '${table.header[roles.values[k]!]}' are in '${unit}', and a BRDF is in 1/sr`, 'Write the unit in the header');
  });
  const kinds = roles.values.map((at) => roles.columns[at]!);
  if (kinds.some((c) => c.name === 'reflectance_factor')) table.notes.push('f_r = reflectance factor / pi');
  if (kinds.some((c) => c.name === 'brdf_cos_r')) table.notes.push('f_r = cosine-corrected BRDF / cos(theta_r)');
  if (kinds.some((c) => c.name === 'brdf_cos_i')) table.notes.push('f_r = BRDF times cos(theta_i) / cos(theta_i)');
  const over = (cosine: number): number => (cosine > 0 ? 1 / cosine : NaN);
  const factors = pairs.map(([wi, wo]) =>
    kinds.map((c) => (c.name === 'reflectance_factor' ? FACTORS[c.unit || '1']! / Math.PI : c.name === 'brdf_cos_r' ? over(wo[2]) : c.name === 'brdf_cos_i' ? over(wi[2]) : 1)),
  );
  return { values: factors.map((row, k) => row.map((factor, c) => columns[c]!.values[k]! * factor)), factors };
}

function uncertaintiesOf(name: string, table: Cells, roles: Roles, numbers: Numbers, values: number[][], factors: number[][]): number[][] | null {
  if (!roles.uncertainties.length) return null;
  const result = values.map((row) => row.map(() => NaN));
  roles.uncertainties.forEach((at, k) => {
    const c = roles.columns[at]!;
    const { values: given, unit } = numbers.column(at);
    const share = c.unit === '%' || unit === '%' ? 0.01 : 1;
    const which = roles.of[k]! < 0 ? roles.values.map((_, i) => i) : [roles.of[k]!];
    const bad = given.filter((u, row) => which.some((i) => Number.isFinite(values[row]![i]!)) && !(u > 0 && Number.isFinite(u)));
    if (bad.length) throw new Problem(`${name}: the uncertainty ${table.header[at]}: ${bad.length} of ${given.length} are not above 0`, 'An uncertainty is one standard deviation');
    given.forEach((u, row) => {
      for (const i of which) {
        const own = (u * share) / (c.expanded ? 2 : 1);
        const absolute = own * Math.abs(c.relative || unit === '%' ? values[row]![i]! : factors[row]![i]!);
        if (absolute > 0) result[row]![i] = absolute;
      }
    });
  });
  return result;
}

function channelsOf(name: string, columns: Column[]): { channels: string[]; wavelengths: number[] | null } {
  if (columns.every((c) => c.wavelength !== null)) {
    const stated = new Set(columns.map((c) => c.unitOfWavelength));
    if (stated.size === 2 && stated.has('') && stated.has('nm')) stated.delete('');
    if (stated.size > 1) throw new Problem(`${name}: the wavelengths are in ${[...stated].map((unit) => unit || 'no unit').sort().join(', ')}`, 'Write all in one unit');
    const wavelengths = inNm(name, columns.map((c) => c.wavelength!), [...stated][0]!);
    return { channels: wavelengths.map(named), wavelengths };
  }
  return { channels: columns.map((c) => c.channel || (columns.length === 1 ? 'grey' : c.name)), wavelengths: null };
}

const named = (nm: number): string => `${Number(nm.toPrecision(6))} nm`;

function inNm(name: string, values: number[], unit: string): number[] {
  const low = values.reduce((a, b) => Math.min(a, b));
  if (!unit && low < SHORTEST) throw new Problem(`${name}: the wavelengths, from ${low} to ${values.reduce((a, b) => Math.max(a, b))}, name no unit and are no light in nm`, 'Write their unit, as in 0.63 um');
  return values.map((value) => Number((value * FACTORS[unit || 'nm']!).toFixed(6)));
}

/** A row for each channel, as a row for each pair of directions. */
function long(name: string, table: Cells, roles: Roles, numbers: Numbers, rows: Sample[], role: string): { channels: string[]; wavelengths: number[] | null; samples: Sample[] } {
  const at = roles.single.get(role)!;
  let channels: string[];
  let wavelengths: number[] | null = null;
  let which: number[];
  if (role === 'wavelength') {
    const { values, unit } = numbers.column(at);
    const bad = values.findIndex((value) => !(value > 0 && Number.isFinite(value)));
    if (bad >= 0) throw new Problem(`${name}, line ${table.lines[bad]}: ${table.header[at]} is missing or not above 0`, 'Fill it in');
    const nm = inNm(name, values, roles.columns[at]!.unit || (unit ? (unitOf(unit, 'length') ?? '') : ''));
    wavelengths = [...new Set(nm)].sort((a, b) => a - b);
    channels = wavelengths.map(named);
    const places = new Map(wavelengths.map((w, k) => [w, k]));
    which = nm.map((w) => places.get(w)!);
  } else {
    const labels = table.rows.map((row) => row[at]!);
    const empty = labels.indexOf('');
    if (empty >= 0) throw new Problem(`${name}, line ${table.lines[empty]}: ${table.header[at]} is missing`, 'Fill it in');
    const order = [...new Set(labels)];
    const places = new Map(order.map((label, k) => [label, k]));
    which = labels.map((label) => places.get(label)!);
    const columns = order.map((label) => known(name, /^\d+$/.test(label) && Number(label) < SHORTEST ? `channel ${label}` : label));
    if (columns.every((c) => c?.role === 'value')) ({ channels, wavelengths } = channelsOf(name, columns as Column[]));
    else channels = order;
  }
  const groups = new Map<string, { sample: Sample; rows: number[][] }>();
  rows.forEach((row, k) => {
    const id = [row.hours, ...row.wi, ...row.wo].map((x) => (Math.round(x * 1e6) + 0).toString()).join(' ');
    if (!groups.has(id)) groups.set(id, { sample: row, rows: channels.map(() => []) });
    groups.get(id)!.rows[which[k]!]!.push(k);
  });
  const samples: Sample[] = [];
  const counts = channels.map((_, c) => [...groups.values()].reduce((sum, group) => sum + group.rows[c]!.length, 0));
  const most = [...groups.values()].reduce((sum, group) => sum + Math.max(...group.rows.map((each) => each.length)), 0);
  const short = counts.findIndex((count) => count < most);
  if (short >= 0) throw new Problem(`${name}: the channel ${channels[short]} has ${counts[short]} of ${most} directions`, 'Give each channel a row for each pair of directions, with an empty cell where nothing was measured');
  for (const group of groups.values()) {
    group.rows[0]!.forEach((_, repeat) => {
      const own = group.rows.map((each) => rows[each[repeat]!]!);
      samples.push({ ...group.sample, values: own.map((row) => row.values[0]!), uncertainties: own[0]!.uncertainties && own.map((row) => row.uncertainties![0]!) });
    });
  }
  return { channels, wavelengths, samples };
}
