// Dust on a mesh of the user's: by inclination, as Motes tabulated it, and sheltered by what stands above, found in a map of heights.

const SIZE = 192;
/** Directions that dust falls from: straight, and tilted by about the spread of `motes.rendering.deposition`, to eight sides. */
const TILT = Math.tan((15 * Math.PI) / 180);
const MARCH = 14;
const LIFT = 0.02;

/** The share of dust at each vertex, 0 to 1. */
export function settle(positions: Float32Array, normals: Float32Array, indices: Uint32Array | Uint16Array, byInclination: readonly number[]): Float32Array {
  const heights = heightMap(positions, indices);
  const count = positions.length / 3;
  const share = new Float32Array(count);
  const last = byInclination.length - 1;
  for (let k = 0; k < count; k += 1) {
    const cosine = Math.min(Math.max(normals[3 * k + 1]!, -1), 1);
    const place = (Math.acos(cosine) / Math.PI) * last;
    const below = Math.min(Math.floor(place), last - 1);
    const own = byInclination[below]! + (place - below) * (byInclination[below + 1]! - byInclination[below]!);
    share[k] = own > 0 ? own * heights.open(positions[3 * k]!, positions[3 * k + 1]!, positions[3 * k + 2]!, cosine) : 0;
  }
  return share;
}

interface Heights {
  /** The share of the directions in which nothing stands above a point. */
  open(x: number, y: number, z: number, cosine: number): number;
}

function heightMap(positions: Float32Array, indices: Uint32Array | Uint16Array): Heights {
  let [lowX, lowZ, highX, highZ] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let k = 0; k < positions.length; k += 3) {
    lowX = Math.min(lowX, positions[k]!);
    highX = Math.max(highX, positions[k]!);
    lowZ = Math.min(lowZ, positions[k + 2]!);
    highZ = Math.max(highZ, positions[k + 2]!);
  }
  const cell = Math.max(highX - lowX, highZ - lowZ, 1e-9) / (SIZE - 1);
  const map = new Float32Array(SIZE * SIZE).fill(-Infinity);
  const column = (x: number): number => (x - lowX) / cell;
  const row = (z: number): number => (z - lowZ) / cell;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * indices[k]!, 3 * indices[k + 1]!, 3 * indices[k + 2]!];
    const [ax, az, bx, bz, cx, cz] = [column(positions[a]!), row(positions[a + 2]!), column(positions[b]!), row(positions[b + 2]!), column(positions[c]!), row(positions[c + 2]!)];
    const area = (bx - ax) * (cz - az) - (cx - ax) * (bz - az);
    for (let i = Math.max(Math.ceil(Math.min(az, bz, cz)), 0); i <= Math.min(Math.floor(Math.max(az, bz, cz)), SIZE - 1); i += 1) {
      for (let j = Math.max(Math.ceil(Math.min(ax, bx, cx)), 0); j <= Math.min(Math.floor(Math.max(ax, bx, cx)), SIZE - 1); j += 1) {
        const u = ((j - ax) * (cz - az) - (cx - ax) * (i - az)) / area;
        const v = ((bx - ax) * (i - az) - (j - ax) * (bz - az)) / area;
        if (!(u >= -1e-6 && v >= -1e-6 && u + v <= 1 + 1e-6)) continue;
        const y = positions[a + 1]! + u * (positions[b + 1]! - positions[a + 1]!) + v * (positions[c + 1]! - positions[a + 1]!);
        if (y > map[i * SIZE + j]!) map[i * SIZE + j] = y;
      }
    }
  }
  return {
    open(x, y, z, cosine) {
      // On a slope the map's cells are higher to one side: that is no shelter.
      const start = y + LIFT + 1.5 * cell * Math.min(Math.sqrt(Math.max(1 - cosine * cosine, 0)) / Math.max(cosine, 0.1), 8);
      let free = 0;
      for (let side = 0; side < 9; side += 1) {
        const [dx, dz] = side === 8 ? [0, 0] : [Math.cos((side * Math.PI) / 4) * TILT, Math.sin((side * Math.PI) / 4) * TILT];
        let blocked = false;
        for (let step = 0; step < MARCH && !blocked; step += 1) {
          const rise = LIFT + 0.015 * (step * step + step);
          const i = Math.round(row(z + dz * rise));
          const j = Math.round(column(x + dx * rise));
          if (i < 0 || j < 0 || i >= SIZE || j >= SIZE) break;
          blocked = map[i * SIZE + j]! > start + rise;
        }
        if (!blocked) free += 1;
      }
      return free / 9;
    },
  };
}
