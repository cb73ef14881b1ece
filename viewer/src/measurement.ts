// Measured points: those of the page, or a CSV that was dropped, with the columns that motes.measurements.table reads.

import type { MeasurementView } from './generated';
import { Problem } from './problem';
import { bytes } from './packed';
import { RANGES } from './state';
import { HORIZON, readTable } from './table';

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

export function fromView(view: MeasurementView): Measurement {
  const [wi, wo, values] = [view.wi, view.wo, view.values].map((text) => new Float32Array(bytes(text))) as [Float32Array, Float32Array, Float32Array];
  return completed(view.name, view.channels, view.hours, view.time_unit, wi, wo, values, view.note);
}

/** A table as docs/data.md describes it; markers and what lies at or below the horizon are left out. */
export function fromCsv(name: string, text: string): Measurement {
  if (text.length > LARGEST) throw new Problem(`${name} has ${Math.round(text.length / 2 ** 20)} MB, more than ${LARGEST / 2 ** 20}`, 'motes view DATA thins any measurement');
  const table = readTable(name, text);
  const samples = table.samples.filter(({ wi, wo }) => wi[2] > HORIZON && wo[2] > HORIZON);
  const dropped = table.samples.length - samples.length;
  if (!samples.length) throw new Problem(`${name} has no usable row`, 'It needs a row a sample, with both directions above the horizon');
  const width = table.channels.length;
  // Negative noise is data; what is further below 0 than the brightest sample is above it is a marker.
  const brightest = table.channels.map((_, c) => samples.reduce((most, { values }) => (values[c]! > most && values[c]! < Infinity ? values[c]! : most), 0));
  const usable = (value: number, c: number): number => (Number.isFinite(value) && value >= -brightest[c]! ? value : NaN);
  const hours = [...new Set(samples.map((sample) => sample.hours))].sort((a, b) => a - b);
  // Of many scans each row keeps its place; directions differ from scan to scan in a table.
  const step = Math.max(samples.length / MOST_POINTS, 1);
  const kept = Array.from({ length: Math.min(samples.length, MOST_POINTS) }, (_, k) => samples[Math.floor(k * step)]!);
  const count = kept.length;
  const wi = new Float32Array(3 * count);
  const wo = new Float32Array(3 * count);
  const values = new Float32Array(hours.length * count * width).fill(NaN);
  kept.forEach((sample, k) => {
    wi.set(sample.wi, 3 * k);
    wo.set(sample.wo, 3 * k);
    values.set(sample.values.map(usable), (hours.indexOf(sample.hours) * count + k) * width);
  });
  const notes = [
    kept.length < samples.length ? `${name} has ${samples.length.toLocaleString('en')} samples; ${kept.length.toLocaleString('en')} of them, evenly spread, are shown.` : '',
    dropped ? `${dropped.toLocaleString('en')} rows with a direction at or below the horizon were left out.` : '',
    ...table.notes.map((note) => `${note}.`),
  ];
  return completed(name, table.channels, hours, table.unit, wi, wo, values, notes.filter(Boolean).join(' '));
}

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
