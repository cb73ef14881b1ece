// Measured points: those of the page, or a CSV that was dropped, with the columns that motes.measurements.table reads.

import { radians } from './dom';
import type { MeasurementView } from './generated';
import { Problem } from './problem';
import { bytes } from './shapes';
import { RANGES } from './state';

export interface Measurement {
  name: string;
  channels: string[];
  hours: number[];
  unit: string;
  count: number;
  wi: Float32Array;
  wo: Float32Array;
  /** (T, N, C), NaN where there is none. */
  values: Float32Array;
  thetaI: Float32Array;
  thetaR: Float32Array;
  thetaH: Float32Array;
  dphi: Float32Array;
  note: string;
}

export const MOST_POINTS = 6000;
const LARGEST = 200 * 2 ** 20;
const ANGLES: Record<string, string> = { theta_i: 'theta_i', phi_i: 'phi_i', theta_r: 'theta_r', phi_r: 'phi_r', theta_o: 'theta_r', phi_o: 'phi_r' };
const TIMES: Record<string, number> = { time: 1, time_h: 1, time_s: 1 / 3600, time_min: 1 / 60, time_d: 24 };

export function fromView(view: MeasurementView): Measurement {
  const [wi, wo, values] = [view.wi, view.wo, view.values].map((text) => new Float32Array(bytes(text))) as [Float32Array, Float32Array, Float32Array];
  return completed(view.name, view.channels, view.hours, view.time_unit, wi, wo, values, view.note);
}

/** A table with a header: theta_i, phi_i, theta_r, phi_r, a time, and a column of f_r [1/sr] for each channel. */
export function fromCsv(name: string, text: string): Measurement {
  if (text.length > LARGEST) throw new Problem(`${name} has ${Math.round(text.length / 2 ** 20)} MB, more than ${LARGEST / 2 ** 20}`, 'motes view DATA thins any measurement');
  const rows = text.replace(/^\ufeff/, '').split(/\r?\n/);
  let header: string[] | null = null;
  let separator = ',';
  const columns: Record<string, number> = {};
  const scales: Record<string, number> = {};
  let channels: { at: number; name: string }[] = [];
  let time: { at: number; factor: number } | null = null;
  const samples: { time: number; numbers: number[] }[] = [];
  let dropped = 0;
  rows.forEach((raw, index) => {
    const line = raw.split('#')[0]!.trimEnd();
    if (!line.trim()) return;
    if (!header) {
      separator = [',', ';', '\t'].reduce((best, each) => (line.split(each).length > line.split(best).length ? each : best));
      header = line.split(separator).map((cell) => cell.trim().replace(/^"|"$/g, ''));
      header.forEach((cell, at) => {
        const lower = cell.toLowerCase();
        const angle = ANGLES[lower.replace(/_deg$/, '')];
        if (angle) {
          columns[angle] = at;
          scales[angle] = lower.endsWith('_deg') ? radians(1) : 1;
        } else if (lower in TIMES) time = { at, factor: TIMES[lower]! };
        else if (lower !== 'weight') channels.push({ at, name: cell });
      });
      const missing = ['theta_i', 'theta_r', 'phi_r'].filter((each) => !(each in columns));
      if (missing.length) throw new Problem(`${name} has no column ${missing.join(', ')}; its first line is "${line.slice(0, 80)}"`, 'Columns: theta_i, phi_i, theta_r, phi_r and one a channel; _deg for degrees');
      if (!channels.length) throw new Problem(`${name} has no column of values`, 'Add one column of f_r in 1/sr for each channel');
      return;
    }
    const cells = line.split(separator).map((cell) => cell.trim().replace(/^"|"$/g, ''));
    if (cells.length !== header.length) throw new Problem(`${name}, line ${index + 1} has ${cells.length} cells; the header has ${header.length}`, 'Rows match the header');
    const number = (at: number): number => (cells[at] === '' ? NaN : Number(cells[at]));
    const angle = (key: string): number => (key in columns ? number(columns[key]!) * scales[key]! : 0);
    const angles = ['theta_i', 'phi_i', 'theta_r', 'phi_r'].map(angle);
    const values = channels.map(({ at }) => number(at));
    if (cells.some((cell) => cell !== '' && Number.isNaN(Number(cell)))) throw new Problem(`${name}, line ${index + 1}: "${cells.find((cell) => cell !== '' && Number.isNaN(Number(cell)))!.slice(0, 40)}" is not a number`, 'Leave a cell empty where nothing was measured');
    if (!angles.every(Number.isFinite) || Math.abs(angles[0]!) >= Math.PI / 2 || Math.abs(angles[2]!) >= Math.PI / 2) {
      dropped += 1;
      return;
    }
    samples.push({ time: time ? number(time.at) * time.factor : 0, numbers: [...angles, ...values.map((value) => (value > 0 || value === 0 ? value : NaN))] });
  });
  if (!header || !samples.length) throw new Problem(`${name} has no usable row`, 'It needs a header and a row a sample, with both directions above the horizon');
  if (samples.some((sample) => !Number.isFinite(sample.time))) throw new Problem(`${name} has rows without a time`, 'Fill the column of the time');
  const hours = [...new Set(samples.map((sample) => sample.time))].sort((a, b) => a - b);
  // Of many scans each row keeps its place; directions differ from scan to scan in a table.
  const step = Math.max(samples.length / MOST_POINTS, 1);
  const kept = Array.from({ length: Math.min(samples.length, MOST_POINTS) }, (_, k) => samples[Math.floor(k * step)]!);
  const [count, width] = [kept.length, channels.length];
  const wi = new Float32Array(3 * count);
  const wo = new Float32Array(3 * count);
  const values = new Float32Array(hours.length * count * width).fill(NaN);
  kept.forEach(({ time: hour, numbers }, k) => {
    wi.set(spherical(numbers[0]!, numbers[1]!), 3 * k);
    wo.set(spherical(numbers[2]!, numbers[3]!), 3 * k);
    values.set(numbers.slice(4), (hours.indexOf(hour) * count + k) * width);
  });
  const notes = [
    kept.length < samples.length ? `${name} has ${samples.length.toLocaleString('en')} samples; ${kept.length.toLocaleString('en')} of them, evenly spread, are shown.` : '',
    dropped ? `${dropped.toLocaleString('en')} rows with a direction at or below the horizon were left out.` : '',
  ];
  return completed(name, channels.map((each) => each.name), hours, 'h', wi, wo, values, notes.filter(Boolean).join(' '));
}

const spherical = (theta: number, phi: number): [number, number, number] => [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];

function completed(name: string, channels: string[], hours: number[], unit: string, wi: Float32Array, wo: Float32Array, values: Float32Array, note: string): Measurement {
  const count = wi.length / 3;
  const [thetaI, thetaR, thetaH, dphi] = [0, 0, 0, 0].map(() => new Float32Array(count)) as [Float32Array, Float32Array, Float32Array, Float32Array];
  for (let k = 0; k < count; k += 1) {
    const [ix, iy, iz, ox, oy, oz] = [wi[3 * k]!, wi[3 * k + 1]!, wi[3 * k + 2]!, wo[3 * k]!, wo[3 * k + 1]!, wo[3 * k + 2]!];
    thetaI[k] = Math.atan2(Math.hypot(ix, iy), iz);
    thetaR[k] = Math.atan2(Math.hypot(ox, oy), oz);
    thetaH[k] = Math.atan2(Math.hypot(ix + ox, iy + oy), iz + oz);
    dphi[k] = Math.atan2(ix * oy - iy * ox, ix * ox + iy * oy);
  }
  return { name, channels, hours, unit, count, wi, wo, values, thetaI, thetaR, thetaH, dphi, note };
}

/** The scan whose time is nearest. */
export function scanAt(data: Measurement, hours: number): number {
  return data.hours.reduce((best, value, k) => (Math.abs(value - hours) < Math.abs(data.hours[best]! - hours) ? k : best), 0);
}

/** An angle of incidence [degrees] at which many samples lie in the plane of incidence. */
export function commonIncidence(data: Measurement): number {
  const counts = new Float64Array(90);
  for (let k = 0; k < data.count; k += 1) {
    const aside = Math.abs(Math.sin(data.dphi[k]!)) * Math.min(Math.sin(data.thetaI[k]!), Math.sin(data.thetaR[k]!));
    if (aside > 0.05) continue;
    const angle = Math.round((data.thetaI[k]! * 180) / Math.PI);
    if (angle <= RANGES.incidence.high) counts[angle]! += 1;
  }
  // Among the angles that have many, the one nearest to 45.
  const enough = 0.4 * Math.max(...counts);
  let best = 45;
  let off = Infinity;
  counts.forEach((count, angle) => {
    if (count >= enough && enough > 0 && Math.abs(angle - 45) < off) [best, off] = [angle, Math.abs(angle - 45)];
  });
  return best;
}
