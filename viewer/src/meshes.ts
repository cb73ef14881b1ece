// The meshes that materials are shown on, by name: those of the page, and those that were dropped.

import type { BufferGeometry } from 'three';
import type { ShapesView } from './generated';
import { readMesh } from './meshfiles';
import { embedded, prepared } from './shapes';

export class Meshes {
  /** Those of the page are unpacked when they are first looked at. */
  private readonly geometries = new Map<string, BufferGeometry | null>();

  constructor(private readonly shipped: ShapesView) {
    for (const view of shipped.shapes) this.geometries.set(view.name, null);
  }

  get names(): string[] {
    return [...this.geometries.keys()];
  }

  /** The mesh of a name; the first of the page where there is none. */
  get(name: string): BufferGeometry {
    const found = this.geometries.get(name);
    if (found) return found;
    const view = this.shipped.shapes.find((each) => each.name === name) ?? this.shipped.shapes[0]!;
    const made = this.geometries.get(view.name) ?? embedded(view);
    this.geometries.set(view.name, made);
    return made;
  }

  /** Add a file's mesh under its name; gives its number of triangles. */
  async add(name: string, data: ArrayBuffer): Promise<number> {
    const geometry = prepared(await readMesh(name, data), this.shipped.dust_by_inclination);
    this.geometries.get(name)?.dispose();
    this.geometries.set(name, geometry);
    return geometry.getIndex()!.count / 3;
  }

  dispose(): void {
    for (const geometry of this.geometries.values()) geometry?.dispose();
  }
}
