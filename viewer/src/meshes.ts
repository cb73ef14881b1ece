// The meshes that materials are shown on, by name: those of the page, and those that were dropped.

import type { BufferGeometry } from 'three';
import type { ShapesView } from './generated';
import { readMesh } from './meshfiles';
import { embedded, prepared, thickest, type Triangles } from './shapes';

export class Meshes {
  /** Those of the page are unpacked when they are first looked at. */
  private readonly geometries = new Map<string, BufferGeometry | null>();
  /** Of the user's meshes what their files hold, and which axis points up in what was made of it. */
  private readonly own = new Map<string, { triangles: Triangles; up: string }>();

  constructor(private readonly shipped: ShapesView) {
    for (const view of shipped.shapes) this.geometries.set(view.name, null);
  }

  get names(): string[] {
    return [...this.geometries.keys()];
  }

  /** The mesh of a name; the first of the page where there is none. */
  get(name: string, up: string): BufferGeometry {
    const own = this.own.get(name);
    if (own && own.up !== up) {
      this.geometries.get(name)?.dispose();
      this.geometries.set(name, prepared(own.triangles, this.shipped.dust_by_inclination, up));
      own.up = up;
    }
    const found = this.geometries.get(name);
    if (found) return found;
    const view = this.shipped.shapes.find((each) => each.name === name) ?? this.shipped.shapes[0]!;
    const made = this.geometries.get(view.name) ?? embedded(view);
    this.geometries.set(view.name, made);
    return made;
  }

  /** Whether a mesh is one of the user's. */
  isOwn(name: string): boolean {
    return this.own.has(name);
  }

  /** Add a file's mesh under its name; gives its number of triangles, and the thickest of its own dust, 0 where it has none. */
  async add(name: string, data: ArrayBuffer, up: string): Promise<{ triangles: number; tau: number }> {
    const triangles = await readMesh(name, data);
    const geometry = prepared(triangles, this.shipped.dust_by_inclination, up);
    this.geometries.get(name)?.dispose();
    this.geometries.set(name, geometry);
    this.own.set(name, { triangles, up });
    return { triangles: geometry.getIndex()!.count / 3, tau: thickest(triangles) };
  }

  dispose(): void {
    for (const geometry of this.geometries.values()) geometry?.dispose();
  }
}
