// OBJ, PLY and GLB as triangles.  Only the shape is read: no materials, no pictures, nothing that a file points to.

import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { Matrix4, Vector3 } from 'three';
import { isRecord } from './material';
import { Problem } from './problem';
import type { Triangles } from './shapes';

export const SUFFIXES = ['.obj', '.ply', '.glb'];
const LARGEST = 400 * 2 ** 20;

/** Triangles out of a file; a sentence where it holds none. */
export function readMesh(name: string, data: ArrayBuffer): Triangles {
  if (data.byteLength > LARGEST) throw new Problem(`${name} has ${Math.round(data.byteLength / 2 ** 20)} MiB, more than ${LARGEST / 2 ** 20}`, 'Decimate it');
  const suffix = name.slice(name.lastIndexOf('.')).toLowerCase();
  try {
    if (suffix === '.obj') return obj(name, new TextDecoder().decode(data));
    if (suffix === '.ply') return ply(name, data);
    return glb(name, data);
  } catch (error) {
    if (error instanceof Problem) throw error;
    throw new Problem(`${name} is not a mesh that can be read: ${error instanceof Error ? error.message : String(error)}`, 'Export it again as OBJ, PLY or GLB');
  }
}

function obj(name: string, text: string): Triangles {
  const points: number[] = [];
  const directions: number[] = [];
  const corners: number[] = [];
  const cornerNormals: number[] = [];
  let line = 0;
  for (let start = 0; start < text.length; ) {
    let end = text.indexOf('\n', start);
    if (end < 0) end = text.length;
    line += 1;
    const head = text.charCodeAt(start);
    if (head === 118 || head === 102) {
      const words = text.slice(start, end).trim().split(/\s+/);
      if (words[0] === 'v') points.push(...three(words, name, line));
      else if (words[0] === 'vn') directions.push(...three(words, name, line));
      else if (words[0] === 'f') {
        const face = words.slice(1).map((word) => corner(word, points.length / 3, directions.length / 3, name, line));
        if (face.length < 3) throw new Problem(`${name}, line ${line}: a face with ${face.length} corners`, 'Export it again');
        for (let k = 1; k + 1 < face.length; k += 1) {
          for (const [v, n] of [face[0]!, face[k]!, face[k + 1]!]) {
            corners.push(v);
            cornerNormals.push(n);
          }
        }
      }
    }
    start = end + 1;
  }
  const positions = Float32Array.from(points);
  if (!directions.length || cornerNormals.some((n) => n < 0)) return { name, positions, normals: null, indices: Uint32Array.from(corners) };
  // A vertex for each pair of a position and a normal.
  const seen = new Map<number, number>();
  const indices = new Uint32Array(corners.length);
  const [places, normals]: [number[], number[]] = [[], []];
  const count = directions.length / 3;
  corners.forEach((v, k) => {
    const key = v * count + cornerNormals[k]!;
    let index = seen.get(key);
    if (index === undefined) {
      index = seen.size;
      seen.set(key, index);
      for (let j = 0; j < 3; j += 1) {
        places.push(points[3 * v + j]!);
        normals.push(directions[3 * cornerNormals[k]! + j]!);
      }
    }
    indices[k] = index;
  });
  return { name, positions: Float32Array.from(places), normals: Float32Array.from(normals), indices };
}

function three(words: string[], name: string, line: number): [number, number, number] {
  const [x, y, z] = [Number(words[1]), Number(words[2]), Number(words[3])];
  if (![x, y, z].every(Number.isFinite)) throw new Problem(`${name}, line ${line}: ${words.slice(0, 4).join(' ').slice(0, 60)} is not three numbers`, 'Export it again');
  return [x, y, z];
}

function corner(word: string, points: number, directions: number, name: string, line: number): [number, number] {
  const [v, , n] = word.split('/');
  const resolve = (text: string | undefined, count: number): number => {
    if (!text) return -1;
    const index = Number(text);
    const zeroBased = index < 0 ? count + index : index - 1;
    if (!Number.isInteger(index) || zeroBased < 0 || zeroBased >= count) throw new Problem(`${name}, line ${line}: ${word.slice(0, 40)} is not among ${count} vertices`, 'The file is damaged');
    return zeroBased;
  };
  const vertex = resolve(v, points);
  if (vertex < 0) throw new Problem(`${name}, line ${line}: a corner without a vertex`, 'The file is damaged');
  return [vertex, resolve(n, directions)];
}

function ply(name: string, data: ArrayBuffer): Triangles {
  if (new TextDecoder('latin1').decode(data.slice(0, 3)) !== 'ply') throw new Problem(`${name} does not begin with "ply"`, 'Export it again');
  const geometry = new PLYLoader().parse(data);
  const positions = geometry.getAttribute('position')?.array;
  const index = geometry.getIndex()?.array;
  if (!positions || !index) throw new Problem(`${name} has no faces`, 'Export the mesh with its faces; clouds of points cannot be shaded');
  const normals = geometry.getAttribute('normal')?.array;
  return { name, positions: Float32Array.from(positions), normals: normals ? Float32Array.from(normals) : null, indices: Uint32Array.from(index) };
}

// ---------------------------------------------------------------- GLB

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const ARRAYS = { 5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array } as const;
const SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const DEEPEST = 64;

type Json = Record<string, unknown>;

function glb(name: string, data: ArrayBuffer): Triangles {
  const view = new DataView(data);
  if (data.byteLength < 20 || view.getUint32(0, true) !== MAGIC || view.getUint32(4, true) !== 2) throw new Problem(`${name} is not a GLB file of version 2`, 'Export it as glTF binary (.glb)');
  let json: Json | null = null;
  let binary: ArrayBuffer = new ArrayBuffer(0);
  for (let at = 12; at + 8 <= data.byteLength; ) {
    const [length, kind] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    if (at + 8 + length > data.byteLength) throw new Problem(`${name} is cut short`, 'Export it again');
    const chunk = data.slice(at + 8, at + 8 + length);
    if (kind === JSON_CHUNK) json = JSON.parse(new TextDecoder().decode(chunk)) as Json;
    if (kind === BINARY_CHUNK) binary = chunk;
    at += 8 + length;
  }
  if (!json) throw new Problem(`${name} has no description`, 'Export it again');
  const document: Json = json;
  const required = Array.isArray(document['extensionsRequired']) ? document['extensionsRequired'].map(String) : [];
  if (required.some((each) => /compression|meshopt/i.test(each))) throw new Problem(`${name} is compressed (${required.join(', ')})`, 'Export it without compression');
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  let complete = true;
  const list = (key: string): Json[] => (Array.isArray(document[key]) ? (document[key] as unknown[]).filter(isRecord) : []);
  const accessor = (index: unknown): { values: ArrayLike<number>; size: number } => {
    const found = list('accessors')[Number(index)];
    const buffer = found && list('bufferViews')[Number(found['bufferView'])];
    const kind = found && ARRAYS[Number(found['componentType']) as keyof typeof ARRAYS];
    const size = found ? SIZES[String(found['type'])] : undefined;
    if (!found || !buffer || !kind || !size || found['sparse']) throw new Problem(`${name} holds numbers in a way that is not supported`, 'Export it again without sparse accessors');
    const count = Number(found['count']);
    const start = Number(buffer['byteOffset'] ?? 0) + Number(found['byteOffset'] ?? 0);
    const width = size * kind.BYTES_PER_ELEMENT;
    const stride = Number(buffer['byteStride'] ?? 0) || width;
    if (!(count >= 0) || start + (count - 1) * stride + width > binary.byteLength) throw new Problem(`${name} is cut short: it lacks ${count} numbers`, 'Export it again');
    const values = new Float64Array(count * size);
    for (let k = 0; k < count; k += 1) values.set(new kind(binary.slice(start + k * stride, start + k * stride + width)), k * size);
    const scale = found['normalized'] ? 1 / (2 ** (8 * kind.BYTES_PER_ELEMENT - (kind.name.startsWith('I') ? 1 : 0)) - 1) : 1;
    return { values: scale === 1 ? values : values.map((x) => x * scale), size };
  };
  const walk = (index: unknown, parent: Matrix4, depth: number): void => {
    const node = list('nodes')[Number(index)];
    if (!node || depth > DEEPEST) return;
    const matrix = parent.clone().multiply(local(node));
    const mesh = node['mesh'] === undefined ? undefined : list('meshes')[Number(node['mesh'])];
    for (const primitive of (mesh && Array.isArray(mesh['primitives']) ? (mesh['primitives'] as unknown[]) : []).filter(isRecord)) {
      if ((primitive['mode'] ?? 4) !== 4 || !isRecord(primitive['attributes'])) continue;
      const own = accessor(primitive['attributes']['POSITION']).values;
      const base = positions.length / 3;
      const point = new Vector3();
      for (let k = 0; k < own.length; k += 3) positions.push(...point.set(own[k]!, own[k + 1]!, own[k + 2]!).applyMatrix4(matrix).toArray());
      const directions = primitive['attributes']['NORMAL'];
      if (directions === undefined) complete = false;
      else {
        const turn = matrix.clone().invert().transpose();
        const given = accessor(directions).values;
        for (let k = 0; k < given.length; k += 3) normals.push(...point.set(given[k]!, given[k + 1]!, given[k + 2]!).transformDirection(turn).toArray());
      }
      if (primitive['indices'] === undefined) for (let k = 0; k < own.length / 3; k += 1) indices.push(base + k);
      else for (const k of Array.from(accessor(primitive['indices']).values)) indices.push(base + k);
    }
    for (const child of Array.isArray(node['children']) ? (node['children'] as unknown[]) : []) walk(child, matrix, depth + 1);
  };
  const scene = list('scenes')[Number(document['scene'] ?? 0)];
  const roots = scene && Array.isArray(scene['nodes']) ? (scene['nodes'] as unknown[]) : list('nodes').map((_, k) => k);
  for (const root of roots) walk(root, new Matrix4(), 0);
  return { name, positions: Float32Array.from(positions), normals: complete && normals.length === positions.length ? Float32Array.from(normals) : null, indices: Uint32Array.from(indices) };
}

function local(node: Json): Matrix4 {
  const numbers = (key: string, size: number): number[] | null => (Array.isArray(node[key]) && node[key].length === size ? node[key].map(Number) : null);
  const whole = numbers('matrix', 16);
  if (whole) return new Matrix4().fromArray(whole);
  const matrix = new Matrix4();
  const [t, r, s] = [numbers('translation', 3), numbers('rotation', 4), numbers('scale', 3)];
  if (r) {
    const [x, y, z, w] = r as [number, number, number, number];
    matrix.set(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0, 2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0, 2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0, 0, 0, 0, 1);
  }
  if (s) matrix.scale(new Vector3(...(s as [number, number, number])));
  if (t) matrix.premultiply(new Matrix4().makeTranslation(...(t as [number, number, number])));
  return matrix;
}
