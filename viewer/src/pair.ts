// The one or two materials that are looked at: the page's own, and those that were dropped in their place.

import type { Payload, ShaderView } from './generated';
import { fromJson, fromView, held, valuesAt, type Material, type Values } from './material';
import { inflated } from './packed';
import type { State } from './state';

export class Pair {
  private readonly own: (Material | null)[];
  private materials: (Material | null)[];
  private library: Record<string, ShaderView> | null = null;

  constructor(private readonly payload: Payload) {
    this.own = [fromView(payload.materials[0]!), payload.materials[1] ? fromView(payload.materials[1]) : null];
    this.materials = [...this.own];
  }

  /** Both places; the second may be empty. */
  get all(): readonly (Material | null)[] {
    return this.materials;
  }

  get two(): boolean {
    return this.materials[1] !== null;
  }

  /** Whether the page came with two. */
  get cameWithTwo(): boolean {
    return this.own[1] !== null;
  }

  /** The first moment of the first that changes with time. */
  get firstHours(): number | undefined {
    return this.materials.map((material) => material?.time?.interval[0]).find((hours) => hours !== undefined);
  }

  at(index: number): Material | null {
    return this.materials[index] ?? null;
  }

  active(state: State): Material {
    return this.materials[state.active]!;
  }

  /** Those in the picture, from left to right. */
  shown(state: State): Material[] {
    return state.compare === 'one' ? [this.active(state)] : [this.materials[0]!, this.materials[1]!];
  }

  /** What was set by hand and fits the material. */
  held(state: State, index: number): Values {
    const material = this.at(index);
    return material ? held(material, state.values[index as 0 | 1]) : {};
  }

  /** The values of a material now: its trends at the hour, and what was set by hand. */
  values(state: State, index: number): Values {
    const material = this.at(index);
    return material ? valuesAt(material, material.time ? state.hours : null, this.held(state, index)) : {};
  }

  shownValues(state: State): Values[] {
    return state.compare === 'one' ? [this.values(state, state.active)] : [this.values(state, 0), this.values(state, 1)];
  }

  /** The hours from the earliest to the latest that is shown. */
  interval(state: State): [number, number] | null {
    const shown = state.compare === 'one' ? [this.at(state.active)] : this.materials;
    const intervals = shown.flatMap((material) => (material?.time ? [material.time.interval] : []));
    return intervals.length ? [Math.min(...intervals.map((i) => i[0])), Math.max(...intervals.map((i) => i[1]))] : null;
  }

  /** A dropped material's JSON as a material, with what had to be left out. */
  read(json: unknown): { material: Material; notes: string[] } {
    this.library ??= inflated(this.payload.library) as Record<string, ShaderView>;
    return fromJson(json, this.library);
  }

  /** Take the materials that the state names; what cannot be read is the page's own again. */
  follow(state: State, fail: (error: unknown) => void): void {
    this.materials = [0, 1].map((index) => {
      const json = state.dropped[index];
      if (!json) return this.own[index]!;
      const now = this.materials[index];
      if (now?.dropped && JSON.stringify(now.json) === JSON.stringify({ ...(json as object), name: now.json.name, channels: now.json.channels })) return now;
      try {
        return this.read(json).material;
      } catch (error) {
        fail(error);
        return this.own[index]!;
      }
    });
  }
}
