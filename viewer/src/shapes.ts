// Meshes: those of the page, and what they must be to be drawn.

import { BufferAttribute, BufferGeometry } from 'three';
import type { ShapeView } from './generated';
import { bytes } from './packed';
import { Problem } from './problem';
import { settle } from './settle';

export interface Triangles {
  name: string;
  positions: Float32Array;
  normals: Float32Array | null;
  indices: Uint32Array;
  /** Optical thickness of the dust at each vertex, where a file has it. */
  tau?: Float32Array | null;
}

/** The longest side of a mesh, where the sphere has a diameter of 2. */
const WIDEST = 2.3;
export const MOST_TRIANGLES = 5_000_000;

/** A mesh of the page. */
export function embedded(view: ShapeView): BufferGeometry {
  const packed = new Uint16Array(bytes(view.positions));
  const positions = Float32Array.from(packed, (value, k) => view.low[k % 3]! + ((view.high[k % 3]! - view.low[k % 3]!) * value) / 65535);
  const normals = Float32Array.from(new Int16Array(bytes(view.normals)), (value) => value / 32767);
  const dust = Float32Array.from(new Uint8Array(bytes(view.dust)), (value) => value / 255);
  // Its middle at the origin; the sphere keeps its radius of 1, what is wider fits into the picture.
  const size = view.high.map((high, j) => high - view.low[j]!);
  const scale = Math.min(1, WIDEST / Math.max(...size));
  for (let k = 0; k < positions.length; k += 1) positions[k] = (positions[k]! - view.low[k % 3]! - size[k % 3]! / 2) * scale;
  return geometry(positions, normals, new Uint16Array(bytes(view.triangles)), dust);
}

/** A mesh of the user's: checked, brought to the size of the others, with normals and dust. */
export function prepared(given: Triangles, dustByInclination: readonly number[], up: string): BufferGeometry {
  const mesh = up === 'z' ? turned(given) : given;
  const { positions, indices } = mesh;
  if (indices.length < 3) throw new Problem(`${mesh.name} has no triangle`, 'Export the mesh with its faces');
  if (indices.length / 3 > MOST_TRIANGLES) throw new Problem(`${mesh.name} has ${(indices.length / 3).toLocaleString('en')} triangles, more than ${MOST_TRIANGLES.toLocaleString('en')}`, 'Decimate it');
  const count = positions.length / 3;
  for (const index of indices) if (index >= count) throw new Problem(`${mesh.name} has a face with vertex ${index} of ${count} vertices`, 'The file is damaged');
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const index of indices) {
    for (let j = 0; j < 3; j += 1) {
      const value = positions[3 * index + j]!;
      if (!Number.isFinite(value)) throw new Problem(`${mesh.name} has a vertex whose position is not finite`, 'Export it again; a modifier that divides by zero is a usual cause');
      low[j] = Math.min(low[j]!, value);
      high[j] = Math.max(high[j]!, value);
    }
  }
  const size = Math.max(...low.map((value, j) => high[j]! - value));
  if (!(size > 0)) throw new Problem(`${mesh.name} has no extent: all its vertices lie in one point`, 'Export it again');
  const moved = new Float32Array(positions.length);
  for (let k = 0; k < positions.length; k += 1) moved[k] = ((positions[k]! - (low[k % 3]! + high[k % 3]!) / 2) / size) * WIDEST;
  const made = geometry(moved, mesh.normals && usable(mesh.normals, count) ? mesh.normals : null, count < 65536 ? Uint16Array.from(indices) : indices, null);
  if (!made.getAttribute('normal')) made.computeVertexNormals();
  const normals = made.getAttribute('normal').array as Float32Array;
  const most = thickest(mesh);
  const share = mesh.tau && most > 0 ? mesh.tau.map((tau) => tau / most) : settle(moved, normals, indices, dustByInclination);
  made.setAttribute('dust', new BufferAttribute(share, 1));
  return made;
}

/** The largest tau of a mesh's own dust, 0 where it has none. */
export function thickest(mesh: Triangles): number {
  let most = 0;
  for (const tau of mesh.tau ?? []) {
    if (!(tau >= 0 && Number.isFinite(tau))) throw new Problem(`${mesh.name} has a vertex with tau = ${tau}, which is no optical thickness`, 'tau is a number from 0 on');
    most = Math.max(most, tau);
  }
  return most;
}

/** z up as y up: a quarter turn about x. */
function turned(mesh: Triangles): Triangles {
  const turn = (values: Float32Array): Float32Array => values.map((value, k) => (k % 3 === 0 ? value : k % 3 === 1 ? values[k + 1]! : -values[k - 1]!));
  return { ...mesh, positions: turn(mesh.positions), normals: mesh.normals && turn(mesh.normals) };
}

function usable(normals: Float32Array, count: number): boolean {
  if (normals.length !== 3 * count) return false;
  for (let k = 0; k < normals.length; k += 3) if (!(Math.hypot(normals[k]!, normals[k + 1]!, normals[k + 2]!) > 1e-6)) return false;
  return true;
}

function geometry(positions: Float32Array, normals: Float32Array | null, indices: Uint16Array | Uint32Array, dust: Float32Array | null): BufferGeometry {
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(positions, 3));
  if (normals) made.setAttribute('normal', new BufferAttribute(normals, 3));
  if (dust) made.setAttribute('dust', new BufferAttribute(dust, 1));
  made.setIndex(new BufferAttribute(indices, 1));
  return made;
}
