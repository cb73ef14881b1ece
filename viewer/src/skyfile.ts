// A sky of the user's: a panorama as Radiance HDR or OpenEXR, by three's loaders, brought to the cells that the viewer draws directions from.

import { DataUtils } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';
import { HEIGHT, WIDTH } from './environment';
import { Problem } from './problem';

export const SKY_SUFFIXES = ['.hdr', '.exr'];
/** The loaders believe the sizes that a file claims. */
const MOST_PIXELS = 2 ** 25;
const LARGEST = 512 * 2 ** 20;
const HEADER = 65536;

/** Radiance (linear sRGB) of the cells of a map, as `radianceMap` has them; a sentence where the file holds no panorama. */
export function readSky(name: string, data: ArrayBuffer): Float32Array {
  if (data.byteLength > LARGEST) throw new Problem(`${name} has ${Math.round(data.byteLength / 2 ** 20)} MiB, more than ${LARGEST / 2 ** 20}`, 'Make it smaller: the sky is shown in 64 x 128 cells');
  const exr = name.toLowerCase().endsWith('.exr');
  const [width, height] = exr ? exrSize(name, data) : hdrSize(name, data);
  if (!(width > 0 && height > 0 && width * height <= MOST_PIXELS)) throw new Problem(`${name} claims ${width} x ${height} pixels, which is none or more than ${MOST_PIXELS.toLocaleString('en')}`, 'Make it smaller: the sky is shown in 64 x 128 cells');
  if (Math.abs(width / height - 2) > 0.05) throw new Problem(`${name} has ${width} x ${height} pixels; a panorama is twice as wide as high`, 'Open an equirectangular (latitude and longitude) picture');
  let pixels: { width: number; height: number; data: ArrayLike<number> };
  try {
    pixels = (exr ? new EXRLoader() : new HDRLoader()).parse(data) as unknown as typeof pixels;
  } catch (error) {
    throw new Problem(`${name} is not a picture that can be read: ${error instanceof Error ? error.message : String(error)}`, 'Save it again as Radiance HDR or OpenEXR');
  }
  if (pixels.width !== width || pixels.height !== height) throw new Problem(`${name} holds ${pixels.width} x ${pixels.height} pixels where its head says ${width} x ${height}`, 'The file is damaged');
  return cells(name, pixels.data, width, height, exr);
}

function hdrSize(name: string, data: ArrayBuffer): [number, number] {
  const head = new TextDecoder('latin1').decode(data.slice(0, HEADER));
  const size = /\n-Y (\d+) \+X (\d+)\n/.exec(head);
  if (!head.startsWith('#?') || !size) throw new Problem(`${name} has no head of a Radiance picture that is stored row by row from the top`, 'Save it again as Radiance HDR or OpenEXR');
  const [width, height] = [Number(size[2]), Number(size[1])];
  // The loader leaves black what is missing; a row takes so much at least, however even it is.
  if (data.byteLength - head.indexOf(size[0]) - size[0].length < height * Math.min(4 * width, 4 + 8 * Math.ceil(width / 127)) && width * height <= MOST_PIXELS) throw new Problem(`${name} breaks off within its pixels`, 'The file is damaged; fetch it again');
  return [width, height];
}

function exrSize(name: string, data: ArrayBuffer): [number, number] {
  const head = new TextDecoder('latin1').decode(data.slice(0, HEADER));
  const at = head.indexOf('dataWindow\0box2i\0');
  if (!head.startsWith('v/1\x01') || at < 0 || at + 37 > data.byteLength) throw new Problem(`${name} has no head of an OpenEXR picture`, 'Save it again as Radiance HDR or OpenEXR');
  const [x0, y0, x1, y1] = [0, 1, 2, 3].map((k) => new DataView(data).getInt32(at + 21 + 4 * k, true)) as [number, number, number, number];
  return [x1 - x0 + 1, y1 - y0 + 1];
}

/** Means over the pixels whose middles lie in a cell, or the nearest pixel where none does.  A panorama's middle lies behind the mesh, towards -z. */
function cells(name: string, data: ArrayLike<number>, width: number, height: number, upwards: boolean): Float32Array {
  const channels = data.length / (width * height);
  const value = (x: number, y: number, channel: number): number => {
    const raw = data[(((upwards ? height - 1 - y : y) * width + x) * channels) + (channels < 3 ? 0 : channel)]!;
    const radiance = data instanceof Uint16Array ? DataUtils.fromHalfFloat(raw) : raw;
    return Number.isFinite(radiance) && radiance > 0 ? radiance : 0;
  };
  const sums = new Float64Array(3 * WIDTH * HEIGHT);
  const weights = new Float64Array(WIDTH * HEIGHT);
  for (let y = 0; y < height; y += 1) {
    const solid = Math.sin((Math.PI * (y + 0.5)) / height);
    const row = Math.min(Math.floor(((y + 0.5) * HEIGHT) / height), HEIGHT - 1);
    for (let x = 0; x < width; x += 1) {
      const cell = row * WIDTH + column((x + 0.5) / width);
      weights[cell]! += solid;
      for (let channel = 0; channel < 3; channel += 1) sums[3 * cell + channel]! += solid * value(x, y, channel);
    }
  }
  const map = new Float32Array(3 * WIDTH * HEIGHT);
  for (let cell = 0; cell < WIDTH * HEIGHT; cell += 1) {
    const weight = weights[cell]!;
    const x = Math.min(Math.floor((((1 - ((cell % WIDTH) + 0.5) / WIDTH) % 1) * width)), width - 1);
    const y = Math.min(Math.floor(((Math.floor(cell / WIDTH) + 0.5) * height) / HEIGHT), height - 1);
    for (let channel = 0; channel < 3; channel += 1) map[3 * cell + channel] = weight > 0 ? sums[3 * cell + channel]! / weight : value(x, y, channel);
  }
  if (!map.some((radiance) => radiance > 0)) throw new Problem(`${name} is black`, 'Open a picture with light in it');
  return map;
}

/** The column of cells that a share of the panorama's width falls into: the map's azimuth goes from +z to +x, the panorama's from +z to -x. */
function column(share: number): number {
  return Math.min(Math.floor((1 - share) * WIDTH), WIDTH - 1);
}
