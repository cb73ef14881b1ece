// The ground below a mesh: nothing is seen of it but the shadow of the light from all around, which says where the mesh stands.

import { BufferAttribute, BufferGeometry, FrontSide, GLSL3, ShaderMaterial } from 'three';

/** Cells of the maps of what lies lowest and highest over the ground, and vertices along a side of it. */
const CELLS = 96;
const SIDE = 65;
/** The ground reaches so far beyond the mesh, in parts of its width. */
const REACH = 1.1;
const RINGS = 6;
const AZIMUTHS = 16;
const STEPS = 24;
const EDGE = 0.35;

const VERTEX = /* glsl */ `
in float hidden;
out float vHidden;
void main() {
  vHidden = hidden;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;
// Black that covers what lies behind it: the page.
const FRAGMENT = /* glsl */ `
uniform float strength;
in float vHidden;
out vec4 color;
void main() { color = vec4(0.0, 0.0, 0.0, clamp(vHidden * strength, 0.0, 1.0)); }`;

export function groundMaterial(): ShaderMaterial {
  return new ShaderMaterial({ glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: FrontSide, depthWrite: false, uniforms: { strength: { value: 1 } } });
}

/** The ground of a mesh, touching its lowest point; `hidden` is the part of a uniform sky's light that the mesh keeps from it. */
export function groundOf(mesh: BufferGeometry): BufferGeometry {
  const positions = mesh.getAttribute('position').array as Float32Array;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < positions.length; k += 1) {
    low[k % 3] = Math.min(low[k % 3]!, positions[k]!);
    high[k % 3] = Math.max(high[k % 3]!, positions[k]!);
  }
  const [middleX, middleZ] = [(low[0]! + high[0]!) / 2, (low[2]! + high[2]!) / 2];
  const half = Math.max(high[0]! - low[0]!, high[2]! - low[2]!, 0.2) / 2;
  const cell = (2 * half) / CELLS;
  const [under, top] = [new Float32Array(CELLS * CELLS).fill(Infinity), new Float32Array(CELLS * CELLS).fill(-Infinity)];
  const at = (x: number, z: number): number => {
    const [j, i] = [Math.floor((x - middleX + half) / cell), Math.floor((z - middleZ + half) / cell)];
    return i < 0 || j < 0 || i >= CELLS || j >= CELLS ? -1 : i * CELLS + j;
  };
  spread(positions, mesh.getIndex()!.array, cell, (x, y, z) => {
    const place = at(x, z);
    if (place < 0) return;
    under[place] = Math.min(under[place]!, y - low[1]!);
    top[place] = Math.max(top[place]!, y - low[1]!);
  });
  const height = high[1]! - low[1]!;
  const reach = half * (1 + REACH);
  const points = new Float32Array(3 * SIDE * SIDE);
  const hidden = new Float32Array(SIDE * SIDE);
  for (let k = 0; k < SIDE * SIDE; k += 1) {
    const [u, v] = [(2 * (k % SIDE)) / (SIDE - 1) - 1, (2 * Math.floor(k / SIDE)) / (SIDE - 1) - 1];
    const [x, z] = [middleX + u * reach, middleZ + v * reach];
    points.set([x, low[1]! - 0.002, z], 3 * k);
    const away = Math.hypot(u, v);
    if (away < 1) hidden[k] = blocked(x, z);
  }
  // So few directions leave patches: the mean over neighbours, fading out before the end.
  const smooth = hidden.map((_, k) => mean(hidden, k));
  for (let k = 0; k < hidden.length; k += 1) {
    const away = Math.hypot((2 * (k % SIDE)) / (SIDE - 1) - 1, (2 * Math.floor(k / SIDE)) / (SIDE - 1) - 1);
    hidden[k] = mean(smooth, k) * Math.min(Math.max((1 - away) / EDGE, 0), 1);
  }
  const corners: number[] = [];
  for (let i = 0; i + 1 < SIDE; i += 1) {
    for (let j = 0; j + 1 < SIDE; j += 1) {
      const a = i * SIDE + j;
      corners.push(a, a + SIDE, a + 1, a + 1, a + SIDE, a + SIDE + 1);
    }
  }
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(points, 3));
  made.setAttribute('hidden', new BufferAttribute(hidden, 1));
  made.setIndex(corners);
  return made;

  /** The part of the light of a uniform sky that does not arrive: directions drawn in proportion to their cosine. */
  function blocked(x: number, z: number): number {
    let count = 0;
    for (let ring = 0; ring < RINGS; ring += 1) {
      const sine = Math.sqrt((ring + 0.5) / RINGS);
      const slope = Math.sqrt(1 - sine * sine) / sine;
      // As far as the light is still below the highest point, or over the mesh.
      const far = Math.min(height / slope, half + Math.hypot(x - middleX, z - middleZ)) || cell;
      for (let k = 0; k < AZIMUTHS; k += 1) {
        const angle = (2 * Math.PI * (k + ring / RINGS)) / AZIMUTHS;
        for (let step = 0; step < STEPS; step += 1) {
          const [near, next] = [(far * step) / STEPS, (far * (step + 1)) / STEPS];
          const place = at(x + (Math.sin(angle) * (near + next)) / 2, z + (Math.cos(angle) * (near + next)) / 2);
          if (place >= 0 && under[place]! <= next * slope && top[place]! >= near * slope) {
            count += 1;
            break;
          }
        }
      }
    }
    return count / (RINGS * AZIMUTHS);
  }
}

/** The mean over a vertex of the ground and those around it. */
function mean(values: Float32Array, k: number): number {
  let [sum, count] = [0, 0];
  for (let i = Math.max(Math.floor(k / SIDE) - 1, 0); i <= Math.min(Math.floor(k / SIDE) + 1, SIDE - 1); i += 1) {
    for (let j = Math.max((k % SIDE) - 1, 0); j <= Math.min((k % SIDE) + 1, SIDE - 1); j += 1) {
      sum += values[i * SIDE + j]!;
      count += 1;
    }
  }
  return sum / count;
}

/** Points all over the triangles, no further apart than a cell. */
function spread(positions: Float32Array, indices: ArrayLike<number>, cell: number, take: (x: number, y: number, z: number) => void): void {
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * indices[k]!, 3 * indices[k + 1]!, 3 * indices[k + 2]!];
    const longest = Math.max(length(a, b), length(b, c), length(c, a));
    const parts = Math.min(Math.max(Math.ceil(longest / cell), 1), CELLS);
    for (let i = 0; i <= parts; i += 1) {
      for (let j = 0; j <= parts - i; j += 1) {
        const [u, v] = [i / parts, j / parts];
        const mix = (axis: number): number => positions[a + axis]! + u * (positions[b + axis]! - positions[a + axis]!) + v * (positions[c + axis]! - positions[a + axis]!);
        take(mix(0), mix(1), mix(2));
      }
    }
  }
  function length(p: number, q: number): number {
    return Math.hypot(positions[q]! - positions[p]!, positions[q + 2]! - positions[p + 2]!);
  }
}
