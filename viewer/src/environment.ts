// Light from all around: small skies made of formulas, and directions drawn from them in proportion to their light.

import { DataTexture, FloatType, RGBAFormat } from 'three';

type Color = [number, number, number];

export const WIDTH = 128;
export const HEIGHT = 64;
/** Directions of the finished picture; what is drawn while things move is the beginning of the same sequence. */
export const DIRECTIONS = 1024;

/** Directions are drawn in proportion to the light plus this part of its mean: what faces away from the bright parts sees light, too. */
const EVENLY = 0.5;

/** Radiance (linear sRGB) of each cell of a map of polar angle (rows, from y up) and azimuth (columns). */
export function radianceMap(name: string): Float32Array {
  const map = new Float32Array(3 * WIDTH * HEIGHT);
  for (let row = 0; row < HEIGHT; row += 1) {
    for (let column = 0; column < WIDTH; column += 1) {
      map.set(radiance(name, direction((column + 0.5) / WIDTH, (row + 0.5) / HEIGHT)), 3 * (row * WIDTH + column));
    }
  }
  return map;
}

/** Unit vector (y up) at shares of the azimuth and of the polar angle. */
export function direction(u: number, v: number): Color {
  const [phi, theta] = [2 * Math.PI * u, Math.PI * v];
  return [Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi)];
}

function radiance(name: string, w: Color): Color {
  if (name === 'dome') return [1, 1, 1];
  if (name === 'sky') return sky(w);
  if (name === 'studio') return studio(w);
  return [0, 0, 0];
}

const step = (edge0: number, edge1: number, x: number): number => {
  const t = Math.min(Math.max((x - edge0) / (edge1 - edge0), 0), 1);
  return t * t * (3 - 2 * t);
};
const mix = (a: Color, b: Color, t: number): Color => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
const dot = (a: Color, b: Color): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a: Color): Color => {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
};

/** A clear afternoon: blue above, pale at the horizon, a hazy sun, grey-brown ground. */
function sky(w: Color): Color {
  const up = mix([1.0, 0.98, 0.94], [0.28, 0.47, 0.86], step(0, 0.75, w[1]));
  const color = mix(mix([0.3, 0.27, 0.23], [0.5, 0.47, 0.43], step(-0.5, 0, w[1])), up, step(-0.05, 0.05, w[1]));
  const sun = unit([0.75, 0.55, 0.5]);
  const glow = Math.exp(-((1 - dot(w, sun)) / 0.03)) * 9 + Math.exp(-((1 - dot(w, sun)) / 0.25)) * 0.5;
  const seen = step(-0.05, 0.1, w[1]);
  return [color[0] + 1.0 * glow * seen, color[1] + 0.88 * glow * seen, color[2] + 0.7 * glow * seen];
}

/** How much of a soft box is seen in a direction. */
function box(center: Color, width: number, height: number): (w: Color) => number {
  const c = unit(center);
  const right = unit([c[2], 0, -c[0]]);
  const above: Color = [c[1] * right[2] - c[2] * right[1], c[2] * right[0] - c[0] * right[2], c[0] * right[1] - c[1] * right[0]];
  return (w) => {
    const facing = dot(w, c);
    if (facing <= 0) return 0;
    const across = Math.abs(dot(w, right)) / facing;
    if (across >= 1.1 * width) return 0;
    return (1 - step(0.8, 1.1, across / width)) * (1 - step(0.8, 1.1, Math.abs(dot(w, above)) / facing / height));
  };
}

const KEY = box([-0.8, 0.75, 0.6], 0.55, 0.4);
const STRIP = box([1.0, 0.25, 0.15], 0.16, 0.7);
const RIM = box([0.3, 0.8, -1.0], 0.7, 0.22);

/** A dark room with three soft boxes: a large one to the left above, a strip to the right, one behind. */
function studio(w: Color): Color {
  const base = mix([0.06, 0.055, 0.05], [0.16, 0.165, 0.18], step(-0.4, 1, w[1]));
  const key = 4.2 * KEY(w);
  const strip = 3.0 * STRIP(w);
  const rim = 4.0 * RIM(w);
  return [base[0] + 1.0 * key + 0.85 * strip + 0.95 * rim, base[1] + 0.96 * key + 0.93 * strip + 0.97 * rim, base[2] + 0.88 * key + 1.05 * strip + 1.0 * rim];
}

const luminance = (map: Float32Array, at: number): number => 0.2126 * map[3 * at]! + 0.7152 * map[3 * at + 1]! + 0.0722 * map[3 * at + 2]!;

/** The radiance of a white diffuser that faces up under a map. */
export function upward(map: Float32Array): number {
  let sum = 0;
  for (let row = 0; row < HEIGHT / 2; row += 1) {
    const [top, bottom] = [Math.cos((Math.PI * row) / HEIGHT), Math.cos((Math.PI * (row + 1)) / HEIGHT)];
    // The integral of the cosine over the cell, over pi.
    const weight = (top * top - bottom * bottom) / WIDTH;
    for (let column = 0; column < WIDTH; column += 1) sum += weight * luminance(map, row * WIDTH + column);
  }
  return sum;
}

function mean(map: Float32Array): number {
  let sum = 0;
  for (let at = 0; at < WIDTH * HEIGHT; at += 1) sum += luminance(map, at) * Math.sin((Math.PI * (Math.floor(at / WIDTH) + 0.5)) / HEIGHT);
  return (sum * Math.PI) / (2 * HEIGHT * WIDTH);
}

/** Directions and radiance/density, a texel each in turn, 256 texels a row; drawn by a sequence whose beginnings are even, too. */
export function drawn(map: Float32Array): Float32Array {
  const evenly = EVENLY * mean(map);
  const data = new Float32Array(4 * 2 * DIRECTIONS);
  const weights = new Float64Array(WIDTH * HEIGHT);
  const rows = new Float64Array(HEIGHT + 1);
  for (let row = 0; row < HEIGHT; row += 1) {
    // The exact solid angle of a cell of this row.
    const solid = ((2 * Math.PI) / WIDTH) * (Math.cos((Math.PI * row) / HEIGHT) - Math.cos((Math.PI * (row + 1)) / HEIGHT));
    let sum = 0;
    for (let column = 0; column < WIDTH; column += 1) {
      const at = row * WIDTH + column;
      weights[at] = solid * (luminance(map, at) + evenly);
      sum += weights[at]!;
    }
    rows[row + 1] = rows[row]! + sum;
  }
  const total = rows[HEIGHT]!;
  if (!(total > 0)) return data;
  // Roberts' R2 sequence: steps by the inverses of the plastic number and its square.
  const plastic = 1.32471795724474602596;
  for (let k = 0; k < DIRECTIONS; k += 1) {
    const a = (0.5 + (k + 1) / plastic) % 1;
    const b = (0.5 + (k + 1) / (plastic * plastic)) % 1;
    let row = 0;
    while (row < HEIGHT - 1 && rows[row + 1]! < a * total) row += 1;
    const inRow = (a * total - rows[row]!) / (rows[row + 1]! - rows[row]! || 1);
    let column = 0;
    let before = 0;
    const wanted = b * (rows[row + 1]! - rows[row]!);
    while (column < WIDTH - 1 && before + weights[row * WIDTH + column]! < wanted) {
      before += weights[row * WIDTH + column]!;
      column += 1;
    }
    const at = row * WIDTH + column;
    const inCell = (wanted - before) / (weights[at]! || 1);
    // Even in the cosine within the cell, as its solid angle is.
    const [top, bottom] = [Math.cos((Math.PI * row) / HEIGHT), Math.cos((Math.PI * (row + 1)) / HEIGHT)];
    const theta = Math.acos(top + inRow * (bottom - top));
    const solid = ((2 * Math.PI) / WIDTH) * (top - bottom);
    const over = (solid * total) / weights[at]!;
    data.set(direction((column + inCell) / WIDTH, theta / Math.PI), 8 * k);
    data.set([map[3 * at]! * over, map[3 * at + 1]! * over, map[3 * at + 2]! * over], 8 * k + 4);
  }
  return data;
}

/** The directions of a sky as a texture. */
export function directionsTexture(map: Float32Array): DataTexture {
  const texture = new DataTexture(drawn(map), 256, (2 * DIRECTIONS) / 256, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
