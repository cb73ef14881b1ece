// OBJ, PLY and GLB as triangles.  Only the shape is read: no materials, no pictures, nothing that a file points to.
//
// PLY and GLB go through three's loaders.  OBJ does not: three's makes six vertices of one, gives every face a normal of its own, and turns a mistake into
// NaN without saying where.

import type { BufferGeometry } from 'three';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { mergeVertices } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { glb } from './gltf';
import { Problem, quoted } from './problem';
import type { Triangles } from './shapes';

export const SUFFIXES = ['.obj', '.ply', '.glb'];
const LARGEST = 400 * 2 ** 20;
const HEADER = 65536;

/** Triangles out of a file; a sentence where it holds none. */
export async function readMesh(name: string, data: ArrayBuffer): Promise<Triangles> {
  if (data.byteLength > LARGEST) throw new Problem(`${name} has ${Math.round(data.byteLength / 2 ** 20)} MiB, more than ${LARGEST / 2 ** 20}`, 'Decimate it');
  const suffix = name.slice(name.lastIndexOf('.')).toLowerCase();
  try {
    if (suffix === '.obj') return obj(name, new TextDecoder().decode(data));
    if (suffix === '.ply') return ply(name, data);
    return await glb(name, data);
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
    let head = text.charCodeAt(start);
    for (let at = start; (head === 32 || head === 9) && at < end; at += 1) head = text.charCodeAt(at + 1);
    if (head === 118 || head === 102) {
      let content = text.slice(start, end);
      while (/\\\s*$/.test(content) && end < text.length) {
        // A line that goes on in the next one.
        const next = text.indexOf('\n', end + 1);
        content = content.replace(/\\\s*$/, ' ') + text.slice(end + 1, next < 0 ? text.length : next);
        end = next < 0 ? text.length : next;
        line += 1;
      }
      const words = content.replace(/#.*/, '').trim().split(/\s+/);
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

const CORNERS = ['vertex_indices', 'vertex_index'];

/** The loader cuts fractions off: 0.2 and 1.7 would be vertices 0 and 1. */
function wholeIndices(name: string, header: string, data: ArrayBuffer): void {
  const elements: { name: string; count: number; properties: string[][] }[] = [];
  for (const line of header.split(/\r\n|\r|\n/)) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'element') elements.push({ name: words[1] ?? '', count: Number(words[2]), properties: [] });
    if (words[0] !== 'property') continue;
    elements.at(-1)?.properties.push(words);
    const types = words[1] === 'list' ? [words[2], CORNERS.includes(words[4] ?? '') ? words[3] : undefined] : [];
    if (types.some((type) => type && /^(float|double)/.test(type))) throw new Problem(`${name} has faces whose vertices are fractions: ${quoted(line.trim())}`, 'Export it again');
  }
  if (!/^\s*format\s+ascii\b/m.test(header)) return;
  const text = new TextDecoder('latin1').decode(data);
  const lines = text.slice(text.indexOf('end_header') + 'end_header'.length).split(/\r\n|\r|\n/).filter((line) => line.trim());
  let at = 0;
  for (const element of elements) {
    const own = lines.slice(at, (at += element.count));
    if (element.name !== 'face') continue;
    for (const line of own) {
      const words = line.trim().split(/\s+/);
      let k = 0;
      for (const property of element.properties) {
        if (property[1] !== 'list') {
          k += 1;
          continue;
        }
        const items = Number(words[k]);
        const shown = CORNERS.includes(property[4] ?? '') ? words.slice(k, k + 1 + items) : [words[k]!];
        if (words.length < k + 1 + items) throw new Problem(`${name} breaks off within the face ${quoted(line.trim())}`, 'The file is damaged; fetch it again');
        if (!shown.every((word) => /^[+-]?\d+$/.test(word))) throw new Problem(`${name} has the face ${quoted(line.trim())}, whose vertices are not whole numbers`, 'Export it again');
        k += 1 + items;
      }
    }
  }
}

function ply(name: string, data: ArrayBuffer): Triangles {
  if (new TextDecoder('latin1').decode(data.slice(0, 3)) !== 'ply') throw new Problem(`${name} does not begin with "ply"`, 'Export it again');
  const header = new TextDecoder('latin1').decode(data.slice(0, HEADER)).split('end_header')[0]!;
  for (const [, what, count] of header.matchAll(/^\s*element\s+(\S+)\s+(\S+)/gm)) {
    // The loader believes it, and goes through as many rows.
    if (!(Number(count) <= data.byteLength)) throw new Problem(`${name} claims ${quoted(count)} of ${quoted(what)}, more than its ${data.byteLength} bytes hold`, 'The file is damaged');
  }
  wholeIndices(name, header, data);
  const loader = new PLYLoader();
  const dusty = /^\s*property\s+\w+\s+tau\s*$/m.test((/element\s+vertex\b[^]*?(?=^\s*element\b|$(?![^]))/m.exec(header) ?? [''])[0]);
  if (dusty) loader.setCustomPropertyNameMapping({ tau: ['tau'] });
  let geometry: BufferGeometry = loader.parse(data);
  if (!geometry.getIndex() && /^\s*element\s+face\s+0*[1-9]/m.test(header) && (geometry.getAttribute('color') || geometry.getAttribute('uv'))) geometry = joined(geometry);
  const positions = geometry.getAttribute('position')?.array;
  const index = geometry.getIndex()?.array;
  if (!positions || !index) throw new Problem(`${name} has no faces`, 'Export the mesh with its faces; clouds of points cannot be shaded');
  const normals = geometry.getAttribute('normal')?.array;
  const tau = dusty ? geometry.getAttribute('tau')?.array : null;
  return { name, positions: Float32Array.from(positions), normals: normals ? Float32Array.from(normals) : null, indices: Uint32Array.from(index), tau: tau ? Float32Array.from(tau) : null };
}

/** Faces with colours or textures of their own come as three vertices each: those that are one are put together again, or every face would shade flat. */
function joined(geometry: BufferGeometry): BufferGeometry {
  for (const name of Object.keys(geometry.attributes)) if (!['position', 'normal', 'tau'].includes(name)) geometry.deleteAttribute(name);
  return mergeVertices(geometry, 0);
}
