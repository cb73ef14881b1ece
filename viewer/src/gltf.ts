// GLB by three's GLTFLoader.  The loader trusts a file: it follows cycles, believes sizes, and fetches what a file points to.  So it is given a
// description made anew, which holds nothing but shapes, once that has been looked at.

import { type BufferAttribute, type InterleavedBufferAttribute, Matrix3, Mesh, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { isRecord } from './material';
import { Problem, quoted } from './problem';
import { MOST_TRIANGLES, type Triangles } from './shapes';

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const WIDTHS: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const DEEPEST = 64;
const LARGEST_STRIDE = 252;
const QUANTIZED = 'KHR_mesh_quantization';

type Json = Record<string, unknown>;

/** Triangles of all meshes of the scene, where it puts them. */
export async function glb(name: string, data: ArrayBuffer): Promise<Triangles> {
  const { document, binary } = chunks(name, data);
  const file = packed(checked(name, document, binary.byteLength), binary);
  const { scene } = await new GLTFLoader().parseAsync(file, '');
  scene.updateMatrixWorld(true);
  const meshes: Mesh[] = [];
  scene.traverse((each) => {
    if (each instanceof Mesh) meshes.push(each);
  });
  return together(name, meshes);
}

function together(name: string, meshes: Mesh[]): Triangles {
  const counts = meshes.map(({ geometry }) => [geometry.getAttribute('position').count, geometry.getIndex()?.count ?? geometry.getAttribute('position').count] as const);
  const positions = new Float32Array(3 * counts.reduce((sum, [vertices]) => sum + vertices, 0));
  const indices = new Uint32Array(counts.reduce((sum, [, corners]) => sum + corners, 0));
  const complete = meshes.length > 0 && meshes.every(({ geometry }) => geometry.getAttribute('normal'));
  const normals = complete ? new Float32Array(positions.length) : null;
  const point = new Vector3();
  let [vertex, corner] = [0, 0];
  meshes.forEach(({ geometry, matrixWorld }, k) => {
    const turn = new Matrix3().getNormalMatrix(matrixWorld);
    const mirrored = matrixWorld.determinant() < 0;
    const [given, directions, index] = [geometry.getAttribute('position'), geometry.getAttribute('normal'), geometry.getIndex()];
    for (let j = 0; j < given.count; j += 1) {
      numbers(point, given, j).applyMatrix4(matrixWorld).toArray(positions, 3 * (vertex + j));
      if (normals) numbers(point, directions, j).applyMatrix3(turn).normalize().toArray(normals, 3 * (vertex + j));
    }
    const total = counts[k]![1];
    for (let j = 0; j < total; j += 1) {
      // A mirror turns faces inside out; their corners then go the other way round.
      const at = mirrored ? j - (j % 3) + ((3 - (j % 3)) % 3) : j;
      indices[corner + j] = vertex + (index ? index.getX(at) : at);
    }
    vertex += given.count;
    corner += total;
  });
  return { name, positions, normals, indices };
}

function numbers(point: Vector3, values: BufferAttribute | InterleavedBufferAttribute, k: number): Vector3 {
  return point.fromBufferAttribute(values, k);
}

/** The description and the numbers of a GLB file. */
function chunks(name: string, data: ArrayBuffer): { document: Json; binary: Uint8Array<ArrayBuffer> } {
  const view = new DataView(data);
  if (data.byteLength < 20 || view.getUint32(0, true) !== MAGIC || view.getUint32(4, true) !== 2) throw new Problem(`${name} is not a GLB file of version 2`, 'Export it as glTF binary (.glb)');
  let document: unknown = null;
  let binary = new Uint8Array(0);
  for (let at = 12; at + 8 <= data.byteLength; ) {
    const [length, kind] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    if (at + 8 + length > data.byteLength) throw new Problem(`${name} is cut short`, 'Export it again');
    const chunk = new Uint8Array(data, at + 8, length);
    if (kind === JSON_CHUNK && document === null) document = JSON.parse(new TextDecoder().decode(chunk));
    if (kind === BINARY_CHUNK && !binary.length) binary = chunk;
    at += 8 + length;
  }
  if (!isRecord(document)) throw new Problem(`${name} has no description`, 'Export it again');
  return { document, binary };
}

/** A description with the shapes of this one alone, all indices and sizes of which are sane. */
function checked(name: string, document: Json, bytes: number): Json {
  const lost = (what: string): Problem => new Problem(`${name} has ${what} that lead nowhere, or beyond the file`, 'The file is damaged; export it again');
  const list = (owner: Json, key: string): Json[] => {
    const found = owner[key] ?? [];
    if (!Array.isArray(found) || !found.every(isRecord)) throw lost(key);
    return found as Json[];
  };
  const whole = (owner: Json, key: string, fallback = 0): number => {
    const value = owner[key] ?? fallback;
    if (typeof value !== 'number' || !Number.isSafeInteger(value) || value < 0) throw new Problem(`${name}: ${key} = ${quoted(value)} is no size`, 'The file is damaged; export it again');
    return value;
  };
  const within = (value: unknown, length: number, what: string): number => {
    if (typeof value !== 'number' || !Number.isInteger(value) || value < 0 || value >= length) throw lost(what);
    return value;
  };
  const required = Array.isArray(document['extensionsRequired']) ? document['extensionsRequired'].map(String) : [];
  const strange = required.filter((each) => each !== QUANTIZED && !/^KHR_(materials|texture|lights)/.test(each));
  if (strange.length) throw new Problem(`${name} is compressed, or needs ${strange.join(', ').slice(0, 80)}`, 'Export it without compression or extensions');
  const [buffer, ...others] = list(document, 'buffers');
  if (!buffer || others.length || buffer['uri'] !== undefined) throw new Problem(`${name} keeps its numbers in other files`, 'Export it as glTF binary (.glb), in one file');
  if (whole(buffer, 'byteLength') > bytes) throw new Problem(`${name} is cut short: it claims ${whole(buffer, 'byteLength')} bytes of numbers and has ${bytes}`, 'Export it again');
  const views = list(document, 'bufferViews').map((view) => {
    const [byteOffset, byteLength, byteStride] = [whole(view, 'byteOffset'), whole(view, 'byteLength'), whole(view, 'byteStride')];
    if (within(view['buffer'], 1, 'bufferViews') !== 0 || byteOffset + byteLength > bytes || byteStride > LARGEST_STRIDE) throw lost('bufferViews');
    return { buffer: 0, byteOffset, byteLength, ...(byteStride ? { byteStride } : {}) };
  });
  const accessors = list(document, 'accessors').map((each) => {
    const width = (WIDTHS[Number(each['componentType'])] ?? 0) * (SIZES[String(each['type'])] ?? 0);
    // Those of matrices belong to skins, those without a view are zeros: neither is a shape.
    if (!width || each['sparse'] !== undefined || each['bufferView'] === undefined) return null;
    const [count, byteOffset] = [whole(each, 'count'), whole(each, 'byteOffset')];
    const view = within(each['bufferView'], views.length, 'accessors');
    const { byteLength, byteStride } = views[view]!;
    if (count && byteOffset + (count - 1) * (byteStride ?? width) + width > byteLength) throw lost('accessors');
    if (byteStride !== undefined && byteStride < width) throw lost('accessors');
    // The loader makes a box of the ends, and complains without; nothing here looks at it.
    const ends = each['type'] === 'VEC3' ? { min: [0, 0, 0], max: [0, 0, 0] } : {};
    return { bufferView: view, byteOffset, count, componentType: Number(each['componentType']), type: String(each['type']), normalized: each['normalized'] === true, ...ends };
  });
  const accessor = (index: unknown): number => {
    const found = within(index, accessors.length, 'meshes');
    if (!accessors[found]) throw new Problem(`${name} holds numbers in a way that is not supported`, 'Export it again without sparse accessors');
    return found;
  };
  const triangles: number[] = [];
  const meshes = list(document, 'meshes').map((mesh) => {
    let total = 0;
    const primitives = list(mesh, 'primitives').flatMap((primitive) => {
      const [mode, attributes] = [whole(primitive, 'mode', 4), primitive['attributes']];
      if (![4, 5, 6].includes(mode) || !isRecord(attributes) || attributes['POSITION'] === undefined) return [];
      const position = accessor(attributes['POSITION']);
      const normal = attributes['NORMAL'] === undefined ? undefined : accessor(attributes['NORMAL']);
      const indices = primitive['indices'] === undefined ? undefined : accessor(primitive['indices']);
      if (accessors[position]!.type !== 'VEC3' || (normal !== undefined && (accessors[normal]!.type !== 'VEC3' || accessors[normal]!.count !== accessors[position]!.count))) throw lost('meshes');
      if (indices !== undefined && (accessors[indices]!.type !== 'SCALAR' || ![5121, 5123, 5125].includes(accessors[indices]!.componentType))) throw lost('meshes');
      const corners = accessors[indices ?? position]!.count;
      total += mode === 4 ? corners / 3 : corners;
      return corners < 3 ? [] : [{ mode, attributes: { POSITION: position, ...(normal === undefined ? {} : { NORMAL: normal }) }, ...(indices === undefined ? {} : { indices }) }];
    });
    triangles.push(total);
    return { primitives };
  });
  const nodes = list(document, 'nodes');
  const parents = new Map<number, number>();
  let shown = 0;
  const kept = nodes.map((node, k) => {
    const children = node['children'] ?? [];
    if (!Array.isArray(children)) throw lost('nodes');
    for (const child of children) {
      if (parents.has(within(child, nodes.length, 'nodes'))) throw lost('nodes');
      parents.set(child as number, k);
    }
    const mesh = node['mesh'] === undefined ? undefined : within(node['mesh'], meshes.length, 'nodes');
    shown += mesh === undefined ? 0 : triangles[mesh]!;
    const drawn = mesh !== undefined && meshes[mesh]!.primitives.length > 0;
    return { ...placed(node), ...(children.length ? { children: children as number[] } : {}), ...(drawn ? { mesh } : {}) };
  });
  for (let k = 0; k < nodes.length; k += 1) {
    let depth = 0;
    for (let at = parents.get(k); at !== undefined; at = parents.get(at)) if ((depth += 1) > DEEPEST) throw new Problem(`${name} has nodes that are their own ancestors, or more than ${DEEPEST} deep`, 'Export it again');
  }
  if (shown > MOST_TRIANGLES) throw new Problem(`${name} has ${Math.round(shown).toLocaleString('en')} triangles, more than ${MOST_TRIANGLES.toLocaleString('en')}`, 'Decimate it');
  const scenes = list(document, 'scenes');
  const scene = scenes.length ? scenes[within(document['scene'] ?? 0, scenes.length, 'scenes')]! : { nodes: nodes.map((_, k) => k).filter((k) => !parents.has(k)) };
  const roots = scene['nodes'] ?? [];
  if (!Array.isArray(roots)) throw lost('scenes');
  for (const root of roots) within(root, nodes.length, 'scenes');
  const drawn = [...new Set(roots as number[])];
  return {
    asset: { version: '2.0' },
    ...(required.includes(QUANTIZED) ? { extensionsUsed: [QUANTIZED], extensionsRequired: [QUANTIZED] } : {}),
    scene: 0,
    scenes: [{ nodes: drawn.filter((root) => !parents.has(root)) }],
    nodes: kept,
    meshes: meshes.map((mesh) => (mesh.primitives.length ? mesh : { primitives: [{ attributes: {} }] })),
    // Nothing refers to what is not a shape; it stands here for the numbers of the others.
    accessors: accessors.map((each) => each ?? { count: 0, componentType: 5126, type: 'SCALAR' }),
    bufferViews: views,
    buffers: [{ byteLength: bytes }],
  };
}

/** Where a node is; what is not the right number of finite numbers is left out. */
function placed(node: Json): Json {
  const found: Json = {};
  for (const [key, size] of [['matrix', 16], ['translation', 3], ['rotation', 4], ['scale', 3]] as const) {
    const value = node[key];
    if (Array.isArray(value) && value.length === size && value.every((x) => typeof x === 'number' && Number.isFinite(x))) found[key] = value;
  }
  return found;
}

/** A GLB file. */
function packed(document: Json, binary: Uint8Array<ArrayBuffer>): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(document));
  const [first, second] = [Math.ceil(text.length / 4) * 4, Math.ceil(binary.length / 4) * 4];
  const file = new Uint8Array(28 + first + second).fill(32, 20, 20 + first);
  const view = new DataView(file.buffer);
  [MAGIC, 2, file.length, first, JSON_CHUNK].forEach((value, k) => view.setUint32(4 * k, value, true));
  file.set(text, 20);
  view.setUint32(20 + first, second, true);
  view.setUint32(24 + first, BINARY_CHUNK, true);
  file.set(binary, 28 + first);
  return file.buffer;
}
